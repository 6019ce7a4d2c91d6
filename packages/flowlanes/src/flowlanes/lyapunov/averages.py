"""Averages over a long motion, with error estimates and a convergence check."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from ..errors import InputError
from ..system.arrays import FloatArray

#: Number of batches into which a series is divided.
BATCHES = 16
#: Smallest number of intervals per batch.
SMALLEST = 4
#: Confidence level of the statistical error.
CONFIDENCE = 0.95
#: Exponent of a power of time whose growth cannot be distinguished from a constant.
POWER = 2


@dataclass(frozen=True)
class Average:
    """The mean rate of a quantity that accumulates along a motion.

    Attributes
    ----------
    value : float
    statistical : float
        Half the 95 % confidence interval from the means of 16 batches, by Student's t: the error
        if the batches are independent, as they are on a chaotic motion that is long enough.
    wandering : float
        Deviation of the sum from even growth, divided by the time: the error of a regular
        motion, where what comes back and forth stays bounded.
    resolution : float
        The rate that growth like the square of the time would show.
    halves : tuple of two floats
        The means over the first and the second half.
    """

    value: float
    statistical: float
    wandering: float
    resolution: float
    halves: tuple[float, float]

    @property
    def error(self) -> float:
        """The largest of the three errors."""
        return max(self.statistical, self.wandering, self.resolution)

    @property
    def halves_agree(self) -> bool:
        """Whether both halves of the motion agree within three errors."""
        first, second = self.halves
        return bool(abs(first - second) <= 3 * self.error)

    @property
    def zero(self) -> bool:
        """Whether it is zero within its error."""
        return bool(abs(self.value) <= self.error)


def batch_means(series: FloatArray, batches: int = BATCHES) -> FloatArray:
    """Means (batches, ...) of equal batches of a series (m, ...).

    If the length is not divisible, the first few members are omitted.

    Raises
    ------
    InputError
        If the series is too short.
    """
    each = len(series) // batches
    if each < SMALLEST:
        raise InputError(
            f"{len(series)} intervals are too few for an error: at least {batches * SMALLEST} are "
            "needed"
        )
    last = series[len(series) - each * batches :]
    means: FloatArray = last.reshape(batches, each, *series.shape[1:]).mean(axis=1)
    return means


def resolution(span: float, began: float) -> float:
    """The apparent rate of quadratic growth over a time `span` from `began`."""
    return POWER * float(np.log1p(span / began)) / span


def average(growth: FloatArray, interval: float, began: float) -> Average:
    """The mean rate of a quantity that grows by `growth` in each of a sequence of intervals.

    Parameters
    ----------
    growth : (m,) array
        The increment of each interval.
    interval : float
        Its length.
    began : float
        When the first interval began; the motion itself began at time 0.

    Returns
    -------
    Average

    Raises
    ------
    InputError
        If there are fewer than 64 intervals.
    """
    from scipy.special import stdtrit

    means = batch_means(growth) / interval
    span = len(growth) * interval
    value = float(growth.sum() / span)
    student = float(stdtrit(BATCHES - 1, (1 + CONFIDENCE) / 2))
    strayed = np.cumsum(growth) - value * interval * np.arange(1, len(growth) + 1)
    half = len(growth) // 2
    return Average(
        value,
        student * float(means.std(ddof=1)) / BATCHES**0.5,
        float(np.ptp(strayed)) / span,
        resolution(span, max(began, interval)),
        (
            float(growth[:half].mean()) / interval,
            float(growth[half:].mean()) / interval,
        ),
    )
