"""§7.3, (7.13)–(7.14): the reducing multiplier, and Theorem 9."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import sympy as sp

from flowlanes.system.laws import ConformallyHamiltonian, Identity, PoissonStructure, Rate
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.vectors import dot, real_symbol, to_components, zero
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_angles import (
    ACROSS,
    COS,
    DET_IQ_ANGLES,
    MOMENTUM,
    SIN,
    TURN,
    VERTICAL,
    M,
    N,
    c,
    gyroscopic_matrix,
    hamiltonian,
    omega,
    p_phi,
    p_theta,
    phi,
    phidot,
    psidot,
    reduction,
    theta,
    thetadot,
)
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import DET_J, A, D, I, L, R, gamma, m

from ..claim import Case, Claim, Remark
from .section_07_3a import KINETIC, PRECESSION, routh_slope, turning

I_1, I_2, I_3 = I.symbols
HALF = sp.Rational(1, 2)
thetaprime, phiprime = real_symbol("thetaprime"), real_symbol("phiprime")
ONE, TWO = I_1 * TURN**2 + I_2 * ACROSS**2, I_1 * ACROSS**2 + I_2 * TURN**2
MIXED = (I_1 - I_2) * TURN * ACROSS
SWING = D * dot(VERTICAL, I * VERTICAL)
COORDINATES = (theta, phi, p_theta, p_phi)

#: S̄ as (7.13) prints it.
SBAR = c * (I_3 + m * R**2) * m * R**2 * N**3 * SIN * (I_1 * ACROSS**2 + I_2 * TURN**2 + m * R**2)
#: N in the angles; T and ψ̇ in θ, φ, θ′, φ′; the slopes of R̄.
MULTIPLIER = 1 / sp.sqrt(to_components(DET_IQ_ANGLES))
SLOWED = {thetadot: MULTIPLIER * thetaprime, phidot: MULTIPLIER * phiprime}
KINETIC_BAR = KINETIC.subs(SLOWED, simultaneous=True)
PRECESSION_BAR = PRECESSION.subs(SLOWED, simultaneous=True)
SLOPES = {
    s: routh_slope(KINETIC_BAR, PRECESSION_BAR, s) for s in (theta, phi, thetaprime, phiprime)
}


@cache
def turning_slowly() -> System:
    """The ball in angles with N, θ′ = θ̇/N and φ′ = φ̇/N, and the momenta of Theorem 9."""
    system = turning()
    further = (
        (N, 1 / sp.sqrt(DET_IQ_ANGLES)),
        (thetaprime, thetadot / N),
        (phiprime, phidot / N),
        (p_theta, SLOPES[thetaprime]),
        (p_phi, SLOPES[phiprime]),
    )
    return replace(system, definitions=system.definitions + further)


@cache
def canonical() -> System:
    """θ, φ, p_θ, p_φ in the time τ."""
    return CATALOGUE["chaplygin-ball-reduced"].system()


def new_time() -> Case:
    """(7.13)."""
    return turning_slowly(), Identity(
        "new_time",
        (
            psidot - PRECESSION_BAR,
            Rate(SLOPES[thetaprime]) / N - SLOPES[theta] + phiprime * SBAR,
            Rate(SLOPES[phiprime]) / N - SLOPES[phi] - thetaprime * SBAR,
        ),
    )


def legendre() -> Case:
    """H = θ′p_θ + φ′p_φ − R̄ is the energy."""
    value = thetaprime * p_theta + phiprime * p_phi - (KINETIC_BAR - psidot * c)
    return turning_slowly(), Identity("legendre", value - dot(M, omega) / 2)


def theorem() -> Case:
    """Hamilton's equations with S̄, in the variables p_θ = ∂R̄/∂θ′, p_φ = ∂R̄/∂φ′."""
    first, second, third = M
    momenta = Identity(
        "momenta",
        (p_theta - N * (first * ACROSS - second * TURN), p_phi - N * third),
    )
    return (turning_slowly(), momenta), (turning(), reduction())


def bracket() -> Case:
    """(7.14) with {p_φ, p_θ} = S̄ is a Poisson bracket and gives the equations of Theorem 9."""
    structure = PoissonStructure("bracket", gyroscopic_matrix(SBAR), rank=4)
    form = ConformallyHamiltonian("theorem", sp.S.One, structure, hamiltonian(zero))
    return (canonical(), structure), (canonical(), form)


def _coefficient(first: sp.Symbol, second: sp.Symbol, value: sp.Expr) -> Callable[[], Case]:
    """The claim that a coefficient of two of p_θ, p_φ, c in the energy has a given value.

    N is expanded on both sides, so that derivatives by c treat it as a constant.
    """

    def decide() -> Case:
        share = sp.diff(hamiltonian(zero), first, second)
        share = share / 2 if first == second else share
        return canonical(), Identity("coefficient", share - value)

    return decide


