/** Solids with their motion as a binary glTF file, which programs for drawing in space open. */

import type { Mesh } from "../engine/body_mesh";
import { channels as channelsOf, daylight } from "../page/palette";
import type { Motion } from "../playback/motion";

const FLOAT = 5126;
const UNSIGNED = 5125;

interface Accessor {
  bufferView: number;
  componentType: number;
  count: number;
  type: "SCALAR" | "VEC3" | "VEC4";
  min?: number[];
  max?: number[];
}

/** Arrays of a file one after another, with their accessors. */
class Buffer {
  readonly views: { buffer: 0; byteOffset: number; byteLength: number }[] = [];
  readonly accessors: Accessor[] = [];
  private readonly parts: ArrayBufferView[] = [];
  length = 0;

  add(values: Float32Array | Uint32Array, type: Accessor["type"], bounds: boolean): number {
    const width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[type];
    const accessor: Accessor = {
      bufferView: this.views.length,
      componentType: values instanceof Float32Array ? FLOAT : UNSIGNED,
      count: values.length / width,
      type,
    };
    if (bounds) {
      const column = (k: number): number[] => Array.from({ length: accessor.count }, (_, n) => values[n * width + k] ?? 0);
      const columns = Array.from({ length: width }, (_, k) => column(k));
      accessor.min = columns.map((each) => each.reduce((a, b) => Math.min(a, b), Infinity));
      accessor.max = columns.map((each) => each.reduce((a, b) => Math.max(a, b), -Infinity));
    }
    this.views.push({ buffer: 0, byteOffset: this.length, byteLength: values.byteLength });
    this.parts.push(values);
    this.length += values.byteLength;
    return this.accessors.push(accessor) - 1;
  }

  bytes(): Uint8Array {
    const all = new Uint8Array(this.length);
    let offset = 0;
    for (const part of this.parts) {
      all.set(new Uint8Array(part.buffer, part.byteOffset, part.byteLength), offset);
      offset += part.byteLength;
    }
    return all;
  }
}

