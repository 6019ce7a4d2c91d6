import assert from "node:assert/strict";
import { test } from "node:test";
import { correction, dot, norm, orthonormal, shortestStep } from "../src/engine/linear.js";

const rows = [
  [1, 2, 0, -1],
  [0, 1, 1, 3],
].map((row) => Float64Array.from(row));

test("the shortest step solves the equations and is a combination of their rows", () => {
  const misses = [3, -2];
  const step = shortestStep({ rows, misses }, 4);
  rows.forEach((row, i) => assert.ok(Math.abs(dot(row, step) - misses[i]!) < 1e-14));
  // orthogonal to what the rows leave open
  const open = [Float64Array.from([2, -1, 1, 0]), Float64Array.from([7, -3, 0, 1])];
  for (const vector of open) {
    assert.ok(rows.every((row) => Math.abs(dot(row, vector)) < 1e-14));
    assert.ok(Math.abs(dot(vector, step)) < 1e-13);
  }
});

test("a row that says the same again changes nothing", () => {
  const again = Float64Array.from(rows[0]!, (x) => 2 * x);
  const plain = shortestStep({ rows, misses: [3, -2] }, 4);
  const twice = shortestStep({ rows: [...rows, again], misses: [3, -2, 6] }, 4);
  plain.forEach((x, k) => assert.ok(Math.abs(x - twice[k]!) < 1e-14));
});

test("of rows that nearly depend on each other, what rounding leaves is no direction", () => {
  // a unit vector near the plane z = 0: its length says again what its components do
  const z = 3e-8;
  const x = Math.sqrt(1 - z * z);
  const dependent = [[2 * x, 0, 2 * z], [1, 0, 0], [0, 1, 0], [0, 0, 1]].map((row) => Float64Array.from(row));
  const rounding = [1e-16, 0, 0, 2e-16];
  const step = correction({ rows: dependent, misses: rounding }, 3);
  assert.ok(norm(step) < 1e-15, `${norm(step)}`);
});

test("vectors are made orthonormal; those that depend on others are left out", () => {
  const sum = rows[0]!.map((x, k) => x - 3 * rows[1]![k]!);
  const basis = orthonormal([...rows, sum]);
  assert.equal(basis.length, 2);
  assert.ok(Math.abs(norm(basis[0]!) - 1) < 1e-15 && Math.abs(dot(basis[0]!, basis[1]!)) < 1e-15);
});
