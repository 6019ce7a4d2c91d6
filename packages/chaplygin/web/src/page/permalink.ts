/** The address of what is shown. */

import type { Lab } from "../lab";
import { toFragment } from "./experiment";

/** Milliseconds of rest after which a choice is written. */
const REST = 300;

/** The further choices of a reader by name, such as the view; those that are empty are the usual ones. */
export type Choices = () => Record<string, string>;

/**
 * Keeps the fragment of the address up to date with the motion and with choices made by pointer or
 * keys in an element; the answer gives the whole address, with the instant.
 */
export function permalink(lab: Lab, holder: HTMLElement, choices: Choices): () => string {
  const made = (): Record<string, string> => Object.fromEntries(Object.entries(choices()).filter(([, text]) => text !== ""));
  const write = (): void => {
    const fragment = toFragment(lab.shown.value.experiment, lab.model, made());
    try {
      history.replaceState(history.state, "", fragment === "" ? location.pathname + location.search : fragment);
    } catch {
      // a page without an address of its own, such as the output of a notebook
    }
  };
  let due: ReturnType<typeof setTimeout> | undefined;
  const later = (): void => {
    clearTimeout(due);
    due = setTimeout(write, REST);
  };
  lab.shown.after(later);
  for (const kind of ["change", "click", "pointerup", "keyup", "wheel"]) holder.addEventListener(kind, later, { passive: true });
  return () => {
    const t = lab.clock.time.value;
    const instant: Record<string, string> = t > 0 ? { t: String(Number(t.toPrecision(6))) } : {};
    const fragment = toFragment(lab.shown.value.experiment, lab.model, { ...made(), ...instant });
    return (location.href.split("#")[0] ?? "") + (fragment || "");
  };
}
