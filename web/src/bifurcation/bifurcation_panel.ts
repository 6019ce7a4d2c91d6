/** Bifurcation diagram: a click on the values of two integrals shows a motion on that torus. */

import type { Lab } from "../lab";
import type { Bifurcation } from "../model";
import { element } from "../page/dom";
import { plain } from "../page/mathml";
import { extent, readable } from "../page/numbers";
import { palette } from "../page/palette";
import { unitText } from "../page/units";
import { Sheet, type Place } from "../sheet/sheet";
import type { Frame, Range } from "../sheet/frame";

export interface BifurcationPanel {
  element: HTMLElement;
  shown(): void;
}

/** The panel; null where the model has no diagram. */
export function bifurcationPanel(lab: Lab): BifurcationPanel | null {
  const { bifurcation } = lab.model;
  return bifurcation === null ? null : new Panel(lab, bifurcation);
}

class Panel implements BifurcationPanel {
  readonly element: HTMLElement;
  private readonly sheet: Sheet;
  /** The values of both integrals for the motion in the scene. */
  private point: Place | null = null;
  private visible = false;

  constructor(
    private readonly lab: Lab,
    private readonly diagram: Bifurcation,
  ) {
    this.sheet = new Sheet({
      label: `Bifurcation diagram: ${diagram.x} across, ${diagram.y} up. Arrow keys move a cross, Enter shows a motion with these values.`,
      paint: (pen, frame) => this.paint(pen, frame),
      click: (place) => void this.start(place),
      hover: (place, frame) => this.hover(place, frame),
      marks: (pen, frame) => this.marks(pen, frame),
      whole: () => this.whole(),
    });
    this.element = element("div", {}, this.sheet.element, element("p", { class: "lab-hint" }, "Over each region the motions fill tori; on the curves lie the special motions. A click shows a motion with these values of the integrals; its ring is where the motion of the scene lies."));
    const { x, y } = this.whole();
    this.sheet.setAxes({ range: x, label: this.label(diagram.x) }, { range: y, label: this.label(diagram.y) });
    lab.shown.after(() => void this.locate());
  }

  shown(): void {
    this.visible = true;
    void this.locate();
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
    if (!this.visible || engine === null || state === null) return;
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
    this.diagram.curves.forEach(({ x, y }, k) => {
      pen.strokeStyle = colours.series[k % colours.series.length] ?? colours.ink;
      pen.lineWidth = 1.8;
      pen.setLineDash([[], [7, 3], [2, 3]][k % 3] ?? []);
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
    const where = `${plain(this.label(this.diagram.x))} = ${readable(place.x)}, ${this.label(this.diagram.y)} = ${readable(place.y)}`;
    return near === null ? where : `${where}: ${(near as { label: string }).label}`;
  }

  /** Show a motion with these values of both integrals, reached from the motion in the scene. */
  private async start(place: Place): Promise<void> {
    const { engine, model } = this.lab;
    const { state, experiment } = this.lab.shown.value;
    if (engine === null || state === null) return this.lab.say("This page shows a recorded motion and cannot compute another.", true);
    const values = await engine.quantities(experiment.parameters, state.slice(0, model.reduced), model.reduced);
    const { x, y } = this.diagram;
    // a number of the state that stays as it is: the two integrals are reached by the others
    const held = model.quantities.findIndex(({ name }) => name !== x && name !== y);
    const on = model.quantities[held];
    if (on === undefined) return;
    const section = { on: on.name, value: values[held] ?? 0, direction: 0 as const, x, y };
    const found = await engine.startOnLevel({ parameters: experiment.parameters, reference: state, section, x: place.x, y: place.y });
    if ("message" in found) return this.lab.say(`No motion with these values was found from the one in the scene: ${found.message}.`, true);
    await this.lab.change({ ...this.lab.wanted.value, start: { state: Array.from(found.state) } });
    this.lab.clock.seek(0);
  }
}
