/** Quantities over time, with a cursor tied to the scene. */

import uPlot from "uplot";
import type { Lab } from "../lab";
import { element, toggle } from "../page/dom";
import { font, letter } from "../page/type";
import { formula } from "../page/mathml";
import { readable, readableBeside } from "../page/numbers";
import { onSchemeChange, palette, type Palette } from "../page/palette";
import { changingModes, lastEvent, modeAt } from "../playback/modes";
import { place } from "../playback/motion";
import { drawModes, modeKey } from "./mode_bar";
import { seriesGroups, type SeriesGroup } from "./series";

/** Height of a plot, in letters of the page; of a wide one a share of its width, and no more of a window. */
const [HEIGHT, OF_WIDTH, OF_WINDOW] = [10.5, 0.32, 0.24];

/** Space over the bar of modes, and its height, in CSS pixels. */
const [SPACE, BAR] = [3, 8];

export interface PlotsPanel {
  element: HTMLElement;
  /** The quantities that are drawn. */
  chosen(): SeriesGroup[];
}

/** Plots of the quantities that the reader chooses, one above the other. */
export function plotsPanel(lab: Lab): PlotsPanel {
  const chosen = new Set(firstChosen(lab));
  const chips = element("div", { class: "lab-chips", role: "toolbar", "aria-label": "Quantities" });
  const sheets = element("div", { class: "lab-plots" });
  const keyPlace = element("div", {});
  const event = element("p", { class: "lab-event", "aria-label": "Last change of the contact" });
  const panel = element("div", {}, chips, keyPlace, sheets);
  let mark: (mode: string) => void = () => {};
  let plots: { plot: uPlot; readings: Reading[]; size: number }[] = [];
  const groups = (): SeriesGroup[] => seriesGroups(lab.model, lab.shown.value.motion);
  const drawn = (): SeriesGroup[] => groups().filter(({ name }) => chosen.has(name));
  const build = (): void => {
    for (const { plot } of plots) plot.destroy();
    sheets.replaceChildren();
    const modes = changingModes(lab.shown.value.motion);
    const key = modes.length > 0 ? modeKey(modes, palette()) : null;
    keyPlace.replaceChildren(...(key === null ? [] : [key.element]), event);
    event.hidden = (lab.shown.value.motion.events ?? []).length === 0;
    mark = key?.now ?? (() => {});
    plots = drawn().map((group) => {
      const holder = element("figure", { class: "lab-plot", "aria-label": `${group.meaning || group.name} over time` });
      sheets.append(holder);
      const width = Math.max(240, sheets.clientWidth || 600);
      const readings = legend(group, holder);
      return { plot: plotOf(lab, group, holder, width), readings, size: largest(group) };
    });
    now();
  };
  const now = (): void => {
    const { motion } = lab.shown.value;
    const t = lab.clock.reading.value;
    mark(modeAt(changingModes(motion), t));
    event.textContent = lastEvent(motion, t);
    const { index, share } = place(motion.times, t);
    for (const { readings, size, plot } of plots) {
      readings.forEach((reading, k) => {
        const values = plot.data[k + 1];
        const value = (1 - share) * (values?.[index] ?? NaN) + (share > 0 ? share * (values?.[index + 1] ?? NaN) : 0);
        reading.textContent = readableBeside(size, value);
      });
    }
  };
  const renew = (): void => {
    const groups = drawn();
    if (groups.length !== plots.length) return build();
    plots = plots.map((drawn, k) => {
      const group = groups[k];
      if (group === undefined) return drawn;
      drawn.plot.setData(dataOf(lab, group));
      return { ...drawn, size: largest(group) };
    });
    now();
  };
  for (const group of groups()) {
    const face = group.mathml && group.text.length <= 4 ? formula(group.mathml) : group.text;
    chips.append(
      toggle(face, group.meaning || group.name, chosen.has(group.name), (on) => {
        if (on) chosen.add(group.name);
        else chosen.delete(group.name);
        build();
      }),
    );
  }
  lab.shown.after(renew);
  lab.clock.reading.after(now);
  lab.clock.time.after(() => plots.forEach(({ plot }) => cursor(plot, lab)));
  onSchemeChange(build);
  let width = 0;
  new ResizeObserver(() => {
    if (sheets.clientWidth === width || sheets.clientWidth === 0) return;
    const first = width === 0;
    width = sheets.clientWidth;
    if (first) build();
    else for (const { plot } of plots) plot.setSize({ width, height: heightOf(lab, width) });
  }).observe(sheets);
  return { element: panel, chosen: drawn };
}

/** The largest absolute value of the curves. */
function largest(group: SeriesGroup): number {
  return group.components.reduce((size, { values }) => values.reduce((high, value) => Math.max(high, Math.abs(value) || 0), size), 0);
}

type Reading = HTMLElement;

/** Names of the curves with their values at the instant of the scene. */
function legend(group: SeriesGroup, holder: HTMLElement): Reading[] {
  const colours = palette();
  const line = element("figcaption", { class: "lab-curves" });
  holder.append(line);
  return group.components.map(({ label }, k) => {
    const reading = element("span", { class: "lab-number" });
    const style = `border-top: 2.5px ${STROKES[k % STROKES.length] ?? "solid"} ${curveColour(colours, k, group.components.length)}`;
    const [letter = "", index = ""] = label.split("_");
    line.append(element("span", {}, element("i", { style }), letter, index === "" ? null : element("sub", {}, index), " = ", reading));
    return reading;
  });
}

