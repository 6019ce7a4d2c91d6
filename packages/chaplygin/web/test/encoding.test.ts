import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { doubles, floats, inflated, integers } from "../src/encoding.js";

const text = (array: ArrayBufferView): string =>
  Buffer.from(array.buffer, array.byteOffset, array.byteLength).toString("base64");

test("numbers come back to the bit", () => {
  const numbers = Float64Array.from([0.1, -1 / 3, 5e-324, Infinity]);
  assert.deepEqual(doubles(text(numbers)), numbers);
  const single = Float32Array.from([0.1, 7]);
  assert.deepEqual(floats(text(single)), single);
  const whole = Uint32Array.from([0, 4294967295]);
  assert.deepEqual(integers(text(whole)), whole);
});

test("deflated bytes come back", async () => {
  const code = new Uint8Array(1000).map((_, i) => (i * i) % 251);
  assert.deepEqual(new Uint8Array(await inflated(text(deflateSync(code)))), code);
});
