/** Triangles of a body that is given over a grid of directions. */

import type { Body } from "../model.js";

/** A closed surface in body axes; corners of faces with different normals are parted. */
export interface Mesh {
  positions: Float32Array;
  normals: Float32Array;
  /** Three corners of each triangle, anticlockwise as seen from outside. */
  indices: Uint32Array;
  /** For each triangle, which of the two colours of the body it has: octants alternate. */
  tones: Uint8Array;
  hollow: boolean;
}

/** Unit vectors γ of a grid, row by row. */
export function directions(theta: ArrayLike<number>, phi: ArrayLike<number>): Float64Array {
  const gamma = new Float64Array(3 * theta.length * phi.length);
  let at = 0;
  for (let i = 0; i < theta.length; i++) {
    for (let j = 0; j < phi.length; j++) {
      const sine = Math.sin(theta[i]!);
      gamma[at++] = sine * Math.cos(phi[j]!);
      gamma[at++] = sine * Math.sin(phi[j]!);
      gamma[at++] = Math.cos(theta[i]!);
    }
  }
  return gamma;
}

/**
 * The mesh over a grid, from the points r(γ) of the surface with the thickness of a flat body.
 * The two poles are closed by caps with corners of their own, as they are flat faces of a disk.
 */
export function meshOfGrid(body: Body, points: ArrayLike<number>): Mesh {
  const { theta, phi, hollow } = body;
  const rows = theta.length;
  const columns = phi.length;
  const gamma = directions(theta, phi);
  const side = hollow ? 1 : -1;
  const grid = rows * columns;
  const count = grid + 2 * (columns + 1);
  const positions = new Float32Array(3 * count);
  const normals = new Float32Array(3 * count);
  for (let k = 0; k < 3 * grid; k++) {
    positions[k] = points[k]!;
    normals[k] = side * gamma[k]!;
  }
  const indices: number[] = [];
  const tones: number[] = [];
  const face = (a: number, b: number, c: number, tone: number): void => {
    if (!turnsOutward(positions, normals, a, b, c)) [b, c] = [c, b];
    indices.push(a, b, c);
    tones.push(tone);
  };
  const quarter = (j: number): number => Math.floor((phi[j]! + 1e-9) / (Math.PI / 2));
  for (let i = 0; i + 1 < rows; i++) {
    const northern = (theta[i]! + theta[i + 1]!) / 2 < Math.PI / 2 ? 1 : 0;
    for (let j = 0; j < columns; j++) {
      const k = (j + 1) % columns;
      const tone = (quarter(j) + northern) % 2;
      face(i * columns + j, i * columns + k, (i + 1) * columns + k, tone);
      face(i * columns + j, (i + 1) * columns + k, (i + 1) * columns + j, tone);
    }
  }
  for (const north of [true, false]) {
    const ring = (north ? 0 : rows - 1) * columns;
    const first = grid + (north ? 0 : columns + 1);
    const middle = first + columns;
    const up = side * (north ? 1 : -1);
    for (let j = 0; j < columns; j++) {
      for (let c = 0; c < 3; c++) {
        const value = positions[3 * (ring + j) + c]!;
        positions[3 * (first + j) + c] = value;
        positions[3 * middle + c]! += value / columns;
      }
      normals[3 * (first + j) + 2] = up;
    }
    normals[3 * middle + 2] = up;
    for (let j = 0; j < columns; j++) {
      face(middle, first + j, first + ((j + 1) % columns), (quarter(j) + (north ? 1 : 0)) % 2);
    }
  }
  return {
    positions,
    normals,
    indices: Uint32Array.from(indices),
    tones: Uint8Array.from(tones),
    hollow,
  };
}

/** Whether a triangle shows its front where its corners' normals point. */
function turnsOutward(p: Float32Array, n: Float32Array, a: number, b: number, c: number): boolean {
  const u = [0, 1, 2].map((k) => p[3 * b + k]! - p[3 * a + k]!);
  const v = [0, 1, 2].map((k) => p[3 * c + k]! - p[3 * a + k]!);
  let sum = 0;
  for (let k = 0; k < 3; k++) {
    const i = (k + 1) % 3;
    const j = (k + 2) % 3;
    const normal = n[3 * a + k]! + n[3 * b + k]! + n[3 * c + k]!;
    sum += (u[i]! * v[j]! - u[j]! * v[i]!) * normal;
  }
  return sum >= 0;
}
