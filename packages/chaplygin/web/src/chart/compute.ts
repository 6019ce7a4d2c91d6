/** Cells of a chart, computed by as many workers as there are processors to spare. */

import type { Engine, State } from "../engine/engine";
import type { PageModel } from "../model";
import type { Experiment } from "../page/experiment";
import { nearestState, type Orbit, type SectionSetting } from "../section/orbits";
import { workerCount, workerEngine, type WorkerEngine } from "../sources/workers";
import { coarseFirst, middle, type Cell } from "./grid";
import { anglesAbout, rotationNumber } from "./rotation_number";

/** What a chart shows: over two parameters or start inputs, or over the points of a section. */
export interface ChartSetting {
  kind: "megno" | "lyapunov" | "rotation";
  /** Names of start inputs or parameters; null for points of the section. */
  x: string | null;
  y: string | null;
  xRange: [number, number];
  yRange: [number, number];
  size: number;
  until: number;
}

/** Where a chart is computed from. */
export interface ChartGround {
  model: PageModel;
  experiment: Experiment;
  /** The state of the motion in the scene. */
  reference: Float64Array;
  section: SectionSetting | null;
  /** Orbits of the section: from their points the way to others is shortest. */
  orbits: Orbit[];
}

/** States found for cells this coarse help to find those of finer ones. */
const HELPFUL = 4;

/** Cells that a worker is given at a time: first, and at most; later ones take about so many milliseconds. */
const [TILE, LARGEST_TILE, TILE_TIME] = [8, 64, 200];

/** The experiment of a cell; a message where it has none. */
export async function cellStart(engine: Engine, ground: ChartGround, setting: ChartSetting, x: number, y: number): Promise<{ experiment: Experiment; state: Float64Array } | { message: string }> {
  const { model, experiment, reference, section } = ground;
  if (setting.x === null || setting.y === null) {
    if (section === null) return { message: "There is no section." };
    const { on, value, direction } = section;
    const { xRange, yRange } = setting;
    const near = nearestState(ground.orbits, model.reduced, { x, y }, xRange[1] - xRange[0], yRange[1] - yRange[0]);
    const task = { parameters: experiment.parameters, reference: near ?? reference, section: { on, value, direction, x: section.x, y: section.y }, x, y };
    const found = await engine.startOnLevel(task);
    return "message" in found ? found : { experiment: { ...experiment, start: { state: Array.from(found.state) } }, state: found.state };
  }
  const given: [string, number][] = [[setting.x, x], [setting.y, y]];
  const inputs = given.filter(([name]) => model.start_inputs.some((input) => input.name === name));
  const parameters = { ...experiment.parameters, ...Object.fromEntries(given.filter((each) => !inputs.includes(each))) };
  const { start } = experiment;
  const next: Experiment["start"] = "state" in start && inputs.length === 0 ? start : { inputs: { ...("inputs" in start ? start.inputs : {}), ...Object.fromEntries(inputs) } };
  const state: State = "state" in next ? { state: Float64Array.from(next.state) } : await engine.startFrom({ parameters, inputs: next.inputs });
  return "message" in state ? state : { experiment: { ...experiment, parameters, start: next }, state: state.state };
}

/** The values of cells; not a number where there is none. */
export async function cellValues(engine: Engine, ground: ChartGround, setting: ChartSetting, places: readonly [number, number][], helpful = false): Promise<number[]> {
  const starts = await Promise.all(places.map(([x, y]) => cellStart(engine, ground, setting, x, y)));
  if (helpful && setting.x === null) ground.orbits.push(...starts.flatMap((start, k) => ("message" in start ? [] : [pointOf(start.state, places[k] ?? [0, 0], ground.model)])));
  const { kind, until } = setting;
  if (kind === "rotation") return Promise.all(starts.map((start) => cellRotation(engine, ground, setting, start)));
  const found = starts.map((start, k) => ("message" in start ? -1 : k)).filter((k) => k >= 0);
  const motions = found.map((k) => {
    const { experiment, state } = starts[k] as { experiment: Experiment; state: Float64Array };
    return { parameters: experiment.parameters, start: state };
  });
  const values = await engine.indicators({ motions, until, kind });
  const result = starts.map(() => NaN);
  found.forEach((k, j) => (result[k] = values[j] ?? NaN));
  return result;
}

/** A state that was found, as an orbit of one point. */
function pointOf(state: Float64Array, [x, y]: readonly [number, number], { reduced }: PageModel): Orbit {
  return { start: state, x: Float64Array.of(x), y: Float64Array.of(y), rows: state.slice(0, reduced), number: 0, until: 0, indicator: null };
}

async function cellRotation(engine: Engine, ground: ChartGround, setting: ChartSetting, start: Awaited<ReturnType<typeof cellStart>>): Promise<number> {
  if ("message" in start) return NaN;
  const { parameters } = start.experiment;
  const { section, model } = ground;
  if (section === null) return NaN;
  const [across, up] = [section.x, section.y].map((name) => model.quantities.findIndex((quantity) => quantity.name === name));
  const { rows, dimension } = await engine.section({ parameters, start: start.state, on: section.on, value: section.value, direction: section.direction, points: 300, until: setting.until });
  if (rows.length === 0) return NaN;
  const values = await engine.quantities(parameters, rows, dimension);
  const width = model.quantities.length;
  const column = (index: number | undefined): Float64Array => Float64Array.from({ length: values.length / width }, (_, k) => values[k * width + (index ?? 0)] ?? NaN);
  const isAngle = model.quantities[across ?? -1]?.angle === true;
  return rotationNumber(isAngle ? column(across) : anglesAbout(column(across), column(up)));
}

/** A chart being computed. */
export interface ChartRun {
  values: Float64Array;
  /** Settled when all cells are done, or the run was stopped. */
  done: Promise<void>;
  stop(): void;
}

/** Compute a chart; `progress` hears of each tile. */
export function chartRun(ground: ChartGround, setting: ChartSetting, progress: (cells: readonly Cell[], share: number) => void): ChartRun {
  const { size } = setting;
  const values = new Float64Array(size * size).fill(NaN);
  const cells = coarseFirst(size);
  const workers: WorkerEngine[] = Array.from({ length: workerCount() }, () => workerEngine(ground.model));
  let next = 0;
  let finished = 0;
  let stopped = false;
  const work = async ({ engine }: WorkerEngine): Promise<void> => {
    let count = TILE;
    while (!stopped && next < cells.length) {
      const began = performance.now();
      const tile = cells.slice(next, next + count);
      next += tile.length;
      const places = tile.map(({ column, row }): [number, number] => [middle(setting.xRange, column, size), middle(setting.yRange, row, size)]);
      const found = await cellValues(engine, ground, setting, places, (tile[0]?.side ?? 1) >= HELPFUL).catch(() => tile.map(() => NaN));
      if (stopped) return;
      tile.forEach(({ column, row }, k) => (values[row * size + column] = found[k] ?? NaN));
      finished += tile.length;
      const fitting = Math.round((tile.length * TILE_TIME) / Math.max(1, performance.now() - began));
      count = Math.min(LARGEST_TILE, Math.max(TILE, fitting));
      progress(tile, finished / cells.length);
    }
  };
  const stop = (): void => {
    stopped = true;
    for (const worker of workers) worker.end();
  };
  return { values, done: Promise.all(workers.map(work)).then(stop, stop), stop };
}
