"""Numbers with nested derivatives: dual numbers over any kind of numbers.

A jet has a level, a value and derivatives in numbered directions.  Value and derivatives are plain
numbers or jets of lower levels, so derivatives with respect to different symbols are not confused.
Plain numbers are real balls, residues modulo a prime, or bounds of degrees (see
:mod:`.functions`).
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any, TypeAlias

from flint import arb, fmpq

from .errors import UndefinedError

#: A plain number or a jet.
Number: TypeAlias = Any


class Jet:
    """A value and its derivatives in numbered directions; a missing derivative is zero."""

    __slots__ = ("level", "slopes", "value")

    def __init__(self, level: int, value: Number, slopes: Mapping[int, Number]) -> None:
        self.level, self.value, self.slopes = level, value, slopes


def ball(value: Fraction | int) -> arb:
    """Rational number as a ball."""
    value = Fraction(value)
    return arb(fmpq(value.numerator, value.denominator))


def level_of(a: Number) -> int:
    """Highest level of derivatives in a number."""
    return a.level if isinstance(a, Jet) else 0


def value_of(a: Number, level: int) -> Number:
    """Number without its derivatives of a level."""
    return a.value if isinstance(a, Jet) and a.level == level else a


def slopes_of(a: Number, level: int) -> Mapping[int, Number]:
    """Derivatives of a level."""
    return a.slopes if isinstance(a, Jet) and a.level == level else {}


def add(a: Number, b: Number) -> Number:
    """Sum of two numbers."""
    first, second = level_of(a), level_of(b)
    if first == second == 0:
        return a + b
    if first < second:
        a, b, first, second = b, a, second, first
    if first > second:
        return Jet(first, add(a.value, b), a.slopes)
    slopes = dict(a.slopes)
    for i, slope in b.slopes.items():
        slopes[i] = add(slopes[i], slope) if i in slopes else slope
    return Jet(first, add(a.value, b.value), slopes)


def multiply(a: Number, b: Number) -> Number:
    """Product of two numbers, by (f g)' = f' g + f g'."""
    first, second = level_of(a), level_of(b)
    if first == second == 0:
        return a * b
    if first < second:
        a, b, first, second = b, a, second, first
    if first > second:
        return Jet(first, multiply(a.value, b), multiples(a.slopes, b))
    slopes = multiples(a.slopes, b.value)
    for i, slope in b.slopes.items():
        part = multiply(a.value, slope)
        slopes[i] = add(slopes[i], part) if i in slopes else part
    return Jet(first, multiply(a.value, b.value), slopes)


def multiples(slopes: Mapping[int, Number], factor: Number) -> dict[int, Number]:
    """Derivatives times a factor."""
    return {i: multiply(slope, factor) for i, slope in slopes.items()}


def through(a: Jet, value: Number, derivative: Number) -> Jet:
    """Function of a jet, by the chain rule."""
    return Jet(a.level, value, multiples(a.slopes, derivative))


def inverse(a: Number) -> Number:
    """Reciprocal of a number, by (1/f)' = −f'/f²."""
    if not isinstance(a, Jet):
        if a == 0 or (isinstance(a, arb) and not (a.is_finite() and a != 0)):
            raise UndefinedError("a division by zero")
        return 1 / a
    value = inverse(a.value)
    return through(a, value, multiply(-1, multiply(value, value)))


def integer_power(a: Number, exponent: int) -> Number:
    """Power with an integer exponent, by (fⁿ)' = n fⁿ⁻¹ f'."""
    if exponent < 0:
        return inverse(integer_power(a, -exponent))
    if not isinstance(a, Jet):
        return a**exponent
    if exponent == 0:
        return integer_power(a.value, 0)
    lower = integer_power(a.value, exponent - 1)
    return through(a, multiply(lower, a.value), multiply(exponent, lower))
