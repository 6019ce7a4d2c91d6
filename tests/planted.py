"""Wrong laws, made from right ones by one slip: a sign, an exponent, an index."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from chaplygin.statements import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Isomorphism,
    Law,
    Measure,
    PoissonStructure,
    Reduction,
    Symmetry,
)
from chaplygin.system import System
from chaplygin.vectors import explicit

Slip = Callable[[sp.Expr, System], sp.Expr | None]


def wrong_sign(formula: sp.Expr, system: System) -> sp.Expr | None:
    """A term that moves, in a sum with others, with the other sign."""
    moving = moving_symbols(system)
    for part in sp.preorder_traversal(formula):
        if part.is_Add:
            terms = [term for term in part.args if term.free_symbols & moving]
            if terms and len(part.args) > 1:
                return formula.xreplace({part: part - 2 * terms[-1]})
    return None


def wrong_exponent(formula: sp.Expr, system: System) -> sp.Expr | None:
    """The cube of a quantity that moves in the place of the quantity, in one term."""
    return _in_one_term(formula, system, lambda symbol: symbol**3)


def wrong_index(formula: sp.Expr, system: System) -> sp.Expr | None:
    """A component in the place of its neighbour, in one term."""
    names = {str(s): s for s in moving_symbols(system)}

    def neighbour(symbol: sp.Symbol) -> sp.Symbol | None:
        stem, _, index = str(symbol).rpartition("_")
        return names.get(f"{stem}_{ {'1': '2', '2': '3', '3': '1'}.get(index) }")

    return _in_one_term(formula, system, neighbour)


def moving_symbols(system: System) -> set[sp.Symbol]:
    """The state, and the definitions that depend on it."""
    moving = set(system.symbols)
    for symbol, value in system.steps:
        if value.free_symbols & moving:
            moving.add(symbol)
    return moving


def _in_one_term(
    formula: sp.Expr, system: System, change: Callable[[sp.Symbol], sp.Expr | None]
) -> sp.Expr | None:
    """A change of one moving symbol, in the first product or power that holds it."""
    moving = moving_symbols(system)
    if formula in moving:
        return None
    for part in sp.preorder_traversal(formula):
        if not (part.is_Mul or part.is_Pow or part.is_Symbol):
            continue
        for symbol in sorted(part.free_symbols & moving, key=str):
            changed = change(symbol)
            if changed is not None:
                return formula.xreplace({part: part.xreplace({symbol: changed})})
    return None


SLIPS: dict[str, Slip] = {
    "sign": wrong_sign,
    "exponent": wrong_exponent,
    "index": wrong_index,
}


def wrong_laws(law: Law, system: System) -> Iterator[tuple[str, Law]]:
    """The law with each slip that its formula admits."""
    for name, slip in SLIPS.items():
        made = _with_slip(law, system, slip)
        if made is not None:
            yield name, replace(made, as_printed=None)


def _with_slip(law: Law, system: System, slip: Slip) -> Law | None:
    if isinstance(law, Integral):
        changed = slip(explicit(sp.sympify(law.value)), system)
        return None if changed is None else replace(law, value=changed)
    if isinstance(law, Measure):
        return _in_pairs(law, "density", system, slip)
    if isinstance(law, Symmetry):
        return _in_pairs(law, "field", system, slip)
    if isinstance(law, PoissonStructure):
        return _in_bracket(law, system, slip)
    if isinstance(law, ConformallyHamiltonian):
        changed = slip(explicit(sp.sympify(law.hamiltonian)), system)
        return None if changed is None else replace(law, hamiltonian=changed)
    if isinstance(law, Isomorphism):
        return _in_pairs(law, "map", system, slip)
    if isinstance(law, Reduction):
        return _in_first(law, "equations", system, slip)
    if isinstance(law, Identity):
        return _in_first(law, "value", system, slip)
    raise TypeError(type(law).__name__)


def _in_pairs(law: Any, field: str, system: System, slip: Slip) -> Law | None:
    """A slip in the first formula of a mapping that admits it."""
    pairs = list(getattr(law, field))
    for i, (name, formula) in enumerate(pairs):
        made = explicit(sp.sympify(formula))
        parts = list(made) if isinstance(made, sp.MatrixBase) else [made]
        for j, part in enumerate(parts):
            changed = slip(part, system)
            if changed is not None:
                parts[j] = changed
                whole = (
                    sp.ImmutableDenseMatrix(parts) if isinstance(made, sp.MatrixBase) else changed
                )
                pairs[i] = (name, whole)
                made_law: Law = replace(law, **{field: tuple(pairs)})
                return made_law
    return None


def _in_first(law: Any, field: str, system: System, slip: Slip) -> Law | None:
    value = getattr(law, field)
    scalars = _scalars(value)
    for i, scalar in enumerate(scalars):
        changed = slip(scalar, system)
        if changed is not None:
            scalars[i] = changed
            made: Law = replace(law, **{field: tuple(scalars)})
            return made
    return None


def _scalars(value: Any) -> list[sp.Expr]:
    if isinstance(value, tuple | list):
        return [s for part in value for s in _scalars(part)]
    made = explicit(sp.sympify(value))
    return list(made) if isinstance(made, sp.MatrixBase) else [made]


def _in_bracket(law: PoissonStructure, system: System, slip: Slip) -> Law | None:
    """A slip in one entry and its mirror image, so that the bracket stays skew."""
    size = law.matrix.shape[0]
    for i in range(size):
        for j in range(i + 1, size):
            entry = law.matrix[i, j]
            if entry == 0:
                continue
            changed = slip(entry, system)
            if changed is not None:
                matrix = law.matrix.as_mutable()
                matrix[i, j], matrix[j, i] = changed, -changed
                return replace(law, matrix=matrix)
    return None
