"""An obstruction to an invariant measure that is smooth where a marble ball is at rest.

Ṁ is quadratic in M, γ̇ is linear in M.  If the density ρ(M, γ) is positive and continuously
differentiable at M = 0, the terms of first order in M of v(ln ρ) + div v = 0 are

    γ̇ · ∂ ln ρ(0, γ)/∂γ + div v = 0.

A ball that spins about the normal has γ̇ = 0, so that div v must vanish for ω = γ.  The numbers are
rational, and the divergence is exact: a quadratic function is differentiated by a central
difference, and γ̇ of a ball has no divergence.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

import sympy as sp

from ...core.system import System
from ...core.vectors import to_components, vectors
from ...formulas.straight_line_program import FieldArithmetic, StraightLineProgram

M, omega, gamma = vectors("M omega gamma")

Values = Mapping[sp.Symbol, Fraction]


def divergence_of_spin(system: System, place: Sequence[Fraction]) -> Fraction:
    """div v of a marble ball for ω = γ.

    Parameters
    ----------
    system : System
        State M, γ; the default parameters are read as decimal fractions.
    place : 3 rational numbers
        γ, a unit vector.
    """
    spinning = _symbol_values(system, dict(zip(omega.symbols, place, strict=True)), place)
    momentum = [_rational_value(part, spinning) for part in to_components(dict(system.start)[M])]
    rates = dict(zip(system.symbols, system.rates, strict=True))
    total = Fraction(0)
    for i, symbol in enumerate(M.symbols):
        for sign in (1, -1):
            shifted = dict(zip(M.symbols, momentum, strict=True))
            shifted[symbol] = momentum[i] + sign
            rate = _rational_value(rates[symbol], _symbol_values(system, shifted, place))
            total += Fraction(sign, 2) * rate
    return total


def _symbol_values(
    system: System, state: Values, place: Sequence[Fraction]
) -> dict[sp.Symbol, Fraction]:
    """Parameters, state, and the definitions that follow from them."""
    known = {p.symbol: Fraction(str(p.default)) for p in system.parameters}
    known |= {**state, **dict(zip(gamma.symbols, place, strict=True))}
    for symbol, formula in system.scalar_definitions:
        if symbol not in known and formula.free_symbols <= set(known):
            known[symbol] = _rational_value(formula, known)
    return known


def _rational_value(formula: sp.Expr, values: Values) -> Fraction:
    """A rational formula."""
    names = sorted(formula.free_symbols, key=str)
    program = StraightLineProgram(names, [formula])
    value: Fraction
    [value] = program.run([values[name] for name in names], FieldArithmetic(Fraction(1)))
    return value
