/** Bifurcation diagram: a click on the values of two integrals shows a motion on that torus. */

import { experimentText } from "../downloads/downloads_panel";
import type { Lab } from "../lab";
import type { Bifurcation } from "../model";
import { element } from "../page/dom";
import { plain } from "../page/mathml";
import { extent, readable, readableOn } from "../page/numbers";
import { palette } from "../page/palette";
import { unitText } from "../page/units";
import { sentence } from "../section/points";
import { Sheet, type Place } from "../sheet/sheet";
import type { Ask } from "../sources/source";
import { frequencies, type Frequency } from "./frequencies";
import type { Frame, Range } from "../sheet/frame";

export interface BifurcationPanel {
  element: HTMLElement;
  shown(): void;
}

/** The panel; null where the model has no diagram. */
export function bifurcationPanel(lab: Lab, ask: Ask | null): BifurcationPanel | null {
  const { bifurcation } = lab.model;
  return bifurcation === null ? null : new Panel(lab, bifurcation, ask);
}

const USE = "Over each region the motions fill tori; on the curves lie the special motions: stable on the solid ones, unstable on the broken ones. A click shows a motion with these values of the integrals; the ring is where the motion of the scene lies.";

/** States of the motion in the scene from which another is looked for. */
const REFERENCES = 12;

class Panel implements BifurcationPanel {
  readonly element: HTMLElement;
  private readonly sheet: Sheet;
  /** The values of both integrals for the motion in the scene. */
  private point: Place | null = null;
  private visible = false;
  /** The parameters of the curves, as text. */
  private known = parametersOf({});
  private stale = false;
  private running: AbortController | null = null;
  private readonly note = element("p", { class: "lab-hint" }, USE);
  private readonly figures = element("div", { class: "lab-answers", role: "status", "aria-live": "polite" });

  constructor(
    private readonly lab: Lab,
    private diagram: Bifurcation,
    private readonly ask: Ask | null,
  ) {
    this.sheet = new Sheet({
      label: `Bifurcation diagram: ${diagram.x} across, ${diagram.y} up. Arrow keys move a cross, Enter shows a motion with these values.`,
      paint: (pen, frame) => this.paint(pen, frame),
      click: (place) => void this.start(place),
      hover: (place, frame) => this.hover(place, frame),
      marks: (pen, frame) => this.marks(pen, frame),
      whole: () => this.whole(),
    });
    this.element = element("div", {}, this.sheet.element, this.note, this.figures);
    this.axes();
    lab.shown.after(() => void this.follow());
  }

  shown(): void {
    this.visible = true;
    void this.follow();
  }

  private axes(): void {
    const { x, y } = this.whole();
    this.sheet.setAxes({ range: x, label: this.label(this.diagram.x) }, { range: y, label: this.label(this.diagram.y) });
  }

  /** Mark the motion of the scene; with Python behind the page, its frequencies and the curves of its parameters. */
  private async follow(): Promise<void> {
    if (!this.visible) return;
    await this.locate();
    const { experiment } = this.lab.shown.value;
    this.stale = parametersOf(experiment.parameters) !== this.known;
    if (!this.stale) this.note.textContent = USE;
    else if (this.ask !== null) this.note.textContent = "The curves of the parameters of the motion in the scene are being computed …";
    else this.note.textContent = "These curves belong to the parameters with which the page opened, not to those of the motion in the scene; chaplygin lab draws them anew.";
    this.sheet.repaint();
    const { ask, lab } = this;
    if (ask === null) {
      this.figures.replaceChildren(element("p", { class: "lab-hint" }, "The frequencies of the closed form are shown in the laboratory: chaplygin lab, or in a notebook."));
      return;
    }
    this.running?.abort();
    const control = new AbortController();
    this.running = control;
    this.figures.replaceChildren(element("p", { class: "lab-hint" }, "asking for the closed form …"));
    const subject = { what: lab.model.name, experiment: experimentText(lab) };
    try {
      if (this.stale) await this.renew(ask, subject, parametersOf(experiment.parameters), control.signal);
      const found = await frequencies(ask, subject.what, subject.experiment, control.signal);
      if (control.signal.aborted) return;
      this.figures.replaceChildren(typeof found === "string" ? element("p", { class: "lab-hint" }, found) : table(found.motion, found.list));
    } catch (why) {
      if (!control.signal.aborted) this.figures.replaceChildren(element("p", { class: "lab-hint lab-refused" }, why instanceof Error ? why.message : String(why)));
    }
  }

  private async renew(ask: Ask, subject: object, parameters: string, signal: AbortSignal): Promise<void> {
    await ask({ do: "bifurcation", subject }, (answer) => {
      const diagram = answer["bifurcation"] as Bifurcation | null | undefined;
      if (diagram === undefined || diagram === null || signal.aborted) return;
      this.diagram = diagram;
      this.known = parameters;
      this.stale = false;
      this.note.textContent = USE;
      this.axes();
    }, signal);
  }

