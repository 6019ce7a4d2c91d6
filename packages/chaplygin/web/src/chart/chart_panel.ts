/** A chart over two parameters or starts: each point the indicator of a motion. */

import type { Lab } from "../lab";
import { choice, element } from "../page/dom";
import { plain } from "../page/mathml";
import { readable, readableOn } from "../page/numbers";
import { indicatorScale, onScale, palette } from "../page/palette";
import { megnoShare, megnoWords } from "../page/indicator";
import { SERIF } from "../page/type";
import { unitText } from "../page/units";
import type { SectionPanel } from "../section/section_panel";
import { rangeAround } from "../controls/slider";
import { singleInputs } from "../controls/start_inputs";
import { Sheet, type Place } from "../sheet/sheet";
import type { Frame, Range } from "../sheet/frame";
import { cellStart, chartRun, type ChartGround, type ChartRun, type ChartSetting } from "./compute";
import { quantile } from "./grid";

const KINDS = [
  { value: "megno", text: "MEGNO" },
  { value: "lyapunov", text: "Lyapunov exponent" },
  { value: "rotation", text: "rotation number" },
];

/** A chart is painted again after so many times as long as that takes. */
const PAINTING = 20;

export interface ChartPanel {
  element: HTMLElement;
  sheet: Sheet;
  shown(): void;
}

/** A quantity of an axis. */
interface Choice {
  name: string;
  text: string;
  range: Range;
  value: number;
}

/** The panel; null where nothing can be computed. */
export function chartPanel(lab: Lab, section: SectionPanel | null): ChartPanel | null {
  const { engine, model } = lab;
  // a chart takes thousands of motions: only a page that computes itself draws one
  if (engine === null || model.wasm === null) return null;
  const choices = choicesOf(lab);
  if (choices.length < 2 && section === null) return null;
  return new Panel(lab, choices, section);
}

class Panel implements ChartPanel {
  readonly element: HTMLElement;
  readonly sheet: Sheet;
  private setting: ChartSetting;
  private drawn: { setting: ChartSetting; ground: ChartGround; values: Float64Array; picture: HTMLCanvasElement; scale: Range } | null = null;
  private run: ChartRun | null = null;
  private readonly go = element("button", { type: "button", class: "lab-button" }, "Compute");
  private readonly bar = element("progress", { class: "lab-progress", max: 1, value: 0, "aria-label": "Share of the chart that is done", hidden: true });
  private readonly key = element("div", { class: "lab-key" });
  private due = 0;
  private pause = 60;

  constructor(
    private readonly lab: Lab,
    private readonly choices: readonly Choice[],
    private readonly section: SectionPanel | null,
  ) {
    this.setting = this.opening();
    this.sheet = new Sheet({
      label: "Chart. Arrow keys move a cross, Enter shows the motion there, plus and minus change the range.",
      paint: (pen, frame) => this.paint(pen, frame),
      click: (place) => void this.show(place),
      hover: (place) => this.hover(place),
      whole: () => this.wholeRange(),
      moved: () => this.moved(),
    });
    this.go.addEventListener("click", () => (this.run === null ? this.start() : this.run.stop()));
    this.element = element("div", {}, this.tools(), this.sheet.element, this.key);
    this.axes();
  }

  shown(): void {
    this.sheet.repaint();
    void this.followSection();
  }

  /** Take the plane and the ranges of the section, as long as no chart of it is drawn. */
  private async followSection(): Promise<void> {
    if (this.section === null || this.setting.x !== null || this.drawn !== null) return;
    await this.section.prepared();
    if (this.setting.x !== null || this.drawn !== null) return;
    const { x, y } = this.sectionRange();
    this.setting = { ...this.setting, xRange: x, yRange: y };
    this.axes();
  }

  private opening(): ChartSetting {
    const [a, b] = this.choices;
    const onSection = this.section !== null;
    const unit: Range = [0, 1];
    const { x, y } = onSection ? this.sectionRange() : { x: a?.range ?? unit, y: b?.range ?? unit };
    return { kind: "megno", x: onSection ? null : (a?.name ?? null), y: onSection ? null : (b?.name ?? null), xRange: x, yRange: y, size: 100, until: Math.max(100, this.lab.model.until) };
  }

  private tools(): HTMLElement {
    const names = this.choices.map(({ name, text }) => ({ value: name, text }));
    const plane = this.section === null ? [] : [{ value: "", text: "point of the section" }];
    const { setting } = this;
    const axis = (label: string, key: "x" | "y"): HTMLLabelElement =>
      choice(label, [...plane, ...names], setting[key] ?? "", (name) => this.choose(key, name === "" ? null : name));
    const until = element("input", { type: "text", inputmode: "decimal", class: "lab-field", "aria-label": "Time up to which each motion is followed", value: String(setting.until) });
    until.addEventListener("change", () => {
      const value = Number(until.value);
      if (value > 0 && Number.isFinite(value)) this.setting = { ...this.setting, until: value };
      else this.lab.say("The time must be a positive number.", true);
    });
    const kinds = this.section === null ? KINDS.slice(0, 2) : KINDS;
    return element(
      "div",
      { class: "lab-tools", role: "toolbar", "aria-label": "Chart" },
      choice("of", kinds, setting.kind, (kind) => (this.setting = { ...this.setting, kind: kind as ChartSetting["kind"] })),
      axis("across", "x"),
      axis("up", "y"),
      element("label", { class: "lab-choice" }, "to t =", until),
      choice("points", [50, 100, 200, 400].map((size) => ({ value: String(size), text: `${size} × ${size}` })), String(setting.size), (size) => (this.setting = { ...this.setting, size: Number(size) })),
      this.go,
      this.bar,
    );
  }

