"""Numbers with derivatives, nested as deep as needed: dual numbers over real balls.

A jet has a level, a value and slopes in numbered directions; value and slopes are balls or jets of
lower levels, so that derivatives of derivatives do not mix.  A statement that is certain for a ball
holds for every real number in it; where a ball does not settle whether an operation is defined, it
counts as undefined.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, TypeAlias

from flint import arb, fmpq

from .errors import UndefinedError

#: A ball or a jet.
Number: TypeAlias = Any


class Jet:
    """A value and its derivatives in numbered directions; a missing one is zero."""

    __slots__ = ("level", "slopes", "value")

    def __init__(self, level: int, value: Number, slopes: Mapping[int, Number]) -> None:
        self.level, self.value, self.slopes = level, value, slopes


def ball(value: Fraction | int) -> arb:
    """A rational number as a ball."""
    value = Fraction(value)
    return arb(fmpq(value.numerator, value.denominator))


def _level(a: Number) -> int:
    return a.level if isinstance(a, Jet) else 0


def value_of(a: Number, level: int) -> Number:
    """The value of a number without its derivatives of a level."""
    return a.value if isinstance(a, Jet) and a.level == level else a


def slopes_of(a: Number, level: int) -> Mapping[int, Number]:
    """The derivatives of a level."""
    return a.slopes if isinstance(a, Jet) and a.level == level else {}


def add(a: Number, b: Number) -> Number:
    """A sum."""
    first, second = _level(a), _level(b)
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
    """A product."""
    first, second = _level(a), _level(b)
    if first == second == 0:
        return a * b
    if first < second:
        a, b, first, second = b, a, second, first
    if first > second:
        return Jet(first, multiply(a.value, b), _multiples(a.slopes, b))
    slopes = _multiples(a.slopes, b.value)
    for i, slope in b.slopes.items():
        part = multiply(a.value, slope)
        slopes[i] = add(slopes[i], part) if i in slopes else part
    return Jet(first, multiply(a.value, b.value), slopes)


def _multiples(slopes: Mapping[int, Number], factor: Number) -> dict[int, Number]:
    return {i: multiply(slope, factor) for i, slope in slopes.items()}


def _through(a: Jet, value: Number, derivative: Number) -> Jet:
    return Jet(a.level, value, _multiples(a.slopes, derivative))


def inverse(a: Number) -> Number:
    """A reciprocal."""
    if not isinstance(a, Jet):
        if not a.is_finite() or a.contains(0):
            raise UndefinedError("a division by zero")
        return 1 / a
    value = inverse(a.value)
    return _through(a, value, multiply(arb(-1), multiply(value, value)))


def integer_power(a: Number, exponent: int) -> Number:
    """A power with an integer exponent."""
    if exponent < 0:
        return inverse(integer_power(a, -exponent))
    if not isinstance(a, Jet):
        return a**exponent
    if exponent == 0:
        return arb(1)
    lower = integer_power(a.value, exponent - 1)
    return _through(a, multiply(lower, a.value), multiply(arb(exponent), lower))


def rational_power(a: Number, exponent: Fraction) -> Number:
    """A power of a positive number with a rational exponent."""
    if exponent.denominator == 1:
        return integer_power(a, int(exponent))
    if not isinstance(a, Jet):
        if not a > 0:
            raise UndefinedError("a root of what is not positive")
        return a.root(exponent.denominator) ** exponent.numerator
    derivative = multiply(ball(exponent), rational_power(a.value, exponent - 1))
    return _through(a, rational_power(a.value, exponent), derivative)


def general_power(a: Number, exponent: Number) -> Number:
    """A power of a positive number."""
    return apply("exp", multiply(exponent, apply("log", a)))


def apply(word: str, a: Number) -> Number:
    """A known function of one number."""
    if isinstance(a, Jet):
        return _through(a, apply(word, a.value), _DERIVATIVES[word](a.value))
    if word == "log" and not a > 0:
        raise UndefinedError("a logarithm of what is not positive")
    if word in ("asin", "acos") and not abs(a) < 1:
        raise UndefinedError(f"{word} outside -1 to 1")
    if word == "sign":
        if a.contains(0):
            raise UndefinedError("an absolute value at zero")
        return arb(1) if a > 0 else arb(-1)
    value = abs(a) if word == "Abs" else getattr(a, word)()
    if not value.is_finite():
        raise UndefinedError(f"{word} where it is not finite")
    return value


def _one_less_square(a: Number) -> Number:
    return add(arb(1), multiply(arb(-1), multiply(a, a)))


_DERIVATIVES: dict[str, Callable[[Number], Number]] = {
    "exp": lambda a: apply("exp", a),
    "log": inverse,
    "sin": lambda a: apply("cos", a),
    "cos": lambda a: multiply(arb(-1), apply("sin", a)),
    "sinh": lambda a: apply("cosh", a),
    "cosh": lambda a: apply("sinh", a),
    "asin": lambda a: rational_power(_one_less_square(a), Fraction(-1, 2)),
    "acos": lambda a: multiply(arb(-1), rational_power(_one_less_square(a), Fraction(-1, 2))),
    "atan": lambda a: inverse(add(arb(1), multiply(a, a))),
    "Abs": lambda a: apply("sign", a),
    "sign": lambda a: arb(0),
}


def arctangent(y: Number, x: Number) -> Number:
    """The angle of the point (x, y), away from the half-line where it jumps."""
    level = max(_level(y), _level(x))
    if level == 0:
        if not (x > 0 or y > 0 or y < 0):
            raise UndefinedError("atan2 where it jumps")
        return arb.atan2(y, x)
    upper, lower = value_of(y, level), value_of(x, level)
    below = inverse(add(multiply(lower, lower), multiply(upper, upper)))
    slopes = _multiples(slopes_of(y, level), multiply(lower, below))
    factor = multiply(arb(-1), multiply(upper, below))
    for i, slope in _multiples(slopes_of(x, level), factor).items():
        slopes[i] = add(slopes[i], slope) if i in slopes else slope
    return Jet(level, arctangent(upper, lower), slopes)
