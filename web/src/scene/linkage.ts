/** Mechanisms in the plane: rods, wheels, axles, blades, joints. */

import { BoxGeometry, CylinderGeometry, Group, Mesh, MeshPhongMaterial, SphereGeometry } from "three";
import type { Link } from "../model";
import type { Palette } from "../page/palette";
import { row, type Motion } from "../playback/motion";

/** The parts of a mechanism; `mark` is the length of a wheel. */
export class Linkage {
  readonly group = new Group();
  private readonly parts: { link: Link; group: Group }[] = [];

  constructor(
    links: readonly Link[],
    private readonly mark: number,
    colours: Palette,
  ) {
    const dark = new MeshPhongMaterial({ color: colours.dark ? "#8fa6bb" : "#33424f", specular: 0x222222 });
    const rod = new MeshPhongMaterial({ color: colours.body[1], specular: 0x222222 });
    const joint = new MeshPhongMaterial({ color: colours.body[0], specular: 0x222222 });
    for (const link of links) {
      const group = new Group();
      for (const mesh of shape(link.kind, mark, { dark, rod, joint })) {
        mesh.castShadow = true;
        group.add(mesh);
      }
      this.parts.push({ link, group });
      this.group.add(group);
    }
  }

  /** Put all parts where they are at an instant. */
  at(motion: Motion, t: number): void {
    for (const { link, group } of this.parts) {
      const width = link.kind === "rod" ? 4 : link.kind === "point" ? 2 : 3;
      const values = row(motion, link.column, width, t);
      group.visible = values !== null && values.every(Number.isFinite);
      if (values === null) continue;
      const [x = 0, y = 0, third = 0, fourth = 0] = values;
      if (link.kind === "rod") {
        const length = Math.hypot(third - x, fourth - y);
        group.position.set((x + third) / 2, (y + fourth) / 2, 0.5 * this.mark);
        group.rotation.z = Math.atan2(fourth - y, third - x);
        group.scale.x = length;
      } else {
        group.position.set(x, y, 0);
        group.rotation.z = link.kind === "point" ? 0 : third;
      }
    }
  }
}

interface Materials {
  dark: MeshPhongMaterial;
  rod: MeshPhongMaterial;
  joint: MeshPhongMaterial;
}

function shape(kind: Link["kind"], mark: number, { dark, rod, joint }: Materials): Mesh[] {
  const radius = mark / 2;
  switch (kind) {
    case "rod":
      return [new Mesh(new BoxGeometry(1, 0.14 * mark, 0.1 * mark), rod)];
    case "wheel":
      return [wheel(radius, 0.3 * mark, 0, dark)];
    case "axle": {
      const bar = new Mesh(new CylinderGeometry(0.06 * mark, 0.06 * mark, 1.1 * mark, 12), rod);
      bar.position.z = 0.75 * radius;
      return [bar, wheel(0.75 * radius, 0.24 * mark, 0.55 * mark, dark), wheel(0.75 * radius, 0.24 * mark, -0.55 * mark, dark)];
    }
    case "blade": {
      const blade = new Mesh(new BoxGeometry(1.3 * mark, 0.06 * mark, 0.45 * mark), dark);
      blade.position.z = 0.225 * mark;
      return [blade];
    }
    case "point": {
      const ball = new Mesh(new SphereGeometry(0.16 * mark, 24, 16), joint);
      ball.position.z = 0.5 * mark;
      return [ball];
    }
  }
}

function wheel(radius: number, width: number, aside: number, material: MeshPhongMaterial): Mesh {
  // the axis of a cylinder is y: across the heading
  const made = new Mesh(new CylinderGeometry(radius, radius, width, 32), material);
  made.position.set(0, aside, radius);
  return made;
}
