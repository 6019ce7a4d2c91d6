/** The experiment file of what is shown. */

/** One number of an experiment as it is shown, and as the file of the model gives it. */
export interface FileNumber {
  /** Name of a parameter or of a start input, with the index of a component. */
  name: string;
  value: number;
  usual: number;
}

/**
 * An experiment file with the parameters and the start that are shown.
 *
 * A change for which the file has no place is written above it as a remark: nothing is left out unsaid.
 */
export function editedExperiment(text: string, parameters: readonly FileNumber[], start: readonly FileNumber[], until: number | null): string {
  let file = text;
  const remarks: string[] = [];
  const apply = (places: readonly Place[], name: string, value: number, usual: number | null): void => {
    const next = placed(file, places, value, usual);
    if (next === null) remarks.push(`# ${name} = ${value} was set in the page; this file has no such entry`);
    else file = next;
  };
  const isChanged = ({ value, usual }: FileNumber): boolean => value !== usual;
  // a file that has one of two equal moments or axes changes both
  const isTied = (one: FileNumber): boolean =>
    /^[Ib]_\d$/.test(one.name) && parameters.some((each) => isChanged(each) && each.name[0] === one.name[0] && each.usual === one.usual);
  for (const each of parameters) {
    const { name, value, usual } = each;
    if (isChanged(each) || (isTied(each) && placed(text, parameterPlaces(name), value, usual) === null)) apply(parameterPlaces(name), name, value, usual);
  }
  for (const each of start) {
    if (!isChanged(each)) continue;
    const { name, value, usual } = each;
    const next = placed(file, startPlaces(name, start), value, null) ?? placed(file, contactOf(name), value, usual) ?? withEntry(file, name, start);
    if (next === null) apply([], name, value, null);
    else file = next;
  }
  if (until !== null) apply([{ table: "run", key: "until", indices: [[]] }], "until", until, null);
  return remarks.length > 0 ? `${remarks.join("\n")}\n\n${file}` : file;
}

/** An entry of a table; indices lead into lists, and a number may stand at several of them. */
interface Place {
  table: string;
  key: string;
  indices: readonly (readonly number[])[];
  /** The file has the number with the other sign. */
  opposite?: boolean;
}

/** Where the file of some kind of experiment has a parameter; which it is, its number tells. */
function parameterPlaces(name: string): Place[] {
  const at = (table: string, key: string, ...indices: number[][]): Place => ({ table, key, indices });
  const own = ["system.parameters", "parameters", "body.shape.parameters", "surface.parameters", "field.parameters"];
  const places = [...own.map((table) => at(table, name, [])), at(`parameters.${name}`, "value", [])];
  const tensor = /^I_(\d)(\d)$/.exec(name);
  if (tensor) {
    const [i, j] = [Number(tensor[1]) - 1, Number(tensor[2]) - 1];
    places.push(at("body", "inertia", [i, j], ...(i === j ? [] : [[j, i]])));
  }
  const component = /^(.+)_(\d)$/.exec(name);
  if (component) {
    const [stem, k] = [component[1] ?? "", Number(component[2]) - 1];
    places.push(at(`parameters.${stem}`, "value", [k]), at(`parameters.${stem}`, "diagonal", [k]));
    const [table, key] = VECTORS[stem] ?? [];
    if (table !== undefined && key !== undefined) places.push(at(table, key, [k]));
  }
  const [table, key] = NUMBERS[name] ?? [];
  if (table !== undefined && key !== undefined) places.push(at(table, key, []));
  if (name === "mu") places.push(at("body", "inertia", [0], [1], [2]));
  // within a sphere its radius counts as negative
  if (name === "a") places.push({ ...at("surface", "radius", []), opposite: true });
  return places;
}

/** Where the file has the contact of a ball with a surface. */
function contactOf(name: string): Place[] {
  const component = /^x_(\d)$/.exec(name);
  return component ? [{ table: "start", key: "contact", indices: [[Number(component[1]) - 1]] }] : [];
}

/** Where the file of a body has vectors and numbers that the equations name so. */
const VECTORS: Readonly<Record<string, readonly [string, string]>> = {
  I: ["body", "inertia"],
  k: ["body", "gyrostat"],
  c: ["body.shape", "centre"],
  b: ["body.shape", "axes"],
};
const NUMBERS: Readonly<Record<string, readonly [string, string]>> = {
  m: ["body", "mass"],
  g: ["field", "gravity"],
  R: ["body.shape", "radius"],
  b: ["body.shape", "radius"],
  a: ["surface", "radius"],
};

