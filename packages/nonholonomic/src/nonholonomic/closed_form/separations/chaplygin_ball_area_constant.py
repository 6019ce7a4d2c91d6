"""The Chaplygin ball at any area constant, by Chaplygin's reduction (1903) to (M, γ) = 0.

M and γ both stay in space.  With D = mR², A = (I + D)⁻¹ and ω = Aw the vector w = λM + μγ, λ = 1,
obeys (Aw, M) = 2hλ and (Aw, γ) = μ/D: the energy, and what μ = D(ω, γ) means.  Both keep their form
in any other basis of the plane of M and γ in which diag(2h, 1/D) is still diagonal, and one such
basis is orthogonal:

    γ′ = (γ + βM)/n,    M′ = M − 2hDβγ,    (M′, γ′) = 0,    |γ′| = 1,

With w = λ′M′ + μ′γ′ the ball moves, in the time dt′ = λ′ dt, as one at zero area constant with D′
for D, I′ = I + D − D′ for I (so that A is the same) and ω′ = ω/λ′.  With h the energy, f = M² and
g = (M, γ),

    σ = (s + (s² + 8hDg²)^(1/2))/2,  s = f − 2hD,      β = −g/σ,      δ = Dg²/σ,
    D′ = D − δ,    e = 1 + 2hDβ²,    n² = (1 − g²/σ)e,    h′ = eh,    M′² = 2eh(D + σ/(2h)).

D′ = D − δ lies between 0 and D, and I′ = I + δ.  In the variable z = w′ − δ, with w′ that of
:mod:`.chaplygin_ball`, the poles are those of the ball itself and the curve is

    y² = 4 (z + δ)(z + D)(2hz − σ) e p(z),        p(z) = ∏(Iᵢ − z).

For g = 0 this is :mod:`.chaplygin_ball`.  The claims made here are proven in parts in
``tests/closed_form/separations``, where the reduction is read backwards.  λ′ never vanishes, since
w = γ′ would give (Aγ′, γ′) = 1/D′, but D′A < 1; so it is positive as it is at g = 0, and

    dt/dt′ = 1/λ′ = 1 + (β/n) D′(ω′, γ′).

The second term is odd under ν′ → −ν′, which on the torus is v → −v up to a half period; its mean is
zero, and the mean of dt/dτ is that of `EVEN`.

It fails where M is parallel to γ, g² = f: there σ = f, D′ = 0, n = 0, and any unit vector across M
may be taken for γ′.  The ball then turns as a free body with the tensor I + D and the momentum
M′ = (1 + 2hD/f)M: elliptic functions.  h = 0 is rest.  The directions given as fixed in space are M
and γ′, which stay apart when M and γ nearly coincide.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.vectors import (
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    vectors,
)

from ...catalogue import from_catalogue
from ...catalogue.chaplygin_ball.chaplygin_bracket import DET_J, A, D, I
from ..genus_two.separation import SeparatedSystem, gaps, nu, nuprime
from ..genus_two.separation_laws import separation_laws

M, gamma, omega = vectors("M gamma omega")
h, f, g, sigma, delta, e, n = (real_symbol(s) for s in ("h", "f", "g", "sigma", "delta", "e", "n"))

SLOPE = f - 2 * h * D
BETA = -g / sigma
#: D′, a separate constant since D − δ loses digits near M ∥ γ, and the inertia tensor I′, of the
#: ball at zero area constant.
D_ZERO = real_symbol("D_0")
I_ZERO = constant(sp.diag(*(moment + delta for moment in I.symbols)))
#: γ′ in terms of the state.
NORMAL = (gamma + BETA * M) / n


def det_iq(normal: sp.MatrixExpr) -> sp.Expr:
    """det I′_Q for a unit vector γ′."""
    return DET_J * (1 - D_ZERO * dot(normal, A * normal))


#: dt′/dτ, the part of the clock that is even in ν′; its mean over the torus is that of the clock.
EVEN = sp.sqrt(det_iq(nu))
#: ω′ without its component along γ′, and (ω′, γ′), for which (M′, γ′) vanishes.
TURN = cross(nuprime, nu) / EVEN
SPIN = -dot(I_ZERO * TURN, nu) / dot(nu, I_ZERO * nu)
#: M′ in ν, ν′.
MOMENTUM = I_ZERO * (TURN + SPIN * nu) + D_ZERO * TURN


def original_vectors(
    momentum: sp.MatrixExpr, normal: sp.MatrixExpr
) -> tuple[tuple[Vector, sp.MatrixExpr], ...]:
    """M and γ, with their formulas in M′ and γ′."""
    return (
        (M, (momentum + 2 * h * D * BETA * n * normal) / e),
        (gamma, (n * normal - BETA * momentum) / e),
    )


def chaplygin_area() -> SeparatedSystem:
    """The Chaplygin ball with any three different principal moments, M not parallel to γ."""
    moments = I.symbols
    scale = sp.sqrt(det_iq(NORMAL)) * e / (1 - BETA * D * dot(omega, gamma))
    separable = SeparatedSystem(
        name="chaplygin-ball-area",
        title="Chaplygin ball",
        system=from_catalogue("chaplygin-ball"),
        constants=(
            (h, dot(M, omega) / 2),
            (f, norm_squared(M)),
            (g, dot(M, gamma)),
            (sigma, (SLOPE + sp.sqrt(SLOPE**2 + 8 * h * D * g**2)) / 2),
            (delta, D * g**2 / sigma),
            (D_ZERO, D - delta),
            (e, 1 + 2 * h * D * BETA**2),
            (n, sp.sqrt((1 - g**2 / sigma) * e)),
        ),
        direction=NORMAL,
        turning=scale * cross(NORMAL, omega),
        poles=moments,
        weights=tuple(
            1 / ((pole + delta) * gap) for pole, gap in zip(moments, gaps(moments), strict=True)
        ),
        leading=-8 * h * e,
        roots=(*moments, -delta, -D, sigma / (2 * h)),
        speeds=(sp.S.Zero, sp.S.One),
        time_rescaling=EVEN * (1 + BETA / n * D_ZERO * SPIN),
        state=original_vectors(MOMENTUM, nu),
        fixed=(M, nu),
        source="§7, Chaplygin (1903)",
    )
    own = ("constants", "fixed_1")
    return replace(
        separable, laws=tuple(law for law in separation_laws(separable) if law.name in own)
    )
