/** The list of keys. */

import { SCENE_KEYS } from "../scene/scene_panel";
import { element } from "./dom";

/** All keys with what they do. */
export function help(): HTMLElement {
  const rows = SCENE_KEYS.map(([keys, what]) => element("tr", {}, element("th", { scope: "row" }, element("kbd", {}, keys)), element("td", {}, what)));
  return element("div", {},
    element("p", { class: "lab-hint" }, "Keys act while the scene, a section or a chart has the focus: click into it, or go there with Tab. With the pointer: drag turns, Shift and drag moves, the wheel zooms; with two fingers as usual."),
    element("table", { class: "lab-keys" }, ...rows));
}
