/** Small drawings on buttons. */

const PATHS = {
  play: "M7 4.5v15l12-7.5z",
  pause: "M6.5 4.5h4v15h-4zM13.5 4.5h4v15h-4z",
  first: "M6 5h2.4v14H6zM19 5v14L9.5 12z",
  undo: "M9 6V2.5L3 8l6 5.500V10h5a4 4 0 0 1 0 8H8v2.500h6a6.500 6.500 0 0 0 0-14.500z",
  redo: "M15 6V2.500L21 8l-6 5.500V10h-5a4 4 0 0 0 0 8h6v2.500h-6a6.500 6.500 0 0 1 0-14.500z",
  whole: "M4 4h6v2.200H6.200V10H4zM14 4h6v6h-2.200V6.200H14zM4 14h2.200v3.800H10V20H4zM17.800 14H20v6h-6v-2.200h3.800z",
  link: "M10.600 13.400a1 1 0 0 0 1.400 0l4.200-4.200a1.800 1.800 0 0 0-2.600-2.600l-1.700 1.700-1.500-1.500 1.700-1.700a4 4 0 0 1 5.600 5.600l-4.200 4.200a3.100 3.100 0 0 1-4.400 0zM13.400 10.600a1 1 0 0 0-1.400 0l-4.200 4.200a1.800 1.800 0 0 0 2.600 2.600l1.700-1.700 1.500 1.500-1.700 1.700a4 4 0 0 1-5.600-5.600l4.200-4.200a3.100 3.100 0 0 1 4.400 0z",
  help: "M11 16.500h2.200V19H11zM12.100 5C9.700 5 8 6.500 7.900 8.900h2.300c.1-1.100.8-1.800 1.900-1.800s1.800.7 1.800 1.600c0 .8-.4 1.200-1.300 1.900-1.200.9-1.700 1.700-1.600 3.300v.6h2.200v-.4c0-.9.3-1.300 1.400-2.100 1-.8 1.700-1.700 1.700-3.300C16.300 6.500 14.600 5 12.100 5z",
} as const;

export type Icon = keyof typeof PATHS;

const SVG = "http://www.w3.org/2000/svg";

/** A drawing in the colour of the text. */
export function icon(name: Icon): SVGSVGElement {
  const drawing = document.createElementNS(SVG, "svg");
  drawing.setAttribute("viewBox", "0 0 24 24");
  drawing.setAttribute("aria-hidden", "true");
  drawing.setAttribute("class", "lab-icon");
  const path = document.createElementNS(SVG, "path");
  path.setAttribute("d", PATHS[name]);
  drawing.append(path);
  return drawing;
}

/** A button with a drawing. */
export function iconButton(name: Icon, label: string, act: () => void): HTMLButtonElement {
  const made = document.createElement("button");
  made.type = "button";
  made.className = "lab-icon-button";
  made.title = label;
  made.setAttribute("aria-label", label);
  made.append(icon(name));
  made.addEventListener("click", act);
  return made;
}

/** Change the drawing and the words of a button. */
export function redraw(made: HTMLButtonElement, name: Icon, label: string): void {
  made.title = label;
  made.setAttribute("aria-label", label);
  made.replaceChildren(icon(name));
}
