/** Starts: from the numbers that a user turns, and from points of a section on a level. */

import type { LevelTask, Numbers, StartTask, State } from "./engine.js";
import { correction, dot, orthonormal, shortestStep } from "./linear.js";
import type { Module } from "./module.js";

/** A start may miss a relation by this much, relative to its size; more is refused, as in Python. */
const SLACK = 1e-12;
const STEPS = 40;
/** Relations of a motion that are missed by no more are left alone: to restore them costs a rounding. */
const LEFT_ALONE = 1e-14;
/** A step so short, relative to the state, is one of rounding. */
const ROUNDING = 1e-15;
/** Pieces of the way from a reference to a point of a section: first, and at most. */
const PIECES = 4;
const MOST_PIECES = 64;

/** The state that the start inputs give, or why there is none. */
export function startFrom(module: Module, { parameters, inputs }: StartTask): State {
  const { model, tables } = module;
  const values = module.parameters(parameters);
  const refused = notAdmissible(module, values);
  if (refused !== null) return { message: refused };
  const given = Float64Array.from(model.start_inputs, (row) => inputs[row.name] ?? row.value);
  const bad = given.findIndex((x) => !Number.isFinite(x));
  if (bad >= 0) {
    return { message: `${model.start_inputs[bad]!.name}: it must be a finite number` };
  }
  let state: Float64Array;
  if (tables.start === null) {
    const found = stateByName(module, given, values);
    if ("message" in found) return found;
    state = found.state;
  } else {
    const size = tables.motion.dimension;
    const numbers = module.values(tables.start, given, values);
    state = numbers.slice(0, size);
    const excess = numbers.slice(size, size + tables.excess.length);
    const nearest = numbers.slice(size + excess.length);
    for (const [i, { message, among }] of tables.excess.entries()) {
      const scale = Math.max(...among.map((k) => Math.abs(given[k]!)));
      if (Math.abs(excess[i]!) > SLACK * scale) {
        const shown = among.map((k) => repr(nearest[k]!)).join(", ");
        const text = message.replace("{excess}", short(excess[i]!)).replace("{nearest}", shown);
        return { message: text, nearest };
      }
    }
    if (!state.every(Number.isFinite)) return { message: tables.singular };
  }
  const outside = outsideDomain(module, state, values);
  return outside === null ? { state } : { message: outside };
}

/** The first parameter that is not admissible, in a sentence. */
function notAdmissible(module: Module, values: Float64Array): string | null {
  const { model, tables } = module;
  const bad = values.findIndex((x) => !Number.isFinite(x));
  if (bad >= 0) {
    const { name } = model.parameters[bad]!;
    return `${model.name}: ${name} = ${repr(values[bad]!)} must be a finite number`;
  }
  if (tables.conditions_on_parameters.length === 0) return null;
  const numbers = module.values(tables.admissible, new Float64Array(tables.admissible.inputs), values);
  const failed = numbers.findIndex((x) => !(x > 0));
  if (failed < 0) return null;
  const { parameter, condition } = tables.conditions_on_parameters[failed]!;
  const value = values[model.parameters.findIndex((p) => p.name === parameter)]!;
  return `${model.name}: ${parameter} = ${repr(value)} is not admissible; ${condition} must hold`;
}

/** The sentence of a guard that forbids a state. */
function outsideDomain(module: Module, state: Numbers, values: Float64Array): string | null {
  const { tables } = module;
  if (tables.start_messages.length === 0) return null;
  const reduced = Array.from(state).slice(0, tables.guards.inputs);
  const failed = module.values(tables.guards, reduced, values).findIndex((x) => !(x > 0));
  return failed < 0 ? null : tables.start_messages[failed]!;
}

/** A state given by its numbers, its directions made unit vectors, on the relations. */
function stateByName(module: Module, given: Float64Array, values: Float64Array): State {
  const { tables } = module;
  const state = Float64Array.from(given);
  for (const { name, places } of tables.directions) {
    const length = Math.hypot(...places.map((k) => state[k]!));
    if (length === 0) return { message: `${name}: must not be zero, as it is a direction` };
    for (const k of places) state[k]! /= length;
  }
  const point = Float64Array.from(state);
  const every = Array.from(point.keys());
  const first = onPhaseSpace(module, point, values, every);
  const scale = 1 + Math.max(0, ...state.map(Math.abs));
  const moved = Math.max(0, ...point.map((x, i) => Math.abs(x - state[i]!)));
  if (first.done && moved <= SLACK * scale) return { state: point };
  const worst = first.misses.reduce((a, x, i) => (Math.abs(x) > Math.abs(first.misses[a]!) ? i : a), 0);
  const text = `start: the relation ${tables.relation_texts[worst]} = 0 is missed by ${short(first.misses[worst]!)}`;
  return first.done ? { message: `${text}; the nearest admissible state is shown`, nearest: point } : { message: text };
}

