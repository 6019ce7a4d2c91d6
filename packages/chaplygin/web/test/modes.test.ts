import assert from "node:assert/strict";
import { test } from "node:test";
import { Color } from "three";
import type { ModeInterval } from "../src/model";
import { daylight } from "../src/page/palette";
import { smoothCurve } from "../src/playback/curve";
import { changingModes, modeAt, presentModes, splitAtModes } from "../src/playback/modes";
import { plotsSvg } from "../src/downloads/svg";
import { drawModes } from "../src/plots/mode_bar";
import { paintedCurve } from "../src/scene/paint";

const MODES: ModeInterval[] = [
  { mode: "sliding", begin: 0, end: 0.25 },
  { mode: "flight", begin: 0.25, end: 1.5 },
  { mode: "rolling without spin", begin: 1.5, end: 2 },
];
const motion = (modes?: ModeInterval[]) => ({ times: Float64Array.of(0, 1, 2), columns: {}, end: null, ...(modes ? { modes } : {}) });
const line = smoothCurve(Float64Array.of(0, 1, 2), Float64Array.of(0, 0, 0, 4, 0, 0, 8, 0, 0), 3, 1);

test("the mode at an instant; at a change, the one that begins", () => {
  assert.deepEqual([-1, 0, 0.2, 0.25, 1.4, 1.5, 9].map((t) => modeAt(MODES, t)), [
    "sliding", "sliding", "sliding", "flight", "flight", "rolling without spin", "rolling without spin",
  ]);
  assert.equal(modeAt([], 1), "");
});

test("modes are shown only where they change, in the order of the key", () => {
  assert.equal(changingModes(motion()).length, 0);
  assert.equal(changingModes(motion(MODES.slice(0, 1))).length, 0);
  assert.equal(changingModes(motion(MODES)).length, 3);
  assert.deepEqual(presentModes(MODES, Object.keys(daylight.modes)), ["flight", "sliding", "rolling without spin"]);
});

test("a curve has a point where a mode begins, on itself", () => {
  const { points, times, lengths } = splitAtModes(line, MODES);
  assert.deepEqual(Array.from(times), [0, 0.25, 1, 1.5, 2]);
  assert.deepEqual(Array.from(points), [0, 0, 0, 1, 0, 0, 4, 0, 0, 6, 0, 0, 8, 0, 0]);
  assert.deepEqual(Array.from(lengths), [0, 1, 4, 6, 8]);
});

test("a curve is coloured by mode up to the very instant of a change, else by time", () => {
  const { colour } = paintedCurve(line, motion(MODES), daylight);
  const is = (at: Color, name: string): void => assert.equal(`#${at.getHexString()}`, daylight.modes[name]);
  // the same instant ends one piece and begins the next
  is(colour(0.25, 0.1), "sliding");
  is(colour(0.25, 0.6), "flight");
  is(colour(2, 1.75), "rolling without spin");
  const usual = paintedCurve(line, motion(), daylight);
  assert.equal(usual.curve, line);
  assert.equal(`#${usual.colour(0, 0.5).getHexString()}`, daylight.time[0]);
  assert.equal(`#${usual.colour(2, 1.5).getHexString()}`, daylight.time.at(-1));
});

/** A pen that writes down what it fills, and how many stripes it draws. */
function recorder() {
  const filled: [string, number, number][] = [];
  let stripes = 0;
  const nothing = (): void => {};
  const pen = {
    fillStyle: "",
    fillRect(left: number, _: number, width: number): void {
      filled.push([this.fillStyle, left, left + width]);
    },
    moveTo: () => (stripes += 1),
    save: nothing, restore: nothing, beginPath: nothing, rect: nothing, clip: nothing, lineTo: nothing, stroke: nothing,
  };
  return { pen: pen as unknown as CanvasRenderingContext2D, filled, striped: () => stripes > 0 };
}

test("the bar of modes ends with the plot, and has stripes where friction holds the spin", () => {
  const box = { left: 10, top: 0, width: 100, height: 8, ratio: 1 };
  const moving = recorder();
  drawModes(moving.pen, MODES, 0, 1, box, daylight);
  assert.deepEqual(moving.filled, [
    [daylight.modes["sliding"], 10, 35],
    [daylight.modes["flight"], 35, 110],
  ]);
  assert.ok(!moving.striped());
  const held = recorder();
  drawModes(held.pen, MODES, 1.5, 2, box, daylight);
  assert.deepEqual(held.filled, [[daylight.modes["rolling without spin"], 10, 110]]);
  assert.ok(held.striped());
});

test("saved plots have the modes under each, and a key", () => {
  const group = { label: "u", unit: "m/s", components: [{ label: "u", values: Float64Array.of(1, 2, 3) }] };
  const svg = plotsSvg("a ball", motion().times, [group, group], MODES);
  const areas = (name: string): number => svg.split(`fill="${daylight.modes[name]}"`).length - 1;
  assert.deepEqual([areas("flight"), areas("sliding"), areas("rolling without spin")], [3, 3, 3]);
  assert.equal(svg.split('fill="url(#stripes1)"').length - 1, 3);
  assert.ok(!plotsSvg("a ball", motion().times, [group, group]).includes("pattern"));
});
