"""The coordinate of a motion x′² = N(x)/B(x) as an elementary function of a phase σ.

The phase always increases with time, and dt/dσ is analytic and positive:

    between simple roots a < b     x = m + ρ cos σ              m = (a + b)/2, ρ = (b − a)/2
    simple root a, double root e   x = a + (e − a) tanh² σ      σ = 0 at the turning point
    double roots a, b              x = m + ρ tanh σ             from a to b

Formulas are written once, for complex balls and for NumPy arrays: see :data:`BALLS` and
:data:`DOUBLES`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any

import numpy as np
from flint import acb, arb

from .divided_differences import Formula, slope, value
from .turning_points import End

__all__ = [
    "BALLS",
    "DOUBLES",
    "Asymptotic",
    "Equation",
    "Heteroclinic",
    "Oscillating",
    "Uniformisation",
]


def _ball_root(x: Any) -> Any:
    return x.sqrt(analytic=True) if isinstance(x, acb) else x.sqrt()


#: Functions of balls, not finite where a complex ball meets a branch cut.
BALLS = SimpleNamespace(
    number=lambda x: x,
    sin=lambda x: x.sin(),
    cos=lambda x: x.cos(),
    tanh=lambda x: x.tanh(),
    sech=lambda x: x.sech(),
    step=lambda x: 1 / (1 + (-2 * x).exp()),
    sqrt=_ball_root,
    # a power of a ball that contains zero has no value
    square=lambda x: x * x,
)

#: The same of arrays.
DOUBLES = SimpleNamespace(
    number=float,
    sin=np.sin,
    cos=np.cos,
    tanh=np.tanh,
    sech=lambda x: 1 / np.cosh(np.clip(x, -350.0, 350.0)),
    step=lambda x: 1 / (1 + np.exp(-2 * np.clip(x, -350.0, 350.0))),
    sqrt=np.sqrt,
    square=np.square,
)


@dataclass(frozen=True)
class Equation:
    """The equation x′² = N(x)/B(x).

    Attributes
    ----------
    numerator, denominator : formula
        N and B, the second positive; in balls and in :class:`Slopes`.
    low, high : arb
        Edges of the domain.
    inner : formula, optional
        N divided by the factors x − low, high − x that it has by construction.
    closed : two bools
        Whether it has them; the motion must turn before an edge whose factor N does not have.
    """

    numerator: Formula
    denominator: Formula
    low: Any
    high: Any
    inner: Formula | None = None
    closed: tuple[bool, bool] = (False, False)

    def square(self, x: Any) -> Any:
        """x′² at a point (arb)."""
        return (value(self.numerator, x) / value(self.denominator, x)).real


@dataclass(frozen=True)
class Uniformisation(ABC):
    """The motion between two ends, in its phase."""

    equation: Equation
    first: End
    second: End

    @abstractmethod
    def place(self, F: Any, sigma: Any) -> Any:
        """x at a phase; `F` is :data:`BALLS` or :data:`DOUBLES`."""

    @abstractmethod
    def slope(self, F: Any, sigma: Any) -> Any:
        """dx/dσ."""

    @abstractmethod
    def roots(self, F: Any, sigma: Any) -> tuple[Any, Any]:
        """√(x − low) and √(high − x), to full relative accuracy.

        An edge that is itself the turning point is passed: the root then changes its sign.
        """

    @abstractmethod
    def clock(self, sigma: Any) -> Any:
        """dt/dσ in complex balls."""

    @abstractmethod
    def phase(self, x: Any, rate: Any) -> Any:
        """The phase of a point with the rate x′ (arb)."""

    def lean(self, F: Any, sigma: Any) -> Any:
        """(dx/dσ)/(√(x − low) √(high − x)), regular where an edge is passed."""
        low, high = self.roots(F, sigma)
        return self.slope(F, sigma) / (low * high)

    @property
    def width(self) -> Any:
        """The distance of the ends."""
        return abs(self.second.place - self.first.place)

    @property
    def gaps(self) -> tuple[Any, Any]:
        """From the first and from the second end to the edges beyond them."""
        a, b = self.first.place, self.second.place
        low, high = self.equation.low, self.equation.high
        return (a - low, high - b) if a < b else (high - a, b - low)


@dataclass(frozen=True)
class Oscillating(Uniformisation):
    """Between simple roots a < b; the phase has the period 2π."""

    @property
    def middle(self) -> Any:
        """m."""
        return (self.first.place + self.second.place) / 2

    def place(self, F: Any, sigma: Any) -> Any:
        """m + ρ cos σ, counted from the nearer end: tight on balls around it."""
        if F is DOUBLES:
            return F.number(self.middle) + F.number(self.width / 2) * F.cos(sigma)
        if abs(sigma.real.mid()) < arb.pi() / 2:
            return self.second.place - self.width * F.square(F.sin(sigma / 2))
        return self.first.place + self.width * F.square(F.cos(sigma / 2))

    def slope(self, F: Any, sigma: Any) -> Any:
        """−ρ sin σ."""
        return -F.number(self.width / 2) * F.sin(sigma)

    def roots(self, F: Any, sigma: Any) -> tuple[Any, Any]:
        """By x − low = (a − low) + 2ρ cos² σ/2 and high − x = (high − b) + 2ρ sin² σ/2."""
        low = _root(F, self.first, self.gaps[0], self.width, F.cos(sigma / 2))
        return low, _root(F, self.second, self.gaps[1], self.width, F.sin(sigma / 2))

    def lean(self, F: Any, sigma: Any) -> Any:
        """−ρ sin σ over both roots, in which the factors of passed edges cancel."""
        low, high = self.roots(F, sigma)
        scale = F.number(1 / self.width.sqrt())
        cos = scale if self.first.edge else F.cos(sigma / 2) / low
        sin = scale if self.second.edge else F.sin(sigma / 2) / high
        return -F.number(self.width) * cos * sin

    def clock(self, sigma: Any) -> Any:
        """√(B/−N[x, a, b])."""
        return self._clock(self.place(BALLS, sigma))

    def _clock(self, x: Any) -> Any:
        rest = -slope(self.equation.numerator, x, self.first.place, self.second.place)
        return _ball_root(value(self.equation.denominator, x) / rest)

    def phase(self, x: Any, rate: Any) -> Any:
        """By ρ cos σ = x − m and ρ sin σ = −x′ dt/dσ."""
        across, along = -rate * self._clock(x).real, x - self.middle
        if across.contains(0) and along < 0:
            # the branch cut of the angle must not pass through the ball
            return arb.pi() + arb.atan2(-across, -along)
        return arb.atan2(across, along)


@dataclass(frozen=True)
class Asymptotic(Uniformisation):
    """Away from the double root e, to the simple root a and back: `first` is a, `second` is e."""

    @property
    def reach(self) -> Any:
        """e − a, with its sign."""
        return self.second.place - self.first.place

    def place(self, F: Any, sigma: Any) -> Any:
        """a + (e − a) tanh² σ."""
        return F.number(self.first.place) + F.number(self.reach) * F.square(F.tanh(sigma))

    def slope(self, F: Any, sigma: Any) -> Any:
        """2(e − a) tanh σ sech² σ."""
        return 2 * F.number(self.reach) * F.tanh(sigma) * F.square(F.sech(sigma))

    def roots(self, F: Any, sigma: Any) -> tuple[Any, Any]:
        """By |x − a| = |e − a| tanh² σ and |e − x| = |e − a| sech² σ."""
        near, far = self._roots(F, sigma)
        return (near, far) if self.reach > 0 else (far, near)

    def _roots(self, F: Any, sigma: Any) -> tuple[Any, Any]:
        near = _root(F, self.first, self.gaps[0], self.width, F.tanh(sigma))
        return near, _root(F, self.second, self.gaps[1], self.width, F.sech(sigma))

    def lean(self, F: Any, sigma: Any) -> Any:
        """dx/dσ over both roots, in which the factors of edges cancel."""
        near, far = self._roots(F, sigma)
        scale = F.number(1 / self.width.sqrt())
        tanh = scale if self.first.edge else F.tanh(sigma) / near
        sech = scale if self.second.edge else F.sech(sigma) / far
        return 2 * F.number(self.reach) * tanh * sech * F.sech(sigma)

    def clock(self, sigma: Any) -> Any:
        """2√(B/(e − a)N[x, a, e, e])."""
        return self._clock(self.place(BALLS, sigma))

    def _clock(self, x: Any) -> Any:
        a, e = self.first.place, self.second.place
        rest = self.reach * slope(self.equation.numerator, x, a, e, e)
        return 2 * _ball_root(value(self.equation.denominator, x) / rest)

    def phase(self, x: Any, rate: Any) -> Any:
        """By sech² σ = (e − x)/(e − a) and x′ dt/dσ = 2(e − x) tanh σ."""
        e = self.second.place
        tanh = rate * self._clock(x).real / (2 * (e - x))
        return (tanh * (self.reach / (e - x)).sqrt()).asinh()


@dataclass(frozen=True)
class Heteroclinic(Uniformisation):
    """From the double root a to the double root b, which may be the lower one."""

    @property
    def reach(self) -> Any:
        """ρ, with the sign of the motion."""
        return (self.second.place - self.first.place) / 2

    @property
    def middle(self) -> Any:
        """m."""
        return (self.first.place + self.second.place) / 2

    def place(self, F: Any, sigma: Any) -> Any:
        """m + ρ tanh σ."""
        return F.number(self.middle) + F.number(self.reach) * F.tanh(sigma)

    def slope(self, F: Any, sigma: Any) -> Any:
        """ρ sech² σ."""
        return F.number(self.reach) * F.square(F.sech(sigma))

    def roots(self, F: Any, sigma: Any) -> tuple[Any, Any]:
        """By |x − a| = 2|ρ|/(1 + e^−2σ) and |b − x| = 2|ρ|/(1 + e^2σ)."""
        near, far = (F.number(gap) for gap in self.gaps)
        width = F.number(self.width)
        first = F.sqrt(near + width * F.step(sigma))
        second = F.sqrt(far + width * F.step(-sigma))
        return (first, second) if self.reach > 0 else (second, first)

    def clock(self, sigma: Any) -> Any:
        """√(B/N[x, a, a, b, b])/|ρ|."""
        x, a, b = self.place(BALLS, sigma), self.first.place, self.second.place
        rest = slope(self.equation.numerator, x, a, a, b, b)
        return _ball_root(value(self.equation.denominator, x) / rest) / abs(self.reach)

    def phase(self, x: Any, rate: Any) -> Any:
        """By sinh σ = ±(x − m)/√|x − a||b − x|."""
        a, b = self.first.place, self.second.place
        along = (x - self.middle) * self.reach.sgn()
        return (along / ((x - a) * (b - x)).sqrt()).asinh()


def _root(F: Any, end: End, gap: Any, width: Any, factor: Any) -> Any:
    """√(gap + width · factor²), with the sign of the factor where the gap is none."""
    if end.edge:
        return F.number(width.sqrt()) * factor
    return F.sqrt(F.number(gap) + F.number(width) * F.square(factor))
