"""Bounds of degrees and coefficients of formulas, propagated through operations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction

from ..claim.errors import CheckError
from ..claim.jets import Number
from ..modular.small_relations import LARGEST
from .generator_functions import Auxiliary, GeneratorFunctions

#: Binary logarithm of the largest bound.
MANY = 4000


class Bound:
    """Bound of a quotient of polynomials with integer coefficients.

    Attributes
    ----------
    degree : int
        Degree of numerator and denominator.
    height : int
        Binary logarithm of the sum of the absolute values of the coefficients, for both.
    """

    __slots__ = ("degree", "height")

    def __init__(self, degree: int, height: int) -> None:
        self.degree, self.height = degree, height

    def __add__(self, other: Bound | int) -> Bound:
        if isinstance(other, int):
            return Bound(self.degree, self.height + other.bit_length() + 1)
        # a/b + c/d = (a d + c b)/(b d): degrees add, and the sum of two terms doubles the height
        # at most.
        return Bound(self.degree + other.degree, self.height + other.height + 1)

    def __mul__(self, other: Bound | int) -> Bound:
        if isinstance(other, int):
            return Bound(self.degree, self.height + other.bit_length())
        return Bound(self.degree + other.degree, self.height + other.height)

    def __pow__(self, exponent: int) -> Bound:
        return Bound(abs(exponent) * self.degree, abs(exponent) * self.height)

    def __rtruediv__(self, other: int) -> Bound:
        return self * other

    def __neg__(self) -> Bound:
        return self

    __radd__ = __sub__ = __rsub__ = __add__
    __rmul__ = __truediv__ = __mul__


class Bounds(GeneratorFunctions):
    """Functions of bounds; every value is bounded by the largest possible product of powers.

    Parameters
    ----------
    size : int
        Number of generators.
    auxiliary : sequence of Auxiliary
    products : iterable of (number, powers)
        Products that are equal to radicands.
    """

    def __init__(
        self,
        size: int,
        auxiliary: Sequence[Auxiliary],
        products: Iterable[tuple[Fraction, Sequence[tuple[Bound, int]]]],
    ) -> None:
        self.degree, self.height = 1, 1
        self.radicands: list[Bound] = []
        self.logarithms_of_numbers: list[Auxiliary] = []
        self.values: list[Number] = [Bound(1, 1)] * size
        # No more than LARGEST multiples of each auxiliary symbol are combined (see
        # :mod:`.modular.small_relations`).
        whole = Bound(2, 2) ** (2 * LARGEST * (len(auxiliary) + 4))
        for content, powers in products:
            value = self.number(content) * whole
            for factor, power in powers:
                value = value * factor**power
            whole = Bound(max(whole.degree, value.degree), max(whole.height, value.height))
        self._whole = whole

    def note(self, value: Number) -> None:
        """Record a value that is compared with another."""
        self.degree = max(self.degree, value.degree)
        self.height = max(self.height, value.height)
        if max(self.degree.bit_length(), self.height.bit_length()) > MANY:
            raise CheckError("the formulas are of too high a degree")

    def _with_note(self, arguments: Iterable[Number], value: Bound) -> Bound:
        for argument in arguments:
            self.note(argument)
        return value

    def number(self, value: Fraction) -> Number:
        """Bound of a rational number."""
        return Bound(0, max(value.numerator.bit_length(), value.denominator.bit_length()))

    def free(self, word: str) -> Number:
        """Bound of a variable."""
        return Bound(1, 1)

    def constant(self, word: str) -> Number:
        """Bound of a variable."""
        return Bound(1, 1)

    def is_nonzero(self, a: Number) -> bool:
        """True, because no bound is known to be zero."""
        return True

    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[Number], value: Number
    ) -> None:
        """Do nothing: the value of an unspecified function is not larger than a variable."""

    def new_root(self, symbol: Auxiliary, radicand: Number, whole: Number) -> Number:
        """Bound of a variable; the radicand is recorded."""
        self.radicands.append(radicand)
        return self._with_note((radicand, whole), Bound(1, 1))

    def new_power(self, symbol: Auxiliary, base: Number, exponent: Callable[[], Number]) -> Number:
        """Bound of a variable; base and exponent are recorded."""
        return self._with_note((base, exponent()), Bound(1, 1))

    def plain_root(self, a: Number, exponent: Fraction) -> Number:
        """Bound of a product of roots."""
        return self._with_note((a,), self._whole ** (abs(exponent.numerator) + 1))

    def plain_power(self, a: Number, exponent: Number) -> Number:
        """Bound of a product of powers."""
        return self._with_note((a, exponent), self._whole)

    def plain_value(self, word: str, arguments: tuple[Number, ...]) -> Number:
        """Bound of a variable, or of an expression in the values for other arguments."""
        return self._with_note(arguments, self._whole**2)

    def plain_unspecified(
        self, word: str, orders: tuple[int, ...], arguments: tuple[Number, ...]
    ) -> Number:
        """Bound of a variable."""
        return self._with_note(arguments, Bound(1, 1))
