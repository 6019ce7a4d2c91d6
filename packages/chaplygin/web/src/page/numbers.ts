/** Numbers as they are read. */

const MINUS = "\u2212";
const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** A number with `digits` significant ones, as it is printed: 1.5, −0.02, 3.2 × 10⁻⁷. */
export function readable(value: number, digits = 4): string {
  if (Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return value > 0 ? "∞" : `${MINUS}∞`;
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return trimmed(value.toPrecision(digits)).replace("-", MINUS);
  const [mantissa = "", exponent = "0"] = value.toExponential(digits - 1).split("e");
  const short = trimmed(mantissa).replace("-", MINUS);
  return `${short} × ${powerOfTen(Number(exponent))}`;
}

function powerOfTen(power: number): string {
  const raised = [...String(Math.abs(power))].map((digit) => RAISED[Number(digit)]).join("");
  return `10${power < 0 ? "⁻" : ""}${raised}`;
}

/** Share of the largest of several values below which one of them is rounding. */
const ROUNDING = 1e-12;

/** A number among others of at most this size, beside which rounding is nothing: it reads 0. */
export function readableBeside(size: number, value: number, digits = 4): string {
  return readable(Math.abs(value) < ROUNDING * size ? 0 : value, digits);
}

/** A value on an axis with this range. */
export function readableOn([low, high]: readonly [number, number], value: number): string {
  return readableBeside(Math.max(Math.abs(low), Math.abs(high)), value);
}

function trimmed(text: string): string {
  const plain = text.includes("e") ? String(Number(text)) : text;
  return plain.includes(".") ? plain.replace(/\.?0+$/, "") : plain;
}

/** The number 1, 2 or 5 times a power of ten that is next below `size`. */
export function roundNumber(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const step = [5, 2, 1].find((candidate) => candidate * power <= size * (1 + 1e-9)) ?? 1;
  return step * power;
}

/** A range that shows all finite values with a margin; a whole one where they are all alike. */
export function extent(values: Iterable<number>, margin = 0.05): [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  if (high - low <= 1e-9 * size || high === low) {
    const half = size > 0 ? 0.1 * size : 1;
    return [low - half, high + half];
  }
  const room = margin * (high - low);
  return [low - room, high + room];
}

/** Places for marks on an axis: round numbers, about `count` of them. */
export function ticks(low: number, high: number, count: number): number[] {
  const rough = (high - low) / Math.max(1, count);
  if (!(rough > 0)) return [low];
  let step = roundNumber(rough);
  while ((high - low) / step > 1.35 * count) step = roundNumber(2.5 * step);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
}

/** What marks on an axis read, with as many digits as tell neighbours apart. */
export function tickTexts(marks: readonly number[]): string[] {
  const size = Math.max(...marks.map(Math.abs));
  const step = Math.abs((marks[1] ?? 0) - (marks[0] ?? 0));
  const digits = step > 0 ? Math.ceil(Math.log10(size / step)) + 1 : 6;
  return marks.map((mark) => readable(mark, Math.min(12, Math.max(6, digits))));
}

/** What marks on an axis read, and its label (with its unit in brackets after two spaces), where a power of ten is common to them. */
export function axisTexts(marks: readonly number[], label: string): { texts: string[]; label: string } {
  const size = Math.max(...marks.map(Math.abs));
  if (!(size > 0) || (size >= 1e-2 && size < 1e5)) return { texts: tickTexts(marks), label };
  const power = Math.floor(Math.log10(size));
  const factor = powerOfTen(power);
  const texts = tickTexts(marks.map((mark) => mark / 10 ** power));
  return { texts, label: label.includes("  (") ? label.replace("  (", `  (${factor} `) : `${label}  (${factor})` };
}
