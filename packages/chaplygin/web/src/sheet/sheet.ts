/** A plane of two quantities on the screen: pointer, wheel, fingers and keys. */

import { element, fitCanvas } from "../page/dom";
import { letter } from "../page/type";
import { onSchemeChange, palette } from "../page/palette";
import { drawFrame, Frame, zoomedRange, type Axis, type Range } from "./frame";

export interface Place {
  x: number;
  y: number;
}

/** What a plane does. */
export interface SheetActs {
  label: string;
  /** Draw all that is there. */
  paint(pen: CanvasRenderingContext2D, frame: Frame, ratio: number): void;
  click(place: Place): void;
  /** A drag from one place to another, where it means something. */
  drag?(from: Place, to: Place): void;
  /** What is at a place: words for a tip, or nothing. `right`, `down` are CSS pixels. */
  hover(place: Place, frame: Frame): string | null;
  /** Draw marks over the picture. */
  marks?(pen: CanvasRenderingContext2D, frame: Frame): void;
  /** The ranges that show everything. */
  whole(): { x: Range; y: Range };
  /** The ranges have changed. */
  moved?(): void;
  keys?: Readonly<Record<string, () => void>>;
}

const CLICK = 5;

/** A drawn plane. */
export class Sheet {
  readonly element: HTMLElement;
  /** Whether a drag without a key draws a box to enlarge. */
  boxing = false;
  private readonly base = element("canvas", { "aria-hidden": true });
  private readonly over = element("canvas", { "aria-hidden": true });
  private readonly tip = element("div", { class: "lab-tip", hidden: true, role: "tooltip" });
  private readonly spoken = element("span", { class: "lab-spoken", role: "status", "aria-live": "polite" });
  private x: Axis = { range: [-1, 1], label: "" };
  private y: Axis = { range: [-1, 1], label: "" };
  private cross: Place | null = null;
  private stroke: { from: { right: number; down: number }; to: { right: number; down: number }; box: boolean } | null = null;
  private readonly fingers = new Map<number, { right: number; down: number }>();
  private due = false;

  constructor(private readonly acts: SheetActs) {
    this.element = element(
      "div",
      { class: "lab-sheet", tabindex: 0, role: "application", "aria-label": acts.label },
      this.base,
      this.over,
      this.tip,
      this.spoken,
    );
    this.bindPointer();
    this.element.addEventListener("keydown", (event) => this.key(event));
    this.element.addEventListener("blur", () => {
      this.cross = null;
      this.mark();
    });
    new ResizeObserver(() => this.paint()).observe(this.element);
    onSchemeChange(() => this.repaint());
  }

  get frame(): Frame {
    return new Frame(this.element.clientWidth, this.element.clientHeight, this.x, this.y, letter());
  }

  /** The pen on the picture, in CSS pixels, to add to what is painted. */
  get pen(): CanvasRenderingContext2D | null {
    return penOf(this.base);
  }

  get canvas(): HTMLCanvasElement {
    return this.base;
  }

  setAxes(x: Axis, y: Axis): void {
    this.x = x;
    this.y = y;
    this.repaint();
  }

  setRanges(x: Range, y: Range): void {
    this.x = { ...this.x, range: x };
    this.y = { ...this.y, range: y };
    this.repaint();
    this.acts.moved?.();
  }

  /** Show everything. */
  showAll(): void {
    const { x, y } = this.acts.whole();
    this.setRanges(x, y);
  }

  zoom(factor: number, about: Place | null = null): void {
    const middle = about ?? this.cross ?? { x: mean(this.x.range), y: mean(this.y.range) };
    this.setRanges(zoomedRange(this.x.range, middle.x, factor), zoomedRange(this.y.range, middle.y, factor));
  }

  /** Paint at the next frame. */
  repaint(): void {
    if (this.due) return;
    this.due = true;
    requestAnimationFrame(() => {
      this.due = false;
      this.paint();
    });
  }

