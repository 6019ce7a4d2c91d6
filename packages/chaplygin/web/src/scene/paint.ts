/** The colours of curves: those of time, or of the modes of a contact. */

import { Color } from "three";
import type { Palette } from "../page/palette";
import type { TimedCurve } from "../playback/curve";
import { changingModes, modeAt, splitAtModes } from "../playback/modes";
import type { Motion } from "../playback/motion";

/** A curve with the colour at an instant `t` of a piece of it; the piece has the instant `within` in its middle. */
export interface PaintedCurve {
  curve: TimedCurve;
  colour(t: number, within: number): Color;
}

/** A curve coloured by mode where the modes of the motion change, else by time. */
export function paintedCurve(curve: TimedCurve, motion: Motion, colours: Palette): PaintedCurve {
  const modes = changingModes(motion);
  if (modes.length === 0) return { curve, colour: timeColour(curve, colours.time) };
  const known = new Map(Object.entries(colours.modes).map(([mode, colour]) => [mode, new Color(colour)]));
  const other = new Color(colours.ink);
  return { curve: splitAtModes(curve, modes), colour: (_, within) => known.get(modeAt(modes, within)) ?? other };
}

function timeColour({ times }: TimedCurve, scale: readonly string[]): PaintedCurve["colour"] {
  const first = times[0] ?? 0;
  const span = Math.max((times.at(-1) ?? 1) - first, 1e-12);
  const tones = scale.map((colour) => new Color(colour));
  return (t) => {
    const share = Math.min(Math.max((t - first) / span, 0), 1) * (tones.length - 1);
    const k = Math.min(Math.floor(share), tones.length - 2);
    return new Color().lerpColors(tones[k] ?? new Color(), tones[k + 1] ?? new Color(), share - k);
  };
}
