"""Formulas in the parameters from solutions modulo a prime.

A law is a sum of parts (functions of state and parameters) with coefficients that are polynomials
in the parameters. Expanded in monomials of the parameters, these have rational coefficients that
do not depend on the parameters and solve one linear system with equations at points with different
parameters. Weights (physical dimensions) split it into small systems.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import combinations_with_replacement
from typing import TypeAlias

import numpy as np
import sympy as sp

from .modular_jets import PRIMES, Integers, modulo, prime
from .modular_linalg import independent_columns, nullspace, rational
from .scaling import Weight, total

LARGEST = 1000
"""Maximum number of unknowns of one linear system; the simplest are kept."""
_SPARE = 24

Product: TypeAlias = tuple[int, ...]
"""Indices of scalars, with repetition."""


@dataclass(frozen=True)
class Part:
    """A function that may occur in a law, with a coefficient in the parameters.

    Attributes
    ----------
    formula : sympy expression or tuple of them
        The function multiplied by the coefficient.
    effort : int
        Complexity of the formula; simple parts are preferred.
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
        """A measure of the complexity of each quantity."""
        return tuple(1 + int(sp.count_ops(formula)) for formula in self.formulas)

    def effort(self, indices: Sequence[int]) -> int:
        """A measure of the complexity of a product of some quantities."""
        return sum(1 + self.efforts[i] for i in indices)


@dataclass(frozen=True)
class Plan:
    """The linear systems to be solved: lists of (index of part, indices of scalars)."""

    blocks: tuple[tuple[tuple[int, Product], ...], ...]

    @property
    def widest(self) -> int:
        """The largest number of unknowns of a block."""
        return max((len(block) for block in self.blocks), default=0)


@dataclass(frozen=True)
class RationalLaw:
    """A law: rational coefficients of products of scalars and a part."""

    terms: tuple[tuple[Fraction, Product, int], ...]
    effort: int


@dataclass(frozen=True)
class Draw:
    """The parts and the linear conditions on them at some points modulo the current prime.

    Attributes
    ----------
    value, condition : arrays of int64, shape (parts, rows, points)
        The parts, and the expressions that must vanish, which are linear in the coefficients.
    numbers : array of int64, shape (scalars, points)
    """

    value: Integers
    condition: Integers
    numbers: Integers


@dataclass(frozen=True)
class _Kernel:
    """One solution modulo a prime, or several combined."""

    terms: tuple[tuple[int, Product], ...]
    residues: tuple[int, ...]


def plan(parts: Sequence[Part], scalars: Scalars, degree: int) -> Plan:
    """Group products of a part and at most `degree` scalars by their weight."""
    zero = tuple(0 for _ in parts[0].weight)
    products = [
        (chosen, total(zero, *(scalars.weights[i] for i in chosen)))
        for size in range(degree + 1)
        for chosen in combinations_with_replacement(range(len(scalars.formulas)), size)
    ]
    blocks: dict[Weight, list[tuple[int, Product]]] = defaultdict(list)
    for index, part in enumerate(parts):
        for chosen, weight in products:
            blocks[total(weight, part.weight)].append((index, chosen))
    for block in blocks.values():
        block.sort(key=lambda item: parts[item[0]].effort + scalars.effort(item[1]))
    return Plan(tuple(tuple(block[:LARGEST]) for block in blocks.values()))


def reconstructed_laws(
    parts: Sequence[Part], scalars: Scalars, degree: int, draw: Callable[[int], Draw]
) -> list[RationalLaw]:
    """Laws with coefficients up to a degree in the scalars, simplest first.

    Parameters
    ----------
    parts : sequence of Part
        The parts, at least one.
    draw : callable
        Number of points ↦ Draw modulo the current prime.

    Returns
    -------
    list of Solution
        Fractions that are too large for one prime are found with several.
    """
    scheme = plan(parts, scalars, degree)
    points = scheme.widest + _SPARE
    kernels, modulus = list(_kernels(scheme, draw(points))), prime()
    for extra in PRIMES[1:]:
        if all(rational(r, modulus) is not None for kernel in kernels for r in kernel.residues):
            break
        with modulo(extra):
            others = list(_kernels(scheme, draw(points)))
        # An unlucky prime changes the pivots; the residues then belong to different bases.
        if [k.terms for k in others] != [k.terms for k in kernels]:
            break
        kernels = [
            _chinese_remainder(a, b, modulus, extra) for a, b in zip(kernels, others, strict=True)
        ]
        modulus *= extra
    solved = (_solution(kernel, modulus, parts, scalars) for kernel in kernels)
    return sorted((s for s in solved if s is not None), key=lambda solution: solution.effort)


def _kernels(scheme: Plan, sample: Draw) -> Iterator[_Kernel]:
    """Bases of the laws among the products, separately for each block."""
    for block in scheme.blocks:
        few = len(block) + _SPARE
        columns, rows = [], []
        for index, chosen in block:
            factor = np.ones_like(sample.value[0, 0, :few])
            for scalar in chosen:
                factor = factor * sample.numbers[scalar, :few] % prime()
            columns.append((sample.value[index, :, :few] * factor % prime()).ravel())
            rows.append((sample.condition[index, :, :few] * factor % prime()).ravel())
        # Products that are dependent on the phase space would add laws that vanish identically.
        independent = independent_columns(np.array(columns).T)
        for vector in nullspace(np.array(rows)[independent].T):
            yield _Kernel(tuple(block[i] for i in independent), tuple(map(int, vector)))


def _chinese_remainder(left: _Kernel, right: _Kernel, modulus: int, extra: int) -> _Kernel:
    """Residues modulo a product, by the Chinese remainder theorem."""
    step = pow(modulus, -1, extra)
    residues = (
        a + modulus * ((b - a) * step % extra)
        for a, b in zip(left.residues, right.residues, strict=True)
    )
    return _Kernel(left.terms, tuple(residues))


def _solution(
    kernel: _Kernel, modulus: int, parts: Sequence[Part], scalars: Scalars
) -> RationalLaw | None:
    terms = []
    effort = 0
    for residue, (index, chosen) in zip(kernel.residues, kernel.terms, strict=True):
        if residue:
            number = rational(residue, modulus)
            if number is None:
                return None
            terms.append((number, chosen, index))
            effort += 3 + parts[index].effort + scalars.effort(chosen)
    return RationalLaw(tuple(terms), effort)
