"""Strips of complex phases to which functions on a torus continue analytically, with bounds.

A function f analytic for |Im v_j| ≤ r_j is, by the maximum principle, at most as large there as on
the four tori Im v = (±r₁, ±r₂), and so its Fourier coefficients on (R/pZ)² obey
|f_k| ≤ M exp(−2π(r₁|k₁| + r₂|k₂|)/p).  For real f two of the four tori suffice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from flint import arb, ctx

from flowlanes.errors import InputError

from ..genus_two.torus import InvariantTorus
from .affine import Affine
from .branch_formula import Branch, direction
from .theta import Line, Numerators

#: Bits of the theta series that are converted to doubles.
BITS = 64
#: Numbers of boxes tried in each direction, for the period 1, and the maximum for both directions
#: together, which bounds memory use.
_BOXES, _MOST = (64, 128, 256), 256**2
#: Half-widths between which the strip is searched.
_WIDEST, _NARROWEST = 0.6, 0.001
#: The strip is first searched on a sample: one box in this many in each direction.
_STRIDE = 4
_CLOSE = "start: too close to a separatrix for error bounds"


@dataclass(frozen=True)
class Strip:
    """A strip of complex phases on which formulas are analytic.

    Attributes
    ----------
    half : (float, float)
        r₁, r₂.
    bounds : tuple of float
        M for each formula.
    sizes : tuple of float
        The largest value of each on the real torus, or so; 1 for one that vanishes.
    """

    half: tuple[float, float]
    bounds: tuple[float, ...]
    sizes: tuple[float, ...]


def lines_of(counts: Sequence[int], periods: Sequence[int]) -> tuple[Line, Line]:
    """The given number of equidistant points over the periods of the two phases."""
    one, two = (Line(arb(0), arb(period) / n, n) for n, period in zip(counts, periods, strict=True))
    return one, two


def _values(
    torus: InvariantTorus,
    branch: Branch,
    heights: Sequence[float],
    periods: Sequence[int],
    boxes: int,
    stride: int = 1,
) -> list[Affine]:
    """The formulas on boxes that cover the torus Im v = heights, or on a sample of them."""
    counts = [boxes * period // stride for period in periods]
    half = 0.5 / boxes
    with np.errstate(all="ignore"):
        N, rate = Numerators(torus, heights).boxes(lines_of(counts, periods), (half, half))
        return branch.values_on_boxes(*direction(N, rate))


def _bounds(
    torus: InvariantTorus, branch: Branch, half: Sequence[float], periods: Sequence[int], boxes: int
) -> tuple[float, ...]:
    """Upper bounds of the moduli on the strip; infinite or NaN where none is proven."""
    tori = [
        _values(torus, branch, heights, periods, boxes) for heights in (half, (half[0], -half[1]))
    ]
    # Unlike max, maximum propagates NaN.
    return tuple(
        float(np.maximum(one.size.max(), two.size.max())) for one, two in zip(*tori, strict=True)
    )


def _exist(
    torus: InvariantTorus,
    branch: Branch,
    half: Sequence[float],
    periods: Sequence[int],
    boxes: int,
    stride: int = 1,
) -> bool:
    """Whether the formulas certainly exist on all boxes, or on a sample of them."""
    return all(
        bool(np.all(np.isfinite(value.size)))
        for heights in (half, (half[0], -half[1]))
        for value in _values(torus, branch, heights, periods, boxes, stride)
    )


def _sizes(periods: Sequence[int]) -> list[int]:
    return [n for n in _BOXES if n**2 * periods[0] * periods[1] <= _MOST]


def strip_bound(torus: InvariantTorus, branch: Branch, periods: Sequence[int]) -> Strip:
    """A strip on which formulas are proven analytic, nearly as wide as possible.

    It is searched on a sample of the boxes and proven on all of them; if that fails it is searched
    on all.

    Parameters
    ----------
    branch : Branch
        Its signs learned.
    periods : two of 1, 2
        Periods of the moduli of the formulas in the two phases.

    Raises
    ------
    InputError
        If there is none of reasonable width: the motion is next to a separatrix.
    """
    with ctx.workprec(BITS):
        narrow = (_NARROWEST, _NARROWEST)
        boxes = next((n for n in _sizes(periods) if _exist(torus, branch, narrow, periods, n)), 0)
        if boxes == 0:
            raise InputError(_CLOSE)
        for stride in (_STRIDE, 1):
            half = _widths(torus, branch, periods, boxes, stride)
            bounds = _bounds(torus, branch, half, periods, boxes)
            if np.all(np.isfinite(bounds)):
                break
        real = _values(torus, branch, (0.0, 0.0), periods, boxes)
        sizes = (float(np.abs(value.middle).max()) for value in real)
        return Strip(half, bounds, tuple(size or 1.0 for size in sizes))


def _widths(
    torus: InvariantTorus, branch: Branch, periods: Sequence[int], boxes: int, stride: int
) -> tuple[float, float]:
    """Half-widths that the boxes, or a sample of them, allow, nearly as large as possible."""

    def exist(half: tuple[float, float]) -> bool:
        return _exist(torus, branch, half, periods, boxes, stride)

    low, high = _NARROWEST, _WIDEST
    while high / low > 1.1:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if exist((middle, middle)) else (low, middle)
    half = (low, low)
    for stretch in (1.6, 1.6, 1.25, 1.25):
        for wider in ((half[0] * stretch, half[1]), (half[0], half[1] * stretch)):
            half = wider if max(wider) < _WIDEST and exist(wider) else half
    return half


def least(torus: InvariantTorus, branch: Branch, periods: Sequence[int]) -> float:
    """A lower bound of formulas that are positive on the real torus.

    Raises
    ------
    InputError
        If the boxes prove none above zero: the motion is next to a separatrix.
    """
    with ctx.workprec(BITS):
        for boxes in _sizes(periods):
            values = _values(torus, branch, (0.0, 0.0), periods, boxes)
            bound = min(
                float((value.middle.real - value.deviation_bound).min()) for value in values
            )
            if bound > 0:
                return bound
    raise InputError(_CLOSE)
