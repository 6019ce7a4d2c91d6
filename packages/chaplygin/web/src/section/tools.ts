/** The choices of a section: quantities, value, direction, points. */

import type { Lab } from "../lab";
import type { PageModel } from "../model";
import { choice, element, toggle } from "../page/dom";
import { quantityIndex, type SectionSetting } from "./orbits";
import { letters } from "./points";

export interface SectionActs {
  change(part: Partial<SectionSetting>): void;
  points(count: number): void;
  indicator(isOn: boolean): void;
  box(isOn: boolean): void;
  zoom(factor: number): void;
  all(): void;
  clear(): void;
}

export interface SectionTools {
  element: HTMLElement;
  /** Show what is chosen. */
  write(setting: SectionSetting): void;
}

const DIRECTIONS = [
  { value: "1", text: "rising" },
  { value: "-1", text: "falling" },
  { value: "0", text: "both" },
];
const COUNTS = [200, 1000, 5000, 20_000].map((count) => ({ value: String(count), text: String(count) }));

export function sectionTools(lab: Lab, chosen: SectionSetting, points: number, acts: SectionActs): SectionTools {
  const { model } = lab;
  const all = model.quantities.map((quantity) => ({ value: quantity.name, text: letters(quantity) }));
  const names = model.wasm_tables?.section_quantities ?? model.quantities.map(({ name }) => name);
  const value = element("input", { type: "text", inputmode: "decimal", class: "lab-field", "aria-label": "Value on the section" });
  value.value = String(chosen.value);
  value.addEventListener("change", () => {
    const number = Number(value.value.replace("\u2212", "-"));
    if (value.value.trim() !== "" && Number.isFinite(number)) acts.change({ value: number });
    else lab.say("The value on the section must be a number.", true);
  });
  const button = (words: string, label: string, act: () => void): HTMLButtonElement => {
    const made = element("button", { type: "button", title: label }, words);
    made.addEventListener("click", act);
    return made;
  };
  const on = choice("on", all.filter((each) => names.includes(each.value)), chosen.on, (name) => acts.change({ on: name }));
  const direction = choice("direction", DIRECTIONS, String(chosen.direction), (way) => acts.change({ direction: Number(way) as -1 | 0 | 1 }));
  const across = choice("across", all, chosen.x, (name) => acts.change({ x: name }));
  const up = choice("up", all, chosen.y, (name) => acts.change({ y: name }));
  const bar = element(
    "div",
    { class: "lab-tools", role: "toolbar", "aria-label": "Section" },
    on,
    element("label", { class: "lab-choice" }, "=", value),
    direction,
    across,
    up,
    choice("points", COUNTS, String(points), (count) => acts.points(Number(count))),
    toggle("indicator", "Colour orbits by MEGNO, an indicator of chaos", false, acts.indicator),
    toggle("box", "Drag a box to enlarge it (or Shift and drag)", false, acts.box),
    button("+", "Nearer (+)", () => acts.zoom(1 / 1.5)),
    button("−", "Farther (−)", () => acts.zoom(1.5)),
    button("all", "Show all points (0)", acts.all),
    button("clear", "Remove all orbits but that of the scene", acts.clear),
  );
  const write = (setting: SectionSetting): void => {
    value.value = String(setting.value);
    for (const [label, name] of [[on, setting.on], [across, setting.x], [up, setting.y], [direction, String(setting.direction)]] as const) {
      const list = label.querySelector("select");
      if (list !== null) list.value = name;
    }
  };
  return { element: bar, write };
}

/** A setting as text for an address. */
export function settingText({ on, value, direction, x, y }: SectionSetting): string {
  return [on, value, direction, x, y].join(" ");
}

/** The setting of a text; null where the model has none such. */
export function settingOf(text: string, model: PageModel): SectionSetting | null {
  const [on = "", value = "", direction = "", x = "", y = ""] = text.split(/[ +]/);
  const number = Number(value);
  const known = [on, x, y].every((name) => quantityIndex(model, name) >= 0) && (model.wasm_tables?.section_quantities.includes(on) ?? true);
  if (!known || value === "" || !Number.isFinite(number) || !["-1", "0", "1"].includes(direction)) return null;
  return { on, value: number, direction: Number(direction) as -1 | 0 | 1, x, y };
}
