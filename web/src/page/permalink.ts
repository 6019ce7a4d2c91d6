/** The address of what is shown. */

import type { Lab } from "../lab";
import { toFragment } from "./experiment";

/** Keeps the fragment of the address up to date; the answer gives the whole address, with the instant. */
export function permalink(lab: Lab): () => string {
  lab.shown.after(({ experiment }) => {
    const fragment = toFragment(experiment, lab.model, {});
    try {
      history.replaceState(history.state, "", fragment === "" ? location.pathname + location.search : fragment);
    } catch {
      // a page without an address of its own, such as the output of a notebook
    }
  });
  return () => {
    const t = lab.clock.time.value;
    const choices: Record<string, string> = t > 0 ? { t: String(Number(t.toPrecision(6))) } : {};
    const fragment = toFragment(lab.shown.value.experiment, lab.model, choices);
    return (location.href.split("#")[0] ?? "") + (fragment || "");
  };
}
