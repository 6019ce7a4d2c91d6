"""The rubber ball on a sphere for k = −1 in the coordinates that separate (§9.5).

u and v are the roots of Σ nᵢ²/(Jᵢ(Jᵢ − z)); with ρ² = 1/(tr J − u − v) and dτ = ρ⁻³ dt

    H = 2 (A(u) p_u² − A(v) p_v²) / (det J (tr J − u − v)(u − v)).
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Identity, Integral, Law, Rate, Separation
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, vectors

from . import rubber_ball_on_e3, rubber_ball_ratio as ratio
from .rubber_ball_ratio import DET_J, RHO_SQUARED, A, J, k
from .rubber_ball_sphero_conical import CANONICAL, cubic

omega, n, e, edot = vectors("omega n e edot")
u, v, p_u, p_v = (real_symbol(name) for name in ("u", "v", "p_u", "p_v"))
udot, vdot = real_symbol("udot"), real_symbol("vdot")
Delta, rho, h, F, C = (real_symbol(name) for name in ("Delta", "rho", "h", "F", "C"))
#: A(u), A(v), their derivatives, and what 𝓗 is divided by.
A_u, A_v, B_u, B_v, Q, H = (real_symbol(name) for name in ("A_u", "A_v", "B_u", "B_v", "Q", "H"))

NAME, TITLE = "rubber-ball-separated", "Hollow rubber ball around a sphere, separated"
SUMMARY = (
    "The rubber ball on a sphere for k = −1 in canonical coordinates that separate, in the time "
    "dτ = N dt."
)
SOURCE = "§9.5"
DEFAULTS = {"J_1": 0.5, "J_2": 0.9, "J_3": 1.35}

TRACE = sp.Add(*J.symbols)
#: ρ² in u and v.
SPREAD = 1 / (TRACE - u - v)
#: 𝓗 as printed.
HAMILTONIAN = 2 * (cubic(u) * p_u**2 - cubic(v) * p_v**2) * SPREAD / (DET_J * (u - v))
#: The same in the named quantities.
ENERGY = (A_u * p_u**2 - A_v * p_v**2) / Q
#: Twice the kinetic energy is LEVER (u̇²/A(u) − v̇²/A(v)).
LEVER = DET_J * SPREAD**2 * (u - v) / 4


def roots(
    first: sp.Symbol, second: sp.Symbol, total: sp.Expr, product: sp.Expr
) -> dict[sp.Symbol, sp.Expr]:
    """The roots of a quadratic with the given sum and product.

    Returns
    -------
    dict
        The distance Δ of the roots, then the smaller and the larger one.
    """
    return {
        Delta: sp.sqrt(total**2 - 4 * product),
        first: (total - Delta) / 2,
        second: (total + Delta) / 2,
    }


#: Sum and product of the roots of Σ nᵢ²/(Jᵢ − z), (9.5), and of Σ nᵢ²/(Jᵢ(Jᵢ − z)).
PLAIN = (TRACE - dot(n, J * n), DET_J * RHO_SQUARED)
WITH_DENSITY = (TRACE - 1 / RHO_SQUARED, DET_J * norm_squared(A * n) / RHO_SQUARED)


def separation() -> Separation:
    """On (9.2) for k = −1: y² = A(z)(2hz(tr J − z) − F) for z = u, v.

    There y = ½ (det J)^(1/2) ρ (u − v) ż, h is the energy and F the integral (9.4).
    """
    quantities = {
        rho: sp.sqrt(RHO_SQUARED),
        **roots(u, v, *WITH_DENSITY),
        h: dot(J * omega, omega) / 2,
        F: ratio.AROUND.value,
    }
    return Separation(
        "separation",
        quantities,
        (
            *(
                DET_J * RHO_SQUARED * (u - v) ** 2 * Rate(z) ** 2 / 4
                - cubic(z) * (2 * h * z * (TRACE - z) - F)
                for z in (u, v)
            ),
            Rate(h),
            Rate(F),
        ),
        meaning="separated equations of the case k = −1",
        level=(k + 1,),
        source="§9.5",
    )


def canonical_form() -> System:
    """State u, v, p_u, p_v; the time is τ.  ω and n are definitions, k = −1."""
    field = {
        u: 2 * A_u * p_u / Q,
        v: -2 * A_v * p_v / Q,
        p_u: (H * DET_J * (TRACE - 2 * u) / 2 - B_u * p_u**2) / Q,
        p_v: (B_v * p_v**2 - H * DET_J * (TRACE - 2 * v) / 2) / Q,
    }
    direction = []
    for own in J.symbols:
        others = sp.Mul(*(own - j for j in J.symbols if j != own))
        direction.append(sp.sqrt(own * (own - u) * (own - v) / others))
    turning = constant(
        [
            -s / 2 * (udot / (j - u) + vdot / (j - v))
            for s, j in zip(e.symbols, J.symbols, strict=True)
        ]
    )
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=rubber_ball_on_e3.parameters({**DEFAULTS, "k": -1.0})[:3],
        definitions={
            A_u: cubic(u),
            A_v: cubic(v),
            B_u: sp.diff(cubic(u), u),
            B_v: sp.diff(cubic(v), v),
            Q: DET_J / 2 * (TRACE - u - v) * (u - v),
            H: ENERGY,
            rho: sp.sqrt(SPREAD),
            udot: field[u] / rho**3,
            vdot: field[v] / rho**3,
            e: constant(direction),
            edot: turning,
            n: rho * e,
            omega: rho**2 * cross(e, edot),
        },
        field=field,
    )


def to_ball() -> Isomorphism:
    """From u, v, p_u, p_v to ω, n of (9.2) with k = −1."""
    return Isomorphism(
        "ball",
        ratio.rolling(),
        {omega: omega, n: n},
        time=rho**3,
        constants={k: sp.S.NegativeOne},
        meaning="from separating coordinates to the angular velocity and the normal",
        source="§9.5",
    )


#: ½F det J by the separated equations: A(z) p_z² = ½ det J (H z(tr J − z) − C).
CONSTANT = Integral(
    "separation",
    H * u * (TRACE - u) - 2 * A_u * p_u**2 / DET_J,
    "constant of the separation",
    source="§9.5",
    unit="kg m^2/s^2",
)


def separation_law() -> Separation:
    """Q² z′² = 2 det J A(z) (h z(tr J − z) − C) for z = u, v, with the values h of 𝓗 and C."""
    return Separation(
        "separated",
        {h: H, C: CONSTANT.value},
        (
            *(
                Q**2 * Rate(z) ** 2 - 2 * DET_J * curve * (h * z * (TRACE - z) - C)
                for z, curve in ((u, A_u), (v, A_v))
            ),
            Rate(h),
            Rate(C),
        ),
        meaning="separated equations",
        source="§9.5",
    )


def momenta() -> Identity:
    """A(z) p_z² = ½ det J (H z(tr J − z) − C) and z′ = ±2 A(z) p_z / Q for z = u, v."""
    energies = tuple(
        cubic(z) * p**2 - DET_J / 2 * (H * z * (TRACE - z) - C) for z, p in ((u, p_u), (v, p_v))
    )
    velocities = (Q * Rate(u) - 2 * A_u * p_u, Q * Rate(v) + 2 * A_v * p_v)
    return Identity(
        "momenta",
        (*energies, *velocities),
        "separated momenta",
        {C: CONSTANT.value},
        source="§9.5",
    )


def laws() -> tuple[Law, ...]:
    """All laws of the canonical form."""
    return (
        Integral("energy", ENERGY, "energy", source="§9.5", unit="J"),
        CONSTANT,
        ConformallyHamiltonian(
            "hamiltonian", sp.S.One, CANONICAL, H, "canonical form", source="§9.5"
        ),
        separation_law(),
        momenta(),
        to_ball(),
    )
