/** Poincaré section: a click starts an orbit, a drag scans, a box enlarges. */

import type { State } from "../engine/engine";
import type { Lab } from "../lab";
import type { Quantity } from "../model";
import { element, painted } from "../page/dom";
import { megnoColour, megnoWords } from "../page/indicator";
import { plain } from "../page/mathml";
import { extent, readableBeside } from "../page/numbers";
import { indicatorScale, palette } from "../page/palette";
import { SpareEngine } from "../sources/workers";
import { unitText } from "../page/units";
import { along, letters, paintMarks, paintPoints, passingPlane, same, sentence, sizes, spreadPlane } from "./points";
import { sectionTools, settingOf, settingText, type SectionTools } from "./tools";
import { Sheet, type Place } from "../sheet/sheet";
import type { Frame, Range } from "../sheet/frame";
import { crossings, longer, nearest, nearestState, quantityIndex, sectionPieces, type Orbit, type SectionSetting } from "./orbits";

const SCAN = 12;

export interface SectionPanel {
  element: HTMLElement;
  sheet: Sheet;
  /** The panel has come into sight. */
  shown(): void;
  /** Settled when the section of the motion in the scene is known. */
  prepared(): Promise<void>;
  orbits(): readonly Orbit[];
  setting(): SectionSetting;
  /** The plane, where the reader has chosen it, as text for an address; else nothing. */
  choice(): string;
  restore(choice: string): void;
}

/** The panel; null where there is nothing to compute sections with. */
export function sectionPanel(lab: Lab): SectionPanel | null {
  const { engine, model } = lab;
  if (engine === null || model.section === null) return null;
  return new Panel(lab, new SpareEngine(model), { ...model.section });
}

class Panel implements SectionPanel {
  readonly element: HTMLElement;
  readonly sheet: Sheet;
  private list: Orbit[] = [];
  private points = 1000;
  private byIndicator = false;
  private serial = 0;
  /** Counts what makes earlier orbits wrong: another level, other parameters, another plane. */
  private era = 0;
  /** Time in which a motion has so many points, with much to spare. */
  private longest = Infinity;
  private placed = false;
  private opening: Promise<void> = Promise.resolve();
  /** Whether the reader has chosen the plane. */
  private own = false;
  private current = "";
  private hovered: Orbit | null = null;
  private visible = false;
  private readonly tools: SectionTools;
  private readonly entries = element("div", { class: "lab-orbits", role: "group", "aria-label": "Orbits" });
  private readonly key = element("div", { class: "lab-key", hidden: true });

  constructor(
    private readonly lab: Lab,
    private readonly engines: SpareEngine,
    private chosen: SectionSetting,
  ) {
    this.sheet = new Sheet({
      label: "Poincaré section. Arrow keys move a cross, Enter starts an orbit there, plus and minus zoom, 0 shows all.",
      paint: (pen, frame, ratio) => this.paint(pen, frame, ratio),
      click: (place) => void this.start([place]),
      drag: (from, to) => void this.start(along(from, to, SCAN)),
      hover: (place, frame) => this.hover(place, frame),
      marks: (pen, frame) => this.marks(pen, frame),
      whole: () => this.whole(),
      keys: { Backspace: () => this.remove(this.list.at(-1)), Delete: () => this.remove(this.list.at(-1)) },
    });
    this.tools = sectionTools(lab, chosen, this.points, {
      change: (part) => this.choose({ ...this.chosen, ...part }),
      points: (count) => (this.points = count),
      indicator: (isOn) => this.colourBy(isOn),
      box: (isOn) => (this.sheet.boxing = isOn),
      zoom: (factor) => this.sheet.zoom(factor),
      all: () => this.sheet.showAll(),
      clear: () => this.clear(),
    });
    this.element = element("div", {}, this.tools.element, this.sheet.element, this.key, this.entries);
    lab.shown.after(() => this.follow());
    this.axes({ x: [-1, 1], y: [-1, 1] });
  }

  shown(): void {
    this.visible = true;
    this.follow();
  }

  async prepared(): Promise<void> {
    this.shown();
    await this.opening;
  }

  orbits(): readonly Orbit[] {
    return this.list;
  }

  setting(): SectionSetting {
    return this.chosen;
  }

  choice(): string {
    return this.own ? settingText(this.chosen) : "";
  }

  restore(text: string): void {
    const setting = settingOf(text, this.lab.model);
    if (setting === null) return;
    this.placed = true;
    this.tools.write(setting);
    this.choose(setting);
  }

  private choose(setting: SectionSetting): void {
    this.own = true;
    this.chosen = setting;
    this.clear();
  }

  private quantity(name: string): Quantity | undefined {
    return this.lab.model.quantities.find((each) => each.name === name);
  }

  private axes({ x, y }: { x: Range; y: Range }): void {
    const label = (name: string): string => {
      const quantity = this.quantity(name);
      if (quantity === undefined) return name;
      const unit = unitText(quantity.unit);
      return `${letters(quantity)}${unit ? `  (${unit})` : ""}`;
    };
    this.sheet.setAxes({ range: x, label: label(this.chosen.x) }, { range: y, label: label(this.chosen.y) });
  }

