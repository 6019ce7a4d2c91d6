"""Constants and the equation of u = (γ, e) for bodies of revolution, as provable laws.

With I₁ = I₂, so that e is the third body axis; other axes follow by renaming.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law, Rate, Reduction
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, to_components, vectors
from nonholonomic.catalogue.chaplygin_ball import chaplygin_bracket
from nonholonomic.catalogue.fixed_point.veselova import F, I, gamma, h, omega

(M,) = vectors("M")
u, own, f, g = (real_symbol(s) for s in ("u", "c_squared", "f", "g"))
I_1, I_2, I_3 = I.symbols

#: Two equal moments.
EQUAL = (I_1 - I_2,)


def veselova_laws() -> tuple[Law, ...]:
    """c² = ω₃²G is constant, I₁u̇² = 2h(1 − u²) − c², and F = 2hI₁ + (I₃ − I₁)c²."""
    _, _, omega_3 = omega.symbols
    _, _, gamma_3 = gamma.symbols
    G = I_3 + (I_1 - I_3) * gamma_3**2
    L = cross(I * omega, gamma)
    L_3, across = to_components(L)[2], to_components(cross(gamma, L))[2]
    energy = dot(omega, I * omega) / 2
    return (
        Integral(
            "axial",
            omega_3**2 * G,
            "constant of a body with I₁ = I₂",
            level=EQUAL,
            source="§6.1",
        ),
        Reduction(
            "nutation",
            {u: gamma_3, own: omega_3**2 * G, h: energy},
            (I_1 * Rate(u) ** 2 - 2 * h * (1 - u**2) + own, Rate(own), Rate(h)),
            "equation of the angle between the vertical and the axis of symmetry",
            level=EQUAL,
            source="§6.1",
        ),
        Identity(
            "axis",
            (
                F - 2 * h * I_1 - (I_3 - I_1) * own,
                # the components of e in the frame of γ and L
                L_3 + I_1 * Rate(gamma_3),
                across**2 - own * G,
            ),
            "the axis of symmetry in the frame of the vertical and the momentum",
            {own: omega_3**2 * G, h: energy, F: norm_squared(L)},
            level=EQUAL,
            source="§6.1",
        ),
    )


def chaplygin_laws() -> tuple[Law, ...]:
    """K² is constant, and (I₁ + D)²u̇² = f(1 − u²) − g² + 2guM₃ − M₃²."""
    D, A = chaplygin_bracket.D, chaplygin_bracket.A
    _, _, M_3 = M.symbols
    _, _, gamma_3 = gamma.symbols
    W = 1 - D * dot(gamma, A * gamma)
    area = dot(M, gamma)
    spun = (M_3 + D * area * gamma_3 / I_1) ** 2
    A_1, _, A_3 = A.symbols
    return (
        Integral(
            "axial",
            spun / W,
            "constant of a ball with I₁ = I₂",
            level=EQUAL,
            source="§7.1",
        ),
        Reduction(
            "nutation",
            {u: gamma_3, f: norm_squared(M), g: area, own: spun / W},
            (
                (I_1 + D) ** 2 * Rate(u) ** 2
                - f * (1 - u**2)
                + g**2
                - 2 * g * u * M_3
                + sp.sympify(M_3) ** 2,
                (M_3 + D * g * u / I_1) ** 2 - own * (1 - D * (A_1 * (1 - u**2) + A_3 * u**2)),
                *map(Rate, (f, g, own)),
            ),
            "equation of the angle between the vertical and the axis of symmetry",
            level=EQUAL,
            source="§7.1",
        ),
    )