  /** Draw the marks anew. */
  mark(): void {
    const { ratio } = fitCanvas(this.over);
    const pen = penOf(this.over);
    if (pen === null) return;
    const { frame } = this;
    const colours = palette();
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, frame.width, frame.height);
    this.acts.marks?.(pen, frame);
    pen.strokeStyle = colours.ink;
    pen.lineWidth = 1;
    if (this.cross !== null) {
      const [right, down] = [frame.right(this.cross.x), frame.down(this.cross.y)];
      pen.beginPath();
      pen.moveTo(right - 12, down);
      pen.lineTo(right + 12, down);
      pen.moveTo(right, down - 12);
      pen.lineTo(right, down + 12);
      pen.stroke();
    }
    if (this.stroke !== null) {
      const { from, to, box } = this.stroke;
      pen.setLineDash([5, 3]);
      pen.beginPath();
      if (box) pen.rect(from.right, from.down, to.right - from.right, to.down - from.down);
      else {
        pen.moveTo(from.right, from.down);
        pen.lineTo(to.right, to.down);
      }
      pen.stroke();
      pen.setLineDash([]);
    }
  }

  /** Paint now. */
  paint(): void {
    if (this.element.clientWidth === 0) return;
    const { ratio } = fitCanvas(this.base);
    const { pen, frame } = this;
    if (pen === null) return;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, frame.width, frame.height);
    this.acts.paint(pen, frame, ratio);
    drawFrame(pen, frame, palette());
    this.mark();
  }

  private value(right: number, down: number): Place {
    const { frame } = this;
    return { x: frame.valueX(right), y: frame.valueY(down) };
  }

  private bindPointer(): void {
    const area = this.element;
    const at = (event: PointerEvent | WheelEvent): { right: number; down: number } => {
      const { left, top } = area.getBoundingClientRect();
      return { right: event.clientX - left, down: event.clientY - top };
    };
    area.addEventListener("pointerdown", (event) => {
      const place = at(event);
      if (!this.frame.contains(place.right, place.down)) return;
      this.cross = null;
      this.fingers.set(event.pointerId, place);
      area.setPointerCapture(event.pointerId);
      if (this.fingers.size === 1) this.stroke = { from: place, to: place, box: this.boxing || event.shiftKey };
      else this.stroke = null;
    });
    area.addEventListener("pointermove", (event) => {
      const place = at(event);
      const finger = this.fingers.get(event.pointerId);
      if (finger === undefined) return this.point(place);
      if (this.fingers.size === 2) return this.pinch(event.pointerId, place);
      this.fingers.set(event.pointerId, place);
      if (this.stroke !== null) this.stroke = { ...this.stroke, to: place };
      this.mark();
    });
    area.addEventListener("pointerup", (event) => {
      if (!this.fingers.delete(event.pointerId)) return;
      const { stroke } = this;
      this.stroke = null;
      this.mark();
      if (stroke === null) return;
      const far = Math.hypot(stroke.to.right - stroke.from.right, stroke.to.down - stroke.from.down);
      const [from, to] = [this.value(stroke.from.right, stroke.from.down), this.value(stroke.to.right, stroke.to.down)];
      if (far < CLICK) this.acts.click(from);
      else if (stroke.box || this.acts.drag === undefined) this.setRanges(sorted(from.x, to.x), sorted(from.y, to.y));
      else this.acts.drag(from, to);
    });
    area.addEventListener("pointercancel", (event) => {
      this.fingers.delete(event.pointerId);
      this.stroke = null;
      this.mark();
    });
    area.addEventListener("pointerleave", () => (this.tip.hidden = true));
    area.addEventListener("dblclick", (event) => event.preventDefault());
    area.addEventListener(
      "wheel",
      (event) => {
        if (!area.matches(":focus-within") && !event.ctrlKey) return;
        event.preventDefault();
        const { right, down } = at(event);
        this.zoom(Math.exp(0.0015 * event.deltaY), this.value(right, down));
      },
      { passive: false },
    );
  }

  private pinch(moved: number, place: { right: number; down: number }): void {
    const other = [...this.fingers].find(([id]) => id !== moved)?.[1];
    const before = this.fingers.get(moved);
    this.fingers.set(moved, place);
    if (other === undefined || before === undefined) return;
    const was = Math.hypot(before.right - other.right, before.down - other.down);
    const is = Math.hypot(place.right - other.right, place.down - other.down);
    if (was > 0 && is > 0) this.zoom(was / is, this.value(other.right, other.down));
  }

  private point(place: { right: number; down: number }): void {
    const { frame } = this;
    const words = frame.contains(place.right, place.down) ? this.acts.hover(this.value(place.right, place.down), frame) : null;
    this.mark();
    this.tip.hidden = words === null;
    if (words === null) return;
    this.tip.textContent = words;
    const left = Math.min(place.right + 14, frame.width - this.tip.offsetWidth - 4);
    const low = place.down + 16 + this.tip.offsetHeight > frame.height;
    this.tip.style.transform = `translate(${Math.max(0, left)}px, ${low ? place.down - this.tip.offsetHeight - 8 : place.down + 16}px)`;
  }

  private key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const [width, height] = [this.x.range[1] - this.x.range[0], this.y.range[1] - this.y.range[0]];
    const step = event.shiftKey ? 0.1 : 0.02;
    const move = (right: number, up: number): void => {
      const now = this.cross ?? { x: mean(this.x.range), y: mean(this.y.range) };
      this.cross = { x: now.x + right * step * width, y: now.y + up * step * height };
      this.spoken.textContent = this.acts.hover(this.cross, this.frame) ?? "";
      this.mark();
    };
    const acts: Record<string, () => void> = {
      ArrowLeft: () => move(-1, 0),
      ArrowRight: () => move(1, 0),
      ArrowUp: () => move(0, 1),
      ArrowDown: () => move(0, -1),
      Enter: () => this.acts.click(this.cross ?? { x: mean(this.x.range), y: mean(this.y.range) }),
      "+": () => this.zoom(1 / 1.3),
      "=": () => this.zoom(1 / 1.3),
      "-": () => this.zoom(1.3),
      "0": () => this.showAll(),
      ...this.acts.keys,
    };
    const act = acts[event.key];
    if (act === undefined) return;
    event.preventDefault();
    act();
  }
}

/** A pen of the processor: pens of the graphics card hold the page up where it is drawn by software. */
function penOf(canvas: HTMLCanvasElement): CanvasRenderingContext2D | null {
  return canvas.getContext("2d", { willReadFrequently: true });
}

function mean([low, high]: Range): number {
  return (low + high) / 2;
}

function sorted(a: number, b: number): Range {
  return a < b ? [a, b] : [b, a];
}
