"""Equations of motion of a body that touches a support with friction, and of its flight.

In body axes, with the velocity v of the centre of mass, force R and couple K of the support,

    m (v̇ + ω×v) = F + R,      I ω̇ + ω×(Iω + k) = T + r×R + K.

The touching particle of the body moves over the support with u = v + ω×r − V, where V is the
velocity of the support there.  Its acceleration is affine in the reaction,

    u̇ = b + A R + (I⁻¹K)×r,      A = E/m − r̂ I⁻¹ r̂,

and in contact its component along the normal γ follows from (γ, u) = 0: (γ, u̇) + (γ̇, u) = 0.
This condition, together with the friction laws and the velocities that a mode holds at zero,
determines the reaction.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import Pairs, scalars
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vectors import constant, cross, dot, norm_squared, real_symbol, zero

from ...mechanics.conventions import BODY
from ...mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    rotation,
    unit_length,
)
from ..friction.friction_law import FrictionLaw, Reaction
from ..friction.modes import Mode
from ..friction.symbols import (
    N,
    contact_velocity,
    contour_couple,
    couple,
    free_acceleration,
    free_turn,
    friction,
    gamma,
    height,
    normal_response,
    omega,
    position,
    r,
    reach,
    reaction,
    rolling,
    rolling_floor,
    slip,
    slip_floor,
    spin,
    spin_sign,
    v,
    wandering,
)
from .free_body import FreeBody, a, free_body, m
from .held_rolling import contour_hold_definitions, holding_couple_of_rolling, with_held_rolling
from .reaction import normal_excess, normal_rate_free, reaction_definitions
from .situation import FrictionalContact

#: Message of the guard that fires when the normal force becomes infinite.
PARADOX = "no motion in contact is possible (Painlevé's paradox)"

#: B, relative to its frictionless value, at which integration stops when B tends to zero.
JAM = 1e-6

#: Message of the guard that fires when Newton's method finds no normal force.
NOT_FOUND = "no normal force was found for a law of friction that depends on it"


def work_symbol(name: str) -> sp.Symbol:
    """Symbol of the work dissipated by a friction law, by impacts, or done on the support (J)."""
    return real_symbol(f"work_{name}")


def contact_equations(situation: FrictionalContact, mode: Mode) -> System:
    """The equations of motion of a body in one contact mode.

    Parameters
    ----------
    situation : FrictionalContact
    mode : Mode

    Returns
    -------
    System
        State: attitude (quaternion), position of the centre of mass (space axes), its velocity v,
        ω and γ (body axes; r for an implicit shape), and the work lost to each law.  The states of
        all modes have the same order; in flight a last variable is the height above the support.
        Guards say when the mode ends.
    """
    free = free_body(situation, mode.touching)
    definitions, powers, guards = _reaction(situation, mode, free)
    # Work columns that every situation has come first.
    first = {"impact": sp.S.Zero}
    if free.turning != 0:
        power = -dot(reaction, free.support_velocity) - free.turning * dot(couple, free.vertical)
        first["support"] = power
    powers = first | powers
    work: Pairs = tuple((work_symbol(name), power) for name, power in powers.items())
    turn = free.inverse_inertia * (cross(r, reaction) + couple)
    at_rest = _at_rest(mode, free)
    field: Pairs = (
        (attitude, quaternion_rate(omega)),
        (position, constant(rotation() * v.entries)),
        (v, free_acceleration + reaction / m),
        (omega, free_turn + turn),
        *free.kinematics.state,
        *work,
        *(pair for law in situation.laws for pair in law.clocks),
    )
    if not mode.touching:
        field += ((height, dot(gamma, contact_velocity)),)
    if at_rest:
        field = tuple((name, 0 * formula) for name, formula in field)
    energy = free.kinetic + free.potential
    balance = Integral(
        "energy_balance",
        energy + sp.Add(*(name for name, _ in work)),
        "energy with all work lost",
        unit="J",
    )
    parameters = free.parameters + tuple(p for law in situation.laws for p in law.parameters)
    parameters += _RUN_PARAMETERS
    return System(
        name=f"contact-{mode.name.replace(' ', '-')}",
        title=f"Body in contact with friction: {mode.name}",
        field=field,
        parameters=parameters,
        definitions=definitions,
        relations=_relations(situation, mode, free),
        laws=(balance,),
        observables=_observables(situation, energy, powers),
        guards=(*free.kinematics.guards, *guards),
        source="§11.1",
        conventions=BODY,
    )


#: Parameters set during a simulation: the sign of the spin, and the thresholds of stopping.
_RUN_PARAMETERS = (
    Parameter(spin_sign, "sign of the spin", 1.0, "1"),
    Parameter(slip_floor, "speed at which sliding is followed in logarithmic time", 1e-9, "m/s"),
    Parameter(rolling_floor, "angular velocity at which rolling is so followed", 1e-9, "rad/s"),
)


def _reaction(
    situation: FrictionalContact, mode: Mode, free: FreeBody
) -> tuple[Pairs, dict[str, sp.Expr], tuple[Guard, ...]]:
    """Definitions of the reaction, power dissipated by each law, and guards of the mode."""
    laws, definitions = situation.laws, free.definitions
    powers: dict[str, sp.Expr] = {law.name: sp.S.Zero for law in laws}
    none = constant([0, 0, 0])
    if not mode.touching:
        definitions += ((reaction, none), (couple, none), (N, sp.S.Zero), (friction, none))
        return definitions, powers, (Guard("landing", height, "the body lands"),)
    total = sum((law.reaction(mode) for law in laws), Reaction())
    definitions += tuple(pair for law in laws for pair in law.definitions(mode))
    definitions = _with_prescribed_rolling(laws, free, definitions)
    if mode.rolling:
        definitions += reaction_definitions(free, mode, total)
    else:
        without_rolling, held = with_held_rolling(free)
        along_normal = reaction_definitions(held, mode, total)
        definitions += without_rolling + holding_couple_of_rolling(free, held, along_normal)
        if any(law.is_along_contour for law in laws):
            definitions += contour_hold_definitions(free)
    definitions += ((friction, reaction - N * gamma),)
    powers = {law.name: law.reaction(mode).power for law in laws}
    guards = [Guard("lift-off", N, "the body leaves the support")]
    guards += [guard for law in laws for guard in law.guards(mode)]
    if mode.sliding and not total.p == total.q == zero:
        # The normal force grows like 1/B, and no step can end exactly at B = 0.
        least = JAM * dot(gamma, free.mobility * gamma)
        guards.append(Guard("paradox", normal_response - least, PARADOX))
    if normal_excess in dict(definitions):
        # Relative to the accelerations, so that the guard does not fire where the body lifts off.
        size = normal_rate_free**2 + norm_squared(free_acceleration)
        guards.append(Guard("normal force", 1e-20 * size - normal_excess**2, NOT_FOUND))
    return definitions, powers, tuple(guards)


def _with_prescribed_rolling(
    laws: tuple[FrictionLaw, ...], free: FreeBody, definitions: Pairs
) -> Pairs:
    """The definitions, with the motion of the contact point that a prescribed rolling implies."""
    for law in laws:
        direction = law.rolling_direction
        if direction is not None:
            wanders = -free.kinematics.spread(cross(gamma, direction))
            moved = {wandering: wanders, contour_couple: dict(definitions)[contour_couple]}
            others = tuple(pair for pair in definitions if pair[0] not in moved)
            return (*others, *moved.items())
    return definitions


def _at_rest(mode: Mode, free: FreeBody) -> bool:
    """Whether all velocities vanish in a mode; a body on a turning support moves with it."""
    moving = mode.sliding or mode.spinning or mode.rolling
    return mode.touching and not moving and free.turning == 0


def _relations(situation: FrictionalContact, mode: Mode, free: FreeBody) -> tuple[sp.Expr, ...]:
    """The constraints of the mode: unit lengths, position of the contact, zero velocities."""
    on_plane = situation.surface.is_flat
    relations = (*free.kinematics.relations, unit_length())
    if on_plane:
        relations += attitude_relations(gamma)
    if not mode.touching:
        # The support's nearest point lies below the nearest point of the body.
        return relations if on_plane else (*relations, *scalars(cross(gamma, reach)))
    if on_plane:
        relations += (dot(reach, gamma),)
    else:
        relations += tuple(scalars(reach - a * gamma))
    if mode.sliding:
        relations += (dot(gamma, contact_velocity),)
    else:
        relations += slip.symbols
    if not mode.spinning:
        relations += (spin,)
    if not mode.rolling:
        relations += (omega if _at_rest(mode, free) else rolling).symbols
    return relations


def _observables(
    situation: FrictionalContact, energy: sp.Expr, powers: dict[str, sp.Expr]
) -> tuple[Observable, ...]:
    """The quantities recorded besides the state."""
    turn = rotation()
    contact_place = constant(position.entries + turn * r.entries)
    power = sp.Add(*powers.values())
    return (
        attitude_observable(),
        Observable("gamma", gamma, "normal of the support at the contact", "", "body"),
        Observable("centre", position, "centre of mass", "m", "space", "(1.17)"),
        Observable(
            "velocity",
            constant(turn * v.entries),
            "velocity of the centre of mass",
            "m/s",
            "space",
        ),
        Observable("contact", contact_place, "nearest point of the body", "m", "space", "(1.14)"),
        Observable(
            "gap",
            dot(reach, gamma) - situation.surface.level,
            "distance of the body from the support",
            "m",
        ),
        Observable("slip", slip, "velocity of the contact over the support", "m/s", "body"),
        Observable("spin", spin, "angular velocity about the normal", "rad/s"),
        Observable("normal_force", N, "normal force", "N", source="(1.17)"),
        Observable("friction_force", friction, "friction force", "N", "body", "§11.1"),
        Observable("friction_couple", couple, "couple of the support", "N m", "body", "§11.1"),
        Observable("power_lost", power, "power lost to friction", "W"),
        Observable("energy", energy, "energy", "J"),
    )
