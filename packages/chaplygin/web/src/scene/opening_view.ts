/** The view with which a scene opens: the whole motion, from the side that shows it best. */

import { floats } from "../encoding";
import type { Scene } from "../model";
import { finiteSamples, pose, row, turned, type Motion, type Vector } from "../playback/motion";
import { capOpening } from "./cap";
import { box } from "./box";
import { largestLength, VECTOR_LENGTH } from "./measures";
import { across, framing, type View } from "./view";

/** Extent in diameters of the body up to which a path is shown as a whole. */
const WHOLE = 10;

/** The view of a scene; lengths in units of `size`. */
export function openingView(scene: Scene, motion: Motion, size: number, aspect = 1.6): View {
  const path = pathOf(scene, motion).map((place) => place / size);
  const { support } = scene;
  const around = [...withBody(centresOf(scene, motion, path, size)), ...arrowEnds(scene, motion, size), ...path];
  if (support?.kind === "sphere") {
    const radius = Math.abs(support.radius) / size;
    const { azimuth, elevation } = sphereDirection(path, support.inside);
    const opening = support.inside ? capOpening(path, -1, 0.3, 1.75) : capOpening(path, 1, Math.max(0.12, 0.75 / radius), 1.2);
    return framing([...around, ...rim(radius, support.inside, opening)], azimuth, elevation, aspect);
  }
  if (support?.kind === "mesh") {
    return framing([...around, ...floats(support.positions).map((place) => place / size)], across(path) + 0.3, 0.5, aspect);
  }
  if (support?.kind === "point" || (support === null && scene.path === null)) return framing(around, 0.6, 0.35, aspect);
  const azimuth = across(path) + 0.42;
  if (!leadsFar(scene, motion)) return framing(around, azimuth, 0.5, aspect);
  const near = [...withBody(centresOf(scene, motion, path, size).slice(0, 3))].map((place, k) => place + (k % 3 < 2 ? 1.1 * Math.sign(place - (path[k % 3] ?? 0)) : 0));
  return framing(near, azimuth, 0.5, aspect);
}

/** Where the middle of the body is, in units of its size. */
function centresOf(scene: Scene, motion: Motion, path: Float64Array, size: number): Float64Array {
  const count = finiteSamples(motion, "centre", 3);
  if (scene.path !== null || count === 0) return path;
  return (motion.columns["centre"] ?? path).slice(0, 3 * count).map((place) => place / size);
}

/** The ends of the arrow of ω, which is shown at first, at some instants. */
function* arrowEnds(scene: Scene, motion: Motion, size: number): Generator<number> {
  const vector = scene.vectors.find(({ column }) => column === "omega");
  const longest = largestLength(motion, "omega");
  if (vector === undefined || !(longest > 0)) return;
  const step = Math.max(1, Math.floor(motion.times.length / 60));
  for (let n = 0; n < motion.times.length; n += step) {
    const now = pose(motion, motion.times[n] ?? 0);
    const value = row(motion, "omega", 3, now.t) as Vector;
    const inSpace = vector.axes === "body" ? turned(now.attitude, value) : value;
    const from = vector.at === "contact" ? now.contact : now.centre;
    const end = from.map((place, i) => place / size + (VECTOR_LENGTH * (inSpace[i] ?? 0)) / longest);
    if (end.every(Number.isFinite)) yield* end;
  }
}

/** The points of a path and the corners of boxes of size one around some of them. */
function* withBody(path: Float64Array): Generator<number> {
  const count = path.length / 3;
  const step = Math.max(1, Math.floor(count / 60));
  for (let k = 0; k < count; k += step) {
    for (let corner = 0; corner < 8; corner++) {
      for (let i = 0; i < 3; i++) yield (path[3 * k + i] ?? 0) + ((corner >> i) & 1 ? 0.45 : -0.45);
    }
  }
}

/** Points of a cap of a sphere, or of a whole one. */
function* rim(radius: number, inside: boolean, opening: number): Generator<number> {
  for (let i = 1; i <= 6; i++) {
    const polar = (opening * i) / 6;
    for (let k = 0; k < 24; k++) {
      const angle = (Math.PI * k) / 12;
      yield radius * Math.sin(polar) * Math.cos(angle);
      yield radius * Math.sin(polar) * Math.sin(angle);
      yield (inside ? -1 : 1) * radius * Math.cos(polar);
    }
  }
}

/** Whether a motion leads so far from its start that the reader must follow the body. */
export function leadsFar(scene: Scene, motion: Motion): boolean {
  if (scene.support?.kind !== "plane" && scene.path === null) return false;
  const path = pathOf(scene, motion);
  if (path.length === 0) return false;
  const { low, high } = box(path);
  return Math.hypot(high[0] - low[0], high[1] - low[1]) > WHOLE * scene.size;
}

/** From where a path on a sphere is seen best. */
function sphereDirection(path: Float64Array, inside: boolean): { azimuth: number; elevation: number } {
  const mean = [0, 1, 2].map((k) => {
    let sum = 0;
    for (let n = k; n < path.length; n += 3) sum += path[n] ?? 0;
    return (3 * sum) / Math.max(3, path.length) + 0.8 * (path[path.length - 3 + k] ?? 0);
  });
  const length = Math.hypot(...mean) || 1;
  const height = Math.asin(Math.min(1, Math.max(-1, (mean[2] ?? 0) / length)));
  const nearPole = Math.hypot(mean[0] ?? 0, mean[1] ?? 0) < 0.35 * length;
  const azimuth = nearPole ? across(path) : Math.atan2(mean[1] ?? 0, mean[0] ?? 0) + 0.35;
  if (!inside) return { azimuth, elevation: Math.min(0.6, Math.max(-0.25, 0.6 * height)) };
  return { azimuth: azimuth + (nearPole ? 0 : Math.PI), elevation: height < -0.3 ? 0.62 : 0.35 };
}

/** The points (n, 3) through which the motion leads, metres. */
function pathOf(scene: Scene, motion: Motion): Float64Array {
  if (scene.path !== null) return planPoints(scene, motion);
  const name = motion.columns["contact"] ? "contact" : "centre";
  const count = finiteSamples(motion, name, 3);
  const path = (motion.columns[name] ?? new Float64Array(0)).slice(0, 3 * count);
  return path.length > 0 ? path : new Float64Array(3);
}

/** How far, in diameters, the ground around a path is drawn. */
export function reachOf(path: ArrayLike<number>, size: number): number {
  if (path.length === 0) return 3;
  const { low, high } = box(path);
  return 2.2 + Math.hypot(high[0] - low[0], high[1] - low[1]) / size;
}

/** The path (n, 3) of a mechanism in the plane. */
export function planPoints(scene: Scene, motion: Motion): Float64Array {
  const name = scene.path ?? "";
  const count = finiteSamples(motion, name, 2);
  const values = motion.columns[name];
  const points = new Float64Array(3 * count);
  for (let k = 0; k < count; k++) points.set([values?.[2 * k] ?? 0, values?.[2 * k + 1] ?? 0, 0], 3 * k);
  return points;
}
