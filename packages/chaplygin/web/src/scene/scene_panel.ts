/** The scene with its switches and keys. */

import type { Lab } from "../lab";
import type { SceneVector } from "../model";
import { element, toggle } from "../page/dom";
import { formula } from "../page/mathml";
import { readable } from "../page/numbers";
import { unitText } from "../page/units";
import { onSchemeChange, palette } from "../page/palette";
import { changingModes, modeAt } from "../playback/modes";
import { row } from "../playback/motion";
import { modeBar, modeKey } from "../plots/mode_bar";
import { leadsFar } from "./opening_view";
import { bindPointer } from "./pointer";
import { Stage, type Shown } from "./stage";
import { orbited } from "./view";

export interface ScenePanel {
  element: HTMLElement;
  stage: Stage;
  /** Switches of what is shown, by name. */
  switches: HTMLElement;
  /** Draw at the next frame. */
  refresh(): void;
  /** The view of the reader as text for an address; nothing where it is the usual one. */
  choice(): string;
  restore(choice: string): void;
}

/** The scene of a laboratory; null where the browser cannot draw it or the system has none. */
export function scenePanel(lab: Lab): ScenePanel | null {
  const { scene } = lab.model;
  const first = lab.shown.value;
  if (!drawable(lab)) return null;
  const canvas = element("canvas", { class: "lab-canvas", "aria-hidden": true });
  const overlay = element("div", { class: "lab-legend" });
  const note = element("div", { class: "lab-note" });
  const bar = element("div", { class: "lab-timebar", "aria-hidden": true });
  const area = element(
    "div",
    {
      class: "lab-scene",
      tabindex: 0,
      role: "application",
      "aria-label": `${lab.model.title}: the motion in space. Arrow keys turn the view, plus and minus zoom, space plays, question mark lists all keys.`,
    },
    canvas,
    overlay,
    bar,
    note,
  );
  const shown: Shown = {
    trace: true,
    traceOnBody: true,
    inertia: false,
    centre: false,
    follow: leadsFar(scene, first.motion),
    vectors: new Set(scene.vectors.filter(({ column }) => column === "omega").map(({ name }) => name)),
  };
  let stage: Stage;
  try {
    stage = new Stage(canvas, scene, first.surfaces, first.motion, shown);
  } catch {
    return null;
  }
  let due = 0;
  const refresh = (): void => {
    if (due !== 0) return;
    due = requestAnimationFrame(() => {
      due = 0;
      stage.draw(lab.clock.time.value);
    });
  };
  const readings = new Map<string, HTMLElement>();
  let mark: (mode: string) => void = () => {};
  const legend = (): void => {
    const { motion } = lab.shown.value;
    mark(modeAt(changingModes(motion), lab.clock.reading.value));
    for (const vector of scene.vectors) {
      const value = row(motion, vector.column, 3, lab.clock.reading.value);
      const reading = readings.get(vector.name);
      if (reading && value) reading.textContent = `${readable(Math.hypot(...value), 3)} ${unitText(vector.unit)}`;
    }
  };
  const relabel = (): void => {
    readings.clear();
    const colours = palette();
    overlay.replaceChildren(
      ...scene.vectors.flatMap((vector, index) => {
        if (!shown.vectors.has(vector.name)) return [];
        const reading = element("span", { class: "lab-number" });
        readings.set(vector.name, reading);
        const mark = element("span", { class: "lab-arrow", style: `background:${colours.components[index % 3] ?? ""}` });
        return [element("div", {}, mark, symbol(vector), reading)];
      }),
    );
    const end = lab.clock.until;
    const modes = changingModes(lab.shown.value.motion);
    const key = modes.length > 0 ? modeKey(modes, colours) : null;
    mark = key?.now ?? (() => {});
    const strip = key === null ? element("i", { style: `background:linear-gradient(90deg,${colours.time.join(",")})` }) : modeBar(modes, 176, 8, colours);
    const span = element("div", {}, element("span", {}, "t = 0"), strip, element("span", {}, `${readable(end)} s`));
    bar.replaceChildren(...(key === null ? [span] : [key.element, span]));
    const { scale } = stage;
    note.textContent = scale === null ? "" : `${scale.what} ${readable(scale.length)} m`;
    legend();
  };
  const switches = switchesOf(lab, stage, shown, () => {
    relabel();
    refresh();
  });
  bindPointer(area, stage, (moved) => {
    if (moved) switches.dispatchEvent(new CustomEvent("unfollow"));
    refresh();
  });
  bindKeys(area, lab, stage, switches, refresh);
  new ResizeObserver(() => {
    stage.resize(area.clientWidth, area.clientHeight);
    // at once: a canvas that has been resized is blank
    stage.draw(lab.clock.time.value);
  }).observe(area);
  lab.clock.time.after(refresh);
  lab.clock.reading.after(legend);
  lab.shown.after(({ motion, surfaces }) => {
    stage.setMotion(motion, surfaces);
    relabel();
    refresh();
  });
  onSchemeChange(() => {
    stage.recolour();
    relabel();
    refresh();
  });
  relabel();
  refresh();
  const restore = (choice: string): void => {
    const moved = stage.restoreView(choice);
    if (moved !== null && moved === shown.follow) switches.querySelector<HTMLButtonElement>('[data-key="f"]')?.click();
    refresh();
  };
  return { element: area, stage, switches, refresh, choice: () => stage.viewChoice, restore };
}

