"""The Chaplygin ball at zero area constant, (M, γ) = 0, separated.

The roots z₁, z₂ of Σ Iᵢγᵢ²/(Iᵢ − z) = 0 give γᵢ² = det I (Iᵢ − z₁)(Iᵢ − z₂)/(Iᵢ z₁z₂ Πᵢ) with
Πᵢ = ∏_{j≠i}(Iᵢ − Iⱼ).  With dt = (det I_Q)^(1/2) dτ they move by

    zₖ′² (z₁ − z₂)² = 4 zₖ (zₖ + D) (2h(zₖ + D) − f) p(zₖ),        p(z) = ∏(Iᵢ − z),

where D = mR², h is the energy and f = M².  The momentum M stays in space, and so does γ.  f > 2hD
on every motion, so that the last root f/(2h) − D is positive; h = 0 is rest.

The equations are proven in Fedorov's variables (:mod:`.fedorov`), with the time (det J)^(1/2) τ;
the laws here include the isomorphism and that it maps the curve to the curve.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Law
from flowlanes.system.system import System
from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_ball_clebsch import DET_I, K, beta
from ...catalogue.chaplygin_ball.chaplygin_bracket import DET_IQ, DET_J, A, D, I
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import separation_laws
from .fedorov import E, fedorov, q_1, r

M, gamma, omega = vectors("M gamma omega")
h, f = real_symbol("h"), real_symbol("f")

#: dt/dτ = (det I_Q)^(1/2), for a unit vector γ.
CLOCK = sp.sqrt(DET_J * (1 - D * dot(nu, A * nu)))
#: ω without its component along γ, from γ̇ = γ×ω.
TURN = cross(nuprime, nu) / CLOCK
#: (ω, γ), for which (M, γ) = (Iω, γ) vanishes.
SPIN = -dot(I * TURN, nu) / dot(nu, I * nu)


def chaplygin_ball() -> SeparatedSystem:
    """The Chaplygin ball at zero area constant, with any three different principal moments."""
    spinning: sp.MatrixExpr = TURN + SPIN * nu
    separable = SeparatedSystem(
        name="chaplygin-ball",
        title="Chaplygin ball at zero area constant",
        system=from_catalogue("chaplygin-ball"),
        level=(dot(M, gamma),),
        constants=((h, dot(M, omega) / 2), (f, norm_squared(M))),
        direction=gamma,
        turning=sp.sqrt(DET_IQ) * cross(gamma, omega),
        poles=I.symbols,
        weights=tuple(1 / (e * gap) for e, gap in zip(I.symbols, gaps(I.symbols), strict=True)),
        leading=-8 * h,
        roots=(*I.symbols, sp.S.Zero, -D, f / (2 * h) - D),
        speeds=(sp.S.Zero, sp.S.One),
        time_rescaling=CLOCK,
        state=((M, I * spinning + D * TURN), (gamma, nu)),
        fixed=(M, gamma),
        source="§7, (7.1)–(7.4)",
    )
    own = tuple(law for law in separation_laws(separable) if law.name != "separation")
    return replace(separable, laws=(*own, *_separation(separable.system)))


def _separation(system: System) -> tuple[Law, ...]:
    """The isomorphism to Fedorov's variables, and the curve in them.

    With y² det J for the curve there, E det J = h det I, and the quadratic in z divided by det I is
    (z + D)(2h(z + D) − f)/det J.
    """
    there = fedorov()
    (separation,) = (law for law in there.laws if law.name == "separation")
    (onto,) = (law for law in system.laws_of(Isomorphism) if law.name == "fedorov")
    constants = [pair for pair in there.constants if pair[0] != r]
    momentum = [pair for pair in onto.map if pair[0] == K]
    return (
        replace(onto, target=onto.target.with_laws(separation)),
        Identity(
            "curve",
            (
                E * DET_J - h * DET_I,
                q_1 * DET_J - (4 * h * D - f) * DET_I,
                beta * DET_J - D * (f - 2 * h * D),
            ),
            "the curve in Fedorov's variables",
            (*momentum, *onto.constants, (h, dot(M, omega) / 2), (f, norm_squared(M)), *constants),
            level=onto.level,
            source=onto.source,
        ),
    )
