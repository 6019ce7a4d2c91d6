"""Rotation numbers to ten or more digits, and detection of phase locking.

The mean advance of an angle converges like 1/N. Weighted with exp(−1/(t(1−t))) along the orbit, it
converges faster than every power of 1/N if the motion is quasi-periodic and smooth (Das, Saiki,
Sander, Yorke 2017). On an orbit that approaches a limit cycle, the initial part far from the cycle
has almost no weight.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from ..arguments import arguments_checked
from ..errors import InputError
from ..system.arrays import FloatArray

#: Initial number of points for a rotation number.
FIRST = 256
#: Minimum number of rounds of a period before an orbit may be called locked or closed.
ROUNDS = 8
#: Differences below this are attributed to rounding.
ROUNDING = 1e-11
#: Multiple of the rounding level above which the noise of differences is negligible.
CLEAR = 1e5
#: Approach factors above this cannot be distinguished from one.
SLOW = 0.999


@dataclass(frozen=True)
class Rotation:
    """A rotation number and the kind of motion.

    Attributes
    ----------
    value : float
        Turns per step.
    error : float
        The difference of the values over the two halves of the orbit, at least the rounding error.
    verdict : str
        ``"locked"``: the orbit approaches a cycle with the rotation number `fraction`
        geometrically; ``"closed"``: it is a cycle from the start, so that no approach can be
        observed; ``"quasi-periodic"``: the average has converged and no cycle of up to
        `max_period` steps is met or crossed; ``"undecided"``. All are observations.
    fraction : Fraction or None
        Turns per number of steps of the cycle.
    approach : float or None
        The factor by which the distance to the cycle decreases in each round, if locked.
    max_period : int
        The longest cycle considered.
    points : int
        Number of steps of the orbit.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> turn = flowlanes.rotation_number(lambda count: (5**0.5 - 1) / 2 * np.arange(count + 1))
    >>> turn.verdict, round(turn.value, 6)
    ('quasi-periodic', 0.618034)
    """

    value: float
    error: float
    verdict: str
    fraction: Fraction | None
    approach: float | None
    max_period: int
    points: int


def average(values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The weighted mean of values along the last axis, and an estimate of its error.

    Parameters
    ----------
    values : array (..., n)
        Values of a function along an orbit at equal time steps; n ≥ 8.

    Returns
    -------
    mean, error : arrays (...)
        The error is the difference between the means of the two halves, but at least the rounding
        error; the mean of the whole is closer to the limit than either.
    """
    count = values.shape[-1]
    if count < 8:
        raise InputError(f"values: an average needs 8 at least, and there are {count}")
    mean = values @ _weights(count)
    half = count // 2
    halves = (values[..., :half] @ _weights(half), values[..., -half:] @ _weights(half))
    rounding = 4 * np.finfo(float).eps * np.maximum(np.abs(values).max(axis=-1), np.abs(mean))
    return mean, np.maximum(np.abs(halves[0] - halves[1]), rounding)


def _weights(count: int) -> FloatArray:
    place = (np.arange(count) + 0.5) / count
    weight = np.exp(-1 / (place * (1 - place)))
    weights: FloatArray = weight / weight.sum()
    return weights


def unwrapped_turns(angles: FloatArray, period: float = 2 * np.pi) -> FloatArray:
    """Continuous turns of an angle on a section, from its values modulo a period.

    The advance per step is a continuous function on the circle that omits a part of it; its branch
    is cut in the middle of the largest gap. The integer part of the advance cannot be observed on
    a section: rotation numbers of different lifts differ by integers.

    Parameters
    ----------
    angles : array (n,)
    period : float

    Returns
    -------
    array (n,)
        Turns, for the lift whose mean advance is nearest to zero.

    Raises
    ------
    InputError
        If the advance covers the circle so densely that there is no gap.
    """
    turns = np.asarray(angles, dtype=float) / period
    advance = np.diff(turns) % 1.0
    order = np.sort(advance)
    gaps = np.diff(np.append(order, order[0] + 1))
    widest = int(gaps.argmax())
    others = np.delete(gaps, widest)
    if gaps[widest] < 0.02 or (len(others) and gaps[widest] < 2 * others.max()):
        raise InputError(
            "angles: the advance in one step covers the whole circle, so that the angle has no "
            "lift; take another angle or section"
        )
    cut = order[(widest + 1) % len(order)] - gaps[widest] / 2
    advance = (advance - cut) % 1.0 + cut
    advance -= round(float(advance.mean()))
    return np.concatenate([[turns[0] % 1.0], turns[0] % 1.0 + np.cumsum(advance)])


def frequency(turns: FloatArray, times: FloatArray) -> tuple[float, float]:
    """The frequency of an angle of a flow (turns per unit of time), and its error.

    Parameters
    ----------
    turns : array (n,)
        Turns of an angle at times so dense that it makes less than half a turn between them; only
        the fractional parts matter.
    times : array (n,)
        Equidistant times.

    Raises
    ------
    InputError
        If the times are not equidistant or the angle jumps.
    """
    steps = np.diff(times)
    if not np.allclose(steps, steps.mean(), rtol=1e-9):
        raise InputError("times: they must be equidistant")
    # The nearest branch of the advance is the right one if it is less than half a turn.
    advance = (np.diff(turns) + 0.5) % 1.0 - 0.5
    if np.abs(advance).max() > 0.4:
        raise InputError("turns: the angle makes nearly half a turn between two times; take more")
    mean, error = average(advance / steps.mean())
    return float(mean), float(error)


