"""The free rigid body (the Euler top), which bodies with fluid and constraints are compared with.

In body axes, with the momentum M and a direction γ fixed in space,

    Ṁ = M×ω,    γ̇ = γ×ω,    ω = I⁻¹M.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Measure, PoissonStructure
from flowlanes.system.system import Observable, Reconstruction, System
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, vectors

from ...mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    unit_length,
)
from ...mechanics.rolling.inertia import check_inertia
from .. import e3
from ..catalogue_entry import Entry, Numbers, Start

M, omega, gamma = vectors("M omega gamma")
I, A = Diagonal("I"), Diagonal("A")

HALF = sp.Rational(1, 2)
SOURCE = "§12, problem 4; Euler's top"
TITLE = "Free rigid body"
SUMMARY = (
    "A rigid body turns freely about its centre of mass, or about a fixed point, without torque."
)
SPIN, SQUARE = "kg m^2/s", "kg^2 m^4/s^2"


def space_motion() -> Reconstruction:
    """The attitude of a body about a fixed point, from ω."""
    return Reconstruction(
        field={attitude: quaternion_rate(omega)},
        relations=(unit_length(), *attitude_relations(gamma)),
        observables=(attitude_observable(),),
    )


def build(p: Numbers) -> System:
    """The body with the principal moments I_1, I_2, I_3."""
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    energy = HALF * dot(M, omega)
    structure = PoissonStructure(
        "bracket",
        e3.lie_poisson(M, gamma),
        casimirs=(norm_squared(gamma), dot(M, gamma)),
        rank=4,
        meaning="bracket of e(3), {M_i, M_j} = −ε_ijk M_k",
        source="(6.11)",
    )
    return System(
        name="free-body",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=e3.inertia_parameters(moments),
        definitions={A: I**-1, omega: A * M},
        field={M: cross(M, omega), gamma: cross(gamma, omega)},
        relations=(norm_squared(gamma) - 1,),
        laws=(
            Integral("energy", energy, "energy", source=SOURCE, unit="J"),
            Integral("area", dot(M, gamma), "area integral", source=SOURCE, unit=SPIN),
            Integral(
                "momentum", norm_squared(M), "square of the momentum", source=SOURCE, unit=SQUARE
            ),
            Measure("volume", {sp.S.One: sp.S.One}, "volume of M and γ", source="Liouville"),
            structure,
            ConformallyHamiltonian(
                "hamiltonian",
                sp.S.One,
                structure,
                energy,
                "Hamiltonian form on e(3)",
                source=SOURCE,
            ),
        ),
        observables=(Observable("omega", omega, "angular velocity, body axes", "rad/s", "body"),),
        reconstruction=space_motion(),
        start={M: I * omega},
    )


ENTRIES = (
    Entry(
        name="free-body",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults={"I_1": 1.0, "I_2": 1.5, "I_3": 2.1},
        build=build,
        start=Start(omega=(0.3, 1.4, -0.5), gamma=(0.2, -0.3, 0.93), until=60.0),
    ),
)
