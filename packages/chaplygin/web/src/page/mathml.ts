/** Formulas of the page model as elements of the page. */

const NAMESPACE = "http://www.w3.org/1998/Math/MathML";

/** The formula of a text in MathML, without anything that is no formula; the text itself if none. */
export function formula(text: string): Node {
  const parsed = new DOMParser().parseFromString(text, "text/html");
  const math = parsed.querySelector("math");
  if (math === null) return document.createTextNode(text);
  clean(math);
  return document.importNode(math, true);
}

/** A short formula as text, with lowered and raised digits, for labels and lists. */
export function plain(text: string): string {
  const parsed = new DOMParser().parseFromString(text, "text/html");
  return (written(parsed.querySelector("math") ?? parsed.body)).trim() || text;
}

function written(element: Element): string {
  const parts = [...element.children].map(written);
  const [first = "", second = "", third = ""] = parts;
  switch (element.localName) {
    case "msub":
      return first + shifted(second, LOWERED);
    case "msup":
      return first + shifted(second, RAISED);
    case "msubsup":
      return first + shifted(second, LOWERED) + shifted(third, RAISED);
    case "mfrac":
      return `${first}/${second}`;
    case "mover":
      return first + (second === "˙" ? "\u0307" : second === "¨" ? "\u0308" : second);
    default:
      return parts.length > 0 ? parts.join("") : (element.textContent ?? "");
  }
}

const DIGITS = "0123456789";
const LOWERED = "₀₁₂₃₄₅₆₇₈₉";
const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/** Digits as those of another line; anything else as it is. */
function shifted(text: string, line: string): string {
  return [...text].map((letter) => line[DIGITS.indexOf(letter)] ?? letter).join("");
}

function clean(element: Element): void {
  for (const { name } of [...element.attributes]) {
    if (name.startsWith("on") || name === "href") element.removeAttribute(name);
  }
  for (const child of [...element.children]) {
    if (child.namespaceURI === NAMESPACE) clean(child);
    else child.remove();
  }
}
