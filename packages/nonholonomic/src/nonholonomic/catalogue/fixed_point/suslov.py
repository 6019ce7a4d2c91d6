"""Suslov's problem (§3.2, §3.4): a body about a fixed point that must not turn about a body axis.

Body axes are chosen so that the axis without rotation is the third one and that I_12 = 0:

    Iω̇ = Iω×ω + γ×∂U/∂γ + λ₀ e₃,   (ω, e₃) = 0,   γ̇ = γ×ω.
"""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.system.isomorphism import Isomorphism
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
from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Entry, Numbers, Start
from . import suslov_bracket

omega, gamma, X = vectors("omega gamma X")
lambda_0 = real_symbol("lambda_0")
I_1, I_2, I_3, I_13, I_23 = MOMENTS = sp.symbols("I_1 I_2 I_3 I_13 I_23", real=True)
C_1, C_2, C_3 = STRENGTHS = sp.symbols("C_1:4", real=True)

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


def _check(p: Numbers) -> None:
    I1, I2, I3, I13, I23 = (p[str(s)] for s in MOMENTS)
    check_inertia(((I1, 0.0, I13), (0.0, I2, I23), (I13, I23, I3)))


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
                on=tuple(product for product in products if product != 0),
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


def field_free(p: Numbers) -> System:
    """No field; the axis without rotation need not be a principal axis."""
    _check(p)
    along = I_13 * omega.symbols[0] + I_23 * omega.symbols[1]
    singular = Measure(
        "singular",
        {along: -sp.S.One},
        "measure, singular at the permanent rotations",
        source=SOURCE,
    )
    return in_field(
        "suslov",
        TITLE,
        sp.S.Zero,
        _parameters(p),
        laws=(singular,),
        source=SOURCE,
        summary=SUMMARY,
    )


def general() -> System:
    """Any potential U(γ)."""
    U = sp.Function("U")(*gamma.symbols)
    return in_field("suslov", TITLE, U, _parameters(DEFAULTS), source=SOURCE, summary=SUMMARY)


QUADRATIC = "Suslov's problem in a quadratic potential"
QUADRATIC_SUMMARY = (
    "A rigid body turns about its centre of mass in the potential ½(γ, Cγ), without rotation "
    "about a principal axis; its motion is that of the five-dimensional bracket."
)
QUADRATIC_SOURCE = "§3.4, (3.8)"


def in_quadratic_field(p: Numbers) -> System:
    """U = ½(γ, Cγ) and a principal axis, with C₁ > C₃ and C₂ > C₃.

    Raises
    ------
    InputError
        If the potential is not least along the axis without rotation.
    """
    check_inertia((p["I_1"], p["I_2"], p["I_3"]))
    if min(p["C_1"], p["C_2"]) <= p["C_3"]:
        raise InputError(
            f"potential strengths {p['C_1']}, {p['C_2']}, {p['C_3']}: the first two must exceed "
            "the third"
        )
    strengths = tuple(
        Parameter(s, f"strength of the potential along body axis {i}", p[str(s)], "J", conditions)
        for i, (s, conditions) in enumerate(
            zip(STRENGTHS, ((C_1 > C_3,), (C_2 > C_3,), ()), strict=True), 1
        )
    )
    moments = _parameters({**p, "I_13": 0.0, "I_23": 0.0})[:3]
    return in_field(
        "suslov-quadratic",
        QUADRATIC,
        HALF * sp.Add(*(c * s**2 for c, s in zip(STRENGTHS, gamma, strict=True))),
        (*moments, *strengths),
        products=(sp.S.Zero, sp.S.Zero),
        laws=_quadratic_laws(),
        source=QUADRATIC_SOURCE,
        summary=QUADRATIC_SUMMARY,
    )


def _quadratic_laws() -> tuple[Law, ...]:
    """Two integrals and the change to the variables of (3.8)."""
    omega_1, omega_2, _ = omega.symbols
    gamma_1, gamma_2, _ = gamma.symbols
    first, second = (C_1 - C_3) / I_2, (C_2 - C_3) / I_1
    return (
        Integral(
            "first",
            I_2 * omega_2**2 + (C_1 - C_3) * gamma_1**2,
            "(C₁ − C₃) Φ₁ for the Casimir function Φ₁",
            source="§3.4, after (3.8)",
            unit="J",
        ),
        Integral(
            "second",
            I_1 * omega_1**2 + (C_2 - C_3) * gamma_2**2,
            "(C₂ − C₃) Φ₂ for the Casimir function Φ₂",
            source="§3.4, after (3.8)",
            unit="J",
        ),
        Isomorphism(
            "bracket",
            suslov_bracket.general(),
            {
                suslov_bracket.p_1: -omega_2 / sp.sqrt(first),
                suslov_bracket.p_2: omega_1 / sp.sqrt(second),
                suslov_bracket.gamma: gamma,
            },
            time=sp.sqrt(first),
            constants={suslov_bracket.d: sp.sqrt(second / first)},
            meaning="Hamiltonian form of Suslov's problem with the five-dimensional bracket",
            onto=(norm_squared(gamma) - 1,),
            source="§3.4, (3.8)",
        ),
    )


DEFAULTS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "I_13": 0.2, "I_23": -0.3}
#: Such that d² = 2.
FIELD_DEFAULTS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "C_1": 1.5, "C_2": 2.0, "C_3": 0.0}

ENTRIES = (
    Entry(
        name="suslov",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        defaults=DEFAULTS,
        build=field_free,
        start=Start(omega=(0.9, -0.5, 0.0), gamma=(2 / 7, -3 / 7, 6 / 7), until=30.0),
        general=general,
    ),
    Entry(
        name="suslov-quadratic",
        title=QUADRATIC,
        summary=QUADRATIC_SUMMARY,
        source=QUADRATIC_SOURCE,
        defaults=FIELD_DEFAULTS,
        build=in_quadratic_field,
        start=Start(omega=(0.9, -0.5, 0.0), gamma=(2 / 7, -3 / 7, 6 / 7), until=60.0),
    ),
)
