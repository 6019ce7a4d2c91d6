/** Ellipsoids as meshes. */

import type { Mesh } from "../engine/body_mesh";
import { turned, type Quaternion, type Vector } from "../playback/motion";

/** An ellipsoid with given semi-axes along axes turned by a quaternion. */
export function ellipsoid(axes: Vector, turn: Quaternion, rows = 32, columns = 64): Omit<Mesh, "tones"> {
  const positions: number[] = [];
  const normals: number[] = [];
  const indices: number[] = [];
  for (let i = 0; i <= rows; i++) {
    const theta = (Math.PI * i) / rows;
    for (let k = 0; k < columns; k++) {
      const phi = (2 * Math.PI * k) / columns;
      const out: Vector = [Math.sin(theta) * Math.cos(phi), Math.sin(theta) * Math.sin(phi), Math.cos(theta)];
      const slope = out.map((part, n) => part / (axes[n] ?? 1)) as Vector;
      const length = Math.hypot(...slope);
      positions.push(...turned(turn, out.map((part, n) => part * (axes[n] ?? 1)) as Vector));
      normals.push(...turned(turn, slope.map((part) => part / length) as Vector));
      if (i === rows) continue;
      const [a, b] = [i * columns + k, i * columns + ((k + 1) % columns)];
      indices.push(a, a + columns, b + columns, a, b + columns, b);
    }
  }
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals), indices: Uint32Array.from(indices), hollow: false };
}
