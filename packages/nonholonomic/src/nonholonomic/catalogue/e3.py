"""Hamiltonian systems on the (co)algebra e(3), in the form of the Kirchhoff equations (§6.3).

    dM/dt = M×∂H/∂M + Γ×∂H/∂Γ,   dΓ/dt = Γ×∂H/∂M,

that is, ẋ = {x, H} with {M_i, M_j} = −ε_ijk M_k, {M_i, Γ_j} = −ε_ijk Γ_k, {Γ_i, Γ_j} = 0.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

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

from ..mechanics.rolling.body import triangle_inequalities

M, Gamma = vectors("M Gamma")
I = Diagonal("I")
H = real_symbol("H")


def lie_poisson(first: MatrixExpr, second: MatrixExpr) -> Components:
    """The 6×6 matrix [[û, v̂], [v̂, 0]] for u = `first`, v = `second`."""
    corner = hat(second)
    top = hat(first).row_join(corner)
    return Components(top.col_join(corner.row_join(Components.zeros(3, 3))))


def bracket(sign: int = -1) -> PoissonStructure:
    """The bracket {M_i, M_j} = `sign` ε_ijk M_k of e(3), with its two Casimir functions.

    The paper prints it with the sign +1, which reverses the motion.
    """
    return PoissonStructure(
        "bracket",
        -sign * lie_poisson(M, Gamma),
        casimirs=(norm_squared(Gamma), dot(M, Gamma)),
        rank=4,
        meaning=f"bracket of e(3), {{M_i, M_j}} = {'−' if sign < 0 else ''}ε_ijk M_k",
        source="(6.11)",
    )


def hamiltonian_form(structure: PoissonStructure) -> ConformallyHamiltonian:
    """ẋ = {x, H} with the given bracket."""
    return ConformallyHamiltonian(
        "hamiltonian", sp.S.One, structure, H, "Hamiltonian form on e(3)", source="(6.11)"
    )


def inertia_parameters(moments: tuple[float, float, float]) -> tuple[Parameter, ...]:
    """The principal moments of inertia I_1, I_2, I_3 of a body."""
    conditions = triangle_inequalities(I.symbols)
    return tuple(
        Parameter(s, f"moment of inertia about body axis {i}", value, "kg m^2", conditions[s])
        for i, (s, value) in enumerate(zip(I.symbols, moments, strict=True), 1)
    )


def e3_system(
    name: str,
    title: str,
    hamiltonian: sp.Expr,
    parameters: tuple[Parameter, ...],
    *,
    level: tuple[sp.Expr, ...] = (),
    laws: tuple[Law, ...] = (),
    source: str = "",
    summary: str = "",
    unit: str = "J",
) -> System:
    """The Hamiltonian system with the given H(M, Γ) on e(3), with Γ² = 1.

    Parameters
    ----------
    name, title, source, summary : str
    hamiltonian : sympy.Expr
        H, in the components of M and Γ (body axes).
    parameters : tuple of Parameter
    level : tuple of sympy.Expr
        Further relations, such as (M, Γ) = 0.
    laws : tuple of Law
        Laws besides the Hamiltonian form, its energy and the area integral.
    unit : str
        SI unit of H.
    """
    slope_M, slope_Gamma = gradient(hamiltonian, M, "H"), gradient(hamiltonian, Gamma, "H")
    structure = bracket()
    return System(
        name=name,
        title=title,
        source=source,
        summary=summary,
        parameters=parameters,
        definitions={H: hamiltonian},
        field={
            M: cross(M, slope_M) + cross(Gamma, slope_Gamma),
            Gamma: cross(Gamma, slope_M),
        },
        relations=(norm_squared(Gamma) - 1, *level),
        laws=(
            Integral("energy", H, "Hamiltonian function", source=source, unit=unit),
            structure,
            replace(
                hamiltonian_form(structure),
                as_printed=hamiltonian_form(bracket(+1)),
                misprint="sign of the bracket",
            ),
            *laws,
        ),
    )
