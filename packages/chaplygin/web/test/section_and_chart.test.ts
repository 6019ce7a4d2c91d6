import assert from "node:assert/strict";
import { test } from "node:test";
import { coarseFirst, middle, quantile } from "../src/chart/grid";
import { anglesAbout, rotationNumber } from "../src/chart/rotation_number";
import { megnoShare } from "../src/page/indicator";
import { crossings, longer, middleOf, nearest, nearestState, wrapped, type Orbit } from "../src/section/orbits";
import { sizes } from "../src/section/points";
import { Frame, zoomedRange } from "../src/sheet/frame";

const orbit = (number: number, x: number[], y: number[]): Orbit => ({
  start: Float64Array.of(0),
  x: Float64Array.from(x),
  y: Float64Array.from(y),
  rows: Float64Array.from(x.flatMap((value) => [value, 10 * value])),
  number,
  until: 1,
  indicator: null,
});

test("a plane maps values to paper and back", () => {
  const frame = new Frame(500, 400, { range: [-1, 3], label: "" }, { range: [10, 20], label: "" });
  assert.ok(Math.abs(frame.valueX(frame.right(0.7)) - 0.7) < 1e-12);
  assert.ok(Math.abs(frame.valueY(frame.down(12.5)) - 12.5) < 1e-12);
  assert.ok(frame.down(20) < frame.down(10));
  assert.deepEqual(zoomedRange([0, 4], 1, 0.5), [0.5, 2.5]);
});

test("the point nearest to a place", () => {
  const all = [orbit(0, [0, 1], [0, 1]), orbit(1, [2], [2])];
  const same = (value: number): number => value;
  const found = nearest(all, same, same, { right: 1.9, down: 2 }, 0.5);
  assert.equal(found?.orbit.number, 1);
  assert.equal(nearest(all, same, same, { right: 5, down: 5 }, 0.5), null);
  assert.deepEqual(Array.from(nearestState(all, 2, { x: 1.1, y: 1 }, 1, 1) ?? []), [1, 10]);
});

test("the components of a vector have one size, other variables their own", () => {
  const given = { start: Float64Array.of(4e-25, 2, 1e-20, 9), rows: Float64Array.of(0, -3, 2e-20, NaN, 0, 0) };
  assert.deepEqual(sizes(["gamma_1", "gamma_2", "theta"], given), [3, 3, 2e-20]);
});

test("points given by their place alone have no state", () => {
  const first = { ...orbit(0, [], []), x: Float64Array.of(7), y: Float64Array.of(7) };
  const both = longer(first, { x: Float64Array.of(1), y: Float64Array.of(1), rows: Float64Array.of(1, 10), time: 3 });
  assert.deepEqual(Array.from(nearestState([both], 2, { x: 7, y: 7 }, 1, 1) ?? []), [1, 10]);
  assert.equal(both.until, 3);
});

test("crossings are counted by direction, those of an angle at every turn", () => {
  const values = [-1, 1, -1, 1, 1];
  assert.equal(crossings(values, 0, 1, false), 2);
  assert.equal(crossings(values, 0, -1, false), 1);
  assert.equal(crossings(values, 0, 0, false), 3);
  assert.equal(crossings([0.1, 3, 6.5, 13], 0, 1, true), 2);
  assert.equal(middleOf([0.31, 0.99]), 0.7);
});

test("angles lie within half a turn", () => {
  for (const angle of [0, 3, -3, 10, -100]) {
    assert.ok(Math.abs(wrapped(angle)) <= Math.PI + 1e-12);
    assert.ok(Math.abs(Math.sin(wrapped(angle)) - Math.sin(angle)) < 1e-9);
  }
});

test("every cell of a chart comes once, coarse ones first", () => {
  for (const size of [1, 7, 50, 64]) {
    const cells = coarseFirst(size);
    assert.equal(cells.length, size * size);
    assert.equal(new Set(cells.map(({ row, column }) => row * size + column)).size, size * size);
    const sides = cells.map(({ side }) => side);
    assert.deepEqual(sides, [...sides].sort((a, b) => b - a));
  }
  assert.equal(middle([0, 10], 2, 5), 5);
  assert.equal(quantile(Float64Array.of(3, NaN, 1, 2), 0.5), 2);
});

test("the rotation number of a rigid turn, of a perturbed one and of none", () => {
  const golden = (Math.sqrt(5) - 1) / 2;
  const angles = Float64Array.from({ length: 200 }, (_, k) => 2 * Math.PI * ((0.1 + golden * k) % 1));
  assert.ok(Math.abs(rotationNumber(angles) - (golden - 1)) < 1e-12);
  // seen through another angle on the circle the number is the same
  const bent = angles.map((angle) => angle + 0.4 * Math.sin(angle));
  assert.ok(Math.abs(rotationNumber(bent) - (golden - 1)) < 1e-5);
  assert.equal(rotationNumber(new Float64Array(100).fill(1.3)), 0);
  // the same motion on an ellipse, about its middle
  const turned = Array.from({ length: 600 }, (_, k) => 2 * Math.PI * k * golden);
  const about = anglesAbout(turned.map((angle) => 5 + 3 * Math.cos(angle)), turned.map((angle) => 0.1 * Math.sin(angle)));
  assert.ok(Math.abs(rotationNumber(about) - (golden - 1)) < 1e-4);
  let seed = 1;
  const scattered = Float64Array.from({ length: 400 }, () => (seed = (seed * 16807) % 2147483647));
  assert.ok(Number.isNaN(rotationNumber(scattered)));
  assert.ok(Number.isNaN(rotationNumber([1, 2])));
});

test("the scale of MEGNO begins at regular motions", () => {
  assert.equal(megnoShare(2), 0);
  assert.equal(megnoShare(32), 1);
  assert.equal(megnoShare(4, 4), 1);
  assert.ok(megnoShare(4) > 0);
});
