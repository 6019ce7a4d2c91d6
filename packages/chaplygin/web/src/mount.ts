/** Puts a laboratory into an element of a page. */

import { bifurcationPanel } from "./bifurcation/bifurcation_panel";
import { chartPanel } from "./chart/chart_panel";
import { experimentPanel } from "./controls/experiment_panel";
import { downloadsPanel } from "./downloads/downloads_panel";
import { computed, Lab, recordedMotion, type Shown } from "./lab";
import { surfacesOf } from "./engine/surfaces";
import { lawReadings, lawsPanel, type LawReading } from "./laws/laws_panel";
import { element } from "./page/dom";
import { fromFragment, instants, opening, type Experiment } from "./page/experiment";
import { help } from "./page/help";
import { permalink } from "./page/permalink";
import { tabs, type Panel } from "./page/tabs";
import { plotsPanel } from "./plots/plots_panel";
import { pose, type Pose } from "./playback/motion";
import { transport } from "./playback/transport";
import { drawable, scenePanel } from "./scene/scene_panel";
import { sectionPanel } from "./section/section_panel";
import { pythonPanel } from "./python/python_panel";
import { askOf } from "./sources/ask";
import { engineOf, type Ask, type Source } from "./sources/source";
import { installStyle } from "./style/install";

/** What a test, or a program in the page, may do with a mounted laboratory. */
export interface PageHandle {
  /** Settled when the first motion is shown. */
  ready: Promise<void>;
  seek(t: number): void;
  pose(): Pose;
  set(change: { parameters?: Record<string, number>; start?: Record<string, number> | number[] }): Promise<void>;
  motion(until: number, samples: number): Promise<Record<string, number[]>>;
  section(choice: { on: string; direction: -1 | 0 | 1; points: number; value?: number }): Promise<number[][]>;
  laws(): LawReading[];
}

declare global {
  interface Window {
    chaplygin?: PageHandle;
  }
}

/** Mount a laboratory with a source in an element; what the element holds stays as the still for print. */
export function mount(target: HTMLElement, source: Source): PageHandle {
  installStyle(target);
  const holder = element("div", { class: "lab-root" });
  target.append(holder);
  let lab: Lab | null = null;
  const ready = open(source).then((opened) => {
    ({ lab } = opened);
    build(target, holder, opened, askOf(source));
  });
  ready.catch((why: unknown) => {
    holder.replaceChildren(element("p", { class: "lab-message lab-refused", role: "alert" }, why instanceof Error ? why.message : String(why)));
  });
  const handle = handleOf(ready, () => lab);
  window.chaplygin = handle;
  return handle;
}

/** A laboratory, and what the address says of how it is seen. */
interface Opened {
  lab: Lab;
  choices: Record<string, string>;
}

/** The laboratory with its first motion: that of the address, or that of the model. */
async function open(source: Source): Promise<Opened> {
  const { model } = source;
  const engine = engineOf(source);
  const asked = engine === null ? null : fromFragment(location.hash, model);
  const wanted = asked?.experiment ?? opening(model);
  let note = "";
  if (asked === null && location.hash.startsWith("#lab&")) {
    note = "The address asks for values that this system does not have; the page shows its own start.";
  }
  let first: Shown | string;
  if (asked === null && model.recorded !== null) {
    // what the page holds is seen at once
    first = { experiment: wanted, motion: recordedMotion(model), state: Float64Array.from(model.start), surfaces: surfacesOf(model) };
  } else first = await computed(model, engine, wanted);
  if (typeof first === "string") {
    note = first;
    const usual = await computed(model, engine, opening(model));
    if (typeof usual === "string") throw new Error(usual);
    first = usual;
  }
  const lab = new Lab(model, engine, first);
  if (note !== "") lab.say(note, true);
  const t = Number(asked?.choices["t"]);
  if (Number.isFinite(t)) lab.clock.seek(t);
  return { lab, choices: asked?.choices ?? {} };
}

