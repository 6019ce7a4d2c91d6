"""Functions of real balls; a statement about a ball is valid for every real number in it.

If a ball does not decide whether an operation is defined, the result is treated as undefined.
"""

from __future__ import annotations

import random
from collections.abc import Sequence
from fractions import Fraction

from flint import arb, fmpq

from .errors import UndefinedError
from .functions import Functions
from .jets import Number

#: Limit on numerator and denominator of an exponent; powers beyond it use a logarithm.
LARGEST = 10_000


def ball(value: Fraction | int) -> arb:
    """Rational number as a ball."""
    value = Fraction(value)
    return arb(fmpq(value.numerator, value.denominator))


class RealFunctions(Functions):
    """Functions at one real point.

    An unspecified smooth function may have any values and derivatives at finitely many different
    arguments.  So every value is chosen freely, but it is the same for equal arguments.

    Parameters
    ----------
    seed : str
        The values are the same for the same seed and the same order of calls.
    """

    def __init__(self, seed: str) -> None:
        self._generator = random.Random(seed)
        self._values: dict[tuple[str, tuple[int, ...]], list[tuple[tuple[arb, ...], arb]]] = {}

    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[arb], value: arb
    ) -> None:
        """Set a value that is determined by others."""
        self._values.setdefault((word, tuple(orders)), []).append((tuple(arguments), value))

    def number(self, value: Fraction) -> Number:
        """Rational number as a ball."""
        return ball(value)

    def constant(self, word: str) -> Number:
        """The number ``pi``."""
        return arb.pi()

    def is_nonzero(self, a: Number) -> bool:
        """True if a ball does not contain zero."""
        return not a.contains(0)

    def plain_root(self, a: Number, exponent: Fraction) -> Number:
        """Power of a positive number with a fractional exponent."""
        if not a > 0:
            raise UndefinedError("a root of a number that is not positive")
        if max(abs(exponent.numerator), exponent.denominator) > LARGEST:
            return self.plain_power(a, ball(exponent))
        return a.root(exponent.denominator) ** exponent.numerator

    def plain_power(self, a: Number, exponent: Number) -> Number:
        """Power of a positive number."""
        return (exponent * self.plain_value("log", (a,))).exp()

    def plain_value(self, word: str, arguments: tuple[Number, ...]) -> Number:
        """Value of a known function."""
        if word == "atan2":
            y, x = arguments
            if not (x > 0 or y > 0 or y < 0):
                raise UndefinedError("atan2 where it jumps")
            return arb.atan2(y, x)
        (a,) = arguments
        if word == "log" and not a > 0:
            raise UndefinedError("a logarithm of a number that is not positive")
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
        """Value of a derivative of an unspecified function."""
        table = self._values.setdefault((word, orders), [])
        for known, value in table:
            # Arguments that cannot be distinguished may be equal, and must have the same value
            # then.
            if all(a.overlaps(b) for a, b in zip(known, arguments, strict=True)):
                return value
        size = 2 ** self._generator.randint(16, 28)
        chosen = arb(self._generator.randint(-(2**24), 2**24)) / size
        table.append((arguments, chosen))
        return chosen