def _momentum(axis: int) -> Callable[[], Case]:
    """One component of L = ρM in the local variables."""

    def decide() -> Case:
        return turning_slowly(), Identity("momentum", scalars(MOMENTUM)[axis] - N * M.symbols[axis])

    return decide


def _brackets(sign: int) -> Case:
    """{L_i, L_j} and {L_i, γ_j} by (7.14), compared with `sign` times (7.6)."""
    place = dict(zip(gamma.symbols, scalars(VERTICAL), strict=True))
    momenta = to_components(MOMENTUM).subs(N, MULTIPLIER)
    variables = sp.Matrix([*momenta, *place.values()])
    jacobian = variables.jacobian(COORDINATES)
    bracket = jacobian * sp.Matrix(gyroscopic_matrix(SBAR)) * jacobian.T
    twisted = to_components(L - D * dot(L, gamma) * N**2 * DET_J * (A * gamma)).xreplace(
        place | dict(zip(L.symbols, scalars(MOMENTUM), strict=True))
    )
    residuals = []
    for i in range(3):
        for j in range(3):
            along = [(sp.LeviCivita(i, j, k), k) for k in range(3)]
            right_L = sum(sign * e * twisted[k] for e, k in along)
            right_g = sum(sign * e * list(place.values())[k] for e, k in along)
            residuals += [
                bracket[i, j] - right_L,
                bracket[i, 3 + j] - right_g,
                bracket[3 + i, 3 + j],
            ]
    return canonical(), Identity("brackets", tuple(residuals))


def brackets_printed() -> Case:
    """(7.6) as it stands."""
    return _brackets(1)


def brackets() -> Case:
    """(7.6) with the opposite sign."""
    return _brackets(-1)


def _terms() -> tuple[Claim, ...]:
    reach, sine = I_3 + D * SIN**2, SIN
    return (
        Claim(
            "Theorem 9, H, coefficient of p_θ²",
            r"$\frac{1}{2} (I_3 \tilde{I}_{12} - D(\gamma, I\gamma))$",
            _coefficient(p_theta, p_theta, (I_3 * ONE - SWING) / 2),
            _coefficient(p_theta, p_theta, (I_3 * ONE + SWING) / 2),
            r"$\frac{1}{2} (I_3 \tilde{I}_{12} + D(\gamma, I\gamma))$",
            "sign of D",
        ),
        Claim(
            "Theorem 9, H, coefficient of p_φ²",
            r"$\frac{1}{2 \sin^2 \theta} (I_1 I_2 \sin^2 \theta + I_3 \tilde{I}_{12} "
            r"\cos^2 \theta - D(\gamma, I\gamma))$",
            _coefficient(
                p_phi, p_phi, (I_1 * I_2 * sine**2 + I_3 * ONE * COS**2 - SWING) / (2 * sine**2)
            ),
            _coefficient(
                p_phi, p_phi, (I_1 * I_2 * sine**2 + I_3 * TWO * COS**2 + SWING) / (2 * sine**2)
            ),
            r"$\frac{1}{2 \sin^2 \theta} (I_1 I_2 \sin^2 \theta + I_3 \tilde{I}_{21} "
            r"\cos^2 \theta + D(\gamma, I\gamma))$",
            r"sign of D, and $\tilde{I}_{12}$ for $\tilde{I}_{21}$",
        ),
        Claim(
            "Theorem 9, H, coefficient of p_θ p_φ",
            r"$\frac{1}{\sin \theta} I_3 (I_1 - I_2) \cos \theta \sin \theta \sin \varphi "
            r"\cos \varphi$",
            _coefficient(p_theta, p_phi, I_3 * MIXED * COS * sine / sine),
            _coefficient(p_theta, p_phi, I_3 * MIXED * COS / sine),
            r"$\frac{1}{\sin \theta} I_3 (I_1 - I_2) \cos \theta \sin \varphi \cos \varphi$",
            "one factor sin θ too many",
        ),
        Claim(
            "Theorem 9, H, coefficient of c p_θ",
            r"$-\frac{\mathcal{N}}{\sin \theta} (I_1 - I_2) (I_3 + D \sin^2 \theta) "
            r"\sin \varphi \cos \varphi$",
            _coefficient(c, p_theta, -N * MIXED * reach / sine),
        ),
        Claim(
            "Theorem 9, H, coefficient of c p_φ",
            r"$-\frac{\mathcal{N}}{\sin^2 \theta} I_3 (\tilde{I}_{21} + D)$",
            _coefficient(c, p_phi, -N * I_3 * (TWO + D) / sine**2),
            _coefficient(c, p_phi, -N * I_3 * (TWO + D) * COS / sine**2),
            r"$-\frac{\mathcal{N}}{\sin^2 \theta} I_3 (\tilde{I}_{21} + D) \cos \theta$",
            "a factor cos θ is missing",
        ),
        Claim(
            "Theorem 9, H, coefficient of c²",
            r"$\frac{\mathcal{N}^2}{\sin^2 \theta} (I_3 + D \sin^2 \theta) (\tilde{I}_{21} + D)$",
            _coefficient(c, c, N**2 * reach * (TWO + D) / sine**2),
            _coefficient(c, c, HALF * N**2 * reach * (TWO + D) / sine**2),
            r"$\frac{\mathcal{N}^2}{2 \sin^2 \theta} (I_3 + D \sin^2 \theta) "
            r"(\tilde{I}_{21} + D)$",
            "a factor ½ is missing",
        ),
    )