/**
 * Put a state of a motion on the relations again, in place, where they are missed by more than rounding: off them an
 * error may grow. What places it in space is moved onto the rest, never the other way round.
 */
export function restoreRelations(module: Module, state: Float64Array, values: Float64Array): void {
  const { phase_space: table, whole_relations: count, relations, conditions } = module.tables;
  if (count === 0 || largestMiss(module.values(table, state, values), state, count) <= LEFT_ALONE) return;
  const places = Array.from(state.keys());
  onPhaseSpace(module, state, values, places.slice(0, conditions.inputs), correction, relations);
  onPhaseSpace(module, state, values, places.slice(conditions.inputs), correction);
}

/** Move some numbers of a whole state, in place, until the first relations hold, or all of them. */
export function onPhaseSpace(
  module: Module,
  state: Float64Array,
  values: Float64Array,
  moving: readonly number[],
  stepFor = shortestStep,
  first = module.tables.whole_relations,
): { done: boolean; misses: number[] } {
  const { phase_space: table, whole_relations: count } = module.tables;
  let before: number[] | null = null;
  if (first === 0 || moving.length === 0) return { done: true, misses: [] };
  const size = state.length;
  for (let step = 0; step < STEPS; step++) {
    const numbers = module.values(table, state, values);
    const misses = Array.from(numbers.subarray(0, first));
    before ??= misses;
    if (!misses.every(Number.isFinite)) break;
    const rows = misses.map((_, i) =>
      Float64Array.from(moving, (k) => numbers[count + i * size + k]!),
    );
    const change = stepFor({ rows, misses: misses.map((x) => -x) }, moving.length);
    moving.forEach((k, j) => (state[k]! += change[j]!));
    const scale = 1 + Math.max(...state.map(Math.abs));
    const longest = Math.max(...change.map(Math.abs));
    if (longest <= ROUNDING * scale) return { done: largestMiss(numbers, state, first) <= SLACK, misses: before };
  }
  return { done: false, misses: before ?? [] };
}

/** By how much the first relations are missed at most, relative to their size; what depends on others may be left unsolved. */
function largestMiss(numbers: Float64Array, state: Float64Array, first: number): number {
  const size = state.length;
  const count = numbers.length / (size + 1);
  const scale = 1 + Math.max(...state.map(Math.abs));
  let largest = 0;
  for (let i = 0; i < first; i++) {
    let reach = 0;
    for (let k = 0; k < size; k++) reach += Math.abs(numbers[count + i * size + k]!);
    const share = Math.abs(numbers[i]!) / (1 + reach * scale);
    largest = share <= largest ? largest : share;
  }
  return largest;
}

/**
 * The rows of the integrals that keep their values: none that is a coordinate itself or depends on
 * such, and no more than a state has numbers to spare.
 */
function keptIntegrals(module: Module, conditions: Float64Array, coordinates: string[]): number[] {
  const { tables, model } = module;
  const size = tables.conditions.inputs;
  const count = tables.relations + tables.integrals.length + model.quantities.length;
  const slope = (row: number): Float64Array =>
    conditions.slice(count + row * size, count + (row + 1) * size);
  const relations = [...Array(tables.relations).keys()];
  const rows = tables.integrals.map((name, i) => ({ name, row: tables.relations + i }));
  const free = rows.filter(({ name }) => coordinates.includes(name));
  const spare = size - tables.relations - coordinates.length;
  const kept: number[] = [];
  let basis = orthonormal([...relations, ...free.map(({ row }) => row)].map(slope));
  for (const { row } of rows.filter((each) => !free.includes(each))) {
    const more = orthonormal([...basis, slope(row)]);
    if (more.length > basis.length && kept.length < spare) kept.push(row);
    basis = more;
  }
  return kept;
}

