/** Sliders for the start, the parameters and the duration. */

import type { Lab } from "../lab";
import type { PageModel } from "../model";
import { element } from "../page/dom";
import { changed, opening } from "../page/experiment";
import { formula } from "../page/mathml";
import { singleInputs, startInputs } from "./start_inputs";
import { rangeAround, slider, type Slider } from "./slider";

/** The panel; where nothing can be changed, one sentence that says why. */
export function experimentPanel(lab: Lab): HTMLElement {
  const { model } = lab;
  if (lab.engine === null) {
    return element("p", { class: "lab-hint" }, "This page plays the motion that was computed for it: under friction the equations change at events, so there are no sliders here. To change start or parameters, edit the experiment file (among what can be saved) and run it.");
  }
  const usual = usualValues(model);
  const starts = singleInputs(model).map((input) => {
    const made = slider({ ...input, symbol: symbolOf(input) }, () => lab.mark(), (value) => {
      const inputs = startInputs(lab);
      const next = changed(inputs, input.name, value, usual.inputs.get(input.name) ?? NaN);
      void lab.change({ ...lab.wanted.value, start: { inputs: next } }, false);
    });
    return [input.name, made] as const;
  });
  const parameters = model.parameters.map((each) => {
    const [low, high] = rangeAround(each.value, each.low, each.high);
    const made = slider({ ...each, symbol: symbolOf(each), low, high }, () => lab.mark(), (value) => {
      void lab.changeParameters(changed(lab.wanted.value.parameters, each.name, value, each.value));
    });
    return [each.name, made] as const;
  });
  const until = slider(
    { name: "until", symbol: document.createTextNode("until"), meaning: "Duration of the motion", unit: "s", value: model.until, low: model.until / 20, high: 5 * model.until },
    () => lab.mark(),
    (value) => {
      if (value > 0) void lab.change({ ...lab.wanted.value, until: value }, false);
      else lab.say("The duration must be positive.", true);
    },
  );
  const note = element("p", { class: "lab-hint", hidden: true }, "This start was chosen in a section or chart; a slider takes it from here.");
  lab.wanted.watch((now) => {
    for (const [name, made] of parameters) made.set(now.parameters[name] ?? usual.parameters.get(name) ?? 0);
    until.set(now.until);
  });
  lab.shown.watch(() => {
    const inputs = startInputs(lab);
    note.hidden = !("state" in lab.wanted.value.start);
    for (const [name, made] of starts) made.set(inputs[name] ?? usual.inputs.get(name) ?? 0);
  });
  lab.wanted.after((now) => {
    if ("state" in now.start) return;
    for (const [name, made] of starts) made.set(now.start.inputs[name] ?? usual.inputs.get(name) ?? 0);
  });
  const reset = element("button", { type: "button", class: "lab-button" }, "As at first");
  reset.addEventListener("click", () => void lab.change(opening(model)));
  // names in words need more room than letters
  const worded = [...model.start_inputs, ...model.parameters].some(({ mathml, name }) => !mathml && name.length > 5);
  return element(
    "div",
    { class: worded ? "lab-sliders lab-worded" : "lab-sliders" },
    group("Start", true, starts, note),
    group("Parameters", parameters.length <= 6 || innerWidth > 620, parameters, null),
    element("details", { open: true }, element("summary", {}, "Run"), until.element, reset),
  );
}

function group(words: string, open: boolean, sliders: readonly (readonly [string, Slider])[], note: HTMLElement | null): HTMLElement | null {
  if (sliders.length === 0) return null;
  return element("details", { open }, element("summary", {}, words), ...sliders.map(([, made]) => made.element), note);
}

function symbolOf({ mathml, name }: { mathml: string; name: string }): Node {
  return mathml ? formula(mathml) : document.createTextNode(name.replaceAll("_", " "));
}

function usualValues(model: PageModel): { inputs: Map<string, number>; parameters: Map<string, number> } {
  return {
    inputs: new Map(model.start_inputs.map((input) => [input.name, input.value])),
    parameters: new Map(model.parameters.map((parameter) => [parameter.name, parameter.value])),
  };
}
