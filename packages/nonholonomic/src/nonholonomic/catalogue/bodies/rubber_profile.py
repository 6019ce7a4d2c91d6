"""The rubber body of revolution with an unspecified profile, for statements of §5 on all of them.

The profile is given by the support function p(γ₃), the height of the centre of mass above the
plane, from which

    r = (χ₁γ₁, χ₁γ₂, χ₂),   χ₁ = −p + γ₃ p′,   χ₂ = −γ₃ p − (1 − γ₃²) p′.

The equations (1.18) are taken along n = γ×e₃ and w = e₃ − γ₃γ, two vectors that span the plane of
ω, that Ĩ leaves orthogonal, and to which the torque λ₀γ does not contribute.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

omega, gamma, r, rdot, M, X, n, w, e = vectors("omega gamma r rdot M X n w e")
I = Diagonal("I")
I_1, I_2, I_3 = I.symbols
m, chi_1, chi_2, A, B, U = (real_symbol(s) for s in ("m", "chi_1", "chi_2", "A", "B", "U"))
g_1, g_2, g_3 = gamma.symbols

#: An unspecified support function, and an unspecified potential.
HEIGHT = sp.Function("p")(g_3)
POTENTIAL = sp.Function("U")(g_3)

HALF = sp.Rational(1, 2)


def from_support(height: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """χ₁ and χ₂ of the body whose centre of mass is `height`(γ₃) above the plane."""
    slope = height.diff(g_3)
    return -height + g_3 * slope, -g_3 * height - (1 - g_3**2) * slope


def profile_system(
    chi: tuple[sp.Expr, sp.Expr],
    potential: sp.Expr = POTENTIAL,
) -> System:
    """The body with the profile χ₁, χ₂ in a potential U(γ₃), which may be its weight.

    Parameters
    ----------
    chi : two formulas in ``gamma_3``
        χ₁ and χ₂, tied by −γ₃χ₁ + (1 − γ₃²)χ₁′ + γ₃χ₂′ = 0.
    potential : sympy.Expr
        U in ``gamma_3``.
    """
    first, second = chi
    rate = cross(gamma, omega)
    nod = g_1 * omega.symbols[1] - g_2 * omega.symbols[0]
    lean = 1 - g_3**2
    parameters = (
        Parameter(m, "mass", 1.0, "kg", (m > 0,)),
        Parameter(I_1, "moment of inertia across the axis", 0.3, "kg m^2", (I_1 > 0,)),
        Parameter(I_3, "moment of inertia about the axis", 0.2, "kg m^2", (I_3 > 0,)),
    )
    return System(
        name="rubber-profile",
        title="Rubber body of revolution",
        source="§5, (1.18)",
        summary="A body of revolution of any profile rolls on a plane with neither slipping nor "
        "spinning.",
        parameters=parameters,
        definitions={
            U: potential,
            chi_1: first,
            chi_2: second,
            r: constant([chi_1 * g_1, chi_1 * g_2, chi_2]),
            rdot: nod * constant([first.diff(g_3) * g_1, first.diff(g_3) * g_2, second.diff(g_3)])
            + chi_1 * (rate - nod * unit_vector(3)),
            I_2: I_1,
            M: I * omega + m * cross(r, cross(omega, r)),
            X: cross(M, omega)
            - m * cross(r, cross(omega, rdot))
            + potential.diff(g_3) * cross(gamma, unit_vector(3)),
            A: I_1 * g_3**2 + I_3 * lean + m * dot(r, gamma) ** 2,
            B: I_1 + m * norm_squared(r),
            n: cross(gamma, unit_vector(3)),
            w: unit_vector(3) - g_3 * gamma,
        },
        field={
            omega: dot(X, n) / (B * lean) * n + dot(X, w) / (A * lean) * w,
            gamma: rate,
        },
        relations=(norm_squared(gamma) - 1, dot(omega, gamma)),
        laws=(
            Integral("energy", HALF * dot(M, omega) + U, "energy", source="Theorem 1", unit="J"),
        ),
    )
