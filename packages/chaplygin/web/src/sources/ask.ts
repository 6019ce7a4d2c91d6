/** What needs Python: requests to a running lab or to the kernel of a notebook. */

import type { Ask, Source } from "./source";

/** A part of an answer. */
export type Answer = Record<string, unknown>;

/** How a page asks; null where there is nobody to ask. */
export function askOf(source: Source): Ask | null {
  if (source.kind === "http") return (request, heard, signal) => post(`${source.base}ask`, request, heard, signal);
  return source.kind === "widget" ? source.ask : null;
}

async function post(address: string, request: object, heard: (answer: Answer) => void, signal?: AbortSignal): Promise<void> {
  const response = await fetch(address, {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(request),
    ...(signal === undefined ? {} : { signal }),
  }).catch((why: unknown) => {
    if (signal?.aborted === true) throw why;
    throw new Error("The lab does not answer; is it still running?");
  });
  if (response.body === null) return;
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  let rest = "";
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    rest += value;
    const lines = rest.split("\n");
    rest = lines.pop() ?? "";
    for (const line of lines) {
      const answer = JSON.parse(line) as Answer;
      if (answer["done"] !== true) heard(answer);
    }
  }
}
