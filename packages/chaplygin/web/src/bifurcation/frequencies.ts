/** The frequencies of a closed form, by Python. */

import type { Ask } from "../sources/source";

/** A frequency or rotation number, in letters. */
export interface Frequency {
  symbol: string;
  value: string;
  unit: string;
  meaning: string;
}

interface ClosedForm {
  title: string;
  motion: string;
  constants: Frequency[];
}

const UNITS = ["turns/s", "rad/s", "s"];

/** Those of an experiment file's motion; a sentence where there are none. */
export async function frequencies(ask: Ask, what: string, experiment: string, signal: AbortSignal): Promise<{ motion: string; list: Frequency[] } | string> {
  let form: ClosedForm | null = null;
  let refused = "";
  await ask({ do: "solve", subject: { what, experiment } }, (answer) => {
    if (typeof answer["error"] === "string") refused = answer["error"];
    if (answer["closed_form"] !== undefined) form = answer["closed_form"] as ClosedForm;
  }, signal);
  const found = form as ClosedForm | null;
  if (found === null) return refused || "No closed form of this motion is known.";
  const list = found.constants.filter(({ unit, meaning }) => UNITS.includes(unit) || meaning === "rotation number");
  return { motion: found.motion, list };
}
