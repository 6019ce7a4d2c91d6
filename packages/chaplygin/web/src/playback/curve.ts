/** Smooth curves through samples. */

/** A curve in space with the instant of each point, and its length up to there. */
export interface TimedCurve {
  points: Float64Array;
  times: Float64Array;
  lengths: Float64Array;
}

/** A curve through points (n, 3) with `parts` pieces a step: each a cubic with the slopes of the neighbours. */
export function smoothCurve(times: Float64Array, points: Float64Array, count: number, parts: number): TimedCurve {
  const total = count < 2 ? count : (count - 1) * parts + 1;
  const curve = new Float64Array(3 * total);
  const instants = new Float64Array(total);
  const at = (k: number, i: number): number => points[3 * k + i] ?? 0;
  const slope = (k: number, i: number): number => {
    const before = Math.max(0, k - 1);
    const after = Math.min(count - 1, k + 1);
    const step = (times[after] ?? 0) - (times[before] ?? 0);
    return step > 0 ? (at(after, i) - at(before, i)) / step : 0;
  };
  for (let n = 0; n < total; n++) {
    const k = Math.min(Math.floor(n / parts), Math.max(0, count - 2));
    const s = n / parts - k;
    const from = times[k] ?? 0;
    const step = count > 1 ? (times[k + 1] ?? 0) - from : 0;
    instants[n] = from + s * step;
    for (let i = 0; i < 3; i++) {
      curve[3 * n + i] = count < 2 || s === 0 ? at(k, i) : hermite(at(k, i), at(k + 1, i), step * slope(k, i), step * slope(k + 1, i), s);
    }
  }
  return { points: curve, times: instants, lengths: lengths(curve) };
}

function hermite(a: number, b: number, da: number, db: number, s: number): number {
  const r = 1 - s;
  return r * r * (1 + 2 * s) * a + s * s * (3 - 2 * s) * b + s * r * r * da - s * s * r * db;
}

/** The length of a curve (n, 3) up to each of its points. */
export function lengths(points: Float64Array): Float64Array {
  const sums = new Float64Array(points.length / 3);
  for (let k = 1; k < sums.length; k++) {
    const step = Math.hypot(
      (points[3 * k] ?? 0) - (points[3 * k - 3] ?? 0),
      (points[3 * k + 1] ?? 0) - (points[3 * k - 2] ?? 0),
      (points[3 * k + 2] ?? 0) - (points[3 * k - 1] ?? 0),
    );
    sums[k] = (sums[k - 1] ?? 0) + step;
  }
  return sums;
}
