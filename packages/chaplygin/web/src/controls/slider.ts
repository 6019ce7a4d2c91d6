/** Sliders with a field for the exact number. */

import { element } from "../page/dom";
import { unitText } from "../page/units";
import { readable } from "../page/numbers";

export interface SliderValue {
  name: string;
  symbol: Node;
  meaning: string;
  unit: string;
  value: number;
  low: number;
  high: number;
}

/** A slider; `begin` is called before a change, `act` at every step of it. */
export interface Slider {
  element: HTMLElement;
  set(value: number): void;
}

/** Steps of a slider from its lowest to its highest value. */
const STEPS = 1000;

export function slider(given: SliderValue, begin: () => void, act: (value: number) => void): Slider {
  const { low, high } = given;
  const label = `${given.meaning || given.name}${given.unit && given.unit !== "1" ? `, ${given.unit}` : ""}`;
  const range = element("input", { type: "range", min: 0, max: STEPS, step: 1, "aria-label": label });
  const field = element("input", { type: "text", inputmode: "decimal", "aria-label": `${label}, as a number`, class: "lab-field", size: 9 });
  const show = (value: number): void => {
    const share = high > low ? (value - low) / (high - low) : 0;
    range.value = String(Math.round(STEPS * share));
    range.style.setProperty("--share", String(Math.min(1, Math.max(0, share))));
    range.setAttribute("aria-valuetext", `${readable(value)} ${given.unit}`);
    // what is nothing beside the range is rounding
    if (document.activeElement !== field) field.value = Math.abs(value) < 1e-12 * (high - low) ? "0" : shortest(value);
  };
  let moving = false;
  range.addEventListener("input", () => {
    if (!moving) begin();
    moving = true;
    const value = rounded(low + (Number(range.value) / STEPS) * (high - low), high - low);
    show(value);
    act(value);
  });
  range.addEventListener("change", () => (moving = false));
  const entered = (): void => {
    const value = Number(field.value.replaceAll("\u2212", "-").replace(",", "."));
    if (field.value.trim() === "" || !Number.isFinite(value)) {
      field.setAttribute("aria-invalid", "true");
      return;
    }
    field.removeAttribute("aria-invalid");
    begin();
    act(value);
    show(value);
  };
  field.addEventListener("change", entered);
  field.addEventListener("keydown", (event) => event.stopPropagation());
  show(given.value);
  const unit = unitText(given.unit) === "" ? null : element("span", { class: "lab-unit" }, unitText(given.unit));
  const made = element(
    "div",
    { class: "lab-slider", title: given.meaning || null },
    element("span", { class: "lab-symbol" }, given.symbol),
    range,
    element("span", { class: "lab-value" }, field, unit),
  );
  return { element: made, set: show };
}

/** A number in five digits, or all that it has if they are fewer. */
function shortest(value: number): string {
  return String(Number(value.toPrecision(5))).replaceAll("-", "\u2212");
}

/** A number rounded to a step that is small on a range. */
function rounded(value: number, range: number): number {
  const step = 10 ** Math.floor(Math.log10(range / STEPS));
  return Number((Math.round(value / step) * step).toPrecision(12));
}

/** The range of a slider for a value of which nothing else is known. */
export function rangeAround(value: number, low: number | null, high: number | null): [number, number] {
  const from = low ?? (value > 0 ? 0 : value < 0 ? 2 * value : -1);
  const to = high ?? (value > 0 ? 2 * value : value < 0 ? 0 : 1);
  if (from < to) return [Math.min(from, value), Math.max(to, value)];
  return [from, from + Math.max(1, Math.abs(from))];
}
