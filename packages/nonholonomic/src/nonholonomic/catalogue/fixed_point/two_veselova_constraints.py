"""A body about a fixed point under two constraints of Veselova: (ω, n₁) and (ω, n₂) are constant.

Let γ be the direction normal to n₁ and n₂, and dα, |α| = 1, any vector fixed in space whose
products with n₁ and n₂ are the two constants.  Then ω = dα + wγ, and the torque of the constraints,
perpendicular to γ, leaves

    (γ, Iγ) ẇ = ((Iω + k)×ω + Kα×Iα, γ),    α̇ = w α×γ,    γ̇ = d γ×α.

The choice of α is free up to a multiple of γ, which changes w by a constant; so the angle between α
and γ may be any, a right one as in the start below.  For d = 0 the axis γ is fixed in the body too,
the constraints are holonomic, and the body turns about it.  For d ≠ 0 they do work, and

    h = ½w²(γ, Iγ) + ½(K − d²)(α, Iα) − d(k, α),

the energy less d(Iω + k, α), is constant: a field of strength K = d² is not felt in it.  Without a
field the momentum (Iω + k, γ) is constant as well, since the reactions have no component along γ,
and the motion is integrable by the theorem of Euler and Jacobi.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import Observable, Parameter, System
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, real_symbol, vectors

from .. import e3
from ..catalogue_entry import Entry, Numbers, Start
from ..parameter_conditions import holding
from ..rotors_and_field import rotors_and_field
from .veselova import moments

omega, alpha, gamma, k = vectors("omega alpha gamma k")
I = Diagonal("I")
w, d, K = real_symbol("w"), real_symbol("d"), real_symbol("K")
HALF = sp.Rational(1, 2)
SOURCE = "§12, problem 1"

TITLE = "Body under two constraints of Veselova"
SUMMARY = (
    "A rigid body with rotors turns about its centre of mass in the potential U = ½K(α, Iα); the "
    "components of its angular velocity along two directions fixed in space are constant, so that "
    "ω = dα + wγ with the normal γ of both. For d = 0 it turns about a fixed axis; without the "
    "field it is integrable for every d."
)


def laws() -> tuple[Law, ...]:
    """Energy integral and measure; momentum without a field; for d = 0 the axis."""
    energy = (
        HALF * w**2 * dot(gamma, I * gamma)
        + HALF * (K - d**2) * dot(alpha, I * alpha)
        - d * dot(k, alpha)
    )
    return (
        Integral(
            "energy", energy, "energy less d times the momentum along α", source=SOURCE, unit="J"
        ),
        Integral(
            "angle", dot(alpha, gamma), "cosine of the angle of α and γ", source=SOURCE, unit="1"
        ),
        Integral(
            "momentum",
            dot(I * omega + k, gamma),
            "momentum along γ",
            on=(K,),
            source=SOURCE,
            unit="kg m^2/s",
        ),
        *(
            Integral(
                f"axis_{i}",
                component,
                f"component {i} of the axis",
                on=(d,),
                source=SOURCE,
                unit="1",
            )
            for i, component in enumerate(gamma.symbols, 1)
        ),
        Measure(
            "measure",
            {dot(gamma, I * gamma): HALF},
            "invariant measure ρ dw d³α d³γ",
            source=SOURCE,
        ),
    )


def build(p: Numbers) -> System:
    """With rotors, in the field."""
    torque = cross(I * omega + k, omega) + K * cross(alpha, I * alpha)
    return System(
        name="two-veselova-constraints",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            *e3.inertia_parameters(moments(p)),
            *rotors_and_field(p),
            Parameter(d, "angular velocity along α", p["d"], "rad/s"),
        ),
        definitions={omega: d * alpha + w * gamma},
        field={
            w: dot(torque, gamma) / dot(gamma, I * gamma),
            alpha: w * cross(alpha, gamma),
            gamma: d * cross(gamma, alpha),
        },
        relations=(norm_squared(alpha) - 1, norm_squared(gamma) - 1),
        laws=holding(laws(), p),
        observables=(Observable("omega", omega, "angular velocity", "rad/s", "body"),),
    )


NUMBERS = {
    **{"I_1": 1.0, "I_2": 1.5, "I_3": 2.1},
    **{"k_1": 0.0, "k_2": 0.0, "k_3": 0.0, "K": 0.0, "d": 1.0},
}


def general() -> System:
    """With the laws of d = 0."""
    return replace(build(NUMBERS), laws=tuple(law for law in laws() if law.on))


ENTRIES = (
    Entry(
        name="two-veselova-constraints",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=NUMBERS,
        build=build,
        start=Start(
            state={
                "w": 0.7,
                "alpha": (6 / 7, 2 / 7, -3 / 7),
                "gamma": (3 / 7, -6 / 7, 2 / 7),
            },
            until=60.0,
        ),
        variables={
            "w": ("angular velocity along γ", "rad/s"),
            "alpha": ("direction fixed in space", "1"),
            "gamma": ("normal to the directions of both constraints", "1"),
        },
        general=general,
    ),
)
