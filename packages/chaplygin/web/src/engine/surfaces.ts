/** What is drawn of a body and of what carries it, for given parameters. */

import { floats, integers } from "../encoding.js";
import type { PageModel, ValuesTable } from "../model.js";
import { directions, meshOfGrid, type Mesh } from "./body_mesh.js";
import type { Values } from "./engine.js";
import type { Module } from "./module.js";

/** Triangles of a surface with the normals to its drawn side. */
export interface Triangles {
  positions: Float32Array;
  normals: Float32Array;
  indices: Uint32Array;
}

/** Null where there is none, or the parameters do not change it. */
export interface Surfaces {
  body: Mesh | null;
  /** The ellipsoid of inertia (x, Ix) = 1, in the axes of the body. */
  inertia: Mesh | null;
  /** What carries a ball, where it is neither plane nor sphere. */
  ground: Triangles | null;
}

/** Newton's steps by which places are drawn onto a surface. */
const STEPS = 8;
/** Directions of a closed surface without a grid of its own. */
const ROWS = 24;
const COLUMNS = 48;

/** The surfaces that a model holds. */
export function surfacesOf({ scene }: PageModel): Surfaces {
  return { body: scene.body === null ? null : meshOfGrid(scene.body, floats(scene.body.positions)), inertia: null, ground: groundOf(scene.support) };
}

function groundOf(support: PageModel["scene"]["support"]): Triangles | null {
  if (support?.kind !== "mesh") return null;
  return { positions: floats(support.positions), normals: floats(support.normals), indices: integers(support.indices) };
}

/** Computes surfaces by the formulas of a module; what depends on no parameter is computed once. */
export class DrawnSurfaces {
  private readonly first: Surfaces;

  constructor(private readonly module: Module) {
    this.first = surfacesOf(module.model);
  }

  at(parameters: Values): Surfaces {
    const { module, first } = this;
    const { contact, inertia, ground } = module.tables;
    const values = module.parameters(parameters);
    return {
      body: contact === null || first.body === null ? first.body : this.body(contact, values),
      inertia: inertia === null ? null : this.closed(inertia, values),
      ground: ground === null || first.ground === null ? first.ground : this.ground(ground, first.ground, values),
    };
  }

  private body(table: ValuesTable, values: Float64Array): Mesh | null {
    const { body } = this.module.model.scene;
    if (body === null) return null;
    const gamma = directions(body.theta, body.phi);
    const points = this.rows(table, gamma, values);
    const side = body.hollow ? 1 : -1;
    for (let i = 0; i < gamma.length; i += 3) {
      const up = side * gamma[i + 2]!;
      if (Math.abs(up) > 1e-9) points[i + 2]! += body.thickness * Math.sign(up);
    }
    return meshOfGrid(body, points);
  }

  private closed(table: ValuesTable, values: Float64Array): Mesh {
    const theta = Array.from({ length: ROWS }, (_, k) => (Math.PI * (k + 0.02)) / (ROWS - 0.96));
    const phi = Array.from({ length: COLUMNS }, (_, k) => (2 * Math.PI * k) / COLUMNS);
    const points = this.rows(table, directions(theta, phi), values);
    return meshOfGrid({ theta, phi, positions: "", hollow: false, thickness: 0 }, points);
  }

  /** The corners of a surface moved onto the one of other parameters. */
  private ground(table: ValuesTable, known: Triangles, values: Float64Array): Triangles {
    const usual = this.module.parameters({});
    if (values.every((value, k) => value === usual[k])) return known;
    const places = Float64Array.from(known.positions);
    const count = places.length / 3;
    // f = 0 may be the surface of the ball's centre, one radius above
    const before = this.rows(table, places, usual);
    for (let k = 0; k < places.length; k++) places[k]! += before[5 * Math.floor(k / 3) + 4]! * known.normals[k]!;
    const normals = Float32Array.from(known.normals);
    let f = new Float64Array(0);
    for (let step = 0; step <= STEPS; step++) {
      f = this.rows(table, places, values) as Float64Array<ArrayBuffer>;
      for (let n = 0; n < count; n++) {
        const [value, x, y, z] = [f[5 * n]!, f[5 * n + 1]!, f[5 * n + 2]!, f[5 * n + 3]!];
        const square = x * x + y * y + z * z;
        if (!(square > 0) || !Number.isFinite(value)) continue;
        const share = step < STEPS ? -value / square : 0;
        const length = Math.sqrt(square);
        [x, y, z].forEach((slope, i) => {
          places[3 * n + i]! += share * slope;
          normals[3 * n + i] = slope / length;
        });
      }
    }
    const positions = Float32Array.from(places, (place, k) => place - f[5 * Math.floor(k / 3) + 4]! * normals[k]!);
    return { positions, normals, indices: known.indices };
  }

  /** Results of a table for rows of three numbers. */
  private rows(table: ValuesTable, three: Float64Array, values: Float64Array): Float64Array {
    const { module } = this;
    const count = three.length / 3;
    const rows = new Float64Array(count * table.inputs);
    for (let i = 0; i < count; i++) rows.set(three.subarray(3 * i, 3 * i + 3), i * table.inputs + module.tables.gamma);
    return module.values(table, rows, values);
  }
}
