// src/engine/body_mesh.ts
function directions(theta, phi) {
  const gamma = new Float64Array(3 * theta.length * phi.length);
  let at = 0;
  for (let i = 0; i < theta.length; i++) {
    for (let j = 0; j < phi.length; j++) {
      const sine = Math.sin(theta[i]);
      gamma[at++] = sine * Math.cos(phi[j]);
      gamma[at++] = sine * Math.sin(phi[j]);
      gamma[at++] = Math.cos(theta[i]);
    }
  }
  return gamma;
}
function meshOfGrid(body, points) {
  const { theta, phi, hollow } = body;
  const rows = theta.length;
  const columns = phi.length;
  const gamma = directions(theta, phi);
  const side = hollow ? 1 : -1;
  const grid = rows * columns;
  const count = grid + 2 * (columns + 1);
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  for (let k = 0; k < 3 * grid; k++) {
    positions[k] = points[k];
    normals[k] = side * gamma[k];
  }
  const indices = [];
  const tones = [];
  const face = (a, b, c, tone) => {
    if (!turnsOutward(positions, normals, a, b, c)) [b, c] = [c, b];
    indices.push(a, b, c);
    tones.push(tone);
  };
  const quarter = (j) => Math.floor((phi[j] + 1e-9) / (Math.PI / 2));
  for (let i = 0; i + 1 < rows; i++) {
    const northern = (theta[i] + theta[i + 1]) / 2 < Math.PI / 2 ? 1 : 0;
    for (let j = 0; j < columns; j++) {
      const k = (j + 1) % columns;
      const tone = (quarter(j) + northern) % 2;
      face(i * columns + j, i * columns + k, (i + 1) * columns + k, tone);
      face(i * columns + j, (i + 1) * columns + k, (i + 1) * columns + j, tone);
    }
  }
  for (const north of [true, false]) {
    const ring = (north ? 0 : rows - 1) * columns;
    const first = grid + (north ? 0 : columns + 1);
    const middle = first + columns;
    const up = side * (north ? 1 : -1);
    for (let j = 0; j < columns; j++) {
      for (let c = 0; c < 3; c++) {
        const value = positions[3 * (ring + j) + c];
        positions[3 * (first + j) + c] = value;
        positions[3 * middle + c] += value / columns;
      }
      normals[3 * (first + j) + 2] = up;
    }
    normals[3 * middle + 2] = up;
    for (let j = 0; j < columns; j++) {
      face(middle, first + j, first + (j + 1) % columns, (quarter(j) + (north ? 1 : 0)) % 2);
    }
  }
  return {
    positions,
    normals,
    indices: Uint32Array.from(indices),
    tones: Uint8Array.from(tones),
    hollow
  };
}
function turnsOutward(p, n, a, b, c) {
  const u = [0, 1, 2].map((k) => p[3 * b + k] - p[3 * a + k]);
  const v = [0, 1, 2].map((k) => p[3 * c + k] - p[3 * a + k]);
  let sum = 0;
  for (let k = 0; k < 3; k++) {
    const i = (k + 1) % 3;
    const j = (k + 2) % 3;
    const normal = n[3 * a + k] + n[3 * b + k] + n[3 * c + k];
    sum += (u[i] * v[j] - u[j] * v[i]) * normal;
  }
  return sum >= 0;
}

