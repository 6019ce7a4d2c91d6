import assert from "node:assert/strict";
import { test } from "node:test";
import { editedExperiment } from "../src/downloads/experiment_file";
import { glb, movingBody } from "../src/downloads/gltf";
import { movingLinkage } from "../src/scene/linkage";
import { plotsSvg, sectionSvg } from "../src/downloads/svg";
import { csv, sectionCsv } from "../src/downloads/table";
import { ellipsoid } from "../src/scene/ellipsoid";
import type { Motion } from "../src/playback/motion";

const FILE = `[system.parameters]
I_1 = 1.0 # first

[body]
mass = 1.0
inertia = [[0.0002, -2e-05, 0.0], [-2e-05, 0.0016, 0.0], [0.0, 0.0, 0.0017]]

[parameters]
l = { value = 0.8, unit = "m", meaning = "length" }

[start]
omega = [0.0, 0.0, -5.0]
heading = 0.0

[run]
until = 8.0
`;

test("a changed number is written into its place, and nothing else changes", () => {
  const text = editedExperiment(
    FILE,
    [{ name: "I_1", value: 2.5, usual: 1 }, { name: "m", value: 3, usual: 1 }, { name: "I_12", value: 1e-5, usual: -2e-5 }, { name: "l", value: 0.9, usual: 0.8 }],
    [{ name: "omega_1", value: 0, usual: 0 }, { name: "omega_2", value: -0.1, usual: 0 }, { name: "omega_3", value: -5, usual: -5 }, { name: "heading", value: 1, usual: 0 }, { name: "x", value: 0, usual: 0 }],
    20,
  );
  const wanted = FILE.replace("I_1 = 1.0", "I_1 = 2.5")
    .replace("mass = 1.0", "mass = 3")
    .replaceAll("-2e-05", "0.00001")
    .replace("value = 0.8", "value = 0.9")
    .replace("omega = [0.0, 0.0,", "omega = [0.0, -0.1,")
    .replace("heading = 0.0", "heading = 1")
    .replace("until = 8.0", "until = 20");
  assert.equal(text, wanted);
  assert.equal(editedExperiment(FILE, [], [], null), FILE);
});

test("a change without a place is said above the file", () => {
  const text = editedExperiment(FILE, [{ name: "b_1", value: 0.3, usual: 0.2 }], [], null);
  assert.ok(text.startsWith("# b_1 = 0.3 was set in the page"));
  assert.ok(text.endsWith(FILE));
});

test("numbers of a shape, a surface and a formula have their own tables", () => {
  const file = `[body.shape]
centre = [0.0, 0.1, 0.0]
axes = [0.2, 0.03, 0.02]

[surface]
radius = 0.1

[parameters.P]
value = [0.0, 0.0, 0.4]

[body.shape.parameters]
e = 0.18
`;
  const usual = { c_2: 0.1, b_3: 0.02, a: -0.1, P_3: 0.4, e: 0.18 };
  const numbers = Object.entries(usual).map(([name, value]) => ({ name, value: 2 * value, usual: value }));
  const wanted = file.replace("0.1, 0.0]", "0.2, 0.0]").replace("0.02]", "0.04]").replace("radius = 0.1", "radius = 0.2").replace("0.4]", "0.8]").replace("0.18", "0.36");
  assert.equal(editedExperiment(file, numbers, [], null), wanted);
});

test("a number that the file gives otherwise is left alone", () => {
  // the mass of a ball with a fluid in it is not that of the shell
  const text = editedExperiment(FILE, [{ name: "m", value: 3, usual: 2.8 }], [], null);
  assert.ok(text.startsWith("# m = 3 was set in the page") && text.endsWith(FILE));
});

test("of two equal moments the file has one, and changes both: what the page shows is said", () => {
  const moments = [{ name: "I_1", value: 2.5, usual: 1 }, { name: "I_2", value: 1, usual: 1 }];
  const text = editedExperiment("[system.parameters]\nI_1 = 1.0\n", moments, [], null);
  assert.equal(text, "# I_2 = 1 was set in the page; this file has no such entry\n\n[system.parameters]\nI_1 = 2.5\n");
});

test("a start may name further variables of a system, and a ball on a surface its centre", () => {
  const numbers = (names: string[], values: number[]) => names.map((name, k) => ({ name, value: values[k] ?? 0, usual: 0 }));
  const system = '[system]\nname = "trailers"\n\n[start]\nu = 1.0\n';
  const text = editedExperiment(system, [], numbers(["x", "q_w", "q_x"], [0.5, 0, 1]), null);
  assert.equal(text, system.replace("[start]\n", "[start]\nq = [0, 1]\nx = 0.5\n"));
  const ball = "[body]\nmass = 1.0\n\n[start]\ncontact = [0.054, 0.0, 0.0]\n";
  const moved = editedExperiment(ball, [], numbers(["R_1", "R_2", "R_3"], [0.03, 0, 0.2]), null);
  assert.equal(moved, ball.replace("contact = [0.054, 0.0, 0.0]", "centre = [0.03, 0, 0.2]"));
});

const motion: Motion = {
  times: Float64Array.of(0, 0.5, 1),
  columns: {
    omega: Float64Array.of(1, 2, 3, 4, 5, 6, 7, NaN, 0.1),
    attitude: Float64Array.of(1, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0),
    centre: Float64Array.of(0, 0, 1, 0, 0, 2, 0, 0, 3),
  },
  end: null,
};

