/** A module with its memory, and calls of its functions. */

import { inflated } from "../encoding.js";
import type { MarchTable, PageModel, ValuesTable, WasmTables } from "../model.js";
import type { Numbers, Values } from "./engine.js";

const PAGE = 1 << 16;
/** Steps of one motion at most, as in Python. */
export const MOST_STEPS = 10_000_000n;
/** The memory below is left alone: an address of 0 is none. */
const FIRST = 1024;

type March = (...args: (number | bigint)[]) => void;
type Rows = (rows: bigint, states: number, values: number, results: number, work: number) => void;

/** What a march leaves of one motion. */
export interface Marched {
  /** Rows of the march's dimension: as many as there are samples. */
  states: Float64Array;
  moments: Float64Array;
  count: number;
  outcome: number;
  ended: number;
  steps: number;
}

/** Calls of a module; each uses the whole memory anew. */
export class Module {
  private at = FIRST;

  private constructor(
    readonly model: PageModel,
    readonly tables: WasmTables,
    private readonly memory: WebAssembly.Memory,
    private readonly functions: WebAssembly.Exports,
  ) {}

  static async create(model: PageModel): Promise<Module> {
    if (model.wasm === null || model.wasm_tables === null) {
      throw new Error(`${model.title}: this page cannot compute`);
    }
    const memory = new WebAssembly.Memory({ initial: 16 });
    const source = await WebAssembly.instantiate(await inflated(model.wasm), { env: { memory } });
    return new Module(model, model.wasm_tables, memory, source.instance.exports);
  }

  /** The parameters of the system in order, the given ones replacing the defaults. */
  parameters(values: Values): Float64Array {
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
  march(
    table: MarchTable,
    starts: Numbers,
    parameters: Numbers,
    times: Numbers,
    wanted: number,
    tolerance: number,
  ): Marched[] {
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
    const march = this.functions[table.name] as March;
    march(
      ...[0n, BigInt(motions), from, values, stride, moments, BigInt(wanted), tolerance, MOST_STEPS],
      ...[states, found, counts, outcome, ended, taken, work],
    );
    return Array.from({ length: motions }, (_, k) => {
      const count = Number(this.whole(counts, motions)[k]);
      const size = wanted * table.dimension;
      return {
        states: this.doubles(states + 8 * k * size, count * table.dimension).slice(),
        moments: this.doubles(found + 8 * k * wanted, count).slice(),
        count,
        outcome: Number(this.whole(outcome, motions)[k]),
        ended: this.doubles(ended, motions)[k]!,
        steps: Number(this.whole(taken, motions)[k]),
      };
    });
  }

  /** A group of formulas at rows of numbers. */
  values(table: ValuesTable, rows: Numbers, parameters: Numbers): Float64Array {
    const count = rows.length / table.inputs;
    this.at = FIRST;
    const from = this.put(rows);
    const values = this.put(parameters);
    const results = this.room(count * table.outputs);
    const work = this.room(table.work);
    (this.functions[table.name] as Rows)(BigInt(count), from, values, results, work);
    return this.doubles(results, count * table.outputs).slice();
  }

  private put(numbers: Numbers): number {
    const place = this.room(Math.max(numbers.length, 1));
    this.doubles(place, numbers.length).set(numbers);
    return place;
  }

  /** The address of room for some doubles. */
  private room(count: number): number {
    const place = this.at;
    // vectors of two lie at even places
    this.at += 16 * Math.ceil(count / 2);
    const missing = this.at - this.memory.buffer.byteLength;
    if (missing > 0) this.memory.grow(Math.ceil(missing / PAGE));
    return place;
  }

  private doubles(place: number, count: number): Float64Array {
    return new Float64Array(this.memory.buffer, place, count);
  }

  private whole(place: number, count: number): BigInt64Array {
    return new BigInt64Array(this.memory.buffer, place, count);
  }
}
