"""A body kept from rolling by its resistance: it may still slide and spin about the normal.

With ω = Ωγ + Ω_s ζ, where Ω_s is the angular velocity of the support about the vertical ζ, the rate
of ω is D + Ω̇γ with D = Ωγ̇ + Ω_s ζ×ω.  The couple that holds the rolling is tangential, so only
the normal component of the angular momentum balance remains, as if I⁻¹ were γγᵀ/(γ, Iγ).
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from flowlanes.system.named_formulas import Pairs, scalars
from flowlanes.system.vector_operators import hat, unit_vector
from flowlanes.system.vectors import Symmetric, Vector, constant, cross, dot, real_symbol

from ..friction.symbols import (
    contour_hold,
    couple,
    free_turn,
    gamma,
    gammadot,
    omega,
    r,
    reaction,
    slip_rate,
    spin,
    spin_rate,
)
from .free_body import FreeBody, m

_turn, _slip_rate, _given = (Vector(f"held_{name}") for name in ("turn", "slip_rate", "rate"))
_inverse, _mobility = Symmetric("Y_n"), Symmetric("A_n")
_spin_rate, _moment = real_symbol("held_spin_rate"), real_symbol("I_n")
_across = Symmetric("V")


def with_held_rolling(free: FreeBody) -> tuple[Pairs, FreeBody]:
    """The definitions of the motion without rolling, and the body with its contact response.

    Parameters
    ----------
    free : FreeBody
    """
    change = _turn - free_turn
    normal = gamma.entries
    inverse = normal * normal.T / _moment
    definitions: Pairs = (
        (_moment, dot(gamma, free.inertia * gamma)),
        (_given, spin * gammadot + free.turning * cross(free.vertical, omega)),
        (_turn, _given + dot(gamma, free.inertia * (free_turn - _given)) / _moment * gamma),
        (_slip_rate, slip_rate + cross(change, r)),
        (_spin_rate, spin_rate + dot(gamma, change)),
        (_inverse, constant(inverse)),
        (_mobility, constant(sp.eye(3) / m - hat(r) * inverse * hat(r))),
    )
    return definitions, replace(
        free,
        inverse_inertia=_inverse,
        mobility=_mobility,
        turn=_turn,
        slip_rate=_slip_rate,
        spin_rate=_spin_rate,
    )


def holding_couple_of_rolling(free: FreeBody, held_body: FreeBody, along_normal: Pairs) -> Pairs:
    """The definitions of the reaction including the tangential couple that holds the rolling.

    Parameters
    ----------
    free, held_body : FreeBody
        Of a body that may roll, and as `with_held_rolling` returns it.
    along_normal : pairs
        The definitions of the reaction; the last one, of the couple, counts along the normal.
    """
    *others, (_, torque) = along_normal
    turn = held_body.turn + held_body.inverse_inertia * (cross(r, reaction) + torque)
    whole = free.inertia * (turn - free_turn) - cross(r, reaction)
    return (*others, (couple, whole))


def contour_hold_definitions(free: FreeBody) -> Pairs:
    """The tangential vector e for which γ×(W e) is the couple that holds the rolling."""
    column = gamma.entries
    columns = (constant(scalars(free.kinematics.spread(unit_vector(axis)))) for axis in (1, 2, 3))
    spread = sp.Matrix.hstack(*columns)
    # W vanishes along the normal.
    along = constant((spread + spread.T) / 2 + column * column.T)
    return ((_across, along**-1), (contour_hold, -1 * (_across * cross(gamma, couple))))
