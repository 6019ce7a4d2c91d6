/** Colours and words for indicators of chaos. */

import { indicatorScale, onScale } from "./palette";
import { readable } from "./numbers";

/** Share of a scale from 2 to `high` for a MEGNO: it tends to 2 on regular motions and grows with chaos. */
export function megnoShare(value: number, high = 32): number {
  return Math.log2(Math.max(1, value) / 2) / Math.log2(high / 2);
}

/** Colour of a MEGNO, red, green and blue. */
export function megnoColour(value: number): [number, number, number] {
  return onScale(indicatorScale(), megnoShare(value));
}

/** A MEGNO in words. */
export function megnoWords(value: number): string {
  if (!Number.isFinite(value)) return "no indicator: the motion ends before";
  // the mean over a finite time: nothing is proven by it
  return `MEGNO ${readable(value, 3)}${value < 2.5 ? ", as on regular motions" : value > 4 ? ", as on chaotic motions" : ""}`;
}