  private choose(key: "x" | "y", name: string | null): void {
    const other = key === "x" ? "y" : "x";
    const next = { ...this.setting, [key]: name };
    if (name === null) next[other] = null;
    else if (next[other] === null) next[other] = this.choices.find((each) => each.name !== name)?.name ?? null;
    this.setting = next;
    const { x, y } = this.wholeRange();
    this.setting = { ...this.setting, xRange: x, yRange: y };
    for (const [index, axis] of (["x", "y"] as const).entries()) {
      const list = this.element.querySelectorAll<HTMLSelectElement>(".lab-tools select")[index + 1];
      if (list) list.value = this.setting[axis] ?? "";
    }
    this.drawn = null;
    this.axes();
    void this.followSection();
  }

  private choice(name: string | null): Choice | undefined {
    return this.choices.find((each) => each.name === name);
  }

  private wholeRange(): { x: Range; y: Range } {
    if (this.setting.x === null) return this.sectionRange();
    return { x: this.choice(this.setting.x)?.range ?? [0, 1], y: this.choice(this.setting.y)?.range ?? [0, 1] };
  }

  private sectionRange(): { x: Range; y: Range } {
    const unit: Range = [-1, 1];
    const frame = this.section?.sheet.frame;
    return { x: frame?.x.range ?? unit, y: frame?.y.range ?? unit };
  }

  private axes(): void {
    const label = (name: string | null, key: "x" | "y"): string => {
      const section = this.section?.setting();
      if (name !== null || section === undefined) return this.choice(name)?.text ?? "";
      const quantity = this.lab.model.quantities.find((each) => each.name === section[key]);
      return quantity?.mathml ? plain(quantity.mathml) : section[key];
    };
    const { x, y, xRange, yRange } = this.setting;
    this.sheet.setAxes({ range: xRange, label: label(x, "x") }, { range: yRange, label: label(y, "y") });
  }

  private moved(): void {
    const { x, y } = this.sheet.frame;
    this.setting = { ...this.setting, xRange: x.range, yRange: y.range };
  }

  private start(): void {
    const { state, experiment } = this.lab.shown.value;
    if (state === null) return;
    const setting = { ...this.setting };
    const ground: ChartGround = { model: this.lab.model, experiment, reference: state, section: this.section?.setting() ?? null, orbits: [...(this.section?.orbits() ?? [])] };
    const picture = document.createElement("canvas");
    picture.width = picture.height = setting.size;
    this.go.textContent = "Stop";
    this.bar.hidden = false;
    this.bar.value = 0;
    const began = performance.now();
    const run = chartRun(ground, setting, (cells, share) => {
      this.bar.value = share;
      for (const { column, row, side } of cells) this.block(column, row, side);
      if (this.due === 0) this.due = window.setTimeout(() => {
        this.due = 0;
        const start = performance.now();
        this.colour();
        // workers wait while the page paints
        this.pause = Math.max(60, PAINTING * (performance.now() - start));
      }, this.pause);
    });
    this.drawn = { setting, ground, values: run.values, picture, scale: [0, 1] };
    this.sides = new Uint8Array(setting.size * setting.size);
    this.run = run;
    void run.done.then(() => {
      this.run = null;
      this.go.textContent = "Compute";
      this.bar.hidden = true;
      this.colour();
      const seconds = (performance.now() - began) / 1000;
      const known = run.values.reduce((count, value) => count + (Number.isFinite(value) ? 1 : 0), 0);
      this.lab.say(`${known} of ${run.values.length} points have a value; computed in ${readable(seconds, 3)} s.`);
    });
  }

  private sides = new Uint8Array(0);

  private block(column: number, row: number, side: number): void {
    const { drawn } = this;
    if (drawn === null) return;
    this.sides[row * drawn.setting.size + column] = side;
  }

