"""A body that slides on a smooth plane: a holonomic contact with a vertical reaction.

The horizontal velocity of the centre of mass is constant and taken to be zero.  Its height h(γ) is
the support function of the body, with ḣ = (ω, b), b = ∂h/∂γ×γ, and the reaction N has the torque
−N b.  Newton's and Euler's equations

    m ḧ = N − m g,    I ω̇ = I ω×ω − N b

become, for the momentum M = I ω + m (ω, b) b that belongs to ω in Lagrange's sense,

    Ṁ = I ω×ω − m g b + m (ω, b) ḃ,    γ̇ = γ×ω,

which are the Hamiltonian equations on e(3) with the energy for H, for every body.
"""

from __future__ import annotations

from typing import Any

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import ConformallyHamiltonian, Integral, Law, Measure, PoissonStructure
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import Observable, Parameter, System
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

from ..e3 import inertia_parameters, lie_poisson

M, omega, gamma, b, bdot, X = vectors("M omega gamma b bdot X")
I, A = Diagonal("I"), Diagonal("A")
m, g, R, I_1, I_3, h, N = (real_symbol(name) for name in ("m", "g", "R", "I_1", "I_3", "h", "N"))
SOURCE = "holonomic counterpart of §11.3"
MOMENTUM = "kg m^2/s"
HALF = sp.Rational(1, 2)
AREA = dot(M, gamma)

#: What b adds to the tensor of inertia: 1 + m (b, Ab).
DENOMINATOR = 1 + m * dot(b, A * b)
KINETIC = HALF * (dot(M, A * M) - m * dot(b, A * M) ** 2 / DENOMINATOR)


def _derivative_along(vector: MatrixExpr, velocity: MatrixExpr) -> MatrixExpr:
    """The rate of a function of γ for a rate of γ."""
    pairs = list(zip(gamma.symbols, scalars(velocity), strict=True))
    return constant([sp.Add(*(sp.diff(c, s) * u for s, u in pairs)) for c in scalars(vector)])


def _hamiltonian_laws() -> tuple[Law, ...]:
    """The laws of every body: energy, area, volume, bracket, Hamiltonian form."""
    structure = PoissonStructure(
        "bracket",
        lie_poisson(M, gamma),
        casimirs=(norm_squared(gamma), AREA),
        rank=4,
        meaning="bracket of e(3)",
        source=SOURCE,
    )
    energy = KINETIC + m * g * h
    return (
        Integral("energy", HALF * dot(M, omega) + m * g * h, "energy", source=SOURCE, unit="J"),
        Integral("area", AREA, "vertical momentum", source=SOURCE, unit=MOMENTUM),
        Measure("volume", {sp.S.One: sp.S.One}, "volume of M, γ", source=SOURCE),
        structure,
        ConformallyHamiltonian(
            "hamiltonian", sp.S.One, structure, energy, "Hamiltonian form on e(3)", source=SOURCE
        ),
    )


def sliding(
    height: sp.Expr,
    inertia: MatrixExpr,
    parameters: tuple[Parameter, ...],
    laws: tuple[Law, ...] = (),
    **fields: Any,
) -> System:
    """A body on a smooth plane, from its support function.

    Parameters
    ----------
    height : sympy.Expr
        h, in the components of γ (body axes).
    inertia : MatrixExpr
        Principal moments about the centre of mass.
    parameters : tuple of Parameter
    laws : tuple of Law
        Further laws besides the Hamiltonian form.
    **described
        Name, title, summary, guards and motion of the System.
    """
    lever = cross(gradient(height, gamma, "h"), gamma)
    return System(
        parameters=parameters,
        source=SOURCE,
        definitions={
            A: inertia**-1,
            h: height,
            b: lever,
            omega: A * M - m * dot(b, A * M) / DENOMINATOR * (A * b),
            bdot: _derivative_along(lever, cross(gamma, omega)),
            X: cross(inertia * omega, omega),
            N: m * (g + dot(b, A * X) + dot(omega, bdot)) / DENOMINATOR,
        },
        field={M: X - m * g * b + m * dot(omega, b) * bdot, gamma: cross(gamma, omega)},
        relations=(norm_squared(gamma) - 1,),
        laws=(*_hamiltonian_laws(), *laws),
        observables=(
            Observable("omega", omega, "angular velocity", "rad/s", "body"),
            Observable("normal_force", N, "normal force", "N"),
        ),
        **fields,
    )


def any_body() -> System:
    """A body with an arbitrary support function h(γ)."""
    return sliding(
        sp.Function("h", real=True)(*gamma.symbols),
        I,
        (
            Parameter(m, "mass", 1.0, "kg", (m > 0,)),
            *inertia_parameters((1.0, 1.5, 2.1)),
            Parameter(g, "acceleration of gravity", 9.81, "m/s^2"),
        ),
        name="smooth-body",
        title="Body on a smooth plane",
        summary="A body of any convex shape slides on a smooth horizontal plane.",
    )
