"""§6.2: the Veselova system in Euler angles, its reducing multiplier and its canonical form."""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Identity, PoissonStructure, Rate
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    Diagonal,
    constant,
    cross,
    dot,
    real_symbol,
    to_components,
    vectors,
)
from nonholonomic.catalogue.angles import NORMAL, phi, phidot, theta, thetadot
from nonholonomic.catalogue.fixed_point import veselova as catalogue
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.veselova_in_angles import (
    ANGLES,
    RATES,
    T_0,
    T,
    body,
    constrained,
    lagrangian,
    metric,
    multiplier,
    omega_of_angles,
    psi,
    psidot,
    slope_of_potential,
)

I = Diagonal("I")
omega, gamma = vectors("omega gamma")
I_1, I_2, I_3 = I.symbols
p_theta, p_phi = real_symbol("p_theta"), real_symbol("p_phi")
HALF = sp.Rational(1, 2)

SIN, COS, SIN_PHI, COS_PHI = sp.sin(theta), sp.cos(theta), sp.sin(phi), sp.cos(phi)
#: ∂T₀/∂ψ̇ on the constraint.
VERTICAL = constrained(sp.diff(T_0, psidot))
#: 𝒩 as Theorem 7 prints it, and ρ_ω⁻¹.
PRINTED, REDUCING = multiplier(I.entries), multiplier(to_components(I**-1))


# --- (6.5), (6.6) --------------------------------------------------------------------------


@cache
def frame() -> System:
    """Three Euler angles with any rates."""
    zero = sp.S.Zero
    rates = {theta: thetadot, phi: phidot, psi: psidot}
    return System(
        name="euler-angles",
        title="Euler angles",
        field={**rates, **dict.fromkeys(rates.values(), zero)},
    )


def angular_velocity() -> Case:
    """(6.5): γ̇ = γ×ω and α̇ = α×ω, where α is the first space axis."""
    first = constant(
        [
            sp.cos(psi) * COS_PHI - COS * sp.sin(psi) * SIN_PHI,
            -sp.cos(psi) * SIN_PHI - COS * sp.sin(psi) * COS_PHI,
            SIN * sp.sin(psi),
        ]
    )
    moving = [rate(v) - cross(v, omega_of_angles) for v in (NORMAL, first)]
    return frame(), Identity("rates", (*moving, dot(NORMAL, first), dot(first, first) - 1))


def constraint() -> Case:
    """(6.6)."""
    value = dot(omega_of_angles, NORMAL) - (psidot + COS * phidot)
    return frame(), Identity("constraint", value)


# --- (6.7), (6.8) --------------------------------------------------------------------------


def lagrange_left_sides() -> tuple[sp.Expr, sp.Expr]:
    """Left-hand sides of Lagrange's equations (6.7)."""
    first, second = (
        Rate(sp.diff(T, s)) - sp.diff(T, q) + slope_of_potential(q)
        for q, s in zip(ANGLES, RATES, strict=True)
    )
    return first, second


def with_some_s() -> Case:
    """The left-hand sides are φ̇S and −θ̇S with one S."""
    first, second = lagrange_left_sides()
    return body(), Identity("chaplygin", first * thetadot + second * phidot)


def chaplygin(value: sp.Expr) -> Identity:
    """(6.7) with a given S."""
    first, second = lagrange_left_sides()
    return Identity("chaplygin", (first - phidot * value, second + thetadot * value))


def s_printed() -> sp.Expr:
    """The last expression in (6.7)."""
    along = I_1 * COS_PHI**2 + I_2 * SIN_PHI**2 + I_3
    return SIN**2 * (thetadot * (I_2 - I_1) * SIN_PHI * COS_PHI - phidot * along)


def s_right() -> sp.Expr:
    """−sin θ ∂T₀/∂ψ̇ written out."""
    along = I_3 - I_1 * SIN_PHI**2 - I_2 * COS_PHI**2
    return SIN**2 * (thetadot * (I_2 - I_1) * SIN_PHI * COS_PHI - phidot * SIN * COS * along)


def no_gyroscopic_term() -> Case:
    """(4.4) with an S that is linear and homogeneous in the rates, so that b = 0."""
    value = s_right()
    linear = sp.Add(*(sp.diff(value, s) * s for s in RATES))
    curved = tuple(sp.hessian(value, RATES))
    return (
        (body(), chaplygin(value)),
        (body(), Identity("homogeneous", (value - linear, *curved))),
    )


