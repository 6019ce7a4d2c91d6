"""Integrals of analytic functions along the real line, with proven error bounds.

The line is cut into panels.  On each, a function is interpolated at n + 1 Chebyshev points; if it
is analytic and smaller than M in a rectangle around the ellipse with the ends of the panel as foci
and with half-axes (ρ ± 1/ρ)/2 half-widths, the interpolant is wrong by 4Mρ⁻ⁿ/(ρ − 1) at most.  A
panel on which no such M is found, or one too large, is halved: near a singularity panels shrink
geometrically, so that almost singular integrals cost little more than others.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from flint import acb, arb, arb_mat, ctx

from ..errors import InputError

__all__ = ["Integrals", "Panel", "Table", "integrals", "working_bits"]

#: ρ of the ellipse, and its half-axes.
RHO = 4
ALONG, ACROSS = arb("2.125"), arb("1.875")

#: A panel may not become narrower than this.
NARROWEST = 1e-60

#: σ ↦ the functions to be integrated, complex balls to complex balls.
Rates = Callable[[Any], Sequence[Any]]
#: (σ, the integrals of the first functions) ↦ further functions.
Nested = Callable[[Any, Sequence[Any]], Sequence[Any]]


def degree(digits: int) -> int:
    """n for an accuracy of so many digits, with a reserve of eight factors ρ."""
    return math.ceil(digits * math.log(10) / math.log(RHO)) + 8


def working_bits(digits: int) -> int:
    """Bits to compute with: summing a Chebyshev series in balls costs up to 1.3 bits a term."""
    return math.ceil(digits * math.log2(10) + 1.3 * degree(digits)) + 64


@lru_cache(maxsize=16)
def _transform(n: int, bits: int) -> tuple[tuple[Any, ...], Any]:
    """The Chebyshev points, and the matrix from values there to coefficients."""
    with ctx.workprec(bits):
        angles = [arb(2 * j + 1) / (2 * n + 2) for j in range(n + 1)]
        rows = [
            [(k * angle).cos_pi() * (2 if k else 1) / (n + 1) for angle in angles]
            for k in range(n + 1)
        ]
        return tuple(angle.cos_pi() for angle in angles), arb_mat(rows)


@dataclass(frozen=True)
class Panel:
    """One interval with the integrals of all functions over it.

    Attributes
    ----------
    low, high : flint.arb
        Exact.
    series : tuple of lists of arb
        Chebyshev coefficients of every integral, the error bound in the first of them.
    first : list of arb
        Chebyshev coefficients of the first function itself.
    bounds : tuple of arb
        Of the functions around the panel.
    """

    low: Any
    high: Any
    series: tuple[list[Any], ...]
    first: list[Any]
    bounds: tuple[Any, ...]

    def value(self, index: int, place: Any) -> Any:
        """An integral at a place of the panel (arb), given as a ball."""
        nearest = place.mid().max(self.low).min(self.high).mid()
        x = (2 * nearest - self.low - self.high) / (self.high - self.low)
        error = self.bounds[index] * abs(place - nearest)
        return _clenshaw(self.series[index], x) + arb(0, error.upper())


def _clenshaw(series: Sequence[Any], x: Any) -> Any:
    first = second = arb(0)
    for coefficient in reversed(series[1:]):
        first, second = 2 * x * first - second + coefficient, first
    return x * first - second + series[0]


@dataclass(frozen=True)
class Integrals:
    """Integrals from zero of some functions along an interval that contains zero.

    Attributes
    ----------
    panels : tuple of Panel
        From left to right.
    """

    panels: tuple[Panel, ...]

    def value(self, index: int, place: Any) -> Any:
        """An integral from 0 to `place`, a small ball inside the interval."""
        middle = place.mid()
        inside = (p for p in self.panels if p.low <= middle and middle <= p.high)
        panel = next(inside, self.panels[0 if middle < 0 else -1])
        return panel.value(index, place)

    def end(self, index: int) -> Any:
        """The integral up to the right end."""
        return self.panels[-1].value(index, self.panels[-1].high)

    def table(self) -> Table:
        """The same in double precision."""
        return Table(self)


def integrals(
    rates: Rates, low: Any, high: Any, digits: int, nested: Nested | None = None
) -> Integrals:
    """Integrals from zero along [low, high].

    Parameters
    ----------
    rates : callable
        Functions, analytic near the interval and real on it.
    low, high : arb
        With low ≤ 0 < high; their middles are taken.
    digits : int
        The error bound is 10^−digits relative to each function on each panel, or absolute where
        functions are smaller than one.
    nested : callable, optional
        Further functions, of σ and the integrals of the first ones.

    Raises
    ------
    InputError
        If a function is singular on the interval.
    """
    build = _Build(rates, nested, digits)
    right = build.side(arb(0), high.mid())
    left = build.side(arb(0), low.mid()) if low < 0 else []
    return Integrals((*reversed(left), *right))


@dataclass(frozen=True)
class _Build:
    rates: Rates
    nested: Nested | None
    digits: int

    def side(self, start: Any, end: Any) -> list[Panel]:
        """Panels from `start` outwards, to the right or to the left."""
        pieces = max(1, math.ceil(abs(float(end - start))))
        stops = [start + (end - start) * k / pieces for k in range(1, pieces)]
        waiting = [end, *(stop.mid() for stop in reversed(stops))]
        made: list[Panel] = []
        totals: Sequence[Any] = ()
        while waiting:
            stop = waiting[-1]
            panel = self._panel(start, stop, totals)
            if panel is None:
                if abs(stop - start) < NARROWEST:
                    raise InputError("a quadrature of this motion is singular on its way")
                waiting.append(((start + stop) / 2).mid())
                continue
            made.append(panel)
            start = waiting.pop()
            totals = [_clenshaw(s, arb(1 if start == panel.high else -1)) for s in panel.series]
        return made

    def _panel(self, start: Any, stop: Any, totals: Sequence[Any]) -> Panel | None:
        low, high = (start, stop) if start < stop else (stop, start)
        half, centre = (high - low) / 2, (high + low) / 2
        box = acb(arb(centre, ALONG * half), arb(0, ACROSS * half))
        bounds = self._bounds(self.rates(box), self.rates(acb(centre)))
        if bounds is None:
            return None
        nodes, matrix = _transform(degree(self.digits), ctx.prec)
        places = [centre + half * node for node in nodes]
        known = matrix * arb_mat([[f.real for f in self.rates(acb(p))] for p in places])
        series = _integrated(known, bounds, half, start == low, totals)
        if self.nested is not None:
            around = [_around(s, m, half) for s, m in zip(series, bounds, strict=True)]
            middle = [acb(_clenshaw(s, arb(0))) for s in series]
            further = self._bounds(self.nested(box, around), self.nested(acb(centre), middle))
            if further is None:
                return None
            rows = [
                [f.real for f in self.nested(acb(p), [acb(_clenshaw(s, x)) for s in series])]
                for p, x in zip(places, nodes, strict=True)
            ]
            rest = totals[len(series) :]
            series += _integrated(matrix * arb_mat(rows), further, half, start == low, rest)
            bounds = [*bounds, *further]
        first = [known[k, 0] for k in range(known.nrows())]
        return Panel(low, high, tuple(series), first, tuple(bounds))

    def _bounds(self, around: Sequence[Any], middle: Sequence[Any]) -> list[Any] | None:
        """Bounds of functions in the rectangle, if they are not too large."""
        if not all(f.is_finite() for f in around):
            return None
        bounds = [arb(f.abs_upper()) for f in around]
        sizes = [max(1.0, float(f.abs_upper())) for f in middle]
        small = all(float(m) < 10 * RHO**6 * s for m, s in zip(bounds, sizes, strict=True))
        return bounds if small else None


def _around(series: Sequence[Any], bound: Any, half: Any) -> Any:
    """An integral in the rectangle."""
    across = ACROSS * half * bound
    along = (ALONG + ACROSS) * half * bound
    return acb(_clenshaw(series, arb(0)) + arb(0, along), arb(0, across))


def _integrated(
    known: Any, bounds: Sequence[Any], half: Any, from_left: bool, totals: Sequence[Any]
) -> list[list[Any]]:
    """Chebyshev series of the integrals that continue `totals`, from the functions' own."""
    n = known.nrows() - 1
    made = []
    for index, bound in enumerate(bounds):
        c = [known[k, index] for k in range(n + 1)] + [arb(0), arb(0)]
        series = [arb(0), half * (c[0] - c[2] / 2)]
        series += [half * (c[k - 1] - c[k + 1]) / (2 * k) for k in range(2, n + 2)]
        error = 4 * bound / arb(RHO) ** n / (RHO - 1) * 2 * half
        begin = _clenshaw(series, arb(-1 if from_left else 1))
        series[0] = (totals[index] if totals else 0) - begin + arb(0, error)
        made.append(series)
    return made


