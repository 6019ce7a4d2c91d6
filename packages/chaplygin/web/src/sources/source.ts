/** Where motions come from. What is mounted never knows which of these it has. */

import type { Engine } from "../engine/engine";
import type { PageModel } from "../model";
import { workerEngine } from "./workers";

export type Source =
  /** The motion that the page holds. */
  | { kind: "recorded"; model: PageModel }
  /** The page itself, by the module of the page model. */
  | { kind: "wasm"; model: PageModel }
  /** The page, and a running lab for what needs Python. */
  | { kind: "http"; model: PageModel; base: string }
  /** The page, and the kernel of a notebook for what needs Python. */
  | { kind: "widget"; model: PageModel; ask: Ask };

/** Send a request; its answers come one by one. */
export type Ask = (request: object, heard: (answer: Record<string, unknown>) => void, signal?: AbortSignal) => Promise<void>;

/** The engine of a source; null where nothing can be computed. */
export function engineOf({ model }: Source): Engine | null {
  return model.wasm === null ? null : workerEngine(model).engine;
}
