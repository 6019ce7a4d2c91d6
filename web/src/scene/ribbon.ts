/** Curves of constant width on the screen, in the colours of time, drawn up to an instant. */

import {
  Color,
  Float32BufferAttribute,
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Mesh,
  ShaderMaterial,
  Vector2,
} from "three";
import type { TimedCurve } from "../playback/curve";

const COLOURS = 5;

const VERTEX = `
attribute vec3 from;
attribute vec3 to;
attribute vec2 fromMark;
attribute vec2 toMark;
uniform vec2 screen;
uniform float width;
uniform float lift;
varying vec2 vMark;
void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(from, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(to, 1.0);
  vec2 run = (b.xy / b.w - a.xy / a.w) * screen;
  float far = length(run);
  vec2 along = far > 1e-6 ? run / far : vec2(1.0, 0.0);
  vec2 side = vec2(-along.y, along.x);
  bool end = position.x > 0.5;
  gl_Position = end ? b : a;
  vMark = end ? toMark : fromMark;
  // half a width beyond both ends: the joints of thick curves stay closed
  vec2 shift = side * position.y + along * (end ? 0.35 : -0.35);
  gl_Position.xy += shift * width / screen * gl_Position.w;
  gl_Position.z -= lift * gl_Position.w;
}`;

const FRAGMENT = `
uniform vec3 scale[${COLOURS}];
uniform vec2 span;
uniform vec2 now;
uniform float tail;
uniform float before;
uniform float after;
varying vec2 vMark;
void main() {
  float share = clamp((vMark.x - span.x) / (span.y - span.x), 0.0, 1.0) * ${(COLOURS - 1).toFixed(1)};
  vec3 colour = scale[0];
  for (int k = 1; k < ${COLOURS}; k++) colour = mix(colour, scale[k], clamp(share - float(k - 1), 0.0, 1.0));
  float alpha = vMark.x <= now.x ? before : after;
  if (vMark.x <= now.x) alpha *= 1.0 - smoothstep(0.6 * tail, tail, now.y - vMark.y);
  if (alpha < 0.004) discard;
  gl_FragColor = vec4(colour, alpha);
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
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  private readonly curve: TimedCurve;

  constructor(curve: TimedCurve, style: RibbonStyle, colours: readonly string[]) {
    this.curve = curve;
    const count = curve.times.length;
    const data = new Float32Array(5 * Math.max(2, count));
    for (let k = 0; k < count; k++) {
      data.set([curve.points[3 * k] ?? 0, curve.points[3 * k + 1] ?? 0, curve.points[3 * k + 2] ?? 0, curve.times[k] ?? 0, curve.lengths[k] ?? 0], 5 * k);
    }
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 0, 1, 0, 1, 1, 0], 3));
    geometry.setIndex([0, 1, 2, 2, 1, 3]);
    const first = new InstancedInterleavedBuffer(data, 5, 1);
    const second = new InstancedInterleavedBuffer(data.slice(5), 5, 1);
    geometry.setAttribute("from", new InterleavedBufferAttribute(first, 3, 0));
    geometry.setAttribute("fromMark", new InterleavedBufferAttribute(first, 2, 3));
    geometry.setAttribute("to", new InterleavedBufferAttribute(second, 3, 0));
    geometry.setAttribute("toMark", new InterleavedBufferAttribute(second, 2, 3));
    geometry.instanceCount = Math.max(0, count - 1);
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      transparent: true,
      depthWrite: false,
      uniforms: {
        screen: { value: new Vector2(1, 1) },
        width: { value: style.width },
        lift: { value: 4e-4 },
        scale: { value: colours.map((colour) => new Color(colour)) },
        span: { value: new Vector2(curve.times[0] ?? 0, Math.max(curve.times[count - 1] ?? 1, (curve.times[0] ?? 0) + 1e-12)) },
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
    this.uniform<Vector2>("now").set(t, lengths[t >= (times[high] ?? 0) ? high : low] ?? 0);
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
