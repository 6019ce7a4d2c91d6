/** Rotation numbers, from an angle at the points of a section. */

const TURN = 2 * Math.PI;

/**
 * The mean advance of an angle per return, in turns, nearest to zero; not a number where the advance
 * covers the whole circle, so that the angle has no lift.
 *
 * Values are weighted so that the mean of a quasi-periodic motion converges faster than any power.
 */
export function rotationNumber(angles: ArrayLike<number>): number {
  const count = angles.length - 1;
  if (count < 8) return NaN;
  const advance = Float64Array.from({ length: count }, (_, k) => {
    const step = ((angles[k + 1] ?? NaN) - (angles[k] ?? NaN)) / TURN;
    return step - Math.floor(step);
  });
  const cut = gap(advance);
  if (Number.isNaN(cut)) return NaN;
  let sum = 0;
  let weights = 0;
  for (let k = 0; k < count; k++) {
    const shifted = (advance[k] ?? NaN) - cut;
    const place = (k + 0.5) / count;
    const weight = Math.exp(-1 / (place * (1 - place)));
    sum += weight * (shifted - Math.floor(shifted) + cut);
    weights += weight;
  }
  const mean = sum / weights;
  return mean - Math.round(mean);
}

/** Angles of points about their mean, each coordinate in units of its spread. */
export function anglesAbout(x: ArrayLike<number>, y: ArrayLike<number>): Float64Array {
  const [across, up] = [centred(x), centred(y)];
  return Float64Array.from(across, (value, k) => Math.atan2(up[k] ?? NaN, value));
}

function centred(values: ArrayLike<number>): Float64Array {
  const list = Float64Array.from(values);
  const mean = list.reduce((sum, value) => sum + value, 0) / list.length;
  const spread = Math.sqrt(list.reduce((sum, value) => sum + (value - mean) ** 2, 0) / list.length);
  return list.map((value) => (value - mean) / (spread || 1));
}

/** The middle of the greatest gap between advances on the circle; not a number where none stands out. */
function gap(advance: Float64Array): number {
  const order = advance.slice().sort();
  const gaps = Array.from(order, (value, k) => (k + 1 < order.length ? (order[k + 1] ?? 0) : (order[0] ?? 0) + 1) - value);
  const widest = gaps.reduce((best, value, k) => (value > (gaps[best] ?? 0) ? k : best), 0);
  const width = gaps[widest] ?? 0;
  const second = gaps.reduce((most, value, k) => (k === widest ? most : Math.max(most, value)), 0);
  // all advances alike: the gap is the circle
  if (!(width >= 0.02) || width < 2 * second) return NaN;
  return (order[(widest + 1) % order.length] ?? 0) - width / 2;
}