// src/engine/linear.ts
var DEPENDENT = 1e-9;
function shortestStep({ rows, misses }, size) {
  const step = new Float64Array(size);
  const basis = [];
  rows.forEach((row, i) => {
    const left = Float64Array.from(row);
    const whole = norm(row);
    for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(left, q);
    const length = norm(left);
    if (!(length > DEPENDENT * whole)) return;
    for (let k = 0; k < size; k++) left[k] /= length;
    const share = (misses[i] - dot(row, step)) / length;
    for (let k = 0; k < size; k++) step[k] += share * left[k];
    basis.push(left);
  });
  return step;
}
function correction({ rows, misses }, size) {
  const step = new Float64Array(size);
  const left = rows.map((row) => Float64Array.from(row));
  const whole = rows.map(norm);
  const share = (i) => norm(left[i]) / (whole[i] || 1);
  const open = new Set(rows.keys());
  while (open.size > 0) {
    const i = [...open].reduce((a, b) => share(b) > share(a) ? b : a);
    open.delete(i);
    const length = norm(left[i]);
    if (!(length > DEPENDENT * whole[i])) break;
    const q = left[i].map((x) => x / length);
    const way = (misses[i] - dot(rows[i], step)) / length;
    for (let k = 0; k < size; k++) step[k] += way * q[k];
    for (const j of open) for (let pass = 0; pass < 2; pass++) remove(left[j], q);
  }
  return step;
}
function orthonormal(vectors) {
  const basis = [];
  for (const vector of vectors) {
    const left = Float64Array.from(vector);
    const whole = norm(vector);
    for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(left, q);
    const length = norm(left);
    if (length > DEPENDENT * whole) basis.push(left.map((x) => x / length));
  }
  return basis;
}
function remove(vector, q) {
  const share = dot(vector, q);
  for (let k = 0; k < vector.length; k++) vector[k] -= share * q[k];
}
function dot(a, b) {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += a[k] * b[k];
  return sum;
}
function norm(a) {
  return Math.sqrt(dot(a, a));
}

