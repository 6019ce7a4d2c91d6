/** The address of what is shown. */

import type { Lab } from "../lab";
import { toFragment } from "./experiment";

/** Keeps the fragment of the address up to date; the answer gives the whole address. */
export function permalink(lab: Lab): () => string {
  const address = (): string => {
    const t = lab.clock.time.value;
    const choices: Record<string, string> = t > 0 ? { t: String(Number(t.toPrecision(6))) } : {};
    return location.href.split("#")[0] + toFragment(lab.shown.value.experiment, lab.model, choices);
  };
  lab.shown.after(({ experiment }) => {
    const fragment = toFragment(experiment, lab.model, {});
    try {
      history.replaceState(null, "", fragment === "" ? location.pathname + location.search : fragment);
    } catch {
      // a page without an address of its own, such as the output of a notebook
    }
  });
  return address;
}
