/** The engine of a page: what computes motions, whether in the page or elsewhere. */

import type { Surfaces } from "./surfaces.js";

/** Values by name; parameters that are left out keep their defaults. */
export type Values = Readonly<Record<string, number>>;

export type Numbers = ArrayLike<number>;

/** A motion through given times, ended early where `end` says so. */
export interface Motion {
  times: Float64Array;
  /** By the dataset's names; row by row. */
  columns: Record<string, Float64Array>;
  /** Whole states, row by row. */
  states: Float64Array;
  end: { time: number; reason: string } | null;
}

export interface MotionTask {
  parameters: Values;
  /** A whole state. */
  start: Numbers;
  /** Increasing from 0 or later. */
  times: Numbers;
}

export interface SectionTask {
  parameters: Values;
  /** A reduced or whole state. */
  start: Numbers;
  /** Name of a quantity. */
  on: string;
  value?: number;
  direction: -1 | 0 | 1;
  points: number;
  /** Time after which the motion is given up. */
  until?: number;
}

export interface SectionPoints {
  /** Reduced states, row by row. */
  rows: Float64Array;
  times: Float64Array;
  /** Numbers of a row. */
  dimension: number;
  end: { time: number; reason: string } | null;
}

export interface IndicatorTask {
  parameters: Values;
  start: Numbers;
  until: number;
  kind: "megno" | "lyapunov";
}

/** Motions that are computed side by side, which costs less than one after another. */
export interface IndicatorsTask {
  motions: { parameters: Values; start: Numbers }[];
  until: number;
  kind: "megno" | "lyapunov";
}

/** A state, or why there is none, in one sentence. */
export type State = { state: Float64Array } | { message: string; nearest?: Float64Array };

export interface StartTask {
  parameters: Values;
  /** Start inputs that replace those of the model. */
  inputs: Values;
}

export interface LevelTask {
  parameters: Values;
  /** A reduced or whole state whose integrals have the values of the level. */
  reference: Numbers;
  /** With `on` null, any state with these values of x and y. */
  section: { on: string | null; value?: number; direction: -1 | 0 | 1; x: string; y: string };
  x: number;
  y: number;
}

/** All methods may compute elsewhere and so give promises. */
export interface Engine {
  motion(task: MotionTask): Promise<Motion>;
  section(task: SectionTask): Promise<SectionPoints>;
  /** Quantities (by the model's order) at states, row by row. */
  quantities(parameters: Values, rows: Float64Array, dimension: number): Promise<Float64Array>;
  /** MEGNO, or the largest Lyapunov exponent; not a number where the motion ends before. */
  indicator(task: IndicatorTask): Promise<number>;
  /** The same of several motions. */
  indicators(task: IndicatorsTask): Promise<Float64Array>;
  startFrom(task: StartTask): Promise<State>;
  startOnLevel(task: LevelTask): Promise<State>;
  /** What is drawn of the body and of what carries it, for these parameters. */
  surfaces(parameters: Values): Promise<Surfaces>;
}
