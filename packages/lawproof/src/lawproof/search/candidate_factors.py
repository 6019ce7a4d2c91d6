"""Candidate factors of laws: denominators of a field, (γ, Jγ), factors of relations."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

import numpy as np
import sympy as sp
from sympy.matrices.expressions import Inverse, MatPow

from flowlanes.system.vectors import Diagonal, Symmetric, dot

from .modular_jets import Integers, inverse, prime
from .vector_invariants import VectorInvariants

_POINTS = 12


def natural_divisors(vocabulary: VectorInvariants) -> tuple[sp.Expr, ...]:
    """Functions of the coordinates by which integrals are often divided.

    These are the factors of denominators, the principal values of varying tensors, and (γ, Jγ), (γ,
    J⁻¹γ) for the constant tensors; none is constant along all motions, and no two are proportional.
    """
    return tuple(_distinct(vocabulary, _candidates(vocabulary), _places(vocabulary)))


def natural_bases(vocabulary: VectorInvariants) -> tuple[sp.Expr, ...]:
    """Functions whose powers often occur in densities.

    They are the divisors, single variables, and the factors of relations, which affect the volume
    on the phase space.
    """
    symbols = vocabulary.space.system.symbols
    named = {n for n, _ in vocabulary.space.system.definitions if isinstance(n, sp.Symbol)}
    singles = [s for s in symbols if s in vocabulary.space.system.state]
    singles += [s for s in sorted(named, key=str) if s in vocabulary.table]
    factors = [f for r in vocabulary.space.relations for f in _factors(r)]
    everything = (*_candidates(vocabulary), *vocabulary.ansatz.coordinates, *singles, *factors)
    return tuple(_distinct(vocabulary, everything, set(symbols)))


def _places(vocabulary: VectorInvariants) -> set[sp.Symbol]:
    return {s for c in vocabulary.ansatz.coordinates for s in c.free_symbols}


def _distinct(
    vocabulary: VectorInvariants, candidates: Iterable[sp.Expr], symbols: set[sp.Symbol]
) -> Iterator[sp.Expr]:
    """Formulas that vary, use only allowed symbols, and are pairwise not proportional."""
    space = vocabulary.space
    sample = space.sample(_POINTS, 7, common=True)
    others = [i for i, s in enumerate(space.system.symbols) if s not in symbols]
    seen: list[Integers] = []
    for formula in candidates:
        jet = sample(formula)
        if not jet.value.all() or not sample.along(jet).any() or np.any(jet.slope[others]):
            continue
        if not any(_proportional(jet.value, other) for other in seen):
            seen.append(jet.value)
            yield formula


def _proportional(left: Integers, right: Integers) -> bool:
    ratio = left * inverse(right) % prime()
    return bool((ratio == ratio[0]).all())


def _candidates(vocabulary: VectorInvariants) -> Iterator[sp.Expr]:
    for pair in vocabulary.tensors:
        for tensor in pair:
            if tensor is not None:
                for vector in vocabulary.coordinates:
                    yield dot(vector, tensor * vector)
    system = vocabulary.space.system
    for _, formula in (*system.field, *system.definitions):
        yield from _denominators(formula)


def _factors(relation: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of a relation, if it has several."""
    if not relation.is_polynomial():
        return ()
    _, factors = sp.factor_list(relation)
    return tuple(f for f, _ in factors) if len(factors) > 1 else ()


def _denominators(formula: sp.Basic) -> Iterator[sp.Expr]:
    for node in sp.preorder_traversal(formula):
        if isinstance(node, (Inverse, MatPow)):
            tensor = node.args[0]
            if isinstance(tensor, Diagonal):
                yield from tensor.symbols
            elif isinstance(tensor, Symmetric):
                yield tensor.entries.det(method="berkowitz")
        elif isinstance(node, sp.Pow) and node.exp.is_negative:
            for factor in sp.Mul.make_args(node.base):
                yield factor.base if isinstance(factor, sp.Pow) else factor
