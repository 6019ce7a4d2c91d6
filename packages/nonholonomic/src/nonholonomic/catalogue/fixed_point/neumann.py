"""The Neumann system: a point on a sphere in a quadratic potential (§6.3)."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Integral, Rate, Separation
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import dot, norm_squared, real_symbol

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers
from ..e3 import Gamma, H, I, M, e3_system, inertia_parameters

c = real_symbol("c")
#: Sphero-conical coordinates: the roots u > v of Σ Γᵢ²/(Iᵢ − z) = 0 on the sphere Γ² = 1.
u, v, Delta = (real_symbol(s) for s in ("u", "v", "Delta"))
#: The values of the two integrals.
h, f = real_symbol("h"), real_symbol("f")
I_1, I_2, I_3 = I.symbols
SECOND = (dot(M, I * M) - c * I_1 * I_2 * I_3 * dot(Gamma, I**-1 * Gamma)) / 2

TITLE = "Neumann system"
SUMMARY = (
    "A point moves on a sphere in a quadratic potential: the Clebsch case with α = 1 and β = 0, "
    "at zero area constant."
)
SOURCE = "§6.3, (6.14), Theorem 8"
STRENGTH = "strength of the potential"


def sphero_conical_coordinates(normal: MatrixExpr) -> dict[sp.Symbol, sp.Expr]:
    """u and v, and before them their distance, for a unit vector in body axes."""
    total = sp.Add(*I.symbols) - dot(normal, I * normal)
    product = sp.Mul(*I.symbols) * dot(normal, I**-1 * normal)
    return {
        Delta: sp.sqrt(total**2 - 4 * product),
        u: (total + Delta) / 2,
        v: (total - Delta) / 2,
    }


def cubic(z: sp.Expr) -> sp.Expr:
    """A(z) = (I₁ − z)(I₂ − z)(I₃ − z)."""
    return sp.Mul(*(s - z for s in I.symbols))


def build(p: Numbers) -> System:
    """H = ½M² + ½c(Γ, IΓ) at (M, Γ) = 0; Γ is the place of the point, Γ×M its velocity."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    return e3_system(
        "neumann",
        TITLE,
        (norm_squared(M) + c * dot(Gamma, I * Gamma)) / 2,
        (*inertia_parameters(moments), Parameter(c, STRENGTH, p["c"], "1/(kg m^2)")),
        level=(dot(M, Gamma),),
        laws=(
            Integral(
                "second",
                SECOND,
                "second quadratic integral, of the Clebsch case",
                source="(6.14)",
            ),
            separation(),
        ),
        source=SOURCE,
        summary=SUMMARY,
        unit="",
    )


def separation() -> Separation:
    """(u − v)² ż² = 8A(z)((h − ½c tr I) z + ½c z² − f) for z = u, v."""
    trace = I_1 + I_2 + I_3
    return Separation(
        "separation",
        {**sphero_conical_coordinates(Gamma), h: H, f: SECOND},
        (
            *(
                (u - v) ** 2 * Rate(z) ** 2
                - 8 * cubic(z) * ((h - c * trace / 2) * z + c * z**2 / 2 - f)
                for z in (u, v)
            ),
            Rate(h),
            Rate(f),
        ),
        "separated equations in sphero-conical coordinates",
        source="Remark 16",
    )