test("a table has every number in full, and nothing where there is none", () => {
  const text = csv(motion, [{ name: "omega", width: 3, axes: "body", unit: "rad/s", meaning: "", mathml: "" }]);
  assert.equal(text, "time (s),omega_1 (rad/s),omega_2 (rad/s),omega_3 (rad/s)\n0,1,2,3\n0.5,4,5,6\n1,7,,0.1\n");
  assert.equal(sectionCsv(["x, y", "z"], [{ x: Float64Array.of(1), y: Float64Array.of(2), number: 0 }]), 'orbit,"x, y",z\n1,1,2\n');
});

test("a drawing is well formed, interrupted where values are missing", () => {
  const text = plotsSvg("a < b & c", motion.times, [{ label: "ω", unit: "rad/s", components: [{ label: "ω₁", values: Float64Array.of(1, NaN, 2) }] }]);
  assert.ok(text.includes("a &lt; b &amp; c"));
  const path = /<path d="(M[^"]*)" fill="none" stroke="#004488"/.exec(text)?.[1] ?? "";
  assert.equal(path.match(/M/g)?.length, 2);
  for (const tag of ["svg", "text", "g"]) assert.equal(text.split(`<${tag}`).length, text.split(`</${tag}>`).length, tag);
  assert.ok(!/NaN|undefined/.test(text));
  const section = sectionSvg("s", { label: "x", range: [0, 1] }, { label: "y", range: [0, 1] }, [{ x: [0.5, 7], y: [0.5, 0.5], colour: "#332288" }]);
  assert.equal(section.match(/h0/g)?.length, 1);
});

/** The document of a binary glTF file, and its numbers. */
function opened(bytes: Uint8Array): { document: any; read: (index: number) => Float32Array } {
  const view = new DataView(bytes.buffer);
  assert.equal(view.getUint32(0, true), 0x46546c67);
  assert.equal(view.getUint32(8, true), bytes.length);
  const length = view.getUint32(12, true);
  const document = JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length)));
  const binary = bytes.subarray(28 + length);
  assert.equal(document.buffers[0].byteLength <= binary.length, true);
  const read = (index: number): Float32Array => {
    const accessor = document.accessors[index];
    const { byteOffset, byteLength } = document.bufferViews[accessor.bufferView];
    return new Float32Array(binary.slice(byteOffset, byteOffset + byteLength).buffer);
  };
  return { document, read };
}

test("a binary glTF holds the body and its motion", () => {
  const mesh = ellipsoid([3, 2, 1], [1, 0, 0, 0], 6, 8);
  const tones = Uint8Array.from({ length: mesh.indices.length / 3 }, (_, k) => k % 2);
  const bytes = glb("body", motion.times, [movingBody({ ...mesh, tones }, motion)]);
  const { document, read } = opened(bytes);
  const [places, turns] = document.animations[0].samplers;
  assert.deepEqual(Array.from(read(places.input)), [0, 0.5, 1]);
  assert.deepEqual(Array.from(read(places.output)), [0, 0, 1, 0, 0, 2, 0, 0, 3]);
  // the second attitude is the first with the other sign: the body does not turn
  assert.deepEqual(Array.from(read(turns.output)).map((value) => value + 0), [0, 0, 0, 1, 0, 0, 0, 1, 1, 0, 0, 0]);
  const counted = document.meshes[0].primitives.reduce((sum: number, { indices }: { indices: number }) => sum + document.accessors[indices].count, 0);
  assert.equal(counted, mesh.indices.length);
});

test("a binary glTF holds the parts of a mechanism, as long as all of them have a place", () => {
  const columns = { rod: Float64Array.of(0, 0, 2, 0, 0, 0, 0, 2, NaN, 0, 0, 2), axle: Float64Array.of(0, 0, 0, 1, 0, Math.PI / 2, 2, 0, 0) };
  const backward: Motion = { times: Float64Array.of(0, -0.5, -1), columns, end: null };
  const solids = movingLinkage([{ kind: "rod", column: "rod" }, { kind: "axle", column: "axle" }], 0.2, backward);
  const { document, read } = opened(glb("trailer", backward.times, solids));
  assert.deepEqual(document.nodes.map(({ name }: { name: string }) => name), ["space", "rod 1", "axle 1"]);
  const { samplers, channels } = document.animations[0];
  const moves = channels.map(({ target }: { target: { node: number; path: string } }) => `${target.node} ${target.path}`);
  assert.deepEqual(moves, ["1 translation", "1 rotation", "1 scale", "2 translation", "2 rotation"]);
  const numbers = samplers.map(({ output }: { output: number }) => Array.from(read(output), (value) => Math.round(1e4 * value) / 1e4));
  assert.deepEqual(Array.from(read(samplers[0].input)), [0, 0.5]);
  assert.deepEqual(numbers[0], [1, 0, 0.1, 0, 1, 0.1]);
  assert.deepEqual(numbers[1], [0, 0, 0, 1, 0, 0, 0.7071, 0.7071]);
  assert.deepEqual(numbers[2], [2, 1, 1, 2, 1, 1]);
  // the wheels of an axle stand on the ground, on both sides of its bar
  const [bar, left, right] = document.meshes[1].primitives.map(({ attributes }: { attributes: { POSITION: number } }) => document.accessors[attributes.POSITION]);
  assert.ok(Math.abs(left.min[2]) < 1e-6 && Math.abs(right.min[2]) < 1e-6 && bar.min[2] > 0.05);
  assert.ok(left.min[1] > 0.08 && right.max[1] < -0.08);
  assert.equal(document.materials.length, 2);
});
