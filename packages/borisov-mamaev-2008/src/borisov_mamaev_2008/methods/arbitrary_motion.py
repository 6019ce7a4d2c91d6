"""A body in contact with arbitrary accelerations and an arbitrary contact point.

Equations of motion that are linear in ω̇ and λ₀ are equivalent if their residuals agree for all
values of both; no equation has to be solved for that.
"""

from __future__ import annotations

from sympy import Expr
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)
from nonholonomic.catalogue.vector_rates import rate

from . import unspecified_systems
from .rigid_body_in_space import POTENTIAL

omega, gamma, r, X, omegadot, rdot, gammadot = vectors("omega gamma r X omegadot rdot gammadot")
I, K = Diagonal("I"), Symmetric("K")
m, lambda_0 = real_symbol("m"), real_symbol("lambda_0")

#: γ×∂U/∂γ.
TORQUE: MatrixExpr = cross(gamma, gradient(POTENTIAL, gamma))


def any_motion() -> System:
    """The system with arbitrary ω̇ and ṙ, and γ̇ = γ×ω as on a plane."""
    arbitrary = ((omegadot, "angular acceleration"), (rdot, "rate of the contact point"))
    return unspecified_systems.system(
        "any-motion",
        "Body in contact, in any motion",
        {omega: omegadot, gamma: cross(gamma, omega), r: rdot},
        parameters=(
            Parameter(m, "mass", 1.2),
            Parameter(lambda_0, "torque about the normal", 0.6),
            *(Parameter(x, "moment of inertia", 1.0 + i / 4) for i, x in enumerate(I.symbols)),
            *(
                Parameter(x, meaning, 0.3 - i / 5)
                for vector, meaning in arbitrary
                for i, x in enumerate(vector)
            ),
        ),
    )


def reaction() -> MatrixExpr:
    """λ of the first equation (1.17), for v = r×ω."""
    velocity = cross(r, omega)
    return m * rate(velocity) - m * cross(velocity, omega)


def newton_euler() -> MatrixExpr:
    """The second equation (1.17), left minus right side, with λ from the first."""
    right = cross(I * omega, omega) + TORQUE + cross(r, reaction()) + lambda_0 * gamma
    return I * rate(omega) - right


def tensor(vector: MatrixExpr) -> MatrixExpr:
    """Ĩu = Iu + m r²u − m r(r, u)."""
    return I * vector + m * norm_squared(r) * vector - m * dot(r, vector) * r


def reduced_equation() -> MatrixExpr:
    """The first equation (1.18), left minus right side."""
    gyroscopic = cross(tensor(omega), omega) - m * cross(r, cross(omega, rate(r)))
    return tensor(rate(omega)) - gyroscopic - TORQUE - lambda_0 * gamma


def driven(normal_rate: MatrixExpr, correction: Expr) -> System:
    """ω̇ = Ĩ⁻¹(X + λ₀γ) for any symmetric tensor Ĩ = K and any bracket X.

    Parameters
    ----------
    normal_rate : vector
        γ̇, which may use the arbitrary vector ``gammadot``.
    correction : sympy.Expr
        The term added to (Ĩ⁻¹γ, X) in the numerator of (1.19).
    """
    adjugate = constant(K.entries.adjugate())
    determinant = K.entries.det()
    numerator = dot(adjugate * gamma, X) / determinant + correction
    numbers = (
        *((s, "bracket of (1.19)", 0.4 - i / 3) for i, s in enumerate(X)),
        *((s, "rate of the normal", 0.2 + i / 3) for i, s in enumerate(gammadot)),
        *((s, "tensor", 2.0 if name[-1] == name[-2] else 0.1) for s, name in _NAMES),
    )
    return unspecified_systems.system(
        "any-torque",
        "A body under any torque",
        {omega: adjugate * (X + lambda_0 * gamma) / determinant, gamma: normal_rate},
        parameters=tuple(Parameter(s, meaning, value) for s, meaning, value in numbers),
        definitions={lambda_0: -numerator * determinant / dot(gamma, adjugate * gamma)},
    )


_NAMES = tuple((s, str(s)) for s in K.symbols)
