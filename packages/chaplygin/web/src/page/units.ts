/** Units as they are read. */

const RAISED: Record<string, string> = { "-": "⁻", "0": "⁰", "1": "¹", "2": "²", "3": "³", "4": "⁴", "5": "⁵", "6": "⁶", "7": "⁷", "8": "⁸", "9": "⁹" };

/** A unit with raised exponents; nothing for a pure number. */
export function unitText(unit: string): string {
  if (unit === "1" || unit === "unknown") return "";
  const raised = unit.replace(/(?:\*\*|\^)\{?(-?\d+)\}?/g, (_, digits: string) => [...digits].map((digit) => RAISED[digit] ?? digit).join(""));
  return raised.replaceAll("*", " ").trim();
}
