"""A body near its support without the reaction: kinematics and free accelerations."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.named_formulas import Pairs, by_dependence, by_name
from flowlanes.system.system import Parameter
from flowlanes.system.vector_operators import gradient, hat
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
    zero,
)

from ...mechanics.rolling.attitude import rotation
from ...mechanics.rolling.body import Body, body_parameters
from ...mechanics.rolling.contact import contact
from ...mechanics.shapes.kinematics import Contact
from ...mechanics.shapes.shape_base import Shape
from ...mechanics.shapes.surfaces import Surface
from ..friction.symbols import (
    contact_velocity,
    contour_couple,
    free_acceleration,
    free_turn,
    gamma,
    gammadot,
    gap,
    normal_rate,
    omega,
    position,
    r,
    rdot,
    reach,
    rolling,
    rolling_speed,
    slip,
    slip_rate,
    slip_speed,
    spin,
    spin_rate,
    v,
    wandering,
)
from .situation import FrictionalContact

m, g, a, U, turning = (real_symbol(name) for name in ("m", "g", "a", "U", "Omega_s"))
k, zeta = Vector("k"), Vector("zeta")


@dataclass(frozen=True)
class FreeBody:
    """Formulas of a body in or near contact that do not involve the reaction.

    Attributes
    ----------
    kinematics : Contact
    definitions : pairs
        In order: kinematics of the contact, slip, spin, and the accelerations `free_acceleration`,
        `free_turn` and `slip_rate` without the reaction.
    parameters : tuple of Parameter
    inertia, inverse_inertia, mobility : MatrixExpr
        I, I⁻¹, and A = E/m − r̂ I⁻¹ r̂.
    turn, slip_rate : MatrixExpr
        ω̇ and the acceleration of the touching particle over the support, without the reaction.
    spin_rate : sympy.Expr
        Rate of the spin, without the reaction.
    vertical, support_velocity : MatrixExpr
        Vertical of space, and velocity of the support at the contact, body axes.
    turning : sympy.Expr
        Angular velocity of the support about the vertical; zero at rest.
    kinetic, potential : sympy.Expr
        Energies (J).
    """

    kinematics: Contact
    definitions: Pairs
    parameters: tuple[Parameter, ...]
    inertia: MatrixExpr
    inverse_inertia: MatrixExpr
    mobility: MatrixExpr
    turn: MatrixExpr
    slip_rate: MatrixExpr
    spin_rate: sp.Expr
    vertical: MatrixExpr
    support_velocity: MatrixExpr
    turning: sp.Expr
    kinetic: sp.Expr
    potential: sp.Expr


def free_body(situation: FrictionalContact, touching: bool) -> FreeBody:
    """The formulas of a body that touches its support, or flies above it."""
    body, surface = situation.body, situation.surface
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    rotors = k if any(body.gyrostat) else zero
    inverse, mobility = type(inertia)("Y"), Symmetric("A")
    vertical = surface.vertical
    kinematics = _contact_kinematics(situation, touching)
    moving_support = _support(surface, vertical)
    field = _applied_forces(situation, vertical, kinematics)

    later = (*omega.symbols, *contact_velocity.symbols, gap)
    position_alone, moving = by_dependence(kinematics.definitions, later)
    names = {name for name, _ in (*kinematics.definitions, *kinematics.state)}
    # These definitions are not needed for every contact.
    if r not in names:
        position_alone += ((r, kinematics.r),)
    if vertical == zeta:
        position_alone += ((zeta, constant(list(rotation().row(2)))),)
    if gammadot not in names:
        moving += ((gammadot, kinematics.gammadot),)
    if rdot not in names:
        moving += ((rdot, kinematics.rdot),)
    seen = constant(rotation().T * position.entries)
    clearance: Pairs = ((gap, dot(reach, gamma) - surface.level),)
    across = omega - moving_support.turn * vertical
    definitions: Pairs = (
        *position_alone,
        (inverse, inertia**-1),
        (mobility, constant(sp.eye(3) / m - hat(r) * inverse.entries * hat(r))),
        (reach, seen + r),
        *(() if touching else clearance),
        (contact_velocity, v + cross(omega, r)),
        *moving,
        (slip, contact_velocity - moving_support.velocity),
        (slip_speed, sp.sqrt(norm_squared(slip))),
        (spin, dot(gamma, across)),
        (rolling, across - spin * gamma),
        (rolling_speed, sp.sqrt(norm_squared(rolling))),
        (wandering, -kinematics.spread(cross(gamma, rolling))),
        (
            contour_couple,
            cross(gamma, kinematics.spread(wandering)) / sp.sqrt(norm_squared(wandering)),
        ),
        *field.definitions,
        (free_acceleration, field.force / m - cross(omega, v)),
        (free_turn, inverse * (field.torque + cross(inertia * omega + rotors, omega))),
        (
            slip_rate,
            free_acceleration
            + cross(free_turn, r)
            + cross(omega, rdot)
            - moving_support.acceleration,
        ),
        (normal_rate, dot(gammadot, slip)),
        (
            spin_rate,
            dot(gamma, free_turn) + dot(gammadot, omega) - moving_support.turn_along_normal_rate,
        ),
    )
    kinetic = sp.Rational(1, 2) * (m * norm_squared(v) + dot(inertia * omega, omega))
    return FreeBody(
        kinematics=kinematics,
        definitions=definitions,
        parameters=_parameters(body, kinematics, moving_support, field),
        inertia=inertia,
        inverse_inertia=inverse,
        mobility=mobility,
        turn=free_turn,
        slip_rate=slip_rate,
        spin_rate=spin_rate,
        vertical=vertical,
        support_velocity=moving_support.velocity,
        turning=moving_support.turn,
        kinetic=kinetic,
        potential=field.potential,
    )


def free_body_parameters(situation: FrictionalContact) -> tuple[Parameter, ...]:
    """The parameters of a body and its support with their values; those of `free_body`."""
    body, surface = situation.body, situation.surface
    kinematics = _contact(body.shape, surface)
    vertical = surface.vertical
    field = _applied_forces(situation, vertical, kinematics)
    return _parameters(body, kinematics, _support(surface, vertical), field)


@lru_cache(maxsize=64)
def _contact(shape: Shape, surface: Surface) -> Contact:
    """Kinematics of the contact of a body that touches its support."""
    return contact(shape, surface, contact_velocity)


def _parameters(
    body: Body, kinematics: Contact, support: _Support, field: _AppliedForces
) -> tuple[Parameter, ...]:
    return _of_body(body) + kinematics.parameters + support.parameters + field.parameters


@lru_cache(maxsize=64)
def _of_body(body: Body) -> tuple[Parameter, ...]:
    return body_parameters(body, Diagonal("I") if body.principal else Symmetric("I"))


def _contact_kinematics(situation: FrictionalContact, touching: bool) -> Contact:
    """The contact point, or the point of the body nearest to the support."""
    shape, surface = situation.body.shape, situation.surface
    if touching:
        return _contact(shape, surface)
    # Replace the support by the one through the nearest point, concentric or parallel to it.
    tangential = contact_velocity - dot(gamma, contact_velocity) * gamma
    return contact(shape, surface, tangential, a + gap)


@dataclass(frozen=True)
class _Support:
    """The motion of the support: `turn` about the vertical, `velocity` at the contact.

    `acceleration` is the rate of `velocity` along the contact, in body axes;
    `turn_along_normal_rate` that of the part of `turn` along the normal.
    """

    turn: sp.Expr = sp.S.Zero
    velocity: MatrixExpr = zero
    acceleration: MatrixExpr = zero
    turn_along_normal_rate: sp.Expr = sp.S.Zero
    parameters: tuple[Parameter, ...] = ()


def _support(surface: Surface, vertical: MatrixExpr) -> _Support:
    if not surface.turntable:
        return _Support()
    meaning = "angular velocity of the support about the vertical"
    tipping = cross(vertical, omega)
    # rate of `reach` in body axes: that of the contact point in space, less the rotation
    passing = v - cross(omega, reach - r) + rdot
    tilt_rate = sp.S.Zero
    if not surface.is_flat:
        tilt_rate = turning * (dot(tipping, gamma) + dot(vertical, gammadot))
    return _Support(
        turning,
        turning * cross(vertical, reach),
        turning * (cross(tipping, reach) + cross(vertical, passing)),
        tilt_rate,
        (Parameter(turning, meaning, surface.turntable, "rad/s"),),
    )


@dataclass(frozen=True)
class _AppliedForces:
    """Force and torque of the field, body axes, with their potential energy."""

    force: MatrixExpr = zero
    torque: MatrixExpr = zero
    potential: sp.Expr = sp.S.Zero
    definitions: Pairs = ()
    parameters: tuple[Parameter, ...] = ()


def _applied_forces(
    situation: FrictionalContact, vertical: MatrixExpr, kinematics: Contact
) -> _AppliedForces:
    body, field = situation.body, situation.field
    applied = _AppliedForces()
    if field.gravity:
        applied = _AppliedForces(
            force=-m * g * vertical,
            potential=m * g * position.symbols[2],
            parameters=(
                Parameter(g, "acceleration of gravity", field.gravity, "m/s^2", (g >= 0,)),
            ),
        )
    if field.potential == 0:
        return applied
    parameters = applied.parameters + field.parameters
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    known = (*body_parameters(body, inertia), *kinematics.parameters, *parameters)
    value = by_name(field.potential, (*gamma.symbols, *(p.symbol for p in known)))
    return _AppliedForces(
        force=applied.force,
        torque=cross(gamma, gradient(value, gamma)),
        potential=applied.potential + U,
        definitions=((U, value),),
        parameters=parameters,
    )
