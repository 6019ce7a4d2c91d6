"""The Frobenius criterion of integrability, verified as an identity."""

from __future__ import annotations

from itertools import combinations

import sympy as sp

from flowlanes.system.named_formulas import expand

from ..lagrangian.structure_functions import VectorField, commutator
from .distribution import Distribution
from .zero_test import vanishes


def involutive(distribution: Distribution) -> bool:
    """Whether all commutators of admissible fields are combinations of these fields.

    False also if this is not shown: if the frame was reduced by a group, or if some field has no
    coordinate that moves with it alone.
    """
    if distribution.structure is not None:
        return False
    fields = [
        {q: expand(v, distribution.steps) for q, v in field.items()}
        for field in distribution.fields
    ]
    own = [_own(fields, i) for i, _ in enumerate(fields)]
    free = [q for q in own if q is not None]
    return len(free) == len(fields) and all(
        _combination(commutator(u, w), fields, free, distribution)
        for u, w in combinations(fields, 2)
    )


def _own(fields: list[dict[sp.Symbol, sp.Expr]], index: int) -> sp.Symbol | None:
    """A coordinate that moves along one field only, with rate 1."""
    others = [field for i, field in enumerate(fields) if i != index]
    for q, value in fields[index].items():
        if value == 1 and not any(q in field for field in others):
            return q
    return None


def _combination(
    bracket: VectorField,
    fields: list[dict[sp.Symbol, sp.Expr]],
    free: list[sp.Symbol],
    distribution: Distribution,
) -> bool:
    # η_i(q_j) = δ_ij for the coordinates q_j in `free`, which move with one field only, so that the
    # factors of a combination are the components of the bracket along q_j
    factors = [bracket.get(q, sp.S.Zero) for q in free]
    return all(
        vanishes(
            bracket.get(q, sp.S.Zero)
            - sp.Add(*(c * f.get(q, sp.S.Zero) for c, f in zip(factors, fields, strict=True))),
            distribution.relations,
        )
        for q in distribution.coordinates
    )
