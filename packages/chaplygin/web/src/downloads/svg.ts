/** Pictures as drawings in text: plots over time and sections, in the style of the project's figures. */

import type { ModeInterval } from "../model";
import { extent, readable, ticks } from "../page/numbers";
import { daylight } from "../page/palette";
import { presentModes } from "../playback/modes";
import { SLOPES } from "../plots/mode_bar";

const FONT = "'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif";
const WIDTH = 640;
const BOX = { left: 70, right: 16, top: 30, height: 190, gap: 44 };

export interface Curves {
  label: string;
  unit: string;
  components: readonly { label: string; values: ArrayLike<number> }[];
}

export interface Points {
  x: ArrayLike<number>;
  y: ArrayLike<number>;
  colour: string;
}

type Scale = (value: number) => number;

/** Room for the bar of modes under a plot, and its height. */
const [ROOM, BAR] = [11, 8];

/** Quantities over time, one plot above the other, with the modes of a contact under each. */
export function plotsSvg(title: string, times: ArrayLike<number>, groups: readonly Curves[], modes: readonly ModeInterval[] = []): string {
  const room = modes.length > 0 ? ROOM : 0;
  const key = modes.length > 0 ? modeKey(modes, BOX.top + groups.length * (BOX.height + BOX.gap + room) + 8) : { content: "", height: 0 };
  const height = BOX.top + groups.length * (BOX.height + BOX.gap + room) + 8 + key.height;
  const last = times[times.length - 1] ?? 1;
  const right: Scale = (t) => BOX.left + (t / (last || 1)) * (WIDTH - BOX.left - BOX.right);
  const parts = groups.map(({ label, unit, components }, n) => {
    const top = BOX.top + n * (BOX.height + BOX.gap + room);
    const [low, high] = extent(components.flatMap(({ values }) => Array.from(values)));
    const down: Scale = (value) => top + ((high - value) / (high - low)) * BOX.height;
    const lines = components.map(({ values }, k) => {
      const dash = ["", "7 3", "2 3"][k % 3] ?? "";
      const colour = daylight.components[k] ?? daylight.series[k % daylight.series.length] ?? daylight.ink;
      return `<path d="${path(times, values, right, down)}" fill="none" stroke="${colour}" stroke-width="1.3"${dash ? ` stroke-dasharray="${dash}"` : ""}/>`;
    });
    const names = components.map(({ label: name }, k) => {
      const x = BOX.left + k * 84;
      const colour = daylight.components[k] ?? daylight.series[k % daylight.series.length] ?? daylight.ink;
      const dash = ["", "7 3", "2 3"][k % 3] ?? "";
      return `<path d="M${x} ${top - 10}h22" stroke="${colour}" stroke-width="1.6"${dash ? ` stroke-dasharray="${dash}"` : ""}/>${text(x + 28, top - 6, name, "start", true)}`;
    });
    const axes = frame(right, down, [0, last], [low, high], top, BOX.height, n === groups.length - 1 ? "t  (s)" : "", `${label}${unit ? `  (${unit})` : ""}`, room);
    const bar = modes.map(({ mode, begin, end }) => modeArea(mode, right(begin), right(Math.min(end, last)), top + BOX.height + ROOM - BAR)).join("");
    return axes + bar + lines.join("") + (components.length > 1 ? names.join("") : "");
  });
  return drawing(title, WIDTH, height, (modes.length > 0 ? STRIPES : "") + parts.join("") + key.content);
}

const STRIPES = [0, 1]
  .map((slope) => `<pattern id="stripes${slope}" width="4.5" height="4.5" patternUnits="userSpaceOnUse" patternTransform="rotate(${45 * slope})"><path d="M0 0V4.5" stroke="#fff" stroke-width="2"/></pattern>`)
  .join("");

function modeArea(mode: string, left: number, right: number, top: number): string {
  const area = (fill: string): string => `<rect x="${left.toFixed(2)}" y="${top}" width="${Math.max(0, right - left).toFixed(2)}" height="${BAR}" fill="${fill}"/>`;
  const slope = SLOPES[mode];
  return area(daylight.modes[mode] ?? daylight.ink) + (slope === undefined ? "" : area(`url(#stripes${slope})`));
}

