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