def kinetic_energy() -> Case:
    """(6.8) and T₀ = ½(ω, Iω)."""
    value = (
        HALF * I_1 * (thetadot * COS_PHI - phidot * SIN_PHI * SIN * COS) ** 2
        + HALF * I_2 * (thetadot * SIN_PHI + phidot * COS_PHI * SIN * COS) ** 2
        + HALF * I_3 * phidot**2 * SIN**4
    )
    return body(), Identity("T", (value - T, value - HALF * dot(omega, I * omega)))


def slopes(of_T: sp.Symbol, further: sp.Expr) -> Case:
    """∂T/∂x = ∂T₀/∂x + `further`."""
    value = sp.diff(T, of_T) - constrained(sp.diff(T_0, of_T)) - further
    return body(), Identity("slope", value)


# --- Theorem 7, (6.10) ---------------------------------------------------------------------


def reducing_multiplier() -> Case:
    """v = ρ_ω⁻¹ J dH."""
    _, form = catalogue.conformally_hamiltonian(catalogue.ANY)
    return catalogue.general(), form


def algebraic_bracket() -> Case:
    """The bracket in ω and γ, with the Casimir functions γ² and (ω, γ)."""
    structure, _ = catalogue.conformally_hamiltonian(catalogue.ANY)
    return catalogue.general(), structure


def euler_lagrange(new_time: sp.Expr) -> Case:
    """(6.9) with d/dτ = 𝒩⁻¹ d/dt."""
    value = tuple(
        Rate(lagrangian(new_time, s)) / new_time - lagrangian(new_time, q) + slope_of_potential(q)
        for q, s in zip(ANGLES, RATES, strict=True)
    )
    return body(), Identity("lagrange", value)


def lagrangian_printed() -> Case:
    """T = ½(γ′×γ, I(γ′×γ))/(γ, I⁻¹γ), with γ′ = 𝒩⁻¹ γ̇."""
    turn = cross(rate(gamma) / REDUCING, gamma)
    value = HALF * dot(turn, I * turn) / dot(gamma, I**-1 * gamma)
    return body(), Identity("L", T - value)


def no_right_hand_side() -> Case:
    """S̄ of (4.5)."""
    bent = sp.diff(REDUCING, phi) * lagrangian(REDUCING, thetadot)
    turned = sp.diff(REDUCING, theta) * lagrangian(REDUCING, phidot)
    return body(), Identity("S", REDUCING * s_right() + (bent - turned) / REDUCING)


@cache
def canonical() -> System:
    """Hamilton's equations in the time τ with H = ½(p, G⁻¹p)/𝒩² + U, for T = ½(q̇, Gq̇)."""
    momenta = sp.Matrix([p_theta, p_phi])
    kinetic = HALF * (momenta.T * metric().inv() * momenta)[0] / REDUCING**2
    flat = PoissonStructure(
        "canonical",
        sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [-1, 0, 0, 0], [0, -1, 0, 0]]),
        rank=4,
    )
    return System(
        name="veselova-canonical",
        title="Veselova system, canonical form",
        parameters=body().parameters,
        definitions={gamma: NORMAL},
        field={
            theta: sp.diff(kinetic, p_theta),
            phi: sp.diff(kinetic, p_phi),
            p_theta: -sp.diff(kinetic, theta) - slope_of_potential(theta),
            p_phi: -sp.diff(kinetic, phi) - slope_of_potential(phi),
        },
        laws=(
            ConformallyHamiltonian(
                "hamiltonian", sp.S.One, flat, kinetic + catalogue.ANY, source="(6.10)"
            ),
        ),
    )


def legendre() -> Case:
    """(6.10): the momenta ∂L/∂θ′, ∂L/∂φ′ obey Hamilton's equations, and H = p q′ − L."""
    momenta = [lagrangian(REDUCING, s) for s in RATES]
    system = canonical()
    (form,) = system.laws
    carried = Isomorphism(
        "canonical",
        system,
        {theta: theta, phi: phi, p_theta: momenta[0], p_phi: momenta[1]},
        REDUCING,
    )
    swept = sp.Add(*(p * s for p, s in zip(momenta, RATES, strict=True))) / REDUCING
    return (
        (body(), carried),
        (system, form),
        (body(), Identity("H", swept - T - HALF * dot(omega, I * omega))),
    )


