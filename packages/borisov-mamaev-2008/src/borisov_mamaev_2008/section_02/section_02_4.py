"""§2.4 and §2.5: the rubber Chaplygin ball as the Veselova system; discussion."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Rate
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    identity,
    norm_squared,
    real_symbol,
    vectors,
)
from nonholonomic.catalogue.chaplygin_ball import chaplygin_suslov_ball
from nonholonomic.catalogue.chaplygin_ball.rubber_chaplygin_ball import general_system
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.arbitrary_motion import TORQUE, newton_euler
from ..methods.catalogue_laws import law_named
from ..section_01.section_01_4 import bound
from .section_02_1 import between

omega, gamma, e = vectors("omega gamma e")
I, J = Diagonal("I"), Diagonal("J")
m, R, lambda_0 = real_symbol("m"), real_symbol("R"), real_symbol("lambda_0")
POINT = -R * gamma


@cache
def ball() -> System:
    """The rubber Chaplygin ball in an unspecified potential, derived from mechanics."""
    return general_system()


def _about_contact(vector: sp.MatrixExpr) -> sp.MatrixExpr:
    """Ĩu = Iu + m r²u − m r(r, u) with r = −Rγ."""
    return I * vector + m * norm_squared(POINT) * vector - m * dot(POINT, vector) * POINT


def perpendicular() -> Case:
    """(ω̇, γ) = (γ̇, γ) = 0."""
    both = (dot(rate(omega), gamma), dot(rate(gamma), gamma))
    return ball(), Identity("perpendicular", both)


def no_wander() -> Case:
    """r×(ω×ṙ) = 0."""
    return ball(), Identity("no_wander", cross(POINT, cross(omega, rate(POINT))))


def tensors() -> Case:
    """Ĩω = Jω, Ĩω̇ = Jω̇ with J = I + mR²E."""
    whole = I + m * R**2 * identity
    residuals = tuple(_about_contact(u) - whole * u for u in (omega, rate(omega)))
    return ball(), Identity("tensors", residuals)


def equations() -> Case:
    """Jω̇ with the multiplier as printed."""
    right = cross(J * omega, omega) + TORQUE
    lever = J**-1 * gamma
    torque = -dot(lever, right) / dot(lever, gamma)
    return ball(), Identity("equations", J * rate(omega) - right - torque * gamma)


def equivalent() -> Case:
    """The map ω, γ ↦ ω, γ onto the Veselova system with J in place of I."""
    return ball(), law_named(ball(), "veselova")


def suslov_balance() -> Case:
    """A rolling ball in arbitrary motion, and the catalogue's ball with its torque along e."""
    whole = I + m * R**2 * identity
    swing = m * R**2 * dot(rate(omega), gamma) * gamma
    balance = whole * rate(omega) - cross(whole * omega, omega) - swing - TORQUE
    rolling = bound(POINT, sp.S.Zero)
    system = chaplygin_suslov_ball.general()
    spin_rate = Rate(dot(omega, gamma))
    solved = J * rate(omega) - cross(J * omega, omega) - TORQUE - lambda_0 * e
    return (
        (rolling, Identity("balance", newton_euler() - balance)),
        (
            system,
            Identity("constrained", (solved - m * R**2 * spin_rate * gamma, Rate(dot(omega, e)))),
        ),
    )


CLAIMS = (
    Claim(
        "§2.4, first display",
        r"$(\dot{\boldsymbol\omega},\boldsymbol\gamma)=(\dot{\boldsymbol\gamma},\boldsymbol\gamma)="
        "0$",
        perpendicular,
    ),
    Claim(
        "§2.4, second relation",
        r"$\mathbf r\times(\boldsymbol\omega\times\dot{\mathbf r})=0$",
        no_wander,
    ),
    Claim(
        "§2.4, second display",
        r"$\tilde{\mathbf I}\boldsymbol\omega=\mathbf J\boldsymbol\omega$, $\tilde{\mathbf I}\dot{"
        r"\boldsymbol\omega}=\mathbf J\dot{\boldsymbol\omega}$, $\mathbf J=\mathbf I+mb^2\mathbf "
        "E$",
        tensors,
    ),
    Claim(
        "§2.4, equations of motion",
        r"$\mathbf J\dot{\boldsymbol\omega}=\mathbf J\boldsymbol\omega\times\boldsymbol\omega+"
        r"\boldsymbol\gamma\times\frac{\partial U(\boldsymbol\gamma)}{\partial\boldsymbol\gamma}+"
        r"\lambda_0\boldsymbol\gamma$, $\lambda_0=-\frac{(\mathbf J^{-1}\boldsymbol\gamma,\mathbf J"
        r"\boldsymbol\omega\times\boldsymbol\omega+\boldsymbol\gamma\times\frac{\partial U("
        r"\boldsymbol\gamma)}{\partial\boldsymbol\gamma})}{(\mathbf J^{-1}\boldsymbol\gamma,"
        r"\boldsymbol\gamma)}$",
        equations,
        note="checked with the mechanics of a rolling ball in an unspecified potential",
    ),
    Claim(
        "§2.4, conclusion",
        "the Chaplygin ball without spinning is equivalent to the Veselova system (in which one "
        r"must replace $\mathbf I\rightarrow\mathbf J$)",
        equivalent,
        note="in every potential U(γ)",
    ),
    Claim(
        "§2.5, Chaplygin's constraint",
        "the equations of motion of a dynamically non-symmetric ball on a plane when both the "
        "velocity at the point of contact and the projection of the angular velocity onto a "
        "ball-fixed axis are zero",
        suslov_balance,
        note="the paper gives no equations; the compact form is Jω̇ = Jω×ω + mR²ṡγ + γ×∂U/∂γ + λ₀e, "
        "s = (ω, γ), (ω, e) = 0",
    ),
    Claim(
        "§2.5, 2",
        "the statement of [23], that in the absence of spinning the kinematic condition is "
        "integrable, is not correct",
        between,
        note="of the four constraints of a rubber ball on a plane one is integrable, R₃ = const; "
        "the span of the admissible fields grows as 2, 3, 5",
    ),
)

REMARKS = (
    Remark(
        "§2.5, 1",
        "Chaplygin's unpublished paper; the constraint is analogous to the Suslov constraint and "
        "reciprocal to the Veselova constraint; the problem is still not studied",
        "history and judgement; when the axis is a principal axis of inertia the free ball turns "
        "uniformly: its ω is constant (catalogue: chaplygin-suslov-ball)",
    ),
    Remark(
        "§2.5, conclusions 1) and 2)",
        "nonholonomy of constraints is geometry and has no direct relation to the mechanical "
        "system; holonomy of a dynamical system is a dynamical effect",
        "opinion; the examples are decided in §2.1, §2.3 and §2.4",
    ),
    Remark("Remark 7", "Lagrangian and Hamiltonian systems", "definition of words"),
)
