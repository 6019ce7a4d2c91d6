/** The colours of the page: those of the project's figures, by day and by night. */

export interface Palette {
  dark: boolean;
  ink: string;
  quiet: string;
  line: string;
  paper: string;
  alarm: string;
  /** Colours of time, from the first instant to the last. */
  time: readonly string[];
  /** The two tones of a body, and of a hollow one. */
  body: readonly [string, string];
  shell: readonly [string, string];
  seam: string;
  ground: readonly [light: string, dark: string];
  /** Lines of the grid on a plane, and of those on a surface. */
  grid: string;
  lines: string;
  shadow: number;
  /** Colours of the components 1, 2, 3 of a vector. */
  components: readonly string[];
  /** Colours that tell many things apart. */
  series: readonly string[];
  /** Colours of the modes of a contact with friction, by name: those of the still figures. */
  modes: Readonly<Record<string, string>>;
}

/* Paul Tol's high-contrast and muted colours: apart for every kind of colour vision. */
const DAY: Palette = {
  dark: false,
  ink: "#1f2730",
  quiet: "#66727d",
  line: "#d9dfe4",
  paper: "#ffffff",
  alarm: "#bb5566",
  time: ["#f6c667", "#ec8f4d", "#cf4f5b", "#8a2a75", "#3b1a68"],
  body: ["#f4f1ea", "#5b86ad"],
  shell: ["#f0ece2", "#a9bfd3"],
  seam: "#3d5a76",
  ground: ["#f4f7fa", "#b3bfcb"],
  grid: "#aab6c2",
  lines: "#aab6c2",
  shadow: 0.34,
  components: ["#004488", "#bb5566", "#d9a521"],
  series: ["#332288", "#cc6677", "#117733", "#ddaa33", "#88ccee", "#aa4499", "#999933", "#44aa99"],
  modes: {
    flight: "#88ccee",
    sliding: "#aa4499",
    "sliding without spin": "#aa4499",
    rolling: "#44aa99",
    "rolling without spin": "#44aa99",
    rest: "#1f2730",
    "sliding without rolling": "#882255",
    "sliding without turning": "#882255",
    spinning: "#999933",
  },
};

const NIGHT: Palette = {
  dark: true,
  ink: "#dde3e8",
  quiet: "#97a4af",
  line: "#36414b",
  paper: "#151a1f",
  alarm: "#e58a99",
  time: ["#f8d98c", "#f2a65a", "#e66f79", "#b873d6", "#8fa8ff"],
  body: ["#f4f1ea", "#5b86ad"],
  shell: ["#dcd9d0", "#8fa9c2"],
  seam: "#25394d",
  ground: ["#5b6773", "#2c353e"],
  grid: "#56636f",
  lines: "#94a3b1",
  shadow: 0.6,
  components: ["#6ea8e6", "#e58a99", "#e6bd52"],
  series: ["#a497f3", "#e58a99", "#58b97b", "#e6bd52", "#88ccee", "#d582c8", "#c3c35c", "#5cc4b2"],
  modes: {
    flight: "#88ccee",
    sliding: "#d582c8",
    "sliding without spin": "#d582c8",
    rolling: "#5cc4b2",
    "rolling without spin": "#5cc4b2",
    rest: "#dde3e8",
    "sliding without rolling": "#dd88aa",
    "sliding without turning": "#dd88aa",
    spinning: "#c3c35c",
  },
};

const night = (): MediaQueryList | null =>
  typeof matchMedia === "function" ? matchMedia("(prefers-color-scheme: dark)") : null;

/** The colours for the scheme that the reader prefers; on paper always those of the day. */
export function palette(): Palette {
  return night()?.matches ? NIGHT : DAY;
}

/** The colours of print and of files. */
export const daylight = DAY;

/** Call `act` when the reader changes between day and night. */
export function onSchemeChange(act: () => void): void {
  night()?.addEventListener("change", act);
}

/** Red, green and blue from 0 to 255 of a colour #rrggbb. */
export function channels(colour: string): [number, number, number] {
  const code = Number.parseInt(colour.slice(1), 16);
  return [(code >> 16) & 255, (code >> 8) & 255, code & 255];
}

/** The colour at a share from 0 to 1 of a scale. */
export function onScale(scale: readonly string[], share: number): [number, number, number] {
  const last = scale.length - 1;
  const place = Math.min(Math.max(share, 0), 1) * last;
  const index = Math.min(Math.floor(place), last - 1);
  const [a, b] = [channels(scale[index] ?? "#000000"), channels(scale[index + 1] ?? "#000000")];
  const part = place - index;
  return [0, 1, 2].map((k) => Math.round((a[k] ?? 0) + part * ((b[k] ?? 0) - (a[k] ?? 0)))) as [
    number,
    number,
    number,
  ];
}

/** From regular to chaotic. */
export function indicatorScale(): readonly string[] {
  return palette().dark ? INDICATOR_BY_NIGHT : INDICATOR_BY_DAY;
}

/* Without its darkest part, which is lost on a dark page. */
const INDICATOR_BY_NIGHT = ["#4f7cc4", "#6a7fae", "#7f8592", "#93907f", "#a99d74", "#c3b369", "#e1cc55", "#fee838"] as const;

/* Dark blue to yellow, in even steps of lightness (cividis). */
const INDICATOR_BY_DAY = [
  "#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838",
] as const;
