"""Ranks at a point: a map that loses dimensions is no isomorphism, a bracket has the rank said."""

from __future__ import annotations

from collections.abc import Sequence
from functools import singledispatch
from typing import Any

import sympy as sp

from ..statements import ConformallyHamiltonian, Isomorphism, Law, PoissonStructure
from .errors import OutOfReachError
from .ground import Ground
from .residuals import components

__all__ = ["rank", "shortfall"]


def rank(field: Any, matrix: Sequence[Sequence[Any]]) -> int:
    """Rank of a matrix of numbers; with balls, the rank that is certain."""
    rows = [list(row) for row in matrix]
    found = 0
    for column in range(len(rows[0]) if rows else 0):
        candidates = [i for i in range(found, len(rows)) if not field.vanishes(rows[i][column])]
        if not candidates:
            continue
        rows[found], rows[candidates[0]] = rows[candidates[0]], rows[found]
        head = rows[found]
        for i in range(found + 1, len(rows)):
            factor = rows[i][column] / head[column]
            rows[i] = [x - factor * y for x, y in zip(rows[i], head, strict=True)]
        found += 1
    return found


@singledispatch
def shortfall(law: Law, ground: Ground, field: Any) -> tuple[str, Any] | None:
    """What a law lacks in rank at a point, or None."""
    return None


@shortfall.register
def _(law: PoissonStructure, ground: Ground, field: Any) -> tuple[str, Any] | None:
    if law.rank is None:
        return None
    plain = ground.evaluator(field)
    size = len(ground.system.symbols)
    matrix = [[plain.value(law.matrix[i, j]) for j in range(size)] for i in range(size)]
    found = rank(field, matrix)
    return _lacking("the rank of the bracket", found, law.rank, field)


@shortfall.register
def _(law: ConformallyHamiltonian, ground: Ground, field: Any) -> tuple[str, Any] | None:
    return shortfall(law.structure, ground, field)


@shortfall.register
def _(law: Isomorphism, ground: Ground, field: Any) -> tuple[str, Any] | None:
    """The map must not lose dimensions of the phase space."""
    partial = ground.partial(field)
    size = len(ground.system.symbols)

    def row(formula: sp.Expr) -> list[Any]:
        slopes = partial(formula).slopes
        return [slopes.get(i, field.zero) for i in range(size)]

    conditions = [row(c) for c in ground.moving]
    images = [row(f) for f in components((*law.map, *law.constants), ground).values()]
    total = rank(field, [*conditions, *images])
    return _lacking("the rank of the map with the conditions", total, size, field)


def _lacking(what: str, found: int, wanted: int, field: Any) -> tuple[str, Any] | None:
    if found >= wanted:
        return None
    if not field.exact:
        raise OutOfReachError(f"{what} is at least {found}, but {wanted} is not certain with balls")
    return what, f"{found} instead of {wanted}"
