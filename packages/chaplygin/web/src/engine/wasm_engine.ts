/** The engine that computes in the page, by the module of its model. */

import type { PageModel } from "../model.js";
import type {
  Engine,
  IndicatorTask,
  IndicatorsTask,
  LevelTask,
  Motion,
  MotionTask,
  Numbers,
  SectionPoints,
  SectionTask,
  StartTask,
  State,
  Values,
} from "./engine.js";
import { indicators } from "./indicator.js";
import { Module, type Marched } from "./module.js";
import { restoreRelations, startFrom, startOnLevel } from "./start.js";
import { DrawnSurfaces, type Surfaces } from "./surfaces.js";

/** Stretches of a motion, after each of which its state is put on the relations again. */
const STRETCHES = 20;

export class WasmEngine implements Engine {
  private drawn: DrawnSurfaces | null = null;

  private constructor(
    private readonly model: PageModel,
    private readonly module: Module,
  ) {}

  static async create(model: PageModel): Promise<WasmEngine> {
    return new WasmEngine(model, await Module.create(model));
  }

  async motion({ parameters, start, times }: MotionTask): Promise<Motion> {
    const { model, module } = this;
    const values = module.parameters(parameters);
    const marched = this.states(start, values, times);
    const { count, states } = marched;
    const numbers = module.values(module.tables.columns, states, values);
    const width = module.tables.columns.outputs;
    const columns: Record<string, Float64Array> = {};
    let first = 0;
    for (const column of model.columns) {
      const part = new Float64Array(count * column.width);
      for (let i = 0; i < count; i++) {
        for (let k = 0; k < column.width; k++) {
          part[i * column.width + k] = numbers[i * width + first + k]!;
        }
      }
      columns[column.name] = part;
      first += column.width;
    }
    const moments = Float64Array.from({ length: count }, (_, i) => model.direction * times[i]!);
    return { times: moments, columns, states, end: this.end(marched) };
  }

  /** Whole states at times, in stretches after which the relations hold but for rounding. */
  private states(start: Numbers, values: Float64Array, times: Numbers): Pick<Marched, "states" | "count" | "outcome" | "ended"> {
    const { model, module } = this;
    const table = module.tables.motion;
    const size = table.dimension;
    const states = new Float64Array(times.length * size);
    const piece = Math.ceil(times.length / STRETCHES);
    let state: Numbers = start;
    let [count, began] = [0, 0];
    while (count < times.length) {
      const wanted = Math.min(piece, times.length - count);
      const moments = Array.from({ length: wanted }, (_, i) => times[count + i]! - began);
      const [run] = module.march(table, state, values, moments, wanted, model.tolerance);
      states.set(run!.states, count * size);
      count += run!.count;
      if (run!.outcome !== 0) return { states: states.slice(0, count * size), count, outcome: run!.outcome, ended: began + run!.ended };
      const last = states.subarray((count - 1) * size, count * size);
      const now = times[count - 1]!;
      // the start itself stays as it was given
      if (now !== began) restoreRelations(module, last, values);
      [state, began] = [last, now];
    }
    return { states, count, outcome: 0, ended: began };
  }

  async section(task: SectionTask): Promise<SectionPoints> {
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
    const { states, moments } = marched!;
    const times = moments.map((t) => model.direction * t);
    return { rows: states, times, dimension: section.dimension, end: this.end(marched!) };
  }

  async quantities(
    parameters: Values,
    rows: Float64Array,
    dimension: number,
  ): Promise<Float64Array> {
    const { module } = this;
    const table = module.tables.quantities;
    return module.values(table, firstColumns(rows, dimension, table.inputs), module.parameters(parameters));
  }

  async indicator(task: IndicatorTask): Promise<number> {
    const { parameters, start, until, kind } = task;
    const [value] = indicators(this.module, { motions: [{ parameters, start }], until, kind });
    return value!;
  }

  async indicators(task: IndicatorsTask): Promise<Float64Array> {
    return indicators(this.module, task);
  }

  async startFrom(task: StartTask): Promise<State> {
    return startFrom(this.module, task);
  }

  async startOnLevel(task: LevelTask): Promise<State> {
    return startOnLevel(this.module, task);
  }

  async surfaces(parameters: Values): Promise<Surfaces> {
    this.drawn ??= new DrawnSurfaces(this.module);
    return this.drawn.at(parameters);
  }

  private end({ outcome, ended }: Pick<Marched, "outcome" | "ended">): Motion["end"] {
    if (outcome === 0) return null;
    const reason = this.module.tables.reasons[outcome] ?? `outcome ${outcome}`;
    return { time: this.model.direction * ended, reason };
  }
}

/** The first numbers of each row. */
function firstColumns(rows: Float64Array, dimension: number, width: number): Float64Array {
  if (dimension === width) return rows;
  const count = rows.length / dimension;
  const result = new Float64Array(count * width);
  for (let i = 0; i < count; i++) {
    result.set(rows.subarray(i * dimension, i * dimension + width), i * width);
  }
  return result;
}
