/** Play, pause, time and speed. */

import type { Lab } from "../lab";
import { element } from "../page/dom";
import { iconButton, redraw } from "../page/icons";
import { readable } from "../page/numbers";
import { SPEEDS } from "./clock";

/** The bar with which a reader plays a motion. */
export function transport(lab: Lab, full: () => void): HTMLElement {
  const { clock } = lab;
  const play = iconButton("play", "Play (space)", () => clock.toggle());
  play.classList.add("lab-play");
  const first = iconButton("first", "To the start (Home)", () => clock.seek(0));
  const scrub = element("input", { type: "range", min: 0, step: "any", "aria-label": "Time", class: "lab-scrub" });
  const reading = element("output", { class: "lab-time", "aria-live": "off" });
  const speed = element("select", { "aria-label": "Speed", title: "Speed ([ and ])" });
  const undo = iconButton("undo", "Undo (Ctrl+Z)", () => void lab.undo());
  const redo = iconButton("redo", "Redo (Ctrl+Shift+Z)", () => void lab.redo());
  const whole = iconButton("whole", "Full screen", full);
  scrub.addEventListener("input", () => {
    clock.pause();
    clock.seek(Number(scrub.value));
  });
  speed.addEventListener("change", () => (clock.speed.value = Number(speed.value)));
  clock.speed.watch((value) => {
    const options = [...new Set([...SPEEDS, value])].sort((a, b) => a - b);
    speed.replaceChildren(
      ...options.map((each) => {
        const option = element("option", { value: each }, `${readable(each, 2)}×`);
        option.selected = each === value;
        return option;
      }),
    );
  });
  clock.playing.watch((playing) => redraw(play, playing ? "pause" : "play", playing ? "Pause (space)" : "Play (space)"));
  const unit = "s";
  const show = (): void => {
    const t = clock.reading.value;
    const digits = clock.until < 1 ? 4 : clock.until < 100 ? 2 : 1;
    const text = `${t.toFixed(digits)} ${unit}`;
    reading.textContent = `t = ${text}`;
    scrub.setAttribute("aria-valuetext", `${text} of ${clock.until.toFixed(digits)} ${unit}`);
  };
  const move = (): void => {
    const t = clock.time.value;
    scrub.max = String(clock.until);
    scrub.value = String(t);
    scrub.style.setProperty("--share", String(clock.until > 0 ? t / clock.until : 0));
  };
  clock.reading.watch(show);
  clock.time.watch(move);
  lab.shown.after(() => {
    show();
    move();
  });
  lab.wanted.watch(() => {
    undo.disabled = !lab.history.canUndo;
    redo.disabled = !lab.history.canRedo;
  });
  const group = lab.engine === null ? null : element("span", { class: "lab-group" }, undo, redo);
  return element(
    "div",
    { class: "lab-transport", role: "toolbar", "aria-label": "Playback" },
    first,
    play,
    scrub,
    reading,
    element("label", { class: "lab-speed" }, speed),
    group,
    whole,
  );
}
