/** What needs Python: proofs, the search for laws, closed forms, periodic orbits, long charts, files. */

import { experimentText } from "../downloads/downloads_panel";
import type { Lab } from "../lab";
import { choice, element, save } from "../page/dom";
import { formula } from "../page/mathml";
import type { Answer } from "../sources/ask";
import type { Ask } from "../sources/source";
import { tileChart } from "./tile_chart";

/** Shows a part of an answer; nothing where it says nothing to a reader. */
type Show = (answer: Answer) => Node | null;

/** Buttons for all of it, and the answer to the last one. */
export function pythonPanel(ask: Ask, lab: Lab): HTMLElement {
  const { model } = lab;
  const status = element("p", { class: "lab-hint", role: "status", "aria-live": "polite" });
  const answers = element("div", { class: "lab-answers" });
  const stop = element("button", { type: "button", class: "lab-button" }, "Stop");
  stop.hidden = true;
  let running: AbortController | null = null;
  stop.addEventListener("click", () => running?.abort());

  const run = async (request: object, show: Show): Promise<void> => {
    running?.abort();
    const control = new AbortController();
    running = control;
    answers.replaceChildren();
    stop.hidden = false;
    status.classList.remove("lab-refused");
    status.textContent = "asking …";
    let refused = "";
    const heard = (answer: Answer): void => {
      if (typeof answer["error"] === "string") refused = answer["error"];
      if (typeof answer["doing"] === "string") status.textContent = `${answer["doing"]} …`;
      if (typeof answer["progress"] === "number") status.textContent = `${Math.round(100 * answer["progress"])} % …`;
      const node = show(answer);
      if (node !== null) answers.append(node);
    };
    try {
      await ask({ ...request, subject: { what: model.name, experiment: experimentText(lab) } }, heard, control.signal);
    } catch (why) {
      refused = control.signal.aborted ? "Stopped." : why instanceof Error ? why.message : String(why);
    }
    if (running !== control) return;
    stop.hidden = true;
    status.textContent = refused;
    status.classList.toggle("lab-refused", refused !== "");
  };

  const rows: HTMLElement[] = [];
  const row = (words: string, act: () => { request: object; show: Show }, ...fields: HTMLElement[]): void => {
    const made = element("button", { type: "button", class: "lab-button" }, words);
    made.addEventListener("click", () => {
      const { request, show } = act();
      void run(request, show);
    });
    rows.push(element("div", { class: "lab-tools" }, made, ...fields));
  };
  row("Prove the laws", () => ({ request: { do: "prove" }, show: verdict }));
  const kind = select("for", ["integrals", "measure", "symmetries"]);
  const degree = field("degree", "2");
  row("Search", () => ({ request: { do: "find", kind: kind.value(), degree: Number(degree.value()) }, show: law }), kind.label, degree.label);
  row("Closed form", () => ({ request: { do: "solve" }, show: closedForm }));
  const on = field("on the section", `${model.section?.on ?? model.quantities[0]?.name ?? ""}`);
  const after = field("after returns", "1");
  row("Periodic orbit", () => ({ request: { do: "orbit", on: on.value(), after: Number(after.value()) }, show: orbit }), on.label, after.label);
  const of = field("of", "megno");
  const [first, second] = model.parameters;
  const axis = (name: string, value: number): string => `${name}=${value - 0.2 * (Math.abs(value) || 1)}:${value + 0.2 * (Math.abs(value) || 1)}:100`;
  const x = field("across", first ? axis(first.name, first.value) : "");
  const y = field("up", second ? axis(second.name, second.value) : "");
  row("Long chart", () => ({ request: { do: "chart", of: of.value(), x: x.value(), y: y.value() }, show: tileChart() }), of.label, x.label, y.label);
  row("Data (NetCDF)", () => ({ request: { do: "data", format: "nc" }, show: file }));
  const name = field("as", `${model.name}-changed.toml`);
  const keep = element("button", { type: "button", class: "lab-button" }, "Save the experiment");
  keep.addEventListener("click", () => void saveExperiment(name.value(), false));
  rows.push(element("div", { class: "lab-tools" }, keep, name.label));

  /** A file that is there already is replaced when the button is pressed again. */
  let asked = "";
  async function saveExperiment(target: string, replace: boolean): Promise<void> {
    const again = replace || asked === target;
    let sentence = `${target} is saved in the folder of the lab.`;
    await ask({ do: "save", file: target, experiment: experimentText(lab), replace: again }, (answer) => {
      if (typeof answer["error"] === "string") sentence = answer["error"];
    }).catch((why: unknown) => (sentence = why instanceof Error ? why.message : String(why)));
    asked = sentence.includes("exists already") ? target : "";
    status.textContent = asked === "" ? sentence : `${target} exists already: press again to replace it.`;
    status.classList.toggle("lab-refused", !sentence.endsWith("of the lab."));
  }

  return element("div", { class: "lab-python" }, ...rows, element("div", { class: "lab-tools" }, status, stop), answers);
}

