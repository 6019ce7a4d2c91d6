/** The numbers that give a start, whatever it was given by. */

import type { Lab } from "../lab";
import type { PageModel } from "../model";
import { row } from "../playback/motion";

/** The start inputs of the experiment; those of a state are read off the motion where it records them. */
export function startInputs(lab: Lab): Record<string, number> {
  const { start } = lab.wanted.value;
  if ("inputs" in start) return { ...start.inputs };
  const { motion } = lab.shown.value;
  const found: Record<string, number> = {};
  for (const { name } of lab.model.start_inputs) {
    const place = lab.model.state.findIndex((each) => each.name === name);
    const value = place >= 0 ? start.state[place] : recorded(lab, name, motion.times[0] ?? 0);
    if (value !== undefined && Number.isFinite(value)) found[name] = value;
  }
  return found;
}

function recorded(lab: Lab, name: string, t: number): number | undefined {
  const cut = name.lastIndexOf("_");
  const column = lab.model.columns.find((each) => each.name === name || each.name === name.slice(0, cut));
  if (column === undefined) return undefined;
  const index = column.name === name ? 0 : Number(name.slice(cut + 1)) - 1;
  return row(lab.shown.value.motion, column.name, column.width, t)?.[index];
}


/** The inputs that can be changed one by one: not the entries of a matrix of rotation. */
export function singleInputs(model: PageModel): PageModel["start_inputs"] {
  const entries = model.start_inputs.filter(({ name }) => name.startsWith("attitude_"));
  return entries.length <= 4 ? model.start_inputs : model.start_inputs.filter((input) => !entries.includes(input));
}