def rotation(turns: FloatArray, tolerance: float = 1e-10, max_period: int = 64) -> Rotation:
    """The rotation number of an orbit and the kind of motion.

    Parameters
    ----------
    turns : array (n,)
        A lift of an angle along the orbit of a map, in turns.
    tolerance : float
        Error below which an average counts as converged.
    max_period : int
        The longest cycle considered.
    """
    value, error = (float(x) for x in average(np.diff(turns)))
    fraction = simplest(value - 4 * error - tolerance, value + 4 * error + tolerance)
    max_period = min(max_period, (len(turns) - 1) // ROUNDS)
    verdict, approach = "undecided", None
    if fraction.denominator <= max_period:
        verdict, approach = _windings_around(turns, fraction)
    elif error <= tolerance and _passes(turns, value, max_period):
        verdict = "quasi-periodic"
    near = fraction if verdict in ("locked", "closed") else None
    return Rotation(value, error, verdict, near, approach, max_period, len(turns) - 1)


def _windings_around(turns: FloatArray, fraction: Fraction) -> tuple[str, float | None]:
    """True if an orbit is or approaches a cycle, and the approach factor."""
    misses = np.abs(
        turns[fraction.denominator :] - turns[: -fraction.denominator] - fraction.numerator
    )
    noise = ROUNDING * max(1.0, float(np.abs(turns).max()) * 1e-3)
    # the largest deviation in each round of the cycle
    rounds = misses[: len(misses) // fraction.denominator * fraction.denominator]
    rounds = rounds.reshape(-1, fraction.denominator).max(axis=1)
    if rounds.max() < noise:
        return "closed", None
    seen = rounds[: int(np.argmax(rounds < noise))] if (rounds < noise).any() else rounds
    if len(seen) < 2:
        return "undecided", None
    # Near the cycle the approach is geometric; below the noise level nothing is visible.
    clear = seen[seen > CLEAR * noise] if (seen > CLEAR * noise).sum() >= 3 else seen
    arrives = bool(rounds[-1] < noise)
    rates = np.diff(np.log(clear))
    late = rates[-6:]
    approach = float(np.exp(late.mean()))
    # For an approach like 1/n the logarithmic rates decrease like 1/n.
    middle = rates[len(rates) // 2 :][:6]
    steady = np.abs(late - late.mean()).max() < 0.5 and middle.mean() > 1.3 * late.mean()
    falls = arrives or rounds[-1] < 0.5 * rounds[0]
    halved = arrives and rates.max() < np.log(0.5)
    if halved or (steady and falls and approach < SLOW):
        return "locked", approach
    return "undecided", None


def _passes(turns: FloatArray, value: float, max_period: int) -> bool:
    """True if an orbit neither meets nor crosses a cycle of up to `max_period` steps."""
    for steps in range(1, max_period + 1):
        misses = turns[steps:] - turns[:-steps] - round(value * steps)
        # The displacement over `steps` changes sign or vanishes on a cycle.
        if misses.min() <= ROUNDING and misses.max() >= -ROUNDING:
            return False
    return True


@arguments_checked
def rotation_number(
    orbit: Callable[[int], FloatArray],
    *,
    tolerance: float = 1e-10,
    max_period: int = 64,
    max_iterations: int = 1 << 17,
) -> Rotation:
    """The rotation number, with as many points as necessary.

    Parameters
    ----------
    orbit : callable
        From a number of steps n to a lift of an angle, in turns, shape (n + 1,).
    tolerance : float
        The required error.
    max_period : int
        The longest cycle considered.
    max_iterations : int
        Maximum number of steps.

    Returns
    -------
    Rotation
        The rotation number in turns per step, its error, and whether the motion is locked or
        quasi-periodic.

    Raises
    ------
    InputError
        If `orbit` returns a wrong number of values, or too few for an average.

    Examples
    --------
    >>> import flowlanes
    >>> import numpy as np
    >>> found = flowlanes.rotation_number(lambda n: 0.1 + (np.sqrt(5) - 1) / 2 * np.arange(n + 1))
    >>> print(found.verdict, round(found.value, 10))
    quasi-periodic 0.6180339887
    """
    count = min(FIRST, max_iterations)
    while True:
        turns = np.asarray(orbit(count))
        if turns.shape != (count + 1,) or turns.dtype.kind not in "iuf":
            raise InputError(
                f"orbit({count}): it must give {count + 1} numbers, the angle before each step "
                "and after the last"
            )
        number = rotation(turns, tolerance, max_period)
        settled = number.error <= tolerance and number.verdict != "undecided"
        if settled or 2 * count > max_iterations:
            return number
        count *= 2


def simplest(low: float, high: float) -> Fraction:
    """The fraction with the smallest denominator in a closed interval."""
    if low > high:
        raise InputError(f"low = {low} lies above high = {high}")
    return _simplest(Fraction(low), Fraction(high))


def _simplest(low: Fraction, high: Fraction) -> Fraction:
    whole = low.numerator // low.denominator
    if low == whole:
        return Fraction(whole)
    if whole + 1 <= high:
        return Fraction(whole + 1)
    # Continued fractions: subtract the integer part and invert, which reverses the interval.
    return whole + 1 / _simplest(1 / (high - whole), 1 / (low - whole))
