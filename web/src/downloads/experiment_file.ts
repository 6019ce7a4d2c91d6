/** The experiment file of what is shown. */

/** A change of one number of an experiment file. */
export interface FileChange {
  /** Name of a parameter or of a start input, with the index of a component. */
  name: string;
  value: number;
}

/**
 * An experiment file with changed parameters and a changed start.
 *
 * A change for which the file has no place is written above it as a remark: nothing is left out unsaid.
 */
export function editedExperiment(text: string, parameters: readonly FileChange[], start: readonly FileChange[], until: number | null): string {
  let file = text;
  const remarks: string[] = [];
  const apply = (places: readonly Place[], name: string, value: number): void => {
    for (const place of places) {
      const next = replaced(file, place, value);
      if (next !== null) {
        file = next;
        return;
      }
    }
    remarks.push(`# ${name} = ${value} was set in the page; this file has no such entry`);
  };
  for (const { name, value } of parameters) apply(parameterPlaces(name), name, value);
  for (const { name, value } of start) apply(startPlaces(name), name, value);
  if (until !== null) apply([{ table: "run", key: "until", indices: [[]] }], "until", until);
  return remarks.length > 0 ? `${remarks.join("\n")}\n\n${file}` : file;
}

/** An entry of a table; indices lead into lists, and a number may stand at several of them. */
interface Place {
  table: string;
  key: string;
  indices: readonly (readonly number[])[];
}

function parameterPlaces(name: string): Place[] {
  const plain = [
    { table: "system.parameters", key: name, indices: [[]] },
    { table: "parameters", key: name, indices: [[]] },
  ];
  const one = (table: string, key: string, ...indices: number[][]): Place[] => [...plain, { table, key, indices }];
  const tensor = /^I_(\d)(\d)$/.exec(name);
  if (tensor) {
    const [i, j] = [Number(tensor[1]) - 1, Number(tensor[2]) - 1];
    return one("body", "inertia", [i, j], ...(i === j ? [] : [[j, i]]));
  }
  const moment = /^I_(\d)$/.exec(name);
  if (moment) return one("body", "inertia", [Number(moment[1]) - 1]);
  if (name === "m") return one("body", "mass", []);
  if (name === "g") return one("field", "gravity", []);
  if (name === "R") return one("body.shape", "radius", []);
  return plain;
}

function startPlaces(name: string): Place[] {
  const component = /^(.+)_(\d)$/.exec(name);
  const whole = { table: "start", key: name, indices: [[]] };
  return component ? [{ table: "start", key: component[1] ?? name, indices: [[Number(component[2]) - 1]] }, whole] : [whole];
}

/** The file with a number replaced; null where there is no such entry. */
function replaced(file: string, { table, key, indices }: Place, value: number): string | null {
  const lines = file.split("\n");
  const head = lines.findIndex((line) => line.trim() === `[${table}]`);
  if (head < 0) return null;
  for (let n = head + 1; n < lines.length && !(lines[n] ?? "").trim().startsWith("["); n++) {
    const match = /^(\s*(?:"[^"]*"|[\w.]+)\s*=\s*)(.*)$/.exec(lines[n] ?? "");
    if (match === null || (match[1] ?? "").replace(/[\s="]/g, "") !== key) continue;
    let entry: string | null = match[2] ?? "";
    for (const index of indices) entry = entry === null ? null : withNumber(entry, index, value);
    if (entry === null) return null;
    lines[n] = (match[1] ?? "") + entry;
    return lines.join("\n");
  }
  return null;
}

const NUMBER = /[-+]?(?:\d[\d_]*\.?\d*(?:[eE][-+]?\d+)?|inf|nan)/;

/** An entry with the number at a place replaced: itself, that of a list, or `value` of an inline table. */
function withNumber(entry: string, index: readonly number[], value: number): string | null {
  if (index.length === 0) {
    const inline = /^(\{.*?\bvalue\s*=\s*)([-+\d.eE_]+)(.*)$/.exec(entry);
    if (inline) return (inline[1] ?? "") + String(value) + (inline[3] ?? "");
    return new RegExp(`^${NUMBER.source}`).test(entry) ? entry.replace(NUMBER, String(value)) : null;
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
      return entry.slice(0, k) + String(value) + entry.slice(k + number[0].length);
    }
  }
  return null;
}