  private clear(): void {
    this.list = [];
    this.serial = 0;
    this.next();
    this.current = "";
    this.follow();
    this.entries.replaceChildren();
    this.sheet.repaint();
  }

  /** Show the orbit of the motion in the scene, unless it is there. */
  private follow(): void {
    const { state, experiment } = this.lab.shown.value;
    if (!this.visible || state === null) return;
    const id = JSON.stringify([experiment.parameters, Array.from(state)]);
    if (id === this.current) return;
    const known = this.list.some((orbit) => same(orbit.start, state)) && this.current.startsWith(`[${JSON.stringify(experiment.parameters)}`);
    this.current = id;
    if (known) return this.mark();
    this.list = [];
    this.serial = 0;
    this.next();
    this.opening = this.open(state);
  }

  /** Show the section of a motion; the first time, where the motion passes. */
  private async open(state: Float64Array): Promise<void> {
    const { era } = this;
    const { motion, experiment } = this.lab.shown.value;
    const { model } = this.lab;
    const { states } = motion;
    if (states === undefined) return void this.trace(state, true);
    const all = await this.engines.engine.quantities(experiment.parameters, states, states.length / motion.times.length);
    if (era !== this.era) return;
    const width = model.quantities.length;
    const column = (name: string): Float64Array => {
      const index = quantityIndex(model, name);
      return Float64Array.from(motion.times, (_, k) => all[k * width + index] ?? NaN);
    };
    const passes = (on: string, value: number): number =>
      crossings(column(on), value, this.chosen.direction, model.quantities[quantityIndex(model, on)]?.angle === true);
    const opening = !this.placed;
    this.placed = true;
    if (opening) {
      this.chosen = passingPlane(model, this.chosen, column, passes);
      this.axes({ x: [-1, 1], y: [-1, 1] });
      this.tools.write(this.chosen);
    }
    const span = motion.times.at(-1) ?? 1;
    const count = passes(this.chosen.on, this.chosen.value);
    this.longest = count === 0 ? 20 * span : (5 * span * Math.max(this.points, 1000)) / count;
    const orbit = await this.trace(state, true);
    if (orbit !== null && opening && this.spread(orbit)) await this.opening;
  }

  /** Choose other quantities than those that a section holds constant, such as the longitude at γ₁ = 0. */
  private spread(orbit: Orbit): boolean {
    const plane = spreadPlane(this.lab.model, this.chosen, orbit);
    if (plane === this.chosen) return false;
    this.chosen = plane;
    this.tools.write(plane);
    this.clear();
    return true;
  }

  /** What is still being computed is of no use any more. */
  private next(): void {
    this.era += 1;
    this.engines.renew();
  }

  private mark(): void {
    this.writeEntries();
    this.sheet.mark();
  }

  /** Start an orbit at each of some places, on the level of the motion in the scene. */
  private async start(places: readonly Place[]): Promise<void> {
    const { state, experiment } = this.lab.shown.value;
    if (state === null) return;
    const { era } = this;
    const { on, value, direction, x, y } = this.chosen;
    let refused = "";
    for (const place of places) {
      const [[left, right], [low, high]] = [this.sheet.frame.x.range, this.sheet.frame.y.range];
      const near = nearestState(this.list, this.lab.model.reduced, place, right - left, high - low);
      const found: State | null = await this.engines.engine.startOnLevel({
        parameters: experiment.parameters,
        // from a point that is on the section the way is shortest
        reference: near ?? state,
        section: { on, value, direction, x, y },
        x: place.x,
        y: place.y,
      }).catch(() => null);
      if (era !== this.era || found === null) return;
      if ("message" in found) {
        refused = found.message;
        continue;
      }
      await this.trace(found.state, false, place);
      const isLast = place === places.at(-1);
      // the points are seen first: to draw the scene anew takes longer than to compute them
      if (isLast) await painted();
      if (era !== this.era) return;
      if (isLast) void this.play(found.state);
    }
    if (refused !== "") this.lab.say(sentence(refused), true);
  }

  /** Show the motion of an orbit in the scene. */
  private async play(start: Float64Array): Promise<void> {
    const { lab } = this;
    const { parameters } = lab.shown.value.experiment;
    this.current = JSON.stringify([parameters, Array.from(start)]);
    this.mark();
    if (await lab.change({ ...lab.wanted.value, start: { state: Array.from(start) } })) lab.clock.seek(0);
  }

