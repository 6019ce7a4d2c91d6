/** Parts of a sphere. */

/** Angle from the pole to the rim of a cap around a path (n, 3) on a sphere; π for a whole sphere. */
export function capOpening(path: ArrayLike<number>, pole: 1 | -1, room: number, widest: number): number {
  let farthest = 0;
  for (let k = 0; k + 2 < path.length; k += 3) {
    const [x, y, z] = [path[k] ?? 0, path[k + 1] ?? 0, path[k + 2] ?? 0];
    const length = Math.hypot(x, y, z);
    if (length > 0) farthest = Math.max(farthest, Math.acos(Math.min(1, Math.max(-1, (pole * z) / length))));
  }
  return farthest + room < widest ? farthest + room : Math.PI;
}
