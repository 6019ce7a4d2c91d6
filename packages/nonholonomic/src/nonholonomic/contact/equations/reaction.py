"""The reaction of a support in a mode of the contact: normal force, force and couple.

The acceleration of the touching particle is u̇ = b + A R + (I⁻¹K)×r, and in contact its normal
component is −(γ̇, u).  While the contact slides this is one equation for N.  Where the slip or the
spin is held at zero, u̇ = 0 or Ω̇ = 0 determines the force or the couple that holds it.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.named_formulas import Pairs, scalars
from flowlanes.system.vectors import Symmetric, Vector, cross, dot, real_symbol

from ..friction.friction_law import Reaction
from ..friction.modes import Mode
from ..friction.symbols import (
    N,
    couple,
    gamma,
    holding_couple,
    normal_rate,
    normal_response,
    r,
    reaction,
)
from .free_body import FreeBody

#: Normal acceleration of the contact without a normal force.
normal_rate_free = real_symbol("normal_rate_free")
_spin_rate_free = real_symbol("spin_rate_free")
#: Residual normal acceleration for the normal force found by Newton's method.
normal_excess = real_symbol("normal_excess")
#: Number of Newton steps; each doubles the number of correct digits.
NEWTON_STEPS = 6

_inverse_mobility = Symmetric("Z")
#: Without slip the force is h − N h_q − τ h_s: h balances all other forces, h_q the couple per unit
#: of N, and h_s the spin couple τ per unit.
_h, _h_q, _h_s = Vector("h"), Vector("h_q"), Vector("h_s")
#: Coefficients of 1, N and τ in the two equations for N and τ.
_n, _w = (tuple(real_symbol(f"{name}_{i}") for i in range(3)) for name in "nw")


def reaction_definitions(free: FreeBody, mode: Mode, laws: Reaction) -> Pairs:
    """Normal force, force and couple of the support in a mode, as definitions.

    Parameters
    ----------
    free : FreeBody
    mode : Mode
        A mode in which the body touches; the rolling is held if `free` is that of held rolling.
    laws : Reaction
        Total reaction of all laws, without the forces that hold the contact.
    """
    return _while_sliding(free, mode, laws) if mode.sliding else _without_slip(free, mode, laws)


def _while_sliding(free: FreeBody, mode: Mode, laws: Reaction) -> Pairs:
    A, Y = free.mobility, free.inverse_inertia
    turned = cross(Y * gamma, r)
    sigma, tilt = dot(gamma, Y * gamma), dot(gamma, turned)
    # Normal acceleration of the contact without normal force, and its increase per unit of normal
    # force.
    base = free.slip_rate + A * laws.force + cross(Y * laws.couple, r)
    normal_0 = dot(gamma, base) + normal_rate
    normal_1 = dot(gamma, A * (gamma + laws.p) + cross(Y * laws.q, r))
    spin_0 = free.spin_rate + dot(turned, laws.force) + dot(gamma, Y * laws.couple)
    spin_1 = dot(turned, gamma + laws.p) + dot(gamma, Y * laws.q)
    torque = N * laws.q + laws.couple
    pairs: Pairs = ()
    if not mode.spinning:
        pairs += ((_spin_rate_free, spin_0),)
        normal_0 -= tilt * _spin_rate_free / sigma
        normal_1 -= tilt * spin_1 / sigma
        torque = torque + holding_couple * gamma
    pairs += ((normal_rate_free, normal_0), *_normal_force(normal_1, dot(gamma, A * gamma)))
    if not mode.spinning:
        pairs += ((holding_couple, -(_spin_rate_free + spin_1 * N) / sigma),)
    return (*pairs, (reaction, N * (gamma + laws.p) + laws.force), (couple, torque))


def _normal_force(response: sp.Expr, without_friction: sp.Expr) -> Pairs:
    """Solve normal_rate_free + N·response = 0 for N; by Newton's method if `response` depends on N.

    The iteration starts from the frictionless normal force and is unrolled into NEWTON_STEPS
    definitions, so that the result is one differentiable formula for the Taylor series.  It
    converges quadratically unless `normal_response`, the derivative of the residual by N, passes
    zero on the way; the guard on `normal_excess` then ends the mode.
    """
    (scalar,) = scalars(response)
    if not scalar.has(N):
        return ((normal_response, response), (N, -normal_rate_free / normal_response))
    excess = normal_rate_free + N * scalar
    slope = scalar + N * sp.diff(scalar, N)
    guesses = [real_symbol(f"normal_force_{i}") for i in range(NEWTON_STEPS)]
    pairs: Pairs = ((guesses[0], -normal_rate_free / without_friction),)
    for guess, following in zip(guesses, (*guesses[1:], N), strict=True):
        pairs += ((following, (N - excess / slope).xreplace({N: guess})),)
    return (*pairs, (normal_excess, excess), (normal_response, slope))


def _without_slip(free: FreeBody, mode: Mode, laws: Reaction) -> Pairs:
    Y, Z = free.inverse_inertia, _inverse_mobility
    turned = cross(Y * gamma, r)
    pairs: Pairs = (
        (Z, free.mobility**-1),
        (_h, -1 * (Z * (free.slip_rate + cross(Y * laws.couple, r)))),
        (_h_q, Z * cross(Y * laws.q, r)),
    )
    if mode.spinning:
        return (
            *pairs,
            (N, dot(gamma, _h) / (1 + dot(gamma, _h_q))),
            (reaction, _h - N * _h_q),
            (couple, N * laws.q + laws.couple),
        )
    n, w = _n, _w
    return (
        *pairs,
        (_h_s, Z * turned),
        # n₀ = n₁ N + n₂ τ and w₀ + w₁ N + w₂ τ = 0
        (n[0], dot(gamma, _h)),
        (n[1], 1 + dot(gamma, _h_q)),
        (n[2], dot(gamma, _h_s)),
        (w[0], free.spin_rate + dot(gamma, Y * laws.couple) + dot(turned, _h)),
        (w[1], dot(gamma, Y * laws.q) - dot(turned, _h_q)),
        (w[2], dot(gamma, Y * gamma) - dot(turned, _h_s)),
        (N, (n[0] * w[2] + n[2] * w[0]) / (n[1] * w[2] - n[2] * w[1])),
        (holding_couple, -(w[0] + w[1] * N) / w[2]),
        (reaction, _h - N * _h_q - holding_couple * _h_s),
        (couple, N * laws.q + laws.couple + holding_couple * gamma),
    )
