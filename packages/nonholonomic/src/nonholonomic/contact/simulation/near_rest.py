"""Dry friction at a contact whose slip is zero, or about to be."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from flowlanes.system.arrays import FloatArray

from ..equations.situation import FrictionalContact
from ..pressure.pressure import Hertz
from ..pressure.pressure_limits import load_factor, slip_ratio
from ..slip.frozen_slip import (
    CoupledSlip,
    FrozenSlip,
    PointSlip,
    point_slip,
    point_slip_with_spin_at_rest,
)
from ..slip.limit_directions import Rest, rest_of_patch, rest_of_point
from ..slip.stopping import Stop
from .compiled import OMEGA, VELOCITY, ContactNumbers

_HERTZ = Hertz()

#: Relative distance from its limit at which friction counts as saturated, and distance below which
#: two directions count as equal.
_AT_LIMIT = 1e-6

#: Factor applied to a friction limit that has just been exceeded.
_BELOW = 1 - _AT_LIMIT


def _force_factor(k: float) -> float:
    return float(_HERTZ.force(k))


def _couple_factor(k: float) -> float:
    return float(_HERTZ.couple(k))


@dataclass(frozen=True)
class DryFriction:
    """The friction thresholds of a situation.

    Attributes
    ----------
    mu : float
        Coefficient of sliding friction as the slip tends to zero; 0 without dry friction, inf for a
        contact that never slips.
    patch : float
        Radius of the patch of a coupled law (m); 0 at a point.
    spin_arm : float
        Arm of an independent couple against spin (m); 0 without one.
    law : str
        Name of the law of sliding.
    static_mu : float
        Coefficient of static friction, at least `mu`.
    viscous, order : float
        ν and p of the friction ν|u|ᵖ per normal force, for impacts.
    force : sympy.Expr or None
        A formula in the slip speed in place of `mu`, for impacts.
    unknown_in_impacts : str
        Reason why friction in impacts is not known; empty if it is known.
    """

    mu: float
    patch: float
    spin_arm: float
    law: str
    static_mu: float
    viscous: float = 0.0
    order: float = 1.0
    force: sp.Expr | None = None
    unknown_in_impacts: str = ""

    def near_stop(self, speed: float) -> DryFriction:
        """The thresholds with the average friction that acts on a small slip until it ends."""
        if not self.viscous or self.patch:
            return self
        return replace(self, mu=self.mu + self.viscous * speed**self.order / (1 + self.order))

    @property
    def never_slips(self) -> bool:
        """Whether friction is unlimited."""
        return math.isinf(self.mu)


def dry_friction(situation: FrictionalContact) -> DryFriction:
    """The friction thresholds of a situation."""
    arm = max((law.spin_arm for law in situation.laws), default=0.0)
    viscous, order = next((law.power for law in situation.laws if law.power[0]), (0.0, 1.0))
    force = next((f for law in situation.laws if (f := law.force_of_slip) is not None), None)
    unknown = "; ".join(filter(None, (law.unknown_in_impacts for law in situation.laws)))
    for law in situation.laws:
        if law.static_mu is not None and law.kinetic_mu is not None:
            mu, patch, static = law.kinetic_mu, law.patch_radius, law.static_mu
            return DryFriction(mu, patch, arm, law.name, static, viscous, order, force, unknown)
    return DryFriction(0.0, 0.0, arm, "", 0.0, viscous, order, force, unknown)


def frozen_slip(numbers: ContactNumbers, dry: DryFriction, spin_sign: float) -> FrozenSlip:
    """The rates of the slip while the rest of the state is held constant.

    Parameters
    ----------
    numbers : ContactNumbers
    dry : DryFriction
    spin_sign : float
        Of the spin; 0 where a couple holds it.
    """
    mobility = numbers.mobility
    acceleration = numbers.slip_rate + numbers.normal_rate * mobility.gamma
    if dry.patch:
        return CoupledSlip(
            mobility,
            dry.mu,
            dry.patch,
            _force_factor,
            _couple_factor,
            acceleration,
            numbers.spin_rate,
            numbers.q,
        )
    if dry.spin_arm and not spin_sign:
        return point_slip_with_spin_at_rest(
            mobility, acceleration, numbers.spin_rate, dry.mu, numbers.q
        )
    return point_slip(mobility, acceleration, dry.mu, -dry.spin_arm * spin_sign, numbers.q)


@dataclass(frozen=True, eq=False)
class Departure:
    """The motion that begins at a contact without slip.

    Attributes
    ----------
    holds : bool
        Whether friction holds the slip at zero; otherwise it grows.
    spin_sign : float
        Sign of the spin, 0 where a couple holds it.
    direction : array (3,) or (4,)
        Direction of the growing slip (of slip and aΩ under a coupled law), body axes; empty if it
        is held.
    normal_force : float
    force : array (3,)
        Friction (N), body axes.
    couple : float
        Couple about the normal (N m).
    unique : bool
        Whether this is the only possible motion.
    """

    holds: bool
    spin_sign: float
    direction: FloatArray
    normal_force: float
    force: FloatArray
    couple: float
    unique: bool


def departure(numbers: ContactNumbers, dry: DryFriction, spin_sign: float) -> Departure | None:
    """The motion of a contact without slip; None if it can neither stick nor begin to slide.

    Parameters
    ----------
    numbers : ContactNumbers
    dry : DryFriction
    spin_sign : float
        Of the spin; 0 where it is zero and a couple may hold it.
    """
    if dry.patch:
        slip = frozen_slip(numbers, dry, 0.0)
        assert isinstance(slip, CoupledSlip)
        options = _departures_of_rest(
            numbers, dry, rest_of_patch(slip, _is_inside_hertz_limit), slip, 0.0
        )
    else:
        signs = (spin_sign,) if spin_sign or not dry.spin_arm else (0.0, 1.0, -1.0)
        options = (
            option
            for sign in signs
            for option in _departures_at_point(numbers, dry, sign, changes=sign != spin_sign)
        )
    possible = sorted(options, key=lambda option: not option.holds)
    return possible[0] if possible else None


def _departures_at_point(
    numbers: ContactNumbers, dry: DryFriction, sign: float, changes: bool
) -> Iterator[Departure]:
    """The possible motions at a point contact for a given sign of the spin (0 if it is zero)."""
    slip = frozen_slip(numbers, dry, sign)
    assert isinstance(slip, PointSlip)
    for option in _departures_of_rest(numbers, dry, rest_of_point(slip, dry.static_mu), slip, sign):
        if dry.spin_arm and not sign:
            # The couple must be able to hold the spin.
            fits = abs(option.couple) <= dry.spin_arm * option.normal_force
        elif changes:
            # The spin that begins must grow.
            constant, slope = slip.response.spin
            friction = numbers.mobility.tangents @ option.force
            rate = numbers.spin_rate + option.normal_force * constant + float(slope @ friction)
            fits = sign * rate > 0
        else:
            fits = True
        if fits:
            yield option


def _departures_of_rest(
    numbers: ContactNumbers, dry: DryFriction, rest: Rest, slip: FrozenSlip, sign: float
) -> Iterator[Departure]:
    """The state of rest, if friction can hold it, and the slides that grow from it."""
    tangents, unique = numbers.mobility.tangents, rest.unique
    if rest.holds:
        force = rest.sticking_force @ tangents
        yield Departure(
            True, sign, np.empty(0), rest.normal_force, force, rest.holding_couple, unique
        )
    for item in rest.exits:
        n = item.direction
        pressure, friction, couple = slip.force(n)
        direction = np.append(n[:2] @ tangents, n[2:])
        turning = float(np.sign(n[2])) if dry.patch else sign
        yield Departure(False, turning, direction, pressure, friction @ tangents, couple, unique)


def _is_inside_hertz_limit(x: float, z: float) -> bool:
    """Whether |f|/μN and |τ|/μNa lie within the limit set of Hertz's pressure."""
    return bool(load_factor(_HERTZ, x, z) <= 1)


