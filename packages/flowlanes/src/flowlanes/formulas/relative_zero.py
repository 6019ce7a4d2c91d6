"""Test whether a number is zero relative to the size of its summands.

A number with a unit is small or large only relative to another one: 10⁻¹³ kg m² is an ordinary
moment of inertia for a ball of one millimetre.  So a sum is taken as zero if it is small compared
with its summands, and a start is on a level if its residual is small compared with the terms of
the residual.  All these tests are independent of the system of units.

Every formula has a value and a size, which is its value without cancellation.  Rational operations
are exact, on fractions, and a decimal number is taken exactly.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import TypeAlias

import mpmath
import sympy as sp
from flint import arb, fmpq

from ..system.named_formulas import Quantity
from ..system.vectors import Vector
from .evaluation import Evaluation
from .multiprecision import mpmath_function

#: Relative size below which a number is taken as zero: starts are read with fifty digits.
RESOLUTION = fmpq(1, 10**40)
#: Relative size that rounding of doubles may leave in a vanishing sum.
ROUNDING = fmpq(1, 10**12)
#: Relative residual of the constraints up to which a start is projected onto them.
START_TOLERANCE = fmpq(1, 10**9)

#: Digits of irrational values.
_DIGITS = 60


def vanishes(ball: arb, size: arb, part: fmpq = RESOLUTION) -> bool:
    """True if a ball cannot be distinguished from zero, compared with `size`.

    Parameters
    ----------
    ball, size : arb
    part : fmpq
        Largest ratio to the size that is taken as zero.
    """
    return bool(abs(ball).lower() <= arb(part) * abs(size).upper())


Real: TypeAlias = Fraction | mpmath.mpf


@dataclass(frozen=True)
class SizedNumber:
    """Number and the size of its summands.

    Attributes
    ----------
    value : Fraction or mpf
    size : Fraction or mpf
        Nonnegative, and zero only where all terms are zero.
    """

    value: Real
    size: Real

    def vanishes(self, part: fmpq = RESOLUTION) -> bool:
        """True if the value is at most a fraction `part` of the size."""
        share = Fraction(int(part.p), int(part.q))
        value, limit = _alike(abs(self.value), _times(share, self.size))
        return bool(value <= limit)

    @property
    def share(self) -> float:
        """Absolute value divided by the size."""
        if self.size == 0:
            return 0.0
        value, size = _alike(abs(self.value), self.size)
        return float(value / size)

    def __sub__(self, other: SizedNumber) -> SizedNumber:
        minus = SizedNumber(_times(Fraction(-1), other.value), other.size)
        return _sum([self, minus])


def state_sizes(
    state: Iterable[Quantity], symbols: Sequence[sp.Symbol], numbers: Sequence[Fraction]
) -> dict[sp.Symbol, SizedNumber]:
    """Numbers of a state with their sizes: the size of a component is that of its vector.

    A component that is only the rounding error of the others is then recognized as such.

    Parameters
    ----------
    state : iterable of Vector or Symbol
        Names of the state.
    symbols : sequence of Symbol
        Components in flat order; those without an entry in `numbers` are omitted.
    numbers : sequence of Fraction
    """
    known = dict(zip(symbols, numbers, strict=False))
    sizes = {symbol: SizedNumber(x, abs(x)) for symbol, x in known.items()}
    for name in state:
        if isinstance(name, Vector):
            parts = [s for s in name.symbols if s in known]
            size = max((abs(known[s]) for s in parts), default=Fraction(0))
            sizes |= {s: SizedNumber(known[s], size) for s in parts}
    return sizes


def values_with_sizes(
    formulas: Sequence[sp.Expr],
    values: Mapping[sp.Symbol, SizedNumber],
    steps: Iterable[tuple[sp.Symbol, sp.Expr]] = (),
) -> list[SizedNumber]:
    """Scalar formulas with their sizes.

    Parameters
    ----------
    formulas : sequence of sympy.Expr
    values : mapping of Symbol to Sized
    steps : pairs of Symbol and formula, optional
        Intermediate quantities, in order.

    Raises
    ------
    ZeroDivisionError
        If a formula has no value.
    KeyError
        If a symbol has no value.
    """
    with mpmath.workdps(_DIGITS):
        sizes = _Sizes(values)
        sizes.define(steps)
        return [sizes(sp.sympify(formula)) for formula in formulas]


# --- arithmetic ----------------------------------------------------------------------------


def _mpf(number: Real) -> mpmath.mpf:
    if isinstance(number, Fraction):
        return mpmath.mpf(number.numerator) / number.denominator
    return number


def _alike(*numbers: Real) -> tuple[Real, ...]:
    """Numbers of one type: fractions only if all of them are fractions."""
    if all(isinstance(number, Fraction) for number in numbers):
        return numbers
    return tuple(_mpf(number) for number in numbers)


def _times(one: Real, other: Real) -> Real:
    first, second = _alike(one, other)
    return first * second


def _sum(terms: Sequence[SizedNumber]) -> SizedNumber:
    values = _alike(*(term.value for term in terms))
    sizes = _alike(*(term.size for term in terms))
    return SizedNumber(sum(values[1:], values[0]), sum(sizes[1:], sizes[0]))


def _product(factors: Sequence[SizedNumber]) -> SizedNumber:
    value, size = factors[0].value, factors[0].size
    for factor in factors[1:]:
        value, size = _times(value, factor.value), _times(size, factor.size)
    return SizedNumber(value, size)


def _inverse(number: SizedNumber) -> SizedNumber:
    value, size = _alike(number.value, number.size)
    # d(1/x) = −dx/x², so the size is divided by x².
    return SizedNumber(1 / value, size / (value * value))


def _root(number: SizedNumber) -> SizedNumber:
    value, size = _mpf(number.value), _mpf(number.size)
    root = mpmath.sqrt(value)
    # d√x = dx/(2 √x); at zero the root of the size is used.
    return SizedNumber(root, size / abs(root) if root else mpmath.sqrt(size))


class _Sizes(Evaluation[SizedNumber]):
    """Numbers with the sizes of their terms."""

    def _constant(self, number: sp.Expr) -> SizedNumber:
        value = Fraction(str(number))
        return SizedNumber(value, abs(value))

    def _sum(self, formula: sp.Add) -> SizedNumber:
        return _sum(self._parts(formula))

    def _product(self, formula: sp.Mul) -> SizedNumber:
        return _product(self._parts(formula))

    def _power(self, formula: sp.Pow) -> SizedNumber:
        exponent = formula.exp
        if not (exponent.is_Rational and exponent.q in (1, 2)):
            return self._function(formula)
        base = self(formula.base)
        factor = base if exponent.q == 1 else _root(base)
        power = _product([factor] * abs(int(exponent.p)))
        return power if exponent > 0 else _inverse(power)

    def _function(self, formula: sp.Expr) -> SizedNumber:
        parts = self._parts(formula)
        function = mpmath_function(formula.func, len(parts))
        value = mpmath.mpmathify(function(*(_mpf(part.value) for part in parts)))
        # The arguments have no unit, so their own values are their sizes.
        return SizedNumber(value, sum((_mpf(part.size) for part in parts), abs(value)))