  /** Paint what is known: a coarse cell fills the square of the finer ones that are still to come. */
  private colour(): void {
    const { drawn } = this;
    if (drawn === null) return;
    const { size, kind } = drawn.setting;
    const pen = drawn.picture.getContext("2d");
    if (pen === null) return;
    drawn.scale = kind === "megno" ? [2, Math.min(32, Math.max(4, quantile(drawn.values, 0.98)))] : [quantile(drawn.values, 0.02), quantile(drawn.values, 0.98)];
    const image = pen.createImageData(size, size);
    for (const side of [16, 8, 4, 2, 1]) {
      for (let row = 0; row < size; row += side) {
        for (let column = 0; column < size; column += side) {
          if (this.sides[row * size + column] !== side) continue;
          const value = drawn.values[row * size + column] ?? NaN;
          const colour = Number.isFinite(value) ? onScale(indicatorScale(), this.share(value)) : null;
          for (let r = row; r < Math.min(size, row + side); r++) {
            for (let c = column; c < Math.min(size, column + side); c++) {
              const place = 4 * ((size - 1 - r) * size + c);
              image.data.set(colour === null ? [0, 0, 0, 0] : [...colour, 255], place);
            }
          }
        }
      }
    }
    pen.putImageData(image, 0, 0);
    this.writeKey();
    this.sheet.repaint();
  }

  private share(value: number): number {
    const { drawn } = this;
    const [low, high] = drawn?.scale ?? [0, 1];
    if (drawn?.setting.kind === "megno") return megnoShare(value, high);
    return high > low ? (value - low) / (high - low) : 0.5;
  }

  private writeKey(): void {
    const { drawn } = this;
    if (drawn === null) return;
    const [low, high] = drawn.setting.kind === "megno" ? ["MEGNO to about 2, regular", `${readable(drawn.scale[1], 3)} and more`] : drawn.scale.map((value) => readable(value, 3));
    const scale = element("i", { style: `background:linear-gradient(90deg,${indicatorScale().join(",")})` });
    this.key.replaceChildren(element("span", {}, low ?? ""), scale, element("span", {}, high ?? ""), element("span", {}, "blank: no such motion"));
  }

  private paint(pen: CanvasRenderingContext2D, frame: Frame): void {
    const { drawn } = this;
    if (drawn === null) {
      pen.fillStyle = palette().quiet;
      pen.font = `${frame.letter}px ${SERIF}`;
      pen.textAlign = "center";
      pen.fillText("Choose the axes and press Compute", frame.width / 2, frame.height / 2);
      return;
    }
    const { xRange, yRange } = drawn.setting;
    const [left, right] = xRange.map((value) => frame.right(value)) as [number, number];
    const [low, high] = yRange.map((value) => frame.down(value)) as [number, number];
    pen.save();
    pen.beginPath();
    pen.rect(frame.right(frame.x.range[0]), frame.down(frame.y.range[1]), frame.innerWidth, frame.innerHeight);
    pen.clip();
    pen.imageSmoothingEnabled = false;
    pen.drawImage(drawn.picture, left, high, right - left, low - high);
    pen.restore();
  }

  private cell(place: Place): { index: number; x: number; y: number } | null {
    const { drawn } = this;
    if (drawn === null) return null;
    const { size, xRange, yRange } = drawn.setting;
    const column = Math.floor(((place.x - xRange[0]) / (xRange[1] - xRange[0])) * size);
    const row = Math.floor(((place.y - yRange[0]) / (yRange[1] - yRange[0])) * size);
    if (column < 0 || row < 0 || column >= size || row >= size) return null;
    return { index: row * size + column, x: place.x, y: place.y };
  }

  private hover(place: Place): string | null {
    const found = this.cell(place);
    if (found === null || this.drawn === null) return null;
    const value = this.drawn.values[found.index] ?? NaN;
    const { x, y } = this.sheet.frame;
    const where = `${x.label} = ${readableOn(x.range, place.x)}, ${y.label} = ${readableOn(y.range, place.y)}`;
    const { kind } = this.drawn.setting;
    if (!Number.isFinite(value)) return `${where}: no value`;
    return `${where}: ${kind === "megno" ? megnoWords(value) : kind === "lyapunov" ? `exponent ${readable(value, 3)}` : `rotation number ${readable(value, 6)}`}`;
  }

  /** Show the motion of a point in the scene. */
  private async show(place: Place): Promise<void> {
    const { engine } = this.lab;
    const { drawn } = this;
    if (engine === null || drawn === null) return;
    const found = await cellStart(engine, drawn.ground, drawn.setting, place.x, place.y);
    if ("message" in found) return this.lab.say(found.message, true);
    await this.lab.change({ ...found.experiment, until: this.lab.wanted.value.until });
    this.lab.clock.seek(0);
  }
}

/** Start inputs and parameters with their ranges. */
function choicesOf({ model }: Lab): Choice[] {
  const text = (mathml: string, name: string, unit: string): string => {
    const letters = mathml ? plain(mathml) : name;
    return unitText(unit) ? `${letters}  (${unitText(unit)})` : letters;
  };
  const inputs = singleInputs(model).map(({ name, mathml, unit, value, low, high }) => ({ name, value, text: text(mathml, name, unit), range: [low, high] as Range }));
  const parameters = model.parameters
    .map(({ name, mathml, unit, value, low, high }) => ({ name, value, text: text(mathml, name, unit), range: rangeAround(value, low, high) }));
  return [...inputs, ...parameters];
}
