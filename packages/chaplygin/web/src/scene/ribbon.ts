/** Curves of constant width on the screen, drawn up to an instant. */

import {
  BufferAttribute,
  BufferGeometry,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  ShaderMaterial,
  Vector2,
} from "three";
import type { TimedCurve } from "../playback/curve";
import type { PaintedCurve } from "./paint";

const VERTEX = `
attribute vec3 to;
attribute vec2 corner;
attribute vec2 fromMark;
attribute vec2 toMark;
attribute vec3 colour;
uniform vec2 screen;
uniform float width;
uniform float lift;
uniform vec2 now;
varying vec2 vMark;
varying vec3 vColour;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  vec2 run = (b.xy / b.w - a.xy / a.w) * screen;
  float far = length(run);
  vec2 along = far > 1e-6 ? run / far : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  bool end = corner.x > 0.5;
  gl_Position = end ? b : a;
  vMark = end ? toMark : fromMark;
  vColour = colour;
  // beyond both ends, so that joints stay closed; not where the curve is pale and would be twice as dark
  float joint = fromMark.x <= now.x ? 0.35 : 0.0;
  vec2 shift = side * corner.y + along * (end ? joint : -joint);
  gl_Position.xy += shift * width / screen * gl_Position.w;
  gl_Position.z -= lift * gl_Position.w;
}`;

const FRAGMENT = `
uniform vec2 now;
uniform float tail;
uniform float before;
uniform float after;
varying vec2 vMark;
varying vec3 vColour;
void main() {
  float alpha = vMark.x <= now.x ? before : after;
  if (vMark.x <= now.x) alpha *= 1.0 - smoothstep(0.6 * tail, tail, now.y - vMark.y);
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(vColour, alpha);
  #include <colorspace_fragment>
}`;

export interface RibbonStyle {
  /** Width in CSS pixels. */
  width: number;
  /** Opacity of what has been and of what is to come. */
  before: number;
  after: number;
  /** Length beyond which the past is no longer drawn. */
  tail: number;
}

/** A timed curve as a mesh. */
export class Ribbon {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private curve: TimedCurve;

  constructor(shown: PaintedCurve, style: RibbonStyle) {
    this.curve = shown.curve;
    const geometry = segments(shown);
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: {
        screen: { value: new Vector2(1, 1) },
        width: { value: style.width },
        lift: { value: 4e-4 },
        now: { value: new Vector2(Infinity, 0) },
        tail: { value: style.tail },
        before: { value: style.before },
        after: { value: style.after },
      },
    });
    this.mesh = new Mesh(geometry, material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = 4;
  }

  /** Draw it as it is at an instant. */
  at(t: number): void {
    const { times, lengths } = this.curve;
    let low = 0;
    let high = times.length - 1;
    while (high - low > 1) {
      const middle = (low + high) >> 1;
      if ((times[middle] ?? 0) <= t) low = middle;
      else high = middle;
    }
    const now = t >= (times[high] ?? 0) ? high : low;
    this.uniform<Vector2>("now").set(t, lengths[now] ?? 0);
    // what is to come is not drawn at all where it has no colour
    if (this.uniform<number>("after") > 0) return;
    const since = (lengths[now] ?? 0) - this.uniform<number>("tail");
    let first = now;
    while (first > 0 && (lengths[first] ?? 0) > since) first -= 1;
    this.mesh.geometry.setDrawRange(6 * first, 6 * (now - first + 1));
  }

  /** Give it another curve. */
  reshape(shown: PaintedCurve): void {
    this.curve = shown.curve;
    this.mesh.geometry.dispose();
    this.mesh.geometry = segments(shown);
  }

  /** Tell it how large the picture is, in CSS pixels. */
  resize(width: number, height: number): void {
    this.uniform<Vector2>("screen").set(width, height);
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }

  private uniform<T>(name: string): T {
    return this.mesh.material.uniforms[name]?.value as T;
  }
}

/** Numbers of a corner: the segment's start, its end, the corner, time and length at both ends, and its colour. */
const STRIDE = 15;

/** Four corners a segment. They are no instances of one: that is slow where no graphics card draws. */
function segments({ curve, colour }: PaintedCurve): BufferGeometry {
  const { points, times, lengths } = curve;
  const count = Math.max(0, times.length - 1);
  const data = new Float32Array(4 * STRIDE * count);
  const indices = new Uint32Array(6 * count);
  for (let k = 0; k < count; k++) {
    const [from, to] = [times[k] ?? 0, times[k + 1] ?? 0];
    const ends = [from, to].map((t) => colour(t, (from + to) / 2).toArray());
    for (let corner = 0; corner < 4; corner++) {
      const at = STRIDE * (4 * k + corner);
      data.set(points.subarray(3 * k, 3 * k + 6), at);
      data.set([corner & 1, corner & 2 ? 1 : -1, from, lengths[k] ?? 0, to, lengths[k + 1] ?? 0], at + 6);
      data.set(ends[corner & 1] ?? [], at + 12);
    }
    indices.set([0, 1, 2, 2, 1, 3].map((corner) => 4 * k + corner), 6 * k);
  }
  const geometry = new BufferGeometry();
  const buffer = new InterleavedBuffer(data, STRIDE);
  const add = (name: string, size: number, offset: number): void => {
    geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset));
  };
  add("position", 3, 0);
  add("to", 3, 3);
  add("corner", 2, 6);
  add("fromMark", 2, 8);
  add("toMark", 2, 10);
  add("colour", 3, 12);
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}
