"""Substitution of formulas for parameters of a mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import Pairs
from flowlanes.system.vectors import to_components

from .mechanism import Frame, Mechanism, Structure


def with_parameters(mechanism: Mechanism, values: Mapping[sp.Symbol, sp.Expr]) -> Mechanism:
    """A mechanism with parameters replaced by numbers or by formulas in the others.

    Parameters
    ----------
    mechanism : Mechanism
    values : mapping of Symbol to Expr
        Values or formulas of parameters, which are removed from the mechanism.
    """
    table = {s: sp.sympify(v) for s, v in values.items()}

    def put_in(formula: sp.Basic) -> sp.Basic:
        # the entries of a tensor are visible only in components
        written = to_components(sp.sympify(formula))
        return written.xreplace(table) if written.free_symbols & set(table) else formula

    def pairs(formulas: Pairs) -> Pairs:
        return tuple((name, put_in(formula)) for name, formula in formulas)

    frame = mechanism.frame
    structure: Structure | None = frame.structure
    return replace(
        mechanism,
        frame=Frame(
            pairs(frame.rates),
            frame.velocities,
            tuple(map(put_in, frame.relations)),
            None if structure is None else tuple((pair, pairs(row)) for pair, row in structure),
        ),
        lagrangian=put_in(mechanism.lagrangian),
        constraints=tuple(map(put_in, mechanism.constraints)),
        positions=tuple(map(put_in, mechanism.positions)),
        forces=pairs(mechanism.forces),
        definitions=pairs(mechanism.definitions),
        parameters=tuple(p for p in mechanism.parameters if p.symbol not in table),
        observables=tuple(replace(o, value=put_in(o.value)) for o in mechanism.observables),
        guards=tuple(replace(g, value=put_in(g.value)) for g in mechanism.guards),
        laws=tuple(
            replace(law, value=put_in(law.value), level=tuple(map(put_in, law.level)))
            if isinstance(law, Integral)
            else law
            for law in mechanism.laws
        ),
    )
