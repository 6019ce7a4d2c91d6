"""The reaction of a support in a mode of the contact: normal force, force and couple.

The acceleration of the touching particle is u̇ = b + A R + (I⁻¹K)×r, and in contact its part along the
normal is −(γ̇, u).  While the contact slides this is one equation for N; where slip or spin is held,
u̇ = 0 or Ω̇ = 0 determine what holds it.
"""

from __future__ import annotations

import sympy as sp

from ..core.named_formulas import Pairs
from ..core.vectors import Symmetric, Vector, cross, dot, real_symbol
from .free_body import FreeBody
from .friction import Reaction
from .modes import Mode
from .symbols import (
    N,
    couple,
    gamma,
    holding_couple,
    normal_rate,
    normal_response,
    r,
    reaction,
    slip_rate,
    spin_rate,
)


def reaction_definitions(free: FreeBody, mode: Mode, laws: Reaction) -> Pairs:
    """Normal force, force and couple of the support, as definitions."""
    A, Y = free.mobility, free.inverse_inertia
    turned = cross(Y * gamma, r)
    sigma = dot(gamma, Y * gamma)
    p, q, force, torque = laws.p, laws.q, laws.force, laws.couple
    # accelerations of the contact without normal and holding reaction
    base = slip_rate + A * force + cross(Y * torque, r)
    spin_base = spin_rate + dot(turned, force) + dot(gamma, Y * torque)
    spin_normal = dot(gamma, Y * q)
    if mode.sliding:
        n_0, n_1 = real_symbol("normal_rate_free"), normal_response
        along = A * (gamma + p) + cross(Y * q, r)
        pairs: Pairs = (
            (n_0, dot(gamma, base) + normal_rate),
            (n_1, dot(gamma, along)),
        )
        tau: sp.Expr = sp.S.Zero
        if mode.spinning:
            pairs += ((N, -n_0 / n_1),)
        else:
            s_0, s_1 = real_symbol("s_0"), real_symbol("s_1")
            tilt = dot(gamma, turned)
            pairs += (
                (s_0, spin_base),
                (s_1, dot(turned, gamma + p) + spin_normal),
                (N, -(n_0 - tilt * s_0 / sigma) / (n_1 - tilt * s_1 / sigma)),
                (holding_couple, -(s_0 + s_1 * N) / sigma),
            )
            tau = holding_couple
        whole = N * (gamma + p) + force
        return (*pairs, (reaction, whole), (couple, N * q + torque + tau * gamma))
    inverse = Symmetric("Z")
    h_0, h_1, h_2 = Vector("h"), Vector("h_q"), Vector("h_s")
    pairs = (
        (inverse, A**-1),
        (h_0, -1 * (inverse * (slip_rate + cross(Y * torque, r)))),
        (h_1, inverse * cross(Y * q, r)),
    )
    if mode.spinning:
        pairs += (
            (N, dot(gamma, h_0) / (1 + dot(gamma, h_1))),
            (reaction, h_0 - N * h_1),
            (couple, N * q + torque),
        )
        return pairs
    row = [real_symbol(name) for name in ("w_0", "w_1", "w_2")]
    column = [real_symbol(name) for name in ("n_0", "n_1", "n_2")]
    pairs += (
        (h_2, inverse * turned),
        (column[0], dot(gamma, h_0)),
        (column[1], 1 + dot(gamma, h_1)),
        (column[2], dot(gamma, h_2)),
        (row[0], spin_rate + dot(gamma, Y * torque) + dot(turned, h_0)),
        (row[1], spin_normal - dot(turned, h_1)),
        (row[2], sigma - dot(turned, h_2)),
        (
            N,
            (column[0] * row[2] + column[2] * row[0]) / (column[1] * row[2] - column[2] * row[1]),
        ),
        (holding_couple, -(row[0] + row[1] * N) / row[2]),
        (reaction, h_0 - N * h_1 - holding_couple * h_2),
        (couple, N * q + torque + holding_couple * gamma),
    )
    return pairs
