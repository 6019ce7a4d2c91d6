"""The cost of a computation, counted in machine-independent units.

The unit is one term operation, roughly the product of two terms. A current core does about ten
million of them per second.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias

from flint import fmpq_mpoly

from flowlanes.errors import InputError
from flowlanes.formulas.errors import EffortSpentError, OutOfReachError

Poly: TypeAlias = fmpq_mpoly

EFFORT = 2_000_000_000
"""Default number of term operations for one proof: a few minutes on one core."""
STEP = 200
"""Fixed cost of an operation, in term operations."""


def checked_effort(effort: int) -> int:
    """An effort given by a user, checked to be positive.

    Raises
    ------
    InputError
    """
    if not effort > 0:
        raise InputError(f"effort = {effort:g}: it must be a positive number of term operations")
    return effort


def budget_message(effort: int) -> str:
    """The message for an effort that was too small."""
    return f"not decided with an effort of {effort:,} term operations"


@dataclass
class Budget:
    """Limits on the size of polynomials and on the number of operations.

    Parameters
    ----------
    effort : int
        Maximum number of term operations.
    terms : int
        Maximum number of terms of a polynomial.
    used : int
        Term operations used so far.
    largest : int
        Number of terms of the largest polynomial so far.
    """

    effort: int = EFFORT
    terms: int = 20_000_000
    used: int = 0
    largest: int = 0

    def charge(self, operations: int) -> None:
        """Add term operations; raise EffortSpentError if the effort is exceeded."""
        if operations > self.effort - self.used:
            self.used = self.effort
            raise EffortSpentError(budget_message(self.effort))
        self.used += operations

    def spend(self, poly: Poly) -> None:
        """Charge for a computed polynomial; raise OutOfReachError if it is too large."""
        size = len(poly)
        self.largest = max(self.largest, size)
        if size > self.terms:
            raise OutOfReachError(
                f"a polynomial of {size:,} terms exceeds the limit of {self.terms:,}"
            )
        self.charge(size + STEP)

    def foresee(self, first: Poly, second: Poly) -> None:
        """Charge for a product in advance; raise OutOfReachError if it would be too large."""
        pairs = len(first) * len(second)
        if pairs > 200 * self.terms:
            raise OutOfReachError(
                f"a product of polynomials with {len(first):,} and {len(second):,} terms exceeds "
                f"the limit of {self.terms:,} terms"
            )
        self.charge(pairs + STEP)
