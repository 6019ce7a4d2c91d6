"""A free rigid body in space, and the vector fields of (1.11).

The attitude is a quaternion. The direction vectors α, β, γ of the paper are the rows of the
rotation matrix.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import Diagonal, constant, cross, real_symbol, vectors
from nonholonomic.mechanics.lagrangian.structure_functions import VectorField, commutator
from nonholonomic.mechanics.rolling.attitude import attitude, quaternion_rate, rotation, unit_length

from . import unspecified_systems

alpha, beta, gamma, R, omega, v, r = vectors("alpha beta gamma R omega v r")
lambda_ = vectors("lambda")[0]
I = Diagonal("I")
m, lambda_0 = real_symbol("m"), real_symbol("lambda_0")

#: α, β, γ and R: the coordinates of (1.10), redundant on SO(3).
COORDINATES = (*alpha.symbols, *beta.symbols, *gamma.symbols, *R.symbols)
POTENTIAL = sp.Function("U")(*gamma.symbols)


def rotation_field(axis: int) -> VectorField:
    """ξ_k of (1.11): −Σ ε_kij (α_i ∂/∂α_j + β_i ∂/∂β_j + γ_i ∂/∂γ_j)."""
    components = {}
    for direction in (alpha, beta, gamma):
        for j, symbol in enumerate(direction):
            components[symbol] = -sum(
                sp.LeviCivita(axis, i, j) * other for i, other in enumerate(direction)
            )
    return components


def translation_field(axis: int) -> VectorField:
    """ζ_k of (1.11), with the component k: α_k ∂/∂R_1 + β_k ∂/∂R_2 + γ_k ∂/∂R_3."""
    directions = (alpha, beta, gamma)
    return {R.symbols[i]: direction.symbols[axis] for i, direction in enumerate(directions)}


def bracket(first: VectorField, second: VectorField) -> VectorField:
    """The commutator of two vector fields on α, β, γ and R."""
    return commutator(first, second)


def moving() -> System:
    """A body that moves with arbitrary ω and v in body axes."""
    rows = rotation()
    return unspecified_systems.system(
        "free-body",
        "Body in space",
        {attitude: quaternion_rate(omega), R: constant(rows * v.entries)},
        parameters=(
            *(Parameter(x, "angular velocity", 0.3 + i / 5) for i, x in enumerate(omega)),
            *(Parameter(x, "velocity", 0.2 - i / 3) for i, x in enumerate(v)),
            *_point(),
        ),
        definitions={
            alpha: constant(rows.row(0).T),
            beta: constant(rows.row(1).T),
            gamma: constant(rows.row(2).T),
        },
        relations=(unit_length(),),
    )


def _point() -> tuple[Parameter, ...]:
    return tuple(Parameter(x, "a point of the body", 0.4 + i / 7) for i, x in enumerate(r))


def constrained() -> System:
    """The body with the forces of (1.17): a potential U(γ), λ at r, and the couple λ₀γ."""
    free = moving()
    couple = cross(gamma, gradient(POTENTIAL, gamma)) + cross(r, lambda_) + lambda_0 * gamma
    return replace(
        free,
        name="body-with-reactions",
        field=(
            *free.field,
            (v, cross(v, omega) + lambda_ / m),
            (omega, I**-1 * (cross(I * omega, omega) + couple)),
        ),
        parameters=(
            *_point(),
            *(Parameter(x, "reaction", 0.5 - i / 3) for i, x in enumerate(lambda_)),
            Parameter(lambda_0, "torque about the normal", 0.7),
            Parameter(m, "mass", 1.2),
            *(Parameter(x, "moment of inertia", 1.0 + i / 4) for i, x in enumerate(I.symbols)),
        ),
    )
