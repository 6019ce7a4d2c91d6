"""The Veselova system with rotors in Bruns' field: the combinations of Remarks 15 and 18 and §7.4.

The rotors enter the equations of the constraint (ω, γ) = 0 by (k, γ) alone: k×ω is projected along
γ, and the rest of it is (k, γ) (γ×ω).  They add (k, γ) γ̂ / (ρ det I) to the bracket {ω_i, ω_j} of
Theorem 7, which stays a Poisson bracket, since on a sphere every gyroscopic 2-form is closed.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, PoissonStructure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import hat
from flowlanes.system.vectors import (
    Components,
    Diagonal,
    cross,
    dot,
    norm_squared,
    to_components,
    vectors,
)

from .. import e3
from ..catalogue_entry import Entry, Numbers, Start
from ..parameter_conditions import holding
from ..rotors_and_field import rotors_and_field
from . import veselova
from .veselova import BRUNS, DENSITY, DET_I, KINETIC, K, U
from .veselova_spinning import spin

omega, gamma, k = vectors("omega gamma k")
I = Diagonal("I")
SOURCE = "§12, problem 1"
TOTAL = I * omega + k

TITLE = "Veselova system with rotors in Bruns' field"
SUMMARY = (
    "A rigid body with rotors turns about its centre of mass in the potential U = ½K(γ, Iγ), and "
    "its angular velocity has no vertical component: a conformally Hamiltonian system, in which "
    "the rotors and the field each keep a second quadratic integral, but not together."
)
SPINNING_TITLE = "Generalised Veselova system with rotors in Bruns' field"
SPINNING_SUMMARY = (
    "A rigid body with rotors turns about its centre of mass in the potential U = ½K(γ, Iγ), and "
    "the vertical component of its angular velocity is constant; it is integrable with the rotors "
    "or in the field, as without them."
)


def parameters(p: Numbers) -> tuple[Parameter, ...]:
    """Moments of inertia, rotors and strength of the field."""
    return (
        *e3.inertia_parameters(veselova.moments(p)),
        *rotors_and_field(p),
    )


def momentum_with_rotors() -> Integral:
    """(6.4) with rotors, without a field."""
    return Integral(
        "momentum",
        norm_squared(cross(TOTAL, gamma)),
        "square of the horizontal momentum",
        on=(K,),
        source=SOURCE,
        unit=veselova.MOMENTUM_UNIT,
    )


def momentum_in_field() -> Integral:
    """Remark 15: in the field, without rotors."""
    return Integral(
        "momentum_in_field",
        norm_squared(cross(I * omega, gamma)) - K * DET_I * dot(gamma, I**-1 * gamma),
        "square of the horizontal momentum, Bruns field",
        on=k.symbols,
        source="Remark 15",
        unit=veselova.MOMENTUM_UNIT,
    )


MOMENTA = (momentum_with_rotors(), momentum_in_field())


def bracket() -> PoissonStructure:
    """The bracket of the Veselova system and the gyroscopic term of the rotors."""
    gyroscopic = to_components(dot(k, gamma) / (DENSITY * DET_I)) * hat(gamma)
    corner = sp.diag(gyroscopic, sp.zeros(3, 3))
    return PoissonStructure(
        "bracket",
        Components(veselova.bracket().matrix + corner),
        casimirs=(norm_squared(gamma), dot(omega, gamma)),
        rank=4,
        meaning="bracket of T*S² with a gyroscopic term, in the variables ω, γ",
        source=SOURCE,
    )


def conformally_hamiltonian() -> tuple[Law, ...]:
    """The form of Theorem 7 with rotors, in the field."""
    structure = bracket()
    return (
        structure,
        ConformallyHamiltonian(
            "hamiltonian",
            1 / DENSITY,
            structure,
            KINETIC + U,
            "conformally Hamiltonian form",
            source=SOURCE,
        ),
    )


def energy_of_spinning() -> Integral:
    """Energy less (ω, γ)(Iω + k, γ), to which the torque of the constraint adds as much."""
    return Integral(
        "energy",
        KINETIC + U - dot(omega, gamma) * dot(TOTAL, gamma),
        "energy less (ω, γ) times the vertical momentum",
        source="Remark 18",
        unit="J",
    )


def build(p: Numbers) -> System:
    """(ω, γ) = 0."""
    return veselova.turning(
        "veselova-gyrostat-bruns",
        TITLE,
        SUMMARY,
        SOURCE,
        parameters(p),
        BRUNS,
        (dot(omega, gamma),),
        (
            veselova.energy(BRUNS),
            *holding(MOMENTA, p),
            veselova.measure(),
            *conformally_hamiltonian(),
        ),
        k,
    )


def spinning(p: Numbers) -> System:
    """(ω, γ) = d with any d."""
    return veselova.turning(
        "veselova-spinning-gyrostat-bruns",
        SPINNING_TITLE,
        SPINNING_SUMMARY,
        SOURCE,
        parameters(p),
        BRUNS,
        (),
        (
            spin(),
            energy_of_spinning(),
            *holding(MOMENTA, p),
            veselova.measure(),
        ),
        k,
    )


NUMBERS = {**veselova.NUMBERS, "k_1": 0.6, "k_2": 0.4, "k_3": -0.8, "K": 3.0}


def general() -> System:
    """With the integrals of a body without rotors or without a field."""
    return replace(build(NUMBERS), laws=MOMENTA)


def spinning_general() -> System:
    """With these integrals, for (ω, γ) = d."""
    return replace(spinning(NUMBERS), laws=MOMENTA)


ENTRIES = (
    Entry(
        name="veselova-gyrostat-bruns",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=NUMBERS,
        build=build,
        start=veselova.START,
        general=general,
    ),
    Entry(
        name="veselova-spinning-gyrostat-bruns",
        title=SPINNING_TITLE,
        summary=SPINNING_SUMMARY,
        source=SOURCE,
        defaults=NUMBERS,
        build=spinning,
        start=Start(omega=(0.9, -0.5, 0.8), gamma=(0.2, -0.3, 0.93), until=60.0),
        general=spinning_general,
    ),
)
