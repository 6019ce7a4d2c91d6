/** Where motions come from. What is mounted never knows which of these it has. */

import type { Engine } from "../engine/engine";
import type { PageModel } from "../model";
import { listed, remoteEngine } from "./remote";
import { workerEngine } from "./workers";

/** Sends messages to the kernel of a notebook and hears its answers, as the model of an anywidget. */
export interface Channel {
  get(name: string): unknown;
  send(message: unknown): void;
  on(event: "msg:custom", act: (message: unknown) => void): void;
}

export type Source =
  /** The motion that the page holds. */
  | { kind: "recorded"; model: PageModel }
  /** The page itself, by the module of the page model. */
  | { kind: "wasm"; model: PageModel }
  /** A running lab. */
  | { kind: "http"; model: PageModel; address: string; token: string }
  /** The kernel of a notebook. */
  | { kind: "widget"; model: PageModel; channel: Channel };

/** The engine of a source; null where nothing can be computed. */
export function engineOf(source: Source): Engine | null {
  const { model } = source;
  // a page that can compute asks nobody: it is faster, and goes on when the other side is gone
  if (source.kind !== "recorded" && model.wasm !== null) return workerEngine(model).engine;
  if (source.kind === "http") return httpEngine(source.address, source.token);
  if (source.kind === "widget") return widgetEngine(source.channel);
  return null;
}

function httpEngine(address: string, token: string): Engine {
  return remoteEngine(async (method, argument) => {
    let response: Response;
    try {
      response = await fetch(`${address}/api/${method}`, {
        method: "POST",
        headers: { "Content-Type": "application/json", "X-Chaplygin-Token": token },
        body: JSON.stringify(listed(argument)),
      });
    } catch {
      throw new Error("The lab does not answer; is it still running?");
    }
    return opened((await response.json()) as Answer);
  });
}

interface Answer {
  id?: number;
  value?: unknown;
  message?: string;
}

function opened(answer: Answer): unknown {
  if (answer.message !== undefined && answer.value === undefined) throw new Error(answer.message);
  return answer.value;
}

function widgetEngine(channel: Channel): Engine {
  const waiting = new Map<number, (answer: Answer) => void>();
  let last = 0;
  channel.on("msg:custom", (message) => {
    const answer = message as Answer;
    const act = waiting.get(answer.id ?? -1);
    waiting.delete(answer.id ?? -1);
    act?.(answer);
  });
  return remoteEngine(async (method, argument) => {
    last += 1;
    const id = last;
    const answer = new Promise<Answer>((resolve) => waiting.set(id, resolve));
    channel.send({ id, method, arguments: listed(argument) });
    return opened(await answer);
  });
}
