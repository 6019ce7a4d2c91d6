"""§10.2: the unbalanced rubber ball on a plane."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Law
from flowlanes.system.system import System
from flowlanes.system.vectors import Diagonal, Vector, cross, dot, norm_squared, zero
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.bodies import unbalanced_rubber_ball_centred as centred

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import conclusion_verdict
from ..methods.independence import independent, rational_point
from ..methods.measure_of_rubber_ball import only_symmetric_balls
from ..methods.unbalanced_ball_symbols import (
    GAMMA_RATE,
    NORMAL,
    OFFSET,
    OMEGA_RATE,
    R_RATE,
    I,
    M,
    R,
    about_contact,
    c,
    gamma,
    m,
    omega,
    r,
)
from ..obstructions.limit_cycle import CASE, limit_cycle

J, gammatilde = Diagonal("J"), Vector("gammatilde")

#: Right-hand side of (10.4) without λ₀.
FREE = cross(about_contact(omega), omega) - m * cross(r, cross(omega, R_RATE))


def rubber() -> System:
    """The unbalanced rubber ball of the catalogue, derived from mechanics."""
    return from_catalogue("unbalanced-rubber-ball")


def rubber_equations() -> Case:
    """(10.4) apart from λ₀: the balance across γ, and γ̇."""
    excess = about_contact(OMEGA_RATE) - FREE
    system = rubber()
    return (
        (system, Identity("balance", cross(gamma, excess), "balance across the normal")),
        (system, Identity("normal", GAMMA_RATE - cross(gamma, omega), "motion of the normal")),
    )


def spin_torque() -> Case:
    """λ₀ of (10.4), with gammatilde = Ĩ⁻¹γ."""
    system = rubber()
    excess = dot(gamma, about_contact(OMEGA_RATE) - FREE) + dot(gammatilde, FREE) / dot(
        gammatilde, gamma
    )
    return (
        (system, Identity("inverse", about_contact(gammatilde) - gamma, "gammatilde is Ĩ⁻¹γ")),
        (system, Identity("torque", excess, "torque λ₀")),
    )


def rubber_invariants() -> Case:
    """(10.2) and the constraint for the rubber ball."""
    system = rubber()
    laws: tuple[Law, ...] = (
        Integral("length", norm_squared(gamma), "length of the normal"),
        Integral("energy", dot(M, omega) / 2, "energy"),
        Identity("constraint", dot(omega, gamma), "the constraint"),
    )
    return tuple((system, law) for law in laws)


def rubber_quadratic(vector: MatrixExpr) -> sp.Expr:
    """(10.5) with a given a."""
    share = 2 * R * m * dot(gamma, vector) * dot(M, omega)
    value: sp.Expr = norm_squared(cross(M, gamma)) - share
    return value


def quadratic() -> Case:
    """(10.5), with the a of r = −Rγ − a."""
    law = Integral("quadratic", rubber_quadratic(OFFSET), "quadratic integral", source="(10.5)")
    return rubber(), law


def as_marble_integral() -> Case:
    """(10.5) is |M×γ|² − m r²(M, ω) plus a multiple of the energy."""
    same = norm_squared(cross(M, gamma)) - m * norm_squared(r) * dot(M, omega)
    shift = m * (R**2 + norm_squared(c)) * dot(M, omega)
    law = Identity("analogue", rubber_quadratic(OFFSET) - same - shift, "(10.5) and (10.3)")
    return rubber(), law


def balanced_rubber() -> Case:
    """(10.5) for a = 0 is |Jω×γ|², the integral of the Veselova system with J in place of I."""
    system = from_catalogue("rubber-chaplygin-ball")
    excess = rubber_quadratic(zero) - norm_squared(cross(J * omega, gamma))
    return system, Identity("balanced", excess, "(10.5) for a = 0")


def as_veselova() -> Case:
    """For a = 0: the Veselova system with I + mR² in place of I."""
    target = from_catalogue("veselova")
    moments = [i + m * R**2 for i in I.symbols]
    law = Isomorphism(
        "veselova",
        target,
        {omega: omega, gamma: gamma},
        constants=dict(zip(I.symbols, moments, strict=True)),
    )
    return from_catalogue("rubber-chaplygin-ball"), law


def rank_of_rubber() -> Verdict:
    """γ², (ω, γ), H and F₂ are independent, so that their levels have dimension two."""
    system = rubber()
    state: dict[str, object] = {"omega_1": 9, "omega_2": -5, "omega_3": "-11/2"}
    functions = (norm_squared(gamma), dot(omega, gamma), dot(M, omega), rubber_quadratic(OFFSET))
    return independent(system, functions, rational_point(system, state | NORMAL))


def tori() -> Verdict:
    """The levels of H and F₂ are tori for |κ| < J₁, κ = 2mRa, J₁ < F₂/2H ≠ J₂ < J₃, H > 0.

    With ξ < η the roots of Σ γᵢ²/(Jᵢ − z) and s = (κ, γ), a level consists of the γ with ξ between
    J₁ and λ = F₂/2H, η between J₂ and J₃ for λ < J₂, and of one velocity for each sign of ξ̇ and
    η̇: their squares are determined by ξ, η and s, and ξ − s, η − s are positive. Angles α and β,
    modulo 2π, cover these points once with α̇, β̇ > 0, and once with α̇ < 0 < β̇, and neither rate
    vanishes: two tori. For λ > J₂ the same holds with ξ and η, J₁ and J₃ exchanged.
    """
    system = centred.system_at_centre()
    return conclusion_verdict(
        "tori",
        "for 2mR|a| < J₁ every level with J₁ < F₂/2H < J₃, F₂/2H ≠ J₂ consists of two tori, with "
        "angles on which the rates have no zero",
        (
            centred.balance(),
            (system, centred.ENERGY),
            (system, centred.QUADRATIC),
            centred.quadratic_forms(),
            centred.on_torus(),
            centred.on_torus(centred.torus(centred.SWAPPED_AXES, 2.4)),
        ),
    )


def with_limit_cycle() -> Verdict:
    """Prove that a particular ball has limit cycles on a torus, together with all premises."""
    dynamics = centred.system_at_centre()
    cases: tuple[tuple[System, Law], ...] = (
        centred.balance(),
        (dynamics, centred.ENERGY),
        (dynamics, centred.QUADRATIC),
        centred.quadratic_forms(),
        centred.on_torus(),
    )
    return limit_cycle([prove(system, law) for system, law in cases])


def refuted_by_limit_cycle() -> Verdict:
    """The statements refuted by limit cycles."""
    cycle = with_limit_cycle()
    return replace(
        cycle,
        decision="refuted" if cycle else "undecided",
        witness={
            "parameters": "J = {}, κ = {}, λ = {}".format(*CASE),
            "limit cycle": cycle.finding,
        },
    )


def measure_decided() -> Verdict:
    """No measure for a certain ball, and for all balls that are not symmetric."""
    cycle, symmetric = with_limit_cycle(), only_symmetric_balls()
    return replace(
        symmetric,
        decision="proven" if cycle and symmetric else "undecided",
        finding=f"{symmetric.finding}; {cycle.finding}",
        seconds=cycle.seconds + symmetric.seconds,
    )


CLAIMS = (
    Claim(
        "(10.4), equations",
        r"$\tilde{\mathbf I}\dot{\boldsymbol\omega} = \tilde{\mathbf I}\boldsymbol\omega\times"
        r"\boldsymbol\omega - m\mathbf r\times(\boldsymbol\omega\times\dot{\mathbf r}) + "
        r"\lambda_0\boldsymbol\gamma$, $\dot{\boldsymbol\gamma} = \boldsymbol\gamma\times"
        r"\boldsymbol\omega$.",
        rubber_equations,
    ),
    Claim(
        "(10.4), λ₀",
        r"$\lambda_0 = -\frac{(\tilde{\mathbf I}^{-1}\boldsymbol\gamma,\tilde{\mathbf I}"
        r"\boldsymbol\omega\times\boldsymbol\omega - m\mathbf r\times(\boldsymbol\omega\times"
        r"\dot{\mathbf r}))}{(\tilde{\mathbf I}^{-1}\boldsymbol\gamma,\boldsymbol\gamma)}$.",
        spin_torque,
    ),
    Claim(
        "§10.2, integrals",
        r"The integrals (10.2) and the equation of constraint "
        r"$(\boldsymbol\omega,\boldsymbol\gamma) = 0$ hold.",
        rubber_invariants,
    ),
    Claim(
        "(10.5)",
        r"$F_2 = |\tilde{\mathbf I}\boldsymbol\omega\times\boldsymbol\gamma|^2 - "
        r"2Rm(\boldsymbol\gamma,\mathbf a)(\tilde{\mathbf I}\boldsymbol\omega,\boldsymbol\omega)$ "
        r"is an integral.",
        quadratic,
        note="with the a of r = −Rγ − a, from the geometric centre to the centre of mass; with a "
        "as the words of §10.1 have it the last term needs the sign +",
    ),
    Claim(
        "§10.2, analogue of (10.3)",
        r"(10.5) is an analogue of the integral (10.3).",
        as_marble_integral,
        note="it is |M×γ|² − m r²(M, ω) plus a multiple of the energy",
    ),
    Claim(
        "§10.2, a = 0",
        r"For $\mathbf a = 0$ this integral transforms into the integral of Veselova's system "
        r"(Section 6).",
        balanced_rubber,
        note="with J = I + mR² for I",
    ),
    Claim(
        "§10.2, only the measure is missing",
        r"Only invariant measure is missing for the system (10.4) to be Euler–Jacobi integrable.",
        rank_of_rubber,
        note="shown: the four integrals are independent in six variables",
    ),
    Claim(
        "§10.2, integral manifold",
        r"The common level surface of the integrals of the system (10.4) is two-dimensional.",
        rank_of_rubber,
    ),
    Claim(
        "§10.2, tori",
        r"At least for small $\mathbf a$, the integral manifold is generally a two-dimensional "
        "torus.",
        tori,
        note="two of them on each level; shown without perturbation for $2mR|\\mathbf a| < J_1 < "
        "J_2 < J_3$, $J_i$ the principal moments about the geometric centre plus $mR^2$, and every "
        "level with $H > 0$ and $F_2/2H$ between $J_1$ and $J_3$, save $J_2$",
    ),
    Claim(
        "§10.2, perturbation",
        r"The system is obtained by perturbation (small $\mathbf a$) of Veselova's system.",
        as_veselova,
        note="shown: for a = 0 it is Veselova's system with I + mR² for I",
    ),
    Claim(
        "§10.2, motions on a torus",
        r"If an integral invariant does not exist, only periodic or quasi-periodic trajectories "
        r"are possible; at the same time, on such a torus asymptotic trajectories and limit cycles "
        r"may occur.",
        refuted_by_limit_cycle,
        with_limit_cycle,
        r"If an integral invariant does not exist, asymptotic trajectories and limit cycles may "
        r"occur on such a torus",
        "“does not exist” for “exists” in the first half, which then is Kolmogorov's theorem; "
        "shown is the second half, with a limit cycle of this very system",
    ),
    Claim(
        "§10.2, existence of a measure",
        r"Preliminary numerical experiments indicate the possibility of existence of invariant "
        r"measure although it is not yet found in the analytical form.",
        refuted_by_limit_cycle,
        measure_decided,
        r"An invariant measure whose density is smooth and positive up to rest exists if and only "
        r"if $\mathbf a = 0$ or the line of $\mathbf a$ is an axis of dynamical symmetry; for an "
        r"open set of other balls there is none with a continuous positive density at all: on tori "
        r"their motions approach limit cycles",
        "at rest the equations leave a density that depends on γ alone, whose logarithm has the "
        "differential −(q, dγ), q = Ĩ⁻¹γ/(γ, Ĩ⁻¹γ); it is closed for these balls alone. The limit "
        "cycles by rigorous bounds for the ball with J = diag(0.5, 2.75, 2.8), 2mR c = (0.05, "
        "−0.1, 0.15) on F₂/2H = 0.95, and so for all nearby ones; most tori have quasi-periodic "
        "motions alone, which is what experiments show",
    ),
)

REMARKS = (
    Remark(
        "§10.2",
        "As the invariant manifolds are two-dimensional, the system has no chaotic trajectories; "
        "in the two-dimensional realm there are no strange attractors.",
        "general theory of flows on surfaces (Poincaré, Bendixson, Denjoy)",
    ),
    Remark(
        "§10.2",
        "The question of existence of invariant measure is reduced to the analysis of the flow on "
        "two-dimensional invariant tori [45, 78].",
        "literature",
    ),
)
