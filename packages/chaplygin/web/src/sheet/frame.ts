/** The frame of a plane of two quantities: where a value is on the paper, and the marks on its axes. */

import { axisTexts, ticks } from "../page/numbers";
import { SERIF } from "../page/type";
import type { Palette } from "../page/palette";

export type Range = [low: number, high: number];

export interface Axis {
  range: Range;
  /** Letters, and a unit or nothing. */
  label: string;
}

/** Space around the plane, in letters of the page. */
const MARGIN = { left: 3.8, right: 0.9, top: 0.6, bottom: 2.6 } as const;

/** Places of a plane on a drawing surface of this size in CSS pixels. */
export class Frame {
  readonly margin: { readonly left: number; readonly right: number; readonly top: number; readonly bottom: number };

  constructor(
    readonly width: number,
    readonly height: number,
    readonly x: Axis,
    readonly y: Axis,
    /** Size of a letter in CSS pixels. */
    readonly letter = 16,
  ) {
    const { left, right, top, bottom } = MARGIN;
    this.margin = { left: left * letter, right: right * letter, top: top * letter, bottom: bottom * letter };
  }

  get innerWidth(): number {
    return Math.max(1, this.width - this.margin.left - this.margin.right);
  }

  get innerHeight(): number {
    return Math.max(1, this.height - this.margin.top - this.margin.bottom);
  }

  right(value: number): number {
    const [low, high] = this.x.range;
    return this.margin.left + ((value - low) / (high - low)) * this.innerWidth;
  }

  down(value: number): number {
    const [low, high] = this.y.range;
    return this.margin.top + ((high - value) / (high - low)) * this.innerHeight;
  }

  valueX(right: number): number {
    const [low, high] = this.x.range;
    return low + ((right - this.margin.left) / this.innerWidth) * (high - low);
  }

  valueY(down: number): number {
    const [low, high] = this.y.range;
    return high - ((down - this.margin.top) / this.innerHeight) * (high - low);
  }

  /** Whether a place on the paper is in the plane. */
  contains(right: number, down: number): boolean {
    return right >= this.margin.left && right <= this.width - this.margin.right && down >= this.margin.top && down <= this.height - this.margin.bottom;
  }
}

/** The range after a zoom by `factor` about a value that stays where it is. */
export function zoomedRange([low, high]: Range, about: number, factor: number): Range {
  return [about + (low - about) * factor, about + (high - about) * factor];
}

/** Draw axes, marks and labels. */
export function drawFrame(pen: CanvasRenderingContext2D, frame: Frame, colours: Palette): void {
  const { margin: { left, top }, letter } = frame;
  const { innerWidth: wide, innerHeight: tall } = frame;
  pen.save();
  pen.font = `${0.8 * letter}px ${SERIF}`;
  pen.lineWidth = 1;
  pen.strokeStyle = colours.quiet;
  pen.beginPath();
  pen.moveTo(left - 0.5, top);
  pen.lineTo(left - 0.5, top + tall + 0.5);
  pen.lineTo(left + wide, top + tall + 0.5);
  pen.stroke();
  pen.fillStyle = colours.ink;
  pen.textAlign = "center";
  pen.textBaseline = "top";
  const across = ticks(...frame.x.range, Math.max(2, wide / (5.6 * letter)));
  const horizontal = axisTexts(across, frame.x.label);
  across.forEach((value, k) => {
    const place = frame.right(value);
    tick(pen, place, top + tall, 0, 4);
    pen.fillText(horizontal.texts[k] ?? "", place, top + tall + 6);
  });
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  const up = ticks(...frame.y.range, Math.max(2, tall / (3.4 * letter)));
  const vertical = axisTexts(up, frame.y.label);
  up.forEach((value, k) => {
    const place = frame.down(value);
    tick(pen, left - 4, place, 4, 0);
    pen.fillText(vertical.texts[k] ?? "", left - 7, place);
  });
  pen.font = `italic ${0.92 * letter}px ${SERIF}`;
  pen.textAlign = "center";
  pen.textBaseline = "bottom";
  pen.fillText(horizontal.label, left + wide / 2, frame.height - 2);
  pen.translate(0.85 * letter, top + tall / 2);
  pen.rotate(-Math.PI / 2);
  pen.textBaseline = "middle";
  pen.fillText(vertical.label, 0, 0);
  pen.restore();
}

function tick(pen: CanvasRenderingContext2D, x: number, y: number, right: number, down: number): void {
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + right, y + down);
  pen.stroke();
}
