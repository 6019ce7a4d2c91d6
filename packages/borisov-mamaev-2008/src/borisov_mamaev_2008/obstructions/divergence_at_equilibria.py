"""Equilibria with non-zero divergence, which exclude a smooth measure.

Where v = 0, div(ρv) = ρ div v, so that no positive smooth density ρ satisfies the Liouville
equation near an equilibrium with div v ≠ 0.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from flowlanes.parsing.exact_decimals import with_exact_decimals
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from lawproof.proof.verdict import Verdict

Point = Mapping[sp.Symbol, sp.Expr]


def _jets(system: System, point: Point) -> tuple[dict[sp.Symbol, sp.Expr], dict[sp.Symbol, Point]]:
    """Values of state, parameters and definitions, with their derivatives by the state."""
    values = dict(point)
    slopes: dict[sp.Symbol, Point] = {s: {s: sp.S.One} for s in system.symbols}
    for symbol, formula in system.scalar_definitions:
        slopes[symbol] = _slopes(formula, values, slopes)
        values[symbol] = with_exact_decimals(formula.xreplace(values))
    return values, slopes


def _slopes(
    formula: sp.Expr, values: Point, slopes: Mapping[sp.Symbol, Point]
) -> dict[sp.Symbol, sp.Expr]:
    total: dict[sp.Symbol, sp.Expr] = {}
    for symbol in formula.free_symbols & set(slopes):
        partial = sp.diff(formula, symbol).xreplace(dict(values))
        for variable, slope in slopes[symbol].items():
            total[variable] = total.get(variable, sp.S.Zero) + partial * slope
    return total


def divergence(system: System, point: Point) -> sp.Expr:
    """The exact divergence of the vector field at an equilibrium.

    Parameters
    ----------
    system : System
        A system that preserves its relations also off the phase space, as γ̇ = γ×ω preserves γ²;
        the divergence then is the one on the phase space.
    point : mapping of Symbol to exact number
        Exact values of state and parameters.

    Raises
    ------
    ValueError
        If the point is not an equilibrium on the phase space.
    """
    values, slopes = _jets(system, point)
    moving = [*system.rates, *system.relations]
    if any(sp.simplify(formula.xreplace(values)) != 0 for formula in scalars(tuple(moving))):
        raise ValueError(f"{system.name}: the point is not a rest point of the phase space")
    total = sp.S.Zero
    for symbol, rate in zip(system.symbols, system.rates, strict=True):
        total += _slopes(rate, values, slopes).get(symbol, sp.S.Zero)
    return sp.simplify(total)


def excludes_measure(system: System, point: Point) -> Verdict:
    """The verdict that a system has no invariant measure with a positive smooth density.

    Parameters
    ----------
    system : System
    point : mapping of Symbol to exact number
        An equilibrium.

    Returns
    -------
    Verdict
        Proven if the divergence does not vanish at the point; otherwise undecided.
    """
    value = divergence(system, point)
    if value == 0:
        return Verdict("measure", "undecided", reason="the divergence vanishes at the rest point")
    return Verdict(
        "measure",
        "proven",
        finding=f"div v = {value} at a rest point, where a smooth measure needs div v = 0",
        witness={"point": {str(s): str(v) for s, v in point.items()}, "residual": str(value)},
    )
