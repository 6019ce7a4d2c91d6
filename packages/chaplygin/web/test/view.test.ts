import assert from "node:assert/strict";
import { test } from "node:test";
import { capOpening } from "../src/scene/cap";
import { ellipsoid } from "../src/scene/ellipsoid";
import { across, eye, FIELD, framing, orbited, panned, toward, zoomed, type View } from "../src/scene/view";

const view: View = { azimuth: 0.3, elevation: 0.4, distance: 5, target: [1, 2, 3] };

test("the eye is at its distance from the target", () => {
  const place = eye(view);
  assert.ok(Math.abs(Math.hypot(place[0] - 1, place[1] - 2, place[2] - 3) - 5) < 1e-12);
});

test("the view never turns over the pole, nor comes into the body", () => {
  assert.ok(orbited(view, 0, 9).elevation < Math.PI / 2);
  assert.ok(orbited(view, 0, -9).elevation > -Math.PI / 2);
  assert.ok(zoomed(view, 1e-9).distance > 0);
});

test("a move keeps the direction and goes across it", () => {
  const moved = panned(view, 0.2, -0.1);
  const step = moved.target.map((place, k) => place - (view.target[k] ?? 0));
  const out = toward(view);
  assert.ok(Math.abs(step.reduce((sum, part, k) => sum + part * (out[k] ?? 0), 0)) < 1e-12);
});

test("all points are in the picture, and it is filled", () => {
  for (const aspect of [0.6, 1, 2.2]) {
    const points = Array.from({ length: 60 }, (_, k) => Math.sin(7.3 * k) * (k % 3 === 2 ? 0.5 : 4));
    const found = framing(points, 0.8, 0.5, aspect);
    const out = toward(found);
    const right = [-Math.sin(0.8), Math.cos(0.8), 0];
    const up = [out[1] * right[2]! - out[2] * right[1]!, out[2] * right[0]! - out[0] * right[2]!, out[0] * right[1]! - out[1] * right[0]!];
    let most = 0;
    for (let k = 0; k < points.length; k += 3) {
      const from = [0, 1, 2].map((i) => (points[k + i] ?? 0) - (found.target[i] ?? 0));
      const dot = (axis: readonly number[]): number => from.reduce((sum, part, i) => sum + part * (axis[i] ?? 0), 0);
      const depth = found.distance - dot(out);
      most = Math.max(most, Math.abs(dot(right)) / depth / Math.tan(FIELD / 2) / aspect, Math.abs(dot(up)) / depth / Math.tan(FIELD / 2));
    }
    assert.ok(most <= 1 && most > 0.7, `${aspect}: ${most}`);
  }
});

test("a path runs from left to right", () => {
  const azimuth = across([0, 0, 0, 1, 1, 0, 2, 2, 0]);
  const right = [-Math.sin(azimuth), Math.cos(azimuth)];
  assert.ok(Math.abs((right[0] ?? 0) - Math.SQRT1_2) < 1e-12 && Math.abs((right[1] ?? 0) - Math.SQRT1_2) < 1e-12);
});

test("a cap reaches around its path, or is the whole sphere", () => {
  assert.ok(Math.abs(capOpening([1, 0, -1], -1, 0.3, 1.75) - (Math.PI / 4 + 0.3)) < 1e-12);
  assert.equal(capOpening([1, 0, 1], -1, 0.3, 1.75), Math.PI);
});

test("points and normals of an ellipsoid", () => {
  const { positions, normals, indices } = ellipsoid([3, 2, 1], [1, 0, 0, 0], 8, 12);
  for (let k = 0; k < positions.length; k += 3) {
    const [x = 0, y = 0, z = 0] = positions.subarray(k, k + 3);
    assert.ok(Math.abs((x / 3) ** 2 + (y / 2) ** 2 + z ** 2 - 1) < 1e-6);
    const [a = 0, b = 0, c = 0] = normals.subarray(k, k + 3);
    assert.ok(Math.abs(a * (y / 4) - b * (x / 9)) < 1e-6 && Math.abs(b * z - c * (y / 4)) < 1e-6);
  }
  let volume = 0;
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => positions.subarray(3 * (indices[k + i] ?? 0), 3 * (indices[k + i] ?? 0) + 3));
    if (!a || !b || !c) continue;
    volume += (a[0]! * (b[1]! * c[2]! - b[2]! * c[1]!) + a[1]! * (b[2]! * c[0]! - b[0]! * c[2]!) + a[2]! * (b[0]! * c[1]! - b[1]! * c[0]!)) / 6;
  }
  // faces turn outwards: the volume is positive, and a little less than that of the ellipsoid
  assert.ok(volume > 0.85 * 8 * Math.PI && volume < 8 * Math.PI, String(volume));
});
