/** What a reader can take along: the address, the experiment, data, pictures, a film, the body in motion. */

import { startInputs } from "../controls/start_inputs";
import type { Lab } from "../lab";
import { element, save } from "../page/dom";
import { plain } from "../page/mathml";
import { daylight } from "../page/palette";
import { changingModes } from "../playback/modes";
import type { PlotsPanel } from "../plots/plots_panel";
import type { ScenePanel } from "../scene/scene_panel";
import type { SectionPanel } from "../section/section_panel";
import { editedExperiment, type FileNumber } from "./experiment_file";
import { film } from "./film";
import { movingLinkage } from "../scene/linkage";
import { glb, movingBody, type MovingSolid } from "./gltf";
import { plotsSvg, sectionSvg } from "./svg";
import { csv, sectionCsv } from "./table";

export interface Downloadable {
  lab: Lab;
  scene: ScenePanel | null;
  plots: PlotsPanel;
  section: SectionPanel | null;
  address: () => string;
}

/** Longest side of a film. */
const FILM_WIDTH = 1280;

/** Buttons for all of it. */
export function downloadsPanel(given: Downloadable): HTMLElement {
  const { lab, scene, plots, section, address } = given;
  const { model } = lab;
  const name = model.name || "motion";
  const list = element("div", { class: "lab-downloads" });
  const add = (words: string, hint: string, act: () => void | Promise<void>): HTMLButtonElement => {
    const made = element("button", { type: "button", class: "lab-button" }, words);
    made.addEventListener("click", () => {
      void Promise.resolve(act()).catch((why: unknown) => lab.say(why instanceof Error ? why.message : String(why), true));
    });
    list.append(element("div", {}, made, element("span", { class: "lab-hint" }, hint)));
    return made;
  };
  const text = (file: string, content: string, type = "text/plain"): void => save(file, new Blob([content], { type: `${type};charset=utf-8` }));
  add("Copy the address", "of this motion: parameters, start and instant are in it", async () => {
    const whole = address();
    await navigator.clipboard.writeText(whole).then(
      () => lab.say("The address is on the clipboard."),
      () => lab.say(whole),
    );
  });
  if (model.experiment !== "") add("Experiment", "a file that the program runs (TOML)", () => text(`${name}.toml`, experimentText(lab)));
  add("Data", "every sample of this motion (CSV)", () => text(`${name}.csv`, csv(lab.shown.value.motion, model.columns), "text/csv"));
  if (section !== null) {
    add("Points of the section", "as a table (CSV)", () => {
      const { x, y } = section.setting();
      text(`${name}-section.csv`, sectionCsv([x, y], section.orbits()), "text/csv");
    });
    add("Section", "as a drawing (SVG)", () => {
      const { x, y } = section.sheet.frame;
      const orbits = section.orbits().map((orbit) => ({ ...orbit, colour: daylight.series[orbit.number % daylight.series.length] ?? daylight.ink }));
      text(`${name}-section.svg`, sectionSvg(model.title, x, y, orbits), "image/svg+xml");
    });
  }
  add("Plots", "over time, as a drawing (SVG)", () => {
    const groups = plots.chosen().map((group) => ({ ...group, label: group.text, components: group.components.map((each) => ({ ...each, label: plain(each.label) })) }));
    text(`${name}-plots.svg`, plotsSvg(model.title, lab.shown.value.motion.times, groups, changingModes(lab.shown.value.motion)), "image/svg+xml");
  });
  if (scene !== null) addOfScene(given, scene, name, add);
  return list;
}

function addOfScene({ lab }: Downloadable, scene: ScenePanel, name: string, add: (words: string, hint: string, act: () => void | Promise<void>) => HTMLButtonElement): void {
  const { stage } = scene;
  const sizes = (): [number, number] => [scene.element.clientWidth, scene.element.clientHeight];
  add("Picture", "of the scene now (PNG)", async () => {
    const sheet = await stage.sized(...sizes(), 3, () => stage.picture(lab.clock.time.value));
    scene.refresh();
    const blob = await new Promise<Blob | null>((resolve) => sheet.toBlob(resolve, "image/png"));
    if (blob === null) throw new Error("The browser could not write the picture.");
    save(`${name}.png`, blob);
  });
  let filming = false;
  const button = add("Film", "of the whole motion at the chosen speed (MP4)", async () => {
    if (filming) {
      filming = false;
      return;
    }
    filming = true;
    lab.clock.pause();
    button.textContent = "Stop the film";
    const [wide, high] = sizes();
    const scale = FILM_WIDTH / Math.max(wide, high);
    const { until } = lab.clock;
    const duration = until / lab.clock.speed.value;
    const [width, height] = [even(wide * scale), even(high * scale)];
    const speed = lab.clock.speed.value;
    const plan = {
      width,
      height,
      duration,
      picture: (seconds: number) => stage.picture(Math.min(until, seconds * speed)),
      progress: (share: number) => lab.say(`Film: ${Math.round(100 * share)} of 100`),
      wanted: () => filming,
    };
    const answer = await stage.sized(width, height, 1, () => film(plan)).finally(() => {
      filming = false;
      button.textContent = "Film";
      scene.refresh();
    });
    if ("message" in answer) return lab.say(answer.message, true);
    save(`${name}.mp4`, answer);
    lab.say(`The film lasts ${duration.toFixed(1)} s.`);
  });
  const { links, path } = lab.model.scene;
  const solids = (): MovingSolid[] => {
    const { surfaces: { body }, motion } = lab.shown.value;
    return [...(body === null ? [] : [movingBody(body, motion)]), ...movingLinkage(links, stage.mark, motion)];
  };
  if (lab.shown.value.surfaces.body !== null || links.length > 0) {
    add(path === null ? "Body in motion" : "Mechanism in motion", "for other 3D programs (glTF, GLB)", () => {
      const content = glb(lab.model.title, lab.shown.value.motion.times, solids());
      save(`${name}.glb`, new Blob([content as Uint8Array<ArrayBuffer>], { type: "model/gltf-binary" }));
    });
  }
}

function even(side: number): number {
  return 2 * Math.max(1, Math.round(side / 2));
}

/** The experiment file of the motion in the scene. */
export function experimentText(lab: Lab): string {
  const { model } = lab;
  const { experiment } = lab.shown.value;
  const list = (usual: readonly { name: string; value: number }[], values: Readonly<Record<string, number>>): FileNumber[] =>
    usual.map(({ name, value }) => ({ name, value: values[name] ?? value, usual: value }));
  const until = experiment.until === model.until ? null : experiment.until;
  return editedExperiment(model.experiment, list(model.parameters, experiment.parameters), list(model.start_inputs, startInputs(lab)), until);
}