interface Field {
  label: HTMLLabelElement;
  value(): string;
}

function field(words: string, value: string): Field {
  const input = element("input", { type: "text", class: "lab-field lab-free", size: Math.max(3, value.length), value, "aria-label": words });
  return { label: element("label", { class: "lab-choice" }, element("span", {}, words), input), value: () => input.value.trim() };
}

function select(words: string, options: readonly string[]): Field {
  let chosen = options[0] ?? "";
  const label = choice(words, options.map((value) => ({ value, text: value })), chosen, (value) => (chosen = value));
  return { label, value: () => chosen };
}

const line = (head: string, words: string, ...more: (Node | null)[]): HTMLElement =>
  element("p", {}, element("strong", {}, head), " ", words, ...more);

function verdict({ verdict: found }: Answer): Node | null {
  const law = found as { name: string; stated: string; reason: string } | undefined;
  return law === undefined ? null : line(law.name, law.reason === "" ? law.stated : `${law.stated}: ${law.reason}`);
}

function law({ found }: Answer): Node | null {
  const result = found as { text: string; mathml: string; stated: string; repeats?: string } | undefined;
  if (result === undefined) return null;
  const known = result.repeats ? `; repeats ${result.repeats}` : "";
  return element("div", {}, element("div", { class: "lab-wide-formula" }, result.mathml === "" ? result.text : formula(result.mathml)), element("p", { class: "lab-hint" }, result.stated + known));
}

function closedForm({ closed_form: found }: Answer): Node | null {
  const form = found as { title: string; motion: string; source: string; equations: string[]; constants: { symbol: string; value: string; error: string; unit: string; meaning: string }[] } | undefined;
  if (form === undefined) return null;
  const constants = form.constants.map(({ symbol, value, error, unit, meaning }) =>
    element("tr", {}, element("th", { scope: "row" }, symbol), element("td", { class: "lab-number" }, [value, error === "0" ? "" : `± ${error}`, unit].filter((part) => part !== "").join(" ")), element("td", {}, meaning)));
  return element("div", {}, line(form.title, [form.source, form.motion].filter((part) => part !== "").join(", ")), ...form.equations.map((text) => element("div", { class: "lab-wide-formula" }, formula(text))), element("table", { class: "lab-table" }, ...constants));
}

function orbit({ orbit: found }: Answer): Node | null {
  const result = found as { period: number; kind: string; values: Record<string, number>; points: Record<string, number>[]; multipliers: { real: number; imaginary: number }[] } | undefined;
  if (result === undefined) return null;
  const rows: [string, string][] = [
    ["period", `${result.period.toPrecision(12)} s`],
    ...Object.entries({ ...result.values, ...result.points[0] }).map(([name, value]): [string, string] => [name, value.toPrecision(12)]),
    ["multipliers", result.multipliers.map(({ real, imaginary }) => `${real.toPrecision(6)}${imaginary === 0 ? "" : ` ${imaginary > 0 ? "+" : "−"} ${Math.abs(imaginary).toPrecision(6)} i`}`).join(",  ")],
  ];
  return element("div", {}, line(result.kind, "(observed)"), element("table", { class: "lab-table" }, ...rows.map(([name, value]) => element("tr", {}, element("th", { scope: "row" }, name), element("td", { class: "lab-number" }, value)))));
}

function file({ file: found }: Answer): Node | null {
  const given = found as { name: string; base64: string } | undefined;
  if (given === undefined) return null;
  save(given.name, new Blob([Uint8Array.from(atob(given.base64), (letter) => letter.charCodeAt(0))]));
  return line(given.name, "is among the downloads.");
}
