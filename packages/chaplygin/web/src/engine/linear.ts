/** A little linear algebra: few equations in few unknowns. */

/** Rows of a slope matrix and what each still misses. */
export interface Equations {
  rows: Float64Array[];
  misses: number[];
}

/** A row is dependent on earlier ones if so small a share of it is left. */
const DEPENDENT = 1e-9;

/** The shortest step that makes up for what is missed; rows that depend on others are left out. */
export function shortestStep({ rows, misses }: Equations, size: number): Float64Array {
  const step = new Float64Array(size);
  const basis: Float64Array[] = [];
  rows.forEach((row, i) => {
    const left = Float64Array.from(row);
    const whole = norm(row);
    for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(left, q);
    const length = norm(left);
    if (!(length > DEPENDENT * whole)) return;
    for (let k = 0; k < size; k++) left[k]! /= length;
    const share = (misses[i]! - dot(row, step)) / length;
    for (let k = 0; k < size; k++) step[k]! += share * left[k]!;
    basis.push(left);
  });
  return step;
}

/**
 * The same for rows that nearly depend on each other, where little is missed: the row of which most is left comes next, so
 * that what rounding leaves of a row is no direction.
 */
export function correction({ rows, misses }: Equations, size: number): Float64Array {
  const step = new Float64Array(size);
  const left = rows.map((row) => Float64Array.from(row));
  const whole = rows.map(norm);
  const share = (i: number): number => norm(left[i]!) / (whole[i]! || 1);
  const open = new Set(rows.keys());
  while (open.size > 0) {
    const i = [...open].reduce((a, b) => (share(b) > share(a) ? b : a));
    open.delete(i);
    const length = norm(left[i]!);
    if (!(length > DEPENDENT * whole[i]!)) break;
    const q = left[i]!.map((x) => x / length);
    const way = (misses[i]! - dot(rows[i]!, step)) / length;
    for (let k = 0; k < size; k++) step[k]! += way * q[k]!;
    // twice, as rounding leaves something the first time
    for (const j of open) for (let pass = 0; pass < 2; pass++) remove(left[j]!, q);
  }
  return step;
}

/** Vectors made orthonormal; those that depend on earlier ones are left out. */
export function orthonormal(vectors: readonly Float64Array[]): Float64Array[] {
  const basis: Float64Array[] = [];
  for (const vector of vectors) {
    const left = Float64Array.from(vector);
    const whole = norm(vector);
    for (let pass = 0; pass < 2; pass++) for (const q of basis) remove(left, q);
    const length = norm(left);
    if (length > DEPENDENT * whole) basis.push(left.map((x) => x / length));
  }
  return basis;
}

/** Subtract from a vector, in place, its part along a unit vector. */
export function remove(vector: Float64Array, q: Float64Array): void {
  const share = dot(vector, q);
  for (let k = 0; k < vector.length; k++) vector[k]! -= share * q[k]!;
}

export function dot(a: Float64Array, b: Float64Array): number {
  let sum = 0;
  for (let k = 0; k < a.length; k++) sum += a[k]! * b[k]!;
  return sum;
}

export function norm(a: Float64Array): number {
  return Math.sqrt(dot(a, a));
}
