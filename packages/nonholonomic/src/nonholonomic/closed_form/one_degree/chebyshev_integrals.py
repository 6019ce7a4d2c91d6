"""Integrals of analytic functions along the real line, with proven error bounds.

The line is divided into panels.  On each, a function f is interpolated by p_n at n + 1 Chebyshev
points.  If f is analytic and |f| ≤ M in boxes that cover the Bernstein ellipse, which has its foci
at the ends of the panel and half-axes of (ρ ± 1/ρ)/2 half-widths, then

    |f − p_n| ≤ 4Mρ⁻ⁿ/(ρ − 1)    on the panel

(L. N. Trefethen, Approximation Theory and Approximation Practice, chapter 8).  Ball arithmetic
encloses f on the boxes, which gives M, and finite values prove that f is analytic there, since
roots take no value across a branch cut.  A panel with no M, or too large a one, is halved, so
near a singularity panels shrink geometrically.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from flint import acb, arb, arb_mat, ctx

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray, IntArray

#: ρ of the ellipse, and its half-axes (ρ ± 1/ρ)/2.
RHO = 4
ALONG, ACROSS = arb("2.125"), arb("1.875")

#: Boxes that cover the upper half of the ellipse (the functions are real on the real axis): middle
#: along the axis, half-width, height.
BOXES = tuple(
    (arb(sign * middle), arb(ALONG / 8), ACROSS * (1 - arb(start) ** 2).sqrt())
    for start, middle in (
        (0, ALONG / 8),
        (0.25, 3 * ALONG / 8),
        (0.5, 5 * ALONG / 8),
        (0.75, 7 * ALONG / 8),
    )
    for sign in (-1, 1)
)

#: Number of points of a panel at which its table stores the time.
KNOTS = 24

#: Indices of panels, and coordinates from −1 to 1 in them.
PanelPoints = tuple[IntArray, FloatArray]

#: Smallest width of a panel.
NARROWEST = 1e-25

#: Maps σ to the functions to be integrated, in complex balls.
Rates = Callable[[acb], Sequence[acb]]
#: Maps (σ, the first functions, their integrals) to further functions.
NestedRates = Callable[[acb, Sequence[acb], Sequence[acb]], Sequence[acb]]


def degree(digits: int) -> int:
    """n for an accuracy of `digits`, with a reserve of eight factors of ρ."""
    return math.ceil(digits * math.log(10) / math.log(RHO)) + 8


def working_bits(digits: int) -> int:
    """Working precision: summing a Chebyshev series in balls costs up to 1.3 bits per term."""
    return math.ceil(digits * math.log2(10) + 1.3 * degree(digits)) + 64


@lru_cache(maxsize=16)
def _transform(n: int, bits: int) -> tuple[tuple[arb, ...], arb_mat]:
    """The Chebyshev points, and the matrix from values there to coefficients."""
    with ctx.workprec(bits):
        angles = [arb(2 * j + 1) / (2 * n + 2) for j in range(n + 1)]
        rows = [
            [(k * angle).cos_pi() * (2 if k else 1) / (n + 1) for angle in angles]
            for k in range(n + 1)
        ]
        return tuple(angle.cos_pi() for angle in angles), arb_mat(rows)


@dataclass(frozen=True)
class Series:
    """A Chebyshev series on [−1, 1].

    The coefficients are exact, and their errors are collected in one number, which is valid since
    |T_k| ≤ 1.  So errors do not grow with the number of terms when the series is summed in balls.

    Attributes
    ----------
    coefficients : list of arb
    error : arb
    """

    coefficients: list[arb]
    error: arb

    @classmethod
    def from_balls(cls, coefficients: Sequence[arb], error: arb | int = 0) -> Series:
        """The series of coefficients with errors, and with an additional error of the sum."""
        radius = sum((c.rad() for c in coefficients), arb(error))
        return cls([c.mid() for c in coefficients], arb(radius.upper()))

    def __call__(self, x: arb) -> arb:
        """The sum at an exact number (Clenshaw)."""
        first = second = arb(0)
        for coefficient in reversed(self.coefficients[1:]):
            first, second = 2 * x * first - second + coefficient, first
        return x * first - second + self.coefficients[0] + arb(0, self.error)

    def reflection(self, sign: int) -> Series:
        """sign · f(−x)."""
        signed = [-sign * c if k % 2 else sign * c for k, c in enumerate(self.coefficients)]
        return Series(signed, self.error)


@dataclass(frozen=True)
class Panel:
    """One interval with the integrals of all functions over it.

    Attributes
    ----------
    low, high : flint.arb
        Exact.
    series : tuple of Series
        Of every integral.
    first : list of arb
        Chebyshev coefficients of the first function itself.
    bounds : tuple of arb
        Of the functions around the panel.
    """

    low: arb
    high: arb
    series: tuple[Series, ...]
    first: list[arb]
    bounds: tuple[arb, ...]

    def value(self, index: int, sigma: arb) -> arb:
        """An integral at a small ball of the panel."""
        nearest = sigma.mid().max(self.low).min(self.high).mid()
        x = (2 * nearest - self.low - self.high) / (self.high - self.low)
        error = self.bounds[index] * abs(sigma - nearest)
        return self.series[index](x) + arb(0, error.upper())

    def reflection(self, parities: Sequence[int]) -> Panel:
        """The panel on the other side of zero, for even (1) or odd (−1) integrals."""
        series = tuple(s.reflection(sign) for s, sign in zip(self.series, parities, strict=True))
        first = [-c if k % 2 else c for k, c in enumerate(self.first)]
        return Panel(-self.high, -self.low, series, first, self.bounds)


@dataclass(frozen=True)
class Integrals:
    """Integrals of some functions from zero, along an interval that contains zero.

    Attributes
    ----------
    panels : tuple of Panel
        From left to right.
    """

    panels: tuple[Panel, ...]

    def value(self, index: int, sigma: arb) -> arb:
        """An integral from 0 to σ, a small ball inside the interval."""
        middle = sigma.mid()
        inside = (p for p in self.panels if p.low <= middle and middle <= p.high)
        panel = next(inside, self.panels[0 if middle < 0 else -1])
        return panel.value(index, sigma)

    @property
    def count(self) -> int:
        """The number of integrals."""
        return len(self.panels[0].series)

    def left_end(self, index: int) -> arb:
        """The integral up to the left end."""
        return self.panels[0].value(index, self.panels[0].low)

    def right_end(self, index: int) -> arb:
        """The integral up to the right end."""
        return self.panels[-1].value(index, self.panels[-1].high)

    def table(self) -> Table:
        """The integrals in double precision."""
        return Table(self)


def integrals(
    rates: Rates,
    low: arb,
    high: arb,
    digits: int,
    units: Sequence[float],
    nested: NestedRates | None = None,
    parities: Sequence[int] = (),
) -> Integrals:
    """Compute integrals from zero along [low, high].

    Parameters
    ----------
    rates : callable
        Functions, analytic near the interval and real on it.
    low, high : arb
        With low ≤ 0 < high; their middles are taken.
    digits : int
        The error bound is 10^−digits relative to each function on each panel, or to its unit
        where it is smaller.
    units : sequence of float
        Of all functions, the further ones included: sizes beside which others are small.
    nested : callable, optional
        Further functions, of σ, the first ones and their integrals.
    parities : sequence of 1 and −1, optional
        Of all integrals, if the interval is symmetric and each is even or odd, the first being odd;
        only one half of them is then computed.

    Raises
    ------
    InputError
        If a function is singular on the interval.
    """
    build = _Build(rates, nested, digits, units)
    right = build.side(arb(0), high.mid())
    if parities:
        left = [panel.reflection(parities) for panel in right]
    else:
        left = build.side(arb(0), low.mid()) if low < 0 else []
    return Integrals((*reversed(left), *right))


@dataclass(frozen=True)
class _Build:
    rates: Rates
    nested: NestedRates | None
    digits: int
    units: Sequence[float]

    def side(self, start: arb, end: arb) -> list[Panel]:
        """Panels from `start` outwards, to the right or to the left."""
        pieces = max(1, math.ceil(abs(float(end - start))))
        stops = [start + (end - start) * k / pieces for k in range(1, pieces)]
        waiting = [end, *(stop.mid() for stop in reversed(stops))]
        panels: list[Panel] = []
        totals: Sequence[arb] = ()
        while waiting:
            stop = waiting[-1]
            panel = self._panel(start, stop, totals)
            if panel is None:
                if abs(stop - start) < NARROWEST:
                    raise InputError("a quadrature of this motion is singular on its way")
                waiting.append(((start + stop) / 2).mid())
                continue
            panels.append(panel)
            start = waiting.pop()
            totals = [s(arb(1 if start == panel.high else -1)) for s in panel.series]
        return panels

    # The panel between `start` and `stop`; None if it must be halved.
    # 1. The boxes around the panel give upper bounds M of the rates.  They fail if a value is not
    #    finite or much larger than that in the middle (`_bounds`).
    # 2. Values at the Chebyshev points times the matrix of `_transform` give the coefficients c_k.
    #    ∫T_k = (T_{k+1}/(k + 1) − T_{k−1}/(k − 1))/2 gives those of the integral, whose constant is
    #    fixed by `totals` at the end where the panel before stopped; the error bound of the
    #    interpolant times the width is added (`_antiderivatives`).
    # 3. Nested rates depend on the integrals q too.  On the boxes, q is enclosed by its value in
    #    the middle and |q(σ) − q(centre)| ≤ M|σ − centre| (`_enclosure`), and the steps repeat.
    def _panel(self, start: arb, stop: arb, totals: Sequence[arb]) -> Panel | None:
        low, high = (start, stop) if start < stop else (stop, start)
        half, centre = (high - low) / 2, (high + low) / 2
        boxes = [
            acb(arb(centre + half * x, half * reach), half * height.union(arb(0)))
            for x, reach, height in BOXES
        ]
        middle = self.rates(acb(centre))
        bounds = _bounds((self.rates(box) for box in boxes), middle, self.units)
        if bounds is None:
            return None
        n = degree(self.digits)
        nodes, matrix = _transform(n, ctx.prec)
        known = [self.rates(acb(centre + half * node)) for node in nodes]
        values = matrix * arb_mat([[f.real for f in row] for row in known])
        anchor = -1 if start == low else 1
        series = _antiderivatives(values, bounds, half, anchor, totals)
        if self.nested is not None:
            around = [_enclosure(s, m, half) for s, m in zip(series, bounds, strict=True)]
            inside = self.nested(acb(centre), middle, [acb(s(arb(0))) for s in series])
            every = (self.nested(box, self.rates(box), around) for box in boxes)
            further = _bounds(every, inside, self.units[len(middle) :])
            if further is None:
                return None
            rows = [
                self.nested(acb(centre + half * x), row, [acb(s(x)) for s in series])
                for x, row in zip(nodes, known, strict=True)
            ]
            coefficients = matrix * arb_mat([[f.real for f in row] for row in rows])
            series += _antiderivatives(coefficients, further, half, anchor, totals[len(series) :])
            bounds = [*bounds, *further]
        first = [values[k, 0] for k in range(n + 1)]
        return Panel(low, high, tuple(series), first, tuple(bounds))


def _bounds(
    boxes: Iterable[Sequence[acb]], middle: Sequence[acb], units: Sequence[float]
) -> list[arb] | None:
    """Bounds of functions over all boxes; None if they are too large compared with the middle."""
    # With the reserve of eight factors of ρ in `degree`, the error 4Mρ⁻ⁿ/(ρ − 1) is below
    # 10^−digits of the value in the middle (or its unit) for any M below this limit.
    limits = [
        10 * RHO**6 * max(unit, float(f.abs_upper()))
        for f, unit in zip(middle, units, strict=False)
    ]
    bounds = [arb(0)] * len(middle)
    for box in boxes:
        for index, (f, limit) in enumerate(zip(box, limits, strict=True)):
            size = arb(f.abs_upper())
            if not size < limit:
                return None
            bounds[index] = bounds[index].max(size)
    return bounds


def _enclosure(series: Series, bound: arb, half: arb) -> acb:
    """Enclosure of an integral over the boxes."""
    across = ACROSS * half * bound
    along = (ALONG + ACROSS) * half * bound
    return acb(series(arb(0)) + arb(0, along.upper()), arb(0, across.upper()))


def _antiderivatives(
    coefficients: arb_mat, bounds: Sequence[arb], half: arb, anchor: int, totals: Sequence[arb]
) -> list[Series]:
    """The integrals that continue `totals` from the end `anchor`, as Chebyshev series."""
    n = coefficients.nrows() - 1
    antiderivatives = []
    for index, bound in enumerate(bounds):
        c = [coefficients[k, index] for k in range(n + 1)] + [arb(0), arb(0)]
        integral = [arb(0), half * (c[0] - c[2] / 2)]
        integral += [half * (c[k - 1] - c[k + 1]) / (2 * k) for k in range(2, n + 2)]
        begin = Series.from_balls(integral)(arb(anchor))
        integral[0] = (totals[index] if totals else 0) - begin
        error = 4 * bound / arb(RHO) ** n / (RHO - 1) * 2 * half
        antiderivatives.append(Series.from_balls(integral, error))
    return antiderivatives


class Table:
    """Integrals in double precision, at many points at once.

    A point is given by the index of its panel and the coordinate in it, from −1 to 1, which gives
    full relative accuracy even on the narrowest panel.
    """

    def __init__(self, exact: Integrals) -> None:
        panels = exact.panels
        self._centre = np.array([float((p.low + p.high) / 2) for p in panels])
        self._half = np.array([float((p.high - p.low) / 2) for p in panels])
        self._series = np.array(
            [[[float(c) for c in s.coefficients] for s in p.series] for p in panels]
        ).transpose(1, 2, 0)
        self._first = np.array([[float(c.mid()) for c in p.first] for p in panels]).T
        offsets = np.linspace(-1.0, 1.0, KNOTS, endpoint=False)
        count = len(panels)
        panel, x = np.repeat(np.arange(count), KNOTS), np.tile(offsets, count)
        times = self.value(0, (panel, x))
        last = self.value(0, (np.array([count - 1]), np.array([1.0])))
        self._times = np.append(times, last)
        self._begins = times[::KNOTS]

    @property
    def span(self) -> tuple[float, float]:
        """The first integral at both ends."""
        return float(self._times[0]), float(self._times[-1])

    def phase(self, points: PanelPoints) -> FloatArray:
        """σ at points."""
        panel, x = points
        return self._centre[panel] + self._half[panel] * x

    def value(self, index: int, points: PanelPoints) -> FloatArray:
        """An integral at points."""
        panel, x = points
        series = self._series[index][:, panel]
        sums: FloatArray = np.polynomial.chebyshev.chebval(x, series, tensor=False)
        return sums

    def rate(self, points: PanelPoints) -> FloatArray:
        """The first function at points."""
        panel, x = points
        sums: FloatArray = np.polynomial.chebyshev.chebval(x, self._first[:, panel], tensor=False)
        return sums

    def inverse(self, values: FloatArray) -> PanelPoints:
        """The points at which the first integral, which is increasing, has given values (n,)."""
        panel = np.clip(np.searchsorted(self._begins, values, side="right") - 1, 0, None)
        knots = np.interp(values, self._times, np.arange(len(self._times)) / KNOTS)
        x = np.clip(2 * (knots - panel) - 1, -1.0, 1.0)
        for _ in range(4):
            points = (panel, x)
            step = (self.value(0, points) - values) / (self.rate(points) * self._half[panel])
            x = np.clip(x - step, -1.0, 1.0)
        return panel, x
