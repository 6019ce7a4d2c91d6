/** An engine in a worker: its calls as messages. */

import type { Engine, Motion, SectionPoints, State } from "../engine/engine";
import type { Surfaces } from "../engine/surfaces";
import type { Values } from "../engine/engine";

/** Calls a method there; rejects with one sentence. */
export type Call = (method: string, argument: unknown) => Promise<unknown>;

/** An engine over calls. */
export function remoteEngine(call: Call): Engine {
  return {
    motion: async (task) => (await call("motion", task)) as Motion,
    section: async (task) => (await call("section", task)) as SectionPoints,
    quantities: async (parameters, rows, dimension) => (await call("quantities", { parameters, rows, dimension })) as Float64Array,
    indicator: async (task) => (await call("indicator", task)) as number,
    indicators: async (task) => (await call("indicators", task)) as Float64Array,
    startFrom: async (task) => (await call("startFrom", task)) as State,
    startOnLevel: async (task) => (await call("startOnLevel", task)) as State,
    surfaces: async (parameters) => (await call("surfaces", parameters)) as Surfaces,
  };
}

/** Run a method of an engine with the one argument that a call carries. */
export function answer(engine: Engine, method: string, argument: unknown): Promise<unknown> {
  switch (method) {
    case "quantities": {
      const { parameters, rows, dimension } = argument as { parameters: Values; rows: Float64Array; dimension: number };
      return engine.quantities(parameters, rows, dimension);
    }
    case "surfaces":
      return engine.surfaces(argument as Values);
    case "motion":
    case "section":
    case "indicator":
    case "indicators":
    case "startFrom":
    case "startOnLevel":
      return engine[method](argument as never);
    default:
      return Promise.reject(new Error(`There is no method ${method}.`));
  }
}
