/** Mechanisms in the plane: rods, wheels, axles, blades, joints. */

import { BoxGeometry, CylinderGeometry, Group, Mesh, MeshPhongMaterial, SphereGeometry } from "three";
import type { Link } from "../model";
import type { Coat, MovingSolid } from "../downloads/gltf";
import { daylight, type Palette } from "../page/palette";
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
    const materials = materialsOf(colours);
    for (const link of links) {
      const group = new Group();
      for (const mesh of shape(link.kind, mark, materials)) {
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
      const place = placeOf(link.kind, row(motion, link.column, WIDTHS[link.kind], t), this.mark);
      group.visible = place !== null;
      if (place === null) continue;
      group.position.set(place.x, place.y, place.z);
      group.rotation.z = place.heading;
      group.scale.x = place.length;
    }
  }
}

interface Place {
  x: number;
  y: number;
  z: number;
  heading: number;
  /** By which a rod is drawn out. */
  length: number;
}

/** Numbers of the column of a part. */
const WIDTHS = { rod: 4, wheel: 3, axle: 3, blade: 3, point: 2 } as const;

/** Where a part is, by a row of its column; null where it is nowhere. */
function placeOf(kind: Link["kind"], values: ArrayLike<number> | null, mark: number): Place | null {
  if (values === null || !Array.from(values).every(Number.isFinite)) return null;
  const [x = 0, y = 0, third = 0, fourth = 0] = Array.from(values);
  if (kind !== "rod") return { x, y, z: 0, heading: kind === "point" ? 0 : third, length: 1 };
  const length = Math.hypot(third - x, fourth - y);
  return { x: (x + third) / 2, y: (y + fourth) / 2, z: 0.5 * mark, heading: Math.atan2(fourth - y, third - x), length };
}

/** The parts along a motion, in the colours of daylight. */
export function movingLinkage(links: readonly Link[], mark: number, motion: Motion): MovingSolid[] {
  const materials = materialsOf(daylight);
  const numbers = new Map<string, number>();
  return links.map((link) => {
    const number = (numbers.get(link.kind) ?? 0) + 1;
    numbers.set(link.kind, number);
    const [column, width] = [motion.columns[link.column], WIDTHS[link.kind]];
    const places = Array.from(motion.times, (_, n) => placeOf(link.kind, column?.subarray(width * n, width * n + width) ?? null, mark));
    const each = (values: (place: Place) => number[], count: number): Float64Array =>
      Float64Array.from(places.flatMap((place) => (place === null ? Array<number>(count).fill(NaN) : values(place))));
    const solid: MovingSolid = {
      name: `${link.kind} ${number}`,
      coats: shape(link.kind, mark, materials).map(coatOf),
      places: each(({ x, y, z }) => [x, y, z], 3),
      attitudes: each(({ heading }) => [Math.cos(heading / 2), 0, 0, Math.sin(heading / 2)], 4),
    };
    return link.kind === "rod" ? { ...solid, scales: each(({ length }) => [length, 1, 1], 3) } : solid;
  });
}

/** The triangles of a mesh where it stands in its part. */
function coatOf(mesh: Mesh): Coat {
  mesh.updateMatrix();
  const geometry = mesh.geometry.clone().applyMatrix4(mesh.matrix);
  const corners = (name: string): Float32Array => Float32Array.from(geometry.getAttribute(name).array);
  const { color } = mesh.material as MeshPhongMaterial;
  return { colour: `#${color.getHexString()}`, positions: corners("position"), normals: corners("normal"), indices: Uint32Array.from(geometry.index?.array ?? []) };
}

interface Materials {
  dark: MeshPhongMaterial;
  rod: MeshPhongMaterial;
  joint: MeshPhongMaterial;
}

function materialsOf(colours: Palette): Materials {
  const of = (color: string): MeshPhongMaterial => new MeshPhongMaterial({ color, specular: 0x222222 });
  return { dark: of(colours.dark ? "#8fa6bb" : "#33424f"), rod: of(colours.body[1]), joint: of(colours.body[0]) };
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
