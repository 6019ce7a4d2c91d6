/** The bar of the modes of a contact, and its key. */

import type { ModeInterval } from "../model";
import { element } from "../page/dom";
import type { Palette } from "../page/palette";
import { presentModes } from "../playback/modes";

/** Where a bar is drawn, in pixels of the canvas; a CSS pixel has `ratio` of them. */
export interface BarBox {
  left: number;
  top: number;
  width: number;
  height: number;
  ratio: number;
}

/** Modes in which friction holds the spin have stripes, that of spinning alone has upright ones. */
export const SLOPES: Record<string, number> = {
  "sliding without spin": 1,
  "rolling without spin": 1,
  "sliding without turning": 1,
  spinning: 0,
};

/** Draw the modes between two instants as a bar. */
export function drawModes(pen: CanvasRenderingContext2D, modes: readonly ModeInterval[], from: number, until: number, box: BarBox, colours: Palette): void {
  const across = (t: number): number => box.left + box.width * Math.min(Math.max((t - from) / (until - from), 0), 1);
  for (const { mode, begin, end } of modes) {
    const left = across(begin);
    const width = across(end) - left;
    if (!(width > 0)) continue;
    pen.fillStyle = colours.modes[mode] ?? colours.ink;
    pen.fillRect(left, box.top, width, box.height);
    const slope = SLOPES[mode];
    if (slope !== undefined && width > 2 * box.ratio) stripes(pen, { ...box, left, width }, slope, colours.paper);
  }
}

function stripes(pen: CanvasRenderingContext2D, { left, top, width, height, ratio }: BarBox, slope: number, colour: string): void {
  pen.save();
  pen.beginPath();
  pen.rect(left, top, width, height);
  pen.clip();
  pen.strokeStyle = colour;
  pen.lineWidth = 1.2 * ratio;
  pen.beginPath();
  for (let x = left - slope * height; x < left + width; x += 4.5 * ratio) {
    pen.moveTo(x, top + height);
    pen.lineTo(x + slope * height, top);
  }
  pen.stroke();
  pen.restore();
}

/** A bar of its own, so many CSS pixels large. */
export function modeBar(modes: readonly ModeInterval[], width: number, height: number, colours: Palette): HTMLCanvasElement {
  const ratio = 2;
  const bar = element("canvas", { class: "lab-mode-bar", width: ratio * width, height: ratio * height, "aria-hidden": true });
  const pen = bar.getContext("2d");
  const box = { left: 0, top: 0, width: bar.width, height: bar.height, ratio };
  if (pen !== null) drawModes(pen, modes, modes[0]?.begin ?? 0, modes.at(-1)?.end ?? 1, box, colours);
  return bar;
}

/** The key of the modes that occur; `now` marks the one of the instant. */
export function modeKey(modes: readonly ModeInterval[], colours: Palette): { element: HTMLElement; now(mode: string): void } {
  const entries = presentModes(modes, Object.keys(colours.modes)).map((mode) => {
    const sample = modeBar([{ mode, begin: 0, end: 1 }], 20, 8, colours);
    return { mode, entry: element("span", {}, sample, mode) };
  });
  const key = element("div", { class: "lab-modes", role: "group", "aria-label": "Modes of the contact" }, ...entries.map(({ entry }) => entry));
  return {
    element: key,
    now(mode) {
      for (const each of entries) {
        if (each.mode === mode) each.entry.setAttribute("aria-current", "true");
        else each.entry.removeAttribute("aria-current");
      }
    },
  };
}
