/** The modes of a contact with friction along a motion. */

import type { ContactEvent, ModeInterval } from "../model";
import { readable } from "../page/numbers";
import type { TimedCurve } from "./curve";
import { lengths } from "./curve";
import type { Motion } from "./motion";

/** The modes of a motion that has more than one; else none. */
export function changingModes({ modes = [] }: Motion): readonly ModeInterval[] {
  return modes.some(({ mode }) => mode !== modes[0]?.mode) ? modes : [];
}

/** The modes that occur, in a given order. */
export function presentModes(modes: readonly ModeInterval[], order: readonly string[]): string[] {
  const occurring = new Set(modes.map(({ mode }) => mode));
  return order.filter((mode) => occurring.has(mode));
}

/** The mode at an instant; at a change, the one that begins. */
export function modeAt(modes: readonly ModeInterval[], t: number): string {
  let low = 0;
  let high = modes.length;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((modes[middle]?.begin ?? 0) <= t) low = middle;
    else high = middle;
  }
  return modes[low]?.mode ?? "";
}

/** The last event up to an instant, in words; empty before the first. */
export function lastEvent({ events = [] }: Motion, t: number): string {
  let last: ContactEvent | undefined;
  for (const event of events) if (event.time <= t) last = event;
  return last === undefined ? "" : `last event: ${last.kind} at ${readable(last.time, 6)} s`;
}

/** A curve with further points at the instants at which modes begin, so that each piece of it has one. */
export function splitAtModes(curve: TimedCurve, modes: readonly ModeInterval[]): TimedCurve {
  const { points, times } = curve;
  const at: number[] = [];
  const places: number[] = [];
  let next = 0;
  for (let k = 0; k < times.length; k++) {
    const t = times[k] ?? 0;
    for (; next < modes.length && (modes[next]?.begin ?? 0) <= t; next++) {
      const begin = modes[next]?.begin ?? 0;
      const before = times[k - 1] ?? t;
      if (begin <= before || begin >= t) continue;
      const share = (begin - before) / (t - before);
      at.push(begin);
      for (let i = 0; i < 3; i++) places.push((1 - share) * (points[3 * k - 3 + i] ?? 0) + share * (points[3 * k + i] ?? 0));
    }
    at.push(t);
    places.push(...points.subarray(3 * k, 3 * k + 3));
  }
  const all = Float64Array.from(places);
  return { points: all, times: Float64Array.from(at), lengths: lengths(all) };
}