/** Whether the system has something to be drawn in space. */
export function drawable(lab: Lab): boolean {
  const { columns } = lab.shown.value.motion;
  const { body, links, path } = lab.model.scene;
  // the attitude of a body in n dimensions is no picture
  return columns["contact"] !== undefined || path !== null || ((body !== null || links.length > 0) && columns["attitude"] !== undefined);
}

function symbol(vector: SceneVector): Node {
  return vector.mathml ? formula(vector.mathml) : document.createTextNode(vector.name);
}

function switchesOf(lab: Lab, stage: Stage, shown: Shown, changed: () => void): HTMLElement {
  const { scene } = lab.model;
  const bar = element("div", { class: "lab-switches", role: "toolbar", "aria-label": "What is shown" });
  const add = (face: string | Node, label: string, key: string, on: boolean, act: (on: boolean) => void): HTMLButtonElement => {
    const made = toggle(face, `${label} (${key})`, on, (next) => {
      act(next);
      changed();
    });
    made.dataset["key"] = key;
    bar.append(made);
    return made;
  };
  const { columns } = lab.shown.value.motion;
  // a body about a fixed point goes nowhere
  if (scene.path !== null || columns["contact"] !== undefined || columns["centre"] !== undefined) {
    const follow = add("follow", "Keep the body in the middle", "f", shown.follow, (on) => (shown.follow = on));
    bar.addEventListener("unfollow", () => {
      shown.follow = false;
      follow.setAttribute("aria-pressed", "false");
    });
    add("path", "Path on the ground", "p", shown.trace, (on) => (shown.trace = on));
  }
  const hasBody = scene.path === null && (scene.inertia_axes !== null || lab.shown.value.surfaces.body !== null);
  if (hasBody && columns["contact"] !== undefined) {
    add("trace", "Trace of the contact on the body", "t", shown.traceOnBody, (on) => (shown.traceOnBody = on));
  }
  scene.vectors.forEach((vector, index) => {
    if (stage.vectorScale(vector.name) === 0) return;
    const on = shown.vectors.has(vector.name);
    add(symbol(vector), `Vector ${vector.name}`, String(index + 1), on, (next) => {
      const names = new Set(shown.vectors);
      if (next) names.add(vector.name);
      else names.delete(vector.name);
      shown.vectors = names;
    });
  });
  if (scene.inertia_axes !== null && scene.body !== null) {
    add("inertia", "Inertia ellipsoid", "i", shown.inertia, (on) => (shown.inertia = on));
  }
  if (hasBody) add("centre", "Centre of mass", "c", shown.centre, (on) => (shown.centre = on));
  const reset = element("button", { type: "button", title: "Whole view (r)", "data-key": "r" }, "whole view");
  reset.addEventListener("click", () => {
    stage.reset();
    changed();
  });
  bar.append(reset);
  return bar;
}

/** Keys of the scene, for help. */
export const SCENE_KEYS: readonly (readonly [keys: string, what: string])[] = [
  ["space", "play or pause"],
  ["← →, ↑ ↓", "turn the view"],
  [", .", "one sample back, on"],
  ["Home, End", "to the start, to the end"],
  ["[ ]", "slower, faster"],
  ["+ −", "nearer, farther"],
  ["f", "keep the body in the middle"],
  ["p, t", "path on the ground, trace on the body"],
  ["1 2 3", "vectors"],
  ["i, c", "inertia ellipsoid, centre of mass"],
  ["r", "whole view"],
  ["Ctrl+Z, Ctrl+Shift+Z", "undo, redo"],
];

function bindKeys(area: HTMLElement, lab: Lab, stage: Stage, switches: HTMLElement, refresh: () => void): void {
  const { clock } = lab;
  const turn = (right: number, down: number): void => {
    stage.view = orbited(stage.view, right, down);
    refresh();
  };
  const zoom = (factor: number): void => {
    stage.zoom(factor);
    refresh();
  };
  const sample = (by: number): void => {
    const { times } = lab.shown.value.motion;
    clock.pause();
    clock.seek(clock.time.value + by * ((times[1] ?? 0) - (times[0] ?? 0)));
  };
  const acts: Record<string, () => void> = {
    " ": () => clock.toggle(),
    ArrowLeft: () => turn(-0.04, 0),
    ArrowRight: () => turn(0.04, 0),
    ArrowUp: () => turn(0, -0.04),
    ArrowDown: () => turn(0, 0.04),
    ",": () => sample(-1),
    ".": () => sample(1),
    Home: () => clock.seek(0),
    End: () => clock.seek(clock.until),
    "[": () => clock.changeSpeed(-1),
    "]": () => clock.changeSpeed(1),
    "+": () => zoom(1 / 1.15),
    "=": () => zoom(1 / 1.15),
    "-": () => zoom(1.15),
  };
  area.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = acts[event.key];
    const switch_ = switches.querySelector<HTMLButtonElement>(`[data-key="${CSS.escape(event.key.toLowerCase())}"]`);
    if (act === undefined && switch_ === null) return;
    event.preventDefault();
    if (act !== undefined) act();
    else switch_?.click();
  });
}
