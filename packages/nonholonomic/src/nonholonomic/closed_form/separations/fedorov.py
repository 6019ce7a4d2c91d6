"""The Chaplygin ball in Fedorov's variables, in which its separation is proven.

The ball at zero area constant moves as K′ = K×v − βγ×Iγ, γ′ = γ×v, K = Iv, on (K, γ) = 0 (§7.5,
proven in the catalogue); these equations contain no square root and no mass.  The roots z₁, z₂ of Σ
Iᵢγᵢ²/(Iᵢ − z) = 0 move by

    zₖ′² (z₁ − z₂)² = 4 zₖ p(zₖ) (2Ezₖ² + (β(I₂I₃ + I₃I₁ + I₁I₂) − G)zₖ − β det I)/det I,

with 2E = (K, v) − β(γ, Iγ) and G = K² + β det I (γ, I⁻¹γ).  On the motions of a ball β > 0 and
E > 0, so that the quadratic has one negative and one positive root.
"""

from __future__ import annotations

from itertools import combinations

import sympy as sp

from flowlanes.system.vectors import cross, dot, norm_squared, real_symbol, vectors

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_ball_clebsch import DET_I, I, K, beta
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import with_laws

(gamma,) = vectors("gamma")
E, G, q_1, r = (real_symbol(name) for name in ("E", "G", "q_1", "r"))

INVERSE = I**-1
TURN = cross(nuprime, nu)
SECOND_INVARIANT = sp.Add(*(first * second for first, second in combinations(I.symbols, 2)))


def fedorov() -> SeparatedSystem:
    """Fedorov's system on (K, γ) = 0, where E > 0 and β > 0."""
    spin = -dot(I * TURN, nu) / dot(nu, I * nu)
    return with_laws(
        SeparatedSystem(
            name="chaplygin-ball-fedorov",
            title="Chaplygin ball in Fedorov's variables",
            system=from_catalogue("chaplygin-ball-fedorov"),
            level=(dot(K, gamma),),
            constants=(
                (E, (dot(K, INVERSE * K) - beta * dot(gamma, I * gamma)) / 2),
                (G, norm_squared(K) + beta * DET_I * dot(gamma, INVERSE * gamma)),
                (q_1, beta * SECOND_INVARIANT - G),
                (r, sp.sqrt(q_1**2 + 8 * E * beta * DET_I)),
            ),
            direction=gamma,
            turning=cross(gamma, INVERSE * K),
            poles=I.symbols,
            weights=tuple(1 / (e * gap) for e, gap in zip(I.symbols, gaps(I.symbols), strict=True)),
            leading=-8 * E / DET_I,
            roots=(*I.symbols, sp.S.Zero, -(q_1 + r) / (4 * E), (r - q_1) / (4 * E)),
            speeds=(sp.S.Zero, sp.S.One),
            time_rescaling=sp.S.One,
            state=((K, I * (TURN + spin * nu)), (gamma, nu)),
            source="§7.5, 2",
        )
    )
