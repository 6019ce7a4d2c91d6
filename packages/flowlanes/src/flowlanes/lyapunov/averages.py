"""Averages over a long motion with error estimates and a convergence check."""

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
    """The mean rate of growth of a quantity along a motion.

    Attributes
    ----------
    value : float
    statistical : float
        Half width of the 95 % confidence interval from the means of 16 batches, by Student's t
        distribution: the error if the batches are independent, as on a sufficiently long chaotic
        motion.
    wandering : float
        Range of the deviation from uniform growth, divided by the time: the error for a regular
        motion, whose oscillations are bounded.
    resolution : float
        The apparent rate of a quantity that grows like the square of the time.
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
        """True if both halves of the motion agree within three errors."""
        first, second = self.halves
        return bool(abs(first - second) <= 3 * self.error)

    @property
    def zero(self) -> bool:
        """True if the mean rate is zero within its error."""
        return bool(abs(self.value) <= self.error)


def batch_means(series: FloatArray, batches: int = BATCHES) -> FloatArray:
    """Means (batches, ...) of equal batches of a series (m, ...).

    If the length is not divisible by `batches`, the first few members are omitted.

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
    # ln t² grows from `began` to began + span by 2 ln(1 + span/began).
    return POWER * float(np.log1p(span / began)) / span


def average(growth: FloatArray, interval: float, began: float) -> Average:
    """The mean rate of a quantity that grows by `growth` in each of consecutive intervals.

    Parameters
    ----------
    growth : (m,) array
        The increments.
    interval : float
        Length of an interval.
    began : float
        Start of the first interval, if the motion begins at time 0.

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
    # Deviation of the accumulated growth from a straight line; its range bounds oscillations.
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
