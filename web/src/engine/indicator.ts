/**
 * Chaos indicators of motions. A deviation is carried along each motion and made of length one after
 * each interval; the logarithms of the lengths lost add up to L(t). MEGNO is twice the mean of L less
 * its mean until then: 2 on a regular motion, λ/2 times the time on a chaotic one. Lengths are
 * measured with each vector of the state divided by its size.
 */

import type { IndicatorsTask } from "./engine.js";
import { norm, orthonormal, remove } from "./linear.js";
import type { Module } from "./module.js";
import { scalesOf } from "./start.js";

const INTERVALS = 200;
/** Part of a motion left out of an exponent, where the deviation finds its direction. */
const UNSETTLED = 0.2;
const TOLERANCE = 1e-12;
/** Looks at the first tenth of a motion, for the sizes of its vectors. */
const LOOKS = 32;

/** One motion with its deviation. */
interface Carried {
  values: Float64Array;
  state: Float64Array;
  scales: Float64Array;
  deviation: Float64Array;
  /** L, its mean, the sum of MEGNO over the intervals, and L where the deviation has settled. */
  total: number;
  mean: number;
  sum: number;
  settled: number;
}

/** The indicators of motions that are computed side by side; not a number where one ends before. */
export function indicators(module: Module, task: IndicatorsTask): Float64Array {
  const { tangent } = module.tables;
  const size = tangent.dimension / 2;
  const transverse = task.kind === "lyapunov";
  const results = new Float64Array(task.motions.length).fill(NaN);
  const carried = task.motions.map(({ parameters, start }) =>
    begin(module, module.parameters(parameters), Float64Array.from(start).slice(0, size), task.until, transverse),
  );
  let live = [...carried.keys()].filter((k) => carried[k] !== null);
  const interval = [task.until / INTERVALS];
  const width = module.model.parameters.length;
  const starts = new Float64Array(carried.length * 2 * size);
  const values = new Float64Array(carried.length * Math.max(width, 1));
  for (let i = 1; i <= INTERVALS && live.length > 0; i++) {
    live.forEach((k, j) => {
      const { state, scales, deviation, values: own } = carried[k]!;
      const first = 2 * size * j;
      starts.set(state, first);
      for (let c = 0; c < size; c++) starts[first + size + c] = deviation[c]! * scales[c]!;
      values.set(own, width * j);
    });
    const runs = module.march(
      tangent,
      starts.subarray(0, 2 * size * live.length),
      values.subarray(0, width * live.length),
      interval,
      1,
      TOLERANCE,
    );
    live = live.filter((k, j) => {
      const one = carried[k]!;
      const run = runs[j]!;
      if (run.outcome !== 0) return false;
      one.state = run.states.subarray(0, size);
      for (let c = 0; c < size; c++) one.deviation[c] = run.states[size + c]! / one.scales[c]!;
      const before = one.total;
      one.total += Math.log(normalise(one.deviation, excluded(module, one, transverse)));
      one.mean += ((one.total + before) / 2 - one.mean) / i;
      one.sum += 2 * (one.total - one.mean);
      if (i <= UNSETTLED * INTERVALS) one.settled = one.total;
      return true;
    });
  }
  for (const k of live) {
    const { total, settled, sum } = carried[k]!;
    const exponent = (total - settled) / (task.until * (1 - UNSETTLED));
    results[k] = task.kind === "megno" ? sum / INTERVALS : exponent;
  }
  return results;
}

/** A motion with a deviation at its start; null where neighbours cannot part. */
function begin(
  module: Module,
  values: Float64Array,
  state: Float64Array,
  until: number,
  transverse: boolean,
): Carried | null {
  const deviation = Float64Array.from(state, (_, k) => Math.cos(1 + 2.7 * k));
  const scales = largestScales(module, state, values, until);
  const one = { values, state, scales, deviation, total: 0, mean: 0, sum: 0, settled: 0 };
  const basis = excluded(module, one, transverse);
  // relations, integrals and the flow leave no deviation
  if (basis.length >= state.length) return null;
  normalise(deviation, basis);
  return one;
}

/** Make a deviation of length one, without the span of a basis; its length before. */
function normalise(deviation: Float64Array, basis: readonly Float64Array[]): number {
  for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(deviation, q);
  const length = norm(deviation);
  for (let k = 0; k < deviation.length; k++) deviation[k]! /= length;
  return length;
}

/** What is no deviation: across the relations; and across the integrals and along the flow. */
function excluded(module: Module, one: Carried, transverse: boolean): Float64Array[] {
  const { invariants, relations, integrals, rates } = module.tables;
  const { state, values, scales } = one;
  const size = state.length;
  const count = relations + integrals.length;
  const wanted = transverse ? count : relations;
  const numbers = wanted > 0 ? module.values(invariants, state, values) : state;
  const vectors = Array.from({ length: wanted }, (_, i) => {
    const row = numbers.slice(count + i * size, count + (i + 1) * size);
    for (let k = 0; k < size; k++) row[k]! *= scales[k]!;
    return row;
  });
  if (transverse) {
    const flow = Float64Array.from(module.values(rates, state, values));
    for (let k = 0; k < size; k++) flow[k]! /= scales[k]!;
    vectors.push(flow);
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
  const times = Array.from({ length: LOOKS }, (_, i) => ((i + 1) / (10 * LOOKS)) * until);
  const start = new Float64Array(2 * size);
  start.set(state);
  const [run] = module.march(tangent, start, values, times, times.length, TOLERANCE);
  const largest = scalesOf(module, state);
  for (let i = 0; i < run!.count; i++) {
    const scales = scalesOf(module, run!.states.subarray(2 * size * i, 2 * size * i + size));
    for (let k = 0; k < size; k++) largest[k] = Math.max(largest[k]!, scales[k]!);
  }
  return largest;
}
