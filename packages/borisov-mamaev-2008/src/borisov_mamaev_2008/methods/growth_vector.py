"""The span of vector fields and their commutators, and verdicts on claims about its dimension."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import sympy as sp

from lawproof.proof.verdict import Verdict
from nonholonomic.mechanics.constraints import growth as mechanics
from nonholonomic.mechanics.lagrangian.structure_functions import VectorField


def growth(
    fields: Sequence[VectorField],
    coordinates: Sequence[sp.Symbol],
    point: Mapping[sp.Symbol, sp.Expr],
) -> tuple[int, ...]:
    """The growth vector of a distribution, with its last entry repeated."""
    counts = mechanics.growth(fields, coordinates, point)
    return (*counts, counts[-1])


def holonomic_count_verdict(claim: int, counts: tuple[int, ...], dimension: int) -> Verdict:
    """The verdict on a claimed number of holonomic constraints.

    A function F with η(F) = 0 for every admissible field η has a differential that annihilates the
    commutators as well. The number of independent functions of this kind is therefore the
    dimension minus the dimension of the span.

    Parameters
    ----------
    claim : int
        The claimed number of independent holonomic constraints.
    counts : tuple of int
        The growth vector, as returned by `growth`.
    dimension : int
        Dimension of the configuration space.
    """
    true = dimension - counts[-1]
    return Verdict(
        "holonomic_constraints",
        "proven" if claim == true else "refuted",
        finding=f"the span grows as {', '.join(map(str, counts))} in dimension {dimension}: "
        f"{true} holonomic constraints",
        witness=None if claim == true else {"claimed": claim, "true": true},
    )
