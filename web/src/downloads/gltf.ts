/** A body with its motion as a binary glTF file, which programs for drawing in space open. */

import type { Mesh } from "../engine/body_mesh";
import { channels, daylight } from "../page/palette";
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

/** The body (in its own axes, with a tone for each triangle) along a motion. Up is y there, z here. */
export function glb(title: string, mesh: Mesh, motion: Motion): Uint8Array {
  const buffer = new Buffer();
  const position = buffer.add(mesh.positions, "VEC3", true);
  const normal = buffer.add(mesh.normals, "VEC3", false);
  const primitives = [0, 1].map((tone) => {
    const chosen: number[] = [];
    mesh.tones.forEach((each, k) => {
      if (each === tone) chosen.push(mesh.indices[3 * k] ?? 0, mesh.indices[3 * k + 1] ?? 0, mesh.indices[3 * k + 2] ?? 0);
    });
    const indices = buffer.add(Uint32Array.from(chosen), "SCALAR", false);
    return { attributes: { POSITION: position, NORMAL: normal }, indices, material: tone };
  });
  const count = motion.times.length;
  const times = buffer.add(Float32Array.from(motion.times), "SCALAR", true);
  const centre = motion.columns["centre"];
  const places = buffer.add(Float32Array.from({ length: 3 * count }, (_, k) => centre?.[k] ?? 0), "VEC3", false);
  const turns = buffer.add(quaternions(motion, count), "VEC4", false);
  const tones = mesh.hollow ? daylight.shell : daylight.body;
  const document = {
    asset: { version: "2.0", generator: "chaplygin" },
    scene: 0,
    scenes: [{ name: title, nodes: [1] }],
    nodes: [
      { name: "body", mesh: 0 },
      { name: "space", children: [0], rotation: [-Math.SQRT1_2, 0, 0, Math.SQRT1_2] },
    ],
    meshes: [{ name: "body", primitives }],
    materials: tones.map((colour) => ({
      pbrMetallicRoughness: { baseColorFactor: [...channels(colour).map(linear), 1], metallicFactor: 0, roughnessFactor: 0.55 },
      doubleSided: true,
    })),
    animations: [
      {
        name: "motion",
        samplers: [
          { input: times, output: places, interpolation: "LINEAR" },
          { input: times, output: turns, interpolation: "LINEAR" },
        ],
        channels: [
          { sampler: 0, target: { node: 0, path: "translation" } },
          { sampler: 1, target: { node: 0, path: "rotation" } },
        ],
      },
    ],
    accessors: buffer.accessors,
    bufferViews: buffer.views,
    buffers: [{ byteLength: buffer.length }],
  };
  return container(JSON.stringify(document), buffer.bytes());
}

/** Attitudes in the order x, y, z, w, each on the side of the one before. */
function quaternions(motion: Motion, count: number): Float32Array {
  const attitude = motion.columns["attitude"];
  const out = new Float32Array(4 * count);
  let before = [0, 0, 0, 1];
  for (let n = 0; n < count; n++) {
    const [w = 1, x = 0, y = 0, z = 0] = [0, 1, 2, 3].map((k) => attitude?.[4 * n + k] ?? (k === 0 ? 1 : 0));
    const sign = x * (before[0] ?? 0) + y * (before[1] ?? 0) + z * (before[2] ?? 0) + w * (before[3] ?? 0) < 0 ? -1 : 1;
    before = [sign * x, sign * y, sign * z, sign * w];
    out.set(before, 4 * n);
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
