/** The frame of a plane of two quantities: where a value is on the paper, and the marks on its axes. */

import { readable, ticks } from "../page/numbers";
import type { Palette } from "../page/palette";

export type Range = [low: number, high: number];

export interface Axis {
  range: Range;
  /** Letters, and a unit or nothing. */
  label: string;
}

/** Space in CSS pixels around the plane. */
export const MARGIN = { left: 62, right: 14, top: 10, bottom: 42 } as const;

/** Places of a plane on a drawing surface of this size in CSS pixels. */
export class Frame {
  constructor(
    readonly width: number,
    readonly height: number,
    readonly x: Axis,
    readonly y: Axis,
  ) {}

  get innerWidth(): number {
    return Math.max(1, this.width - MARGIN.left - MARGIN.right);
  }

  get innerHeight(): number {
    return Math.max(1, this.height - MARGIN.top - MARGIN.bottom);
  }

  right(value: number): number {
    const [low, high] = this.x.range;
    return MARGIN.left + ((value - low) / (high - low)) * this.innerWidth;
  }

  down(value: number): number {
    const [low, high] = this.y.range;
    return MARGIN.top + ((high - value) / (high - low)) * this.innerHeight;
  }

  valueX(right: number): number {
    const [low, high] = this.x.range;
    return low + ((right - MARGIN.left) / this.innerWidth) * (high - low);
  }

  valueY(down: number): number {
    const [low, high] = this.y.range;
    return high - ((down - MARGIN.top) / this.innerHeight) * (high - low);
  }

  /** Whether a place on the paper is in the plane. */
  contains(right: number, down: number): boolean {
    return right >= MARGIN.left && right <= this.width - MARGIN.right && down >= MARGIN.top && down <= this.height - MARGIN.bottom;
  }
}

/** The range after a zoom by `factor` about a value that stays where it is. */
export function zoomedRange([low, high]: Range, about: number, factor: number): Range {
  return [about + (low - about) * factor, about + (high - about) * factor];
}

/** Draw axes, marks and labels. */
export function drawFrame(pen: CanvasRenderingContext2D, frame: Frame, colours: Palette): void {
  const { left, top } = MARGIN;
  const { innerWidth: wide, innerHeight: tall } = frame;
  pen.save();
  pen.font = "13px 'STIX Two Text', 'Palatino Linotype', Georgia, serif";
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
  for (const value of ticks(...frame.x.range, Math.max(2, wide / 90))) {
    const place = frame.right(value);
    tick(pen, place, top + tall, 0, 4);
    pen.fillText(readable(value, 6), place, top + tall + 6);
  }
  pen.textAlign = "right";
  pen.textBaseline = "middle";
  for (const value of ticks(...frame.y.range, Math.max(2, tall / 55))) {
    const place = frame.down(value);
    tick(pen, left - 4, place, 4, 0);
    pen.fillText(readable(value, 6), left - 7, place);
  }
  pen.font = "italic 15px 'STIX Two Text', 'Palatino Linotype', Georgia, serif";
  pen.textAlign = "center";
  pen.textBaseline = "bottom";
  pen.fillText(frame.x.label, left + wide / 2, frame.height - 2);
  pen.translate(14, top + tall / 2);
  pen.rotate(-Math.PI / 2);
  pen.textBaseline = "middle";
  pen.fillText(frame.y.label, 0, 0);
  pen.restore();
}

function tick(pen: CanvasRenderingContext2D, x: number, y: number, right: number, down: number): void {
  pen.beginPath();
  pen.moveTo(x, y);
  pen.lineTo(x + right, y + down);
  pen.stroke();
}
