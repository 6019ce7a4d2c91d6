"""Checks of starts and times before an integration."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt

from ..errors import InputError
from ..formulas.array_evaluation import as_float_array, numbers
from ..formulas.graph import Term
from ..system.arrays import FloatArray
from ..system.system import System

#: Allowed residual of a relation at a start, relative to the terms of the relation, and absolute.
SLACK, LEAST = 1e-9, 1e-13

#: Number of starts examined at a time.
ROWS = 2048

#: Numbers within this many powers of ten of one are not regarded as too large or too small.
_USUAL_POWERS = 10


def moments(times: npt.ArrayLike, backward: bool = False) -> FloatArray:
    """Sampling times, counted from 0 in the direction of the motion.

    Raises
    ------
    InputError
        If there are no times, or they do not continue from 0 in that direction.
    """
    row = np.atleast_1d(as_float_array("times", times))
    if row.ndim != 1 or not row.size or not np.all(np.isfinite(row)):
        raise InputError("times: there must be a row of at least one, and all finite numbers")
    ahead = -row if backward else row
    if ahead[0] < 0 or np.any(np.diff(ahead) <= 0):
        way = "decrease from 0" if backward else "increase from 0"
        raise InputError(f"times: they must {way}, where the motion begins")
    return np.ascontiguousarray(ahead)


def check_state_shape(system: System, points: FloatArray) -> None:
    """Raise an error for starts that are not rows with one state each."""
    size = len(system.symbols)
    if points.ndim != 2 or points.shape[1] != size:
        names = ", ".join(map(str, system.symbols))
        raise InputError(
            f"{system.name}: starts have the shape {points.shape}; (motions, {size}) is needed, "
            f"in the order {names}"
        )


def require_on_phase_space(
    system: System, relations: Sequence[Term], points: FloatArray, parameters: FloatArray
) -> None:
    """Raise an error for starts that violate a relation of the system.

    Parameters
    ----------
    system : System
    relations : sequence of Term
        See :func:`flowlanes.formulas.array_evaluation.relation_terms`.
    points : array (motions, size)
    parameters : array (1 or motions, parameters)
    """
    if not relations or not len(points):
        return

    def excess(rows: slice) -> tuple[FloatArray, FloatArray]:
        """Residuals of the relations, and their ratios to the allowed ones."""
        varied = parameters[rows] if len(parameters) > 1 else parameters
        missed, sizes = np.split(np.abs(numbers(relations, points[rows], varied)), 2, axis=1)
        return missed, missed / (SLACK * sizes + LEAST)

    # In parts, so that intermediate results stay in the cache of the processor.
    parts = (slice(first, first + ROWS) for first in range(0, len(points), ROWS))
    # NaN is not within the bounds.
    if all((excess(rows)[1] <= 1).all() for rows in parts):
        return
    missed, ratios = excess(slice(None))
    worst = np.unravel_index(np.argmax(np.nan_to_num(ratios, nan=np.inf)), ratios.shape)
    for symbol, number in zip(system.symbols, points[worst[0]], strict=True):
        if not np.isfinite(number):
            raise InputError(
                f"{system.name}: start {worst[0]} has {symbol} = {number:g}, which must be finite"
            )
    raise InputError(
        f"{system.name}: start {worst[0]} misses the phase space; "
        f"{system.relations[worst[1]]} is {missed[worst]:.3g} there and must vanish"
    )


def overflow_reason(
    names: Sequence[str], numbers: Sequence[float], finite: Callable[[Sequence[float]], bool]
) -> str:
    """Name the numbers whose sizes make a value infinite or undefined, in one sentence.

    Parameters
    ----------
    names : sequence of str
    numbers : sequence of float
    finite : callable
        Function that is True if the value is finite with given numbers.

    Returns
    -------
    str
        Sentence with the smallest sufficient set of names; empty if the sizes of the numbers are
        not the reason.
    """
    with np.errstate(all="ignore"):
        blamed = too_extreme(numbers, finite)
    if not blamed:
        return ""
    listed = ", ".join(f"{names[i]} = {numbers[i]:g}" for i in blamed)
    verb = "is" if len(blamed) == 1 else "are"
    return f"{listed} {verb} too far from 1 to compute with: choose other units or numbers"


def too_extreme(numbers: Sequence[float], finite: Callable[[Sequence[float]], bool]) -> list[int]:
    """Indices of the numbers whose sizes make a value infinite or undefined.

    The smallest sufficient set; empty if the sizes of the numbers are not the reason.
    """
    sizes = {i: abs(math.log10(abs(x))) for i, x in enumerate(numbers) if x}
    blamed = [i for i in sorted(sizes, key=sizes.__getitem__) if sizes[i] > _USUAL_POWERS]

    def finite_without(indices: Sequence[int]) -> bool:
        return finite([math.copysign(1.0, x) if i in indices else x for i, x in enumerate(numbers)])

    if not blamed or not finite_without(blamed):
        return []
    for index in tuple(blamed):
        fewer = [i for i in blamed if i != index]
        if finite_without(fewer):
            blamed = fewer
    return sorted(blamed)
