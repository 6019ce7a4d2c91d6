/** What carries the body: a plane with a grid, a sphere, any surface. */

import {
  BackSide,
  BufferAttribute,
  BufferGeometry,
  CircleGeometry,
  Color,
  CylinderGeometry,
  FrontSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  PlaneGeometry,
  ShaderMaterial,
  ShadowMaterial,
  SphereGeometry,
  Vector3,
  type Side,
} from "three";
import type { Triangles } from "../engine/surfaces";
import type { Palette } from "../page/palette";
import { roundNumber } from "../page/numbers";
import type { Vector } from "../playback/motion";
import { box } from "./box";

export interface Ground {
  group: Group;
  /** Spacing of its grid, or length of its axes, in metres; 0 without either. */
  spacing: number;
  axes?: true;
  /** Move what follows the reader's target. */
  around(target: Vector, reach: number, body: Vector, shadow: number): void;
}

/** The plane z = 0, with a grid that fades around the target, and shadows. */
export function planeGround(spacing: number, colours: Palette): Ground {
  const group = new Group();
  const grid = new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: {
      colour: { value: new Color(colours.grid) },
      spacing: { value: spacing },
      middle: { value: new Vector3() },
      reach: { value: 1 },
    },
    vertexShader: `varying vec2 vPlace;
      void main() { vec4 place = modelMatrix * vec4(position, 1.0); vPlace = position.xy;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`,
    fragmentShader: `varying vec2 vPlace; uniform vec3 colour; uniform float spacing; uniform vec3 middle; uniform float reach;
      void main() {
        vec2 line = vPlace / spacing; vec2 width = fwidth(line);
        vec2 off = abs(fract(line - 0.5) - 0.5);
        vec2 ink = (1.0 - smoothstep(0.1 * width, 0.85 * width, off)) * (1.0 - smoothstep(0.1, 0.5, width));
        float fade = 1.0 - smoothstep(0.25, 1.0, distance(vPlace, middle.xy) / reach);
        float alpha = 0.75 * max(ink.x, ink.y) * fade * fade;
        if (alpha < 0.004) discard;
        gl_FragColor = vec4(colour, alpha);
        #include <colorspace_fragment>
      }`,
  });
  const lines = new Mesh(new CircleGeometry(1, CORNERS), grid);
  const shadow = new Mesh(new PlaneGeometry(1, 1), new ShadowMaterial({ opacity: colours.shadow, depthWrite: false }));
  shadow.receiveShadow = true;
  lines.renderOrder = -2;
  shadow.renderOrder = -1;
  lines.frustumCulled = shadow.frustumCulled = false;
  group.add(lines, shadow);
  const [disk, sheet] = [lines, shadow].map((mesh) => mesh.geometry.getAttribute("position") as BufferAttribute);
  const round = Float32Array.from(disk?.array ?? []);
  // a circle lies within its corners
  const outward = 1 / Math.cos(Math.PI / CORNERS);
  return {
    group,
    spacing,
    around(target, reach, body, shadowed) {
      // corners are moved rather than the mesh: the grid stays where it is in space
      stretched(disk, round, target, outward * reach);
      stretched(sheet, SQUARE, body, shadowed);
      (grid.uniforms["middle"]?.value as Vector3).set(...target);
      const uniform = grid.uniforms["reach"];
      if (uniform) uniform.value = reach;
    },
  };
}

/** Corners of the disk in which the grid is seen. */
const CORNERS = 48;

const SQUARE = Float32Array.of(-1, 1, 0, 1, 1, 0, -1, -1, 0, 1, -1, 0);

function stretched(attribute: BufferAttribute | undefined, corners: Float32Array, [x, y]: Vector, half: number): void {
  if (attribute === undefined) return;
  for (let k = 0; k < attribute.count; k++) attribute.setXYZ(k, x + half * (corners[3 * k] ?? 0), y + half * (corners[3 * k + 1] ?? 0), 0);
  attribute.needsUpdate = true;
}

/** Axes of space at the start of a path (n, 3), where nothing else gives its scale. */
export function spaceAxes(path: Float64Array, colours: Palette): Ground {
  const { low, high } = box(path);
  const length = roundNumber(0.2 * Math.max(...high.map((most, k) => most - (low[k] ?? 0))) || 1);
  const group = new Group();
  for (const axis of ["x", "y", "z"] as const) {
    const rod = new Mesh(new CylinderGeometry(0.015 * length, 0.015 * length, length, 10), new MeshBasicMaterial({ color: colours.quiet }));
    rod.position.fromArray(path)[axis] += length / 2;
    // a cylinder stands along y
    if (axis === "x") rod.rotation.z = Math.PI / 2;
    if (axis === "z") rod.rotation.x = Math.PI / 2;
    group.add(rod);
  }
  return { group, spacing: length, axes: true, around: () => undefined };
}

