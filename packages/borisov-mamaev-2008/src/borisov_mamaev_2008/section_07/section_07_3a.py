"""§7.3, (7.8)–(7.12): the Chaplygin ball in Euler angles, and its Routh function."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Law, Measure, Rate
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, dot, real_symbol, to_components
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_angles import (
    ACROSS,
    AREA,
    COS,
    DET_IQ_ANGLES,
    SIN,
    TURN,
    VERTICAL,
    M,
    ball_in_angles,
    c,
    in_space,
    phi,
    phidot,
    psi,
    psidot,
    theta,
    thetadot,
    x,
    y,
)
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import (
    PARAMETERS,
    TENSORS,
    A,
    D,
    I,
    R,
    m,
)

from ..claim import Case, Claim, Remark

I_1, I_2, I_3 = I.symbols
P_theta, P_phi = real_symbol("P_theta"), real_symbol("P_phi")
REACH = m * R**2
SLIDE_SIN, SLIDE_COS = sp.sin(psi), sp.cos(psi)

#: ω of (6.5).
SPIN = constant(
    [
        psidot * SIN * TURN + thetadot * ACROSS,
        psidot * SIN * ACROSS - thetadot * TURN,
        psidot * COS + phidot,
    ]
)
#: ½(ω, Iω) in the angles and their rates.
TURNING = to_components(dot(SPIN, I * SPIN)) / 2
#: T₀ with ẋ and ẏ eliminated by (7.8).
KINETIC = TURNING + D / 2 * (thetadot**2 + phidot**2 * SIN**2)
#: ∂T₀/∂ψ̇ as (7.11) prints it, and ψ̇ from it.
SPREAD = (I_1 * TURN**2 + I_2 * ACROSS**2) * SIN**2 + I_3 * COS**2
CYCLIC_REST = (I_1 - I_2) * thetadot * SIN * TURN * ACROSS + I_3 * phidot * COS
PRECESSION = (c - CYCLIC_REST) / SPREAD
#: S of (7.10), with ψ̇ and without.
GYROSCOPIC = REACH * SIN * (phidot * COS + psidot)

#: ∂f_x/∂q̇ and ∂f_y/∂q̇ of (7.8).
SLIDES = {
    theta: (-R * SLIDE_SIN, R * SLIDE_COS),
    phi: (R * SIN * SLIDE_COS, R * SIN * SLIDE_SIN),
}
VELOCITIES = {theta: thetadot, phi: phidot, psi: psidot}


@cache
def rolling() -> System:
    """The ball in angles, with ψ and the position of its centre."""
    return in_space(ball_in_angles())


@cache
def turning() -> System:
    """The ball in angles only."""
    return ball_in_angles()


def lagrange(function: sp.Expr, coordinate: sp.Symbol) -> sp.Expr:
    """d/dt(∂F/∂q̇) − ∂F/∂q."""
    slope = sp.diff(function, VELOCITIES[coordinate])
    return Rate(slope) - sp.diff(function, coordinate)


def routh_slope(kinetic: sp.Expr, precession: sp.Expr, variable: sp.Symbol) -> sp.Expr:
    """∂R/∂q or ∂R/∂q̇ of the Routh function R = T − ψ̇c, through ψ̇ = `precession`."""
    through = sp.diff(kinetic, psidot) - c
    return sp.diff(kinetic, variable) + through * sp.diff(precession, variable)


def routh(coordinate: sp.Symbol) -> sp.Expr:
    """d/dt(∂R/∂q̇) − ∂R/∂q, with R in θ, φ, θ̇, φ̇ and c."""
    slope = routh_slope(KINETIC, PRECESSION, VELOCITIES[coordinate])
    return Rate(slope) - routh_slope(KINETIC, PRECESSION, coordinate)


def reaction(coordinate: sp.Symbol) -> sp.Expr:
    """λ_x ∂f_x/∂q̇ + λ_y ∂f_y/∂q̇ with λ_x = mẍ, λ_y = mÿ."""
    along_x, along_y = SLIDES[coordinate]
    return m * Rate(Rate(x)) * along_x + m * Rate(Rate(y)) * along_y


def _identity(*formulas: object) -> Case:
    return rolling(), Identity("identity", formulas)


def constraint_x() -> Case:
    """f_x = 0."""
    return _identity(Rate(x) - R * Rate(theta) * SLIDE_SIN + R * Rate(phi) * SIN * SLIDE_COS)


def constraint_y() -> Case:
    """f_y = 0."""
    return _identity(Rate(y) + R * Rate(theta) * SLIDE_COS + R * Rate(phi) * SIN * SLIDE_SIN)


def multipliers() -> Case:
    """The five equations (7.9)."""
    return _identity(
        Rate(sp.diff(TURNING, psidot)),
        lagrange(TURNING, theta) - reaction(theta),
        lagrange(TURNING, phi) - reaction(phi),
    )


def independent_of_psi() -> Case:
    """T₀ agrees with its form in the variables M, and does not contain x, y, ψ."""
    along = (Rate(x), Rate(y))
    whole = m * sum(v**2 for v in along) / 2 + TURNING
    return _identity(whole - dot(M, SPIN) / 2, *(sp.diff(TURNING, s) for s in (x, y, psi)))


def eliminated_theta() -> Case:
    """The reaction in the equation for θ."""
    return _identity(reaction(theta) + m * R**2 * (Rate(thetadot) + psidot * phidot * SIN))


_BRACKET = Rate(phidot) * SIN + thetadot * phidot * COS - thetadot * psidot


def eliminated_phi_printed() -> Case:
    """The reaction in the equation for φ, as printed."""
    return _identity(reaction(phi) + m * R**2 * _BRACKET)


def eliminated_phi() -> Case:
    """The reaction in the equation for φ."""
    return _identity(reaction(phi) + m * R**2 * SIN * _BRACKET)


def routh_equations() -> Case:
    """(7.10) for the Routh function."""
    return turning(), Identity(
        "routh",
        (
            psidot - PRECESSION,
            routh(theta) + phidot * GYROSCOPIC,
            routh(phi) - thetadot * GYROSCOPIC,
        ),
    )


def cyclic() -> Case:
    """(7.11): the printed form of ∂T₀/∂ψ̇, and its constancy."""
    printed = CYCLIC_REST + SPREAD * psidot
    integral: Law = Integral("cyclic", printed)
    return (
        (turning(), Identity("derivative", printed - sp.diff(TURNING, psidot))),
        (turning(), Identity("area", printed - c)),
        (turning(), integral),
    )


def generalised_chaplygin() -> Case:
    """(4.4) with S of (4.4) = −S, which is linear in the velocities with b ≠ 0."""
    factor = -GYROSCOPIC.subs(psidot, PRECESSION)
    a_1, a_2 = sp.diff(factor, thetadot), sp.diff(factor, phidot)
    b = factor.subs({thetadot: 0, phidot: 0})
    return turning(), Identity(
        "chaplygin",
        (
            routh(theta) - phidot * factor,
            routh(phi) + thetadot * factor,
            factor - (a_1 * thetadot + a_2 * phidot + b),
            *(sp.diff(a, v) for a in (a_1, a_2) for v in (thetadot, phidot)),
        ),
    )


@cache
def routh_system() -> System:
    """(4.7) for the ball: θ, φ and P = ∂R/∂q̇, in the time t."""
    momentum = constant(
        [
            P_theta * ACROSS - P_phi * COS * TURN / SIN + c * TURN / SIN,
            -P_theta * TURN - P_phi * COS * ACROSS / SIN + c * ACROSS / SIN,
            P_phi,
        ]
    )
    lever = A * VERTICAL
    share = D * dot(lever, momentum) / (1 - D * dot(VERTICAL, lever))
    energy = to_components(dot(momentum, A * momentum + share * lever)) / 2
    slopes = {s: sp.diff(energy, s) for s in (theta, phi, P_theta, P_phi)}
    om1, om2, _ = to_components(A * momentum + share * lever)
    factor = REACH * SIN * (slopes[P_phi] * COS + (om1 * TURN + om2 * ACROSS) / SIN)
    return System(
        name="routh",
        title="Chaplygin ball, Routh function",
        parameters=(*PARAMETERS, AREA),
        definitions=TENSORS,
        field={
            theta: slopes[P_theta],
            phi: slopes[P_phi],
            P_theta: -slopes[theta] - slopes[P_phi] * factor,
            P_phi: -slopes[phi] + slopes[P_theta] * factor,
        },
    )


def multiplier() -> Case:
    """(7.3) is the density of the measure in θ, φ, P, as Theorem 6 requires."""
    first, second, third = M
    onto = Isomorphism(
        "momenta",
        routh_system(),
        {
            theta: theta,
            phi: phi,
            P_theta: first * ACROSS - second * TURN,
            P_phi: third,
        },
        constants={c: c},
    )
    half = sp.Rational(1, 2)
    return (
        (turning(), onto),
        (routh_system(), Measure("measure", {DET_IQ_ANGLES: -half})),
    )


CLAIMS = (
    Claim(
        "(7.8), x",
        r"$f_x = \dot{x} - R\dot{\theta} \sin \psi + R\dot{\varphi} \sin \theta \cos \psi = 0$",
        constraint_x,
    ),
    Claim(
        "(7.8), y",
        r"$f_y = \dot{y} + R\dot{\theta} \cos \psi + R\dot{\varphi} \sin \theta \sin \psi = 0$",
        constraint_y,
    ),
    Claim(
        "(7.9)",
        r"$\frac{d}{dt} \frac{\partial T_0}{\partial \dot{x}} = \lambda_x$, "
        r"$\frac{d}{dt} \frac{\partial T_0}{\partial \dot{y}} = \lambda_y$, "
        r"$\frac{d}{dt} \frac{\partial T_0}{\partial \dot{\psi}} = 0$, "
        r"$\frac{d}{dt} \frac{\partial T_0}{\partial \dot{q}} - \frac{\partial T_0}{\partial q} = "
        r"\lambda_x \frac{\partial f_x}{\partial \dot{q}} + "
        r"\lambda_y \frac{\partial f_y}{\partial \dot{q}}$ for $q = \theta, \varphi$",
        multipliers,
        note="without a potential",
    ),
    Claim(
        "§7.3, T_0",
        r"$T_0 = \frac{1}{2} m (\dot{x}^2 + \dot{y}^2) + \frac{1}{2} (\omega, I \omega)$ does not "
        r"depend on x, y, and ψ.",
        independent_of_psi,
    ),
    Claim(
        "§7.3, reaction along θ",
        r"$\lambda_x \frac{\partial f_x}{\partial \dot{\theta}} + "
        r"\lambda_y \frac{\partial f_y}{\partial \dot{\theta}} = "
        r"-mR^2 (\ddot{\theta} + \dot{\psi} \dot{\varphi} \sin \theta)$",
        eliminated_theta,
    ),
    Claim(
        "§7.3, reaction along φ",
        r"$\lambda_x \frac{\partial f_x}{\partial \dot{\varphi}} + "
        r"\lambda_y \frac{\partial f_y}{\partial \dot{\varphi}} = -mR^2 (\ddot{\varphi} "
        r"\sin \theta + \dot{\theta} \dot{\varphi} \cos \theta - \dot{\theta} \dot{\psi})$",
        eliminated_phi_printed,
        eliminated_phi,
        r"$\lambda_x \frac{\partial f_x}{\partial \dot{\varphi}} + "
        r"\lambda_y \frac{\partial f_y}{\partial \dot{\varphi}} = -mR^2 \sin \theta "
        r"(\ddot{\varphi} \sin \theta + \dot{\theta} \dot{\varphi} \cos \theta - "
        r"\dot{\theta} \dot{\psi})$",
        "a factor sin θ is missing",
    ),
    Claim(
        "(7.10)",
        r"$\frac{d}{dt} \frac{\partial \mathcal{R}}{\partial \dot{\theta}} - "
        r"\frac{\partial \mathcal{R}}{\partial \theta} = -\dot{\varphi} S$, "
        r"$\frac{d}{dt} \frac{\partial \mathcal{R}}{\partial \dot{\varphi}} - "
        r"\frac{\partial \mathcal{R}}{\partial \varphi} = \dot{\theta} S$, "
        r"$S = mR^2 \sin \theta (\dot{\varphi} \cos \theta + \dot{\psi})$, with "
        r"$\mathcal{R} = T_0 - \dot{\psi} \frac{\partial T_0}{\partial \dot{\psi}}$",
        routh_equations,
    ),
    Claim(
        "(7.11)",
        r"$\frac{\partial T_0}{\partial \dot{\psi}} = (I_1 - I_2)\dot{\theta} \sin \theta "
        r"\sin \varphi \cos \varphi + I_3 \dot{\varphi} \cos \theta + ((I_1 \sin^2 \varphi + "
        r"I_2 \cos^2 \varphi) \sin^2 \theta + I_3 \cos^2 \theta) \dot{\psi} = c = $ const",
        cyclic,
    ),
    Claim(
        "§7.3, after (7.11)",
        "The equations have the form of a generalised Chaplygin system (4.4).",
        generalised_chaplygin,
        note="S of (4.4) is minus S of (7.10)",
    ),
    Claim(
        "(7.12)",
        r"$\mathcal{N}(\theta, \varphi) dt = d\tau$, where $\mathcal{N} = \rho_\mu$ is the density "
        "of the invariant measure (7.3).",
        multiplier,
        note="read with Theorem 6: the density in θ, φ and the momenta ∂R/∂q̇",
    ),
)

REMARKS = (
    Remark(
        "§7.3, after (7.9)",
        "The equations for θ and φ do not depend on ψ, so that ψ can be eliminated by Routh's "
        "procedure.",
        "the result, (7.10), is proved",
    ),
)
