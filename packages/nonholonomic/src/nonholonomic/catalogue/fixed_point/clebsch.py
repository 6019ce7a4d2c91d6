"""The Clebsch case of the Kirchhoff equations, as (6.14) writes it (§6.3)."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import dot, norm_squared, real_symbol

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers
from ..e3 import Gamma, I, M, e3_system, inertia_parameters
from .neumann import SECOND, STRENGTH, c

alpha, beta = real_symbol("alpha"), real_symbol("beta")
HALF = sp.Rational(1, 2)

#: With `SECOND` the two quadratic integrals, in involution on the whole of e(3).
FIRST = HALF * (norm_squared(M) + c * dot(Gamma, I * Gamma))

TITLE = "Clebsch case"
SUMMARY = (
    "A rigid body in an ideal fluid, in Clebsch's integrable case: α = 1, β = 0 is the Neumann "
    "system, α = 0, β = 1 the Bruns problem."
)
SOURCE = "§6.3, (6.14)"


def build(p: Numbers) -> System:
    """H = α ½(M² + c(Γ, IΓ)) + β ½((M, IM) − c det I (Γ, I⁻¹Γ))."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    return e3_system(
        "clebsch",
        TITLE,
        alpha * FIRST + beta * SECOND,
        (
            *inertia_parameters(moments),
            Parameter(c, STRENGTH, p["c"], "1/(kg m^2)"),
            Parameter(alpha, "weight of the Neumann Hamiltonian", p["alpha"], "1"),
            Parameter(beta, "weight of the Bruns Hamiltonian", p["beta"], "1/(kg m^2)"),
        ),
        laws=(
            Integral("area", dot(M, Gamma), "area integral", source="Proposition 6"),
            Integral("neumann", FIRST, "Hamiltonian of the Neumann system", source="(6.14)"),
            Integral("bruns", SECOND, "Hamiltonian of the Bruns problem", source="(6.14)"),
        ),
        source=SOURCE,
        summary=SUMMARY,
        unit="",
    )
