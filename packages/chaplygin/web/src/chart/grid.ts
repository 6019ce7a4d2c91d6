/** The order in which the cells of a chart are computed: coarse first, each cell once. */

/** A cell of a chart, and the side of the square that it stands for until finer ones are known. */
export interface Cell {
  column: number;
  row: number;
  side: number;
}

/** All cells of a square grid in passes, each twice as fine as the one before. */
export function coarseFirst(size: number, first = 16): Cell[] {
  const cells: Cell[] = [];
  let coarsest = 1;
  while (coarsest * 2 <= first && coarsest * 2 <= size) coarsest *= 2;
  for (let side = coarsest; side >= 1; side /= 2) {
    for (let row = 0; row < size; row += side) {
      for (let column = 0; column < size; column += side) {
        const known = side < coarsest && row % (2 * side) === 0 && column % (2 * side) === 0;
        if (!known) cells.push({ column, row, side });
      }
    }
  }
  return cells;
}

/** The value in the middle of a cell of an axis. */
export function middle([low, high]: readonly [number, number], index: number, size: number): number {
  return low + ((index + 0.5) / size) * (high - low);
}

/** A number between others so that a share of all finite values is below it. */
export function quantile(values: Float64Array, share: number): number {
  const sorted = values.filter(Number.isFinite).sort();
  return sorted.length === 0 ? NaN : (sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))] ?? NaN);
}
