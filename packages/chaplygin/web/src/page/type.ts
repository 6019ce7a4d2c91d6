/** The type of what is drawn. */

export const SERIF = "'STIX Two Text', 'Palatino Linotype', Palatino, Georgia, serif";

/** The size of the page's letters in pixels. */
export function letter(): number {
  return Number.parseFloat(getComputedStyle(document.documentElement).fontSize) || 16;
}

/** A font of a size in pixels, a whole number: uPlot enlarges no more than that of it on fine screens. */
export function font(pixels: number): string {
  return `${Math.round(pixels)}px ${SERIF}`;
}
