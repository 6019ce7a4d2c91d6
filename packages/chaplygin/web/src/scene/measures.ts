/** Comparisons and sizes of what a scene shows. */

import type { Motion } from "../playback/motion";
import type { Surface } from "./body";

/** The longest arrow of a vector along a motion, in diameters of the body. */
export const VECTOR_LENGTH = 0.9;

export function sameSurface(a: Pick<Surface, "positions">, b: Pick<Surface, "positions"> | null): boolean {
  return b !== null && a.positions.length === b.positions.length && a.positions.every((place, k) => place === b.positions[k]);
}

export function largestLength(motion: Motion, column: string): number {
  const values = motion.columns[column];
  if (values === undefined) return 0;
  let largest = 0;
  for (let k = 0; k + 2 < values.length; k += 3) {
    const length = Math.hypot(values[k] ?? 0, values[k + 1] ?? 0, values[k + 2] ?? 0);
    if (length > largest) largest = length;
  }
  return largest;
}

export function meshSpacing(positions: ArrayLike<number>): number {
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < positions.length; k++) {
    low = Math.min(low, positions[k] ?? low);
    high = Math.max(high, positions[k] ?? high);
  }
  const rough = (high - low) / 12;
  const power = 10 ** Math.floor(Math.log10(rough));
  return (([1, 2, 5, 10] as const).find((step) => step * power >= rough * (1 - 1e-9)) ?? 10) * power;
}

