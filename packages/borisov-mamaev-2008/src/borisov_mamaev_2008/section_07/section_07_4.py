"""§7.4: the Chaplygin ball with a gyrostat."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Measure
from flowlanes.system.system import System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import constant, cross, dot, to_components, vectors
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball import unspecified_with_rotors
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_angles import (
    ACROSS,
    COS,
    SIN,
    TURN,
    ball_in_angles,
    c,
    phi,
    phidot,
    psidot,
    reduction,
    theta,
    thetadot,
)
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import (
    DET_IQ,
    D,
    I,
    J,
    gamma,
    hamiltonian_form,
    k,
)
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim
from ..methods.catalogue_laws import law_named, printed_form
from .section_07_3a import CYCLIC_REST, GYROSCOPIC, KINETIC, SPIN, SPREAD, VELOCITIES, routh_slope

M, omega = vectors("M omega")
J_1, J_2, J_3 = J.symbols
U = sp.Function("U")(*gamma.symbols)
HALF = sp.Rational(1, 2)
#: T₀ with (ω, k), and ψ̇ from ∂T₀/∂ψ̇ = c.
WITH_ROTORS = KINETIC + to_components(dot(SPIN, k))
VERTICAL_SHARE = to_components(dot(constant([SIN * TURN, SIN * ACROSS, COS]), k))
PRECESSION = (c - CYCLIC_REST - VERTICAL_SHARE) / SPREAD


@cache
def ball() -> System:
    """The ball with rotors in an unspecified potential."""
    return unspecified_with_rotors()


def equations() -> Case:
    """The equations of motion of §7.4."""
    lever = cross(gamma, cross(omega, gamma))
    return ball(), Identity(
        "equations",
        (
            rate(M) - (cross(M + k, omega) + cross(gamma, gradient(U, gamma))),
            rate(gamma) - cross(gamma, omega),
            M - (I * omega + D * lever),
        ),
    )


def routh() -> Case:
    """(7.10) with the new T₀."""
    system = ball_in_angles(k)

    def left(coordinate: sp.Symbol) -> sp.Expr:
        slope = routh_slope(WITH_ROTORS, PRECESSION, VELOCITIES[coordinate])
        return rate(constant([slope]))[0] - routh_slope(WITH_ROTORS, PRECESSION, coordinate)

    return (
        (system, Integral("cyclic", sp.diff(WITH_ROTORS, psidot))),
        (
            system,
            Identity(
                "routh",
                (
                    psidot - PRECESSION,
                    left(theta) + phidot * GYROSCOPIC,
                    left(phi) - thetadot * GYROSCOPIC,
                ),
            ),
        ),
    )


def measure() -> Case:
    """The measure (7.3)."""
    return ball(), Measure("measure", {DET_IQ: -HALF})


def gyroscopic_printed() -> Case:
    """Theorem 9 with rotors, S̄ as printed."""
    return ball_in_angles(k), printed_form(reduction(k))


def gyroscopic() -> Case:
    """Theorem 9 with rotors, with S̄ corrected."""
    return ball_in_angles(k), reduction(k)


def bracket_printed() -> Case:
    """The energy and the bracket as printed, in the variables of the ball."""
    system = hamiltonian_form(U, k)
    return system, printed_form(law_named(system, "hamiltonian"))


def bracket() -> Case:
    """The corrected bracket is Poisson, and with the energy it gives the motion of the ball."""
    system = hamiltonian_form(U, k)
    return (
        (system, law_named(system, "hamiltonian")),
        (ball(), law_named(ball(), "hamiltonian_form")),
    )


CLAIMS = (
    Claim(
        "§7.4, equations",
        r"$\dot{M} = (M + k) \times \omega + \gamma \times \frac{\partial U}{\partial \gamma}$, "
        r"$\dot{\gamma} = \gamma \times \omega$, $M = I_Q \omega$",
        equations,
    ),
    Claim(
        "§7.4, T_0",
        r"(7.10) holds with $T_0 = \frac{1}{2} m (\dot{x}^2 + \dot{y}^2) + "
        r"\frac{1}{2} (\omega, I\omega) + (\omega, k)$.",
        routh,
        note=r"with $\partial T_0 / \partial \dot{\psi} = (M + k, \gamma) = c$",
    ),
    Claim("§7.4, measure", "The system possesses the same invariant measure (7.3).", measure),
    Claim(
        r"§7.4, S̄",
        r"$\bar{S} = \mathcal{N}^3 D \sin \theta (c J_3 (J_1 \cos^2 \varphi + J_2 \sin^2 \varphi) "
        r"+ \det J (\gamma, J^{-1} k))$",
        gyroscopic_printed,
        gyroscopic,
        r"$\bar{S} = \mathcal{N}^3 D \sin \theta (c J_3 (J_1 \cos^2 \varphi + J_2 \sin^2 \varphi) "
        r"- \det J (\gamma, J^{-1} k))$, $c = (M + k, \gamma)$",
        "sign of the term with k",
    ),
    Claim(
        "§7.4, bracket",
        r"For $L = \rho_\mu (M + k)$, $\gamma$: $\{L_i, L_j\} = \varepsilon_{ijk} (L_k - "
        r"D \det J (\rho_\mu^2 (L, \gamma) - (\gamma, J^{-1} k)) \gamma_k)$, "
        r"$\{L_i, \gamma_j\} = \varepsilon_{ijk} \gamma_k$, $\{\gamma_i, \gamma_j\} = 0$",
        bracket_printed,
        bracket,
        r"$\{L_i, L_j\} = \varepsilon_{ijk} (L_k - D \det J (\rho_\mu^2 (L, \gamma) J_k^{-1} - "
        r"\rho_\mu^3 (\gamma, J^{-1} k)) \gamma_k)$, the others as printed",
        r"the factors $J_k^{-1}$ and $\rho_\mu^3$ are missing; as with (7.6), dx/dτ = {H, x}",
    ),
)
