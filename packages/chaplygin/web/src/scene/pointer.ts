/** Pointer, wheel and fingers on the scene. */

import { orbited, panned, zoomed, type View } from "./view";

export interface ViewHolder {
  view: View;
}

/** Let the reader turn, move and enlarge a view with the pointer over an element. */
export function bindPointer(area: HTMLElement, holder: ViewHolder, changed: (moved: boolean) => void): void {
  const fingers = new Map<number, { x: number; y: number }>();
  const spread = (): number => {
    const [a, b] = [...fingers.values()];
    return a && b ? Math.hypot(a.x - b.x, a.y - b.y) : 0;
  };
  area.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    area.setPointerCapture(event.pointerId);
  });
  area.addEventListener("pointermove", (event) => {
    const finger = fingers.get(event.pointerId);
    if (finger === undefined) return;
    const height = area.clientHeight || 1;
    const right = (event.clientX - finger.x) / height;
    const down = (event.clientY - finger.y) / height;
    if (fingers.size === 2) {
      const before = spread();
      fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
      const after = spread();
      if (before > 0 && after > 0) holder.view = zoomed(holder.view, before / after);
      holder.view = panned(holder.view, right / 2, down / 2);
      changed(true);
      return;
    }
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const moves = event.shiftKey || event.buttons === 2 || event.buttons === 4;
    holder.view = moves ? panned(holder.view, right, down) : orbited(holder.view, right, down);
    changed(moves);
  });
  const lift = (event: PointerEvent): void => void fingers.delete(event.pointerId);
  area.addEventListener("pointerup", lift);
  area.addEventListener("pointercancel", lift);
  area.addEventListener("contextmenu", (event) => event.preventDefault());
  area.addEventListener(
    "wheel",
    (event) => {
      // on a page of text the wheel scrolls, unless the reader is in the scene
      if (!area.matches(":focus-within") && !event.ctrlKey) return;
      event.preventDefault();
      holder.view = zoomed(holder.view, Math.exp(0.0015 * event.deltaY));
      changed(false);
    },
    { passive: false },
  );
}
