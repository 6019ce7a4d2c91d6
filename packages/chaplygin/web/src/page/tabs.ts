/** Panels of which one is seen at a time. */

import { element } from "./dom";

export interface Panel {
  name: string;
  title: string;
  content: HTMLElement;
  /** Called when the panel comes into sight. */
  shown?: () => void;
}

let serial = 0;

/** A row of tabs with their panels; arrow keys go from tab to tab. */
export function tabs(label: string, panels: readonly Panel[], changed: (name: string) => void = () => undefined): { element: HTMLElement; select(name: string): void } {
  serial += 1;
  const list = element("div", { role: "tablist", "aria-label": label, class: "lab-tabs" });
  const bodies: HTMLElement[] = [];
  const heads = panels.map(({ name, title, content }) => {
    const id = `lab-${serial}-${name}`;
    const head = element("button", { type: "button", role: "tab", id: `${id}-tab`, "aria-controls": id }, title);
    const body = element("div", { role: "tabpanel", id, "aria-labelledby": `${id}-tab`, class: `lab-panel lab-panel-${name}` }, content);
    list.append(head);
    bodies.push(body);
    return head;
  });
  const select = (index: number, focus: boolean): void => {
    heads.forEach((head, k) => {
      const on = k === index;
      head.setAttribute("aria-selected", String(on));
      head.tabIndex = on ? 0 : -1;
      const body = bodies[k];
      if (body) body.hidden = !on;
    });
    if (focus) heads[index]?.focus();
    const panel = panels[index];
    if (panel === undefined) return;
    panel.shown?.();
    changed(panel.name);
  };
  heads.forEach((head, k) => head.addEventListener("click", () => select(k, false)));
  list.addEventListener("keydown", (event) => {
    const now = heads.findIndex((head) => head === document.activeElement);
    const steps: Record<string, number> = { ArrowRight: now + 1, ArrowLeft: now - 1, Home: 0, End: heads.length - 1 };
    const next = steps[event.key];
    if (next === undefined) return;
    event.preventDefault();
    select((next + heads.length) % heads.length, true);
  });
  select(0, false);
  return {
    element: element("section", { class: "lab-deck", "aria-label": label }, list, ...bodies),
    select: (name) => {
      const index = panels.findIndex((panel) => panel.name === name);
      if (index >= 0) select(index, false);
    },
  };
}
