"""A homogeneous marble ball on a plane under a force at its centre (§2.2): a particle in a plane.

Everything is written in space axes.  The ball of radius b has the moment of inertia μ about every
axis through its centre; its velocity is v = r×ω with r = −b e_z.  Eliminating the reaction N of
m v̇ = N + F, μ ω̇ = r×N gives (μ + mb²) ω̇ = −r×F.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Identity, Integral, Law
from flowlanes.system.system import Observable, Parameter, System
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import constant, cross, dot, real_symbol, vectors

from ...mechanics.rolling.body import check_mass
from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers
from ..vector_rates import rate

R, omega, v, r, N, F = vectors("R omega v r N F")
m, mu, b, kappa, mtilde = (real_symbol(name) for name in ("m", "mu", "b", "kappa", "mtilde"))

NAME = "marble-ball"
TITLE = "Homogeneous marble ball"
SUMMARY = (
    "A homogeneous ball rolls on a horizontal plane without slipping, pulled towards a point by a "
    "spring; its centre moves like a particle of larger mass."
)
SOURCE = "§2.2, (2.5), (2.6)"

#: A force that may depend on place and angular velocity, and thereby on the velocity.
FORCE = constant([sp.Function(f"F_{i}")(*R.symbols, *omega.symbols) for i in (1, 2, 3)])


def ball(numbers: Numbers, force: MatrixExpr, *further: Parameter) -> System:
    """The ball under a force at its centre, given in space axes."""
    check_mass(numbers["m"])
    check_inertia((numbers["mu"],) * 3)
    heavier = m + mu / b**2
    return System(
        name=NAME,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=(
            Parameter(m, "mass", numbers["m"], "kg", (m > 0,)),
            Parameter(mu, "moment of inertia about the centre", numbers["mu"], "kg m^2", (mu > 0,)),
            Parameter(b, "radius of the ball", numbers["b"], "m", (b > 0,)),
            *further,
        ),
        definitions={
            r: -b * unit_vector(3),
            F: force,
            v: cross(r, omega),
            N: (m / heavier) * (F - dot(F, unit_vector(3)) * unit_vector(3)) - F,
        },
        field={R: v, omega: cross(F, r) / (mu + m * b**2)},
        observables=(
            Observable("velocity", v, "velocity of the centre", "m/s", "space", "(2.5)"),
            Observable("reaction", N, "reaction of the plane", "N", "space", "(2.6)"),
        ),
    )


def laws() -> tuple[Law, ...]:
    """The laws that hold under every force."""
    heavier = m + mu / b**2
    return (
        Integral("height", R.symbols[2], "height of the centre", source="§2.2", unit="m"),
        Integral(
            "spin",
            omega.symbols[2],
            "angular velocity about the vertical",
            source="(2.6)",
            unit="rad/s",
        ),
        Identity(
            "balance",
            (m * rate(v) - N - F, mu * rate(omega) - cross(r, N)),
            "Newton's and Euler's equations with the reaction of the plane",
            source="(2.6)",
        ),
        Identity(
            "particle",
            (rate(R) - v, heavier * rate(v) - F + dot(F, unit_vector(3)) * unit_vector(3)),
            "the centre moves in a horizontal plane as a particle of mass m + μ/b²",
            source="Proposition 2",
        ),
    )


def general() -> System:
    """Under any force at the centre."""
    return ball(_DEFAULTS, FORCE).with_laws(*laws())


_DEFAULTS = {"m": 1.0, "mu": 0.4, "b": 1.0, "kappa": 1.0}
