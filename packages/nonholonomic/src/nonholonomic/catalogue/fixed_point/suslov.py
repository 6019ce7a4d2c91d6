"""Suslov's problem (§3.2, §3.4): a body about a fixed point that must not turn about a body axis.

Body axes are chosen so that the axis without rotation is the third one and that I_12 = 0:

    Iω̇ = Iω×ω + γ×∂U/∂γ + λ₀ e₃,   (ω, e₃) = 0,   γ̇ = γ×ω.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import Observable, Parameter, Reconstruction, System
from flowlanes.system.vector_operators import gradient, unit_vector
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, vectors

from ...mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    unit_length,
)
from ..catalogue_entry import Numbers

omega, gamma, X = vectors("omega gamma X")
lambda_0 = real_symbol("lambda_0")
I_1, I_2, I_3, I_13, I_23 = MOMENTS = sp.symbols("I_1 I_2 I_3 I_13 I_23", real=True)

PRODUCTS = (I_13, I_23)
HALF = sp.Rational(1, 2)


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    moments = [
        Parameter(s, f"moment of inertia about body axis {i}", p[str(s)], "kg m^2", (s > 0,))
        for i, s in enumerate((I_1, I_2, I_3), 1)
    ]
    products = [
        Parameter(s, f"product of inertia of body axes {i} and 3", p[str(s)], "kg m^2")
        for i, s in enumerate(PRODUCTS, 1)
    ]
    return (*moments, *products)


def in_field(
    name: str,
    title: str,
    potential: sp.Expr,
    parameters: tuple[Parameter, ...],
    *,
    products: tuple[sp.Expr, sp.Expr] = PRODUCTS,
    laws: tuple[Law, ...] = (),
    source: str = "",
    summary: str = "",
) -> System:
    """Suslov's problem in a potential U(γ).

    Parameters
    ----------
    name, title, source, summary : str
    potential : sympy.Expr
        U, in the components of γ (body axes).
    parameters : tuple of Parameter
        Those of the body first, then those of the potential.
    products : 2 sympy.Expr
        I_13 and I_23; zero for a principal axis.
    laws : tuple of Law
        Laws besides the conservation of energy and, for a principal axis, of the volume.
    """
    first, second = products
    inertia = constant([[I_1, 0, first], [0, I_2, second], [first, second, I_3]])
    torque: MatrixExpr = cross(gamma, gradient(potential, gamma))
    X_1, X_2, X_3 = X.symbols
    acceleration = [X_1 / I_1, X_2 / I_2, sp.S.Zero]
    return System(
        name=name,
        title=title,
        source=source,
        summary=summary,
        parameters=parameters,
        definitions={
            X: cross(inertia * omega, omega) + torque,
            lambda_0: first * X_1 / I_1 + second * X_2 / I_2 - X_3,
        },
        field={omega: constant(acceleration), gamma: cross(gamma, omega)},
        relations=(norm_squared(gamma) - 1, dot(omega, unit_vector(3))),
        laws=(
            Integral(
                "energy",
                HALF * dot(inertia * omega, omega) + potential,
                "energy",
                source="Theorem 1",
                unit="J",
            ),
            Measure(
                "volume",
                {sp.S.One: sp.S.One},
                "volume of ω and γ, when the axis without rotation is a principal axis",
                level=tuple(product for product in products if product != 0),
                source="§3.2",
            ),
            *laws,
        ),
        observables=(
            Observable("axis_torque", lambda_0, "torque about the axis without rotation", "N m"),
        ),
        reconstruction=Reconstruction(
            field={attitude: quaternion_rate(omega)},
            relations=(unit_length(), *attitude_relations(gamma)),
            observables=(attitude_observable(),),
        ),
    )


TITLE = "Suslov's problem"
SUMMARY = (
    "A rigid body turns about a fixed point, its centre of mass, under the constraint that its "
    "angular velocity has no component along an axis fixed in the body."
)
SOURCE = "§3.2"


def general() -> System:
    """Any potential U(γ)."""
    U = sp.Function("U")(*gamma.symbols)
    return in_field("suslov", TITLE, U, _parameters(DEFAULTS), source=SOURCE, summary=SUMMARY)


DEFAULTS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "I_13": 0.2, "I_23": -0.3}