class Table:
    """Integrals in double precision, for many places at once.

    Attributes
    ----------
    breaks : array (panels + 1,)
    """

    def __init__(self, exact: Integrals) -> None:
        panels = exact.panels
        self.breaks = np.array([float(p.low) for p in panels] + [float(panels[-1].high)])
        self._series = np.array(
            [[[float(c.mid()) for c in s] for s in p.series] for p in panels]
        ).transpose(1, 2, 0)
        self._first = np.array([[float(c.mid()) for c in p.first] for p in panels]).T
        self._half = np.diff(self.breaks) / 2

    def locate(self, places: Any) -> tuple[Any, Any]:
        """The panel of every place, and where in it, from −1 to 1."""
        panel = np.clip(np.searchsorted(self.breaks, places) - 1, 0, len(self._half) - 1)
        return panel, (places - self.breaks[panel]) / self._half[panel] - 1

    def value(self, index: int, places: Any) -> Any:
        """An integral at places (n,)."""
        panel, x = self.locate(places)
        return np.polynomial.chebyshev.chebval(x, self._series[index][:, panel], tensor=False)

    def rate(self, places: Any) -> Any:
        """The first function at places (n,)."""
        panel, x = self.locate(places)
        return np.polynomial.chebyshev.chebval(x, self._first[:, panel], tensor=False)