/** A sphere about the origin, or the cap of it with this angle from the pole to the rim. */
export function sphereGround(radius: number, inside: boolean, opening: number, colours: Palette): Ground {
  const whole = opening >= Math.PI;
  const start = inside && !whole ? Math.PI - opening : 0;
  const geometry = new SphereGeometry(radius, 128, 80, 0, 2 * Math.PI, start, whole ? Math.PI : opening);
  geometry.rotateX(Math.PI / 2);
  const step = (opening > 0.8 ? 15 : 5) * (Math.PI / 180);
  return surfaceGround(geometry, inside, lineShader.graticule(step), colours);
}

/** Any surface, whose normals point to the side on which the body is. */
export function meshGround(mesh: Triangles, spacing: number, colours: Palette): Ground {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  return surfaceGround(geometry, false, lineShader.planes(spacing), colours);
}

/** The strength of lines on a surface from 0 to 1, in GLSL, at the place `vOwn` with normal `vTurn`. */
const lineShader = {
  graticule: (step: number): string => `
    float polar = acos(clamp(vOwn.z / length(vOwn), -1.0, 1.0));
    float around = atan(vOwn.y, vOwn.x);
    vec2 line = vec2(polar, around) / ${step.toFixed(9)};
    vec2 width = vec2(fwidth(polar), length(fwidth(vOwn.xy)) / max(length(vOwn.xy), 1e-9)) / ${step.toFixed(9)};
    vec2 off = abs(fract(line - 0.5) - 0.5);
    vec2 ink = (1.0 - smoothstep(0.1 * width, 0.8 * width, off)) * (1.0 - smoothstep(0.15, 0.5, width));
    float polarEdge = min(polar, 3.14159265 - polar);
    if (polarEdge < ${step.toFixed(9)}) ink.y = 0.0;
    float lines = max(ink.x, ink.y);`,
  planes: (spacing: number): string => `
    vec3 line = vOwn / ${spacing.toFixed(9)}; vec3 width = fwidth(line) + 1e-9;
    vec3 off = abs(fract(line - 0.5) - 0.5);
    vec3 ink = (1.0 - smoothstep(0.1 * width, 0.8 * width, off)) * (1.0 - smoothstep(0.15, 0.5, width));
    ink *= clamp((0.98 - abs(vTurn)) / 0.1, 0.0, 1.0);
    float lines = max(ink.x, max(ink.y, ink.z));`,
};

function surfaceGround(geometry: BufferGeometry, flipped: boolean, lines: string, colours: Palette): Ground {
  const group = new Group();
  // the side on which the body is, opaque; the other, where it stands in the way, as of glass
  const [solid, glass]: [Side, Side] = flipped ? [BackSide, FrontSide] : [FrontSide, BackSide];
  const wall = new Mesh(geometry, surfaceMaterial(solid, 1, lines, colours));
  wall.receiveShadow = true;
  wall.renderOrder = -2;
  const pane = new Mesh(geometry, surfaceMaterial(glass, 0.14, lines, colours));
  pane.renderOrder = 9;
  group.add(wall, pane);
  return { group, spacing: 0, around: () => undefined };
}

function surfaceMaterial(side: Side, opacity: number, lines: string, colours: Palette): MeshLambertMaterial {
  const glass = opacity < 1;
  const material = new MeshLambertMaterial({ color: colours.ground[0], side, transparent: glass, opacity, depthWrite: !glass });
  material.onBeforeCompile = (shader) => {
    shader.uniforms["uLine"] = { value: new Color(colours.lines) };
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vOwn;\nvarying vec3 vTurn;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nvOwn = position;\nvTurn = normalize(normal);");
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vOwn;\nvarying vec3 vTurn;\nuniform vec3 uLine;")
      .replace(
        "#include <color_fragment>",
        `${lines}
        diffuseColor.rgb = mix(diffuseColor.rgb, uLine, 0.7 * lines);
        ${glass ? "diffuseColor.a = mix(diffuseColor.a, 0.4, 0.6 * lines);" : ""}`,
      );
  };
  // lines are part of the program: surfaces with other lines need another
  material.customProgramCacheKey = () => lines + String(glass);
  return material;
}
