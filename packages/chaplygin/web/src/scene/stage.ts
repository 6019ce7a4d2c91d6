/** The scene on the screen: what is there, from where it is seen, and its pictures. */

import {
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  Scene as World,
  SphereGeometry,
  Vector3,
  WebGLRenderer,
} from "three";
import type { Surfaces } from "../engine/surfaces";
import type { Scene } from "../model";
import { roundNumber } from "../page/numbers";
import { palette, type Palette } from "../page/palette";
import type { TimedCurve } from "../playback/curve";
import { pose, row, turned, type Motion, type Pose, type Vector } from "../playback/motion";
import { Arrow } from "./arrows";
import { BodyModel, type Surface } from "./body";
import { box } from "./box";
import { capOpening } from "./cap";
import { meshGround, planeGround, spaceAxes, sphereGround, type Ground } from "./ground";
import { largestLength, meshSpacing, sameSurface, VECTOR_LENGTH } from "./measures";
import { Linkage } from "./linkage";
import { contactCurve, planCurve, traceOnBody } from "./curves";
import { leadsFar, openingView, reachOf } from "./opening_view";
import { paintedCurve, type PaintedCurve } from "./paint";
import { Ribbon } from "./ribbon";
import { ellipsoid } from "./ellipsoid";
import { eye, FIELD, viewOf, viewText, zoomed, type View } from "./view";

/** What the reader has chosen to see. */
export interface Shown {
  trace: boolean;
  traceOnBody: boolean;
  inertia: boolean;
  centre: boolean;
  follow: boolean;
  vectors: ReadonlySet<string>;
}

const TRACE_ON_BODY = 6.3;

/** Diameters of the body that are in view where the reader follows it. */
const SEEN = 12;