function build(target: HTMLElement, holder: HTMLElement, { lab, choices }: Opened, ask: Ask | null): void {
  const scene = scenePanel(lab);
  if (scene !== null) target.classList.add("lab-live");
  const full = (): void => {
    if (document.fullscreenElement !== null) void document.exitFullscreen();
    else void holder.requestFullscreen().catch(() => lab.say("This browser shows no full screen here.", true));
  };
  const message = element("p", { class: "lab-message", role: "status", "aria-live": "polite" });
  lab.message.watch((sentence) => {
    message.textContent = sentence;
    message.classList.toggle("lab-refused", lab.refused.value);
  });
  const plots = plotsPanel(lab);
  const pictures: Panel[] = [{ name: "plots", title: "Over time", content: plots.element }];
  const section = sectionPanel(lab);
  if (section !== null) pictures.push({ name: "section", title: "Section", content: section.element, shown: () => section.shown() });
  const chart = chartPanel(lab, section);
  if (chart !== null) pictures.push({ name: "chart", title: "Chart", content: chart.element, shown: () => chart.shown() });
  const bifurcation = bifurcationPanel(lab, ask);
  if (bifurcation !== null) pictures.push({ name: "bifurcation", title: "Bifurcation diagram", content: bifurcation.element, shown: () => bifurcation.shown() });
  const values: Panel[] = [{ name: "experiment", title: "Start and parameters", content: experimentPanel(lab) }];
  const laws = lawsPanel(lab);
  if (laws !== null) values.push({ name: "laws", title: "Laws", content: laws });
  let picture = "";
  const address = permalink(lab, holder, () => ({ view: scene?.choice() ?? "", section: section?.choice() ?? "", show: picture }));
  const downloads = downloadsPanel({ lab, scene, plots, section, address });
  if (ask !== null) values.push({ name: "python", title: "Python", content: pythonPanel(ask, lab) });
  values.push({ name: "downloads", title: "Save", content: downloads }, { name: "keys", title: "Keys", content: help() });
  const view = element("div", { class: "lab-view" }, scene?.element ?? null, transport(lab, full), scene?.switches ?? null, message);
  const deck = tabs("Pictures", pictures, (name) => (picture = name === pictures[0]?.name ? "" : name));
  holder.append(view, tabs("Values", values).element, deck.element);
  if (choices["view"] !== undefined) scene?.restore(choices["view"]);
  if (choices["section"] !== undefined) section?.restore(choices["section"]);
  if (choices["show"] !== undefined) deck.select(choices["show"]);
  holder.addEventListener("keydown", (event) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    event.preventDefault();
    void (event.shiftKey ? lab.redo() : lab.undo());
  });
  if (scene === null && drawable(lab) && lab.message.value === "") {
    lab.say("This browser draws no scene, as it offers no WebGL; everything else works.");
  }
}

function handleOf(ready: Promise<void>, current: () => Lab | null): PageHandle {
  const there = (): Lab => {
    const lab = current();
    if (lab === null) throw new Error("The page is not ready yet: wait for chaplygin.ready.");
    return lab;
  };
  return {
    ready,
    seek(t) {
      there().clock.pause();
      there().clock.seek(t);
    },
    pose: () => pose(there().shown.value.motion, there().clock.time.value),
    async set({ parameters, start }) {
      const lab = there();
      const now = lab.wanted.value;
      const next: Experiment = { ...now, parameters: { ...now.parameters, ...parameters } };
      if (Array.isArray(start)) next.start = { state: start };
      else if (start !== undefined) next.start = { inputs: { ...("inputs" in now.start ? now.start.inputs : {}), ...start } };
      if (!(await lab.change(next)) && lab.refused.value) throw new Error(lab.message.value);
    },
    async motion(until, samples) {
      const lab = there();
      const { motion, state, experiment } = lab.shown.value;
      if (lab.engine === null || state === null) return lists(motion.times, motion.columns);
      const task = { parameters: experiment.parameters, start: state, times: instants(until, samples) };
      const answer = await lab.engine.motion(task);
      return lists(answer.times, answer.columns);
    },
    async section(choice) {
      const lab = there();
      const { state, experiment } = lab.shown.value;
      if (lab.engine === null || state === null) throw new Error("This page shows a recorded motion and cannot compute a section.");
      const { rows, dimension } = await lab.engine.section({ parameters: experiment.parameters, start: state, ...choice });
      return Array.from({ length: rows.length / dimension }, (_, k) => Array.from(rows.subarray(k * dimension, (k + 1) * dimension)));
    },
    laws: () => lawReadings(there(), there().clock.time.value),
  };
}

function lists(times: Float64Array, columns: Record<string, Float64Array>): Record<string, number[]> {
  const all = Object.entries(columns).map(([name, values]) => [name, Array.from(values)]);
  return { time: Array.from(times), ...Object.fromEntries(all) };
}
