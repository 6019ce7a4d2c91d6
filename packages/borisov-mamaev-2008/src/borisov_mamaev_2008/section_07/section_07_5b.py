"""§7.5, 2: Fedorov's isomorphism of the Chaplygin ball with the Clebsch case."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import sympy as sp

from flowlanes.system.laws import Identity, Integral, Rate
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball import DENSITY
from nonholonomic.catalogue.chaplygin_ball.chaplygin_ball_clebsch import onto_fedorov
from nonholonomic.catalogue.chaplygin_ball.chaplygin_bracket import DET_J, A, D, I, J, gamma
from nonholonomic.catalogue.vector_rates import rate

from ..claim import Case, Claim, Remark
from ..methods.catalogue_laws import printed_form

M, omega, Q, K = vectors("M omega Q K")
rho = real_symbol("rho")
INVERSE = I**-1
AREA = (dot(M, gamma),)
TILT = dot(I * gamma, A * gamma)
LOAD = dot(J * K, INVERSE * K)
#: Reading of ρ_μ in the rest of §7.5.
SAME_DENSITY = r"with the corrected $\rho_\mu = (1 - D(\gamma, J^{-1}\gamma))^{1/2}$"


@cache
def ball_with_density(density: sp.Expr) -> System:
    """The ball without a field, with ρ, Q = Iω and K = ρQ.

    Parameters
    ----------
    density : Expr
        Formula for ρ, the density of the invariant measure.
    """
    system = CATALOGUE["chaplygin-ball"].system()
    further = ((rho, density), (Q, I * omega), (K, rho * Q))
    return replace(system, definitions=system.definitions + further, laws=())


@cache
def rightly() -> System:
    """The ball with ρ = (1 − D(γ, J⁻¹γ))^(1/2)."""
    return ball_with_density(sp.sqrt(1 - D * dot(gamma, A * gamma)))


RATE_OF_DENSITY = Identity("density", Rate(rho) + D * dot(cross(gamma, omega), A * gamma) / rho)


def density_printed() -> Case:
    """The rate of ρ_μ of (7.3)."""
    return ball_with_density(DENSITY), RATE_OF_DENSITY


def density() -> Case:
    """The rate of (1 − D(γ, J⁻¹γ))^(1/2)."""
    return rightly(), RATE_OF_DENSITY


def momentum() -> Case:
    """The rate of ρQ."""
    turn = cross(Q, INVERSE * Q)
    value = (
        I * (A * cross(Q, rho * (INVERSE * Q)))
        + D * dot(turn, A * gamma) / rho * (I * (A * gamma))
        - D * dot(cross(gamma, INVERSE * Q), A * gamma) / rho * Q
    )
    return rightly(), Identity("momentum", rate(rho * Q) - value)


def normal() -> Case:
    """The rate of γ."""
    return rightly(), Identity("normal", rate(gamma) - cross(gamma, INVERSE * Q))


def level() -> Case:
    """(Q, γ) = 0 is the level (M, γ) = 0."""
    return (
        (rightly(), Identity("level", dot(Q, gamma) - dot(M, gamma))),
        (rightly(), Identity("level", dot(K, gamma), level=AREA)),
        (ball_with_density(DENSITY), Identity("level", dot(K, gamma), level=AREA)),
    )


def in_new_time() -> Case:
    """The rates of K and γ in the time τ, at (K, γ) = 0."""
    pull = D / DET_J * LOAD / TILT * cross(gamma, I * gamma)
    return rightly(), Identity(
        "new_time",
        (
            rho * rate(K) - (cross(K, INVERSE * K) - pull),
            rho * rate(gamma) - cross(gamma, INVERSE * K),
        ),
        level=AREA,
    )


def integral_printed() -> Case:
    """The integral as printed."""
    value = LOAD / dot(INVERSE * gamma, J * gamma)
    return rightly(), Integral("fedorov", value, level=AREA)


def integral() -> Case:
    """The corrected integral, equal to M² − 2DH."""
    value = LOAD / TILT
    known = norm_squared(M) - D * dot(M, omega)
    return (
        (rightly(), Integral("fedorov", value, level=AREA)),
        (rightly(), Identity("known", value - known, level=AREA)),
    )


def final_printed() -> Case:
    """The final system as printed, with J⁻¹ in the rate of γ."""
    return CATALOGUE["chaplygin-ball"].system(), printed_form(onto_fedorov())


def final() -> Case:
    """The final system as corrected, and its isomorphism with the ball."""
    return CATALOGUE["chaplygin-ball"].system(), onto_fedorov()


def clebsch() -> Case:
    """The final system is a Clebsch case of the Kirchhoff equations."""
    system = CATALOGUE["chaplygin-ball-fedorov"].system()
    return tuple((system, law) for law in system.laws)


CLAIMS = (
    Claim(
        r"§7.5, rate of ρ_μ",
        r"$\dot{\rho}_\mu = -D((\gamma \times \omega), J^{-1}\gamma) / \rho_\mu$ for $\rho_\mu$ "
        "of (7.3)",
        density_printed,
        density,
        r"$\dot{\rho} = -D((\gamma \times \omega), J^{-1}\gamma) / \rho$ for "
        r"$\rho = (1 - D(\gamma, J^{-1}\gamma))^{1/2}$",
        r"another ρ: the density in ω instead of that in M of (7.3), "
        r"$\rho = (\rho_\mu^2 \det J)^{-1/2}$",
    ),
    Claim(
        "§7.5, rate of ρ_μ Q",
        r"$\frac{d}{dt}(\rho_\mu Q) = IJ^{-1}(Q \times \rho_\mu I^{-1}Q) + "
        r"((Q \times I^{-1}Q), DJ^{-1}\gamma) IJ^{-1}\gamma / \rho_\mu - "
        r"DQ((\gamma \times I^{-1}Q), J^{-1}\gamma) / \rho_\mu$, $Q = I\omega$",
        momentum,
        note=SAME_DENSITY,
    ),
    Claim(
        "§7.5, rate of γ",
        r"$\frac{d\gamma}{dt} = \gamma \times I^{-1}Q$",
        normal,
    ),
    Claim(
        "§7.5, level",
        r"$(Q, \gamma) = (K, \gamma) = 0$ is the level $(M, \gamma) = 0$.",
        level,
        note="for either ρ",
    ),
    Claim(
        "§7.5, rates of K and γ",
        r"With $dt = \rho_\mu d\tau$, $K = \rho_\mu Q$ on $(K, \gamma) = 0$: "
        r"$\frac{dK}{d\tau} = K \times I^{-1}K - \frac{D}{\det J} "
        r"\frac{(JK, I^{-1}K)}{(I\gamma, J^{-1}\gamma)} \gamma \times I\gamma$, "
        r"$\frac{d\gamma}{d\tau} = \gamma \times I^{-1}K$",
        in_new_time,
        note=SAME_DENSITY,
    ),
    Claim(
        "§7.5, integral 𝓛",
        r"$\mathcal{L} = \frac{(JK, I^{-1}K)}{(I^{-1}\gamma, J\gamma)}$ is an integral.",
        integral_printed,
        integral,
        r"$\mathcal{L} = \frac{(JK, I^{-1}K)}{(I\gamma, J^{-1}\gamma)} = M^2 - 2DH$ is an "
        "integral.",
        "the inverse stands at the wrong tensor in the denominator; " + SAME_DENSITY,
    ),
    Claim(
        "§7.5, final system",
        r"On $\mathcal{L} = \beta$: $\frac{dK}{d\tau} = K \times I^{-1}K - "
        r"\beta' \gamma \times I\gamma$, $\beta' = \frac{D}{\det J} \beta$, "
        r"$\frac{d\gamma}{d\tau} = \gamma \times J^{-1}K$",
        final_printed,
        final,
        r"On $\mathcal{L} = \beta$: $\frac{dK}{d\tau} = K \times I^{-1}K - "
        r"\beta' \gamma \times I\gamma$, $\beta' = \frac{D}{\det J} \beta$, "
        r"$\frac{d\gamma}{d\tau} = \gamma \times I^{-1}K$",
        r"$J^{-1}$ for $I^{-1}$ in the rate of γ",
    ),
    Claim(
        "§7.5, last paragraph",
        "The system corresponds to the integrable Clebsch case of the Kirchhoff equations.",
        clebsch,
        note="read for the corrected system; its integral of Clebsch is "
        r"$K^2 + \beta' \det I (\gamma, I^{-1}\gamma)$",
    ),
)

REMARKS = (
    Remark(
        "§7.5, last paragraph",
        "This isomorphism differs from the one indicated above; their relation would be of "
        "interest.",
        "an opinion and an open question",
    ),
)
