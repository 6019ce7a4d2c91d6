/** An engine that computes elsewhere: in a worker, in a running lab, in the kernel of a notebook. */

import type { Engine, Motion, SectionPoints, State } from "../engine/engine";
import type { Mesh } from "../engine/body_mesh";

/** Calls a method there; rejects with one sentence. */
export type Call = (method: string, argument: unknown) => Promise<unknown>;

/** The names of all methods. */
export const METHODS = [
  "motion",
  "section",
  "quantities",
  "indicator",
  "startFrom",
  "startOnLevel",
  "bodyMesh",
] as const satisfies readonly (keyof Engine)[];

/** An engine over calls whose answers may hold plain lists in place of arrays of doubles. */
export function remoteEngine(call: Call): Engine {
  return {
    async motion(task) {
      const answer = (await call("motion", task)) as Motion;
      const columns = Object.fromEntries(Object.entries(answer.columns).map(([name, values]) => [name, doubles(values)]));
      return { ...answer, columns, times: doubles(answer.times), states: doubles(answer.states) };
    },
    async section(task) {
      const answer = (await call("section", task)) as SectionPoints;
      return { ...answer, rows: doubles(answer.rows), times: doubles(answer.times) };
    },
    async quantities(parameters, rows, dimension) {
      return doubles((await call("quantities", { parameters, rows, dimension })) as ArrayLike<number>);
    },
    indicator: async (task) => number((await call("indicator", task)) as number | null),
    startFrom: async (task) => state((await call("startFrom", task)) as State),
    startOnLevel: async (task) => state((await call("startOnLevel", task)) as State),
    bodyMesh: async (parameters) => mesh((await call("bodyMesh", { parameters })) as Mesh | null),
  };
}

/** Run a method of an engine with the one argument that a call carries. */
export function answer(engine: Engine, method: string, argument: unknown): Promise<unknown> {
  switch (method) {
    case "quantities": {
      const { parameters, rows, dimension } = argument as {
        parameters: Record<string, number>;
        rows: ArrayLike<number>;
        dimension: number;
      };
      return engine.quantities(parameters, doubles(rows), dimension);
    }
    case "bodyMesh":
      return engine.bodyMesh((argument as { parameters: Record<string, number> }).parameters);
    case "motion":
    case "section":
    case "indicator":
    case "startFrom":
    case "startOnLevel":
      return engine[method](argument as never);
    default:
      return Promise.reject(new Error(`There is no method ${method}.`));
  }
}

/** An argument with arrays of doubles as lists, for JSON. */
export function listed(value: unknown): unknown {
  if (ArrayBuffer.isView(value)) return Array.from(value as Float64Array);
  if (Array.isArray(value)) return value.map(listed);
  if (value !== null && typeof value === "object") {
    return Object.fromEntries(Object.entries(value).map(([name, inner]) => [name, listed(inner)]));
  }
  return value;
}

function doubles(values: ArrayLike<number | null> | undefined): Float64Array {
  return values instanceof Float64Array ? values : Float64Array.from(values ?? [], number);
}

/** Numbers that JSON lacks are null there. */
function number(value: number | null): number {
  return value ?? NaN;
}

/** A mesh whose arrays JSON has made lists. */
function mesh(answer: Mesh | null): Mesh | null {
  if (answer === null || answer.positions instanceof Float32Array) return answer;
  const { positions, normals, indices, tones, hollow } = answer;
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals), indices: Uint32Array.from(indices), tones: Uint8Array.from(tones), hollow };
}

function state(answer: State): State {
  return "message" in answer ? answer : { state: doubles(answer.state) };
}
