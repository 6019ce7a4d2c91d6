"""A planted kind of law: a Lax pair."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import sympy as sp

from flowlanes.system.laws import Rate, Side, VanishingLaw, VectorField


@dataclass(frozen=True, repr=False)
class LaxPair(VanishingLaw):
    """Matrices L and A on the phase space with dL/dt = [A, L], so that L keeps its spectrum."""

    L: sp.MatrixBase
    A: sp.MatrixBase
    meaning: str = ""

    heading = "Lax pair"

    def __post_init__(self) -> None:
        super().__post_init__()
        for name in ("L", "A"):
            object.__setattr__(self, name, sp.ImmutableDenseMatrix(getattr(self, name)))

    def residuals(self, system: VectorField) -> Mapping[str, sp.Basic]:
        """dL/dt − [A, L]."""
        return {"L": self.L.applyfunc(Rate) - (self.A * self.L - self.L * self.A)}

    def sides(self) -> tuple[tuple[Side, Side], ...]:
        """The matrices, and the equation."""
        return ("L", self.L), ("A", self.A), ("dL/dt", "A L - L A")
