/** Quantities over time: which there are, and their values. */

import type { PageModel } from "../model";
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
    const names = AXES[column.axes] ?? [];
    const components = Array.from({ length: column.width }, (_, k) => ({
      label: column.width === 1 ? text : `${text}${lowered(names[k] ?? String(k + 1))}`,
      values: isLaw ? values.map((value) => value - (values[0] ?? 0)) : component(values, column.width, k),
    }));
    return [{ ...column, text, unit: unitText(column.unit), components }];
  });
}

/** The formula of a column as text where it is a letter, not a name. */
function letter(mathml: string): string | null {
  const text = plain(mathml);
  return text !== "" && text.length <= 4 ? text : null;
}

function component(values: Float64Array, width: number, index: number): Float64Array {
  return width === 1 ? values : Float64Array.from({ length: values.length / width }, (_, k) => values[width * k + index] ?? NaN);
}

const LOWERED: Record<string, string> = { "1": "₁", "2": "₂", "3": "₃", "4": "₄", "5": "₅", "6": "₆" };

function lowered(name: string): string {
  return LOWERED[name] ?? `_${name}`;
}
