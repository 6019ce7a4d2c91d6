"""Polynomials that suggest themselves: denominators of a field, (γ, Jγ), determinants."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import sympy as sp
from sympy.matrices.expressions import Inverse, MatPow

from ...vectors import Diagonal, Symmetric, dot, explicit
from .modular import PRIME, Integers, inverse
from .stage import Sample
from .vocabulary import Vocabulary

__all__ = ["natural"]

_POINTS = 12


def natural(vocabulary: Vocabulary) -> tuple[sp.Expr, ...]:
    """Functions of the coordinates from which densities and denominators are often made.

    These are the factors of denominators, determinants of tensors that vary, and (γ, Jγ),
    (γ, J⁻¹γ) for the constant tensors; none is constant along all motions, no two are
    proportional.
    """
    stage = vocabulary.stage
    sample = stage.sample(_POINTS, 7, common=True)
    found: list[sp.Expr] = []
    seen: list[Integers] = []
    for formula in _candidates(vocabulary):
        if not _only_coordinates(vocabulary, formula, sample):
            continue
        value = sample(formula).value
        if any(_proportional(value, other) for other in seen):
            continue
        found.append(formula)
        seen.append(value)
    return tuple(found)


def _proportional(left: Integers, right: Integers) -> bool:
    ratio = left * inverse(right) % PRIME
    return bool((ratio == ratio[0]).all())


def _only_coordinates(vocabulary: Vocabulary, formula: sp.Expr, sample: Sample) -> bool:
    """Whether a formula varies along the motion and has no slope by the momenta."""
    jet = sample(formula)
    if not sample.along(jet).any() or not jet.value.all():
        return False
    symbols = vocabulary.stage.system.symbols
    places = {s for c in vocabulary.ansatz.coordinates for s in c.free_symbols}
    moving = [i for i, s in enumerate(symbols) if s not in places]
    return not np.any(jet.slope[moving])


def _candidates(vocabulary: Vocabulary) -> Iterator[sp.Expr]:
    for pair in vocabulary.tensors:
        for tensor in pair:
            if tensor is not None:
                for vector in vocabulary.coordinates:
                    yield dot(vector, tensor * vector)
    system = vocabulary.stage.system
    for _, formula in (*system.field, *system.definitions):
        yield from _denominators(formula)


def _denominators(formula: Any) -> Iterator[sp.Expr]:
    for node in sp.preorder_traversal(formula):
        if isinstance(node, (Inverse, MatPow)):
            tensor = node.args[0]
            if isinstance(tensor, (Diagonal, Symmetric)):
                yield explicit(tensor).det(method="berkowitz")
        elif isinstance(node, sp.Pow) and node.exp.is_negative:
            for factor in sp.Mul.make_args(node.base):
                yield factor.base if isinstance(factor, sp.Pow) else factor