const STROKES = ["solid", "dashed", "dotted", "solid"] as const;

/** The colour of a component; where there are more than three, all are from the longer list. */
function curveColour(colours: Palette, k: number, count: number): string {
  const list = count > colours.components.length ? colours.series : colours.components;
  return list[k % list.length] ?? colours.ink;
}

function firstChosen(lab: Lab): string[] {
  const names = lab.model.columns.map(({ name }) => name);
  const wanted = ["omega", "gamma"].filter((name) => names.includes(name));
  return wanted.length > 0 ? wanted : names.filter((name) => !name.startsWith("lambda")).slice(0, 2);
}

function dataOf(lab: Lab, group: SeriesGroup): uPlot.AlignedData {
  return [lab.shown.value.motion.times, ...group.components.map(({ values }) => values)];
}

function heightOf(lab: Lab, width: number): number {
  return Math.round(Math.max(HEIGHT * letter(), Math.min(OF_WIDTH * width, OF_WINDOW * window.innerHeight))) + roomForModes(lab);
}

/** What the bar of modes takes under a plot; the ticks of time go down through it. */
function roomForModes(lab: Lab): number {
  return changingModes(lab.shown.value.motion).length > 0 ? SPACE + BAR : 0;
}

function plotOf(lab: Lab, group: SeriesGroup, holder: HTMLElement, width: number): uPlot {
  const colours = palette();
  const marks = { stroke: colours.quiet, font: font(0.8 * letter()), ticks: { stroke: colours.line, width: 1, size: 4 }, grid: { stroke: colours.line, width: 0.5 } };
  const dashes = [[], [7, 3], [2, 3], [8, 3, 2, 3]];
  const label = `${group.text}${group.unit ? `  (${group.unit})` : ""}`;
  const room = roomForModes(lab);
  const ticks = { ...marks.ticks, size: marks.ticks.size + room };
  const plot: uPlot = new uPlot(
    {
      width,
      height: heightOf(lab, width),
      legend: { show: false },
      scales: { x: { time: false } },
      cursor: { y: false, drag: { x: false, y: false }, points: { size: 6 }, focus: { prox: 24 } },
      axes: [
        { ...marks, ticks, size: 1.9 * letter() + room, values: (_, values) => values.map((value) => readable(value, 6)) },
        { ...marks, size: 3.9 * letter(), label, labelSize: 1.4 * letter(), labelFont: `italic ${font(0.88 * letter())}`, values: (_, values) => values.map((value) => readable(value, 6)) },
      ],
      series: [
        {},
        ...group.components.map(({ label: name }, k) => ({
          label: name,
          stroke: curveColour(colours, k, group.components.length),
          width: 1.5,
          dash: dashes[k % dashes.length] ?? [],
          points: { show: false },
        })),
      ],
      hooks: {
        draw: [(drawn) => bar(drawn, lab, colours), (drawn) => cursor(drawn, lab)],
      },
    },
    dataOf(lab, group),
    holder,
  );
  const seek = (event: PointerEvent): void => {
    const { left } = plot.over.getBoundingClientRect();
    lab.clock.pause();
    lab.clock.seek(plot.posToVal(event.clientX - left, "x"));
  };
  plot.over.addEventListener("pointerdown", (event) => {
    plot.over.setPointerCapture(event.pointerId);
    seek(event);
  });
  plot.over.addEventListener("pointermove", (event) => {
    if (plot.over.hasPointerCapture(event.pointerId)) seek(event);
  });
  plot.over.style.touchAction = "pan-y";
  const mark = element("div", { class: "lab-plot-now" });
  plot.over.append(mark);
  cursor(plot, lab);
  return plot;
}

/** Draw the modes of the contact under a plot, where they change. */
function bar({ ctx, bbox, scales }: uPlot, lab: Lab, colours: Palette): void {
  const ratio = uPlot.pxRatio;
  const { min = 0, max = 1 } = scales["x"] ?? {};
  const box = { left: bbox.left, top: bbox.top + bbox.height + SPACE * ratio, width: bbox.width, height: BAR * ratio, ratio };
  drawModes(ctx, changingModes(lab.shown.value.motion), min, max, box, colours);
  ctx.fillStyle = colours.ink;
  for (const { time } of lab.shown.value.motion.events ?? []) {
    if (time < min || time > max) continue;
    ctx.fillRect(bbox.left + (bbox.width * (time - min)) / (max - min) - 0.5 * ratio, box.top - ratio, ratio, box.height + 2 * ratio);
  }
}

/** The line of the instant that the scene shows is an element of its own: moving it redraws nothing. */
function cursor(plot: uPlot, lab: Lab): void {
  const mark = plot.over.querySelector<HTMLElement>(".lab-plot-now");
  if (mark === null) return;
  mark.style.transform = `translateX(${plot.valToPos(lab.clock.time.value, "x").toFixed(2)}px)`;
}
