/** A motion: samples of named columns, and values between them. */

import type { ContactEvent, ModeInterval } from "../model";

/** Samples of a motion; columns are flat, row by row. */
export interface Motion {
  times: Float64Array;
  columns: Record<string, Float64Array>;
  /** The modes of a contact with friction, one after the other. */
  modes?: readonly ModeInterval[];
  /** The changes of the contact, by name. */
  events?: readonly ContactEvent[];
  /** Whole states, row by row, where they are known. */
  states?: Float64Array;
  /** Why it ends before its last instant, where it does. */
  end: { time: number; reason: string } | null;
}

export type Quaternion = [w: number, x: number, y: number, z: number];
export type Vector = [x: number, y: number, z: number];

/** Where a body is at an instant, in space. */
export interface Pose {
  t: number;
  attitude: Quaternion;
  centre: Vector;
  contact: Vector;
}

/** The sample before an instant, and the share of the step that has gone by. */
export function place(times: Float64Array, t: number): { index: number; share: number } {
  const last = times.length - 1;
  if (last <= 0 || !(t > (times[0] ?? 0))) return { index: 0, share: 0 };
  if (t >= (times[last] ?? 0)) return { index: last, share: 0 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((times[middle] ?? 0) <= t) low = middle;
    else high = middle;
  }
  const start = times[low] ?? 0;
  return { index: low, share: (t - start) / ((times[high] ?? 0) - start) };
}

/** A row of a column between samples, linearly. */
export function row(motion: Motion, name: string, width: number, t: number): number[] | null {
  const values = motion.columns[name];
  if (values === undefined) return null;
  const { index, share } = place(motion.times, t);
  const at = (sample: number, k: number): number => values[sample * width + k] ?? NaN;
  return Array.from({ length: width }, (_, k) =>
    share === 0 ? at(index, k) : (1 - share) * at(index, k) + share * at(index + 1, k),
  );
}

/** The rotation a share of the way from one to another along the shorter arc. */
export function slerp(from: Quaternion, to: Quaternion, share: number): Quaternion {
  let cosine = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3];
  const sign = cosine < 0 ? -1 : 1;
  cosine = Math.min(1, Math.abs(cosine));
  const angle = Math.acos(cosine);
  const sine = Math.sin(angle);
  const a = sine > 1e-9 ? Math.sin((1 - share) * angle) / sine : 1 - share;
  const b = (sine > 1e-9 ? Math.sin(share * angle) / sine : share) * sign;
  return unit([
    a * from[0] + b * to[0],
    a * from[1] + b * to[1],
    a * from[2] + b * to[2],
    a * from[3] + b * to[3],
  ]);
}

/** The quaternion of length one along another. */
export function unit(q: Quaternion): Quaternion {
  const length = Math.hypot(...q) || 1;
  return [q[0] / length, q[1] / length, q[2] / length, q[3] / length];
}

/** A vector of the body as one of space. */
export function turned(q: Quaternion, v: Vector): Vector {
  const [w, x, y, z] = q;
  const a = 2 * (y * v[2] - z * v[1]);
  const b = 2 * (z * v[0] - x * v[2]);
  const c = 2 * (x * v[1] - y * v[0]);
  return [v[0] + w * a + y * c - z * b, v[1] + w * b + z * a - x * c, v[2] + w * c + x * b - y * a];
}

/** A vector of space as one of the body. */
export function turnedBack(q: Quaternion, v: Vector): Vector {
  return turned([q[0], -q[1], -q[2], -q[3]], v);
}

/** The pose of a body at an instant; what the motion does not record stays at rest at the origin. */
export function pose(motion: Motion, t: number): Pose {
  const attitudes = motion.columns["attitude"];
  const { index, share } = place(motion.times, t);
  const at = (k: number): Quaternion =>
    [0, 1, 2, 3].map((i) => attitudes?.[4 * k + i] ?? (i === 0 ? 1 : 0)) as Quaternion;
  const attitude = share === 0 ? at(index) : slerp(at(index), at(index + 1), share);
  const vector = (name: string): Vector | null => row(motion, name, 3, t) as Vector | null;
  const centre = vector("centre") ?? [0, 0, 0];
  return { t: clampTime(motion, t), attitude, centre, contact: vector("contact") ?? centre };
}

/** An instant of the motion: the nearest that it has. */
export function clampTime(motion: Motion, t: number): number {
  const { times } = motion;
  return Math.min(Math.max(t, times[0] ?? 0), times[times.length - 1] ?? 0);
}

/** How many samples from the first are finite in a column. */
export function finiteSamples(motion: Motion, name: string, width: number): number {
  const values = motion.columns[name];
  if (values === undefined) return 0;
  for (let k = 0; k < motion.times.length; k++) {
    for (let i = 0; i < width; i++) if (!Number.isFinite(values[k * width + i])) return k;
  }
  return motion.times.length;
}
