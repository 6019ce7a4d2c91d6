/** Elements of the page. */

type Child = Node | string | null;
type Attributes = Record<string, string | number | boolean | null>;

/** An element with attributes and children; `null` leaves an attribute or a child out. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === null || value === false) continue;
    made.setAttribute(name, value === true ? "" : String(value));
  }
  made.append(...children.filter((child): child is Node | string => child !== null));
  return made;
}

/** A button with its words, which a reader hears in full where the face is a symbol. */
export function button(face: string, label: string, act: () => void): HTMLButtonElement {
  const made = element("button", { type: "button", "aria-label": label, title: label }, face);
  made.addEventListener("click", act);
  return made;
}

/** A button that is on or off. */
export function toggle(
  face: string | Node,
  label: string,
  on: boolean,
  act: (on: boolean) => void,
): HTMLButtonElement {
  const made = element(
    "button",
    { type: "button", "aria-label": label, title: label, "aria-pressed": String(on) },
    face,
  );
  made.addEventListener("click", () => {
    const next = made.getAttribute("aria-pressed") !== "true";
    made.setAttribute("aria-pressed", String(next));
    act(next);
  });
  return made;
}

/** A list to choose from, with its label before it. */
export function choice(
  label: string,
  options: readonly { value: string; text: string }[],
  chosen: string,
  act: (value: string) => void,
): HTMLLabelElement {
  const list = element("select", { "aria-label": label });
  for (const { value, text } of options) {
    const option = element("option", { value }, text);
    option.selected = value === chosen;
    list.append(option);
  }
  list.addEventListener("change", () => act(list.value));
  return element("label", { class: "lab-choice" }, element("span", {}, label), list);
}

/** Give a file to the reader. */
export function save(name: string, content: Blob): void {
  const address = URL.createObjectURL(content);
  const link = element("a", { href: address, download: name });
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

/** The size of a drawing surface in device pixels, and how many of them a CSS pixel has. */
export function fitCanvas(canvas: HTMLCanvasElement): { width: number; height: number; ratio: number } {
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  return { width, height, ratio };
}

/** Settled when what the page shows has been painted; in a page that is out of sight, soon. */
export function painted(): Promise<void> {
  return new Promise((done) => {
    requestAnimationFrame(() => setTimeout(done));
    setTimeout(done, 500);
  });
}