/** Draws motions of one model. Lengths of the model are divided by its size. */
export class Stage {
  view: View;
  readonly size: number;
  private readonly renderer: WebGLRenderer;
  private readonly camera = new PerspectiveCamera((FIELD * 180) / Math.PI, 1, 0.05, 500);
  private readonly world = new World();
  private readonly metres = new Group();
  private readonly lamp = new DirectionalLight(0xffffff, 2.1);
  private readonly bodyFrame = new Group();
  private colours: Palette = palette();
  private body: BodyModel | null = null;
  private ground: Ground | null = null;
  private linkage: Linkage | null = null;
  private path: Ribbon | null = null;
  private trace: Ribbon | null = null;
  private arrows = new Map<string, { arrow: Arrow; scale: number }>();
  private inertia: BodyModel | null = null;
  private centreMark: Mesh | null = null;
  /** The view with which the scene has opened, or was reset to. */
  private usual: View;
  private given = false;
  private reach = 4;
  private width = 1;
  private height = 1;

  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly scene: Scene,
    private surfaces: Surfaces,
    private motion: Motion,
    public shown: Shown,
  ) {
    this.size = scene.size > 0 ? scene.size : 1;
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true, powerPreference: "high-performance" });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.camera.up.set(0, 0, 1);
    this.metres.scale.setScalar(1 / this.size);
    this.world.add(this.metres, this.lamp, this.lamp.target);
    this.metres.add(this.bodyFrame);
    this.view = this.usual = openingView(scene, motion, this.size);
    this.lamp.castShadow = true;
    this.lamp.shadow.mapSize.set(1024, 1024);
    this.lamp.shadow.radius = 5;
    this.lamp.shadow.bias = -2e-4;
    this.lamp.shadow.normalBias = 0.01;
    const half = 1.6;
    Object.assign(this.lamp.shadow.camera, { left: -half, right: half, top: half, bottom: -half, near: 0.5, far: 14 });
    this.build();
  }

  /** Show another motion of the same model, perhaps of another body. */
  setMotion(motion: Motion, surfaces: Surfaces): void {
    this.motion = motion;
    const known = this.surfaces;
    this.surfaces = surfaces;
    if (this.path === null || (this.trace === null) !== !this.leavesTrace || motion.columns["attitude"] === undefined) return this.build();
    // what a graphics program has been made for stays: making one anew takes longer than the motion
    if (surfaces.body !== null && !sameSurface(surfaces.body, known.body)) this.body?.reshape(surfaces.body);
    const { inertia } = surfaces;
    if (inertia !== null && !sameSurface(inertia, known.inertia)) this.inertia?.reshape(this.insideBody(inertia));
    const contact = contactCurve(this.motion);
    this.reach = reachOf(this.scene.path !== null ? planCurve(this.scene, this.motion).points : contact.points, this.size);
    const { ground } = surfaces;
    if (this.scene.support?.kind === "sphere" || this.ground?.axes === true || (ground !== null && !sameSurface(ground, known.ground))) {
      if (this.ground !== null) this.metres.remove(this.ground.group);
      this.buildGround(contact.points);
    }
    this.path.reshape(this.paintedCurve(this.scene.path !== null ? planCurve(this.scene, this.motion) : contact));
    this.trace?.reshape(this.paintedCurve(traceOnBody(this.motion)));
    for (const { name, column } of this.scene.vectors) {
      const drawn = this.arrows.get(name);
      if (drawn !== undefined) drawn.scale = largestLength(motion, column) || drawn.scale;
    }
  }

  private paintedCurve(curve: TimedCurve): PaintedCurve {
    return paintedCurve(curve, this.motion, this.colours);
  }

  private get leavesTrace(): boolean {
    const { columns } = this.motion;
    return this.body !== null && columns["contact"] !== undefined && columns["attitude"] !== undefined;
  }

  /** The scale of the picture: the spacing of a grid or the length of axes, in metres; null without either. */
  get scale(): { what: "grid" | "axes"; length: number } | null {
    const { spacing = 0, axes } = this.ground ?? {};
    return spacing > 0 ? { what: axes === true ? "axes" : "grid", length: spacing } : null;
  }

  /** The length of a wheel of a mechanism, metres. */
  get mark(): number {
    return 0.2 * this.size;
  }

  /** Draw in the colours that the reader prefers now. */
  recolour(): void {
    this.colours = palette();
    this.build();
  }

  /** The view from which the whole motion is seen best. */
  reset(): void {
    this.view = this.usual = openingView(this.scene, this.motion, this.size, this.width / this.height);
  }

  /** The view of the reader as text for an address; nothing where it is the usual one. */
  get viewChoice(): string {
    const { view, usual } = this;
    const places = this.shown.follow ? [] : view.target.map((place, k) => place - (usual.target[k] ?? 0));
    const changes = [view.azimuth - usual.azimuth, view.elevation - usual.elevation, view.distance - usual.distance, ...places];
    return changes.every((change) => Math.abs(change) < 1e-6) ? "" : viewText(view, !this.shown.follow);
  }

  /** See it as a text says; the answer says whether the reader has moved the target. */
  restoreView(choice: string): boolean | null {
    const found = viewOf(choice, this.view.target);
    if (found === null) return null;
    this.view = found.view;
    this.given = true;
    return found.moved;
  }

  zoom(factor: number): void {
    this.view = zoomed(this.view, factor);
  }

  /** The magnitude that the longest arrow of a vector stands for. */
  vectorScale(name: string): number {
    return this.arrows.get(name)?.scale ?? 0;
  }

  resize(width: number, height: number, ratio = Math.min(window.devicePixelRatio || 1, 2)): void {
    if (width < 1 || height < 1) return;
    const first = this.width === 1;
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.path?.resize(width, height);
    this.trace?.resize(width, height);
    if (first && !this.given) this.reset();
  }

  /** Draw the instant `t`. */
  draw(t: number): void {
    // curves have a width in pixels: nothing is drawn before the size of the picture is known
    if (this.width === 1) return;
    const now = pose(this.motion, t);
    this.place(now);
    if (this.shown.follow) this.follow(now);
    const target = new Vector3(...this.view.target);
    this.camera.position.set(...eye(this.view));
    this.camera.near = Math.max(0.02, this.view.distance / 60);
    this.camera.far = this.view.distance + 6 * this.reach + 60;
    this.camera.updateProjectionMatrix();
    this.camera.lookAt(target);
    const metres = this.view.target.map((place) => place * this.size) as Vector;
    const nearby = Math.min(Math.max(this.reach, 2), 0.62 * this.view.distance);
    const place = this.placeOf(now);
    this.ground?.around(metres, nearby * this.size, place, this.shadowed(now));
    const body = new Vector3(...place).divideScalar(this.size);
    this.lamp.target.position.copy(body);
    this.lamp.position.copy(body).add(this.lampDirection().multiplyScalar(6));
    this.renderer.render(this.world, this.camera);
  }

  /** Do some work with pictures of another size. */
  async sized<R>(width: number, height: number, ratio: number, work: () => Promise<R> | R): Promise<R> {
    const [wide, high] = [this.width, this.height];
    this.resize(width, height, ratio);
    try {
      return await work();
    } finally {
      this.resize(wide, high);
    }
  }

  /** A picture of an instant, with the colour of the paper behind it. */
  picture(t: number): HTMLCanvasElement {
    this.draw(t);
    const sheet = document.createElement("canvas");
    sheet.width = this.canvas.width;
    sheet.height = this.canvas.height;
    const pen = sheet.getContext("2d");
    if (pen !== null) {
      pen.fillStyle = this.colours.paper;
      pen.fillRect(0, 0, sheet.width, sheet.height);
      pen.drawImage(this.canvas, 0, 0);
    }
    return sheet;
  }

  dispose(): void {
    this.clear();
    this.renderer.dispose();
  }

  /** Half the side of the square on the ground in which the shadow lies. */
  private shadowed({ centre }: Pose): number {
    const most = 1.7 * this.size;
    if (this.body === null) return most;
    // the lamp stands 22° from the vertical
    return Math.min(most, 0.41 * Math.abs(centre[2]) + 1.1 * this.body.radius + 0.06 * this.size);
  }

  private lampDirection(): Vector3 {
    const { azimuth } = this.view;
    // over the reader's left shoulder, steep: as in the project's figures
    const right = new Vector3(-Math.sin(azimuth), Math.cos(azimuth), 0);
    const near = new Vector3(Math.cos(azimuth), Math.sin(azimuth), 0);
    return right.multiplyScalar(-0.35).addScaledVector(near, 0.2).add(new Vector3(0, 0, 1)).normalize();
  }

  private follow(now: Pose): void {
    const [x, y, z] = this.placeOf(now);
    this.view = { ...this.view, target: [x / this.size, y / this.size, z / this.size] };
  }

  /** Where the body, or the mechanism, is. */
  private placeOf(now: Pose): Vector {
    const { path } = this.scene;
    if (path === null) return now.centre;
    const [x = 0, y = 0] = row(this.motion, path, 2, now.t) ?? [];
    return [x, y, 0];
  }

  private clear(): void {
    this.body?.dispose();
    this.inertia?.dispose();
    this.path?.dispose();
    this.trace?.dispose();
    for (const { arrow } of this.arrows.values()) arrow.dispose();
    this.arrows.clear();
    this.bodyFrame.clear();
    this.metres.clear();
    this.metres.add(this.bodyFrame);
    for (const light of this.world.children.filter((child) => child instanceof HemisphereLight)) {
      this.world.remove(light);
    }
    this.body = this.ground = this.linkage = this.path = this.trace = this.inertia = this.centreMark = null;
  }

  private build(): void {
    this.clear();
    const { scene, colours, motion } = this;
    this.world.add(new HemisphereLight(0xffffff, colours.dark ? 0x7d8894 : 0xb9c2cb, 1.5));
    this.buildBody();
    const contact = contactCurve(this.motion);
    this.buildGround(contact.points);
    if (scene.links.length > 0) {
      this.linkage = new Linkage(scene.links, this.mark, colours);
      this.metres.add(this.linkage.group);
    }
    const path = this.paintedCurve(scene.path !== null ? planCurve(this.scene, this.motion) : contact);
    this.path = new Ribbon(path, { width: 3, before: 1, after: 0.16, tail: Infinity });
    this.metres.add(this.path.mesh);
    if (this.leavesTrace) {
      const trace = this.paintedCurve(traceOnBody(this.motion));
      this.trace = new Ribbon(trace, { width: 2.2, before: 1, after: 0, tail: TRACE_ON_BODY * this.size });
      this.bodyFrame.add(this.trace.mesh);
    }
    for (const [index, vector] of scene.vectors.entries()) {
      const largest = largestLength(motion, vector.column);
      if (!(largest > 0)) continue;
      const arrow = new Arrow(colours.components[index % 3] ?? colours.ink);
      this.arrows.set(vector.name, { arrow, scale: largest });
      this.metres.add(arrow.group);
    }
    this.path.resize(this.width, this.height);
    this.trace?.resize(this.width, this.height);
  }

  private buildBody(): void {
    const { scene, colours } = this;
    const axes = scene.inertia_axes;
    const { body: shaped, inertia } = this.surfaces;
    const moves = this.motion.columns["attitude"] !== undefined;
    if (!moves) return;
    const unit = axes ? (0.5 * this.size) / Math.max(...axes) : 0;
    const semi = axes?.map((axis) => axis * unit) as Vector | undefined;
    const surface = shaped ?? (semi ? ellipsoid(semi, scene.inertia_turn) : null);
    if (surface !== null) {
      this.body = new BodyModel(surface, colours);
      this.bodyFrame.add(this.body.group);
    }
    if (semi && shaped !== null) {
      // as large as fits into the body along its longest axis
      const inner = this.insideBody(inertia ?? ellipsoid(semi, scene.inertia_turn));
      this.inertia = new BodyModel(inner, { ...colours, body: ["#efd9a4", "#c77d4f"] });
      this.bodyFrame.add(this.inertia.group);
    }
    this.centreMark = new Mesh(
      new SphereGeometry(0.028 * this.size, 24, 16),
      new MeshBasicMaterial({ color: colours.alarm, depthTest: false, transparent: true }),
    );
    this.centreMark.renderOrder = 11;
    this.bodyFrame.add(this.centreMark);
  }

  /** A surface about the centre of mass, made so large that it fits into the body along its longest axis. */
  private insideBody(surface: Surface): Surface {
    const longest = Math.max(...box(surface.positions).high);
    const scale = (0.4 * this.size) / longest;
    return { ...surface, positions: surface.positions.map((place) => scale * place) };
  }

  private buildGround(path: Float64Array): void {
    const { scene, colours, size } = this;
    this.reach = reachOf(scene.path !== null ? planCurve(this.scene, this.motion).points : path, size);
    // of a path that leads far only a part is seen at once
    const seen = leadsFar(scene, this.motion) ? Math.min(this.reach, SEEN) : this.reach;
    const support = scene.support ?? (scene.path === null ? null : { kind: "plane" as const });
    if (support?.kind === "point" || (support === null && (this.body !== null || path.length < 6))) return;
    if (support === null) this.ground = spaceAxes(path, colours);
    else if (support.kind === "plane") this.ground = planeGround(roundNumber(Math.max(0.5, seen / 16) * size), colours);
    else if (support.kind === "sphere") {
      // the radius may be one of the parameters: the contact tells it
      const radius = Math.hypot(path[0] ?? NaN, path[1] ?? NaN, path[2] ?? NaN) || Math.abs(support.radius);
      const room = support.inside ? 0.3 : Math.max(0.12, (0.75 * size) / radius);
      const around = this.surfaces.body?.hollow === true;
      const opening = around ? Math.PI : capOpening(path, support.inside ? -1 : 1, room, support.inside ? 1.75 : 1.2);
      this.ground = sphereGround(radius, support.inside, opening, colours);
    } else {
      const mesh = this.surfaces.ground;
      if (mesh === null) return;
      this.ground = meshGround(mesh, meshSpacing(mesh.positions), colours);
    }
    this.metres.add(this.ground.group);
  }

  private place(now: Pose): void {
    const { shown } = this;
    const [w, x, y, z] = now.attitude;
    this.bodyFrame.position.set(...now.centre);
    this.bodyFrame.quaternion.set(x, y, z, w);
    if (this.body !== null) this.body.glass = (shown.inertia && this.inertia !== null) || shown.centre;
    if (this.inertia !== null) this.inertia.group.visible = shown.inertia;
    if (this.centreMark !== null) this.centreMark.visible = shown.centre;
    this.linkage?.at(this.motion, now.t);
    for (const [ribbon, on] of [[this.path, shown.trace], [this.trace, shown.traceOnBody]] as const) {
      if (ribbon === null) continue;
      ribbon.mesh.visible = on;
      ribbon.at(now.t);
    }
    for (const vector of this.scene.vectors) {
      const drawn = this.arrows.get(vector.name);
      if (drawn === undefined) continue;
      const value = row(this.motion, vector.column, 3, now.t) as Vector | null;
      drawn.arrow.group.visible = shown.vectors.has(vector.name) && value !== null;
      if (!drawn.arrow.group.visible || value === null) continue;
      const inSpace = vector.axes === "body" ? turned(now.attitude, value) : value;
      const length = (VECTOR_LENGTH * this.size) / drawn.scale;
      drawn.arrow.thickness = 0.0026 * this.view.distance * this.size;
      const from = vector.at === "contact" ? now.contact : now.centre;
      drawn.arrow.set(new Vector3(...from), new Vector3(...inSpace).multiplyScalar(length));
    }
  }
}
