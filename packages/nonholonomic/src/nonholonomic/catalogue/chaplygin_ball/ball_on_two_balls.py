"""A ball on two equal supporting balls at right angles: the Chaplygin ball with D → −D (§12).

In a ball bearing (:mod:`.ball_bearing`) with two equal weights D and orthogonal directions α, β the
tensor of the supports is D(E − γ⊗γ), γ = α×β, and the momentum becomes

    M = Iω + D(ω + (ω, γ)γ) = Jω + D(ω, γ)γ,    J = I + D,

where the Chaplygin ball has −D(ω, γ)γ.  Every law of that ball holds with the sign of D changed in
it, and the ball has a conformally Hamiltonian form, with rotors and in every potential U(γ).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)

from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Entry, Numbers, Start
from ..e3 import inertia_parameters, lie_poisson
from ..parameter_conditions import holding
from ..rotors_and_field import rotors_and_field
from .chaplygin_bracket import DET_J, A, I, J

M, gamma, k, omega = vectors("M gamma k omega")
K, D, U = real_symbol("K"), real_symbol("D"), real_symbol("U")
HALF = sp.Rational(1, 2)
#: det (J + Dγ⊗γ), written out in γ so that it can be differentiated.
DETERMINANT = DET_J * (1 + D * dot(gamma, A * gamma))
DENSITY = 1 / sp.sqrt(DETERMINANT)
BRUNS = to_components(K / 2 * dot(gamma, Diagonal("I") * gamma))

TITLE = "Ball with rotors on two equal balls at right angles, in Bruns' field"
SUMMARY = (
    "A dynamically asymmetric ball with rotors turns about its fixed centre in the potential "
    "U = ½K(γ, Iγ), in contact without slipping with two equal homogeneous balls in orthogonal "
    "directions; γ is normal to both. Its equations are those of the Chaplygin ball with mR² "
    "replaced by a negative number."
)
SOURCE = "§12, problems 1 and 2"


def bracket() -> PoissonStructure:
    """Minus the bracket (7.6) with −D for D, in the variables M, γ."""
    spin = M + k + D * dot(omega, gamma) * gamma
    return PoissonStructure(
        "bracket",
        lie_poisson(spin / DENSITY, gamma / DENSITY),
        casimirs=(norm_squared(gamma), dot(M + k, gamma)),
        rank=4,
        meaning="the bracket of the Chaplygin ball with −D for D",
        source=SOURCE,
    )


def laws() -> tuple[Law, ...]:
    """Those of the Chaplygin ball."""
    structure = bracket()
    energy = HALF * dot(M, omega) + U
    unit = "kg^2 m^4/s^2"
    return (
        Integral("energy", energy, "energy", source=SOURCE, unit="J"),
        Integral("area", dot(M + k, gamma), "area integral", source=SOURCE, unit="kg m^2/s"),
        Integral(
            "momentum",
            norm_squared(M + k),
            "square of the momentum",
            on=(K,),
            source=SOURCE,
            unit=unit,
        ),
        Integral(
            "momentum_in_field",
            norm_squared(M) - K * DET_J * dot(gamma, A * gamma),
            "square of the momentum, Bruns field",
            on=k.symbols,
            source=SOURCE,
            unit=unit,
        ),
        Measure("measure", {DETERMINANT: -HALF}, "invariant measure ρ d³M d³γ", source=SOURCE),
        structure,
        ConformallyHamiltonian(
            "hamiltonian",
            DENSITY,
            structure,
            energy,
            "conformally Hamiltonian form",
            source=SOURCE,
        ),
    )


def build(p: Numbers) -> System:
    """The ball on two balls, with rotors, in the field."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    lever = A * gamma
    return System(
        name="ball-on-two-balls",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            *inertia_parameters(moments),
            Parameter(D, "d R²/ρ² of a supporting ball", p["D"], "kg m^2", (D >= 0,)),
            *rotors_and_field(p),
        ),
        definitions={
            J: I + D * identity,
            A: J**-1,
            omega: A * M - D * dot(lever, M) / (1 + D * dot(gamma, lever)) * lever,
            U: BRUNS,
        },
        field={
            M: cross(M, omega) + cross(k, omega) + cross(gamma, gradient(BRUNS, gamma)),
            gamma: cross(gamma, omega),
        },
        relations=(norm_squared(gamma) - 1,),
        laws=holding(laws(), p),
    )


NUMBERS = {
    **{"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "D": 0.8},
    **{"k_1": 0.6, "k_2": 0.4, "k_3": -0.8, "K": 3.0},
}


def general() -> System:
    """With the laws of a ball without rotors or without a field."""
    return replace(build(NUMBERS), laws=tuple(law for law in laws() if law.on))


ENTRIES = (
    Entry(
        name="ball-on-two-balls",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=NUMBERS,
        build=build,
        start=Start(
            state={"M": (1.2, -0.7, 1.9), "gamma": (2 / 7, -3 / 7, 6 / 7)},
            until=60.0,
        ),
        variables={
            "M": ("momentum of the ball and its supports", "kg m^2/s"),
            "gamma": ("normal to the directions of both balls", "1"),
        },
        general=general,
    ),
)