TEXT_S = (
    r"$S = \sin^2\theta\left(\dot{\theta}(I_2 - I_1)\sin\varphi\cos\varphi - "
    r"\dot{\varphi}"
)

CLAIMS = (
    Claim(
        "§6.2, b = 0",
        r"The Veselova system is the Chaplygin system (4.4) with $b(q) = 0$.",
        no_gyroscopic_term,
    ),
    Claim(
        "§6.2, multiplier",
        r"Upon the time substitution $\mathcal{N}dt = d\tau$ with $\mathcal{N} = \rho_\omega^{-1}$ "
        "it can be written in the Hamiltonian form.",
        reducing_multiplier,
    ),
    Claim(
        "§6.2, bracket",
        "The canonical Poisson structure of the cotangent bundle of the sphere gives an algebraic "
        r"Poisson bracket of the redundant variables $\omega, \gamma$.",
        algebraic_bracket,
        note="{ω, ω} and {ω, γ} are ρ_ω⁻¹ (det I)⁻¹ times the matrices of "
        "Iω + ω×(γ×Iγ) and γ̂ I (E − γ⊗γ); {γ, γ} = 0",
    ),
    Claim(
        "(6.5)",
        r"$\omega = (\dot{\psi}\sin\theta\sin\varphi + \dot{\theta}\cos\varphi, "
        r"\dot{\psi}\sin\theta\cos\varphi - \dot{\theta}\sin\varphi, "
        r"\dot{\psi}\cos\theta + \dot{\varphi})$, "
        r"$\gamma = (\sin\theta\sin\varphi, \sin\theta\cos\varphi, \cos\theta)$",
        angular_velocity,
    ),
    Claim(
        "(6.6)",
        r"$f = (\omega, \gamma) = \dot{\psi} + \cos\theta\dot{\varphi} = 0$",
        constraint,
    ),
    Claim(
        "(6.7), form",
        r"$\frac{d}{dt}\frac{\partial T}{\partial\dot{\theta}} - \frac{\partial T}{\partial\theta} "
        r"+ \frac{\partial U}{\partial\theta} = \dot{\varphi}S$, "
        r"$\frac{d}{dt}\frac{\partial T}{\partial\dot{\varphi}} - "
        r"\frac{\partial T}{\partial\varphi} + \frac{\partial U}{\partial\varphi} = "
        r"-\dot{\theta}S$",
        with_some_s,
        note="with one function S, to be named by the next two claims",
    ),
    Claim(
        "(6.7), S by T₀",
        r"$S = \frac{\partial T_0}{\partial\dot{\psi}}"
        r"|_{\dot{\psi} = -\cos\theta\dot{\varphi}}$",
        lambda: (body(), chaplygin(VERTICAL)),
        lambda: (body(), chaplygin(-SIN * VERTICAL)),
        r"$S = -\sin\theta\frac{\partial T_0}{\partial\dot{\psi}}"
        r"|_{\dot{\psi} = -\cos\theta\dot{\varphi}}$",
        "missing factor −sin θ, the derivative of the coefficient cos θ of the constraint",
    ),
    Claim(
        "(6.7), S in the angles",
        TEXT_S + r"(I_1\cos^2\varphi + I_2\sin^2\varphi + I_3)\right)$",
        lambda: (body(), chaplygin(s_printed())),
        lambda: (body(), chaplygin(s_right())),
        TEXT_S + r"\sin\theta\cos\theta(I_3 - I_1\sin^2\varphi - I_2\cos^2\varphi)\right)$",
        "missing factor sin θ cos θ, wrong signs of I₁ and I₂, and sin φ, cos φ exchanged",
    ),
    Claim(
        "(6.8)",
        r"$T = \frac{1}{2}I_1(\dot{\theta}\cos\varphi - "
        r"\dot{\varphi}\sin\varphi\sin\theta\cos\theta)^2 + "
        r"\frac{1}{2}I_2(\dot{\theta}\sin\varphi + "
        r"\dot{\varphi}\cos\varphi\sin\theta\cos\theta)^2 + "
        r"\frac{1}{2}I_3\dot{\varphi}^2\sin^4\theta$",
        kinetic_energy,
    ),
    Claim(
        "Remark 19, ∂T/∂θ̇",
        r"$\frac{\partial T}{\partial\dot{\theta}} = \frac{\partial T_0}{\partial\dot{\theta}}$",
        lambda: slopes(thetadot, sp.S.Zero),
    ),
    Claim(
        "Remark 19, ∂T/∂φ̇",
        r"$\frac{\partial T}{\partial\dot{\varphi}} = "
        r"\frac{\partial T_0}{\partial\dot{\varphi}} - "
        r"\cos\theta\frac{\partial T_0}{\partial\dot{\psi}}$",
        lambda: slopes(phidot, -COS * VERTICAL),
    ),
    Claim(
        "Remark 19, ∂T/∂θ",
        r"$\frac{\partial T}{\partial\theta} = \frac{\partial T_0}{\partial\theta} + "
        r"\dot{\varphi}\sin\theta\frac{\partial T_0}{\partial\psi}$",
        lambda: slopes(theta, phidot * SIN * constrained(sp.diff(T_0, psi))),
        lambda: slopes(theta, phidot * SIN * VERTICAL),
        r"$\frac{\partial T}{\partial\theta} = \frac{\partial T_0}{\partial\theta} + "
        r"\dot{\varphi}\sin\theta\frac{\partial T_0}{\partial\dot{\psi}}$",
        "missing dot: the derivative is by ψ̇; T₀ does not depend on ψ",
    ),
    Claim(
        "Remark 19, ∂T/∂φ",
        r"$\frac{\partial T}{\partial\varphi} = \frac{\partial T_0}{\partial\varphi}$",
        lambda: slopes(phi, sp.S.Zero),
    ),
    Claim(
        "Theorem 7, (6.9)",
        r"After the time substitution $\mathcal{N}dt = d\tau$, "
        r"$\mathcal{N} = (\gamma, I\gamma)^{-1/2}$, the equations of motion take the form "
        r"$\frac{d}{d\tau}\frac{\partial L}{\partial\theta'} - \frac{\partial L}{\partial\theta} = "
        r"0$, $\frac{d}{d\tau}\frac{\partial L}{\partial\varphi'} - "
        r"\frac{\partial L}{\partial\varphi} = 0$ with $L = T - U$, "
        r"$\dot{\theta} = \mathcal{N}\theta'$, $\dot{\varphi} = \mathcal{N}\varphi'$.",
        lambda: euler_lagrange(PRINTED),
        lambda: euler_lagrange(REDUCING),
        r"The same with $\mathcal{N} = (\gamma, I^{-1}\gamma)^{-1/2}$.",
        "missing inverse: 𝒩 is 1/ρ_ω",
    ),
    Claim(
        "Theorem 7, L",
        r"$L = \frac{1}{2}\frac{(\gamma' \times \gamma, I(\gamma' \times \gamma))}"
        r"{(\gamma, I^{-1}\gamma)} - U(\gamma)$",
        lagrangian_printed,
        note="with 𝒩 = (γ, I⁻¹γ)^(−1/2)",
    ),
    Claim(
        "Theorem 7, proof",
        r"After the time substitution, the right-hand side $\bar{S}$ of (6.9), calculated by "
        "virtue of (4.5), vanishes.",
        no_right_hand_side,
        note="with 𝒩 = (γ, I⁻¹γ)^(−1/2) and the right S of (6.7)",
    ),
    Claim(
        "(6.10)",
        r"$p_\theta = \frac{\partial L}{\partial\theta'}$, "
        r"$p_\varphi = \frac{\partial L}{\partial\varphi'}$, "
        r"$H = p_\theta\theta' + p_\varphi\varphi' - L$ give the canonical equations "
        r"$\frac{d\theta}{d\tau} = \frac{\partial H}{\partial p_\theta}$, "
        r"$\frac{d\varphi}{d\tau} = \frac{\partial H}{\partial p_\varphi}$, "
        r"$\frac{dp_\theta}{d\tau} = -\frac{\partial H}{\partial\theta}$, "
        r"$\frac{dp_\varphi}{d\tau} = -\frac{\partial H}{\partial\varphi}$.",
        legendre,
    ),
)

REMARKS = (
    Remark(
        "§6.2, first paragraph",
        "The isomorphism with the Neumann system was established in [16, 27]; the analogy can be "
        "extended to the Chaplygin ball and the general Clebsch system.",
        "history; the statement on the ball is made precise, and decided, in section 7",
    ),
)
