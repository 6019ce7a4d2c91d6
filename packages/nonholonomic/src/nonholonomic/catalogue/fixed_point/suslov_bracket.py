"""A solvable five-dimensional bracket whose Casimir functions are not all global (§3.4, (3.8)).

The only brackets that are not zero are those with γ₃, which turns the planes (p₁, γ₁) and
(p₂, γ₂) at the rates 1 and d:

    {γ₁, γ₃} = p₁,   {γ₂, γ₃} = d p₂,   {p₁, γ₃} = −γ₁,   {p₂, γ₃} = −d γ₂.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import PoissonStructure
from flowlanes.system.vectors import Components, Vector

gamma = Vector("gamma")
p_1, p_2, d = sp.symbols("p_1 p_2 d", real=True)
gamma_1, gamma_2, gamma_3 = gamma.symbols
#: Flat order of the state.
ORDER = (p_1, p_2, gamma_1, gamma_2, gamma_3)


def skew(brackets: dict[tuple[sp.Symbol, sp.Symbol], sp.Expr]) -> Components:
    """The matrix of a bracket from its entries {x, y} that are not zero."""
    matrix = sp.zeros(5, 5)
    for (x, y), value in brackets.items():
        i, j = ORDER.index(x), ORDER.index(y)
        matrix[i, j], matrix[j, i] = value, -value
    return Components(matrix)


def bracket() -> PoissonStructure:
    """(3.8), with {γ₁, γ₃} = p₁ where the paper prints {γ₁, γ₂} = p₁."""
    common = {
        (gamma_2, gamma_3): d * p_2,
        (p_1, gamma_3): -gamma_1,
        (p_2, gamma_3): -d * gamma_2,
    }
    casimirs = (p_1**2 + gamma_1**2, p_2**2 + gamma_2**2)
    meaning = "Lie–Poisson bracket of a solvable algebra"
    printed = PoissonStructure(
        "bracket",
        skew({(gamma_1, gamma_2): p_1, **common}),
        casimirs=casimirs,
        rank=2,
        meaning=meaning,
        source="(3.8)",
    )
    return PoissonStructure(
        "bracket",
        skew({(gamma_1, gamma_3): p_1, **common}),
        casimirs=casimirs,
        rank=2,
        meaning=meaning,
        source="(3.8)",
        as_printed=printed,
        misprint="{γ₁, γ₂} = p₁ in place of {γ₁, γ₃} = p₁",
    )


def third_casimir() -> sp.Expr:
    """Argument of the complex function Φ₃ of Remark 10; its modulus is Φ₁^(d/2) Φ₂^(−1/2).

    It is many-valued: for irrational d its values at a point are dense.
    """
    return d * sp.atan2(gamma_1, p_1) - sp.atan2(gamma_2, p_2)
