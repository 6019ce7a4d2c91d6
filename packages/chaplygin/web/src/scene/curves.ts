/** The curves of a motion: on the ground and on the body. */

import type { Scene } from "../model";
import { smoothCurve, type TimedCurve } from "../playback/curve";
import { finiteSamples, pose, turnedBack, type Motion, type Vector } from "../playback/motion";
import { planPoints } from "./opening_view";

/** Points with which a curve is drawn, where it has fewer samples. */
const CURVE_POINTS = 1200;

/** The path of the contact point, or of the body where there is none. */
export function contactCurve(motion: Motion): TimedCurve {
  const name = motion.columns["contact"] ? "contact" : "centre";
  const count = finiteSamples(motion, name, 3);
  return smoothCurve(motion.times, motion.columns[name] ?? new Float64Array(0), count, parts(count));
}

/** The path of a mechanism in the plane. */
export function planCurve(scene: Scene, motion: Motion): TimedCurve {
  const points = planPoints(scene, motion);
  return smoothCurve(motion.times, points, points.length / 3, 4);
}

/** The trace of the contact point on the body, in its own axes. */
export function traceOnBody(motion: Motion): TimedCurve {
  const count = Math.min(finiteSamples(motion, "contact", 3), finiteSamples(motion, "attitude", 4));
  const points = new Float64Array(3 * count);
  for (let k = 0; k < count; k++) {
    const { attitude, centre, contact } = pose(motion, motion.times[k] ?? 0);
    const arm = contact.map((place, i) => place - (centre[i] ?? 0)) as Vector;
    points.set(turnedBack(attitude, arm), 3 * k);
  }
  return smoothCurve(motion.times, points, count, parts(count));
}

function parts(count: number): number {
  return Math.max(1, Math.min(6, Math.ceil(CURVE_POINTS / Math.max(1, count))));
}