/** The vector of which a number of the start is a component; null of one that stands alone. */
function vectorOf(name: string, start: readonly FileNumber[]): { stem: string; index: number; values: string } | null {
  const stem = /^(.+)_[wxyz1-9]$/.exec(name)?.[1];
  if (stem === undefined) return null;
  const all = start.filter((each) => each.name.length === stem.length + 2 && each.name.startsWith(`${stem}_`));
  return { stem, index: all.findIndex((each) => each.name === name), values: `[${all.map(({ value }) => value).join(", ")}]` };
}

function startPlaces(name: string, start: readonly FileNumber[]): Place[] {
  const vector = vectorOf(name, start);
  const whole = { table: "start", key: name, indices: [[]] };
  return vector === null ? [whole] : [{ table: "start", key: vector.stem, indices: [[vector.index]] }, whole];
}

/** The file with a further entry of its start, where it may have one; null where it may not. */
function withEntry(file: string, name: string, start: readonly FileNumber[]): string | null {
  const head = "\n[start]\n";
  // the entries of a matrix
  if (!file.includes(head) || /_\d\d$/.test(name)) return null;
  const vector = vectorOf(name, start);
  const entry = vector === null ? `${name} = ${start.find((each) => each.name === name)?.value}` : `${vector.stem} = ${vector.values}`;
  if (/^\[(?:system|frame)\]$/m.test(file)) return file.replace(head, `${head}${entry}\n`);
  // a ball on a surface may be given by its centre
  const given = /^(?:contact|centre) *=.*$/m;
  return vector?.stem === "R" && given.test(file) ? file.replace(given, `centre = ${vector.values}`) : null;
}

/** The file with a number at the first of some places where it has the `usual` one; null where none has. */
function placed(file: string, places: readonly Place[], value: number, usual: number | null): string | null {
  for (const place of places) {
    const sign = place.opposite === true ? -1 : 1;
    const next = replaced(file, place, sign * value, usual === null ? null : sign * usual);
    if (next !== null) return next;
  }
  return null;
}

/** The file with a number replaced; null where there is no such entry, or another number than the usual one. */
function replaced(file: string, { table, key, indices }: Place, value: number, usual: number | null): string | null {
  const lines = file.split("\n");
  const head = lines.findIndex((line) => line.trim() === `[${table}]`);
  if (head < 0) return null;
  for (let n = head + 1; n < lines.length && !(lines[n] ?? "").trim().startsWith("["); n++) {
    const match = /^(\s*(?:"[^"]*"|[\w.]+)\s*=\s*)(.*)$/.exec(lines[n] ?? "");
    if (match === null || (match[1] ?? "").replace(/[\s="]/g, "") !== key) continue;
    let entry: string | null = match[2] ?? "";
    for (const index of indices) entry = entry === null ? null : withNumber(entry, index, value, usual);
    if (entry === null) return null;
    lines[n] = (match[1] ?? "") + entry;
    return lines.join("\n");
  }
  return null;
}

const NUMBER = /[-+]?(?:\d[\d_]*\.?\d*(?:[eE][-+]?\d+)?|inf|nan)/;

/** An entry with the number at a place replaced: itself, that of a list, or `value` of an inline table. */
function withNumber(entry: string, index: readonly number[], value: number, usual: number | null): string | null {
  const fits = (text: string): boolean => usual === null || Math.abs(Number(text.replaceAll("_", "")) - usual) <= 1e-12 * Math.abs(usual);
  if (index.length === 0) {
    const inline = /^(\{.*?\bvalue\s*=\s*)([-+\d.eE_]+)(.*)$/.exec(entry);
    if (inline) return fits(inline[2] ?? "") ? (inline[1] ?? "") + String(value) + (inline[3] ?? "") : null;
    const number = NUMBER.exec(entry);
    return number?.index === 0 && fits(number[0]) ? entry.replace(NUMBER, String(value)) : null;
  }
  const depth = index.length;
  const at = new Array<number>(depth + 1).fill(0);
  let level = 0;
  for (let k = 0; k < entry.length; k++) {
    const letter = entry[k];
    if (letter === "[") at[++level] = 0;
    else if (letter === "]") level -= 1;
    else if (letter === ",") at[level] = (at[level] ?? 0) + 1;
    else if (level === depth && index.every((wanted, n) => at[n + 1] === wanted)) {
      const number = NUMBER.exec(entry.slice(k));
      if (number === null || number.index !== 0) continue;
      if (!fits(number[0])) return null;
      return entry.slice(0, k) + String(value) + entry.slice(k + number[0].length);
    }
  }
  return null;
}
