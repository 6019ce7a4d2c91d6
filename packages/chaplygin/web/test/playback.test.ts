import assert from "node:assert/strict";
import { test } from "node:test";
import { lengths, smoothCurve } from "../src/playback/curve";
import { finiteSamples, place, pose, row, slerp, turned, turnedBack, type Motion, type Quaternion, type Vector } from "../src/playback/motion";
import { fittingSpeed } from "../src/playback/clock";

const close = (a: ArrayLike<number>, b: ArrayLike<number>, within = 1e-12): void => {
  assert.equal(a.length, b.length);
  for (let k = 0; k < a.length; k++) assert.ok(Math.abs((a[k] ?? NaN) - (b[k] ?? NaN)) <= within, `${a[k]} is not ${b[k]}`);
};

/** A rotation by an angle about an axis of length one. */
const about = ([x, y, z]: Vector, angle: number): Quaternion => [
  Math.cos(angle / 2),
  ...[x, y, z].map((part) => part * Math.sin(angle / 2)),
] as Quaternion;

test("the sample before an instant", () => {
  const times = Float64Array.of(0, 1, 3);
  assert.deepEqual(place(times, -1), { index: 0, share: 0 });
  assert.deepEqual(place(times, 1), { index: 1, share: 0 });
  assert.deepEqual(place(times, 2), { index: 1, share: 0.5 });
  assert.deepEqual(place(times, 9), { index: 2, share: 0 });
});

test("a quaternion turns vectors as the matrix of the rotation does", () => {
  close(turned(about([0, 0, 1], Math.PI / 2), [1, 0, 0]), [0, 1, 0]);
  close(turned(about([1, 0, 0], Math.PI / 2), [0, 1, 0]), [0, 0, 1]);
  const q = about([0.6, 0, 0.8], 1.1);
  close(turnedBack(q, turned(q, [0.3, -2, 5])), [0.3, -2, 5]);
});

test("between two attitudes the body turns evenly, on the shorter way", () => {
  const q = about([0, 1, 0], 0.8);
  close(slerp([1, 0, 0, 0], q, 0.25), about([0, 1, 0], 0.2));
  close(slerp([1, 0, 0, 0], q.map((part) => -part) as Quaternion, 0.25), about([0, 1, 0], 0.2));
  close(slerp(q, q, 0.5), q);
});

test("a pose at a sample is the sample to the last bit", () => {
  const motion: Motion = {
    times: Float64Array.of(0, 0.5),
    columns: {
      attitude: Float64Array.of(1, 0, 0, 0, ...about([0, 0, 1], 1)),
      centre: Float64Array.of(0.1, 0.2, 0.3, 1.1, 1.2, 1.3),
      contact: Float64Array.of(0.1, 0.2, 0, 1.1, 1.2, 0),
    },
    end: null,
  };
  assert.deepEqual(pose(motion, 0.5), { t: 0.5, attitude: about([0, 0, 1], 1), centre: [1.1, 1.2, 1.3], contact: [1.1, 1.2, 0] });
  assert.equal(pose(motion, 7).t, 0.5);
  close(row(motion, "centre", 3, 0.25) ?? [], [0.6, 0.7, 0.8]);
  assert.equal(row(motion, "omega", 3, 0), null);
});

test("a column ends at its first missing value", () => {
  const motion: Motion = { times: Float64Array.of(0, 1, 2), columns: { centre: Float64Array.of(0, 0, 0, 1, NaN, 1, 2, 2, 2) }, end: null };
  assert.equal(finiteSamples(motion, "centre", 3), 1);
});

test("a smooth curve passes its samples and is exact for a parabola inside", () => {
  const times = Float64Array.from({ length: 6 }, (_, k) => k);
  const points = Float64Array.from({ length: 18 }, (_, k) => (k % 3 === 0 ? Math.floor(k / 3) : k % 3 === 1 ? Math.floor(k / 3) ** 2 : 0));
  const curve = smoothCurve(times, points, 6, 4);
  assert.equal(curve.times.length, 21);
  for (let k = 4; k <= 16; k++) {
    const t = curve.times[k] ?? NaN;
    close([curve.points[3 * k] ?? NaN, curve.points[3 * k + 1] ?? NaN], [t, t * t]);
  }
});

test("lengths add up along a curve", () => {
  close(lengths(Float64Array.of(0, 0, 0, 3, 4, 0, 3, 4, 12)), [0, 5, 17]);
});

test("motions are played neither in a blink nor for minutes", () => {
  for (const until of [1e-3, 0.5, 2, 10, 60, 100, 1e4]) {
    const speed = fittingSpeed(until);
    assert.ok(speed > 0);
    if (until >= 4 && until <= 90) assert.equal(speed, 1);
  }
});
