"""How far functions on a torus continue to complex phases, and how large they are there.

A function f analytic for |Im v_j| ≤ r_j is, by the maximum principle, at most as large there as on
the four tori Im v = (±r₁, ±r₂), and so its Fourier coefficients on (R/pZ)² obey
|f_k| ≤ M exp(−2π(r₁|k₁| + r₂|k₂|)/p).  For real f two of the four tori suffice.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb, ctx

from ..errors import InputError
from .rigorous_affine import Affine
from .rigorous_formula import Branch, LeavesBranchError, direction
from .rigorous_theta import Line, Numerators, complex_numerators
from .torus import Torus

__all__ = ["Strip", "least", "lines_of", "strip_bound"]

#: Bits for bounds.
BITS = 64
#: Boxes in each direction: at first, at most, and the points of a trial.
_COARSE, _FINE, _TRIAL = 24, 96, 24
#: Half-widths between which the strip is looked for.
_WIDEST, _NARROWEST = 0.6, 0.004
#: By how much a strip that looked right is made narrower, for a bound with some room.
_ROOM = 0.85


@dataclass(frozen=True)
class Strip:
    """Where formulas are analytic.

    Attributes
    ----------
    half : (float, float)
        r₁, r₂.
    bounds : tuple of arb
        M for each formula.
    """

    half: tuple[float, float]
    bounds: tuple[Any, ...]


def lines_of(count: Sequence[int], period: int) -> tuple[Line, Line]:
    """`count` equidistant points over the period in both directions."""
    one, two = (Line(arb(0), arb(period) / n, n) for n in count)
    return one, two


def _sizes(
    torus: Torus,
    branch: Branch,
    heights: Sequence[Any],
    period: int,
    accepted: Callable[[Affine], bool],
) -> Iterator[tuple[Any, ...]]:
    """Enclosures of the formulas on boxes that cover the torus Im v = heights.

    Boxes on which a formula may leave its branch, or is not accepted, are divided.

    Raises
    ------
    LeavesBranchError
        If even the smallest do not help.
    """
    numerators = Numerators(torus, heights)
    count = _COARSE * period
    wanted: set[tuple[int, int]] | None = None
    while True:
        half = arb(period) / (2 * count)
        failed = set()
        boxes = numerators.boxes(lines_of((count, count), period), (half, half))
        for place, (N, rate) in enumerate(boxes):
            cell = divmod(place, count)
            if wanted is None or cell in wanted:
                try:
                    values = branch.continued(*direction(N, rate))
                except LeavesBranchError:
                    failed.add(cell)
                    continue
                if all(map(accepted, values)):
                    yield tuple(values)
                else:
                    failed.add(cell)
        if not failed:
            return
        if count == _FINE * period:
            raise LeavesBranchError
        # boxes of the next grid that meet one that failed; its boxes are centred on their points
        count *= 2
        wanted = {
            ((2 * j + a) % count, (2 * k + b) % count)
            for j, k in failed
            for a in (-1, 0, 1)
            for b in (-1, 0, 1)
        }


def _moderate(value: Affine) -> bool:
    """Whether a box adds little to the bound."""
    return bool(value.spread < 10 + 3 * abs(value.middle))


def _positive(value: Affine) -> bool:
    """Whether a real function is positive on a box, and known to a factor."""
    return bool(value.middle.real > 2 * value.spread)


def _bounds(torus: Torus, branch: Branch, half: Sequence[float], period: int) -> tuple[Any, ...]:
    largest: list[Any] = []
    for heights in (half, (half[0], -half[1])):
        for values in _sizes(torus, branch, heights, period, _moderate):
            sizes = [value.size for value in values]
            largest = [max(pair) for pair in zip(largest or sizes, sizes, strict=True)]
    if not all(size.is_finite() for size in largest):
        raise LeavesBranchError
    return tuple(largest)


def _promising(torus: Torus, branch: Branch, half: Sequence[float], period: int) -> bool:
    """Whether the formulas keep well to their branch at some points of the tori: a quick trial."""
    line = np.arange(_TRIAL * period) / _TRIAL
    x = np.array(np.meshgrid(line, line)).reshape(2, -1)
    try:
        for heights in (half, (half[0], -half[1])):
            v = x + 1j * np.array(heights)[:, None]
            branch.continued(*direction(*complex_numerators(torus, v)))
    except LeavesBranchError:
        return False
    return True


def strip_bound(torus: Torus, branch: Branch, period: int) -> Strip:
    """A strip on which formulas are proven analytic, nearly as wide as it can be.

    Parameters
    ----------
    torus : Torus
    branch : Branch
        Its signs learned.
    period : int
        Of the formulas in both phases: 1 or 2.

    Raises
    ------
    InputError
        If there is none of reasonable width: the motion is next to a separatrix.
    """
    with ctx.workprec(BITS):
        low, high = _NARROWEST, _WIDEST
        while high / low > 1.1:
            middle = (low * high) ** 0.5
            if _promising(torus, branch, (middle, middle), period):
                low = middle
            else:
                high = middle
        half = (low, low)
        for stretch in (1.3,) * 4:
            for wider in ((half[0] * stretch, half[1]), (half[0], half[1] * stretch)):
                if _promising(torus, branch, wider, period):
                    half = wider
        while min(half) > _NARROWEST / 2:
            half = (half[0] * _ROOM, half[1] * _ROOM)
            try:
                return Strip(half, _bounds(torus, branch, half, period))
            except LeavesBranchError:
                continue
    raise InputError("start: too close to a separatrix for error bounds")


def least(torus: Torus, branch: Branch, period: int) -> Any:
    """A positive lower bound of formulas that are positive on the real torus (arb).

    Raises
    ------
    LeavesBranchError
        If no box proves it.
    """
    with ctx.workprec(BITS):
        bounds = []
        for values in _sizes(torus, branch, (arb(0), arb(0)), period, _positive):
            bounds += [(value.middle.real - value.spread).lower() for value in values]
        return min(bounds)
