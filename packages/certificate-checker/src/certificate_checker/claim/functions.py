"""Functions of numbers with derivatives: roots, known functions, unspecified functions.

The rules of differentiation are the same for all kinds of numbers; the values are not.  In real
balls the value is that of the function (:class:`.real_functions.RealFunctions`).  Modulo a prime,
where a root or a sine has no meaning, it is the value of the generator that represents it in the
proof.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from .jets import (
    Jet,
    Number,
    add,
    integer_power,
    inverse,
    level_of,
    multiples,
    multiply,
    slopes_of,
    through,
    value_of,
)

HALF = Fraction(1, 2)


class Functions(ABC):
    """Functions at one point, for numbers of one kind."""

    @abstractmethod
    def number(self, value: Fraction) -> Number:
        """Rational number as a number of this kind."""

    @abstractmethod
    def constant(self, word: str) -> Number:
        """The number ``pi``."""

    @abstractmethod
    def is_nonzero(self, a: Number) -> bool:
        """True if a number without derivatives is certainly nonzero."""

    @abstractmethod
    def plain_root(self, a: Number, exponent: Fraction) -> Number:
        """Power of a positive number with a fractional exponent."""

    @abstractmethod
    def plain_power(self, a: Number, exponent: Number) -> Number:
        """Power of a positive number."""

    @abstractmethod
    def plain_value(self, word: str, arguments: tuple[Number, ...]) -> Number:
        """Value of a known function or of ``sign``."""

    @abstractmethod
    def plain_unspecified(
        self, word: str, orders: tuple[int, ...], arguments: tuple[Number, ...]
    ) -> Number:
        """Value of a derivative of an unspecified function."""

    def rational_power(self, a: Number, exponent: Fraction) -> Number:
        """Power of a positive number with a rational exponent."""
        if exponent.denominator == 1:
            return integer_power(a, int(exponent))
        if not isinstance(a, Jet):
            return self.plain_root(a, exponent)
        slope = multiply(self.number(exponent), self.rational_power(a.value, exponent - 1))
        return through(a, self.rational_power(a.value, exponent), slope)

    def general_power(self, a: Number, exponent: Number) -> Number:
        """Power of a positive number: (aⁿ)' = aⁿ (n a'/a + n' log a)."""
        level = max(level_of(a), level_of(exponent))
        if level == 0:
            return self.plain_power(a, exponent)
        base, inner = value_of(a, level), value_of(exponent, level)
        value = self.general_power(base, inner)
        factor = multiply(value, multiply(inner, inverse(base)))
        slopes = multiples(slopes_of(a, level), factor)
        changes = slopes_of(exponent, level)
        if changes:
            slopes = _sum_of(slopes, multiples(changes, multiply(value, self.value("log", base))))
        return Jet(level, value, slopes)

    def value(self, word: str, a: Number) -> Number:
        """Known function of one number."""
        if not isinstance(a, Jet):
            return self.plain_value(word, (a,))
        return through(a, self.value(word, a.value), _DERIVATIVES[word](self, a.value))

    def arctangent(self, y: Number, x: Number) -> Number:
        """Angle of the point (x, y), away from the half-line where it jumps."""
        level = max(level_of(y), level_of(x))
        if level == 0:
            return self.plain_value("atan2", (y, x))
        upper, lower = value_of(y, level), value_of(x, level)
        # d atan2(y, x) = (x dy − y dx)/(x² + y²)
        below = inverse(add(multiply(lower, lower), multiply(upper, upper)))
        slopes = multiples(slopes_of(y, level), multiply(lower, below))
        factor = multiply(-1, multiply(upper, below))
        slopes = _sum_of(slopes, multiples(slopes_of(x, level), factor))
        return Jet(level, self.arctangent(upper, lower), slopes)

    def unspecified(
        self, word: str, orders: tuple[int, ...], arguments: Sequence[Number]
    ) -> Number:
        """Value of an unspecified function, differentiated by the chain rule."""
        level = max((level_of(p) for p in arguments), default=0)
        if level == 0:
            return self.plain_unspecified(word, orders, tuple(arguments))
        lower = [value_of(p, level) for p in arguments]
        slopes: dict[int, Number] = {}
        for i, argument in enumerate(arguments):
            if not slopes_of(argument, level):
                continue
            raised = tuple(n + (i == j) for j, n in enumerate(orders))
            partial = self.unspecified(word, raised, lower)
            slopes = _sum_of(slopes, multiples(slopes_of(argument, level), partial))
        return Jet(level, self.unspecified(word, orders, lower), slopes)


def _sum_of(first: Mapping[int, Number], second: Mapping[int, Number]) -> dict[int, Number]:
    slopes = dict(first)
    for i, slope in second.items():
        slopes[i] = add(slopes[i], slope) if i in slopes else slope
    return slopes


def _arcsine_slope(functions: Functions, a: Number) -> Number:
    square = add(functions.number(Fraction(1)), multiply(-1, multiply(a, a)))
    return functions.rational_power(square, -HALF)


_DERIVATIVES: dict[str, Callable[[Functions, Number], Number]] = {
    "exp": lambda functions, a: functions.value("exp", a),
    "log": lambda functions, a: inverse(a),
    "sin": lambda functions, a: functions.value("cos", a),
    "cos": lambda functions, a: multiply(-1, functions.value("sin", a)),
    "sinh": lambda functions, a: functions.value("cosh", a),
    "cosh": lambda functions, a: functions.value("sinh", a),
    "asin": _arcsine_slope,
    "acos": lambda functions, a: multiply(-1, _arcsine_slope(functions, a)),
    "atan": lambda functions, a: inverse(add(functions.number(Fraction(1)), multiply(a, a))),
    "Abs": lambda functions, a: functions.value("sign", a),
    "sign": lambda functions, a: functions.number(Fraction(0)),
}
