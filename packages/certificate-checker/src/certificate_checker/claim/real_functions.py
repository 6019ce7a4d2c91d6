"""Functions of real balls: a certain statement about a ball holds for every real number in it.

If a ball does not decide whether an operation is defined, the result counts as undefined.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction

from flint import arb, fmpq

from .errors import UndefinedError
from .functions import Functions
from .jets import Number

#: Limit on the numbers in an exponent, above which powers are computed by a logarithm.
LARGEST = 10_000


def ball(value: Fraction | int) -> arb:
    """A rational number as a ball."""
    value = Fraction(value)
    return arb(fmpq(value.numerator, value.denominator))


class RealFunctions(Functions):
    """Functions at one real point.

    An unspecified smooth function may have any values and derivatives at finitely many different
    arguments, so each is chosen freely, but equal where all arguments agree.

    Parameters
    ----------
    seed : str
        The choice is the same for the same seed and the same order of questions.
    """

    def __init__(self, seed: str) -> None:
        self._generator = random.Random(seed)
        self._values: dict[tuple[str, tuple[int, ...]], list[tuple[tuple[arb, ...], arb]]] = {}

    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[arb], value: arb
    ) -> None:
        """Set a value that is determined by the others."""
        self._values.setdefault((word, tuple(orders)), []).append((tuple(arguments), value))

    def number(self, value: Fraction) -> Number:
        """A rational number."""
        return ball(value)

    def constant(self, word: str) -> Number:
        """The number ``pi``."""
        return arb.pi()

    def is_nonzero(self, a: Number) -> bool:
        """Whether a ball does not contain zero."""
        return not a.contains(0)

    def plain_root(self, a: Number, exponent: Fraction) -> Number:
        """A power of a positive number with a fractional exponent."""
        if not a > 0:
            raise UndefinedError("a root of what is not positive")
        if max(abs(exponent.numerator), exponent.denominator) > LARGEST:
            return self.plain_power(a, ball(exponent))
        return a.root(exponent.denominator) ** exponent.numerator

    def plain_power(self, a: Number, exponent: Number) -> Number:
        """A power of a positive number."""
        return (exponent * self.plain_value("log", (a,))).exp()

    def plain_value(self, word: str, arguments: tuple[Number, ...]) -> Number:
        """The value of a known function."""
        if word == "atan2":
            y, x = arguments
            if not (x > 0 or y > 0 or y < 0):
                raise UndefinedError("atan2 where it jumps")
            return arb.atan2(y, x)
        (a,) = arguments
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

    def plain_unspecified(
        self, word: str, orders: tuple[int, ...], arguments: tuple[Number, ...]
    ) -> Number:
        """A value of a derivative of an unspecified function."""
        table = self._values.setdefault((word, orders), [])
        for known, value in table:
            if all(a.overlaps(b) for a, b in zip(known, arguments, strict=True)):
                return value
        size = 2 ** self._generator.randint(16, 28)
        chosen = arb(self._generator.randint(-(2**24), 2**24)) / size
        table.append((arguments, chosen))
        return chosen
