"""The Chaplygin ball at zero area constant and the Clebsch case (§7.5).

Two isomorphisms, both on (M, γ) = 0: on a level of (M, M) by Theorem 10, and on a level of
M² − 2DH by Fedorov, K = (1 − D(γ, J⁻¹γ))^(1/2) Iω.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism, with_any_parameters
from flowlanes.system.laws import Integral
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers
from ..e3 import Gamma, M as CLEBSCH_MOMENTUM, inertia_parameters
from ..file_systems import file_system
from ..fixed_point import clebsch, neumann
from ..fixed_point.neumann import c
from .chaplygin_bracket import DET_IQ, DET_J, A, D, J, gamma

M, K, omega = vectors("M K omega")
I = Diagonal("I")
beta = real_symbol("beta")

DET_I = sp.Mul(*I.symbols)
INVERSE = I**-1
AREA = (dot(M, gamma),)
#: The diagonals of B = IJ⁻¹ and of its root.
WIDTHS = tuple(i * a for i, a in zip(I.symbols, A.symbols, strict=True))
ROOTS = tuple(sp.sqrt(b) for b in WIDTHS)
#: (γ, Bγ) = (Iγ, J⁻¹γ) = 1 − D(γ, J⁻¹γ).
SPREAD = dot(I * gamma, A * gamma)

TITLE = "Chaplygin ball in Fedorov's variables"
SUMMARY = (
    "The system on e(3), a Clebsch case, to which the Chaplygin ball without a field is equivalent "
    "at zero area constant."
)
SOURCE = "§7.5, 2"


def fedorov(p: Numbers) -> System:
    """K′ = K×I⁻¹K − βγ×Iγ, γ′ = γ×I⁻¹K."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    target = with_any_parameters(clebsch.build({**p, "c": 1.0, "alpha": 0.0, "beta": 1.0}))
    return System(
        name="chaplygin-ball-fedorov",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            *inertia_parameters(moments),
            Parameter(beta, "D/det J times the level of M² − 2DH", p["beta"], "1/s^2"),
        ),
        field={
            K: cross(K, INVERSE * K) - beta * cross(gamma, I * gamma),
            gamma: cross(gamma, INVERSE * K),
        },
        relations=(norm_squared(gamma) - 1,),
        laws=(
            Integral(
                "energy",
                (dot(K, INVERSE * K) - beta * dot(gamma, I * gamma)) / 2,
                "Hamiltonian function",
                source=SOURCE,
                unit="J",
            ),
            Integral("area", dot(K, gamma), "area integral", source=SOURCE, unit="kg m^2/s"),
            Integral(
                "clebsch",
                norm_squared(K) + beta * DET_I * dot(gamma, INVERSE * gamma),
                "integral of Clebsch",
                source=SOURCE,
                unit="kg^2 m^4/s^2",
            ),
            Isomorphism(
                "clebsch_case",
                target,
                {CLEBSCH_MOMENTUM: K, Gamma: gamma},
                constants={
                    **{s: 1 / s for s in I.symbols},
                    c: beta * DET_I,
                    clebsch.alpha: sp.S.Zero,
                    clebsch.beta: sp.S.One,
                },
                meaning="Clebsch case (6.14) with I⁻¹ for I, α = 0, β = 1",
                source=SOURCE,
            ),
        ),
    )


def onto_clebsch() -> Isomorphism:
    """Theorem 10: the ball without a field on a level of (M, M), at (M, γ) = 0."""
    density = 1 / sp.sqrt(DET_IQ)
    momentum = constant([density * s / root for s, root in zip(M, ROOTS, strict=True)])
    place = [root * g / sp.sqrt(SPREAD) for root, g in zip(ROOTS, gamma, strict=True)]
    printed = [p / b for p, b in zip(place, WIDTHS, strict=True)]
    law = Isomorphism(
        "clebsch_case",
        with_any_parameters(file_system("clebsch", {})),
        {CLEBSCH_MOMENTUM: momentum, Gamma: constant(place)},
        density * DET_J / D * sp.Mul(*ROOTS),
        constants={
            **dict(zip(I.symbols, WIDTHS, strict=True)),
            c: density**2 * norm_squared(M) * SPREAD / sp.Mul(*WIDTHS),
            clebsch.alpha: sp.S.One,
            clebsch.beta: -sp.S.One,
        },
        meaning="Clebsch case (6.14) with I = IJ⁻¹, α = 1, β = −1",
        onto=(dot(CLEBSCH_MOMENTUM, Gamma), neumann.SECOND),
        level=AREA,
        source="Theorem 10",
    )
    return replace(
        law,
        as_printed=replace(law, map={CLEBSCH_MOMENTUM: momentum, Gamma: constant(printed)}),
        misprint="B^(−1/2) for B^(1/2) in s",
    )


def onto_fedorov() -> Isomorphism:
    """Fedorov's isomorphism: the ball without a field on a level of M² − 2DH, at (M, γ) = 0."""
    density = sp.sqrt(1 - D * dot(gamma, A * gamma))
    momentum = density * (I * omega)
    level = dot(J * momentum, INVERSE * momentum) / dot(I * gamma, A * gamma)
    law = Isomorphism(
        "fedorov",
        fedorov(NUMBERS),
        {K: momentum, gamma: gamma},
        1 / density,
        constants={beta: D / DET_J * level},
        meaning="Clebsch case in Fedorov's variables",
        onto=(dot(K, gamma), beta * DET_J * SPREAD - D * dot(J * K, INVERSE * K)),
        level=AREA,
        source=SOURCE,
    )
    return replace(
        law,
        as_printed=replace(
            law,
            target=_printed_by(law.target),
            constants=(*law.constants, *((s, s) for s in J.symbols)),
        ),
        misprint="J⁻¹ for I⁻¹ in the rate of γ",
    )


def _printed_by(right: System) -> System:
    """The final system of §7.5 as printed."""
    moments = tuple(
        Parameter(s, f"moment of inertia J = I + D about body axis {i}", 1.0, "kg m^2")
        for i, s in enumerate(J.symbols, 1)
    )
    rates = dict(right.field) | {gamma: cross(gamma, J**-1 * K)}
    return replace(right, parameters=right.parameters + moments, field=rates, laws=())


NUMBERS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "beta": 0.6}
