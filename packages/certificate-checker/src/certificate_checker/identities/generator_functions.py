"""Functions at a point that is given by the generators of a proof."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from ..claim.formulas import Formula
from ..claim.functions import Functions
from ..claim.jets import Number
from ..claim.polynomials import Poly, Powers


@dataclass(frozen=True)
class Auxiliary:
    """Meaning of an auxiliary symbol.

    A *formal root* is the root of inner · ∏ whole^(power · degree), divided by ∏ whole^power.  Its
    power is `inner` for any signs of the factors; its own sign is not determined.
    """

    name: str
    kind: str
    word: str
    number: int
    orders: tuple[int, ...]
    exponent: Formula | None
    of: tuple[tuple[Poly, Powers], ...]
    whole: Powers

    @property
    def positive(self) -> bool:
        """True if the symbol is positive wherever it is defined."""
        return self.kind in ("root", "power", "pi") or self.word == "exp"

    @property
    def radicand(self) -> tuple[Poly, Powers]:
        """Radicand in the law; for a formal root, including the factors outside the root."""
        return self.of[0][0], [(poly, power * self.number) for poly, power in self.whole]


class GeneratorFunctions(Functions):
    """Functions whose values are given by generators.

    Attributes
    ----------
    values : list of numbers
        Values of the generators of a ring.
    logarithms_of_numbers : list of Auxiliary
    """

    values: list[Number]
    logarithms_of_numbers: list[Auxiliary]

    @abstractmethod
    def free(self, word: str) -> Number:
        """Value that is not determined by others."""

    @abstractmethod
    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[Number], value: Number
    ) -> None:
        """Set a value of an unspecified function that is determined by others."""

    @abstractmethod
    def new_root(self, symbol: Auxiliary, radicand: Number, whole: Number) -> Number:
        """Value of a root, or of a formal root with the factor `whole` outside."""

    @abstractmethod
    def new_power(self, symbol: Auxiliary, base: Number, exponent: Callable[[], Number]) -> Number:
        """Value of a symbolic power."""
