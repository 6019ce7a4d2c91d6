/** The type of what is drawn. */

export const SERIF = "'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif";

/** The size of the page's letters in pixels. */
export function letter(): number {
  return Number.parseFloat(getComputedStyle(document.documentElement).fontSize) || 16;
}
