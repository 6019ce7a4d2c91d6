"""§6.3, up to (6.13): the Veselova system on e(3).

A Hamiltonian system on e(3) is read as in (6.11): dM/dτ = M×∂H/∂M + Γ×∂H/∂Γ, dΓ/dτ = Γ×∂H/∂M. The
bracket printed with it has the opposite sign and would reverse the time.
"""

from __future__ import annotations

from functools import cache

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, PoissonStructure
from flowlanes.system.system import System
from flowlanes.system.vectors import (
    constant,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof.proof.prover import prove
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import e3, from_catalogue
from nonholonomic.catalogue.e3 import Gamma, I, M
from nonholonomic.catalogue.fixed_point import veselova as catalogue, veselova_geodesic as geodesic

from ..claim import Case, Claim, Remark
from ..methods.derived_verdicts import computed_verdict

omega, gamma = vectors("omega gamma")
I_1, I_2, I_3 = I.symbols
k = real_symbol("k")
HALF = sp.Rational(1, 2)
DET = I_1 * I_2 * I_3
MOMENTS = (1.0, 1.5, 2.1)
NUMBERS = {"I_1": 1.0, "I_2": 1.5, "I_3": 2.1, "alpha": 1.0, "beta": 0.7, "c": 0.8}
DENSITY = catalogue.DENSITY
ROOT = geodesic.ROOT
INVERSE_ROOT = constant(to_components(ROOT).inv())

#: M and Γ of (6.11) in terms of ω and γ; L and s of Proposition 6 in terms of M and Γ.
M_OF, GAMMA_OF = DENSITY * ROOT * omega, INVERSE_ROOT * gamma / DENSITY
L, S = INVERSE_ROOT * M, ROOT * Gamma / geodesic.LENGTH


# --- (6.11), (6.12) ------------------------------------------------------------------------


@cache
def body() -> System:
    """The Veselova system in an unspecified potential."""
    return catalogue.general()


@cache
def free_flow() -> System:
    """(6.12) with U = 0, on (M, Γ) = 0."""
    return geodesic.in_potential(sp.S.Zero, MOMENTS)


@cache
def flow() -> System:
    """(6.13), on (M, Γ) = 0."""
    return from_catalogue("veselova-geodesic-flow")


@cache
def off_level() -> System:
    """(6.12) with U = 0, for any (M, Γ)."""
    return e3.e3_system("veselova-off-level", "", geodesic.FIRST, e3.inertia_parameters(MOMENTS))


def onto_e3() -> Case:
    """(6.11) in an unspecified potential."""
    return body(), catalogue.onto_e3(catalogue.ANY, MOMENTS)


def hamiltonian() -> Case:
    """H of (6.12) is the energy, and (Γ, IΓ)^(−1/2) I^(1/2) Γ is γ."""
    value = HALF * dot(GAMMA_OF, I * GAMMA_OF) * norm_squared(M_OF)
    normal = DENSITY * ROOT * GAMMA_OF
    return body(), Identity("H", (value - HALF * dot(omega, I * omega), normal - gamma))


def relations() -> Case:
    """Γ² = 1, (ω, γ) = (M, Γ), ρ_ω = (Γ, IΓ)^(−1/2)."""
    return body(), Identity(
        "relations",
        (
            norm_squared(GAMMA_OF) - 1,
            dot(M_OF, GAMMA_OF) - dot(omega, gamma),
            DENSITY - 1 / sp.sqrt(dot(GAMMA_OF, I * GAMMA_OF)),
        ),
    )


def bracket(sign: int) -> Case:
    """(6.11) is ẋ = {x, H} of (3.5) with {M_i, M_j} = `sign` ε_ijk M_k."""
    return free_flow(), e3.hamiltonian_form(e3.bracket(sign))


def leaf_by_gamma() -> Verdict:
    """γ² as a function of Γ is identically one, so that it restricts nothing on e(3)."""
    verdict = prove(off_level(), Identity("unit", norm_squared(S) - 1))
    return computed_verdict(
        "leaf",
        verdict,
        "γ² = 1 for every Γ, so that γ² = 1, (M, Γ) = 0 leaves five dimensions",
        verdict.reason,
        decision="refuted",
    )


def leaf() -> Case:
    """Γ² and (M, Γ) are the Casimir functions of a bracket of rank four."""
    return off_level(), PoissonStructure(
        "leaf", e3.lie_poisson(M, Gamma), casimirs=(norm_squared(Gamma), dot(M, Gamma)), rank=4
    )


def geodesic_flow() -> Case:
    """For U = 0, H is quadratic in M, and F is a second integral."""
    return free_flow(), Integral("F", second())


def inverse() -> Case:
    """The inverse map from M and Γ to the Veselova system."""
    back = Isomorphism(
        "veselova",
        from_catalogue("veselova"),
        {omega: geodesic.LENGTH * INVERSE_ROOT * M, gamma: S},
        sp.sqrt(DET) / geodesic.LENGTH,
    )
    return free_flow(), back


def second() -> sp.Expr:
    """F as it is printed after (6.12)."""
    return dot(I * M, M) * dot(I * Gamma, Gamma) - dot(I * M, Gamma) ** 2


def second_integral() -> Case:
    """F of (6.4) in M and Γ."""
    momentum = I * omega
    value = dot(I * M_OF, M_OF) * dot(I * GAMMA_OF, GAMMA_OF) - dot(I * M_OF, GAMMA_OF) ** 2
    same = value - (norm_squared(momentum) - dot(momentum, gamma) ** 2)
    return (
        (from_catalogue("veselova"), Identity("F", same)),
        (free_flow(), Integral("F", second())),
    )


def only_on_level() -> Verdict:
    """{H, F} = 0 only on (M, Γ) = 0."""
    law = Integral("F", second())
    on, off = prove(free_flow(), law), prove(off_level(), law)
    decided = on.decision == "proven" and off.decision == "refuted"
    return computed_verdict(
        "only on the level",
        decided,
        "zero on the level, and not zero at a point with (M, Γ) ≠ 0",
        on.reason or off.reason,
        witness=off.witness,
    )


CLAIMS = (
    Claim(
        "(6.11)",
        r"With the time substitution $(\rho_\omega\sqrt{\det I})^{-1}dt = d\tau$ and "
        r"$M = \rho_\omega I^{1/2}\omega$, $\Gamma = \rho_\omega^{-1}I^{-1/2}\gamma$ the "
        "equations are "
        r"$\frac{dM}{d\tau} = M \times \frac{\partial H}{\partial M} + \Gamma \times "
        r"\frac{\partial H}{\partial\Gamma}$, $\frac{d\Gamma}{d\tau} = \Gamma \times "
        r"\frac{\partial H}{\partial M}$.",
        onto_e3,
    ),
    Claim(
        "(6.12)",
        r"$H = \frac{1}{2}(\Gamma, I\Gamma)(M, M) + \tilde{U}(\Gamma)$, "
        r"$\tilde{U}(\Gamma) = U(\rho_\omega I^{1/2}\Gamma)$",
        hamiltonian,
    ),
    Claim(
        "§6.3, after (6.12), relations",
        r"$\gamma^2 = \Gamma^2 = 1$, $(\omega, \gamma) = (M, \Gamma) = 0$, "
        r"$\rho_\omega = (\gamma, I^{-1}\gamma)^{1/2} = (\Gamma, I\Gamma)^{-1/2}$",
        relations,
    ),
    Claim(
        "§6.3, after (6.12), bracket",
        r"(6.11) is Hamiltonian with $\{M_i, M_j\} = \varepsilon_{ijk}M_k$, "
        r"$\{M_i, \Gamma_j\} = \varepsilon_{ijk}\Gamma_k$, $\{\Gamma_i, \Gamma_j\} = 0$.",
        lambda: bracket(1),
        lambda: bracket(-1),
        r"$\{M_i, M_j\} = -\varepsilon_{ijk}M_k$, $\{M_i, \Gamma_j\} = "
        r"-\varepsilon_{ijk}\Gamma_k$, $\{\Gamma_i, \Gamma_j\} = 0$",
        "wrong sign: with ẋ = {x, H}, as in (3.5) and (4.6), it gives (6.11) backwards",
    ),
    Claim(
        "§6.3, symplectic leaf",
        r"The four-dimensional symplectic leaf is given by $\gamma^2 = 1$, $(M, \Gamma) = 0$.",
        leaf_by_gamma,
        leaf,
        r"It is given by $\Gamma^2 = 1$, $(M, \Gamma) = 0$.",
        "γ instead of Γ: γ² by Γ is one everywhere",
    ),
    Claim(
        "§6.3, geodesic flow",
        "The system (6.11), (6.12) determines a certain integrable potential system on a "
        "two-dimensional sphere and defines thereby a certain geodesic flow.",
        geodesic_flow,
        note="H and F are quadratic in M and in involution; with an arbitrary U the system is not "
        "integrable",
        where=("U = 0",),
    ),
    Claim(
        "§6.3, inverse transformation",
        r"$\omega = (\Gamma, I\Gamma)^{1/2}I^{-1/2}M$, "
        r"$\gamma = (\Gamma, I\Gamma)^{-1/2}I^{1/2}\Gamma$",
        inverse,
    ),
    Claim(
        "§6.3, F",
        r"If $U = 0$, the integral (6.4) is $F = (IM, M)(I\Gamma, \Gamma) - (IM, \Gamma)^2$.",
        second_integral,
    ),
    Claim(
        "§6.3, {H, F}",
        r"$\{H, F\} = 0$ only on the level $(M, \Gamma) = 0$.",
        only_on_level,
    ),
)

REMARKS = (
    Remark(
        "§6.3, after (6.12)",
        "A similar situation takes place for the Euler–Poisson equations with zero area constant; "
        "a search for integrable potentials is reduced to one on e(3).",
        "a comparison and a programme",
    ),
    Remark(
        "§6.3, before (6.13)",
        "It was noted in [16, 27] that for U = 0 the system is equivalent to the Neumann problem.",
        "history; the equivalence is Theorem 8",
    ),
)
