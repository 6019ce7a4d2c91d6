/** Engines in workers of the page, which keep the page itself free. */

import source from "worker:./worker.ts";
import type { Engine } from "../engine/engine";
import type { PageModel } from "../model";
import { remoteEngine } from "./remote";

interface Answer {
  id: number;
  value?: unknown;
  message?: string;
}

/** An engine in a worker, and a way to end it. */
export interface WorkerEngine {
  engine: Engine;
  /** Whether it computes. */
  busy(): boolean;
  end(): void;
}

/** A worker that computes for a model; its text is part of this page, so that no other file is needed. */
export function workerEngine(model: PageModel): WorkerEngine {
  const address = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
  const worker = new Worker(address);
  const waiting = new Map<number, { resolve: (value: unknown) => void; reject: (why: Error) => void }>();
  let last = 0;
  worker.addEventListener("message", ({ data }: MessageEvent<Answer>) => {
    const asked = waiting.get(data.id);
    waiting.delete(data.id);
    if (data.message !== undefined) asked?.reject(new Error(data.message));
    else asked?.resolve(data.value);
  });
  worker.addEventListener("error", (event) => {
    for (const { reject } of waiting.values()) reject(new Error(event.message || "The computation failed."));
    waiting.clear();
  });
  // what has been recorded is of no use for computing
  worker.postMessage({ model: { ...model, recorded: null, experiment: "" } });
  const engine = remoteEngine(
    (method, argument) =>
      new Promise((resolve, reject) => {
        last += 1;
        waiting.set(last, { resolve, reject });
        worker.postMessage({ id: last, method, argument });
      }),
  );
  return {
    engine,
    busy: () => waiting.size > 0,
    end() {
      worker.terminate();
      URL.revokeObjectURL(address);
      for (const { reject } of waiting.values()) reject(new Error("The computation was stopped."));
      waiting.clear();
    },
  };
}

/** How many workers a long computation has: one for each processor, as the page itself only waits and paints. */
export function workerCount(): number {
  return Math.min(16, navigator.hardwareConcurrency || 2);
}

/** An engine in a worker of its own, whose work can be thrown away. */
export class SpareEngine {
  private worker: WorkerEngine | null = null;

  constructor(private readonly model: PageModel) {}

  get engine(): Engine {
    this.worker ??= workerEngine(this.model);
    return this.worker.engine;
  }

  /** End what is being computed; the next call finds a worker that is free. */
  renew(): void {
    if (this.worker?.busy() !== true) return;
    this.worker.end();
    this.worker = null;
  }
}
