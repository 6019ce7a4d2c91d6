/** The body: its surface in two tones by octants, as in the project's figures. */

import {
  BackSide,
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  FrontSide,
  Group,
  Mesh,
  MeshPhongMaterial,
  Vector3,
  type Side,
} from "three";
import type { Mesh as Triangles } from "../engine/body_mesh";
import type { Palette } from "../page/palette";
import { box } from "./box";

/** The surface of a body in its own axes. */
export type Surface = Omit<Triangles, "tones">;

/** A body in its own axes. */
export class BodyModel {
  readonly group = new Group();
  /** Distance of the farthest point from the origin of its axes. */
  radius = 0;
  private readonly materials: MeshPhongMaterial[] = [];

  private readonly middle = new Vector3();

  constructor(surface: Surface, colours: Palette) {
    const { hollow } = surface;
    for (const side of hollow ? [BackSide, FrontSide] : [FrontSide]) {
      const material = twoTones(this.middle, side, hollow, colours);
      const mesh = new Mesh(new BufferGeometry(), material);
      mesh.castShadow = !hollow;
      mesh.renderOrder = side === BackSide ? 0 : hollow ? 8 : 1;
      this.materials.push(material);
      this.group.add(mesh);
    }
    this.reshape(surface);
  }

  /** Give it another surface. */
  reshape(surface: Surface): void {
    const { low, high } = box(surface.positions);
    this.middle.set(...low).add(new Vector3(...high)).multiplyScalar(0.5);
    this.radius = surface.positions.reduce((most, _, k, all) => (k % 3 === 0 ? Math.max(most, Math.hypot(all[k] ?? 0, all[k + 1] ?? 0, all[k + 2] ?? 0)) : most), 0);
    for (const mesh of this.group.children) {
      if (!(mesh instanceof Mesh)) continue;
      (mesh.geometry as BufferGeometry).dispose();
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(surface.positions, 3));
      geometry.setAttribute("normal", new BufferAttribute(surface.normals, 3));
      geometry.setIndex(new BufferAttribute(surface.indices, 1));
      mesh.geometry = geometry;
    }
  }

  /** Show the body as of glass, so that what is in it is seen. */
  set glass(on: boolean) {
    for (const material of this.materials) {
      if (material.userData["wall"] === true || material.transparent === on) continue;
      // the far side of a body that is closed is seen through it alone
      if (material.side !== BackSide) material.side = on ? DoubleSide : FrontSide;
      material.opacity = on ? 0.4 : 1;
      material.transparent = on;
      material.depthWrite = !on;
      material.needsUpdate = true;
    }
  }

  dispose(): void {
    for (const child of this.group.children) if (child instanceof Mesh) child.geometry.dispose();
    for (const material of this.materials) material.dispose();
  }
}

function twoTones(middle: Vector3, side: Side, hollow: boolean, colours: Palette): MeshPhongMaterial {
  const wall = hollow && side === FrontSide;
  const material = new MeshPhongMaterial({
    color: 0xffffff,
    specular: new Color(0x33383d),
    shininess: 42,
    side,
    transparent: wall,
    opacity: wall ? 0.16 : 1,
    depthWrite: !wall,
  });
  material.userData["wall"] = wall;
  const tones = hollow ? colours.shell : colours.body;
  material.onBeforeCompile = (shader) => {
    shader.uniforms["uMiddle"] = { value: middle };
    shader.uniforms["uFirst"] = { value: new Color(tones[0]) };
    shader.uniforms["uSecond"] = { value: new Color(tones[1]) };
    shader.uniforms["uSeam"] = { value: new Color(colours.seam) };
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", "#include <common>\nvarying vec3 vOwn;\nuniform vec3 uMiddle;")
      .replace("#include <begin_vertex>", "#include <begin_vertex>\nvOwn = position - uMiddle;");
    shader.fragmentShader = shader.fragmentShader
      .replace(
        "#include <common>",
        "#include <common>\nvarying vec3 vOwn;\nuniform vec3 uFirst;\nuniform vec3 uSecond;\nuniform vec3 uSeam;",
      )
      .replace(
        "#include <color_fragment>",
        `vec3 width = fwidth(vOwn) + 1e-12;
        vec3 part = clamp(vOwn / width, -1.0, 1.0);
        diffuseColor.rgb = mix(uFirst, uSecond, 0.5 + 0.5 * part.x * part.y * part.z);
        vec3 near = 1.0 - smoothstep(0.3, 1.1, abs(vOwn) / width);
        diffuseColor.rgb = mix(diffuseColor.rgb, uSeam, 0.55 * max(near.x, max(near.y, near.z)));`,
      )
      .replace(
        "#include <opaque_fragment>",
        `float rim = 1.0 - abs(dot(normalize(vViewPosition), normal));
        outgoingLight = mix(outgoingLight, 0.35 * uSeam, 0.75 * smoothstep(0.86, 0.99, rim));
        #include <opaque_fragment>`,
      );
  };
  return material;
}
