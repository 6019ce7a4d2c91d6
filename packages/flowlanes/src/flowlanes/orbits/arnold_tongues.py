"""Devil's staircases of rotation numbers, and Arnold tongues: the edges of their steps.

A circle map x ↦ f(x) with a lift, in turns, has the rotation number p/q if its displacement D(x) =
f^q(x) − x − p has a zero, that is, if min D ≤ 0 ≤ max D. If an increase of a parameter moves the
map forwards, max D = 0 at the lower edge of the step and min D = 0 at the upper one. Both
conditions are smooth; unlike rotation numbers, they determine widths down to rounding level.

Examples
--------
>>> from fractions import Fraction
>>> import numpy as np
>>> def arnold(angles, shifts, count):
...     rows = [angles]
...     for _ in range(count):
...         rows.append(rows[-1] + shifts - 0.8 / (2 * np.pi) * np.sin(2 * np.pi * rows[-1]))
...     return np.stack(rows, axis=1)
>>> step = locked_interval(arnold, Fraction(0), (-0.3, 0.3))
>>> print(round(step.low, 6), round(step.high, 6))
-0.127324 0.127324
>>> staircase(arnold, np.array([0.0, 0.5])).rotations.round(6).tolist()
[0.0, 0.5]
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from fractions import Fraction
from itertools import pairwise
from math import gcd
from typing import Protocol

import numpy as np

from ..arguments import arguments_checked
from ..errors import InputError, RunError
from ..system.arrays import FloatArray
from .rotation import FIRST, average

#: Error of one step of an integrated map, in turns.
ACCURACY = 1e-13
#: Initial number of sample points of a displacement on the circle, per step of the cycle.
SAMPLES = 8
#: Maximum number of points.
FINEST = 4096
#: Fraction of the largest Fourier coefficient at which a displacement counts as resolved.
COEFFICIENT_TOLERANCE = 1e-9
#: Relative size below which, and number of points above which, constant coefficients count as
#: noise.
NOISE, MANY = 1e-3, 256


class CircleMaps(Protocol):
    """A family of circle maps."""

    def __call__(self, turns: FloatArray, values: FloatArray, count: int) -> FloatArray:
        """Orbits under lifts of the maps.

        Parameters
        ----------
        turns : array (n,)
            Starts.
        values : array (n,)
            The parameter of each orbit.
        count : int
            Number of steps.

        Returns
        -------
        array (n, count + 1)
            Turns, beginning with the start.
        """
        ...


@dataclass(frozen=True)
class DevilsStaircase:
    """Rotation numbers as a function of a parameter.

    Attributes
    ----------
    values : array (n,)
        The parameter.
    rotations : array (n,)
        Turns per step.
    errors : array (n,)
        Differences between the averages over the two halves of each orbit.
    """

    values: FloatArray
    rotations: FloatArray
    errors: FloatArray


@dataclass(frozen=True)
class Displacement:
    """f^q(x) − x − p on the circle at one parameter, as a trigonometric polynomial.

    Attributes
    ----------
    least, greatest : float
        Its extrema.
    where : pair of float
        Positions of the extrema, in turns.
    noise : float
        Effect of errors of the map on the extrema: its accuracy, and the size of the coefficients
        that should vanish.
    mean : float
    """

    least: float
    greatest: float
    where: tuple[float, float]
    noise: float
    mean: float


@dataclass(frozen=True)
class Plateau:
    """An interval of the parameter on which the rotation number is a given fraction.

    Attributes
    ----------
    fraction : Fraction
    low, high : float
        Its edges.
    error : float
        Effect of errors of the map on each edge.
    slope : float
        The derivative of the mean displacement by the parameter.
    middle : Displacement
        The displacement in the middle of the plateau.
    """

    fraction: Fraction
    low: float
    high: float
    error: float
    slope: float
    middle: Displacement = field(repr=False)

    @property
    def width(self) -> float:
        """The width."""
        return self.high - self.low

    @property
    def open(self) -> bool:
        """True if the width exceeds the errors of the edges."""
        return self.width > 2 * self.error


@arguments_checked
def staircase(
    maps: CircleMaps,
    values: FloatArray,
    *,
    start: float = 0.0,
    tolerance: float = 1e-10,
    max_iterations: int = 1 << 14,
) -> DevilsStaircase:
    """Rotation numbers at many values of a parameter, each with enough steps.

    Parameters
    ----------
    maps : CircleMaps
    values : array (n,)
    start : float
        The initial point of all orbits, in turns.
    tolerance : float
        The required error.
    max_iterations : int
        Maximum number of steps; the errors show whether it was sufficient.

    Returns
    -------
    DevilsStaircase
        Rotation numbers (turns a step) with their errors, one for each value.

    Raises
    ------
    InputError
        If an argument is of another type.
    """
    values = np.asarray(values, dtype=float)
    rotations, errors = np.full(len(values), np.nan), np.full(len(values), np.inf)
    pending, count = np.arange(len(values)), FIRST
    while len(pending) and count <= max_iterations:
        orbits = maps(np.full(len(pending), start), values[pending], count)
        rotations[pending], errors[pending] = average(np.diff(orbits, axis=1))
        pending = pending[errors[pending] > tolerance]
        count *= 2
    return DevilsStaircase(values, rotations, errors)


def displacement(
    maps: CircleMaps, value: float, fraction: Fraction, accuracy: float = ACCURACY
) -> Displacement:
    """The displacement of the q-th iterate of a map from p turns.

    Parameters
    ----------
    maps : CircleMaps
    value : float
        The parameter.
    fraction : Fraction
        p/q.
    accuracy : float
        The error of one step of the map, turns.

    Raises
    ------
    RunError
        If the displacement is not resolved with thousands of points, or the map ends.
    """
    count, before = 32, np.inf
    while count < SAMPLES * fraction.denominator:
        count *= 2
    while count <= FINEST:
        places = np.arange(count) / count
        orbits = maps(places, np.full(count, value), fraction.denominator)
        moved = orbits[:, -1] - places - fraction.numerator
        if not np.isfinite(moved).all():
            raise RunError("the map of the circle ends", float(value))
        # The values are those of a smooth periodic function, so Fourier coefficients fall quickly;
        # the last eighth of them measures the error of the trigonometric interpolation.
        sizes = np.abs(np.fft.rfft(moved)) / count
        tail = float(sizes[-count // 8 :].max())
        rounding = accuracy * fraction.denominator
        # A noise level does not decrease with more points.
        flat = tail > before / 4 and (tail < NOISE * float(sizes.max()) or count >= MANY)
        if flat or tail <= max(COEFFICIENT_TOLERANCE * float(sizes.max()), rounding):
            return _extrema(moved, tail * float(np.sqrt(count)) + rounding)
        count, before = 2 * count, tail
    raise RunError(f"the displacement is too rough for {FINEST} points", float(value))


def _extrema(displacement: FloatArray, noise: float) -> Displacement:
    """Extrema of the trigonometric polynomial through equidistant values."""
    count = len(displacement)
    powers = 2j * np.pi * np.arange(count // 2 + 1)
    # D(x) = Re Σ c_k exp(2πi k x) with doubled coefficients for k > 0, except the Nyquist term.
    share = np.fft.rfft(displacement) / count
    share[1:] *= 2
    share[-1] /= 2

    def at(place: float, order: int) -> float:
        return float((share * powers**order * np.exp(powers * place)).real.sum())

    extrema = []
    for start, sign in ((int(displacement.argmin()), 1.0), (int(displacement.argmax()), -1.0)):
        place = start / count
        for _ in range(30):
            bend = at(place, 2)
            step = -at(place, 1) / bend if bend * sign > 0 else 0.0
            place += float(np.clip(step, -0.5 / count, 0.5 / count))
            if abs(step) < 1e-12:
                break
        # Newton's method on D′ = 0 may end in rounding errors; a sample can be as good.
        best = min(
            (at(place, 0), place),
            (float(displacement[start]), start / count),
            key=lambda b: sign * b[0],
        )
        extrema.append(best)
    (least, low), (greatest, high) = extrema
    return Displacement(least, greatest, (low % 1.0, high % 1.0), noise, float(displacement.mean()))


@arguments_checked
def locked_interval(
    maps: CircleMaps,
    fraction: Fraction,
    bracket: tuple[float, float],
    accuracy: float = ACCURACY,
) -> Plateau:
    """The step of a staircase at a given fraction.

    Parameters
    ----------
    maps : CircleMaps
    fraction : Fraction
        p/q: p turns in q steps.
    bracket : pair of float
        Parameter values on both sides of the step.
    accuracy : float
        The error of one step of the map, turns.

    Returns
    -------
    Plateau
        The edges of the step in the parameter, with their errors.

    Raises
    ------
    InputError
        If the rotation number does not pass the fraction between these values.
    """
    from scipy.optimize import brentq

    low, high = sorted(bracket)
    ends = [displacement(maps, value, fraction, accuracy) for value in (low, high)]
    rising = ends[1].least > 0 > ends[0].greatest
    if not (rising or ends[0].least > 0 > ends[1].greatest):
        raise InputError(
            f"bracket: the rotation number does not pass {fraction} between {low:g} and {high:g}, "
            "or one of them lies on its step"
        )

    def edge(name: str) -> float:
        end: float = brentq(
            lambda value: getattr(displacement(maps, value, fraction, accuracy), name),
            low,
            high,
            xtol=1e-15 * max(abs(low), abs(high)),
            rtol=4 * np.finfo(float).eps,
        )
        return end

    names = ("greatest", "least") if rising else ("least", "greatest")
    edges = edge(names[0]), edge(names[1])
    middle = displacement(maps, sum(edges) / 2, fraction, accuracy)
    slope = _slope(maps, fraction, edges, (low, high))
    spacing = float(np.spacing(max(abs(low), abs(high))))
    return Plateau(fraction, *edges, middle.noise / abs(slope) + spacing, slope, middle)


def _slope(
    maps: CircleMaps, fraction: Fraction, edges: tuple[float, float], bracket: tuple[float, float]
) -> float:
    """The derivative of the mean displacement by the parameter, across a plateau."""
    reach = max(1e-4 * (bracket[1] - bracket[0]), edges[1] - edges[0])
    sides = [edges[0] - reach, edges[1] + reach]
    means = [displacement(maps, value, fraction).mean for value in sides]
    return (means[1] - means[0]) / (sides[1] - sides[0])


def plateaus(
    maps: CircleMaps, stairs: DevilsStaircase, max_period: int, turns: Iterable[int] = ()
) -> list[Plateau]:
    """The plateaus of a devil's staircase with denominators up to a given one.

    Parameters
    ----------
    maps : CircleMaps
    stairs : DevilsStaircase
        Fine enough to be monotone between the values around each step.
    max_period : int
        The largest denominator.
    turns : iterable of int
        Numerators to search; all by default.
    """
    wanted = set(turns)
    finite = stairs.rotations[np.isfinite(stairs.rotations)]
    if not len(finite):
        raise InputError("stairs: no rotation number is known")
    lowest, highest = float(finite.min()), float(finite.max())
    plateaux = []
    for q in range(1, max_period + 1):
        for p in range(int(np.ceil(lowest * q)), int(np.floor(highest * q)) + 1):
            if gcd(p, q) == 1 and (not wanted or p in wanted):
                plateaux.extend(_plateaus_of(maps, stairs, Fraction(p, q)))
    return sorted(plateaux, key=lambda step: step.low)


def _plateaus_of(maps: CircleMaps, stairs: DevilsStaircase, fraction: Fraction) -> list[Plateau]:
    """The plateaus of a fraction, one for each crossing of the staircase."""
    known = np.flatnonzero(np.isfinite(stairs.rotations))
    values, excess = stairs.values[known], stairs.rotations[known] - float(fraction)
    # An orbit near a fixed point has a poor average.
    unsure = np.abs(excess) <= np.maximum(1e-9, 4 * stairs.errors[known])
    clear = np.flatnonzero(~unsure)
    plateaux = []
    for i, j in pairwise(clear):
        if excess[i] * excess[j] < 0:
            low, high = _outwards(maps, values, (int(i), int(j)), fraction)
            if low >= 0 and high < len(values):
                plateaux.append(locked_interval(maps, fraction, (values[low], values[high])))
    return plateaux


def _outwards(
    maps: CircleMaps, values: FloatArray, ends: tuple[int, int], fraction: Fraction
) -> tuple[int, int]:
    """The nearest parameters on both sides at which the displacement has no zero."""

    def passes(index: int) -> bool:
        if not 0 <= index < len(values):
            return True
        moved = displacement(maps, values[index], fraction)
        return moved.least > 0 or moved.greatest < 0

    low, high = ends
    while not passes(low):
        low -= 1
    while not passes(high):
        high += 1
    return low, high
