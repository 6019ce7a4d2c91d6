"""The Chaplygin ball under a constraint of Suslov's kind (§2.5): no turn about an axis of its own.

With J = I + mR²E, s = (ω, γ) and the unit vector e fixed in the ball, M = Jω − mR²sγ obeys
Ṁ = M×ω + γ×∂U/∂γ + λ₀e.  Since γ̇ = γ×ω, this is

    J ω̇ = Jω×ω + mR²σγ + γ×∂U/∂γ + λ₀e,      (ω̇, e) = 0,      σ = ṡ = (ω̇, γ).
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Law, Measure, Rate
from flowlanes.system.system import Observable, Parameter, Reconstruction, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

from ...mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    unit_length,
)
from ...mechanics.rolling.body import check_mass
from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers

omega, gamma, e, X, p, q = vectors("omega gamma e X p q")
I, J, A = Diagonal("I"), Diagonal("J"), Diagonal("A")
m, R, D, s, sigma, lambda_0 = (real_symbol(n) for n in ("m", "R", "D", "s", "sigma", "lambda_0"))

POTENTIAL = sp.Function("U")(*gamma.symbols)
#: The axis e is the principal axis 3.
PRINCIPAL = (*e.symbols[:2], e.symbols[2] - 1)

NAME = "chaplygin-suslov-ball"
TITLE = "Chaplygin ball under Suslov's constraint"
SUMMARY = (
    "A balanced, dynamically asymmetric ball rolls on a horizontal plane without slipping, and its "
    "angular velocity has no component along an axis fixed in the ball."
)
SOURCE = "§2.5"


def suslov_ball(numbers: Numbers, potential: sp.Expr = sp.S.Zero) -> System:
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
            sigma: (dot(q, X) - dot(p, X) * dot(gamma, p) / dot(e, p)) / lever,
            lambda_0: -(dot(p, X) + D * sigma * dot(gamma, p)) / dot(e, p),
        },
        field={
            omega: A * (X + D * sigma * gamma + lambda_0 * e),
            gamma: cross(gamma, omega),
        },
        relations=(norm_squared(gamma) - 1, dot(omega, e)),
        observables=(
            Observable("spin_torque", lambda_0, "torque about the axis of the ball", "N m"),
        ),
        reconstruction=Reconstruction(
            field={attitude: quaternion_rate(omega)},
            relations=(unit_length(), *attitude_relations(gamma)),
            observables=(attitude_observable(),),
        ),
    )


def _always(potential: sp.Expr = sp.S.Zero) -> tuple[Law, ...]:
    """The laws that hold for every axis."""
    half = sp.Rational(1, 2)
    kinetic = half * dot(J * omega, omega) - half * D * s**2
    return (
        Identity(
            "spin_rate", Rate(s) - sigma, "rate of the spin about the vertical", source=SOURCE
        ),
        Integral("energy", kinetic + potential, "energy", source="§2.5, (3.3)", unit="J"),
    )


def _volume() -> Measure:
    return Measure(
        "volume",
        {sp.S.One: 1},
        "the volume itself, when the axis is the principal axis 3",
        level=PRINCIPAL,
        source=SOURCE,
    )


def general() -> System:
    """In any potential U(γ), with any axis."""
    return suslov_ball(_DEFAULTS, POTENTIAL).with_laws(*_always(POTENTIAL), _volume())


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
