"""Obstructions to an invariant measure that is smooth where a rolling body is at rest.

Let the momenta (or angular velocities) p change by ṗ quadratic in p and γ by γ̇ linear in p, and let
ρ(p, γ) be positive and continuously differentiable at p = 0.  The terms of first order in p of
v(ln ρ) + div v = 0 then are

    γ̇ · ∂ ln ρ(0, γ)/∂γ + d(p, γ) = 0,      d = div v, linear in p.

- Marble: a body that spins about the normal has γ̇ = 0, so that d must vanish for ω = γ.
- Rubber: γ̇ = γ×ω takes every tangential value, so that d = (T, ω) must have T = γ×∇ ln ρ on the
  tangent plane, and the tangential part of T no divergence on the sphere.

All numbers are rational, and every derivative is exact: a quadratic function is differentiated by a
central difference, and γ carries its derivatives along.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from operator import add, mul

import sympy as sp

from ..system import System
from ..vectors import Vector, explicit, vectors

__all__ = ["curl_of_divergence", "divergence_of_spin"]

M, omega, gamma = vectors("M omega gamma")

Triple = Sequence[Fraction]
UNITS = tuple(tuple(Fraction(int(i == j)) for j in range(3)) for i in range(3))


@dataclass(frozen=True)
class _Dual:
    """A rational number with its derivatives by γ."""

    value: Fraction
    slope: tuple[Fraction, ...] = (Fraction(0), Fraction(0), Fraction(0))

    def __add__(self, other: _Dual) -> _Dual:
        pairs = zip(self.slope, other.slope, strict=True)
        return _Dual(self.value + other.value, tuple(a + b for a, b in pairs))

    def __mul__(self, other: _Dual) -> _Dual:
        pairs = zip(self.slope, other.slope, strict=True)
        slope = tuple(a * other.value + self.value * b for a, b in pairs)
        return _Dual(self.value * other.value, slope)

    def power(self, exponent: int) -> _Dual:
        """A whole power."""
        factor = exponent * self.value ** (exponent - 1)
        return _Dual(self.value**exponent, tuple(factor * a for a in self.slope))


def _evaluated(formula: sp.Expr, known: Mapping[sp.Symbol, _Dual]) -> _Dual:
    """A rational formula; sympy.SympifyError or KeyError where it is not one."""
    if formula.is_Symbol:
        return known[formula]
    if formula.is_Add or formula.is_Mul:
        return reduce(
            add if formula.is_Add else mul, (_evaluated(arg, known) for arg in formula.args)
        )
    if formula.is_Pow:
        return _evaluated(formula.base, known).power(int(formula.exp))
    number = sp.Rational(formula)
    return _Dual(Fraction(int(number.p), int(number.q)))


def _known(system: System, vector: Vector, value: Triple, place: Triple) -> dict[sp.Symbol, _Dual]:
    """Parameters, state and definitions at a point."""
    known = {p.symbol: _Dual(Fraction(str(p.default))) for p in system.parameters}
    known |= {s: _Dual(x) for s, x in zip(vector.symbols, value, strict=True)}
    known |= {s: _Dual(x, e) for s, x, e in zip(gamma.symbols, place, UNITS, strict=True)}
    for symbol, formula in system.steps:
        if symbol not in known and formula.free_symbols <= set(known):
            known[symbol] = _evaluated(formula, known)
    return known


def _divergence(system: System, vector: Vector, value: Triple, place: Triple) -> _Dual:
    """div v at a point, with its derivatives by γ; γ̇ has no divergence for a ball."""
    rates = dict(zip(system.symbols, system.rates, strict=True))
    total = _Dual(Fraction(0))
    for symbol, unit in zip(vector.symbols, UNITS, strict=True):
        for sign in (1, -1):
            shifted = [x + sign * e for x, e in zip(value, unit, strict=True)]
            rate = _evaluated(rates[symbol], _known(system, vector, shifted, place))
            total = total + rate * _Dual(Fraction(sign, 2))
    return total


def divergence_of_spin(system: System, place: Triple) -> Fraction:
    """d(M, γ) of a marble ball for ω = γ, which an invariant measure smooth at rest needs zero.

    Parameters
    ----------
    system : System
        State M, γ; the default parameters are read as decimal fractions.
    place : 3 rational numbers
        γ, a unit vector.
    """
    spinning = _known(system, omega, place, place)
    formula = explicit(dict(system.start)[M])
    momentum = [_evaluated(part, spinning).value for part in formula]
    return _divergence(system, M, momentum, place).value


def curl_of_divergence(system: System, place: Triple) -> Fraction:
    """The divergence on the sphere of the tangential part of T, for a rubber ball on a plane.

    Parameters
    ----------
    system : System
        State ω, γ; the default parameters are read as decimal fractions.
    place : 3 rational numbers
        γ, a unit vector.
    """
    field = [_divergence(system, omega, unit, place) for unit in UNITS]
    total = Fraction(0)
    for i, part in enumerate(field):
        total += part.slope[i] - 2 * part.value * place[i]
        total -= sum(place[i] * a * x for a, x in zip(part.slope, place, strict=True))
    return total
