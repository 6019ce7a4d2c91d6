"""The Veselova system (§6): a body about a fixed point that must not turn about the vertical."""

from __future__ import annotations

import sympy as sp

from ..mechanics.attitude import attitude, attitude_observable, quaternion_rate, tie, unit_length
from ..mechanics.body import check_inertia
from ..statements import Integral
from ..system import Motion, Observable, Parameter, System
from ..vectors import Diagonal, cross, dot, normed, scalar, vectors
from .entry import Entry, Numbers, Start

omega, gamma, omegadot, X = vectors("omega gamma omegadot X")
I, A = Diagonal("I"), Diagonal("A")
lambda_0 = scalar("lambda_0")

TITLE = "Veselova system"
SUMMARY = (
    "A rigid body turns about a fixed point, its centre of mass, under the constraint that its "
    "angular velocity has no vertical component."
)
SOURCE = "§6.1, (6.1)–(6.4)"


def build(p: Numbers) -> System:
    """(6.1) without a field, with the sign of λ₀ that keeps (ω, γ) = 0."""
    check_inertia((p["I_1"], p["I_2"], p["I_3"]))
    parameters = tuple(
        Parameter(s, f"moment of inertia about body axis {i}", p[str(s)], "kg m^2", (s > 0,))
        for i, s in enumerate(I.symbols, 1)
    )
    return System(
        name="veselova",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=parameters,
        definitions={
            A: I**-1,
            X: cross(I * omega, omega),
            lambda_0: -dot(A * gamma, X) / dot(A * gamma, gamma),
        },
        field={omega: A * (X + lambda_0 * gamma), gamma: cross(gamma, omega)},
        relations=(normed(gamma) - 1, dot(omega, gamma)),
        laws=(
            Integral(
                "energy",
                sp.Rational(1, 2) * dot(I * omega, omega),
                "energy",
                source="(6.2)",
                unit="J",
            ),
            Integral(
                "momentum",
                normed(cross(I * omega, gamma)),
                "square of the horizontal momentum",
                source="(6.4)",
                unit="kg^2 m^4/s^2",
            ),
        ),
        observables=(
            Observable("spin_torque", lambda_0, "torque about the vertical", "N m", source="(6.1)"),
        ),
        motion=Motion(
            field={attitude: quaternion_rate(omega)},
            relations=(unit_length(), *tie(gamma)),
            observables=(attitude_observable(),),
        ),
    )


ENTRIES = (
    Entry(
        name="veselova",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults={"I_1": 1.0, "I_2": 1.5, "I_3": 2.1},
        build=build,
        start=Start(omega=(0.9, -0.5, -0.35483870967741937), gamma=(0.2, -0.3, 0.93), until=60.0),
    ),
)
