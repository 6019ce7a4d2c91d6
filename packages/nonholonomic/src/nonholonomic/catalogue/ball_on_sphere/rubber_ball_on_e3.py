"""The rubber ball on a sphere as a Hamiltonian system on e(3), (9.13), (9.14).

    {M_i, M_j} = −ε_ijk M_k,   {M_i, γ_j} = −ε_ijk γ_k,   {γ_i, γ_j} = 0,
    H = ½ (k² / det J) (γ, Jγ)^(1/k) M²,      dx/dτ = {x, H},

that is, M′ = M×∂H/∂M + γ×∂H/∂γ, γ′ = γ×∂H/∂M.
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, PoissonStructure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient, hat
from flowlanes.system.vectors import (
    Components,
    Diagonal,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

from ..catalogue_entry import Numbers

M, gamma = vectors("M gamma")
J = Diagonal("J")
k = real_symbol("k")

J_1, J_2, J_3 = J.symbols
DET_J = J_1 * J_2 * J_3
#: The factors of H = G(γ) F(M) that §9.4 speaks of.
STIFFNESS = k**2 / DET_J * dot(gamma, J * gamma) ** (1 / k)
KINETIC = norm_squared(M) / 2

NAME, TITLE = "rubber-ball-on-e3", "Rubber ball on a sphere as a Hamiltonian system"
SUMMARY = (
    "The rubber ball on a sphere in the variables M = Ñ J^(1/2) ω, γ = J^(−1/2) n / ρ and the time "
    "dτ = N dt: a Hamiltonian system on the algebra e(3)."
)
SOURCE = "§9.3, (9.11)–(9.14)"
DEFAULTS = {"J_1": 2.0, "J_2": 2.5, "J_3": 3.1, "k": -1.0}


def parameters(p: Mapping[str, float]) -> tuple[Parameter, ...]:
    """J and k, with the values given."""
    what = "moment of inertia about a tangent at the contact, axis"
    moments = tuple(
        Parameter(s, f"{what} {i}", p[str(s)], "kg m^2", (s > 0,))
        for i, s in enumerate(J.symbols, 1)
    )
    return (*moments, Parameter(k, "ratio a/(a + b) of the radii", p["k"], "1", (sp.Ne(k, 0),)))


def bracket(sign: int = -1) -> Components:
    """The matrix of {M_i, M_j} = sign ε_ijk M_k, {M_i, γ_j} = sign ε_ijk γ_k."""
    turn, swing = -sign * hat(M), -sign * hat(gamma)
    return Components(turn.row_join(swing).col_join(swing.row_join(Components.zeros(3, 3))))


STRUCTURE = PoissonStructure(
    "e(3)",
    bracket(),
    casimirs=(dot(M, gamma), norm_squared(gamma)),
    rank=4,
    meaning="Lie–Poisson bracket of e(3)",
    source="(9.13)",
)


def on_e3(
    hamiltonian: sp.Expr,
    parameters: tuple[Parameter, ...],
    *laws: Law,
    relations: tuple[sp.Expr, ...] = (norm_squared(gamma) - 1, dot(M, gamma)),
    source: str = "(9.14)",
) -> System:
    """The Hamiltonian system M′ = M×∂H/∂M + γ×∂H/∂γ, γ′ = γ×∂H/∂M.

    Parameters
    ----------
    hamiltonian : sympy.Expr
        H(M, γ); unspecified functions are allowed.
    parameters : tuple of Parameter
    *laws : Law
        Further laws, besides energy, bracket and Hamiltonian form.
    relations : tuple of sympy.Expr
        The symplectic leaf; by default that of a point on a sphere.
    source : str
        Where H is stated.
    """
    slope_M, slope_gamma = gradient(hamiltonian, M, "H"), gradient(hamiltonian, gamma, "H")
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=parameters,
        field={
            M: cross(M, slope_M) + cross(gamma, slope_gamma),
            gamma: cross(gamma, slope_M),
        },
        relations=relations,
        laws=(
            Integral("energy", hamiltonian, "energy", source=source, unit="J"),
            STRUCTURE,
            ConformallyHamiltonian(
                "hamiltonian",
                sp.S.One,
                STRUCTURE,
                hamiltonian,
                "Hamiltonian form on e(3)",
                source=source,
            ),
            *laws,
        ),
    )


def hamiltonian_form(p: Numbers = DEFAULTS) -> System:
    """The system of (9.14); state M, γ with (M, γ) = 0."""
    return on_e3(STIFFNESS * KINETIC, parameters(p))


def product(stiffness: sp.Expr, kinetic: sp.Expr) -> System:
    """The system of any product H = G(γ) F(M), (9.15), on all of e(3)."""
    return on_e3(stiffness * kinetic, (), relations=(), source="(9.15)")


def any_product() -> System:
    """H = G(γ) F(M) with both functions unspecified."""
    return product(sp.Function("G")(*gamma.symbols), sp.Function("F")(*M.symbols))
