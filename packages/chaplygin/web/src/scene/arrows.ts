/** Vectors as arrows. */

import { ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Quaternion, Vector3 } from "three";

const SHAFT = new CylinderGeometry(1, 1, 1, 14).translate(0, 0.5, 0);
const HEAD = new ConeGeometry(1, 1, 20).translate(0, 0.5, 0);
const UP = new Vector3(0, 1, 0);

/** An arrow of a given thickness; seen palely through what hides it. */
export class Arrow {
  readonly group = new Group();
  private readonly parts: { shaft: Mesh; head: Mesh }[] = [];

  /** Half the width of the shaft. */
  thickness = 1;

  constructor(colour: string) {
    for (const hidden of [false, true]) {
      const material = new MeshBasicMaterial({
        color: colour,
        transparent: hidden,
        opacity: hidden ? 0.35 : 1,
        depthTest: !hidden,
        depthWrite: !hidden,
      });
      const shaft = new Mesh(SHAFT, material);
      const head = new Mesh(HEAD, material);
      shaft.renderOrder = head.renderOrder = hidden ? 10 : 2;
      this.parts.push({ shaft, head });
      this.group.add(shaft, head);
    }
  }

  /** Put it at a place along a vector of the length to draw. */
  set(place: Vector3, vector: Vector3): void {
    const length = vector.length();
    this.group.visible = Number.isFinite(length) && length > 1e-9;
    if (!this.group.visible) return;
    this.group.position.copy(place);
    this.group.quaternion.copy(new Quaternion().setFromUnitVectors(UP, vector.clone().divideScalar(length)));
    const thick = Math.min(this.thickness, 0.25 * length);
    const tip = Math.min(5 * thick, 0.6 * length);
    for (const { shaft, head } of this.parts) {
      shaft.scale.set(thick, length - tip, thick);
      head.scale.set(2.6 * thick, tip, 2.6 * thick);
      head.position.y = length - tip;
    }
  }

  dispose(): void {
    for (const { shaft } of this.parts) (shaft.material as MeshBasicMaterial).dispose();
  }
}
