"""Hertz's factors F(k) and M(k) for compiled code: three ranges without cancellation.

F has only two continuous derivatives at k = 1, so no analytic formula holds on both sides; for
large k the closed form cancels, and a series replaces it.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from typing import Literal

import sympy as sp

from flowlanes.system.vectors import real_symbol

from .hypergeometric import series_coefficients

#: Bounds of the middle range.  The first is where the formulas change; at the second the closed
#: form of M has lost one digit (at 3 two), and the series needs 20 terms.
INNER_BOUND, OUTER_BOUND = sp.Integer(1), sp.Integer(2)
#: Largest remainder of the series.
REMAINDER = 1e-17

k = real_symbol("k")
_HALF = Fraction(1, 2)


@dataclass(frozen=True)
class FactorRange:
    """Hertz's factors between two values of k.

    Attributes
    ----------
    name : str
        ``"inner"``, ``"middle"`` or ``"outer"``.
    lower, upper : sympy.Expr
        The bounds of k.
    argument : sympy.Symbol
        Variable of the formulas; in terms of k it is `argument_formula` (k², k and 1/k²).
    argument_formula : sympy.Expr
    force, couple : sympy.Expr
        F/`force_scale` and M/`couple_scale` as formulas in `argument`.
    force_scale, couple_scale : sympy.Expr
        Powers of k: k and 1, then 1 and 1, then 1 and 1/k.  So F u/|u| is smooth where the sliding
        ends, and M sgn Ω where the spinning ends.
    """

    name: Literal["inner", "middle", "outer"]
    lower: sp.Expr
    upper: sp.Expr
    argument: sp.Symbol
    argument_formula: sp.Expr
    force: sp.Expr
    couple: sp.Expr
    force_scale: sp.Expr
    couple_scale: sp.Expr

    def factors(self) -> tuple[sp.Expr, sp.Expr]:
        """F and M as formulas in k, valid in this range only."""
        inserted = {self.argument: self.argument_formula}
        return (
            self.force_scale * self.force.xreplace(inserted),
            self.couple_scale * self.couple.xreplace(inserted),
        )


@cache
def hertz_ranges() -> tuple[FactorRange, FactorRange, FactorRange]:
    """The inner, the middle and the outer range of Hertz's factors, in this order.

    In the middle range α = arcsin(1/k) is written as π/2 − arctan s with s = √(k² − 1).  The
    rounding error of s, which is large near k = 1, then has no effect on F and M to first order.

    Examples
    --------
    >>> from nonholonomic.contact.pressure.pressure_ranges import hertz_ranges
    >>> inner, middle, outer = hertz_ranges()
    >>> inner.force, inner.couple
    (pi*(3/8 - 3*k_2/32), pi*(k_2*(9*k_2/128 - 3/16) + 3/16))
    """
    square, inverse = real_symbol("k_2"), real_symbol("j_2")
    # Factor out π, so that the coefficients stay rational.
    inner = FactorRange(
        "inner",
        sp.Integer(0),
        INNER_BOUND,
        square,
        k**2,
        sp.Mul(sp.pi, _horner([Fraction(3, 8), Fraction(-3, 32)], square), evaluate=False),
        sp.Mul(
            sp.pi,
            _horner([Fraction(3, 16), Fraction(-3, 16), Fraction(9, 128)], square),
            evaluate=False,
        ),
        k,
        sp.Integer(1),
    )
    s = sp.sqrt((k - 1) * (k + 1))
    alpha = sp.pi / 2 - sp.atan(s)
    middle = FactorRange(
        "middle",
        INNER_BOUND,
        OUTER_BOUND,
        k,
        k,
        sp.Rational(3, 16) * (k * (4 - k**2) * alpha + (k + 2 / k) * s),
        sp.Rational(3, 64) * ((8 - k**2 * (8 - 3 * k**2)) * alpha + 3 * (2 - k**2) * s),
        sp.Integer(1),
        sp.Integer(1),
    )
    outer = FactorRange(
        "outer",
        OUTER_BOUND,
        sp.oo,
        inverse,
        k**-2,
        _horner(_series(-_HALF, Fraction(5, 2)), inverse),
        _horner([c / 5 for c in _series(_HALF, Fraction(7, 2))], inverse),
        sp.Integer(1),
        1 / k,
    )
    return inner, middle, outer


def _series(a: Fraction, c: Fraction) -> list[Fraction]:
    """Coefficients of ₂F₁(a, ½; c; z), as many as the outer range needs."""
    bound = 1 / Fraction(int(OUTER_BOUND)) ** 2
    coefficients = series_coefficients(a, _HALF, c, 100)
    for number in range(1, len(coefficients)):
        # The coefficients decrease, so a geometric series bounds the remainder.
        if abs(coefficients[number]) * bound**number / (1 - bound) < REMAINDER:
            return coefficients[:number]
    raise ArithmeticError("the series needs more than 100 terms")


def _horner(coefficients: list[Fraction], x: sp.Symbol) -> sp.Expr:
    """A polynomial in Horner form, which sums the smallest terms first."""
    value: sp.Expr = sp.Integer(0)
    for coefficient in reversed(coefficients):
        rational = sp.Rational(coefficient.numerator, coefficient.denominator)
        value = value * x + rational
    return value
