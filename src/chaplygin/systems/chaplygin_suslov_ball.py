"""The Chaplygin ball under a constraint of Suslov's kind (§2.5): no turn about an axis of its own.

With J = I + mR²E, s = (ω, γ) and the unit vector e fixed in the ball, M = Jω − mR²sγ obeys
Ṁ = M×ω + γ×∂U/∂γ + λ₀e.  Since γ̇ = γ×ω, this is

    J ω̇ = Jω×ω + mR²ṡγ + γ×∂U/∂γ + λ₀e,      (ω̇, e) = 0,      ṡ = (ω̇, γ).
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from ..mechanics.attitude import attitude, attitude_observable, quaternion_rate, tie, unit_length
from ..mechanics.body import check_inertia, check_mass
from ..statements import Identity, Integral, Law, Measure, Rate
from ..system import Motion, Observable, Parameter, System
from ..vectors import Diagonal, constant, cross, dot, gradient, normed, scalar, vectors
from .entry import Entry, Numbers, Start

omega, gamma, e, X, p, q = vectors("omega gamma e X p q")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
m, R, D, s, sdot, lambda_0 = (scalar(n) for n in ("m", "R", "D", "s", "sdot", "lambda_0"))

POTENTIAL = sp.Function("U")(*gamma.symbols)
#: The axis e is the principal axis 3.
PRINCIPAL = (*e.symbols[:2], e.symbols[2] - 1)

NAME = "chaplygin-suslov-ball"
TITLE = "Chaplygin ball under Suslov's constraint"
SUMMARY = (
    "A balanced, dynamically asymmetric ball rolls on a horizontal plane without slipping and "
    "does not turn about an axis fixed in the ball."
)
SOURCE = "§2.5"


def equations(numbers: Numbers, potential: Any = sp.S.Zero) -> System:
    """The equations with both multipliers eliminated, in ω and γ (body axes)."""
    check_mass(numbers["m"])
    check_inertia((numbers["I_1"], numbers["I_2"], numbers["I_3"]))
    lever = 1 - D * dot(gamma, q) + D * dot(gamma, p) ** 2 / dot(e, p)
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            Parameter(m, "mass", numbers["m"], "kg", (m > 0,)),
            *(
                Parameter(
                    x, f"moment of inertia about body axis {i}", numbers[str(x)], "kg m^2", (x > 0,)
                )
                for i, x in enumerate(I.symbols, 1)
            ),
            Parameter(R, "radius of the ball", numbers["R"], "m", (R > 0,)),
            *(
                Parameter(x, f"axis without turn, body axis {i}", numbers[str(x)], "1")
                for i, x in enumerate(e.symbols, 1)
            ),
        ),
        definitions={
            D: m * R**2,
            J: I + D * constant(sp.eye(3)),
            A: J**-1,
            p: A * e,
            q: A * gamma,
            s: dot(omega, gamma),
            X: cross(J * omega, omega) + cross(gamma, gradient(potential, gamma)),
            sdot: (dot(q, X) - dot(p, X) * dot(gamma, p) / dot(e, p)) / lever,
            lambda_0: -(dot(p, X) + D * sdot * dot(gamma, p)) / dot(e, p),
        },
        field={
            omega: A * (X + D * sdot * gamma + lambda_0 * e),
            gamma: cross(gamma, omega),
        },
        relations=(normed(gamma) - 1, dot(omega, e)),
        observables=(
            Observable("spin_torque", lambda_0, "torque about the axis of the ball", "N m"),
        ),
        motion=Motion(
            field={attitude: quaternion_rate(omega)},
            relations=(unit_length(), *tie(gamma)),
            observables=(attitude_observable(),),
        ),
    )


def laws(potential: Any = sp.S.Zero) -> tuple[Law, ...]:
    """Energy, and the invariant volume when the axis is a principal axis of inertia."""
    half = sp.Rational(1, 2)
    kinetic = half * dot(J * omega, omega) - half * D * s**2
    return (
        Identity("spin_rate", Rate(s) - sdot, "rate of the spin about the vertical", source=SOURCE),
        Integral("energy", kinetic + potential, "energy", source="§2.5, (3.3)", unit="J"),
        Measure(
            "principal",
            {sp.S.One: 1},
            "the volume itself, for a principal axis",
            on=PRINCIPAL,
            source=SOURCE,
        ),
    )


def _free_laws() -> tuple[Law, ...]:
    """A ball without forces turns uniformly when its axis is a principal axis of inertia."""
    omega_1, omega_2, _ = omega.symbols
    return (
        Integral(
            "omega_1",
            omega_1,
            "angular velocity about body axis 1, for the principal axis 3",
            on=PRINCIPAL,
            source=SOURCE,
            unit="rad/s",
        ),
        Integral(
            "omega_2",
            omega_2,
            "angular velocity about body axis 2, for the principal axis 3",
            on=PRINCIPAL,
            source=SOURCE,
            unit="rad/s",
        ),
        Integral(
            "spin",
            s,
            "angular velocity about the vertical, for the principal axis 3",
            on=PRINCIPAL,
            source=SOURCE,
            unit="rad/s",
        ),
    )


def build(numbers: Numbers) -> System:
    """Without forces."""
    system = equations(numbers)
    axis = (numbers["e_1"], numbers["e_2"], numbers["e_3"])
    found = (*laws(), *_free_laws())
    return system.with_laws(*(law for law in found if axis == (0, 0, 1) or not law.on))


def general() -> System:
    """In any potential U(γ), with any axis."""
    return equations(_DEFAULTS, POTENTIAL).with_laws(*laws(POTENTIAL))


_DEFAULTS = {
    "m": 1.0,
    "I_1": 1.0,
    "I_2": 1.5,
    "I_3": 2.1,
    "R": 1.0,
    "e_1": 0.48,
    "e_2": 0.6,
    "e_3": 0.64,
}

ENTRIES = (
    Entry(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=_DEFAULTS,
        build=build,
        start=Start(omega=(0.9, -0.5, -0.20625), gamma=(0.2, -0.3, 0.93), until=60.0),
        general=general,
    ),
)
