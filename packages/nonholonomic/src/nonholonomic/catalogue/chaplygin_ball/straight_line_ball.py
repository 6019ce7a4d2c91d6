"""A Chaplygin ball that rolls along a straight line (§12; Veselov and Veselova [27]).

The ball rolls on a horizontal plane without slipping while an ideal guide keeps its centre above a
straight line of the direction α.  With the vertical γ and β = γ×α the velocity R ω×γ of the centre
is parallel to α exactly when (ω, α) = 0, and is then R (ω, β) α.  The reactions do no work on any
turn η with (η, α) = 0, so that

    I ω̇ + ω×I ω + m R² β d(ω, β)/dt = λ₀ α:

the space derivative of M = I ω + m R² (ω, β) β is λ₀ α, and M keeps its components along β and γ.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Measure, Symmetry
from flowlanes.system.system import Observable, Parameter, System, Theorem
from flowlanes.system.vectors import Components, Diagonal, cross, dot, real_symbol, vectors

from ...mechanics.rolling.attitude import attitude, quaternion_rate, rotation, unit_length
from ...mechanics.rolling.body import check_mass
from ...mechanics.rolling.inertia import check_inertia
from ..catalogue_entry import Numbers, entry_with
from ..e3 import inertia_parameters

omega, alpha, beta, gamma, M, X, q = vectors("omega alpha beta gamma M X q")
I, A = Diagonal("I"), Diagonal("A")
m, R, x, lambda_0 = (real_symbol(name) for name in ("m", "R", "x", "lambda_0"))
P, S, D_11, D_12, D_22, Delta, omega_b, omega_c = (
    real_symbol(name)
    for name in ("P", "S", "D_11", "D_12", "D_22", "Delta", "omega_beta", "omega_gamma")
)
HALF = sp.Rational(1, 2)
MOMENTUM = "kg m^2/s"

TITLE = "Chaplygin ball along a straight line"
SUMMARY = (
    "A balanced, dynamically asymmetric ball rolls on a horizontal plane without slipping while a "
    "guide keeps its centre above a straight line; it is integrable by the Euler–Jacobi theorem, "
    "but no conformally Hamiltonian form is known."
)
SOURCE = "§12, problem 2"


SHIFT = Symmetry("shift", {x: sp.S.One}, "shift along the line", source=SOURCE)
#: Δ = Σ I_j I_k α_i² + m R² (γ, Iγ), by Lagrange's identity.
POSITIVE = Theorem((), "the inertia in the plane of β and γ is positive definite", tuple, (Delta,))


def space_axes() -> dict[MatrixExpr, MatrixExpr]:
    """α, β, γ, the rows of the rotation, as definitions."""
    turn = rotation()
    return {axis: Components(turn[i, :].T) for i, axis in enumerate((alpha, beta, gamma))}


def _parameters(p: Numbers) -> tuple[Parameter, ...]:
    moments = (p["I_1"], p["I_2"], p["I_3"])
    check_inertia(moments)
    check_mass(p["m"])
    return (
        *inertia_parameters(moments),
        Parameter(m, "mass", p["m"], "kg", (m > 0,)),
        Parameter(R, "radius of the ball", p["R"], "m", (R > 0,)),
    )


def _inertia_across() -> dict[sp.Symbol, sp.Expr]:
    """The inertia in the plane of β and γ, with its determinant."""
    return {
        D_11: dot(beta, I * beta) + m * R**2,
        D_12: dot(beta, I * gamma),
        D_22: dot(gamma, I * gamma),
        Delta: D_11 * D_22 - D_12**2,
    }


def _velocity(vector: MatrixExpr) -> MatrixExpr:
    """(I + m R² β⊗β)⁻¹ applied to a vector, by Sherman and Morrison."""
    # m R² β⊗β has rank one, so that the inverse is that of I with one term subtracted
    lever = A * beta
    return A * vector - m * R**2 * dot(lever, vector) / (1 + m * R**2 * dot(beta, lever)) * lever


def _across(value: sp.Expr) -> Integral:
    meaning = "momentum about the horizontal normal of the line"
    return Integral("across", value, meaning, source=SOURCE, unit=MOMENTUM)


def _upward(value: sp.Expr) -> Integral:
    return Integral("upward", value, "vertical momentum", source=SOURCE, unit=MOMENTUM)


def build(p: Numbers) -> System:
    """The equations from the principle of d'Alembert, with the multiplier λ₀."""
    return System(
        name="straight-line-ball",
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=_parameters(p),
        definitions={
            A: I**-1,
            **space_axes(),
            M: I * omega + m * R**2 * dot(omega, beta) * beta,
            X: cross(I * omega, omega),
            q: _velocity(alpha),
            lambda_0: -dot(q, X) / dot(q, alpha),
            **_inertia_across(),
        },
        field={
            omega: _velocity(X) + lambda_0 * q,
            attitude: quaternion_rate(omega),
            x: R * dot(omega, beta),
        },
        relations=(unit_length(), dot(omega, alpha)),
        laws=(
            Integral("energy", HALF * dot(M, omega), "energy", source=SOURCE, unit="J"),
            _across(dot(M, beta)),
            _upward(dot(M, gamma)),
            Measure("measure", {Delta: HALF}, "invariant measure", source=SOURCE),
            SHIFT,
            Isomorphism(
                "momenta",
                momenta(p),
                {P: dot(M, beta), S: dot(M, gamma), attitude: attitude, x: x},
                meaning="the two constant momenta in place of ω",
                source=SOURCE,
            ),
        ),
        theorems=(
            POSITIVE,
            Theorem(
                ("measure",),
                "measure of the momenta, as d(P, S) = Δ d(ω_β, ω_γ) at each attitude",
                partial(_identities, p),
            ),
        ),
        observables=(
            Observable("speed", R * dot(omega, beta), "velocity along the line", "m/s"),
            Observable("guide_torque", lambda_0, "reaction about the direction of the line", "N m"),
        ),
    )


