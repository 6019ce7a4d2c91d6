/** A chart that is drawn row by row as it is computed elsewhere. */

import { element } from "../page/dom";
import type { Answer } from "../sources/ask";

interface Head {
  title: string;
  unit: string;
  store: string;
  x: { name: string; low: number; high: number; count: number };
  y: { name: string; low: number; high: number; count: number };
}

interface Tile {
  row: number;
  width: number;
  height: number;
  values: (number | null)[];
}

/** Colours from low to high, even to the eye and to every kind of colour vision. */
const COLOURS = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]] as const;

/** Shows the parts of one chart: a canvas first, then its rows. */
export function tileChart(): (answer: Answer) => Node | null {
  let head: Head | null = null;
  let values = new Float64Array(0);
  const canvas = element("canvas", { class: "lab-tile-chart", role: "img" });
  const key = element("p", { class: "lab-hint" });
  return (answer) => {
    if (answer["chart"] !== undefined) {
      head = answer["chart"] as Head;
      canvas.width = head.x.count;
      canvas.height = head.y.count;
      values = new Float64Array(head.x.count * head.y.count).fill(NaN);
      canvas.setAttribute("aria-label", `${head.title} over ${head.x.name} and ${head.y.name}`);
      return element("figure", {}, canvas, key);
    }
    if (answer["tile"] !== undefined && head !== null) {
      const { row, width, values: rows } = answer["tile"] as Tile;
      rows.forEach((value, n) => (values[row * width + n] = value ?? NaN));
      const [low, high] = paint(canvas, values, head.x.count);
      const unit = head.unit === "1" ? "" : ` ${head.unit}`;
      key.textContent =
        `${head.title} from ${low.toPrecision(4)} (dark) to ${high.toPrecision(4)}${unit} (light); ` +
        `${head.x.name} from ${head.x.low} to ${head.x.high} across, ${head.y.name} from ${head.y.low} to ${head.y.high} up; kept in ${head.store}`;
    }
    return null;
  };
}

/** Paint the numbers there are, the first row lowest; their range. */
function paint(canvas: HTMLCanvasElement, values: Float64Array, width: number): [number, number] {
  const finite = values.filter(Number.isFinite).sort();
  const low = finite[Math.floor(0.005 * finite.length)] ?? 0;
  const high = finite[Math.ceil(0.995 * finite.length) - 1] ?? 1;
  const height = values.length / width;
  const pen = canvas.getContext("2d");
  if (pen === null) return [low, high];
  const image = pen.createImageData(width, height);
  values.forEach((value, n) => {
    if (!Number.isFinite(value)) return;
    const place = 4 * ((height - 1 - Math.floor(n / width)) * width + (n % width));
    image.data.set([...colour((value - low) / (high - low || 1)), 255], place);
  });
  pen.putImageData(image, 0, 0);
  return [low, high];
}

function colour(share: number): number[] {
  const at = Math.min(1, Math.max(0, share)) * (COLOURS.length - 1);
  const n = Math.min(COLOURS.length - 2, Math.floor(at));
  const [a, b] = [COLOURS[n] ?? COLOURS[0], COLOURS[n + 1] ?? COLOURS[4]];
  return a.map((value, k) => Math.round(value + (at - n) * ((b[k] ?? value) - value)));
}
