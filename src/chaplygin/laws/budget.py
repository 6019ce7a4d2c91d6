"""How much a computation may cost."""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

from .errors import OutOfReachError

__all__ = ["Budget"]

Poly = Any


@dataclass
class Budget:
    """How large polynomials may become and how long the work may take."""

    terms: int = 20_000_000
    deadline: float = float("inf")
    largest: int = 0

    def spend(self, poly: Poly) -> None:
        """Note the size of a polynomial; OutOfReachError when it or the time is too much."""
        size = len(poly)
        self.largest = max(self.largest, size)
        if size > self.terms:
            raise OutOfReachError(
                f"a polynomial of {size:,} terms exceeds the limit of {self.terms:,}"
            )
        if time.monotonic() > self.deadline:
            raise OutOfReachError(f"the time given ran out at a polynomial of {size:,} terms")

    def foresee(self, first: Poly, second: Poly) -> None:
        """Refuse a product that would not fit into memory."""
        pairs = len(first) * len(second)
        if pairs > 200 * self.terms:
            raise OutOfReachError(
                f"a product of polynomials with {len(first):,} and {len(second):,} terms exceeds "
                f"the limit of {self.terms:,} terms"
            )