/** The state of a level at a point of a section, reached from a reference on the same level. */
export function startOnLevel(module: Module, task: LevelTask): State {
  const { model, tables } = module;
  const { section } = task;
  const values = module.parameters(task.parameters);
  const size = tables.conditions.inputs;
  const names = model.quantities.map((q) => q.name);
  const chosen = [...(section.on === null ? [] : [section.on]), section.x, section.y];
  const places = chosen.map((name) => names.indexOf(name));
  const missing = chosen.find((_, i) => places[i]! < 0);
  if (missing !== undefined) return { message: `${missing}: no quantity of ${model.name}` };
  const before = tables.relations + tables.integrals.length;
  const count = before + names.length;
  const at = (z: Numbers): Float64Array => module.values(tables.conditions, z, values);
  const state = Float64Array.from(Array.from(task.reference).slice(0, size));
  const first = at(state);
  const kept = keptIntegrals(module, first, chosen);
  const conserved = tables.relations + kept.length;
  const rows = [...Array(tables.relations).keys(), ...kept, ...places.map((p) => before + p)];
  const turns = [...Array(conserved).fill(false), ...places.map((p) => model.quantities[p]!.angle)];
  const level = rows.map((row, i) => (i < tables.relations ? 0 : first[row]!));
  const goal = [...level.slice(0, conserved), ...(section.on === null ? [] : [section.value ?? 0]), task.x, task.y];
  const scales = scalesOf(module, state);
  /** Newton's method for given values of all conditions; null if it does not lead there. */
  const solve = (from: Float64Array, wanted: readonly number[]): Float64Array | null => {
    const z = Float64Array.from(from);
    for (let step = 0; step < STEPS; step++) {
      const numbers = at(z);
      const misses = rows.map((row, i) => difference(wanted[i]!, numbers[row]!, turns[i]!));
      const slopes = rows.map((row) =>
        Float64Array.from({ length: size }, (_, k) => numbers[count + row * size + k]! * scales[k]!),
      );
      const reach = slopes.map((row) => Math.sqrt(dot(row, row)));
      const far = Math.max(...misses.map((x, i) => Math.abs(x) / (reach[i]! + 1e-300)));
      if (!Number.isFinite(far)) return null;
      if (far < 1e-14 || (step > 6 && far < 1e-12)) return z;
      const change = shortestStep({ rows: slopes, misses }, size);
      // no step is longer than the vectors that it changes
      const longest = Math.max(...change.map(Math.abs));
      const share = Math.min(1, 0.5 / longest);
      for (let k = 0; k < size; k++) z[k]! += share * change[k]! * scales[k]!;
    }
    return null;
  };
  const last = rows.length - 1;
  for (let pieces = PIECES; pieces <= MOST_PIECES; pieces *= 4) {
    let z: Float64Array | null = state;
    for (let i = 1; i <= pieces && z !== null; i++) {
      const wanted = goal.map((value, k) => {
        if (k < conserved || k > last) return value;
        const from = first[rows[k]!]!;
        return from + (i / pieces) * difference(value, from, turns[k]!);
      });
      z = solve(z, wanted);
    }
    if (z === null) continue;
    const numbers = at(z);
    const flow = module.values(tables.rates, z, values);
    const slope = numbers.subarray(
      count + rows[conserved]! * size,
      count + (rows[conserved]! + 1) * size,
    );
    const rises = model.direction * dot(Float64Array.from(slope), flow);
    if (section.direction * model.direction * rises < 0) continue;
    const outside = outsideDomain(module, z, values);
    if (outside !== null) return { message: outside };
    return withLift(module, z, task.reference, values);
  }
  return {
    message: `no state on this level was found at ${section.x} = ${short(task.x)}, ${section.y} = ${short(task.y)}`,
  };
}

/** A whole state for a reduced one: what places it in space as near to a reference as may be. */
function withLift(
  module: Module,
  reduced: Float64Array,
  reference: Numbers,
  values: Float64Array,
): State {
  const { model, tables } = module;
  const size = tables.motion.dimension;
  const known = reference.length >= size ? reference : model.start;
  const state = Float64Array.from({ length: size }, (_, k) =>
    k < reduced.length ? reduced[k]! : known[k]!,
  );
  const moving = Array.from({ length: size - reduced.length }, (_, k) => reduced.length + k);
  if (moving.length > 0 && !onPhaseSpace(module, state, values, moving).done) {
    return { message: `${model.name}: no attitude belongs to this state` };
  }
  return { state };
}

/** For each number the size of its vector. */
export function scalesOf(module: Module, state: Numbers): Float64Array {
  const scales = new Float64Array(module.tables.conditions.inputs).fill(1);
  const sizes = module.tables.groups.map((group) => Math.hypot(...group.map((k) => state[k]!)));
  const largest = Math.max(...sizes);
  module.tables.groups.forEach((group, i) => {
    const size = sizes[i]! > 1e-10 * largest ? sizes[i]! : largest > 0 ? largest : 1;
    for (const k of group) scales[k] = size;
  });
  return scales;
}

/** a − b, of angles within half a turn. */
function difference(a: number, b: number, angle: boolean): number {
  const plain = a - b;
  return angle ? plain - 2 * Math.PI * Math.round(plain / (2 * Math.PI)) : plain;
}

/** A number as Python writes it. */
function repr(x: number): string {
  return Number.isInteger(x) && Math.abs(x) < 1e16 ? x.toFixed(1) : String(x);
}

/** A number in six digits. */
function short(x: number): string {
  return String(Number(x.toPrecision(6)));
}
