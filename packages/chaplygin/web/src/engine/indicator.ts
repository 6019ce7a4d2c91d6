/**
 * Chaos indicators of motions. A deviation is carried along each motion and measured after each
 * interval; the logarithms of its growth add up to L(t). MEGNO is twice the mean of L less its mean
 * until then: 2 on a regular motion, λ/2 times the time on a chaotic one. Lengths are measured with
 * each vector of the state divided by its size.
 */

import type { IndicatorsTask } from "./engine.js";
import { norm, orthonormal, remove } from "./linear.js";
import type { Marched, Module } from "./module.js";
import { scalesOf } from "./start.js";

const INTERVALS = 200;
/**
 * Intervals after which a deviation is made of length one. The method begins with short steps: it
 * goes through many intervals at once, unless the deviation leaves the range of doubles there.
 */
const STRETCH = 10;
/** Part of a motion left out of an exponent, where the deviation finds its direction. */
const UNSETTLED = 0.2;
const TOLERANCE = 1e-12;
/** Looks at the first tenth of a motion, for the sizes of its vectors. */
const LOOKS = 32;

/** One motion with its deviation. */
interface Carried {
  /** Its place among the motions. */
  index: number;
  values: Float64Array;
  state: Float64Array;
  scales: Float64Array;
  deviation: Float64Array;
  /** Intervals that are done. */
  done: number;
  /** L, its mean, the sum of MEGNO over the intervals, and L where the deviation has settled. */
  total: number;
  mean: number;
  sum: number;
  settled: number;
}

/** The indicators of motions that are computed side by side; not a number where one ends before. */
export function indicators(module: Module, task: IndicatorsTask): Float64Array {
  const size = module.tables.tangent.dimension / 2;
  const transverse = task.kind === "lyapunov";
  const results = new Float64Array(task.motions.length).fill(NaN);
  const all = task.motions.map(({ parameters, start }, index): Carried => {
    const values = module.parameters(parameters);
    const state = Float64Array.from(start).slice(0, size);
    const deviation = Float64Array.from(state, (_, k) => Math.cos(1 + 2.7 * k));
    return { index, values, state, scales: scalesOf(module, state), deviation, done: 0, total: 0, mean: 0, sum: 0, settled: 0 };
  });
  measure(module, all, task.until);
  let live = all.filter((one) => begin(module, one, transverse));
  const interval = task.until / INTERVALS;
  while (live.length > 0 && live[0]!.done < INTERVALS) {
    const runs = march(module, live, interval, STRETCH);
    live = live.filter((one, j) => follow(module, one, runs[j]!, transverse) || slowly(module, one, interval, transverse));
  }
  for (const { index, total, settled, sum } of live) {
    const exponent = (total - settled) / (task.until * (1 - UNSETTLED));
    results[index] = task.kind === "megno" ? sum / INTERVALS : exponent;
  }
  return results;
}

/** Motions with their deviations through some intervals. */
function march(module: Module, motions: readonly Carried[], interval: number, count: number): Marched[] {
  const { tangent } = module.tables;
  const size = tangent.dimension / 2;
  const width = module.model.parameters.length;
  const starts = new Float64Array(motions.length * 2 * size);
  const values = new Float64Array(motions.length * Math.max(width, 1));
  motions.forEach(({ state, scales, deviation, values: own }, j) => {
    starts.set(state, 2 * size * j);
    for (let c = 0; c < size; c++) starts[2 * size * j + size + c] = deviation[c]! * scales[c]!;
    values.set(own, width * j);
  });
  const times = Array.from({ length: count }, (_, i) => (i + 1) * interval);
  return module.march(tangent, starts, values, times, count, TOLERANCE);
}

/** Take note of the growth along a run; false, and nothing is changed, where it did not come to its end. */
function follow(module: Module, one: Carried, run: Marched, transverse: boolean): boolean {
  if (run.outcome !== 0) return false;
  const size = one.state.length;
  const states = new Float64Array(run.count * size);
  for (let n = 0; n < run.count; n++) states.set(run.states.subarray(2 * size * n, 2 * size * n + size), size * n);
  let deviation = one.deviation;
  const lengths = excludedBases(module, one, states, transverse).map((basis, n) => {
    deviation = Float64Array.from(one.scales, (scale, c) => run.states[2 * size * n + size + c]! / scale);
    return normalise(deviation, basis);
  });
  if (!lengths.every(Number.isFinite)) return false;
  const before = one.total;
  for (const length of lengths) {
    const last = one.total;
    one.total = before + Math.log(length);
    one.done += 1;
    one.mean += ((one.total + last) / 2 - one.mean) / one.done;
    one.sum += 2 * (one.total - one.mean);
    if (one.done <= UNSETTLED * INTERVALS) one.settled = one.total;
  }
  one.state = states.subarray((run.count - 1) * size);
  one.deviation = deviation;
  return true;
}

/** The same stretch interval by interval, as for a deviation that grows beyond all numbers; false where the motion ends. */
function slowly(module: Module, one: Carried, interval: number, transverse: boolean): boolean {
  for (let i = 0; i < STRETCH; i++) {
    const [run] = march(module, [one], interval, 1);
    if (!follow(module, one, run!, transverse)) return false;
  }
  return true;
}

/** Make the deviation at the start one of length one; false where neighbours cannot part. */
function begin(module: Module, one: Carried, transverse: boolean): boolean {
  const [basis] = excludedBases(module, one, one.state, transverse);
  // relations, integrals and the flow leave no deviation
  if (basis!.length >= one.state.length) return false;
  normalise(one.deviation, basis!);
  return true;
}

/** Make a deviation of length one, without the span of a basis; its length before. */
function normalise(deviation: Float64Array, basis: readonly Float64Array[]): number {
  for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(deviation, q);
  const length = norm(deviation);
  for (let k = 0; k < deviation.length; k++) deviation[k]! /= length;
  return length;
}

/** At each of some states, what is no deviation: across the relations; and across the integrals and along the flow. */
function excludedBases(
  module: Module,
  { values, scales }: Carried,
  states: Float64Array,
  transverse: boolean,
): Float64Array[][] {
  const { invariants, relations, integrals, rates } = module.tables;
  const size = scales.length;
  const count = relations + integrals.length;
  const wanted = transverse ? count : relations;
  const numbers = wanted > 0 ? module.values(invariants, states, values) : states;
  const flows = transverse ? module.values(rates, states, values) : null;
  return Array.from({ length: states.length / size }, (_, n) => {
    const vectors = Array.from({ length: wanted }, (_, i) => {
      const first = n * invariants.outputs + count + i * size;
      return scales.map((scale, k) => numbers[first + k]! * scale);
    });
    if (flows !== null) vectors.push(scales.map((scale, k) => flows[n * size + k]! / scale));
    return orthonormal(vectors);
  });
}

/** Measure by the largest sizes of the vectors of each state over the first tenth of its motion. */
function measure(module: Module, motions: readonly Carried[], until: number): void {
  const still = motions.map((one) => ({ ...one, deviation: new Float64Array(one.state.length) }));
  const runs = march(module, still, until / (10 * LOOKS), LOOKS);
  motions.forEach(({ state, scales }, j) => {
    const size = state.length;
    const { states, count } = runs[j]!;
    for (let i = 0; i < count; i++) {
      const found = scalesOf(module, states.subarray(2 * size * i, 2 * size * i + size));
      for (let k = 0; k < size; k++) scales[k] = Math.max(scales[k]!, found[k]!);
    }
  });
}
