"""The coordinate of a motion x′² = N(x)/B(x) as an elementary function of a phase σ.

The phase always increases with time, and dt/dσ is analytic and positive:

    between simple roots a < b     x = m + ρ cos σ              m = (a + b)/2, ρ = (b − a)/2
    simple root a, double root e   x = a + (e − a) tanh² σ      σ = 0 at the turning point
    double roots a, b              x = m + ρ tanh σ             from a to b

Formulas are written once, for both balls and NumPy arrays; see :mod:`.functions`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass

import numpy as np
from flint import acb, arb

from .divided_differences import Formula, analytic_root, slope, value
from .functions import BALLS, Functions, N
from .turning_points import End


@dataclass(frozen=True)
class Equation:
    """The equation x′² = N(x)/B(x).

    Attributes
    ----------
    numerator, denominator : formula
        N and B, the second positive; of balls and of `DividedDifferences`.
    low, high : arb
        Edges of the domain.
    inner : formula, optional
        N divided by the factors x − low, high − x that it has by construction.
    closed : two bools
        Whether it has them; the motion must turn before an edge whose factor N does not have.
    """

    numerator: Formula
    denominator: Formula
    low: arb
    high: arb
    inner: Formula | None = None
    closed: tuple[bool, bool] = (False, False)

    def square(self, x: arb) -> arb:
        """x′² at a point (arb)."""
        return (value(self.numerator, x) / value(self.denominator, x)).real


@dataclass(frozen=True)
class Uniformisation(ABC):
    """The motion between two ends, as a function of its phase."""

    equation: Equation
    first: End
    second: End

    @abstractmethod
    def coordinate(self, F: Functions[N], sigma: N) -> N:
        """x at a phase, in the numbers of `F`."""

    @abstractmethod
    def slope(self, F: Functions[N], sigma: N) -> N:
        """dx/dσ."""

    @abstractmethod
    def roots(self, F: Functions[N], sigma: N) -> tuple[N, N]:
        """√(x − low) and √(high − x), to full relative accuracy.

        If the turning point is an edge, the motion passes through it and the root changes its sign.
        """

    @abstractmethod
    def clock(self, sigma: acb) -> acb:
        """dt/dσ in complex balls."""

    @abstractmethod
    def phase(self, x: arb, rate: arb) -> arb:
        """The phase of a point with the rate x′ (arb)."""

    def arc_slope(self, F: Functions[N], sigma: N) -> N:
        """(dx/dσ)/(√(x − low) √(high − x)), regular where the motion passes an edge."""
        low, high = self.roots(F, sigma)
        return self.slope(F, sigma) / (low * high)

    @property
    def width(self) -> arb:
        """The distance between the ends."""
        return abs(self.second.x - self.first.x)

    @property
    def gaps(self) -> tuple[arb, arb]:
        """Distances of the first and of the second end from the edges beyond them."""
        a, b = self.first.x, self.second.x
        low, high = self.equation.low, self.equation.high
        return (a - low, high - b) if a < b else (high - a, b - low)


@dataclass(frozen=True)
class Oscillating(Uniformisation):
    """Between simple roots a < b; the phase has the period 2π."""

    @property
    def middle(self) -> arb:
        """m."""
        return (self.first.x + self.second.x) / 2

    def coordinate(self, F: Functions[N], sigma: N) -> N:
        """m + ρ cos σ, measured from the nearer end: tight on balls around it."""
        if isinstance(sigma, np.ndarray):
            return F.number(self.middle) + F.number(self.width / 2) * F.cos(sigma)
        if abs(sigma.real.mid()) < arb.pi() / 2:
            return self.second.x - self.width * F.square(F.sin(sigma / 2))
        return self.first.x + self.width * F.square(F.cos(sigma / 2))

    def slope(self, F: Functions[N], sigma: N) -> N:
        """−ρ sin σ."""
        return -F.number(self.width / 2) * F.sin(sigma)

    def roots(self, F: Functions[N], sigma: N) -> tuple[N, N]:
        """From x − low = (a − low) + 2ρ cos² σ/2 and high − x = (high − b) + 2ρ sin² σ/2."""
        low = _root(F, self.first, self.gaps[0], self.width, F.cos(sigma / 2))
        return low, _root(F, self.second, self.gaps[1], self.width, F.sin(sigma / 2))

    def arc_slope(self, F: Functions[N], sigma: N) -> N:
        """−ρ sin σ over both roots, in which the factors of passed edges cancel."""
        low, high = self.roots(F, sigma)
        scale = F.number(1 / self.width.sqrt())
        cos = scale if self.first.edge else F.cos(sigma / 2) / low
        sin = scale if self.second.edge else F.sin(sigma / 2) / high
        return -F.number(self.width) * cos * sin

    def clock(self, sigma: acb) -> acb:
        """√(B/−N[x, a, b])."""
        return self._clock(self.coordinate(BALLS, sigma))

    def _clock(self, x: arb | acb) -> acb:
        # N vanishes at a and b, so N(x) = (x − a)(x − b) N[x, a, b] = −ρ² sin² σ N[x, a, b], and
        # the root with dx/dσ = −ρ sin σ cancels without division at the turning points.
        divided = -slope(self.equation.numerator, x, self.first.x, self.second.x)
        return analytic_root(value(self.equation.denominator, x) / divided)

    def phase(self, x: arb, rate: arb) -> arb:
        """From ρ cos σ = x − m and ρ sin σ = −x′ dt/dσ."""
        across, along = -rate * self._clock(x).real, x - self.middle
        if across.contains(0) and along < 0:
            # The branch cut of the angle must not pass through the ball.
            return arb.pi() + arb.atan2(-across, -along)
        return arb.atan2(across, along)


@dataclass(frozen=True)
class Asymptotic(Uniformisation):
    """From the double root e to the simple root a and back: `first` is a, `second` is e."""

    @property
    def reach(self) -> arb:
        """e − a, with its sign."""
        return self.second.x - self.first.x

    def coordinate(self, F: Functions[N], sigma: N) -> N:
        """a + (e − a) tanh² σ."""
        return F.number(self.first.x) + F.number(self.reach) * F.square(F.tanh(sigma))

    def slope(self, F: Functions[N], sigma: N) -> N:
        """2(e − a) tanh σ sech² σ."""
        return 2 * F.number(self.reach) * F.tanh(sigma) * F.square(F.sech(sigma))

    def roots(self, F: Functions[N], sigma: N) -> tuple[N, N]:
        """From |x − a| = |e − a| tanh² σ and |e − x| = |e − a| sech² σ."""
        inner, outer = self._roots(F, sigma)
        return (inner, outer) if self.reach > 0 else (outer, inner)

    def _roots(self, F: Functions[N], sigma: N) -> tuple[N, N]:
        inner = _root(F, self.first, self.gaps[0], self.width, F.tanh(sigma))
        return inner, _root(F, self.second, self.gaps[1], self.width, F.sech(sigma))

    def arc_slope(self, F: Functions[N], sigma: N) -> N:
        """dx/dσ over both roots, in which the factors of edges cancel."""
        inner, outer = self._roots(F, sigma)
        scale = F.number(1 / self.width.sqrt())
        tanh = scale if self.first.edge else F.tanh(sigma) / inner
        sech = scale if self.second.edge else F.sech(sigma) / outer
        return 2 * F.number(self.reach) * tanh * sech * F.sech(sigma)

    def clock(self, sigma: acb) -> acb:
        """2√(B/(e − a)N[x, a, e, e])."""
        return self._clock(self.coordinate(BALLS, sigma))

    def _clock(self, x: arb | acb) -> acb:
        a, e = self.first.x, self.second.x
        # N(x) = (x − a)(x − e)² N[x, a, e, e] = (e − a)³ tanh² σ sech⁴ σ N[x, a, e, e].
        divided = self.reach * slope(self.equation.numerator, x, a, e, e)
        return 2 * analytic_root(value(self.equation.denominator, x) / divided)

    def phase(self, x: arb, rate: arb) -> arb:
        """From sech² σ = (e − x)/(e − a) and x′ dt/dσ = 2(e − x) tanh σ."""
        e = self.second.x
        tanh = rate * self._clock(x).real / (2 * (e - x))
        return (tanh * (self.reach / (e - x)).sqrt()).asinh()


@dataclass(frozen=True)
class Heteroclinic(Uniformisation):
    """From the double root a to the double root b, which may be the lower one."""

    @property
    def reach(self) -> arb:
        """ρ, with the sign of the motion."""
        return (self.second.x - self.first.x) / 2

    @property
    def middle(self) -> arb:
        """m."""
        return (self.first.x + self.second.x) / 2

    def coordinate(self, F: Functions[N], sigma: N) -> N:
        """m + ρ tanh σ."""
        return F.number(self.middle) + F.number(self.reach) * F.tanh(sigma)

    def slope(self, F: Functions[N], sigma: N) -> N:
        """ρ sech² σ."""
        return F.number(self.reach) * F.square(F.sech(sigma))

    def roots(self, F: Functions[N], sigma: N) -> tuple[N, N]:
        """From |x − a| = 2|ρ|/(1 + e^−2σ) and |b − x| = 2|ρ|/(1 + e^2σ)."""
        inner, outer = (F.number(gap) for gap in self.gaps)
        width = F.number(self.width)
        first = F.sqrt(inner + width * F.step(sigma))
        second = F.sqrt(outer + width * F.step(-sigma))
        return (first, second) if self.reach > 0 else (second, first)

    def clock(self, sigma: acb) -> acb:
        """√(B/N[x, a, a, b, b])/|ρ|."""
        x, a, b = self.coordinate(BALLS, sigma), self.first.x, self.second.x
        divided = slope(self.equation.numerator, x, a, a, b, b)
        return analytic_root(value(self.equation.denominator, x) / divided) / abs(self.reach)

    def phase(self, x: arb, rate: arb) -> arb:
        """From sinh σ = ±(x − m)/√|x − a||b − x|."""
        a, b = self.first.x, self.second.x
        along = (x - self.middle) * self.reach.sgn()
        return (along / ((x - a) * (b - x)).sqrt()).asinh()


def _root(F: Functions[N], end: End, gap: arb, width: arb, factor: N) -> N:
    """√(gap + width · factor²), with the sign of the factor if the gap is zero."""
    if end.edge:
        return F.number(width.sqrt()) * factor
    return F.sqrt(F.number(gap) + F.number(width) * F.square(factor))
