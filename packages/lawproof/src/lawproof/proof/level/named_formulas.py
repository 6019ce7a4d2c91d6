"""Named formulas of a law in scalar form."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import flat, scalars
from flowlanes.system.vectors import Vector

from .level_set import LevelSet


def components(
    pairs: Sequence[tuple[sp.Symbol | Vector, sp.Expr]], level: LevelSet
) -> dict[sp.Symbol, sp.Expr]:
    """Pairs (name, formula) as scalar symbols with scalar formulas, rates expanded."""
    formulas_by_symbol: dict[sp.Symbol, sp.Expr] = {}
    for name, formula in pairs:
        formulas = (level.without_rates(scalar) for scalar in scalars(formula))
        formulas_by_symbol.update(zip(flat([name]), formulas, strict=True))
    return formulas_by_symbol


def quantities_in_order(law: Law, level: LevelSet) -> dict[sp.Symbol, sp.Expr]:
    """The quantities named by a law, in terms of the system and of earlier quantities.

    Raises
    ------
    InputError
        If the name of a quantity is taken, or its formula uses itself or a later one.
    """
    quantities = components(getattr(law, "quantities", ()), level)
    system = level.system
    kinds = {
        "a state variable": set(system.symbols),
        "a definition": {s for s, _ in system.scalar_definitions},
        "a parameter": {p.symbol for p in system.parameters},
    }
    for symbol in quantities:
        for kind, names in kinds.items():
            if symbol in names:
                raise InputError(
                    f"the law {law.name!r} names a quantity {symbol}, which is {kind} of "
                    f"{system.name}; it needs a name of its own"
                )
    waiting = set(quantities)
    for symbol, formula in quantities.items():
        if ahead := sorted(map(str, formula.free_symbols & waiting)):
            raise InputError(
                f"the law {law.name!r}: the formula of {symbol} uses {', '.join(ahead)}; a "
                "quantity may use those named before it"
            )
        waiting.remove(symbol)
    return quantities
