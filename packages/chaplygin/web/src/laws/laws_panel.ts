/** The laws with their verdicts, values and drifts. */

import type { Lab } from "../lab";
import type { Law } from "../model";
import { element } from "../page/dom";
import { formula } from "../page/mathml";
import { readable } from "../page/numbers";
import { unitText } from "../page/units";
import { row, type Motion } from "../playback/motion";

/** What a verdict begins with, its mark and its class. */
const MARKS: readonly (readonly [string, string])[] = [["proven", "✓"], ["refuted", "✗"], ["undecided", "?"], ["not tried", "–"]];

/** A law as a test reads it. */
export interface LawReading {
  name: string;
  verdict: string;
  value: number | null;
  drift: number | null;
}

/** All laws with their values at an instant. */
export function lawReadings(lab: Lab, t: number): LawReading[] {
  const { motion } = lab.shown.value;
  return lab.model.laws.map(({ name, verdict, column }) => ({
    name,
    verdict,
    value: column === null ? null : (row(motion, column, 1, t)?.[0] ?? null),
    drift: column === null ? null : drift(motion, column),
  }));
}

/** How far a column gets from its first value. */
export function drift(motion: Motion, column: string): number | null {
  const values = motion.columns[column];
  if (values === undefined) return null;
  const first = values[0] ?? NaN;
  let farthest = 0;
  for (const value of values) {
    const away = Math.abs(value - first);
    if (away > farthest) farthest = away;
  }
  return farthest;
}

function verdictOf({ verdict, text }: Law): HTMLElement {
  const [word, mark] = MARKS.find(([each]) => verdict.startsWith(each)) ?? ["undecided", "?"];
  return element("span", { class: `lab-verdict lab-${word.replace(" ", "-")}`, title: text }, `${mark} ${verdict}`);
}

/** The panel; null for a system of which no law is known. */
export function lawsPanel(lab: Lab): HTMLElement | null {
  const { laws, columns } = lab.model;
  if (laws.length === 0) return null;
  const units = new Map(columns.map(({ name, unit }) => [name, unitText(unit)]));
  const rows = laws.map((law) => {
    const value = element("span", { class: "lab-number" });
    const away = element("span", { class: "lab-number" });
    const verdict = verdictOf(law);
    const numbers = law.column === null
      ? null
      : element("p", { class: "lab-law-numbers" }, element("span", {}, "now ", value), element("span", {}, "drift ", away));
    const made = element(
      "li",
      {},
      element("p", { class: "lab-law-head" }, element("strong", {}, law.meaning || law.name), verdict, element("span", { class: "lab-source" }, law.source)),
      element("div", { class: "lab-formula", tabindex: 0, role: "group", "aria-label": `Formula of ${law.meaning || law.name}` }, formula(law.mathml)),
      numbers,
    );
    return { law, value, away, made };
  });
  const values = (): void => {
    for (const { law, value } of rows) {
      if (law.column === null) continue;
      const now = row(lab.shown.value.motion, law.column, 1, lab.clock.reading.value)?.[0] ?? NaN;
      value.textContent = `${readable(now, 7)} ${units.get(law.column) ?? ""}`;
    }
  };
  lab.clock.reading.after(values);
  lab.shown.watch(({ motion }) => {
    for (const { law, away } of rows) {
      if (law.column !== null) away.textContent = readable(drift(motion, law.column) ?? NaN, 2);
    }
    values();
  });
  return element("ul", { class: "lab-laws" }, ...rows.map(({ made }) => made));
}
