"""The unbalanced rubber ball seen from its geometric centre (§10.2), and its motion on a torus.

Let J = I_c + mR², with the tensor of inertia I_c about the geometric centre, in the principal axes
of I_c, and κ = 2mR c with c from the centre of mass to the geometric centre.  On (ω, γ) = 0

    (Ĩω, ω) = (Kω, ω),   K = J − s,   s = (κ, γ),
    K ω̇ = Jω×ω + ½ (κ, γ×ω) ω + λγ,   γ̇ = γ×ω,

and with M = Kω the integral (10.5) is |M×γ|² + s (M, ω).  In the roots ξ < η of Σ γᵢ²/(Jᵢ − z)

    (η − s)(η − ξ)² ξ̇² = −4 A(ξ)(F − 2Hξ),   (ξ − s)(η − ξ)² η̇² = 4 A(η)(2Hη − F).

This makes {H, F} = const an invariant torus with the motion of `torus` on it: H and F are
integrals, and γ with the signs of ξ̇, η̇ determines the point of the torus and its velocity.

For s = 0 this is Veselova's system; the factors η − s and ξ − s couple ξ and η.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Integral, Rate
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
)

from ..ball_on_sphere.rubber_ball_sphero_conical import cubic, normal, square
from ..catalogue_entry import Numbers

omega, gamma, kappa, M, X = vectors("omega gamma kappa M X")
J, K, A = Diagonal("J"), Diagonal("K"), Diagonal("A")
s, lambda_0, xi, eta = (real_symbol(name) for name in ("s", "lambda_0", "xi", "eta"))
m, R = real_symbol("m"), real_symbol("R")
#: Angles on the torus, and F/2H, the constant of the torus.
alpha, beta, level = (real_symbol(name) for name in ("alpha", "beta", "lambda"))
xidot, etadot = real_symbol("xidot"), real_symbol("etadot")

NAME, TITLE = "unbalanced-rubber-ball-centred", "Unbalanced rubber ball from its centre"
SUMMARY = (
    "The unbalanced rubber ball on a plane in the principal axes of inertia at its geometric "
    "centre; for these parameters some of its motions, with F/2H from 0.88 to 1.0, approach limit "
    "cycles."
)
SOURCE = "§10.2, (10.4), (10.5)"
DEFAULTS = {
    "J_1": 0.5,
    "J_2": 2.75,
    "J_3": 2.8,
    "kappa_1": 0.05,
    "kappa_2": -0.1,
    "kappa_3": 0.15,
}
#: Well apart, so that J₁ < λ < J₂ < J₃ and |κ| < J₁ hold in a neighbourhood.
APART = {"J_1": 1.0, "J_2": 2.0, "J_3": 3.0, "kappa_1": 0.2, "kappa_2": -0.3, "kappa_3": 0.4}

#: The same with J₁ and J₃ exchanged: with ξ and η exchanged too, the case J₂ < λ < J₃.
SWAPPED_AXES = {**APART, "J_1": APART["J_3"], "J_3": APART["J_1"]}

#: For sphero-conical coordinates of any place.
NET = {**APART, "J_1": 0.5, "J_2": 0.9, "J_3": 1.35}

J_1, J_2, J_3 = J.symbols


def parameters(p: Numbers) -> tuple[Parameter, ...]:
    """J and κ, with the values given."""
    moments = tuple(
        Parameter(
            symbol,
            f"moment of inertia {i} about the geometric centre plus mR²",
            p[str(symbol)],
            "kg m^2",
            (symbol > 0,),
        )
        for i, symbol in enumerate(J.symbols, 1)
    )
    offsets = tuple(
        Parameter(symbol, f"2mR times the {name} offset of the centre", p[str(symbol)], "kg m^2")
        for name, symbol in zip(("first", "second", "third"), kappa.symbols, strict=True)
    )
    return (*moments, *offsets)


ENERGY = Integral("energy", dot(M, omega) / 2, "energy", source="(10.2)", unit="J")
QUADRATIC = Integral(
    "quadratic",
    norm_squared(cross(M, gamma)) + s * dot(M, omega),
    "quadratic integral",
    source="(10.5)",
    unit="kg^2 m^4/s^2",
)


def system_at_centre(p: Numbers = DEFAULTS) -> System:
    """State ω, γ in the principal axes of the geometric centre."""
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=parameters(p),
        definitions={
            s: dot(kappa, gamma),
            K: J - s * identity,
            A: K**-1,
            M: K * omega,
            X: cross(J * omega, omega) + dot(kappa, cross(gamma, omega)) / 2 * omega,
            lambda_0: -dot(A * gamma, X) / dot(A * gamma, gamma),
        },
        field={omega: A * (X + lambda_0 * gamma), gamma: cross(gamma, omega)},
        relations=(norm_squared(gamma) - 1, dot(omega, gamma)),
    )


def balance() -> tuple[System, Identity]:
    """(10.4) with the tensor I = J − mR² − m(c² − c⊗c) about the centre of mass, c = κ/(2mR).

    The excess of Ĩω̇ over its right-hand side without λ₀ is along γ.
    """
    system = system_at_centre()
    sizes = (Parameter(m, "mass", 1.0, "kg"), Parameter(R, "radius of the ball", 0.5, "m"))
    place = kappa / (2 * m * R)
    reach = place - R * gamma
    reach_rate = -R * cross(gamma, omega)

    def about_contact(spin: MatrixExpr) -> MatrixExpr:
        about_centre = m * (norm_squared(place) * spin - dot(place, spin) * place)
        central = J * spin - m * R**2 * spin - about_centre
        return central + m * cross(reach, cross(spin, reach))

    acceleration = A * (X + lambda_0 * gamma)
    free = cross(about_contact(omega), omega) - m * cross(reach, cross(omega, reach_rate))
    excess = cross(gamma, about_contact(acceleration) - free)
    law = Identity("balance", excess, "balance of (10.4) across the normal", source="(10.4)")
    return replace(system, parameters=(*system.parameters, *sizes)), law


def quadratic_forms() -> tuple[System, Identity]:
    """2H and F in ξ̇ and η̇, for ω = γ̇×γ and any number s.

    With A(ξ) < 0 < A(η) they give ξ̇² and η̇² for 2H = 1, F = λ:

        (η − s)(η − ξ)² ξ̇² = −4 A(ξ)(λ − ξ),   (ξ − s)(η − ξ)² η̇² = 4 A(η)(η − λ).
    """
    field = {xi: xidot, eta: etadot, xidot: sp.S.Zero, etadot: sp.S.Zero}
    system = System(
        name="sphero-conical-net",
        title="A point on the sphere in sphero-conical coordinates",
        parameters=(*parameters(NET)[:3], Parameter(s, "s of K = J − s", 0.2, "kg m^2")),
        definitions={gamma: normal()},
        field=field,
    )
    spin = cross(constant([Rate(g) for g in gamma.symbols]), gamma)
    momentum = J * spin - s * spin
    first = (eta - s) * xidot**2 / -cubic(xi)
    second = (xi - s) * etadot**2 / cubic(eta)
    energy = dot(momentum, spin)
    quadratic = norm_squared(cross(momentum, gamma)) + s * dot(momentum, spin)
    values = (
        energy - (eta - xi) / 4 * (first + second),
        quadratic - (eta - xi) / 4 * (eta * first + xi * second),
    )
    return system, Identity("forms", values, "energy and integral on the sphere", source="§10.2")


def torus(numbers: Numbers = APART, constant_of_torus: float = 1.4) -> System:
    """The motion with 2H = 1 and F = λ on its torus, λ between J₁ and J₂.

    `APART` has J₁ < λ < J₂; `SWAPPED_AXES`, with λ from 2 to 3, stands for J₂ < λ < J₃.

    State α, β with ξ = J₁cos²β + λsin²β, η = J₂cos²α + J₃sin²α; its time τ has
    dt = (η − ξ) √((ξ − s)(η − s)) dτ.  The definitions P² and Q² hold (dβ/dτ)² and (dα/dτ)².
    """
    P, Q = real_symbol("P"), real_symbol("Q")
    place = (
        sp.sin(beta) * sp.sqrt((level - J_1) * (eta - J_1) / ((J_2 - J_1) * (J_3 - J_1))),
        sp.sin(alpha) * sp.sqrt((J_2 - xi) / (J_2 - J_1)),
        sp.cos(alpha) * sp.sqrt((J_3 - xi) / (J_3 - J_1)),
    )
    return System(
        name="unbalanced-rubber-ball-torus",
        title="Unbalanced rubber ball on its torus",
        parameters=(
            *parameters(numbers),
            Parameter(level, "constant F/2H of the torus", constant_of_torus, "kg m^2"),
        ),
        definitions={
            xi: J_1 * sp.cos(beta) ** 2 + level * sp.sin(beta) ** 2,
            eta: J_2 * sp.cos(alpha) ** 2 + J_3 * sp.sin(alpha) ** 2,
            gamma: constant(place),
            s: dot(kappa, gamma),
            P: (J_2 - xi) * (J_3 - xi) * (xi - s),
            Q: (eta - J_1) * (eta - level) * (eta - s),
        },
        field={alpha: sp.sqrt(Q), beta: sp.sqrt(P)},
    )


def on_torus(system: System | None = None) -> tuple[System, Identity]:
    """That α and β give ξ, η and γ as they should: (9.6), and ξ′², η′² by `quadratic_forms`."""
    system = system or torus()
    squares = tuple(g**2 - square(i, xi, eta) for i, g in enumerate(gamma.symbols))
    rates = (
        Rate(xi) ** 2 + 4 * cubic(xi) * (level - xi) * (xi - s),
        Rate(eta) ** 2 - 4 * cubic(eta) * (eta - level) * (eta - s),
    )
    return system, Identity("torus", (*squares, *rates), "motion on the torus", source="§10.2")