// src/engine/start.ts
var SLACK = 1e-12;
var STEPS = 40;
var LEFT_ALONE = 1e-14;
var ROUNDING = 1e-15;
var PIECES = 4;
var MOST_PIECES = 64;
function startFrom(module, { parameters, inputs }) {
  const { model, tables } = module;
  const values = module.parameters(parameters);
  const refused = notAdmissible(module, values);
  if (refused !== null) return { message: refused };
  const given = Float64Array.from(model.start_inputs, (row) => inputs[row.name] ?? row.value);
  const bad = given.findIndex((x) => !Number.isFinite(x));
  if (bad >= 0) {
    return { message: `${model.start_inputs[bad].name}: it must be a finite number` };
  }
  let state;
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
      const scale = Math.max(...among.map((k) => Math.abs(given[k])));
      if (Math.abs(excess[i]) > SLACK * scale) {
        const shown = among.map((k) => repr(nearest[k])).join(", ");
        const text = message.replace("{excess}", short(excess[i])).replace("{nearest}", shown);
        return { message: text, nearest };
      }
    }
    if (!state.every(Number.isFinite)) return { message: tables.singular };
  }
  const outside = outsideDomain(module, state, values);
  return outside === null ? { state } : { message: outside };
}
function notAdmissible(module, values) {
  const { model, tables } = module;
  const bad = values.findIndex((x) => !Number.isFinite(x));
  if (bad >= 0) {
    const { name } = model.parameters[bad];
    return `${model.name}: ${name} = ${repr(values[bad])} must be a finite number`;
  }
  if (tables.conditions_on_parameters.length === 0) return null;
  const numbers = module.values(tables.admissible, new Float64Array(tables.admissible.inputs), values);
  const failed = numbers.findIndex((x) => !(x > 0));
  if (failed < 0) return null;
  const { parameter, condition } = tables.conditions_on_parameters[failed];
  const value = values[model.parameters.findIndex((p) => p.name === parameter)];
  return `${model.name}: ${parameter} = ${repr(value)} is not admissible; ${condition} must hold`;
}
function outsideDomain(module, state, values) {
  const { tables } = module;
  if (tables.start_messages.length === 0) return null;
  const reduced = Array.from(state).slice(0, tables.guards.inputs);
  const failed = module.values(tables.guards, reduced, values).findIndex((x) => !(x > 0));
  return failed < 0 ? null : tables.start_messages[failed];
}
function stateByName(module, given, values) {
  const { tables } = module;
  const state = Float64Array.from(given);
  for (const { name, places } of tables.directions) {
    const length = Math.hypot(...places.map((k) => state[k]));
    if (length === 0) return { message: `${name}: must not be zero, as it is a direction` };
    for (const k of places) state[k] /= length;
  }
  const point = Float64Array.from(state);
  const every = Array.from(point.keys());
  const first = onPhaseSpace(module, point, values, every);
  const scale = 1 + Math.max(0, ...state.map(Math.abs));
  const moved = Math.max(0, ...point.map((x, i) => Math.abs(x - state[i])));
  if (first.done && moved <= SLACK * scale) return { state: point };
  const worst = first.misses.reduce((a, x, i) => Math.abs(x) > Math.abs(first.misses[a]) ? i : a, 0);
  const text = `start: the relation ${tables.relation_texts[worst]} = 0 is missed by ${short(first.misses[worst])}`;
  return first.done ? { message: `${text}; the nearest admissible state is shown`, nearest: point } : { message: text };
}
function restoreRelations(module, state, values) {
  const { phase_space: table, whole_relations: count, relations, conditions } = module.tables;
  if (count === 0 || largestMiss(module.values(table, state, values), state, count) <= LEFT_ALONE) return;
  const places = Array.from(state.keys());
  onPhaseSpace(module, state, values, places.slice(0, conditions.inputs), correction, relations);
  onPhaseSpace(module, state, values, places.slice(conditions.inputs), correction);
}
function onPhaseSpace(module, state, values, moving, stepFor = shortestStep, first = module.tables.whole_relations) {
  const { phase_space: table, whole_relations: count } = module.tables;
  let before = null;
  if (first === 0 || moving.length === 0) return { done: true, misses: [] };
  const size = state.length;
  for (let step = 0; step < STEPS; step++) {
    const numbers = module.values(table, state, values);
    const misses = Array.from(numbers.subarray(0, first));
    before ??= misses;
    if (!misses.every(Number.isFinite)) break;
    const rows = misses.map(
      (_, i) => Float64Array.from(moving, (k) => numbers[count + i * size + k])
    );
    const change = stepFor({ rows, misses: misses.map((x) => -x) }, moving.length);
    moving.forEach((k, j) => state[k] += change[j]);
    const scale = 1 + Math.max(...state.map(Math.abs));
    const longest = Math.max(...change.map(Math.abs));
    if (longest <= ROUNDING * scale) return { done: largestMiss(numbers, state, first) <= SLACK, misses: before };
  }
  return { done: false, misses: before ?? [] };
}
function largestMiss(numbers, state, first) {
  const size = state.length;
  const count = numbers.length / (size + 1);
  const scale = 1 + Math.max(...state.map(Math.abs));
  let largest = 0;
  for (let i = 0; i < first; i++) {
    let reach = 0;
    for (let k = 0; k < size; k++) reach += Math.abs(numbers[count + i * size + k]);
    const share = Math.abs(numbers[i]) / (1 + reach * scale);
    largest = share <= largest ? largest : share;
  }
  return largest;
}
function keptIntegrals(module, conditions, coordinates) {
  const { tables, model } = module;
  const size = tables.conditions.inputs;
  const count = tables.relations + tables.integrals.length + model.quantities.length;
  const slope = (row) => conditions.slice(count + row * size, count + (row + 1) * size);
  const relations = [...Array(tables.relations).keys()];
  const rows = tables.integrals.map((name, i) => ({ name, row: tables.relations + i }));
  const free = rows.filter(({ name }) => coordinates.includes(name));
  const spare = size - tables.relations - coordinates.length;
  const kept = [];
  let basis = orthonormal([...relations, ...free.map(({ row }) => row)].map(slope));
  for (const { row } of rows.filter((each) => !free.includes(each))) {
    const more = orthonormal([...basis, slope(row)]);
    if (more.length > basis.length && kept.length < spare) kept.push(row);
    basis = more;
  }
  return kept;
}
function startOnLevel(module, task) {
  const { model, tables } = module;
  const { section } = task;
  const values = module.parameters(task.parameters);
  const size = tables.conditions.inputs;
  const names = model.quantities.map((q) => q.name);
  const chosen = [...section.on === null ? [] : [section.on], section.x, section.y];
  const places = chosen.map((name) => names.indexOf(name));
  const missing = chosen.find((_, i) => places[i] < 0);
  if (missing !== void 0) return { message: `${missing}: no quantity of ${model.name}` };
  const before = tables.relations + tables.integrals.length;
  const count = before + names.length;
  const at = (z) => module.values(tables.conditions, z, values);
  const state = Float64Array.from(Array.from(task.reference).slice(0, size));
  const first = at(state);
  const kept = keptIntegrals(module, first, chosen);
  const conserved = tables.relations + kept.length;
  const rows = [...Array(tables.relations).keys(), ...kept, ...places.map((p) => before + p)];
  const turns = [...Array(conserved).fill(false), ...places.map((p) => model.quantities[p].angle)];
  const level = rows.map((row, i) => i < tables.relations ? 0 : first[row]);
  const goal = [...level.slice(0, conserved), ...section.on === null ? [] : [section.value ?? 0], task.x, task.y];
  const scales = scalesOf(module, state);
  const solve = (from, wanted) => {
    const z = Float64Array.from(from);
    for (let step = 0; step < STEPS; step++) {
      const numbers = at(z);
      const misses = rows.map((row, i) => difference(wanted[i], numbers[row], turns[i]));
      const slopes = rows.map(
        (row) => Float64Array.from({ length: size }, (_, k) => numbers[count + row * size + k] * scales[k])
      );
      const reach = slopes.map((row) => Math.sqrt(dot(row, row)));
      const far = Math.max(...misses.map((x, i) => Math.abs(x) / (reach[i] + 1e-300)));
      if (!Number.isFinite(far)) return null;
      if (far < 1e-14 || step > 6 && far < 1e-12) return z;
      const change = shortestStep({ rows: slopes, misses }, size);
      const longest = Math.max(...change.map(Math.abs));
      const share = Math.min(1, 0.5 / longest);
      for (let k = 0; k < size; k++) z[k] += share * change[k] * scales[k];
    }
    return null;
  };
  const last = rows.length - 1;
  for (let pieces = PIECES; pieces <= MOST_PIECES; pieces *= 4) {
    let z = state;
    for (let i = 1; i <= pieces && z !== null; i++) {
      const wanted = goal.map((value, k) => {
        if (k < conserved || k > last) return value;
        const from = first[rows[k]];
        return from + i / pieces * difference(value, from, turns[k]);
      });
      z = solve(z, wanted);
    }
    if (z === null) continue;
    const numbers = at(z);
    const flow = module.values(tables.rates, z, values);
    const slope = numbers.subarray(
      count + rows[conserved] * size,
      count + (rows[conserved] + 1) * size
    );
    const rises = model.direction * dot(Float64Array.from(slope), flow);
    if (section.direction * model.direction * rises < 0) continue;
    const outside = outsideDomain(module, z, values);
    if (outside !== null) return { message: outside };
    return withLift(module, z, task.reference, values);
  }
  return {
    message: `no state on this level was found at ${section.x} = ${short(task.x)}, ${section.y} = ${short(task.y)}`
  };
}
function withLift(module, reduced, reference, values) {
  const { model, tables } = module;
  const size = tables.motion.dimension;
  const known = reference.length >= size ? reference : model.start;
  const state = Float64Array.from(
    { length: size },
    (_, k) => k < reduced.length ? reduced[k] : known[k]
  );
  const moving = Array.from({ length: size - reduced.length }, (_, k) => reduced.length + k);
  if (moving.length > 0 && !onPhaseSpace(module, state, values, moving).done) {
    return { message: `${model.name}: no attitude belongs to this state` };
  }
  return { state };
}
function scalesOf(module, state) {
  const scales = new Float64Array(module.tables.conditions.inputs).fill(1);
  const sizes = module.tables.groups.map((group) => Math.hypot(...group.map((k) => state[k])));
  const largest = Math.max(...sizes);
  module.tables.groups.forEach((group, i) => {
    const size = sizes[i] > 1e-10 * largest ? sizes[i] : largest > 0 ? largest : 1;
    for (const k of group) scales[k] = size;
  });
  return scales;
}
function difference(a, b, angle) {
  const plain = a - b;
  return angle ? plain - 2 * Math.PI * Math.round(plain / (2 * Math.PI)) : plain;
}
function repr(x) {
  return Number.isInteger(x) && Math.abs(x) < 1e16 ? x.toFixed(1) : String(x);
}
function short(x) {
  return String(Number(x.toPrecision(6)));
}