  private label(name: string): string {
    const quantity = this.lab.model.quantities.find((each) => each.name === name);
    const letters = quantity?.mathml ? plain(quantity.mathml) : name;
    const unit = unitText(quantity?.unit ?? "1");
    return unit ? `${letters}  (${unit})` : letters;
  }

  private whole(): { x: Range; y: Range } {
    const { curves } = this.diagram;
    return { x: extent(curves.flatMap(({ x }) => x)), y: extent(curves.flatMap(({ y }) => y)) };
  }

  private async locate(): Promise<void> {
    const { engine, model } = this.lab;
    const { state, experiment } = this.lab.shown.value;
    if (engine === null || state === null) return;
    const values = await engine.quantities(experiment.parameters, state.slice(0, model.reduced), model.reduced);
    const of = (name: string): number => values[model.quantities.findIndex((each) => each.name === name)] ?? NaN;
    this.point = { x: of(this.diagram.x), y: of(this.diagram.y) };
    this.sheet.mark();
  }

  private paint(pen: CanvasRenderingContext2D, frame: Frame): void {
    const colours = palette();
    pen.save();
    pen.beginPath();
    pen.rect(frame.right(frame.x.range[0]), frame.down(frame.y.range[1]), frame.innerWidth, frame.innerHeight);
    pen.clip();
    const kinds = [...new Set(this.diagram.curves.map(({ label }) => label))];
    this.diagram.curves.forEach(({ x, y, label, stable }) => {
      pen.strokeStyle = colours.series[Math.max(0, kinds.indexOf(label)) % colours.series.length] ?? colours.ink;
      pen.lineWidth = 1.8;
      pen.globalAlpha = this.stale ? 0.35 : 1;
      pen.setLineDash(stable ? [] : [6, 3.5]);
      pen.beginPath();
      x.forEach((value, n) => {
        const [right, down] = [frame.right(value), frame.down(y[n] ?? NaN)];
        if (n === 0) pen.moveTo(right, down);
        else pen.lineTo(right, down);
      });
      pen.stroke();
    });
    pen.restore();
  }

  private marks(pen: CanvasRenderingContext2D, frame: Frame): void {
    if (this.point === null) return;
    pen.strokeStyle = palette().ink;
    pen.fillStyle = palette().paper;
    pen.lineWidth = 2;
    pen.beginPath();
    pen.arc(frame.right(this.point.x), frame.down(this.point.y), 5, 0, 2 * Math.PI);
    pen.fill();
    pen.stroke();
  }

  private hover(place: Place, frame: Frame): string | null {
    let near: { label: string; far: number } | null = null;
    for (const { label, x, y } of this.diagram.curves) {
      x.forEach((value, n) => {
        const far = Math.hypot(frame.right(value) - frame.right(place.x), frame.down(y[n] ?? NaN) - frame.down(place.y));
        if (far < 8 && (near === null || far < near.far)) near = { label, far };
      });
    }
    const where = `${plain(this.label(this.diagram.x))} = ${readableOn(frame.x.range, place.x)}, ${this.label(this.diagram.y)} = ${readableOn(frame.y.range, place.y)}`;
    return near === null ? where : `${where}: ${(near as { label: string }).label}`;
  }

  /** Show a motion with these values of both integrals, reached from a state of the motion in the scene. */
  private async start(place: Place): Promise<void> {
    const { engine } = this.lab;
    const { state, experiment, motion } = this.lab.shown.value;
    if (engine === null || state === null) return this.lab.say("This page shows a recorded motion and cannot compute another.", true);
    const { x, y } = this.diagram;
    const { states } = motion;
    const count = motion.times.length;
    const references = [state];
    if (states !== undefined) {
      const width = states.length / count;
      for (let k = 1; k < REFERENCES; k++) {
        const sample = Math.floor((k * count) / REFERENCES);
        references.push(states.slice(sample * width, (sample + 1) * width));
      }
    }
    let refused = "";
    for (const reference of references) {
      const section = { on: null, direction: 0 as const, x, y };
      const found = await engine.startOnLevel({ parameters: experiment.parameters, reference, section, x: place.x, y: place.y });
      if ("message" in found) {
        refused ||= found.message;
        continue;
      }
      await this.lab.change({ ...this.lab.wanted.value, start: { state: Array.from(found.state) } });
      this.lab.clock.seek(0);
      return;
    }
    this.lab.say(`${sentence(refused)} Where no torus lies over a point of the diagram there is no motion.`, true);
  }
}

function parametersOf(parameters: Readonly<Record<string, number>>): string {
  return JSON.stringify(Object.entries(parameters).sort(([a], [b]) => (a < b ? -1 : 1)));
}

function table(motion: string, list: readonly Frequency[]): HTMLElement {
  const rows = list.map(({ symbol, value, unit, meaning }) =>
    element("tr", {}, element("th", { scope: "row" }, symbol), element("td", { class: "lab-number" }, `${readable(Number(value), 10)} ${unit}`.trim()), element("td", {}, meaning)));
  return element("div", {}, element("p", {}, `Closed form: ${motion}`), element("table", { class: "lab-table" }, ...rows));
}
