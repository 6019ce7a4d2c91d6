/** Quantities over time: which there are, and their values. */

import type { Column, PageModel } from "../model";
import { plain } from "../page/mathml";
import { unitText } from "../page/units";
import type { Motion } from "../playback/motion";

/** A recorded column with one curve a component. */
export interface SeriesGroup {
  name: string;
  mathml: string;
  /** The letters alone. */
  text: string;
  meaning: string;
  unit: string;
  components: { label: string; values: Float64Array }[];
}

const AXES: Record<string, readonly string[]> = {
  body: ["1", "2", "3"],
  space: ["x", "y", "z"],
  quaternion: ["w", "x", "y", "z"],
};

/** All recorded columns of a motion that can be drawn. */
export function seriesGroups(model: PageModel, motion: Motion): SeriesGroup[] {
  return model.columns.flatMap((column) => {
    const values = motion.columns[column.name];
    // places of a drawing in the plane are seen in the scene
    if (values === undefined || column.axes === "plane") return [];
    const isLaw = column.name.startsWith("law_");
    const name = (isLaw ? column.name.slice(4) : column.name).replaceAll("_", " ");
    const text = isLaw ? `drift of ${name}` : letter(column.mathml) ?? name;
    const names = indicesOf(column);
    const components = Array.from({ length: column.width }, (_, k) => ({
      label: column.width === 1 ? text : `${text}${lowered(names[k] ?? String(k + 1))}`,
      values: isLaw ? values.map((value) => value - (values[0] ?? 0)) : component(values, column.width, k),
    }));
    return [{ ...column, text, unit: unitText(column.unit), components }];
  });
}

/** The indices of the components; pairs of them for skew matrices and rotations. */
function indicesOf({ name, axes, width }: Column): readonly string[] {
  const known = AXES[axes];
  if (known !== undefined) return known;
  if (axes === "pair") {
    const size = (1 + Math.round(Math.sqrt(1 + 8 * width))) / 2;
    return pairs(size).filter(([i, j]) => i < j).map(([i, j]) => `${i}${j}`);
  }
  return name === "attitude" ? pairs(Math.round(Math.sqrt(width))).map(([i, j]) => `${i}${j}`) : [];
}

function pairs(size: number): [number, number][] {
  const numbers = Array.from({ length: size }, (_, k) => k + 1);
  return numbers.flatMap((i) => numbers.map((j): [number, number] => [i, j]));
}

/** The formula of a column as text where it is a letter, not a name. */
function letter(mathml: string): string | null {
  const text = plain(mathml);
  return text !== "" && text.length <= 4 ? text : null;
}

function component(values: Float64Array, width: number, index: number): Float64Array {
  return width === 1 ? values : Float64Array.from({ length: values.length / width }, (_, k) => values[width * k + index] ?? NaN);
}

const LOWERED = "₀₁₂₃₄₅₆₇₈₉";

function lowered(name: string): string {
  return /^[0-9]+$/.test(name) ? [...name].map((digit) => LOWERED[Number(digit)]).join("") : `_${name}`;
}
