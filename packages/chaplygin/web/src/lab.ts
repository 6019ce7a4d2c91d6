/** The laboratory of one model: what is computed, what is shown, and how both change. */

import { surfacesOf, type Surfaces } from "./engine/surfaces";
import { doubles } from "./encoding";
import type { Engine, State, Values } from "./engine/engine";
import type { PageModel } from "./model";
import { Cell, latest } from "./page/cell";
import { History, instants, opening, same, type Experiment } from "./page/experiment";
import { Clock, fittingSpeed } from "./playback/clock";
import type { Motion } from "./playback/motion";

/** A motion with what it was computed from. */
export interface Shown {
  experiment: Experiment;
  motion: Motion;
  /** The state at its start; null where only the recorded samples are known. */
  state: Float64Array | null;
  surfaces: Surfaces;
}

/** Everything that panels of the page share. */
export class Lab {
  readonly clock = new Clock();
  readonly shown: Cell<Shown>;
  /** One sentence on what was refused or done; empty if nothing. */
  readonly message = new Cell("");
  readonly refused = new Cell(false);
  readonly history = new History<Experiment>();
  readonly wanted: Cell<Experiment>;
  private readonly compute: (experiment: Experiment) => Promise<Shown | string | undefined>;

  constructor(
    readonly model: PageModel,
    readonly engine: Engine | null,
    first: Shown,
  ) {
    this.shown = new Cell(first);
    this.wanted = new Cell(first.experiment);
    this.compute = latest((experiment) => computed(model, engine, experiment));
    this.clock.until = first.motion.times.at(-1) ?? 0;
    this.clock.speed.value = fittingSpeed(this.clock.until);
  }

  /** Ask for another experiment; `remember` it for undo, which steps of a drag are not. */
  async change(next: Experiment, remember = true): Promise<boolean> {
    if (same(next, this.wanted.value)) return true;
    if (remember) this.history.push(this.wanted.value);
    return this.request(next);
  }

  /** Remember the experiment of now as one to go back to. */
  mark(): void {
    this.history.push(this.wanted.value);
  }

  async undo(): Promise<void> {
    const before = this.history.undo(this.wanted.value);
    if (before !== undefined) await this.request(before);
  }

  async redo(): Promise<void> {
    const after = this.history.redo(this.wanted.value);
    if (after !== undefined) await this.request(after);
  }

  /** Take other parameters; where they forbid the start, from the nearest one that they admit. */
  async changeParameters(parameters: Values): Promise<void> {
    const now = this.wanted.value;
    const inputs = this.givenNumbers(now);
    const answer = inputs === null || this.engine === null ? null : await this.engine.startFrom({ parameters, inputs });
    if (answer === null || !("nearest" in answer) || answer.nearest === undefined) return void this.change({ ...now, parameters }, false);
    const nearest = [...answer.nearest];
    const start = { inputs: Object.fromEntries(this.model.start_inputs.map(({ name }, k) => [name, nearest[k] ?? NaN])) };
    if (await this.change({ ...now, parameters, start }, false)) {
      this.say("With these parameters there is no motion from the start that was given; the nearest admissible one is taken.");
    }
  }

  /** The start inputs of an experiment; null where its state does not tell them. */
  private givenNumbers({ start }: Experiment): Values | null {
    if ("inputs" in start) return start.inputs;
    const { state, start_inputs: inputs } = this.model;
    const places = inputs.map(({ name }) => state.findIndex((each) => each.name === name));
    if (places.some((place) => place < 0)) return null;
    return Object.fromEntries(inputs.map(({ name }, k) => [name, start.state[places[k] ?? 0] ?? NaN]));
  }

  /** Say one sentence. */
  say(sentence: string, refused = false): void {
    this.refused.value = refused;
    this.message.value = sentence;
  }

  private async request(next: Experiment): Promise<boolean> {
    this.wanted.value = next;
    let result: Shown | string | undefined;
    try {
      result = await this.compute(next);
    } catch (why) {
      result = why instanceof Error ? why.message : String(why);
    }
    if (result === undefined) return false;
    if (typeof result === "string") {
      this.say(result, true);
      return false;
    }
    const end = result.motion.end;
    this.say(end === null ? "" : `The motion ends at t = ${end.time.toPrecision(4)}: ${end.reason}.`, end !== null);
    this.clock.until = result.motion.times.at(-1) ?? 0;
    this.shown.value = result;
    return true;
  }
}

/** The motion of an experiment, or one sentence why there is none. */
export async function computed(model: PageModel, engine: Engine | null, experiment: Experiment): Promise<Shown | string> {
  if (engine === null) {
    if (model.recorded === null) return "This page holds no motion and cannot compute one.";
    if (!same(experiment, opening(model))) return "This page shows a recorded motion and cannot compute another.";
    return { experiment, motion: recordedMotion(model), state: Float64Array.from(model.start), surfaces: surfacesOf(model) };
  }
  const start = await startState(engine, experiment);
  if ("message" in start) return start.message;
  const { parameters, until } = experiment;
  const [motion, surfaces] = await Promise.all([
    engine.motion({ parameters, start: start.state, times: instants(until, samplesFor(model, until)) }),
    engine.surfaces(parameters),
  ]);
  return { experiment, motion, state: start.state, surfaces };
}

/** The state from which an experiment starts. */
export async function startState(engine: Engine, experiment: Experiment): Promise<State> {
  const { start, parameters } = experiment;
  return "state" in start ? { state: Float64Array.from(start.state) } : engine.startFrom({ parameters, inputs: start.inputs });
}

/** As many samples as the model says, and more for a longer motion. */
function samplesFor(model: PageModel, until: number): number {
  const wanted = Math.round(((model.samples - 1) * until) / model.until) + 1;
  return Math.min(20_001, Math.max(601, model.samples, wanted));
}

/** The motion that a page holds. */
export function recordedMotion(model: PageModel): Motion {
  const recorded = model.recorded;
  if (recorded === null) return { times: new Float64Array(1), columns: {}, end: null };
  const columns = Object.fromEntries(
    Object.entries(recorded.columns).map(([name, values]) => [name, doubles(values)]),
  );
  return { times: doubles(recorded.times), columns, modes: recorded.modes, events: recorded.events, end: recorded.end };
}

/** An experiment with some of its values replaced. */
export function replaced(experiment: Experiment, parameters: Values, inputs: Values): Experiment {
  const start = "state" in experiment.start && Object.keys(inputs).length === 0
    ? experiment.start
    : { inputs: { ...("inputs" in experiment.start ? experiment.start.inputs : {}), ...inputs } };
  return { ...experiment, parameters: { ...experiment.parameters, ...parameters }, start };
}

