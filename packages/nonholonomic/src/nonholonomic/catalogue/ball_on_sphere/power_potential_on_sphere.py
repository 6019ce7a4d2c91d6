"""A point on a unit sphere in the potential −h (γ, Jγ)^(−1/k), (9.16), (9.17).

On the level H̃ = 0 its trajectories are those of the rubber ball on a sphere with the ratio k.
k = 1 is Braden's system, k = −1 is Neumann's.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import dot, norm_squared, real_symbol

from .rubber_ball_on_e3 import DET_J, J, M, gamma, k, on_e3

h = real_symbol("h")

NAME, TITLE = "power-potential-on-sphere", "Point on a sphere in a power of a quadratic form"
SUMMARY = (
    "A point moves on a unit sphere in the potential −h (γ, Jγ)^(−1/k): Braden's system for k = 1, "
    "Neumann's for k = −1."
)
SOURCE = "§9.4, (9.16), (9.17)"
DEFAULTS = {"J_1": 2.0, "J_2": 2.5, "J_3": 3.1, "k": 1.0, "h": 1.0}

STRETCH = dot(gamma, J * gamma)
#: (γ, J⁻¹γ), in the components of J.
SQUEEZE = sp.Add(*(s**2 / j for s, j in zip(gamma.symbols, J.symbols, strict=True)))
POTENTIAL = -h * STRETCH ** (-1 / k)
HAMILTONIAN = norm_squared(M) / 2 + POTENTIAL

BRADEN = Integral(
    "braden",
    (
        sp.Add(*(s**2 / j for s, j in zip(M.symbols, J.symbols, strict=True))) / 2
        - h * (sp.Add(*(1 / j for j in J.symbols)) - SQUEEZE) / STRETCH
    ),
    "quadratic integral of Braden's system, k = 1",
    level=(k - 1,),
    source="§9.4",
    unit="kg m^2/s^2",
)
NEUMANN = Integral(
    "neumann",
    dot(M, J * M) / 2 + h * DET_J * SQUEEZE,
    "quadratic integral of Neumann's system, k = −1",
    level=(k + 1,),
    source="§9.4",
    unit="kg^3 m^6/s^2",
)


def parameters(p: Mapping[str, float]) -> tuple[Parameter, ...]:
    """J, k and h, with the values given."""
    tensor = tuple(
        Parameter(
            s, f"eigenvalue {i} of the tensor in the potential", p[str(s)], "kg m^2", (s > 0,)
        )
        for i, s in enumerate(J.symbols, 1)
    )
    return (
        *tensor,
        Parameter(k, "exponent: the potential is a power −1/k", p["k"], "1", (sp.Ne(k, 0),)),
        Parameter(h, "strength of the potential", p["h"], "J"),
    )


def moving(p: Mapping[str, float] = DEFAULTS) -> System:
    """State M, γ with (M, γ) = 0; M = γ×γ′ up to sign."""
    system = on_e3(HAMILTONIAN, parameters(p), source="(9.17)")
    return replace(system, name=NAME, title=TITLE, summary=SUMMARY, source=SOURCE)


def integrable() -> System:
    """The point for any k, with the integrals of the two integrable exponents."""
    return moving().with_laws(BRADEN, NEUMANN)
