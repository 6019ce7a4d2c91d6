"""The rubber ball on a sphere in sphero-conical coordinates, (9.5)–(9.10).

ξ and η are the roots of Σ nᵢ²/(Jᵢ − z); in them (9.2) is a Chaplygin system with the reducing
multiplier N = (ξη / det J)^(1/(2k) − 1).
"""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import ConformallyHamiltonian, Integral, Measure, PoissonStructure
from flowlanes.system.system import Guard, System
from flowlanes.system.vectors import Components, constant, cross, real_symbol, vectors

from . import rubber_ball_on_e3, rubber_ball_ratio as ratio
from .rubber_ball_ratio import DET_J, J, k

omega, n, ndot = vectors("omega n ndot")
xi, eta = real_symbol("xi"), real_symbol("eta")
#: Velocities ξ̇, η̇; momenta ∂T/∂ξ̇, ∂T/∂η̇; canonical momenta N ∂T/∂ξ̇, N ∂T/∂η̇.
xidot, etadot = real_symbol("xidot"), real_symbol("etadot")
P_xi, P_eta = real_symbol("P_xi"), real_symbol("P_eta")
p_xi, p_eta = real_symbol("p_xi"), real_symbol("p_eta")
#: A(ξ), A(η), their derivatives, and what (9.14) is divided by.
A_xi, A_eta, B_xi, B_eta, Q = (
    real_symbol(name) for name in ("A_xi", "A_eta", "B_xi", "B_eta", "Q")
)
H, N = real_symbol("H"), real_symbol("N")

NAME, TITLE = "rubber-ball-sphero-conical", "Rubber ball on a sphere, sphero-conical coordinates"
SUMMARY = (
    "The rubber ball on a sphere in canonical sphero-conical coordinates of the normal and the "
    "time dτ = N dt."
)
SOURCE = "§9.3, (9.5)–(9.10), (9.14)"
DEFAULTS = {"J_1": 0.5, "J_2": 0.9, "J_3": 1.35, "k": 0.6}


def cubic(z: sp.Expr) -> sp.Expr:
    """A(z) = (J₁ − z)(J₂ − z)(J₃ − z)."""
    return sp.Mul(*(j - z for j in J.symbols))


def kinetic(sign: int = 1) -> sp.Expr:
    """(9.7) in ξ, η, ξ̇, η̇, with the sign for which it is positive; −1 as printed."""
    share = eta * xidot**2 / cubic(xi) - xi * etadot**2 / cubic(eta)
    return sign * (xi - eta) / (8 * k**2) * share


#: S of (9.8).
GYROSCOPIC = (2 * k - 1) / (8 * k**3) * (xi - eta) * (xidot / cubic(xi) + etadot / cubic(eta))
#: N of (9.9) in ξ, η.
MULTIPLIER = (xi * eta / DET_J) ** (1 / (2 * k) - 1)


def hamiltonian() -> sp.Expr:
    """The last expression of (9.14)."""
    share = cubic(xi) / eta * p_xi**2 - cubic(eta) / xi * p_eta**2
    return 2 * k**2 / (xi - eta) * (xi * eta / DET_J) ** ((2 * k - 1) / k) * share


#: The same in the named quantities.
ENERGY = (A_xi * p_xi**2 / eta - A_eta * p_eta**2 / xi) / Q


def normal() -> Components:
    """n by (9.6), in the octant n₁, n₂, n₃ > 0."""
    return constant([sp.sqrt(square(i, xi, eta)) for i in range(3)])


def square(i: int, first: sp.Expr, second: sp.Expr) -> sp.Expr:
    """nᵢ² by (9.6), from the two roots."""
    own = J.symbols[i]
    others = [j for j in J.symbols if j != own]
    return (own - first) * (own - second) / sp.Mul(*(own - j for j in others))


def turning(rate_xi: sp.Expr, rate_eta: sp.Expr) -> Components:
    """ṅ for given ξ̇, η̇, with n taken from the definitions."""
    return constant(
        [
            -s / 2 * (rate_xi / (j - xi) + rate_eta / (j - eta))
            for s, j in zip(n.symbols, J.symbols, strict=True)
        ]
    )


def _system(
    name: str,
    field: Mapping[sp.Symbol, sp.Expr],
    rates: tuple[sp.Expr, sp.Expr],
    before: Mapping[sp.Symbol, sp.Expr] | None = None,
) -> System:
    return System(
        name=name,
        title=TITLE,
        summary=SUMMARY,
        source=SOURCE,
        parameters=rubber_ball_on_e3.parameters(DEFAULTS),
        definitions={
            **(before or {}),
            n: normal(),
            ndot: turning(*rates),
            omega: cross(ndot, n) / k,
        },
        field=field,
        # between the moments of inertia, and so positive: powers are taken of ξη
        guards=tuple(Guard(str(z), z, f"the coordinate {z} vanishes") for z in (xi, eta)),
    )


