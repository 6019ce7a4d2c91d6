"""The Hamiltonian system (6.13) on e(3), which contains the Veselova system (6.12)."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import constant, dot, norm_squared, real_symbol, to_components

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Entry, Numbers, Start
from ..e3 import Gamma, I, M, e3_system, inertia_parameters
from . import clebsch, neumann
from .clebsch import alpha, beta
from .neumann import c

I_1, I_2, I_3 = I.symbols
HALF = sp.Rational(1, 2)

#: The two terms of (6.13); the first is (6.12) without a potential.
FIRST = HALF * norm_squared(M) * dot(Gamma, I * Gamma)
SECOND = HALF * (dot(M, I * M) * dot(Gamma, I * Gamma) - dot(M, I * Gamma) ** 2)

#: I^(1/2) and 1/ρ_ω = (Γ, IΓ)^(1/2).
ROOT = constant(sp.diag(*(sp.sqrt(s) for s in I.symbols)))
LENGTH = sp.sqrt(dot(Gamma, I * Gamma))

TITLE = "Geodesic flow of the Veselova system"
SUMMARY = (
    "The Hamiltonian system on e(3), at zero area constant, to which the Veselova system is "
    "equivalent for α = 1 and β = 0; the Hamiltonian contains β times its second integral."
)
SOURCE = "§6.3, (6.11)–(6.13)"


def in_potential(potential: sp.Expr, moments: tuple[float, float, float]) -> System:
    """(6.12): H = ½(Γ, IΓ)M² + U(γ), with γ = (Γ, IΓ)^(−1/2) I^(1/2) Γ.

    Parameters
    ----------
    potential : sympy.Expr
        U, as a formula in ``gamma_1``, ``gamma_2``, ``gamma_3`` (body axes).
    moments : 3 floats
        Defaults of the parameters I_1, I_2, I_3.
    """
    normal = to_components(ROOT * to_components(Gamma)) / to_components(LENGTH)
    names = [real_symbol(f"gamma_{i}") for i in (1, 2, 3)]
    here = potential.subs(dict(zip(names, normal, strict=True)), simultaneous=True)
    return e3_system(
        "veselova-on-e3",
        "Veselova system on e(3)",
        FIRST + here,
        inertia_parameters(moments),
        level=(dot(M, Gamma),),
        source="§6.3, (6.11), (6.12)",
        summary="The Veselova system in a potential, as a Hamiltonian system on e(3).",
    )


def build(p: Numbers) -> System:
    """H of (6.13)."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    target = clebsch.build({**p, "c": 1.0})
    return e3_system(
        "veselova-geodesic-flow",
        TITLE,
        alpha * FIRST + beta * SECOND,
        (
            *inertia_parameters(moments),
            Parameter(alpha, "weight of the Veselova Hamiltonian", p["alpha"], "1"),
            Parameter(beta, "weight of the second integral", p["beta"], "1/(kg m^2)"),
        ),
        level=(dot(M, Gamma),),
        laws=(
            Integral("first", FIRST, "Veselova Hamiltonian", source="(6.12)"),
            Integral("second", SECOND, "second quadratic integral", source="(6.13)"),
            replace(
                to_clebsch(target),
                as_printed=to_clebsch(target, -1),
                misprint="sign of k, with the equations (6.11)",
            ),
        ),
        source=SOURCE,
        summary=SUMMARY,
        unit="",
    )


def to_clebsch(target: System, sign: int = 1) -> Isomorphism:
    """Proposition 6: L = I^(−1/2) M and s = (Γ, IΓ)^(−1/2) I^(1/2) Γ move as the Clebsch case.

    Their time is kτ with k = `sign` √det I.
    """
    inverse = constant(sp.diag(*(1 / sp.sqrt(s) for s in I.symbols)))
    return Isomorphism(
        "clebsch",
        target,
        {
            M: inverse * M,
            Gamma: ROOT * Gamma / LENGTH,
        },
        sign * sp.sqrt(I_1 * I_2 * I_3),
        {c: norm_squared(M) * dot(Gamma, I * Gamma) / (I_1 * I_2 * I_3)},
        "Clebsch case with c = M²(Γ, IΓ)/det I",
        onto=(dot(M, Gamma), neumann.SECOND),
        source="Proposition 6",
    )


ENTRIES = (
    Entry(
        name="veselova-geodesic-flow",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults={"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "alpha": 1.0, "beta": 0.7},
        build=build,
        start=Start(
            state={"M": (0.9, -0.2, -0.4), "Gamma": (2 / 7, -3 / 7, 6 / 7)},
            until=60.0,
        ),
    ),
)
