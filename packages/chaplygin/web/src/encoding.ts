/** Numbers of the page model, which are base64 of little-endian arrays. */

import type { Doubles, Floats, Integers } from "./model.js";

export function bytes(text: string): Uint8Array<ArrayBuffer> {
  const raw = atob(text);
  const result = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) result[i] = raw.charCodeAt(i);
  return result;
}

export function doubles(text: Doubles): Float64Array {
  return new Float64Array(bytes(text).buffer);
}

export function floats(text: Floats): Float32Array {
  return new Float32Array(bytes(text).buffer);
}

export function integers(text: Integers): Uint32Array {
  return new Uint32Array(bytes(text).buffer);
}

/** The bytes of a text that was deflated (zlib) before it became base64. */
export async function inflated(text: string): Promise<ArrayBuffer> {
  const stream = new Blob([bytes(text)]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).arrayBuffer();
}
