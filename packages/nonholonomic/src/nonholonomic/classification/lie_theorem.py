"""Lie's theorem (Theorem 3): independent symmetry fields that span a solvable algebra."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from flowlanes.system.laws import Integral, Law, Symmetry, of_kind
from flowlanes.system.vectors import Vector
from lawproof.proof.level.named_formulas import components
from lawproof.proof.rank import rank

from .conserved_covectors import AnnihilatingCovectors
from .facts import HERE, Fact, ProofBudget, fact_of
from .ranks import RankSample, View, conditions_on_parameters
from .rotation_symmetry import RotationSymmetry, proven_rotation_symmetry

Components = dict[sp.Symbol, sp.Expr]


def independent_symmetries(
    sample: RankSample, laws: Sequence[Law], budget: ProofBudget
) -> list[Symmetry]:
    """The proven symmetry fields, independent of the motion and of one another.

    If none is declared, rotations about the body axes are tried at the present parameters.
    """
    stated = list(of_kind(laws, Symmetry))
    if not stated and not sample.level:
        rotations = enumerate(_rotations(sample, conditions_on_parameters(sample, laws)))
        stated = [
            law
            for axis, law in rotations
            if proven_rotation_symmetry(sample, axis) or budget.verdict(sample.system, law)
        ]
    return _independent(sample, stated)


def lie_symmetries(
    sample: RankSample,
    count: int,
    sources: Sequence[AnnihilatingCovectors],
    symmetries: Sequence[Symmetry],
    budget: ProofBudget,
) -> tuple[Fact, ...]:
    """The symmetry fields required by Theorem 3, or none if there are too few.

    They are tangent to the levels of the integrals and span a solvable Lie algebra, both proven.

    Parameters
    ----------
    sample : RankSample
    count : int
        n − k − 1 for dimension n and k integrals.
    sources : sequence of AnnihilatingCovectors
        The integrals.
    symmetries : sequence of Symmetry
        Independent of one another and of the motion.
    budget : ProofBudget
    """
    if count <= 0 or len(symmetries) < count:
        return ()
    fitting = [law for law in symmetries if _tangent(sample, law, sources, budget)]
    if len(fitting) < count or not _solvable(sample, fitting):
        return ()
    return tuple(fact_of(law) for law in fitting)


def _rotations(sample: RankSample, on: tuple[sp.Expr, ...]) -> list[Symmetry]:
    """Rotations about the body axes, as candidates; none if the state has scalars."""
    state = sample.system.state
    names = [name for name in state if isinstance(name, Vector) and len(name.symbols) == 3]
    if len(names) != len(state):
        return []
    rotations = []
    for i in range(3):
        axis = sp.Matrix([int(i == j) for j in range(3)])
        field = {name: axis.cross(sp.Matrix(name.symbols)) for name in names}
        words = f"rotation about body axis {i + 1}"
        rotation = Symmetry(f"rotation_{i + 1}", field, words, level=on, source=HERE)
        rotations.append(rotation)
    return rotations


def _full(sample: RankSample, law: Symmetry) -> Components:
    """The components of a symmetry field in terms of the state only."""
    named = components(law.field, sample.level_set)
    return {s: sample.expand(named.get(s, sp.S.Zero)) for s in sample.system.symbols}


def _independent(sample: RankSample, laws: Sequence[Symmetry]) -> list[Symmetry]:
    if not laws:
        return []
    fields = [_full(sample, law) for law in laws]

    def independent_indices(view: View) -> list[int]:
        rows = [[view.jet(rate).value for rate in sample.level_set.system.rates]]
        indices = []
        for index, field in enumerate(fields):
            more = [view.jet(component).value for component in field.values()]
            if rank(view.field, [*rows, more]) == len(rows) + 1:
                rows.append(more)
                indices.append(index)
        return indices

    return [laws[i] for i in max(sample.at_points(independent_indices), key=len)]


def _tangent(
    sample: RankSample,
    law: Symmetry,
    sources: Sequence[AnnihilatingCovectors],
    budget: ProofBudget,
) -> bool:
    """Whether a symmetry field is proven to be tangent to the levels of all integrals."""
    if not all(source.functions for source in sources):
        return False
    field = _full(sample, law)
    moved = replace(sample.level_set.system, field=field)
    rotation = _as_rotation(sample, field)
    return all(
        (rotation and rotation.keeps(formula))
        or budget.verdict(moved, Integral(f"along {law.name}", formula, level=sample.level))
        for source in sources
        for formula in source.functions
    )


def _as_rotation(sample: RankSample, field: Components) -> RotationSymmetry | None:
    """The rotation about a body axis that equals a field, if it is a proven symmetry."""
    for axis, law in enumerate(_rotations(sample, ())):
        if _full(sample, law) == field:
            return proven_rotation_symmetry(sample, axis)
    return None


def _solvable(sample: RankSample, laws: Sequence[Symmetry]) -> bool:
    """Whether fields span a solvable Lie algebra with constant structure; exact."""
    fields = [_full(sample, law) for law in laws]
    structure = _structure(fields, sample.system.symbols)
    if structure is None:
        return False
    span = [list(row) for row in sp.eye(len(laws)).tolist()]
    # the derived series: each term is spanned by the brackets of the one before, and a solvable
    # algebra reaches zero
    while span:
        pairs = [(span[i], span[j]) for i in range(len(span)) for j in range(i)]
        brackets = [_bracket(structure, a, b) for a, b in pairs]
        reduced = sp.Matrix(brackets).rref()[0].tolist() if brackets else []
        derived = [row for row in reduced if any(row)]
        if len(derived) == len(span):
            return False
        span = derived
    return True


def _bracket(structure: dict[tuple[int, int], list[Any]], a: sp.Expr, b: sp.Expr) -> list[sp.Expr]:
    size = len(a)
    total = [sp.S.Zero] * size
    for (i, j), values in structure.items():
        weight = a[i] * b[j] - a[j] * b[i]
        total = [t + weight * v for t, v in zip(total, values, strict=True)]
    return total


def _structure(
    fields: Sequence[Components], symbols: Sequence[sp.Symbol]
) -> dict[tuple[int, int], list[Any]] | None:
    """Constants c with [uᵢ, uⱼ] = Σ cₖ uₖ, for i < j; None if there are none."""
    structure = {}
    for j in range(len(fields)):
        for i in range(j):
            bracket = _commutator(fields[i], fields[j], symbols)
            constants = sp.symbols(f"c_:{len(fields)}")
            conditions: list[sp.Expr] = []
            for s in symbols:
                total = sp.Add(*(c * u[s] for c, u in zip(constants, fields, strict=True)))
                left = sp.expand(bracket[s] - total)
                if not left.is_polynomial(*symbols):
                    return None
                conditions += sp.Poly(left, *symbols).coeffs()
            solved = sp.solve(conditions, constants, dict=True)
            if not solved:
                return None
            structure[i, j] = [
                solved[0].get(c, sp.S.Zero).xreplace(_free(constants)) for c in constants
            ]
    return structure


def _free(constants: Sequence[sp.Symbol]) -> Components:
    return dict.fromkeys(constants, sp.S.Zero)


def _commutator(u: Components, w: Components, symbols: Sequence[sp.Symbol]) -> Components:
    return {
        s: sp.Add(*(u[r] * sp.diff(w[s], r) - w[r] * sp.diff(u[s], r) for r in symbols))
        for s in symbols
    }