// src/engine/indicator.ts
var INTERVALS = 200;
var STRETCH = 10;
var UNSETTLED = 0.2;
var TOLERANCE = 1e-12;
var LOOKS = 32;
function indicators(module, task) {
  const size = module.tables.tangent.dimension / 2;
  const transverse = task.kind === "lyapunov";
  const results = new Float64Array(task.motions.length).fill(NaN);
  const all = task.motions.map(({ parameters, start }, index) => {
    const values = module.parameters(parameters);
    const state = Float64Array.from(start).slice(0, size);
    const deviation = Float64Array.from(state, (_, k) => Math.cos(1 + 2.7 * k));
    return { index, values, state, scales: scalesOf(module, state), deviation, done: 0, total: 0, mean: 0, sum: 0, settled: 0 };
  });
  measure(module, all, task.until);
  let live = all.filter((one) => begin(module, one, transverse));
  const interval = task.until / INTERVALS;
  while (live.length > 0 && live[0].done < INTERVALS) {
    const runs = march(module, live, interval, STRETCH);
    live = live.filter((one, j) => follow(module, one, runs[j], transverse) || slowly(module, one, interval, transverse));
  }
  for (const { index, total, settled, sum } of live) {
    const exponent = (total - settled) / (task.until * (1 - UNSETTLED));
    results[index] = task.kind === "megno" ? sum / INTERVALS : exponent;
  }
  return results;
}
function march(module, motions, interval, count) {
  const { tangent } = module.tables;
  const size = tangent.dimension / 2;
  const width = module.model.parameters.length;
  const starts = new Float64Array(motions.length * 2 * size);
  const values = new Float64Array(motions.length * Math.max(width, 1));
  motions.forEach(({ state, scales, deviation, values: own }, j) => {
    starts.set(state, 2 * size * j);
    for (let c = 0; c < size; c++) starts[2 * size * j + size + c] = deviation[c] * scales[c];
    values.set(own, width * j);
  });
  const times = Array.from({ length: count }, (_, i) => (i + 1) * interval);
  return module.march(tangent, starts, values, times, count, TOLERANCE);
}
function follow(module, one, run, transverse) {
  if (run.outcome !== 0) return false;
  const size = one.state.length;
  const states = new Float64Array(run.count * size);
  for (let n = 0; n < run.count; n++) states.set(run.states.subarray(2 * size * n, 2 * size * n + size), size * n);
  let deviation = one.deviation;
  const lengths = excludedBases(module, one, states, transverse).map((basis, n) => {
    deviation = Float64Array.from(one.scales, (scale, c) => run.states[2 * size * n + size + c] / scale);
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
function slowly(module, one, interval, transverse) {
  for (let i = 0; i < STRETCH; i++) {
    const [run] = march(module, [one], interval, 1);
    if (!follow(module, one, run, transverse)) return false;
  }
  return true;
}
function begin(module, one, transverse) {
  const [basis] = excludedBases(module, one, one.state, transverse);
  if (basis.length >= one.state.length) return false;
  normalise(one.deviation, basis);
  return true;
}
function normalise(deviation, basis) {
  for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(deviation, q);
  const length = norm(deviation);
  for (let k = 0; k < deviation.length; k++) deviation[k] /= length;
  return length;
}
function excludedBases(module, { values, scales }, states, transverse) {
  const { invariants, relations, integrals, rates } = module.tables;
  const size = scales.length;
  const count = relations + integrals.length;
  const wanted = transverse ? count : relations;
  const numbers = wanted > 0 ? module.values(invariants, states, values) : states;
  const flows = transverse ? module.values(rates, states, values) : null;
  return Array.from({ length: states.length / size }, (_, n) => {
    const vectors = Array.from({ length: wanted }, (_2, i) => {
      const first = n * invariants.outputs + count + i * size;
      return scales.map((scale, k) => numbers[first + k] * scale);
    });
    if (flows !== null) vectors.push(scales.map((scale, k) => flows[n * size + k] / scale));
    return orthonormal(vectors);
  });
}
function measure(module, motions, until) {
  const still = motions.map((one) => ({ ...one, deviation: new Float64Array(one.state.length) }));
  const runs = march(module, still, until / (10 * LOOKS), LOOKS);
  motions.forEach(({ state, scales }, j) => {
    const size = state.length;
    const { states, count } = runs[j];
    for (let i = 0; i < count; i++) {
      const found = scalesOf(module, states.subarray(2 * size * i, 2 * size * i + size));
      for (let k = 0; k < size; k++) scales[k] = Math.max(scales[k], found[k]);
    }
  });
}

// src/encoding.ts
function bytes(text) {
  const raw = atob(text);
  const result = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) result[i] = raw.charCodeAt(i);
  return result;
}
function floats(text) {
  return new Float32Array(bytes(text).buffer);
}
function integers(text) {
  return new Uint32Array(bytes(text).buffer);
}
async function inflated(text) {
  const stream = new Blob([bytes(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}

// src/engine/module.ts
var PAGE = 1 << 16;
var MOST_STEPS = 10000000n;
var FIRST = 1024;
var Module = class _Module {
  constructor(model, tables, memory, functions) {
    this.model = model;
    this.tables = tables;
    this.memory = memory;
    this.functions = functions;
  }
  model;
  tables;
  memory;
  functions;
  at = FIRST;
  static async create(model) {
    if (model.wasm === null || model.wasm_tables === null) {
      throw new Error(`${model.title}: this page cannot compute`);
    }
    const memory = new WebAssembly.Memory({ initial: 16 });
    const source = await WebAssembly.instantiate(await inflated(model.wasm), { env: { memory } });
    return new _Module(model, model.wasm_tables, memory, source.instance.exports);
  }
  /** The parameters of the system in order, the given ones replacing the defaults. */
  parameters(values) {
    const known = new Set(this.model.parameters.map((p) => p.name));
    for (const name of Object.keys(values)) {
      if (!known.has(name)) {
        const all = [...known].join(", ") || "none";
        throw new RangeError(`${this.model.name}: no parameter ${name}; it has ${all}`);
      }
    }
    return Float64Array.from(this.model.parameters, (p) => values[p.name] ?? p.value);
  }
  /**
   * Motions from rows of starts, each through `times`, or its crossings; `parameters` are those of
   * all, or one row for each.
   */
  march(table, starts, parameters, times, wanted, tolerance) {
    const motions = starts.length / table.dimension;
    const stride = parameters.length > table.parameters ? BigInt(table.parameters) : 0n;
    this.at = FIRST;
    const from = this.put(starts);
    const values = this.put(parameters);
    const moments = this.put(times);
    const states = this.room(motions * wanted * table.dimension);
    const found = this.room(motions * wanted);
    const counts = this.room(motions);
    const outcome = this.room(motions);
    const ended = this.room(motions);
    const taken = this.room(motions);
    const work = this.room(table.work);
    this.doubles(states, motions * wanted * table.dimension).fill(NaN);
    this.whole(counts, motions).fill(0n);
    const march2 = this.functions[table.name];
    march2(
      ...[0n, BigInt(motions), from, values, stride, moments, BigInt(wanted), tolerance, MOST_STEPS],
      ...[states, found, counts, outcome, ended, taken, work]
    );
    return Array.from({ length: motions }, (_, k) => {
      const count = Number(this.whole(counts, motions)[k]);
      const size = wanted * table.dimension;
      return {
        states: this.doubles(states + 8 * k * size, count * table.dimension).slice(),
        moments: this.doubles(found + 8 * k * wanted, count).slice(),
        count,
        outcome: Number(this.whole(outcome, motions)[k]),
        ended: this.doubles(ended, motions)[k],
        steps: Number(this.whole(taken, motions)[k])
      };
    });
  }
  /** A group of formulas at rows of numbers. */
  values(table, rows, parameters) {
    const count = rows.length / table.inputs;
    this.at = FIRST;
    const from = this.put(rows);
    const values = this.put(parameters);
    const results = this.room(count * table.outputs);
    const work = this.room(table.work);
    this.functions[table.name](BigInt(count), from, values, results, work);
    return this.doubles(results, count * table.outputs).slice();
  }
  put(numbers) {
    const place = this.room(Math.max(numbers.length, 1));
    this.doubles(place, numbers.length).set(numbers);
    return place;
  }
  /** The address of room for some doubles. */
  room(count) {
    const place = this.at;
    this.at += 16 * Math.ceil(count / 2);
    const missing = this.at - this.memory.buffer.byteLength;
    if (missing > 0) this.memory.grow(Math.ceil(missing / PAGE));
    return place;
  }
  doubles(place, count) {
    return new Float64Array(this.memory.buffer, place, count);
  }
  whole(place, count) {
    return new BigInt64Array(this.memory.buffer, place, count);
  }
};

// src/engine/surfaces.ts
var STEPS2 = 8;
var ROWS = 24;
var COLUMNS = 48;
function surfacesOf({ scene }) {
  return { body: scene.body === null ? null : meshOfGrid(scene.body, floats(scene.body.positions)), inertia: null, ground: groundOf(scene.support) };
}
function groundOf(support) {
  if (support?.kind !== "mesh") return null;
  return { positions: floats(support.positions), normals: floats(support.normals), indices: integers(support.indices) };
}
var DrawnSurfaces = class {
  constructor(module) {
    this.module = module;
    this.first = surfacesOf(module.model);
  }
  module;
  first;
  at(parameters) {
    const { module, first } = this;
    const { contact, inertia, ground } = module.tables;
    const values = module.parameters(parameters);
    return {
      body: contact === null || first.body === null ? first.body : this.body(contact, values),
      inertia: inertia === null ? null : this.closed(inertia, values),
      ground: ground === null || first.ground === null ? first.ground : this.ground(ground, first.ground, values)
    };
  }
  body(table, values) {
    const { body } = this.module.model.scene;
    if (body === null) return null;
    const gamma = directions(body.theta, body.phi);
    const points = this.rows(table, gamma, values);
    const side = body.hollow ? 1 : -1;
    for (let i = 0; i < gamma.length; i += 3) {
      const up = side * gamma[i + 2];
      if (Math.abs(up) > 1e-9) points[i + 2] += body.thickness * Math.sign(up);
    }
    return meshOfGrid(body, points);
  }
  closed(table, values) {
    const theta = Array.from({ length: ROWS }, (_, k) => Math.PI * (k + 0.02) / (ROWS - 0.96));
    const phi = Array.from({ length: COLUMNS }, (_, k) => 2 * Math.PI * k / COLUMNS);
    const points = this.rows(table, directions(theta, phi), values);
    return meshOfGrid({ theta, phi, positions: "", hollow: false, thickness: 0 }, points);
  }
  /** The corners of a surface moved onto the one of other parameters. */
  ground(table, known, values) {
    const usual = this.module.parameters({});
    if (values.every((value, k) => value === usual[k])) return known;
    const places = Float64Array.from(known.positions);
    const count = places.length / 3;
    const before = this.rows(table, places, usual);
    for (let k = 0; k < places.length; k++) places[k] += before[5 * Math.floor(k / 3) + 4] * known.normals[k];
    const normals = Float32Array.from(known.normals);
    let f = new Float64Array(0);
    for (let step = 0; step <= STEPS2; step++) {
      f = this.rows(table, places, values);
      for (let n = 0; n < count; n++) {
        const [value, x, y, z] = [f[5 * n], f[5 * n + 1], f[5 * n + 2], f[5 * n + 3]];
        const square = x * x + y * y + z * z;
        if (!(square > 0) || !Number.isFinite(value)) continue;
        const share = step < STEPS2 ? -value / square : 0;
        const length = Math.sqrt(square);
        [x, y, z].forEach((slope, i) => {
          places[3 * n + i] += share * slope;
          normals[3 * n + i] = slope / length;
        });
      }
    }
    const positions = Float32Array.from(places, (place, k) => place - f[5 * Math.floor(k / 3) + 4] * normals[k]);
    return { positions, normals, indices: known.indices };
  }
  /** Results of a table for rows of three numbers. */
  rows(table, three, values) {
    const { module } = this;
    const count = three.length / 3;
    const rows = new Float64Array(count * table.inputs);
    for (let i = 0; i < count; i++) rows.set(three.subarray(3 * i, 3 * i + 3), i * table.inputs + module.tables.gamma);
    return module.values(table, rows, values);
  }
};

// src/engine/wasm_engine.ts
var STRETCHES = 20;
var WasmEngine = class _WasmEngine {
  constructor(model, module) {
    this.model = model;
    this.module = module;
  }
  model;
  module;
  drawn = null;
  static async create(model) {
    return new _WasmEngine(model, await Module.create(model));
  }
  async motion({ parameters, start, times }) {
    const { model, module } = this;
    const values = module.parameters(parameters);
    const marched = this.states(start, values, times);
    const { count, states } = marched;
    const numbers = module.values(module.tables.columns, states, values);
    const width = module.tables.columns.outputs;
    const columns = {};
    let first = 0;
    for (const column of model.columns) {
      const part = new Float64Array(count * column.width);
      for (let i = 0; i < count; i++) {
        for (let k = 0; k < column.width; k++) {
          part[i * column.width + k] = numbers[i * width + first + k];
        }
      }
      columns[column.name] = part;
      first += column.width;
    }
    const moments = Float64Array.from({ length: count }, (_, i) => model.direction * times[i]);
    return { times: moments, columns, states, end: this.end(marched) };
  }
  /** Whole states at times, in stretches after which the relations hold but for rounding. */
  states(start, values, times) {
    const { model, module } = this;
    const table = module.tables.motion;
    const size = table.dimension;
    const states = new Float64Array(times.length * size);
    const piece = Math.ceil(times.length / STRETCHES);
    let state = start;
    let [count, began] = [0, 0];
    while (count < times.length) {
      const wanted = Math.min(piece, times.length - count);
      const moments = Array.from({ length: wanted }, (_, i) => times[count + i] - began);
      const [run] = module.march(table, state, values, moments, wanted, model.tolerance);
      states.set(run.states, count * size);
      count += run.count;
      if (run.outcome !== 0) return { states: states.slice(0, count * size), count, outcome: run.outcome, ended: began + run.ended };
      const last = states.subarray((count - 1) * size, count * size);
      const now = times[count - 1];
      if (now !== began) restoreRelations(module, last, values);
      [state, began] = [last, now];
    }
    return { states, count, outcome: 0, ended: began };
  }
  async section(task) {
    const { model, module } = this;
    const { section, section_quantities: names } = module.tables;
    const chosen = names.indexOf(task.on);
    if (chosen < 0) {
      throw new RangeError(`${task.on}: no quantity of a section; they are ${names.join(", ")}`);
    }
    const own = module.parameters(task.parameters);
    const values = new Float64Array(own.length + 2 + names.length);
    values.set(own);
    values[own.length] = task.value ?? 0;
    values[own.length + 1] = model.direction * task.direction;
    values[own.length + 2 + chosen] = 1;
    const start = Array.from(task.start).slice(0, section.dimension);
    const until = [task.until ?? Infinity];
    const [marched] = module.march(section, start, values, until, task.points, model.section_tolerance);
    const { states, moments } = marched;
    const times = moments.map((t) => model.direction * t);
    return { rows: states, times, dimension: section.dimension, end: this.end(marched) };
  }
  async quantities(parameters, rows, dimension) {
    const { module } = this;
    const table = module.tables.quantities;
    return module.values(table, firstColumns(rows, dimension, table.inputs), module.parameters(parameters));
  }
  async indicator(task) {
    const { parameters, start, until, kind } = task;
    const [value] = indicators(this.module, { motions: [{ parameters, start }], until, kind });
    return value;
  }
  async indicators(task) {
    return indicators(this.module, task);
  }
  async startFrom(task) {
    return startFrom(this.module, task);
  }
  async startOnLevel(task) {
    return startOnLevel(this.module, task);
  }
  async surfaces(parameters) {
    this.drawn ??= new DrawnSurfaces(this.module);
    return this.drawn.at(parameters);
  }
  end({ outcome, ended }) {
    if (outcome === 0) return null;
    const reason = this.module.tables.reasons[outcome] ?? `outcome ${outcome}`;
    return { time: this.model.direction * ended, reason };
  }
};
function firstColumns(rows, dimension, width) {
  if (dimension === width) return rows;
  const count = rows.length / dimension;
  const result = new Float64Array(count * width);
  for (let i = 0; i < count; i++) {
    result.set(rows.subarray(i * dimension, i * dimension + width), i * width);
  }
  return result;
}
export {
  WasmEngine,
  directions,
  meshOfGrid
};
