import assert from "node:assert/strict";
import { test } from "node:test";
import { directions, meshOfGrid, type Mesh } from "../src/engine/body_mesh.js";
import type { Body } from "../src/model.js";

const rows = 24;
const columns = 48;
const theta = Array.from({ length: rows + 1 }, (_, i) => 1e-6 + ((Math.PI - 2e-6) * i) / rows);
const phi = Array.from({ length: columns }, (_, j) => (2 * Math.PI * j) / columns);

function body(hollow = false): Body {
  return { theta, phi, positions: "", hollow, thickness: 0 };
}

/** Points r(γ) of an ellipsoid, or of a shell that rolls with its inner side. */
function ellipsoid(axes: number[], side: number): Float64Array {
  const gamma = directions(theta, phi);
  const points = new Float64Array(gamma.length);
  for (let i = 0; i < gamma.length; i += 3) {
    const scale = Math.hypot(...axes.map((a, k) => a * gamma[i + k]!));
    axes.forEach((a, k) => (points[i + k] = (side * a * a * gamma[i + k]!) / scale));
  }
  return points;
}

/** Six times the volume, by the divergence theorem. */
function volume({ positions, indices }: Mesh): number {
  let sum = 0;
  const at = (corner: number): number[] => [0, 1, 2].map((k) => positions[3 * corner + k]!);
  for (let f = 0; f < indices.length; f += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => at(indices[f + k]!)) as [number[], number[], number[]];
    sum += a[0]! * (b[1]! * c[2]! - b[2]! * c[1]!);
    sum += a[1]! * (b[2]! * c[0]! - b[0]! * c[2]!);
    sum += a[2]! * (b[0]! * c[1]! - b[1]! * c[0]!);
  }
  return sum;
}

test("a mesh is closed, faces outwards and has the volume of the body", () => {
  const axes = [1, 0.6, 0.3];
  const mesh = meshOfGrid(body(), ellipsoid(axes, -1));
  const expected = 8 * Math.PI * axes[0]! * axes[1]! * axes[2]!;
  assert.ok(Math.abs(volume(mesh) / expected - 1) < 0.02);
  // every edge once in each direction, by the places of its ends, as caps have corners of their own
  const place = (corner: number): string =>
    [0, 1, 2].map((k) => mesh.positions[3 * corner + k]!.toFixed(4)).join(" ");
  const edges = new Map<string, number>();
  for (let f = 0; f < mesh.indices.length; f += 3) {
    for (let k = 0; k < 3; k++) {
      const [a, b] = [mesh.indices[f + k]!, mesh.indices[f + ((k + 1) % 3)]!].map(place);
      if (a === b) continue;
      edges.set(`${a} > ${b}`, (edges.get(`${a} > ${b}`) ?? 0) + 1);
    }
  }
  for (const [edge, count] of edges) {
    const [a, b] = edge.split(" > ");
    assert.equal(count, edges.get(`${b} > ${a}`), edge);
  }
});

test("normals are those of the surface, and octants alternate", () => {
  const mesh = meshOfGrid(body(), ellipsoid([1, 1, 1], -1));
  for (let k = 0; k < 3 * theta.length * columns; k++) {
    assert.ok(Math.abs(mesh.normals[k]! - mesh.positions[k]!) < 1e-6);
  }
  const share = mesh.tones.reduce((a, b) => a + b, 0) / mesh.tones.length;
  assert.ok(Math.abs(share - 0.5) < 0.01);
});

test("a shell is seen from outside as well", () => {
  const mesh = meshOfGrid(body(true), ellipsoid([2, 2, 2], 1));
  assert.ok(mesh.hollow && volume(mesh) > 0);
});
