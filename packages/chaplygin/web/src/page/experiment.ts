/** What is computed: parameters, start, duration; and its way into the address of the page. */

import type { Numbers, Values } from "../engine/engine";
import type { PageModel } from "../model";

/** A start by the inputs that a reader turns, or by a whole state. */
export type Start = { inputs: Values } | { state: number[] };

/** Parameters and inputs that are left out have the values of the model. */
export interface Experiment {
  parameters: Values;
  start: Start;
  until: number;
}

/** The experiment with which a model opens. */
export function opening(model: PageModel): Experiment {
  return { parameters: {}, start: { inputs: {} }, until: model.until };
}

/** Whether two experiments are the same. */
export function same(a: Experiment, b: Experiment): boolean {
  return JSON.stringify(ordered(a)) === JSON.stringify(ordered(b));
}

function ordered({ parameters, start, until }: Experiment): unknown {
  const sorted = (values: Values): [string, number][] => Object.entries(values).sort(([x], [y]) => (x < y ? -1 : 1));
  return [sorted(parameters), "state" in start ? start.state : sorted(start.inputs), until];
}

/** Equally spaced instants from 0 to `until`. */
export function instants(until: number, samples: number): Float64Array {
  return Float64Array.from({ length: samples }, (_, k) => (until * k) / Math.max(1, samples - 1));
}

/** An experiment, an instant and further choices, as the fragment of an address. */
export function toFragment(experiment: Experiment, model: PageModel, choices: Record<string, string>): string {
  const parts = new URLSearchParams();
  for (const [name, value] of Object.entries(experiment.parameters)) parts.set(`p.${name}`, String(value));
  if ("state" in experiment.start) parts.set("state", experiment.start.state.join(" "));
  else for (const [name, value] of Object.entries(experiment.start.inputs)) parts.set(`s.${name}`, String(value));
  if (experiment.until !== model.until) parts.set("until", String(experiment.until));
  for (const [name, value] of Object.entries(choices)) parts.set(name, value);
  const text = parts.toString();
  return text === "" ? "" : `#lab&${text}`;
}

/** The experiment and the choices of a fragment; null where it holds none of this model. */
export function fromFragment(
  fragment: string,
  model: PageModel,
): { experiment: Experiment; choices: Record<string, string> } | null {
  if (!fragment.startsWith("#lab&")) return null;
  const experiment = { parameters: {} as Record<string, number>, inputs: {} as Record<string, number> };
  let state: number[] | null = null;
  let until = model.until;
  const choices: Record<string, string> = {};
  for (const [key, text] of new URLSearchParams(fragment.slice(5))) {
    const value = Number(text);
    const name = key.slice(2);
    if (key.startsWith("p.")) {
      if (!Number.isFinite(value) || !model.parameters.some((p) => p.name === name)) return null;
      experiment.parameters[name] = value;
    } else if (key.startsWith("s.")) {
      if (!Number.isFinite(value) || !model.start_inputs.some((input) => input.name === name)) return null;
      experiment.inputs[name] = value;
    } else if (key === "state") {
      state = text.split(/[ +]/).map(Number);
      if (state.length !== model.state.length || !state.every(Number.isFinite)) return null;
    } else if (key === "until") {
      if (!(value > 0) || !Number.isFinite(value)) return null;
      until = value;
    } else choices[key] = text;
  }
  const start: Start = state === null ? { inputs: experiment.inputs } : { state };
  return { experiment: { parameters: experiment.parameters, start, until }, choices };
}

/** Values with one of them changed; one that is again that of the model is left out. */
export function changed(values: Values, name: string, value: number, usual: number): Values {
  const { [name]: _, ...others } = values;
  return value === usual ? others : { ...others, [name]: value };
}

/** States as plain numbers. */
export function numbers(values: Numbers): number[] {
  return Array.from(values);
}

/** States of the past and of the future, to go back to. */
export class History<T> {
  private past: T[] = [];
  private future: T[] = [];

  constructor(private readonly longest = 200) {}

  /** Remember what is about to be replaced. */
  push(value: T): void {
    this.past.push(value);
    if (this.past.length > this.longest) this.past.shift();
    this.future = [];
  }

  /** The one before, for the one of now; undefined where there is none. */
  undo(now: T): T | undefined {
    const before = this.past.pop();
    if (before !== undefined) this.future.push(now);
    return before;
  }

  /** The one that was undone last, for the one of now. */
  redo(now: T): T | undefined {
    const after = this.future.pop();
    if (after !== undefined) this.past.push(now);
    return after;
  }

  get canUndo(): boolean {
    return this.past.length > 0;
  }

  get canRedo(): boolean {
    return this.future.length > 0;
  }
}
