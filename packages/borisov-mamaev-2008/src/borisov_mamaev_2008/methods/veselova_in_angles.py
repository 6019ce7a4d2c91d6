"""The Veselova system in Euler angles, with its energies and the new time (§6.2)."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import Diagonal, Vector, constant, dot, real_symbol
from nonholonomic.catalogue.angles import NORMAL, in_angles, phi, phidot, theta, thetadot
from nonholonomic.catalogue.fixed_point import veselova as catalogue

I = Diagonal("I")
gamma = Vector("gamma")
psi, psidot = real_symbol("psi"), real_symbol("psidot")
ANGLES, RATES = (theta, phi), (thetadot, phidot)
HALF = sp.Rational(1, 2)

S_THETA, C_THETA, S_PHI, C_PHI = sp.sin(theta), sp.cos(theta), sp.sin(phi), sp.cos(phi)

#: ω of (6.5), body axes.
omega_of_angles = constant(
    [
        psidot * S_THETA * S_PHI + thetadot * C_PHI,
        psidot * S_THETA * C_PHI - thetadot * S_PHI,
        psidot * C_THETA + phidot,
    ]
)

#: The kinetic energy without the constraint.
T_0 = HALF * sp.Add(*(i * w**2 for i, w in zip(I.symbols, omega_of_angles, strict=True)))


def constrained(formula: sp.Expr) -> sp.Expr:
    """A formula with ψ̇ = −cos θ φ̇ substituted."""
    return formula.xreplace({psidot: -C_THETA * phidot})


#: The kinetic energy with ψ̇ eliminated.
T = constrained(T_0)


@cache
def body() -> System:
    """The Veselova system in an unspecified potential, with the state θ, φ, θ̇, φ̇."""
    return in_angles(catalogue.general())


def slope_of_potential(angle: sp.Symbol) -> sp.Expr:
    """The derivative ∂U/∂θ or ∂U/∂φ of U(γ)."""
    return dot(
        gradient(catalogue.ANY, gamma), constant([part.diff(angle) for part in scalars(NORMAL)])
    )


def multiplier(tensor: sp.MatrixBase) -> sp.Expr:
    """The factor (γ, `tensor` γ)^(−1/2) in the angles."""
    normal = sp.Matrix(scalars(NORMAL))
    return 1 / sp.sqrt(normal.dot(tensor * normal))


def lagrangian(rate: sp.Expr, slope_of: sp.Symbol) -> sp.Expr:
    """A derivative of L(θ, φ, θ′, φ′) = T with θ̇ = 𝒩θ′, φ̇ = 𝒩φ′, expressed in θ̇ and φ̇.

    Parameters
    ----------
    rate : sympy.Expr
        The factor 𝒩 in the angles.
    slope_of : Symbol
        θ or φ for ∂L/∂θ, ∂L/∂φ; θ̇ or φ̇ for ∂L/∂θ′, ∂L/∂φ′.
    """
    in_new_time = T.xreplace({s: rate * s for s in RATES})
    return sp.diff(in_new_time, slope_of).xreplace({s: s / rate for s in RATES})


def metric() -> sp.Matrix:
    """The matrix of T in θ̇, φ̇."""
    return sp.hessian(sp.expand(T), RATES)
