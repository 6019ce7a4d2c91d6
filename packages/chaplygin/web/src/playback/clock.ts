/** The time of the motion that is shown, and its running. */

import { Cell } from "../page/cell";

/** Speeds, times real time. */
export const SPEEDS = [0.02, 0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10] as const;

/** Milliseconds between numbers that are written while a motion plays: faster ones cannot be read. */
const BETWEEN = 100;

/** Runs through the time of a motion, again and again. */
export class Clock {
  readonly time = new Cell(0);
  /** The time for numbers that are read: that of the motion, but while it plays not at every picture. */
  readonly reading = new Cell(0);
  readonly playing = new Cell(false);
  readonly speed = new Cell(1);
  private end = 1;
  private frame = 0;
  private before = 0;
  private written = 0;

  /** Give the time at which the motion ends. */
  set until(end: number) {
    this.end = end;
    if (this.time.value > end) this.seek(end);
  }

  get until(): number {
    return this.end;
  }

  play(): void {
    if (this.playing.value) return;
    if (this.time.value >= this.end) this.seek(0);
    this.playing.value = true;
    this.before = 0;
    this.frame = requestAnimationFrame(this.step);
  }

  pause(): void {
    if (!this.playing.value) return;
    cancelAnimationFrame(this.frame);
    this.playing.value = false;
    this.reading.value = this.time.value;
  }

  toggle(): void {
    if (this.playing.value) this.pause();
    else this.play();
  }

  /** Go to an instant. */
  seek(t: number): void {
    this.time.value = Math.min(Math.max(t, 0), this.end);
    this.reading.value = this.time.value;
  }

  /** The next speed of the list, faster or slower. */
  changeSpeed(by: 1 | -1): void {
    const now = SPEEDS.findIndex((speed) => speed >= this.speed.value - 1e-9);
    this.speed.value = SPEEDS[Math.min(Math.max(now + by, 0), SPEEDS.length - 1)] ?? 1;
  }

  private readonly step = (instant: number): void => {
    if (!this.playing.value) return;
    // after a pause of the page, such as in another tab, the motion goes on where it was
    const passed = this.before === 0 ? 0 : Math.min(0.1, (instant - this.before) / 1000);
    this.before = instant;
    const next = this.time.value + passed * this.speed.value;
    this.time.value = next >= this.end ? 0 : next;
    if (instant - this.written >= BETWEEN) {
      this.written = instant;
      this.reading.value = this.time.value;
    }
    this.frame = requestAnimationFrame(this.step);
  };
}

/** A speed at which a motion of this duration takes between five seconds and a minute. */
export function fittingSpeed(until: number): number {
  if (until >= 4 && until <= 90) return 1;
  const wanted = until < 4 ? until / 8 : until / 40;
  return SPEEDS.reduce((best, speed) =>
    Math.abs(Math.log(speed / wanted)) < Math.abs(Math.log(best / wanted)) ? speed : best,
  );
}
