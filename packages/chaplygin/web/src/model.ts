/** The page model: all that a page knows of a system, as JSON. Arrays are flat, row by row. */

/** Base64 of little-endian doubles, floats or integers; `doubles` and the others read them. */
export type Doubles = string;
export type Floats = string;
export type Integers = string;

/** A number of the state. */
export interface StateVariable {
  name: string;
  mathml: string;
  unit: string;
  meaning: string;
  /** Whether its values count up to whole turns. */
  angle: boolean;
}

/** A parameter; `low` and `high` bound a slider, null where nothing is known. */
export interface Parameter {
  name: string;
  mathml: string;
  meaning: string;
  unit: string;
  value: number;
  low: number | null;
  high: number | null;
}

/** A number that a user may turn to give the start, such as a component of ω. */
export interface StartInput {
  name: string;
  mathml: string;
  unit: string;
  meaning: string;
  value: number;
  low: number;
  high: number;
}

/** A recorded quantity, by its name in a dataset. */
export interface Column {
  name: string;
  /** Components; 1 for a scalar. */
  width: number;
  /** "body", "space", "quaternion", another dimension's name, or "" for a scalar. */
  axes: string;
  unit: string;
  meaning: string;
  mathml: string;
}

/** A law claimed of the system; an integral has a column with its values. */
export interface Law {
  name: string;
  meaning: string;
  unit: string;
  column: string | null;
  mathml: string;
  /** "proven", "proven where …", "refuted", "undecided" or "not tried". */
  verdict: string;
  source: string;
  /** The verdict with its reason. */
  text: string;
}

/** A scalar for sections, charts and plots: a component of the state, an observable, an integral. */
export interface Quantity {
  name: string;
  mathml: string;
  unit: string;
  meaning: string;
  /** As the command line takes it. */
  formula: string;
  /** Whether its values count up to whole turns. */
  angle: boolean;
}

/** A condition that must stay positive, and what has happened when it is not. */
export interface Guard {
  message: string;
}

/** The section that a page opens with. */
export interface SectionChoice {
  on: string;
  value: number;
  direction: -1 | 0 | 1;
  x: string;
  y: string;
}

/** A curve or region of a bifurcation diagram, in values of two integrals. */
export interface BifurcationCurve {
  label: string;
  /** Whether the motions on it are stable. */
  stable: boolean;
  x: number[];
  y: number[];
}

export interface Bifurcation {
  x: string;
  y: string;
  curves: BifurcationCurve[];
}

/**
 * A convex body over a grid of directions γ, in body axes, its centre of mass at the origin: the
 * point r(γ) of its surface, whose outward normal is −γ (+γ where it is hollow).
 */
export interface Body {
  /** Angles of γ from body axis 3, and about it (the azimuth goes round once). */
  theta: number[];
  phi: number[];
  /** theta.length × phi.length points. */
  positions: Floats;
  /** A shell that rolls with its inner side. */
  hollow: boolean;
  /** By how much each side of a flat body was moved outwards along axis 3. */
  thickness: number;
}

/** What carries the body. */
export type Surface =
  | { kind: "plane" }
  /** A sphere about the origin, below the body, or around it where `inside`. */
  | { kind: "sphere"; radius: number; inside: boolean }
  | { kind: "mesh"; positions: Floats; normals: Floats; indices: Integers }
  /** Nothing: a body about a fixed point. */
  | { kind: "point" };

/** A part of a mechanism in the plane, its place and heading given by columns of the dataset. */
export interface Link {
  kind: "rod" | "wheel" | "axle" | "blade" | "point";
  /** Column of width 2 (point), 3 (x, y, heading) or 4 (rod: x, y, x, y). */
  column: string;
}

/** A vector drawn in the scene. */
export interface SceneVector {
  name: string;
  /** Column of width 3. */
  column: string;
  axes: "body" | "space";
  /** Where it begins. */
  at: "centre" | "contact";
  unit: string;
  mathml: string;
}

export interface Scene {
  body: Body | null;
  /** Semi-axes of the ellipsoid (x, Ix) = const, the longest of them 1; null if unknown. */
  inertia_axes: [number, number, number] | null;
  /** Quaternion (w, x, y, z) of these axes in the body. */
  inertia_turn: [number, number, number, number];
  support: Surface | null;
  links: Link[];
  /** Column of width 2 with the path of a mechanism in the plane. */
  path: string | null;
  vectors: SceneVector[];
  /** Diameter of what is drawn. */
  size: number;
}

