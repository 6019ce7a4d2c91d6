/** Orbits of a section: their points, and which of them is near a place. */

import type { Engine, SectionPoints, Values } from "../engine/engine";
import type { PageModel } from "../model";

/** What a section shows. */
export interface SectionSetting {
  on: string;
  value: number;
  direction: -1 | 0 | 1;
  x: string;
  y: string;
}

/** Points of one motion. */
export interface Orbit {
  /** The whole state from which it starts. */
  start: Float64Array;
  x: Float64Array;
  y: Float64Array;
  /** Number of the orbit since the section was cleared; gives its colour. */
  number: number;
  /** The reduced states of its points, row by row, after those that were given by their place alone. */
  rows: Float64Array;
  /** Time of its last point. */
  until: number;
  /** MEGNO, once it is known. */
  indicator: number | null;
}

/** Points of the first piece; later ones take about so many milliseconds. */
const FIRST_PIECE = 250;
const PIECE_TIME = 60;

/** Some points of a section, in order. */
export interface Piece {
  x: Float64Array;
  y: Float64Array;
  rows: Float64Array;
  time: number;
  /** Why no more follow, where they do not. */
  end: string | null;
}

/** The index of a quantity by its name. */
export function quantityIndex(model: PageModel, name: string): number {
  return model.quantities.findIndex((quantity) => quantity.name === name);
}

/** The points of a section from a start, in pieces as they come. */
export async function* sectionPieces(
  engine: Engine,
  model: PageModel,
  parameters: Values,
  setting: SectionSetting,
  start: Float64Array,
  points: number,
  longest: number,
): AsyncGenerator<Piece> {
  const [ix, iy] = [quantityIndex(model, setting.x), quantityIndex(model, setting.y)];
  const width = model.quantities.length;
  const { on, value, direction } = setting;
  const next = (from: Float64Array, time: number, wanted: number): Promise<SectionPoints> => {
    const part = engine.section({ parameters, start: from, on, value, direction, points: wanted, until: longest - time });
    // whoever has seen enough does not wait for it
    part.catch(() => undefined);
    return part;
  };
  let time = 0;
  let began = performance.now();
  let coming: Promise<SectionPoints> | null = next(start, time, Math.min(FIRST_PIECE, points));
  for (let done = 0; coming !== null; ) {
    const { rows, times, dimension, end }: SectionPoints = await coming;
    coming = null;
    const count = rows.length / dimension;
    done += count;
    if (count === 0) {
      yield { x: new Float64Array(0), y: new Float64Array(0), rows, time, end: end?.reason ?? "it does not cross the section" };
      return;
    }
    time += times.at(-1) ?? 0;
    const asked = engine.quantities(parameters, rows, dimension);
    if (end === null && done < points) {
      // computed while this page shows what there is
      const now = performance.now();
      const piece = Math.round(Math.min(5000, Math.max(50, (count * PIECE_TIME) / Math.max(1, now - began))));
      began = now;
      coming = next(rows.slice((count - 1) * dimension), time, Math.min(piece, points - done));
    }
    const values = await asked;
    yield { x: column(values, width, ix, model), y: column(values, width, iy, model), rows, time, end: end?.reason ?? null };
  }
}

function column(values: Float64Array, width: number, index: number, model: PageModel): Float64Array {
  const angle = model.quantities[index]?.angle === true;
  return Float64Array.from({ length: values.length / width }, (_, k) => {
    const value = values[k * width + index] ?? NaN;
    return angle ? wrapped(value) : value;
  });
}

/** An angle between −π and π. */
export function wrapped(angle: number): number {
  const turns = Math.round(angle / (2 * Math.PI));
  return angle - 2 * Math.PI * turns;
}

/** How often a quantity along a motion passes a value in a direction; 0 is both. */
export function crossings(values: ArrayLike<number>, value: number, direction: -1 | 0 | 1, angle: boolean): number {
  let count = 0;
  for (let k = 1; k < values.length; k++) {
    const before = (values[k - 1] ?? NaN) - value;
    const after = (values[k] ?? NaN) - value;
    // an angle passes a value at every turn
    const turns = angle ? Math.floor(after / (2 * Math.PI)) - Math.floor(before / (2 * Math.PI)) : 0;
    const sign = angle ? Math.sign(turns) : before < 0 && after >= 0 ? 1 : before > 0 && after <= 0 ? -1 : 0;
    if (sign !== 0 && (direction === 0 || direction === sign)) count += angle ? Math.abs(turns) : 1;
  }
  return count;
}

/** A round number near the middle of the values that a quantity takes. */
export function middleOf(values: ArrayLike<number>): number {
  let [low, high] = [Infinity, -Infinity];
  for (let k = 0; k < values.length; k++) {
    const value = values[k] ?? NaN;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (!(high > low)) return low === Infinity ? 0 : low;
  const step = 10 ** Math.floor(Math.log10((high - low) / 2));
  return Number((Math.round((low + high) / 2 / step) * step).toPrecision(6));
}

/** The orbit with a point nearest to a place, if one is within a distance; all in units of the picture. */
export function nearest(
  orbits: readonly Orbit[],
  right: (x: number) => number,
  down: (y: number) => number,
  place: { right: number; down: number },
  within: number,
): { orbit: Orbit; index: number } | null {
  let best: { orbit: Orbit; index: number } | null = null;
  let least = within * within;
  for (const orbit of orbits) {
    for (let k = 0; k < orbit.x.length; k++) {
      const a = right(orbit.x[k] ?? NaN) - place.right;
      const b = down(orbit.y[k] ?? NaN) - place.down;
      const far = a * a + b * b;
      if (far < least) [least, best] = [far, { orbit, index: k }];
    }
  }
  return best;
}

/** An orbit with more points. */
export function longer(orbit: Orbit, piece: Pick<Piece, "x" | "y" | "rows" | "time">): Orbit {
  return { ...orbit, x: joined(orbit.x, piece.x), y: joined(orbit.y, piece.y), rows: joined(orbit.rows, piece.rows), until: piece.time };
}

/** The reduced state of the computed point nearest to a place, in units of the ranges; null without any. */
export function nearestState(orbits: readonly Orbit[], dimension: number, place: { x: number; y: number }, width: number, height: number): Float64Array | null {
  let best: Float64Array | null = null;
  let least = Infinity;
  for (const { x, y, rows } of orbits) {
    const count = rows.length / dimension;
    const skipped = x.length - count;
    for (let k = 0; k < count; k++) {
      const far = Math.hypot(((x[skipped + k] ?? NaN) - place.x) / width, ((y[skipped + k] ?? NaN) - place.y) / height);
      if (far < least) {
        least = far;
        best = rows.subarray(k * dimension, (k + 1) * dimension);
      }
    }
  }
  return best;
}

function joined(a: Float64Array, b: Float64Array): Float64Array {
  const both = new Float64Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}
