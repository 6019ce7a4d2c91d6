/** What runs in a worker: an engine that answers messages. */

import type { Engine } from "../engine/engine";
import { WasmEngine } from "../engine/wasm_engine";
import type { PageModel } from "../model";
import { answer } from "./remote";

let engine: Promise<Engine> | null = null;

interface Request {
  model?: PageModel;
  id?: number;
  method?: string;
  argument?: unknown;
}

addEventListener("message", ({ data }: MessageEvent<Request>) => {
  if (data.model !== undefined) {
    engine = WasmEngine.create(data.model);
    engine.catch(() => undefined);
    return;
  }
  const { id, method, argument } = data;
  void (async () => {
    try {
      if (engine === null) throw new Error("The worker has no model.");
      postMessage({ id, value: await answer(await engine, method ?? "", argument) });
    } catch (why) {
      postMessage({ id, message: why instanceof Error ? why.message : String(why) });
    }
  })();
});
