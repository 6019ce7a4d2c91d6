"""§5, after (5.2): the measure, the Hamiltonian form and two bodies of simple shape."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Identity, Measure, Rate, Reduction
from flowlanes.system.system import System
from flowlanes.system.vectors import constant, real_symbol, to_components, vectors
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.angles import phi, theta
from nonholonomic.catalogue.bodies.rubber_profile import A, B

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import computed_verdict
from ..methods.tori import of_rank_two
from .section_05_a import body, body_in_angles, constants, quadratures

M, omega, gamma, r, c = vectors("M omega gamma r c")
m, g, R, I_1, I_2, I_3 = (real_symbol(s) for s in ("m", "g", "R", "I_1", "I_2", "I_3"))
h, k, u = (real_symbol(s) for s in ("h", "k", "u"))
g_1, g_2, g_3 = gamma.symbols
w_3 = omega.symbols[2]
HALF = sp.Rational(1, 2)

#: The centre of the disk or ball is at −a on the axis.
a = -c.symbols[2]
#: cos θ and sin θ.
COS, SIN = g_3, sp.sqrt(1 - g_3**2)
LEVEL = (I_1 - I_2, *c.symbols[:2])


# --- measure and Hamiltonian form ----------------------------------------------------------


def measure() -> Case:
    """ρ = BA."""
    return body(), Measure("measure", {B: sp.S.One, A: HALF})


def determinant() -> Case:
    """det Ĩ (γ, Ĩ⁻¹γ) with the adjugate of Ĩ = I + m r² − m r⊗r."""
    x = sp.Matrix(r.symbols)
    tensor = sp.diag(I_1, I_1, I_3) + m * (x.dot(x) * sp.eye(3) - x * x.T)
    normal = sp.Matrix(gamma.symbols)
    return body(), Identity("determinant", normal.dot(tensor.adjugate() * normal) - B * A)


def proposition() -> Case:
    """Check Proposition 5.

    On a level, θ̇² and φ̇ are functions of θ, and φ̇ has the sign of k ≠ 0. The motion on tori has a
    Hamiltonian form of rank two.
    """
    return quadratures(), nowhere_zero(), *of_rank_two()


def nowhere_zero() -> tuple[System, Identity]:
    """kφ̇ = k²/(A sin²θ)."""
    _, constant_k = constants()
    value = constant_k * Rate(phi) - constant_k**2 / (sp.sqrt(A) * sp.sin(theta) ** 2)
    return body_in_angles(), Identity("phi", value)


def always_positive() -> Verdict:
    """The sign of φ̇ = ω₃/sin²θ at a point of the phase space with k < 0."""
    normal = [sp.Rational(n, 7) for n in (2, 3, 6)]
    turn = [sp.Integer(n) for n in (3, 0, -1)]
    on_constraint = sum(x * y for x, y in zip(normal, turn, strict=True)) == 0
    rate = turn[2] / (1 - normal[2] ** 2)
    refuted = on_constraint and rate < 0
    return computed_verdict(
        "phi increases",
        refuted,
        "φ̇ is negative at a point with k < 0",
        "the point tried does not decide it",
        decision="refuted",
        witness={"omega": str(turn), "gamma": str(normal), "residual": str(rate)},
    )


# --- disk and ball -------------------------------------------------------------------------


def profile(name: str, chi_1: sp.Expr, chi_2: sp.Expr) -> Case:
    """r of the mechanics is (χ₁γ₁, χ₁γ₂, χ₂)."""
    system = CATALOGUE[name].system()
    value = r - constant([chi_1 * g_1, chi_1 * g_2, chi_2])
    return system, Identity("profile", to_components(value), level=LEVEL)


def nutation(name: str, principal: sp.Expr, weight: sp.Expr) -> Case:
    """½ B θ̇² = h − U − ½k²/sin²θ, with θ̇² = γ̇₃²/(1 − γ₃²)."""
    system = CATALOGUE[name].system()
    (energy,) = (law.value for law in system.integrals if law.name == "energy")
    (linear,) = (law.value for law in system.integrals if law.name == "spin")
    speed = Rate(u) ** 2 / (1 - u**2)
    return system, Reduction(
        "nutation",
        {u: g_3, k: linear, h: energy},
        (Rate(k), Rate(h), HALF * principal * speed - (h - weight - HALF * k**2 / SIN**2)),
        level=LEVEL,
    )


def disk_profile() -> Case:
    """χ₁ = −R/sin θ, χ₂ = −a."""
    return profile("rubber-disk", -R / SIN, -a)


def disk_quadrature() -> Case:
    """B = I₁ + m(R² + a²), U = mg(R sin θ + a cos θ)."""
    return nutation("rubber-disk", I_1 + m * (R**2 + a**2), m * g * (R * SIN + a * COS))


def ball_profile() -> Case:
    """χ₁ = −R, χ₂ = −R cos θ − a."""
    return profile("rubber-routh-sphere", -R, -R * COS - a)


def ball_quadrature() -> Case:
    """B = I₁ + m(R² + a²) + 2mRa cos θ, U = mg(R + a cos θ)."""
    principal = I_1 + m * (R**2 + a**2) + 2 * m * R * a * COS
    return nutation("rubber-routh-sphere", principal, m * g * (R + a * COS))


CLAIMS = (
    Claim(
        "§5, measure",
        r"The density of the measure $\rho\, d^3\omega\, d^3\gamma$ is "
        r"$\rho(\gamma_3) = B(\gamma_3)A(\gamma_3)$.",
        measure,
    ),
    Claim(
        "Remark 14",
        r"$\det \tilde{I}(\gamma, \tilde{I}^{-1}\gamma) = B(\gamma_3)A^2(\gamma_3)$",
        determinant,
    ),
    Claim(
        "Proposition 5",
        r"If $k \neq 0$, the equations of a heavy rubber body of revolution can be represented "
        "(without change of time) in the Hamiltonian form.",
        proposition,
        note="on a regular level θ̇² and φ̇ depend on θ alone and φ̇ does not vanish, so that "
        "Theorem 4 gives (4.2), of which a bracket of rank two is shown. Corollary 1 as printed "
        "does not suffice",
        where=(
            "the motion is near a torus at which the rotation number has a differential that is "
            "not zero, or is constant",
        ),
    ),
    Claim(
        "Proposition 5, proof",
        r"In view of the first equation in (5.2), the condition $\dot{\varphi} > 0$ is fulfilled "
        "everywhere.",
        always_positive,
        nowhere_zero,
        r"In view of the second line of (5.2), $k\dot{\varphi} = k^2/(A\sin^2\theta) > 0$ "
        "everywhere.",
        "φ̇ has the sign of k, which may be negative",
        erratum="“first equation” is printed for “second line” of (5.2), which gives φ̇",
    ),
    Claim(
        "§5, disk, profile",
        r"Disk with displaced centre of mass: $\chi_1 = -\frac{R}{\sin\theta}$, $\chi_2 = -a$.",
        disk_profile,
    ),
    Claim(
        "§5, disk, quadrature",
        r"$\frac{1}{2}(I_1 + m(R^2 + a^2))\dot{\theta}^2 = h - mg(R\sin\theta + a\cos\theta) - "
        r"\frac{1}{2}\frac{k^2}{\sin^2\theta}$",
        disk_quadrature,
    ),
    Claim(
        "§5, ball, profile",
        r"Ball with displaced centre: $\chi_1 = -R$, $\chi_2 = -R\cos\theta - a$.",
        ball_profile,
    ),
    Claim(
        "§5, ball, quadrature",
        r"$\frac{1}{2}(I_1 + m(R^2 + a^2) + 2mRa\cos\theta)\dot{\theta}^2 = h - mg(R + "
        r"a\cos\theta) - \frac{1}{2}\frac{k^2}{\sin^2\theta}$",
        ball_quadrature,
    ),
)

REMARKS = (
    Remark(
        "§5, after (5.1)",
        "The existence of a linear integral is quite expectable [1]; that it is elementary for any "
        "shape of the body is far from trivial.",
        "opinion; that it is an integral for any shape is (5.1)",
    ),
)