def _components() -> tuple[Claim, ...]:
    printed = (
        r"$L_1 = p_\theta \cos \varphi - p_\varphi \frac{\cos \theta \sin \varphi}{\sin \theta} "
        r"+ c\mathcal{N} \frac{\sin \varphi}{\sin \theta}$",
        r"$L_2 = -p_\theta \sin \varphi - p_\varphi \frac{\cos \theta \cos \varphi}{\sin \theta} "
        r"+ c\mathcal{N} \frac{\cos \varphi}{\sin \theta}$",
        r"$L_3 = p_\varphi$",
    )
    return tuple(Claim(f"§7.3, L_{i + 1}", text, _momentum(i)) for i, text in enumerate(printed))


CLAIMS = (
    Claim(
        "(7.13)",
        r"$\frac{d}{d\tau} \frac{\partial \bar{\mathcal{R}}}{\partial \theta'} - "
        r"\frac{\partial \bar{\mathcal{R}}}{\partial \theta} = -\varphi' \bar{S}$, "
        r"$\frac{d}{d\tau} \frac{\partial \bar{\mathcal{R}}}{\partial \varphi'} - "
        r"\frac{\partial \bar{\mathcal{R}}}{\partial \varphi} = \theta' \bar{S}$, "
        r"$\bar{S} = c(I_3 + mR^2) mR^2 \mathcal{N}^3 \sin \theta "
        r"(I_1 \cos^2 \varphi + I_2 \sin^2 \varphi + mR^2)$",
        new_time,
        erratum=r"$\dot{\theta}'$ under the derivative: read $\theta'$",
    ),
    Claim(
        "Theorem 9, equations",
        r"$\frac{d\theta}{d\tau} = \frac{\partial H}{\partial p_\theta}$, "
        r"$\frac{dp_\theta}{d\tau} = -\frac{\partial H}{\partial \theta} - "
        r"\bar{S} \frac{\partial H}{\partial p_\varphi}$, "
        r"$\frac{d\varphi}{d\tau} = \frac{\partial H}{\partial p_\varphi}$, "
        r"$\frac{dp_\varphi}{d\tau} = -\frac{\partial H}{\partial \varphi} + "
        r"\bar{S} \frac{\partial H}{\partial p_\theta}$",
        theorem,
        note="with the energy as H",
    ),
    Claim(
        "(7.14)",
        r"$\{\theta, p_\theta\} = \{\varphi, p_\varphi\} = 1$, "
        r"$\{p_\varphi, p_\theta\} = \bar{S}(\theta, \varphi)$, $\{\theta, \varphi\} = 0$",
        bracket,
    ),
    Claim(
        "Theorem 9, H by Legendre",
        r"$p_\theta = \partial \bar{\mathcal{R}} / \partial \theta'$, "
        r"$p_\varphi = \partial \bar{\mathcal{R}} / \partial \varphi'$, "
        r"$H = \theta' p_\theta + \varphi' p_\varphi - \bar{\mathcal{R}}$ is the Hamiltonian.",
        legendre,
        note="it is the energy of (7.2)",
        erratum="θ̇′ under the derivative: read θ′",
    ),
    *_terms(),
    *_components(),
    Claim(
        "§7.3, last sentence",
        "With these L, the bracket (7.14) gives the bracket (7.6).",
        brackets_printed,
        brackets,
        r"With these L, the bracket (7.14) gives minus the bracket (7.6).",
        "opposite sign: (7.6) goes with dx/dτ = {H, x}, (7.14) with dx/dτ = {x, H}",
    ),
)

REMARKS = (
    Remark(
        "§7.3",
        "As the system has an invariant measure, (7.10) can be written in Hamiltonian form.",
        "Theorem 6 says it in general; the form itself is proved as Theorem 9",
    ),
)
