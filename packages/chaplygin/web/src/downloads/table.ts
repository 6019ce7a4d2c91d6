/** A motion as a table of text. */

import type { Column } from "../model";
import type { Motion } from "../playback/motion";

const SUFFIXES: Record<string, readonly string[]> = {
  body: ["_1", "_2", "_3"],
  space: ["_x", "_y", "_z"],
  quaternion: ["_w", "_x", "_y", "_z"],
};

/** Comma-separated values: a row of names with units, then one row a sample, every number in full. */
export function csv(motion: Motion, columns: readonly Column[]): string {
  const present = columns.filter(({ name }) => motion.columns[name] !== undefined);
  const head = ["time (s)"];
  for (const { name, width, axes, unit } of present) {
    const suffixes = SUFFIXES[axes];
    for (let k = 0; k < width; k++) {
      const suffix = width === 1 ? "" : (suffixes?.[k] ?? `_${k + 1}`);
      head.push(`${name}${suffix}${unit === "1" ? "" : ` (${unit})`}`);
    }
  }
  const lines = [head.map(quoted).join(",")];
  motion.times.forEach((t, n) => {
    const cells = [String(t)];
    for (const { name, width } of present) {
      const values = motion.columns[name];
      for (let k = 0; k < width; k++) {
        const value = values?.[n * width + k] ?? NaN;
        cells.push(Number.isFinite(value) ? String(value) : "");
      }
    }
    lines.push(cells.join(","));
  });
  return `${lines.join("\n")}\n`;
}

/** Comma-separated values of the points of a section. */
export function sectionCsv(names: readonly [string, string], orbits: readonly { x: Float64Array; y: Float64Array; number: number }[]): string {
  const lines = [["orbit", ...names].map(quoted).join(",")];
  for (const { x, y, number } of orbits) x.forEach((value, k) => lines.push(`${number + 1},${value},${y[k] ?? ""}`));
  return `${lines.join("\n")}\n`;
}

function quoted(text: string): string {
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