def _identities(p: Numbers) -> tuple[System, System]:
    """The measure in the momenta, and that these are the same motion."""
    ball, other = build(p), momenta(p)
    same = ball.laws_of(Isomorphism)
    measures = other.laws_of(Measure)
    return replace(ball, laws=same, theorems=()), replace(other, laws=measures)


def momenta(p: Numbers) -> System:
    """The ball in P = (M, β) and S = (M, γ): ω = ω_β β + ω_γ γ has two components alone."""
    return System(
        name="straight-line-ball-momenta",
        title="Chaplygin ball along a straight line, by its momenta",
        summary=(
            "The Chaplygin ball along a straight line in the variables of its two constant momenta "
            "and the attitude; the density of the invariant measure is a Jacobian determinant."
        ),
        source=SOURCE,
        parameters=_parameters(p),
        definitions={
            **space_axes(),
            **_inertia_across(),
            omega_b: (D_22 * P - D_12 * S) / Delta,
            omega_c: (D_11 * S - D_12 * P) / Delta,
            omega: omega_b * beta + omega_c * gamma,
        },
        field={
            P: sp.S.Zero,
            S: sp.S.Zero,
            attitude: quaternion_rate(omega),
            x: R * omega_b,
        },
        relations=(unit_length(),),
        laws=(
            Integral(
                "energy", HALF * (P * omega_b + S * omega_c), "energy", source=SOURCE, unit="J"
            ),
            _across(P),
            _upward(S),
            Measure("measure", {Delta: -HALF}, "invariant measure", source=SOURCE),
            SHIFT,
        ),
        theorems=(POSITIVE,),
        observables=(Observable("omega", omega, "angular velocity", "rad/s", "body"),),
    )


ENTRIES = (
    entry_with(
        name="straight-line-ball",
        build=build,
    ),
    entry_with(
        name="straight-line-ball-momenta",
        build=momenta,
    ),
)
