/** What a page may call. */

import type { PageModel } from "./model";
import { mount } from "./mount";
import type { Channel, Source } from "./sources/source";

export { mount };

/** Mount every element of the class `chaplygin-lab`, by the page model in its first script. */
export function mountAll(): void {
  for (const target of document.querySelectorAll<HTMLElement>(".chaplygin-lab")) {
    const script = target.querySelector("script[type='application/json']");
    if (script === null || target.querySelector(".lab-root") !== null) continue;
    const model = JSON.parse(script.textContent ?? "") as PageModel;
    mount(target, sourceOf(target, model));
  }
}

function sourceOf(target: HTMLElement, model: PageModel): Source {
  const { address, token } = target.dataset;
  if (address !== undefined) return { kind: "http", model, address, token: token ?? "" };
  return { kind: model.wasm === null ? "recorded" : "wasm", model };
}

/** Show an anywidget: its trait `page` holds the page model. */
export function render({ model, el }: { model: Channel; el: HTMLElement }): void {
  const page = model.get("page");
  mount(el, { kind: "widget", model: (typeof page === "string" ? JSON.parse(page) : page) as PageModel, channel: model });
}