/** Triangles of one colour. */
export interface Coat {
  colour: string;
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/** A solid in its own axes, and where it is at each of the instants of a motion; its attitudes are (w, x, y, z). */
export interface MovingSolid {
  name: string;
  coats: Coat[];
  places: Float64Array;
  attitudes: Float64Array;
  scales?: Float64Array;
}

/** A body along a motion. */
export function movingBody(mesh: Mesh, motion: Motion): MovingSolid {
  const { positions, normals } = mesh;
  const colours = mesh.hollow ? daylight.shell : daylight.body;
  const coats = colours.map((colour, tone) => {
    const chosen: number[] = [];
    mesh.tones.forEach((each, k) => {
      if (each === tone) chosen.push(...mesh.indices.subarray(3 * k, 3 * k + 3));
    });
    return { colour, positions, normals, indices: Uint32Array.from(chosen) };
  });
  const count = motion.times.length;
  const column = (name: string, width: number): Float64Array => motion.columns[name] ?? new Float64Array(width * count).fill(NaN);
  return { name: "body", coats: coats.filter(({ indices }) => indices.length > 0), places: column("centre", 3), attitudes: column("attitude", 4) };
}

/** Solids along a motion, at the instants at which all of them have a place. Up is y there, z here. */
export function glb(title: string, times: Float64Array, solids: readonly MovingSolid[]): Uint8Array {
  const buffer = new Buffer();
  const here = (values: Float64Array, n: number): boolean => {
    const width = values.length / times.length;
    return values.subarray(width * n, width * n + width).every(Number.isFinite);
  };
  const good = Array.from(times.keys()).filter((n) => solids.every(({ places, attitudes }) => here(places, n) && here(attitudes, n)));
  const chosen = (values: Float64Array): Float32Array => {
    const width = values.length / times.length;
    return Float32Array.from(good.flatMap((n) => Array.from(values.subarray(width * n, width * n + width))));
  };
  const stored = new Map<Float32Array, number>();
  const once = (values: Float32Array, bounds: boolean): number => {
    const index = stored.get(values) ?? buffer.add(values, "VEC3", bounds);
    stored.set(values, index);
    return index;
  };
  const began = times[good[0] ?? 0] ?? 0;
  const input = buffer.add(Float32Array.from(good, (n) => Math.abs((times[n] ?? 0) - began)), "SCALAR", true);
  const colours = [...new Set(solids.flatMap(({ coats }) => coats.map(({ colour }) => colour)))];
  const samplers: { input: number; output: number; interpolation: "LINEAR" }[] = [];
  const channels: { sampler: number; target: { node: number; path: string } }[] = [];
  const drive = (node: number, path: string, output: number): void => {
    channels.push({ sampler: samplers.push({ input, output, interpolation: "LINEAR" }) - 1, target: { node, path } });
  };
  const meshes = solids.map(({ name, coats, places, attitudes, scales }, k) => {
    drive(k + 1, "translation", buffer.add(chosen(places), "VEC3", false));
    drive(k + 1, "rotation", buffer.add(quaternions(chosen(attitudes)), "VEC4", false));
    if (scales !== undefined) drive(k + 1, "scale", buffer.add(chosen(scales), "VEC3", false));
    const primitives = coats.map(({ colour, positions, normals, indices }) => ({
      attributes: { POSITION: once(positions, true), NORMAL: once(normals, false) },
      indices: buffer.add(indices, "SCALAR", false),
      material: colours.indexOf(colour),
    }));
    return { name, primitives };
  });
  const document = {
    asset: { version: "2.0", generator: "chaplygin" },
    scene: 0,
    scenes: [{ name: title, nodes: [0] }],
    nodes: [
      { name: "space", children: solids.map((_, k) => k + 1), rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] },
      ...solids.map(({ name }, k) => ({ name, mesh: k })),
    ],
    meshes,
    materials: colours.map((colour) => ({
      pbrMetallicRoughness: { baseColorFactor: [...channelsOf(colour).map(linear), 1], metallicFactor: 0, roughnessFactor: 0.55 },
      doubleSided: true,
    })),
    animations: [{ name: "motion", samplers, channels }],
    accessors: buffer.accessors,
    bufferViews: buffer.views,
    buffers: [{ byteLength: buffer.length }],
  };
  return container(JSON.stringify(document), buffer.bytes());
}

/** Attitudes (w, x, y, z) in the order x, y, z, w, each on the side of the one before. */
function quaternions(attitudes: Float32Array): Float32Array {
  const out = new Float32Array(attitudes.length);
  let before = [0, 0, 0, 1];
  for (let n = 0; n < attitudes.length; n += 4) {
    const [w = 1, x = 0, y = 0, z = 0] = attitudes.subarray(n, n + 4);
    const sign = x * (before[0] ?? 0) + y * (before[1] ?? 0) + z * (before[2] ?? 0) + w * (before[3] ?? 0) < 0 ? -1 : 1;
    before = [sign * x, sign * y, sign * z, sign * w];
    out.set(before, n);
  }
  return out;
}

/** A channel of a colour for light that is added, from 0 to 1. */
function linear(channel: number): number {
  const share = channel / 255;
  return share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4;
}

function container(json: string, binary: Uint8Array): Uint8Array {
  const text = new TextEncoder().encode(json);
  const textLength = 4 * Math.ceil(text.length / 4);
  const binaryLength = 4 * Math.ceil(binary.length / 4);
  const total = 12 + 8 + textLength + 8 + binaryLength;
  const out = new Uint8Array(total);
  const view = new DataView(out.buffer);
  const words = [0x46546c67, 2, total, textLength, 0x4e4f534a];
  words.forEach((word, k) => view.setUint32(4 * k, word, true));
  out.fill(0x20, 20, 20 + textLength);
  out.set(text, 20);
  view.setUint32(20 + textLength, binaryLength, true);
  view.setUint32(24 + textLength, 0x004e4942, true);
  out.set(binary, 28 + textLength);
  return out;
}
