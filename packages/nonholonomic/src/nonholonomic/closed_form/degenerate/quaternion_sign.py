"""Continuous signs of quaternions along a motion that is at least asymptotically periodic."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from flowlanes.system.arrays import FloatArray

from ..genus_two.attitude import continuous_signs as agreeing_signs

#: Number of points per period in the table of quaternions.
POINTS = 512


@dataclass(frozen=True)
class Signs:
    """Quaternions with continuous signs on a grid in τ.

    Attributes
    ----------
    low, step : float
        First point and step of the grid.
    table : array (n, 4)
        Quaternions on the grid, from a period before the first edge to a period after the last.
    flips : (±1, ±1)
        Factors by which a period multiplies the quaternion, in the past and in the future.
    """

    low: float
    step: float
    table: FloatArray
    flips: tuple[float, float]

    def continuous(self, tau: FloatArray, turns: FloatArray, quaternions: FloatArray) -> FloatArray:
        """Quaternions (n, 4) at τ on the grid, `turns` periods later, with their signs."""
        index = np.clip(np.rint((tau - self.low) / self.step), 0, len(self.table) - 1)
        near = self.table[index.astype(int)]
        agree = np.sum(near * quaternions, axis=1) < 0
        flip = np.where(turns < 0, self.flips[0], self.flips[1])
        sign = np.where(agree, -1.0, 1.0) * np.where(turns % 2 == 1, flip, 1.0)
        return sign[:, None] * quaternions


def continuous_signs(
    attitude: Callable[[FloatArray], FloatArray],
    first: float,
    last: float,
    period: float,
    start: FloatArray,
) -> Signs:
    """Choose the signs that make the quaternion of a motion continuous.

    Parameters
    ----------
    attitude : callable
        τ (n,) ↦ quaternions (n, 4) with any signs.
    first, last : float
        Before and after them the attitude is periodic, but for the sign.
    period : float
    start : array (4,)
        The quaternion at τ = 0, with its sign.
    """
    step = period / POINTS
    count = int(np.ceil((last - first) / step)) + 2 * POINTS
    tau = first - period + step * np.arange(count + 1, dtype=float)
    table = attitude(tau)
    table = table * agreeing_signs(table)[:, None]
    zero = round(-tau[0] / step)
    table = table * (1.0 if float(table[zero] @ start) > 0 else -1.0)
    flips = [np.sign(float(table[k] @ table[k + POINTS])) for k in (0, count - POINTS)]
    return Signs(float(tau[0]), step, table, (float(flips[0]), float(flips[1])))
