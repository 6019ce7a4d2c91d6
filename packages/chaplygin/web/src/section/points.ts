/** Points of sections: drawn, compared, and a plane through which a motion passes. */

import type { PageModel, Quantity } from "../model";
import { plain } from "../page/mathml";
import { extent } from "../page/numbers";
import type { Frame } from "../sheet/frame";
import { middleOf, quantityIndex, type Orbit, type SectionSetting } from "./orbits";

export function paintPoints(pen: CanvasRenderingContext2D, frame: Frame, orbit: Orbit, from: number, colour: string, ratio: number): void {
  const size = orbit.x.length > 3000 ? 1.2 : 1.8;
  const dot = Math.max(1, Math.round(size * ratio)) / ratio;
  pen.fillStyle = colour;
  for (let k = from; k < orbit.x.length; k++) {
    const [right, down] = [frame.right(orbit.x[k] ?? NaN), frame.down(orbit.y[k] ?? NaN)];
    if (frame.contains(right, down)) pen.fillRect(right - dot / 2, down - dot / 2, dot, dot);
  }
}

/** Rings where orbits that are played begin; of the orbit under the pointer, all points. */
export function paintMarks(pen: CanvasRenderingContext2D, frame: Frame, played: readonly Orbit[], hovered: Orbit | null, ink: string): void {
  const ring = (orbit: Orbit): void => {
    if (orbit.x.length === 0) return;
    pen.beginPath();
    pen.arc(frame.right(orbit.x[0] ?? NaN), frame.down(orbit.y[0] ?? NaN), 5, 0, 2 * Math.PI);
    pen.stroke();
  };
  pen.strokeStyle = pen.fillStyle = ink;
  pen.lineWidth = 1.6;
  played.forEach(ring);
  if (hovered === null) return;
  for (let k = 0; k < hovered.x.length; k++) {
    const [right, down] = [frame.right(hovered.x[k] ?? NaN), frame.down(hovered.y[k] ?? NaN)];
    if (frame.contains(right, down)) pen.fillRect(right - 1, down - 1, 2, 2);
  }
  ring(hovered);
}

/** The plane with another axis in place of one that is constant along an orbit; itself where none is. */
export function spreadPlane(model: PageModel, plane: SectionSetting, orbit: Orbit): SectionSetting {
  const names = model.state.slice(0, model.reduced).map(({ name }) => name);
  for (const axis of ["x", "y"] as const) {
    const values = orbit[axis];
    if (values.length < 3 || varies(values, model.quantities[quantityIndex(model, plane[axis])]?.angle === true)) continue;
    const other = plane[axis === "x" ? "y" : "x"];
    const next = names.find((name, k) => {
      if ([plane.on, other].includes(name) || quantityIndex(model, name) < 0) return false;
      return varies(Float64Array.from({ length: orbit.rows.length / model.reduced }, (_, n) => orbit.rows[n * model.reduced + k] ?? NaN), false);
    });
    if (next !== undefined) return { ...plane, [axis]: next };
  }
  return plane;
}

/** Whether values differ by more than rounding; angles half a turn apart are the same line of a body. */
export function varies(values: Float64Array, angle: boolean): boolean {
  const [low, high] = extent(angle ? values.map((value) => Math.abs(Math.tan(value / 2))) : values, 0);
  return high - low > 1e-6 * Math.max(Math.abs(low), Math.abs(high)) && new Set(values).size > 2;
}

export function along(from: { x: number; y: number }, to: { x: number; y: number }, count: number): { x: number; y: number }[] {
  return Array.from({ length: count }, (_, k) => {
    const share = k / (count - 1);
    return { x: from.x + share * (to.x - from.x), y: from.y + share * (to.y - from.y) };
  });
}

/** The largest size of each variable along an orbit; the components of a vector count together. */
export function sizes(names: readonly string[], orbit: Pick<Orbit, "start" | "rows">): number[] {
  const stem = (name: string): string => name.replace(/_\d+$/, "");
  const largest = new Map<string, number>();
  const count = (values: Float64Array): void =>
    values.forEach((value, n) => {
      const whose = stem(names[n % names.length] ?? "");
      if (Number.isFinite(value)) largest.set(whose, Math.max(largest.get(whose) ?? 0, Math.abs(value)));
    });
  count(orbit.start.slice(0, names.length));
  count(orbit.rows);
  return names.map((name) => largest.get(stem(name)) ?? 0);
}

export function letters(quantity: Quantity): string {
  return quantity.mathml ? plain(quantity.mathml) : quantity.name;
}

export function same(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  if (a.length !== b.length) return false;
  for (let k = 0; k < a.length; k++) if (a[k] !== b[k]) return false;
  return true;
}

export function sentence(words: string): string {
  return words.endsWith(".") ? words : `${words}.`;
}


/** Crossings of a motion that are enough for a section. */
const ENOUGH = 5;

/** The section where the motion passes often: at another value than the chosen one, or on another quantity. */
export function passingPlane(
  model: PageModel,
  chosen: SectionSetting,
  column: (name: string) => Float64Array,
  passes: (on: string, value: number) => number,
): SectionSetting {
  const own = { on: chosen.on, value: chosen.value, count: passes(chosen.on, chosen.value) };
  if (own.count >= ENOUGH) return chosen;
  const names = model.state.slice(0, model.reduced).map(({ name }) => name).filter((name) => quantityIndex(model, name) >= 0);
  const options = [chosen.on, ...names]
    .filter((name) => model.wasm_tables?.section_quantities.includes(name) ?? true)
    .flatMap((on) => [0, middleOf(column(on))].map((value) => ({ on, value, count: passes(on, value) })));
  const best = options.find(({ count }) => count >= ENOUGH) ?? options.reduce((a, b) => (b.count > a.count ? b : a), own);
  let plane = { ...chosen, on: best.on, value: best.value };
  for (const axis of ["x", "y"] as const) {
    if (plane[axis] !== plane.on) continue;
    const other = names.find((name) => ![plane.on, plane.x, plane.y].includes(name));
    if (other !== undefined) plane = { ...plane, [axis]: other };
  }
  return plane;
}
