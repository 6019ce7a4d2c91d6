"""Time derivatives in formulas, written out where their values do not suffice."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from ...core.laws import Rate
from ...core.named_formulas import expand
from .level_set import LevelSet

Quantities = Mapping[sp.Symbol, sp.Expr]


def without_rates(
    formula: sp.Expr, level: LevelSet, quantities: Quantities | None = None
) -> sp.Expr:
    """A formula in which every rate is written out as a formula in the state.

    Parameters
    ----------
    quantities : mapping of Symbol to formula, optional
        Further names that may stand under a rate.
    """
    while rates := formula.atoms(Rate):
        innermost = [rate for rate in rates if not rate.args[0].has(Rate)]
        formula = formula.xreplace(
            {rate: _rate_formula(rate.args[0], level, quantities or {}) for rate in innermost}
        )
    return formula


def without_second_rates(
    formula: sp.Expr, level: LevelSet, quantities: Quantities | None = None
) -> sp.Expr:
    """A formula in which rates stand under no other rate: the inner ones are written out."""
    deep = {rate for rate in formula.atoms(Rate) if rate.args[0].has(Rate)}
    outermost = {r for r in deep if not any(r in o.args[0].atoms(Rate) for o in deep - {r})}
    return formula.xreplace(
        {r: Rate(without_rates(r.args[0], level, quantities)) for r in outermost}
    )


def _rate_formula(formula: sp.Expr, level: LevelSet, quantities: Quantities) -> sp.Expr:
    formula = level.expand(expand(formula, quantities))
    rates = zip(level.system.symbols, level.system.rates, strict=True)
    return sp.Add(*(sp.diff(formula, s) * rate for s, rate in rates))