function modeKey(modes: readonly ModeInterval[], top: number): { content: string; height: number } {
  let [x, y] = [BOX.left, top];
  const entries = presentModes(modes, Object.keys(daylight.modes)).map((mode) => {
    const width = 44 + 6.2 * mode.length;
    if (x + width > WIDTH) [x, y] = [BOX.left, y + 18];
    const entry = modeArea(mode, x, x + 20, y) + text(x + 26, y + 8, mode, "start");
    x += width;
    return entry;
  });
  return { content: entries.join(""), height: y - top + 20 };
}

/** Points of a section. */
export function sectionSvg(title: string, x: { label: string; range: [number, number] }, y: { label: string; range: [number, number] }, orbits: readonly Points[]): string {
  const tall = 480;
  const right: Scale = (value) => BOX.left + ((value - x.range[0]) / (x.range[1] - x.range[0])) * (WIDTH - BOX.left - BOX.right);
  const down: Scale = (value) => 16 + ((y.range[1] - value) / (y.range[1] - y.range[0])) * tall;
  const dots = orbits.map(({ x: xs, y: ys, colour }) => {
    const marks: string[] = [];
    for (let k = 0; k < xs.length; k++) {
      const [a, b] = [right(xs[k] ?? NaN), down(ys[k] ?? NaN)];
      if (a >= BOX.left && a <= WIDTH - BOX.right && b >= 16 && b <= 16 + tall) marks.push(`M${a.toFixed(1)} ${b.toFixed(1)}h0`);
    }
    return `<path d="${marks.join("")}" stroke="${colour}" stroke-width="1.4" stroke-linecap="round"/>`;
  });
  return drawing(title, WIDTH, tall + 66, frame(right, down, x.range, y.range, 16, tall, x.label, y.label) + dots.join(""));
}

function drawing(title: string, width: number, height: number, content: string): string {
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" width="${width}" height="${height}" role="img">` +
    `<title>${escaped(title)}</title><rect width="100%" height="100%" fill="#fff"/>${content}</svg>\n`
  );
}

function frame(right: Scale, down: Scale, x: readonly [number, number], y: readonly [number, number], top: number, height: number, xLabel: string, yLabel: string, room = 0): string {
  const [left, end, low] = [right(x[0]), right(x[1]), top + height];
  const parts = [`<path d="M${left} ${top}V${low}H${end}" fill="none" stroke="${daylight.quiet}" stroke-width="0.8"/>`];
  for (const value of ticks(x[0], x[1], 7)) {
    const place = right(value).toFixed(1);
    parts.push(`<path d="M${place} ${low}v${4 + room}" stroke="${daylight.quiet}" stroke-width="0.8"/>`, text(Number(place), low + 17 + room, readable(value, 6), "middle"));
  }
  for (const value of ticks(y[0], y[1], Math.max(3, height / 50))) {
    const place = down(value);
    parts.push(`<path d="M${left} ${place.toFixed(1)}h-4" stroke="${daylight.quiet}" stroke-width="0.8"/>`, text(left - 7, place + 4, readable(value, 6), "end"));
  }
  if (xLabel) parts.push(text((left + end) / 2, low + 36 + room, xLabel, "middle", true));
  const middle = top + height / 2;
  parts.push(`<g transform="rotate(-90 16 ${middle})">${text(16, middle + 4, yLabel, "middle", true)}</g>`);
  return parts.join("");
}

function text(x: number, y: number, words: string, anchor: string, letters = false): string {
  return `<text x="${x.toFixed(1)}" y="${y.toFixed(1)}" font-family="${FONT.replaceAll('"', "'")}" font-size="${letters ? 14 : 12.5}"${letters ? ' font-style="italic"' : ""} text-anchor="${anchor}" fill="${daylight.ink}">${escaped(words)}</text>`;
}

/** A line through samples, interrupted where a value is missing. */
function path(times: ArrayLike<number>, values: ArrayLike<number>, right: Scale, down: Scale): string {
  const parts: string[] = [];
  let begun = false;
  for (let k = 0; k < times.length; k++) {
    const value = values[k] ?? NaN;
    if (!Number.isFinite(value)) begun = false;
    else {
      parts.push(`${begun ? "L" : "M"}${right(times[k] ?? 0).toFixed(1)} ${down(value).toFixed(1)}`);
      begun = true;
    }
  }
  return parts.join("");
}

function escaped(words: string): string {
  return words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}