def first_direction(dry: DryFriction, N: float, force: FloatArray, couple: float) -> FloatArray:
    """Direction (3,), or (4,) with aΩ, in which a contact at its friction limit begins to slide.

    Parameters
    ----------
    dry : DryFriction
    N : float
        Normal force.
    force : array (3,)
        Of friction, body axes.
    couple : float
        Of friction about the normal.
    """
    size = float(np.linalg.norm(force))
    if not dry.patch:
        return -force / size
    k = float(slip_ratio(_HERTZ, size / (dry.mu * N), abs(couple) / (dry.mu * N * dry.patch)))
    angle = math.atan(k)
    along = -math.sin(angle) * force / size if size else np.zeros(3)
    return np.append(along, -math.copysign(math.cos(angle), couple))


def sudden_direction(
    numbers: ContactNumbers, dry: DryFriction, spin_sign: float, direction: FloatArray
) -> FloatArray | None:
    """Direction (3,) in which a point contact at its friction limit slides; None if it cannot.

    If static friction exceeds kinetic friction, it drops to the kinetic value and the slip grows
    at once.  Otherwise the slip starts smoothly, opposite to the force, provided that nearby slip
    directions turn towards this one.  If they turn away, which requires a normal force that
    depends on friction, the slip grows at once in another direction, as was already possible while
    friction held the contact.  A slip opposite to the force may also decay as soon as friction no
    longer holds it; if no slip grows, there is no direction.

    Parameters
    ----------
    numbers : ContactNumbers
    dry : DryFriction
    spin_sign : float
        Of the spin; 0 where a couple holds it.
    direction : array (3,)
        Direction opposite to the friction at its limit, body axes.
    """
    falls = dry.static_mu > dry.mu
    # sticking at the limit is excluded in spite of rounding errors
    limited = replace(dry, static_mu=dry.mu)
    if not falls:
        limited = replace(dry, static_mu=_BELOW * dry.mu, mu=_BELOW * dry.mu)
    choice = departure(numbers, limited, spin_sign)
    if choice is None:
        return None
    if choice.holds:
        return None if falls else direction
    gently = not falls and float(choice.direction @ direction) > _BELOW
    return direction if gently else choice.direction


def state_after_stop(
    numbers: ContactNumbers, dry: DryFriction, state: FloatArray, stop: Stop
) -> FloatArray:
    """The state (size,) when sliding has stopped, before corrections for work and rounding.

    Parameters
    ----------
    numbers : ContactNumbers
        At `state`.
    dry : DryFriction
    state : array (size,)
    stop : Stop
    """
    mobility, lasting = numbers.mobility, stop.duration
    impulse = stop.normal_impulse * mobility.gamma + stop.friction_impulse @ mobility.tangents
    after = state + numbers.rates_of_place * lasting
    after[VELOCITY] += numbers.free_acceleration * lasting + mobility.velocity_jump(impulse)
    resistance = mobility.inverse_inertia @ numbers.q * stop.normal_impulse
    turn = mobility.angular_velocity_jump(impulse, stop.couple_impulse) + resistance
    after[OMEGA] += numbers.free_turn * lasting + turn
    return after
