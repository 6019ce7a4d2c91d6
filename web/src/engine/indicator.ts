/**
 * Chaos indicators of one motion. A deviation is carried along and made of length one after each
 * interval; the logarithms of the lengths lost add up to L(t). MEGNO is twice the mean of L less
 * its mean until then: 2 on a regular motion, λ/2 times the time on a chaotic one. Lengths are
 * measured with each vector of the state divided by its size.
 */

import type { IndicatorTask } from "./engine.js";
import { norm, orthonormal, remove } from "./linear.js";
import type { Module } from "./module.js";
import { scalesOf } from "./start.js";

const INTERVALS = 200;
/** Part of a motion left out of an exponent, where the deviation finds its direction. */
const UNSETTLED = 0.2;
const TOLERANCE = 1e-12;

export function indicator(module: Module, task: IndicatorTask): number {
  const { tables } = module;
  const values = module.parameters(task.parameters);
  const size = tables.tangent.dimension / 2;
  let state = Float64Array.from(Array.from(task.start).slice(0, size));
  const scales = largestScales(module, state, values, task.until);
  let deviation = Float64Array.from({ length: size }, (_, k) => Math.cos(1 + 2.7 * k));
  const transverse = task.kind === "lyapunov";
  // where relations, integrals and the flow leave no deviation, neighbours cannot part
  if (excluded(module, state, values, scales, transverse).length >= size) return NaN;
  normalise(deviation, excluded(module, state, values, scales, transverse));
  const interval = task.until / INTERVALS;
  let total = 0;
  let mean = 0;
  let sum = 0;
  let settled = 0;
  for (let i = 1; i <= INTERVALS; i++) {
    const start = [...state, ...deviation.map((x, k) => x * scales[k]!)];
    const [run] = module.march(tables.tangent, start, values, [interval], 1, TOLERANCE);
    if (run!.outcome !== 0) return NaN;
    state = run!.states.slice(0, size);
    deviation = run!.states.slice(size).map((x, k) => x / scales[k]!);
    const before = total;
    total += Math.log(normalise(deviation, excluded(module, state, values, scales, transverse)));
    mean += ((total + before) / 2 - mean) / i;
    sum += 2 * (total - mean);
    if (i <= UNSETTLED * INTERVALS) settled = total;
  }
  if (task.kind === "megno") return sum / INTERVALS;
  return (total - settled) / (task.until * (1 - UNSETTLED));
}

/** Make a deviation of length one, without the span of a basis; its length before. */
function normalise(deviation: Float64Array, basis: readonly Float64Array[]): number {
  for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(deviation, q);
  const length = norm(deviation);
  for (let k = 0; k < deviation.length; k++) deviation[k]! /= length;
  return length;
}

/** What is no deviation: across the relations; and across the integrals and along the flow. */
function excluded(
  module: Module,
  state: Float64Array,
  values: Float64Array,
  scales: Float64Array,
  transverse: boolean,
): Float64Array[] {
  const { conditions, relations, integrals, rates } = module.tables;
  const count = relations + (transverse ? integrals.length : 0);
  const size = state.length;
  const first = conditions.outputs / (size + 1);
  const numbers = module.values(conditions, state, values);
  const vectors = Array.from({ length: count }, (_, i) =>
    Float64Array.from(state, (_, k) => numbers[first + i * size + k]! * scales[k]!),
  );
  if (transverse) {
    vectors.push(module.values(rates, state, values).map((x, k) => x / scales[k]!));
  }
  return orthonormal(vectors);
}

/** The largest sizes of the vectors of the state over the first tenth of the motion. */
function largestScales(
  module: Module,
  state: Float64Array,
  values: Float64Array,
  until: number,
): Float64Array {
  const { tangent } = module.tables;
  const size = state.length;
  const times = Array.from({ length: 32 }, (_, i) => ((i + 1) / 320) * until);
  const start = [...state, ...new Float64Array(size)];
  const [run] = module.march(tangent, start, values, times, times.length, TOLERANCE);
  const largest = scalesOf(module, state);
  for (let i = 0; i < run!.count; i++) {
    const scales = scalesOf(module, run!.states.subarray(2 * size * i, 2 * size * i + size));
    scales.forEach((x, k) => (largest[k] = Math.max(largest[k]!, x)));
  }
  return largest;
}
