"""A body above or on its support, without the reaction: kinematics and free accelerations."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ..core.named_formulas import Pairs
from ..core.system import Parameter
from ..core.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    by_name,
    constant,
    cross,
    dot,
    gradient,
    hat,
    norm_squared,
    real_symbol,
    to_components,
    zero,
)
from ..mechanics.rolling.attitude import rotation
from ..mechanics.rolling.body import body_parameters
from ..mechanics.rolling.contact import Contact, contact
from ..mechanics.rolling.surfaces import Sphere
from .situation import FrictionalContact
from .symbols import (
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
)

m, g, a, U, turning = (real_symbol(name) for name in ("m", "g", "a", "U", "Omega_s"))
k, zeta, wandering = Vector("k"), Vector("zeta"), Vector("wandering")


@dataclass(frozen=True)
class FreeBody:
    """Formulas of a body in or above contact that do not know the reaction.

    Attributes
    ----------
    touch : Contact
    definitions : pairs
        In order: kinematics of the contact, slip, spin, and the accelerations `free_acceleration`,
        `free_turn` and `slip_rate` without the reaction.
    parameters : tuple of Parameter
    inverse_inertia, mobility : MatrixExpr
        I⁻¹, and A = E/m − r̂ I⁻¹ r̂.
    vertical, support_velocity : MatrixExpr
        Vertical of space, and velocity of the support at the contact, body axes.
    turning : sympy.Expr
        Angular velocity of the support about the vertical; zero at rest.
    kinetic, potential : sympy.Expr
        Energies (J).
    """

    touch: Contact
    definitions: Pairs
    parameters: tuple[Parameter, ...]
    inverse_inertia: MatrixExpr
    mobility: MatrixExpr
    vertical: MatrixExpr
    support_velocity: MatrixExpr
    turning: sp.Expr
    kinetic: sp.Expr
    potential: sp.Expr


def free_body(situation: FrictionalContact, touching: bool) -> FreeBody:
    """The formulas of a body that touches its support, or flies above it."""
    body, surface, field = situation.body, situation.surface, situation.field
    on_sphere = isinstance(surface, Sphere)
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    rotors = k if any(body.gyrostat) else zero
    tangential: MatrixExpr = contact_velocity
    radius: sp.Expr = a
    if not touching:
        tangential = contact_velocity - dot(gamma, contact_velocity) * gamma
        radius = a + gap
    touch = contact(body.shape, surface, tangential, radius)
    parameters = body_parameters(body, inertia) + touch.parameters

    later = (*omega.symbols, *contact_velocity.symbols, gap)
    position_alone, moving = by_dependence(touch.definitions, later)
    names = {name for name, _ in (*touch.definitions, *touch.state)}
    vertical: MatrixExpr = zeta if on_sphere else gamma
    if r not in names:
        position_alone += ((r, touch.r),)
    if on_sphere:
        position_alone += ((zeta, constant(list(rotation().row(2)))),)
    seen = constant(to_components(rotation()).T * to_components(position))
    clearance = dot(reach, gamma) - (a if on_sphere else 0)
    inverse, mobility = type(inertia)("Y"), Symmetric("A")

    turn: sp.Expr = sp.S.Zero
    support = support_rate = zero
    tilt_rate: sp.Expr = sp.S.Zero
    if surface.turntable:
        turn = turning
        meaning = "angular velocity of the support about the vertical"
        parameters += (Parameter(turning, meaning, surface.turntable, "rad/s"),)
        support = turn * cross(vertical, reach)
        over = v - cross(omega, reach - r) + rdot
        tipped = cross(vertical, omega)
        support_rate = turn * (cross(tipped, reach) + cross(vertical, over))
        if on_sphere:
            tilt_rate = turn * (dot(tipped, gamma) + dot(vertical, gammadot))

    force, torque, potential = zero, zero, sp.S.Zero
    potential_definition: Pairs = ()
    if field.gravity:
        parameters += (Parameter(g, "acceleration of gravity", field.gravity, "m/s^2", (g >= 0,)),)
        force = -m * g * vertical
        potential = m * g * position.symbols[2]
    if field.potential != 0:
        parameters += tuple(
            Parameter(s, "parameter of the potential", value, "SI") for s, value in field.values
        )
        value = by_name(field.potential, (*gamma.symbols, *(p.symbol for p in parameters)))
        potential_definition = ((U, value),)
        potential = potential + U
        torque = cross(gamma, gradient(value, gamma))

    across = omega - turn * vertical
    definitions: Pairs = (
        *position_alone,
        (inverse, inertia**-1),
        (
            mobility,
            constant(sp.eye(3) / m - hat(r) * to_components(inverse) * hat(r)),
        ),
        (reach, seen + r),
        *(() if touching else ((gap, clearance),)),
        (contact_velocity, v + cross(omega, r)),
        *moving,
        *(() if gammadot in names else ((gammadot, touch.gammadot),)),
        *(() if rdot in names else ((rdot, touch.rdot),)),
        (slip, contact_velocity - support),
        (slip_speed, sp.sqrt(norm_squared(slip))),
        (spin, dot(gamma, across)),
        (rolling, across - spin * gamma),
        (rolling_speed, sp.sqrt(norm_squared(rolling))),
        (wandering, -touch.spread(cross(gamma, rolling))),
        (
            contour_couple,
            cross(gamma, touch.spread(wandering)) / sp.sqrt(norm_squared(wandering)),
        ),
        *potential_definition,
        (free_acceleration, force / m - cross(omega, v)),
        (free_turn, inverse * (torque + cross(inertia * omega + rotors, omega))),
        (
            slip_rate,
            free_acceleration + cross(free_turn, r) + cross(omega, rdot) - support_rate,
        ),
        (normal_rate, dot(gammadot, slip)),
        (spin_rate, dot(gamma, free_turn) + dot(gammadot, omega) - tilt_rate),
    )
    half = sp.Rational(1, 2)
    return FreeBody(
        touch=touch,
        definitions=definitions,
        parameters=parameters,
        inverse_inertia=inverse,
        mobility=mobility,
        vertical=vertical,
        support_velocity=support,
        turning=turn,
        kinetic=half * (m * norm_squared(v) + dot(inertia * omega, omega)),
        potential=potential,
    )


def by_dependence(definitions: Pairs, symbols: Sequence[sp.Symbol]) -> tuple[Pairs, Pairs]:
    """Definitions that do not depend on any of the symbols, and those that do."""
    moving = set(symbols)
    before: Pairs = ()
    after: Pairs = ()
    for name, formula in definitions:
        if to_components(formula).free_symbols & moving:
            moving |= {name} if isinstance(name, sp.Symbol) else set(name.symbols)
            after += ((name, formula),)
        else:
            before += ((name, formula),)
    return before, after
