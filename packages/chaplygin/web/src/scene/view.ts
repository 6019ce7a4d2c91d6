/** From where the reader looks. Lengths are in diameters of what is drawn. */

import type { Vector } from "../playback/motion";

/** A place around a target, which is in the middle of the picture. */
export interface View {
  azimuth: number;
  elevation: number;
  distance: number;
  target: Vector;
}

/** A view as text for an address, with its target where the reader has moved it. */
export function viewText({ azimuth, elevation, distance, target }: View, moved: boolean): string {
  return [azimuth, elevation, distance, ...(moved ? target : [])].map((value) => Number(value.toPrecision(5))).join(" ");
}

/** The view of a text; null where it is none. */
export function viewOf(text: string, target: Vector): { view: View; moved: boolean } | null {
  const numbers = text.split(/[ +]/).map(Number);
  const moved = numbers.length === 6;
  if (!(moved || numbers.length === 3) || !numbers.every(Number.isFinite) || !((numbers[2] ?? 0) > 0)) return null;
  const [azimuth = 0, elevation = 0, distance = 1, ...place] = numbers;
  return { view: { azimuth, elevation, distance, target: moved ? (place as Vector) : target }, moved };
}

const HIGHEST = Math.PI / 2 - 0.02;

/** Angle between the top and the bottom of the picture. */
export const FIELD = (30 * Math.PI) / 180;

/** Unit vector of space from the target to the reader. */
export function toward({ azimuth, elevation }: View): Vector {
  const flat = Math.cos(elevation);
  return [flat * Math.cos(azimuth), flat * Math.sin(azimuth), Math.sin(elevation)];
}

/** Where the reader's eye is. */
export function eye(view: View): Vector {
  const out = toward(view);
  return view.target.map((place, k) => place + view.distance * (out[k] ?? 0)) as Vector;
}

/** The view after a drag by parts of the picture's height. */
export function orbited(view: View, right: number, down: number): View {
  return {
    ...view,
    azimuth: view.azimuth - Math.PI * right,
    elevation: Math.min(Math.max(view.elevation + Math.PI * down, -HIGHEST), HIGHEST),
  };
}

/** The view from a distance times `factor`. */
export function zoomed(view: View, factor: number): View {
  return { ...view, distance: Math.min(Math.max(view.distance * factor, 0.8), 4000) };
}

/** The view with its target moved in the plane of the picture, by parts of its height. */
export function panned(view: View, right: number, down: number): View {
  const scale = 2 * view.distance * Math.tan(FIELD / 2);
  const { azimuth, elevation } = view;
  const across: Vector = [-Math.sin(azimuth), Math.cos(azimuth), 0];
  const upward: Vector = [
    -Math.sin(elevation) * Math.cos(azimuth),
    -Math.sin(elevation) * Math.sin(azimuth),
    Math.cos(elevation),
  ];
  return {
    ...view,
    target: view.target.map(
      (place, k) => place + scale * (down * (upward[k] ?? 0) - right * (across[k] ?? 0)),
    ) as Vector,
  };
}

/** The view from a direction in which points (n, 3) fill the picture; `aspect` is width over height. */
export function framing(points: ArrayLike<number>, azimuth: number, elevation: number, aspect: number): View {
  const direction: View = { azimuth, elevation, distance: 1, target: [0, 0, 0] };
  const near = toward(direction);
  const right: Vector = [-Math.sin(azimuth), Math.cos(azimuth), 0];
  const up: Vector = [
    -Math.sin(elevation) * Math.cos(azimuth),
    -Math.sin(elevation) * Math.sin(azimuth),
    Math.cos(elevation),
  ];
  const tall = Math.tan(FIELD / 2) * ROOM;
  const wide = tall * aspect;
  const middle = { x: 0, y: 0 };
  let distance = 1;
  // the picture is centred anew for the distance found: twice is enough for the eye
  for (let round = 0; round < 3; round++) {
    const sides = { left: Infinity, right: -Infinity, low: Infinity, high: -Infinity };
    let needed = 1;
    for (let k = 0; k + 2 < points.length; k += 3) {
      const place: Vector = [points[k] ?? 0, points[k + 1] ?? 0, points[k + 2] ?? 0];
      const [x, y, z] = [dot(place, right) - middle.x, dot(place, up) - middle.y, dot(place, near)];
      needed = Math.max(needed, z + Math.max(Math.abs(x) / wide, Math.abs(y) / tall));
      const scale = round === 0 ? 1 : distance / Math.max(1e-6, distance - z);
      sides.left = Math.min(sides.left, x * scale);
      sides.right = Math.max(sides.right, x * scale);
      sides.low = Math.min(sides.low, y * scale);
      sides.high = Math.max(sides.high, y * scale);
    }
    distance = needed;
    if (round === 2) break;
    middle.x += (sides.left + sides.right) / 2;
    middle.y += (sides.low + sides.high) / 2;
  }
  const target = [0, 1, 2].map((k) => middle.x * (right[k] ?? 0) + middle.y * (up[k] ?? 0)) as Vector;
  return { azimuth, elevation, distance, target };
}

/** Share of the picture that is filled. */
const ROOM = 0.92;

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** The azimuth from which points (n, 3) extend most from left to right. */
export function across(points: ArrayLike<number>): number {
  const count = Math.floor(points.length / 3);
  let [mx, my] = [0, 0];
  for (let k = 0; k < count; k++) {
    mx += (points[3 * k] ?? 0) / count;
    my += (points[3 * k + 1] ?? 0) / count;
  }
  let [xx, xy, yy] = [0, 0, 0];
  for (let k = 0; k < count; k++) {
    const [x, y] = [(points[3 * k] ?? 0) - mx, (points[3 * k + 1] ?? 0) - my];
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  if (!(xx + yy > 0)) return 0;
  const along = 0.5 * Math.atan2(2 * xy, xx - yy);
  const end = count - 1;
  const forward =
    Math.cos(along) * ((points[3 * end] ?? 0) - (points[0] ?? 0)) +
    Math.sin(along) * ((points[3 * end + 1] ?? 0) - (points[1] ?? 0));
  const sign = forward < 0 ? -1 : 1;
  return Math.atan2(-sign * Math.cos(along), sign * Math.sin(along));
}