  /** Compute an orbit, piece by piece; the picture grows as it goes. */
  private async trace(start: Float64Array, first: boolean, place: Place | null = null): Promise<Orbit | null> {
    const { era } = this;
    const { parameters } = this.lab.shown.value.experiment;
    let orbit: Orbit = { start, x: new Float64Array(0), y: new Float64Array(0), rows: new Float64Array(0), number: this.serial, until: 0, indicator: null };
    if (place !== null) orbit = longer(orbit, { x: Float64Array.of(place.x), y: Float64Array.of(place.y), rows: orbit.rows, time: 0 });
    this.serial += 1;
    this.list.push(orbit);
    this.writeEntries();
    try {
      for await (const piece of sectionPieces(this.engines.engine, this.lab.model, parameters, this.chosen, start, this.points, this.longest)) {
        if (era !== this.era) return null;
        const index = this.list.indexOf(orbit);
        if (index < 0) return null;
        const before = orbit.x.length;
        orbit = longer(orbit, piece);
        this.list[index] = orbit;
        if (first && before === 0) this.axes(this.whole());
        else this.add(orbit, before);
        if (piece.end !== null && piece.x.length === 0) this.lab.say(`The motion has no point of this section: ${piece.end}.`, true);
      }
    } catch (why) {
      if (era !== this.era) return null;
      this.lab.say(sentence(why instanceof Error ? why.message : String(why)), true);
      return null;
    }
    this.writeEntries();
    if (this.byIndicator) void this.judge(orbit);
    return orbit;
  }

  private colourBy(isOn: boolean): void {
    this.byIndicator = isOn;
    this.key.hidden = !isOn;
    const scale = element("i", { style: `background:linear-gradient(90deg,${indicatorScale().join(",")})` });
    this.key.replaceChildren(element("span", {}, "MEGNO to about 2, regular"), scale, element("span", {}, "32 and more, chaotic"));
    this.sheet.repaint();
    this.writeEntries();
    if (isOn) for (const orbit of this.list) void this.judge(orbit);
  }

  private async judge(orbit: Orbit): Promise<void> {
    if (orbit.indicator !== null || !(orbit.until > 0)) return;
    const { era } = this;
    const { parameters } = this.lab.shown.value.experiment;
    const until = Math.min(orbit.until, 20 * this.lab.model.until);
    const value = await this.engines.engine.indicator({ parameters, start: orbit.start, until, kind: "megno" }).catch(() => null);
    if (value === null) return;
    const index = this.list.findIndex((each) => each.number === orbit.number);
    const now = this.list[index];
    if (era !== this.era || now === undefined) return;
    this.list[index] = { ...now, indicator: value };
    this.sheet.repaint();
    this.writeEntries();
  }

  private remove(orbit: Orbit | undefined): void {
    this.list = this.list.filter((each) => each !== orbit);
    this.sheet.repaint();
    this.writeEntries();
  }

  private colour(orbit: Orbit): string {
    if (this.byIndicator && orbit.indicator !== null) return `rgb(${megnoColour(orbit.indicator).join()})`;
    if (this.byIndicator) return palette().quiet;
    const { series } = palette();
    return series[orbit.number % series.length] ?? palette().ink;
  }

  private paint(pen: CanvasRenderingContext2D, frame: Frame, ratio: number): void {
    for (const orbit of this.list) paintPoints(pen, frame, orbit, 0, this.colour(orbit), ratio);
  }

  /** Add points to the picture without painting the others anew. */
  private add(orbit: Orbit, from: number): void {
    const { pen, frame } = this.sheet;
    if (pen !== null) paintPoints(pen, frame, orbit, from, this.colour(orbit), Math.min(window.devicePixelRatio || 1, 2));
  }

  private whole(): { x: Range; y: Range } {
    const range = (axis: "x" | "y"): Range => {
      if (this.quantity(this.chosen[axis])?.angle === true) return [-Math.PI, Math.PI];
      return extent(this.list.flatMap((orbit) => Array.from(orbit[axis])), 0.12);
    };
    return { x: range("x"), y: range("y") };
  }

  private hover(place: Place, frame: Frame): string | null {
    const at = { right: frame.right(place.x), down: frame.down(place.y) };
    const found = nearest(this.list, (x) => frame.right(x), (y) => frame.down(y), at, 9);
    this.hovered = found?.orbit ?? null;
    if (found === null) return null;
    const { model } = this.lab;
    const state = model.state.slice(0, model.reduced);
    const size = sizes(state.map(({ name }) => name), found.orbit);
    const start = state.map(({ name, mathml }, k) => `${plain(mathml || name)} = ${readableBeside(size[k] ?? 0, found.orbit.start[k] ?? NaN)}`);
    const { indicator } = found.orbit;
    return `starts at ${start.join(", ")}${indicator === null ? "" : `; ${megnoWords(indicator)}`}`;
  }

  private marks(pen: CanvasRenderingContext2D, frame: Frame): void {
    const { state } = this.lab.shown.value;
    const played = this.list.filter((orbit) => state !== null && same(orbit.start, state));
    paintMarks(pen, frame, played, this.hovered, palette().ink);
  }

  private writeEntries(): void {
    const { state } = this.lab.shown.value;
    const entries = this.list.slice(-40).map((orbit) => {
      const words = `Play orbit ${orbit.number + 1}: ${orbit.x.length} points${orbit.indicator === null ? "" : `, ${megnoWords(orbit.indicator)}`}`;
      const isOn = state !== null && same(orbit.start, state);
      const made = element("button", { type: "button", "aria-label": words, title: words, "aria-current": isOn ? "true" : null }, element("i", { style: `background:${this.colour(orbit)}` }), String(orbit.number + 1));
      made.addEventListener("click", () => void this.play(orbit.start));
      return made;
    });
    this.entries.replaceChildren(...entries);
  }
}
