"""The cost of a computation, counted alike on every machine.

The unit is a term operation: about one product of a term by a term.  A present-day core does ten
million of them in a second.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from flint import fmpq_mpoly

from flowlanes.errors import InputError
from flowlanes.formulas.errors import EffortSpentError, OutOfReachError

Poly: TypeAlias = fmpq_mpoly

EFFORT = 2_000_000_000
"""Term operations that one proof may take, by default: some minutes of one core."""
STEP = 200
"""The cost of a step besides its terms, in term operations."""


def checked_effort(effort: int) -> int:
    """An effort that a user gives, which must be positive.

    Raises
    ------
    InputError
    """
    if not effort > 0:
        raise InputError(f"effort = {effort:g}: it must be a positive number of term operations")
    return effort


def budget_message(effort: int) -> str:
    """The error for an effort that was too small."""
    return f"not decided with an effort of {effort:,} term operations"


@dataclass
class Budget:
    """Limits of the size of polynomials and of the number of operations.

    Parameters
    ----------
    effort : int
        Term operations allowed.
    terms : int
        Terms that a polynomial may have.
    used : int
        Term operations done so far.
    largest : int
        Terms of the largest polynomial so far.
    """

    effort: int = EFFORT
    terms: int = 20_000_000
    used: int = 0
    largest: int = 0

    def charge(self, operations: int) -> None:
        """Count term operations; EffortSpentError when they are more than are left."""
        if operations > self.effort - self.used:
            self.used = self.effort
            raise EffortSpentError(budget_message(self.effort))
        self.used += operations

    def spend(self, poly: Poly) -> None:
        """Note a polynomial that was made; OutOfReachError when it is too large."""
        size = len(poly)
        self.largest = max(self.largest, size)
        if size > self.terms:
            raise OutOfReachError(
                f"a polynomial of {size:,} terms exceeds the limit of {self.terms:,}"
            )
        self.charge(size + STEP)

    def foresee(self, first: Poly, second: Poly) -> None:
        """Count a product before it is made; OutOfReachError when it would be too large."""
        pairs = len(first) * len(second)
        if pairs > 200 * self.terms:
            raise OutOfReachError(
                f"a product of polynomials with {len(first):,} and {len(second):,} terms exceeds "
                f"the limit of {self.terms:,} terms"
            )
        self.charge(pairs + STEP)
