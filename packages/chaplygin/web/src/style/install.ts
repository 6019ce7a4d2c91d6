/** The style sheet, for pages that do not bring it along. */

import text from "./lab.css";

/** Add the style sheet to the page of an element, once. */
export function installStyle(target: HTMLElement): void {
  const root = target.getRootNode();
  const home = root instanceof ShadowRoot ? root : document.head;
  if (home.querySelector("style[data-chaplygin-lab]") !== null) return;
  const sheet = document.createElement("style");
  sheet.dataset["chaplyginLab"] = "";
  sheet.textContent = text;
  home.append(sheet);
}
