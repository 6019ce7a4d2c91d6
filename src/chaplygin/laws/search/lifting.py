"""From solutions modulo a prime to formulas in the parameters.

A law is a sum of parts (functions of state and parameters) whose coefficients are polynomials in
the parameters.  Written out in monomials of the parameters its coefficients are plain rational
numbers, the same for all values of the parameters: they solve one linear system whose equations
are taken at points with parameters of their own.  Weights split it into small ones.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement

import numpy as np
import sympy as sp

from .grading import Weight, total
from .linear import independent_columns, nullspace, rational
from .modular import PRIME, Integers

__all__ = ["LARGEST", "Part", "Plan", "Scalars", "Solution", "plan", "points_for", "solutions"]

LARGEST = 1000
"""The largest number of unknowns of one linear system."""
_SPARE = 24


@dataclass(frozen=True)
class Part:
    """A function that may occur in a law, with a coefficient in the parameters.

    Attributes
    ----------
    formula : sympy expression or tuple of them
        What stands behind the coefficient.
    weight : Weight
    effort : int
        How complicated it looks; simple parts are preferred.
    """

    formula: sp.Expr | tuple[tuple[str, sp.Expr], ...]
    weight: Weight
    effort: int


@dataclass(frozen=True)
class Scalars:
    """Quantities made of parameters alone, with their weights."""

    formulas: tuple[sp.Expr, ...]
    weights: tuple[Weight, ...]

    @cached_property
    def efforts(self) -> tuple[int, ...]:
        """How complicated each looks."""
        return tuple(1 + int(sp.count_ops(formula)) for formula in self.formulas)

    def effort(self, chosen: Sequence[int]) -> int:
        """How complicated a product of some of them looks."""
        return sum(1 + self.efforts[i] for i in chosen)


@dataclass(frozen=True)
class Plan:
    """The linear systems to be solved: lists of (index of part, indices of scalars)."""

    blocks: tuple[tuple[tuple[int, tuple[int, ...]], ...], ...]

    @property
    def widest(self) -> int:
        """The largest number of unknowns of a block."""
        return max((len(block) for block in self.blocks), default=0)


@dataclass(frozen=True)
class Solution:
    """A law: rational numbers in front of products of scalars and a part."""

    terms: tuple[tuple[Fraction, tuple[int, ...], int], ...]
    effort: int


def plan(parts: Sequence[Part], scalars: Scalars, degree: int, zero: Weight) -> Plan:
    """Sort products of a part and at most `degree` scalars by their weight."""
    products = [
        (chosen, total(zero, *(scalars.weights[i] for i in chosen)))
        for size in range(degree + 1)
        for chosen in combinations_with_replacement(range(len(scalars.formulas)), size)
    ]
    blocks: dict[Weight, list[tuple[int, tuple[int, ...]]]] = defaultdict(list)
    for index, part in enumerate(parts):
        for chosen, weight in products:
            blocks[total(weight, part.weight)].append((index, chosen))
    ordered = (
        tuple(sorted(block, key=lambda item: parts[item[0]].effort + scalars.effort(item[1])))
        for block in blocks.values()
    )
    return Plan(tuple(block for block in ordered if len(block) <= LARGEST))


def points_for(made: Plan) -> int:
    """How many points a plan needs."""
    return made.widest + _SPARE


def solutions(
    made: Plan,
    parts: Sequence[Part],
    scalars: Scalars,
    value: Integers,
    condition: Integers,
    numbers: Integers,
) -> Iterator[Solution]:
    """Laws among the sums of products, each block by itself.

    Parameters
    ----------
    made : Plan
    parts : sequence of Part
    scalars : Scalars
    value, condition : arrays of int64, shape (parts, rows, points)
        The parts themselves and what must vanish, linear in the coefficients.
    numbers : array of int64, shape (scalars, points)
    """
    for block in made.blocks:
        few = len(block) + _SPARE
        columns, rows = [], []
        for index, chosen in block:
            factor = np.ones_like(value[0, 0, :few])
            for scalar in chosen:
                factor = factor * numbers[scalar, :few] % PRIME
            columns.append((value[index, :, :few] * factor % PRIME).ravel())
            rows.append((condition[index, :, :few] * factor % PRIME).ravel())
        kept = independent_columns(np.array(columns).T)
        for vector in nullspace(np.array(rows)[kept].T):
            found = _solution(vector, [block[i] for i in kept], parts, scalars)
            if found is not None:
                yield found


def _solution(
    vector: Integers,
    block: Sequence[tuple[int, tuple[int, ...]]],
    parts: Sequence[Part],
    scalars: Scalars,
) -> Solution | None:
    terms = []
    effort = 0
    for residue, (index, chosen) in zip(vector, block, strict=True):
        if residue:
            number = rational(int(residue))
            if number is None:
                return None
            terms.append((number, chosen, index))
            effort += 3 + parts[index].effort + scalars.effort(chosen)
    return Solution(tuple(terms), effort)
