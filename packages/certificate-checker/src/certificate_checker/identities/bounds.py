"""Bounds of degrees and coefficients of formulas, propagated through operations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction

from ..claim.errors import CheckError
from ..claim.jets import Number
from ..modular.small_relations import LARGEST
from .generator_functions import Auxiliary, GeneratorFunctions

#: The binary logarithm of the largest bound.
MANY = 4000


class Bound:
    """A bound of a quotient of polynomials with integer coefficients.

    Attributes
    ----------
    degree : int
        Of numerator and denominator.
    height : int
        Binary logarithm of the sum of the absolute values of the coefficients, of both.
    """

    __slots__ = ("degree", "height")

    def __init__(self, degree: int, height: int) -> None:
        self.degree, self.height = degree, height

    def __add__(self, other: Bound | int) -> Bound:
        if isinstance(other, int):
            return Bound(self.degree, self.height + other.bit_length() + 1)
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
    """Functions of bounds; every expression is bounded by the largest such product.

    Parameters
    ----------
    size : int
        Number of generators.
    auxiliary : sequence of Auxiliary
    products : iterable of (number, powers)
        What radicands are products of.
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
        """A rational number."""
        return Bound(0, max(value.numerator.bit_length(), value.denominator.bit_length()))

    def free(self, word: str) -> Number:
        """A variable."""
        return Bound(1, 1)

    def constant(self, word: str) -> Number:
        """A variable."""
        return Bound(1, 1)

    def is_nonzero(self, a: Number) -> bool:
        """Nothing is known to be zero."""
        return True

    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[Number], value: Number
    ) -> None:
        """The value of an unspecified function is not larger than a variable."""

    def new_root(self, symbol: Auxiliary, radicand: Number, whole: Number) -> Number:
        """A variable."""
        self.radicands.append(radicand)
        return self._with_note((radicand, whole), Bound(1, 1))

    def new_power(self, symbol: Auxiliary, base: Number, exponent: Callable[[], Number]) -> Number:
        """A variable."""
        return self._with_note((base, exponent()), Bound(1, 1))

    def plain_root(self, a: Number, exponent: Fraction) -> Number:
        """A product of roots."""
        return self._with_note((a,), self._whole ** (abs(exponent.numerator) + 1))

    def plain_power(self, a: Number, exponent: Number) -> Number:
        """A product of powers."""
        return self._with_note((a, exponent), self._whole)

    def plain_value(self, word: str, arguments: tuple[Number, ...]) -> Number:
        """A variable, or an expression in those of multiples of other arguments."""
        return self._with_note(arguments, self._whole**2)

    def plain_unspecified(
        self, word: str, orders: tuple[int, ...], arguments: tuple[Number, ...]
    ) -> Number:
        """A variable."""
        return self._with_note(arguments, Bound(1, 1))