def in_chaplygin_form(kinetic_energy: sp.Expr, gyroscopic: sp.Expr) -> System:
    """(9.8) for a kinetic energy T and a function S, solved for ξ̈, η̈.

    Parameters
    ----------
    kinetic_energy : sympy.Expr
        T in ξ, η, ξ̇, η̇, without a product ξ̇η̇.
    gyroscopic : sympy.Expr
        S, so that the right-hand sides are η̇S and −ξ̇S.

    Returns
    -------
    System
        State ξ, η, ξ̇, η̇; ω and n are definitions.
    """
    accelerations = []
    for q, v, force in ((xi, xidot, etadot * gyroscopic), (eta, etadot, -xidot * gyroscopic)):
        inertia = sp.diff(kinetic_energy, v, 2)
        momentum = sp.diff(kinetic_energy, v)
        drift = sp.diff(momentum, xi) * xidot + sp.diff(momentum, eta) * etadot
        accelerations.append((sp.diff(kinetic_energy, q) + force - drift) / inertia)
    field = {xi: xidot, eta: etadot, xidot: accelerations[0], etadot: accelerations[1]}
    return _system("rubber-ball-chaplygin-form", field, (xidot, etadot))


def momentum_form() -> System:
    """(9.8) in ξ, η and the momenta ∂T/∂ξ̇, ∂T/∂η̇, in the original time."""
    energy = kinetic()
    inertia = [sp.diff(energy, v, 2) for v in (xidot, etadot)]
    rates = {xidot: P_xi / inertia[0], etadot: P_eta / inertia[1]}
    force = GYROSCOPIC
    field = {
        xi: xidot.xreplace(rates),
        eta: etadot.xreplace(rates),
        P_xi: (sp.diff(energy, xi) + etadot * force).xreplace(rates),
        P_eta: (sp.diff(energy, eta) - xidot * force).xreplace(rates),
    }
    return _system("rubber-ball-momentum-form", field, (rates[xidot], rates[etadot]))


#: (n, J⁻¹n)^(1/(2k) − 1), the density in ξ, η, P_ξ, P_η.
MOMENTUM_MEASURE = Measure(
    "measure",
    {xi * eta / DET_J: 1 / (2 * k) - 1},
    "invariant measure in ξ, η and the momenta",
    source="§9.3, before (9.9)",
)

CANONICAL = PoissonStructure(
    "canonical",
    sp.Matrix([[0, 0, 1, 0], [0, 0, 0, 1], [-1, 0, 0, 0], [0, -1, 0, 0]]),
    rank=4,
    meaning="canonical bracket",
    source="(9.10)",
)


def canonical_form() -> System:
    """(9.10) with the Hamiltonian (9.14); the time is τ, dτ = N dt."""
    share = (2 * k - 1) / k
    field = {
        xi: 2 * A_xi * p_xi / (eta * Q),
        eta: -2 * A_eta * p_eta / (xi * Q),
        p_xi: H * (1 / (xi - eta) - share / xi)
        - (B_xi * p_xi**2 / eta + A_eta * p_eta**2 / xi**2) / Q,
        p_eta: (A_xi * p_xi**2 / eta**2 + B_eta * p_eta**2 / xi) / Q
        - H * (1 / (xi - eta) + share / eta),
    }
    definitions = {
        A_xi: cubic(xi),
        A_eta: cubic(eta),
        B_xi: sp.diff(cubic(xi), xi),
        B_eta: sp.diff(cubic(eta), eta),
        Q: (xi - eta) / (2 * k**2) * (xi * eta / DET_J) ** -share,
        H: ENERGY,
        N: MULTIPLIER,
        xidot: N * field[xi],
        etadot: N * field[eta],
    }
    return _system(NAME, field, (xidot, etadot), definitions).with_laws(
        Integral("energy", ENERGY, "energy", source="(9.14)", unit="J"),
        ConformallyHamiltonian(
            "hamiltonian", sp.S.One, CANONICAL, H, "canonical form", source="(9.10)"
        ),
    )


def to_canonical() -> Isomorphism:
    """From `momentum_form`: p = N P and dτ = N dt."""
    return Isomorphism(
        "canonical",
        canonical_form(),
        {xi: xi, eta: eta, p_xi: MULTIPLIER * P_xi, p_eta: MULTIPLIER * P_eta},
        time=MULTIPLIER,
        meaning="canonical form after the change of time",
        source="(9.10)",
    )


def to_ball(time: sp.Expr = sp.S.One) -> Isomorphism:
    """From coordinates to ω, n of (9.2); `time` is dt by the time of the coordinates."""
    return Isomorphism(
        "ball",
        ratio.rolling(),
        {omega: omega, n: n},
        time=time,
        meaning="from sphero-conical coordinates to the angular velocity and the normal",
        source="(9.6), (9.8)",
    )