/** A time in which the mode of a contact with friction does not change. */
export interface ModeInterval {
  mode: string;
  begin: number;
  end: number;
}

/** A change of the contact, such as "stick". */
export interface ContactEvent {
  kind: string;
  time: number;
}

/** A trajectory stored in the page. */
export interface Recorded {
  times: Doubles;
  columns: Record<string, Doubles>;
  /** One after the other, from the first sample to the last; none without friction. */
  modes: ModeInterval[];
  events: ContactEvent[];
  end: { time: number; reason: string } | null;
}

/** How a loop of the module is called; see docs/laboratory.md. */
export interface MarchTable {
  name: string;
  /** Numbers of a state, with its deviations. */
  dimension: number;
  deviations: number;
  /** Numbers that it takes as parameters: those of the system, then those that choose a section. */
  parameters: number;
  /** Doubles of memory for its work. */
  work: number;
}

/** How a group of formulas of the module is called. */
export interface ValuesTable {
  name: string;
  inputs: number;
  outputs: number;
  /** Doubles of memory for its work. */
  work: number;
}

export interface WasmTables {
  motion: MarchTable;
  section: MarchTable;
  tangent: MarchTable;
  /** Motions side by side in one call that cost no more than one. */
  lanes: number;
  /** Recorded columns at a whole state, in the order of the model's columns. */
  columns: ValuesTable;
  /** Relations of a whole state, and after them their slopes, row by row. */
  phase_space: ValuesTable;
  /** Quantities at a reduced state, in the order of the model's quantities. */
  quantities: ValuesTable;
  /** Relations, integrals, quantities at a reduced state, and after them their slopes. */
  conditions: ValuesTable;
  /** Relations and integrals at a reduced state, and after them their slopes. */
  invariants: ValuesTable;
  /** Time derivatives of a reduced state. */
  rates: ValuesTable;
  /** Guards at a reduced state. */
  guards: ValuesTable;
  /** Positive where the parameters are admissible. */
  admissible: ValuesTable;
  conditions_on_parameters: { parameter: string; condition: string }[];
  /** From the start inputs to a whole state, what must vanish, and the nearest inputs. */
  start: ValuesTable | null;
  /** For each number that must vanish, what to say: with {excess} and {nearest}. */
  excess: { message: string; among: number[] }[];
  /** What to say of a start at which formulas have no value. */
  singular: string;
  /** Vectors that a start makes unit vectors: their places in the whole state. */
  directions: { name: string; places: number[] }[];
  /** Relations of the whole state as text. */
  relation_texts: string[];
  /** What to say of a start that a guard forbids. */
  start_messages: string[];
  /**
   * At reduced states of which only three numbers count: the point of the body with the outward
   * normal −γ, and that of its ellipsoid of inertia; null where no formula gives it.
   */
  contact: ValuesTable | null;
  inertia: ValuesTable | null;
  /** At a place in space: f, ∇f, and the distance of f = 0 from the surface that carries a ball. */
  ground: ValuesTable | null;
  /** Where these three numbers begin in the reduced state. */
  gamma: number;
  /** Quantities on which sections can be taken. */
  section_quantities: string[];
  /** The places of the components of each vector of the reduced state. */
  groups: number[][];
  relations: number;
  whole_relations: number;
  integrals: string[];
  /** Reasons for which a motion ends, by code; those of the guards follow. */
  reasons: string[];
}

export interface PageModel {
  format: 1;
  name: string;
  title: string;
  kind: "rolling" | "ball" | "mechanism" | "system";
  /** The experiment file. */
  experiment: string;
  /** The integrated state: that of the reduced system, then the motion in space. */
  state: StateVariable[];
  /** How many numbers of the state are the reduced system. */
  reduced: number;
  parameters: Parameter[];
  start: number[];
  start_inputs: StartInput[];
  /** −1 where time runs backward; times count from 0 in any case. */
  direction: -1 | 1;
  until: number;
  samples: number;
  /** Error allowed in a step, relative to the size of each vector of the state. */
  tolerance: number;
  section_tolerance: number;
  columns: Column[];
  laws: Law[];
  quantities: Quantity[];
  guards: Guard[];
  section: SectionChoice | null;
  bifurcation: Bifurcation | null;
  scene: Scene;
  recorded: Recorded | null;
  /** The module, deflated (zlib), base64; null where the page cannot compute. */
  wasm: string | null;
  wasm_tables: WasmTables | null;
}
