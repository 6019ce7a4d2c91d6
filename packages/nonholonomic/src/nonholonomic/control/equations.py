"""Equations of a ball driven by rotors and a mass inside it.

Body axes with the geometric centre O as origin.  The contact C lies at −Rγ, so the velocity of O
(and of the contact point on the plane) is V = Rω×γ.  With the centre of mass of the ball at a, the
moving mass μ at ρ, s = Rγ + a and σ = Rγ + ρ, the angular momentum about C is

    M = A ω + b,   A = I + m(s² − s sᵀ) + μ(σ² − σ σᵀ),   b = μ σ×ρ̇ + Σ i_a u_a e_a,

    Ṁ = M×ω − g(m a + μρ)×γ − V×(m ω×a + μ(ω×ρ + ρ̇)) + λγ,   γ̇ = γ×ω,

λ = 0 for the marble contact.  For the rubber contact λ keeps (ω, γ) = 0; it changes only the
vertical component of M, which is omitted: M then denotes the horizontal part, and M + ℓγ = Aω + b
with ℓ = −(γ, A⁻¹(M − b))/(γ, A⁻¹γ). M is continuous even if the rates of joints and the speeds of
rotors jump; a balanced ball without moving mass that starts from rest keeps M = 0 and is driftless.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeAlias

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import Pairs, flat_pairs, scalars
from flowlanes.system.system import Observable, Parameter, Reconstruction, System
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    constant,
    cross,
    dot,
    norm_squared,
    real_symbol,
)

from ..mechanics.conventions import BODY
from ..mechanics.lagrangian.mechanism import TIME
from ..mechanics.rolling.attitude import (
    attitude,
    attitude_observable,
    attitude_relations,
    quaternion_rate,
    rotation,
    unit_length,
)
from .controlled import ControlledSystem, input_formulas
from .robot import SphericalRobot

M, gamma, omega, b, rho, rhodot = (Vector(n) for n in ("M", "gamma", "omega", "b", "rho", "rhodot"))
place, A = Vector("place", 2), Symmetric("A")
m, mu, R, g, Delta, ell = (real_symbol(n) for n in ("m", "mu", "R", "g", "Delta", "ell"))

Column: TypeAlias = Any


@dataclass(frozen=True)
class _Formulas:
    """Definitions and rates, in γ, M, the joints and the inputs."""

    inputs: tuple[sp.Symbol, ...]
    definitions: Pairs
    momentum_rate: Column
    joint_rates: tuple[tuple[sp.Symbol, sp.Expr], ...]
    parameters: tuple[Parameter, ...]


@arguments_checked
def controlled_system(robot: SphericalRobot) -> ControlledSystem:
    """The equations of a robot with arbitrary momentum.

    Parameters
    ----------
    robot : SphericalRobot

    Returns
    -------
    ControlledSystem
        The state has the attitude (quaternion, body to space), the contact point, M (body axes; its
        horizontal part for a rubber contact) and the joints of the moving mass; inputs are the
        speeds ``u_1``, … of the rotors and ``theta_rate``, … of the joints.

    Raises
    ------
    InputError
        If a joint has the name of another variable.

    Examples
    --------
    >>> from nonholonomic.control import Rotor, SphericalRobot, controlled_system
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((0, 0, 1), 0.1),))
    >>> controlled_system(robot).inputs
    (u_1,)
    """
    return _in_space(robot, M.entries, ((M, None),))


@arguments_checked
def driftless_system(robot: SphericalRobot) -> ControlledSystem:
    """The equations of a balanced robot that starts from rest, M = 0.

    Parameters
    ----------
    robot : SphericalRobot

    Returns
    -------
    ControlledSystem
        The state has attitude and contact point; rates are linear in the speeds of the rotors.

    Raises
    ------
    InputError
        If the robot is not balanced: its momentum about the contact does not stay zero.

    Examples
    --------
    >>> from nonholonomic.control import Rotor, SphericalRobot, driftless_system
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((0, 0, 1), 0.1),))
    >>> len(driftless_system(robot).state)
    6
    """
    if not robot.is_balanced:
        raise InputError(
            "spherical robot: with a moving mass, or a centre of mass beside the geometric centre, "
            "its momentum about the contact does not stay zero; use controlled_system"
        )
    return _in_space(robot, sp.zeros(3, 1), ())


@arguments_checked
def driven_system(robot: SphericalRobot, inputs: Mapping[str, str | sp.Expr]) -> System:
    """The motion of a robot whose inputs are given functions of time and state.

    Parameters
    ----------
    robot : SphericalRobot
    inputs : mapping of str to formula
        A formula for each input, by name, in the time t, M, gamma and the joints.

    Returns
    -------
    System
        The state has M, gamma, the joints and, if the inputs depend on it, the time; attitude and
        contact point are reconstructed. For a balanced ball the momentum is among the laws.

    Raises
    ------
    InputError
        If an input is missing or unknown, or a formula cannot be read.

    Examples
    --------
    >>> import lawproof
    >>> from nonholonomic.control import Rotor, SphericalRobot, driven_system
    >>> robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((0, 0, 1), 0.1),))
    >>> lawproof.prove(driven_system(robot, {"u_1": "sin(t)"}), "momentum").decision
    'proven'
    """
    parts = _formulas(robot, M.entries)
    field = (
        (M, constant(list(parts.momentum_rate))),
        (gamma, cross(gamma, omega)),
        *parts.joint_rates,
    )
    rubber = robot.contact == "rubber"
    relations = (norm_squared(gamma) - 1, *((dot(M, gamma),) if rubber else ()))
    state = tuple(symbol for symbol, _ in flat_pairs(field))
    formulas = input_formulas("driven-ball", parts.inputs, state, inputs)
    timed = any(formula.has(TIME) for formula in formulas.values())
    laws: tuple[Integral, ...] = ()
    if robot.is_balanced:
        laws = (Integral("momentum", norm_squared(M)),)
        if not rubber:
            laws += (Integral("area", dot(M, gamma)),)
    return System(
        "driven-ball",
        "Ball with driven rotors" if robot.moving_mass is None else "Ball with a moving mass",
        (*field, *(((TIME, sp.S.One),) if timed else ())),
        parts.parameters,
        (*formulas.items(), *parts.definitions),
        relations,
        laws,
        (
            Observable("omega", omega, "angular velocity", "rad/s", "body"),
            Observable("gamma", gamma, "vertical", "", "body"),
            *(Observable(str(u), u, "speed of a rotor or joint", "rad/s") for u in parts.inputs),
        ),
        reconstruction=_motion_in_space(),
        conventions=BODY,
    )


def _motion_in_space() -> Reconstruction:
    x, y = place.symbols
    return Reconstruction(
        field=((attitude, quaternion_rate(omega)), (place, _place_rate())),
        relations=(unit_length(), *attitude_relations(gamma)),
        observables=(
            attitude_observable(),
            Observable("contact", constant([x, y, 0]), "contact point", "m", "space"),
            Observable("centre", constant([x, y, R]), "geometric centre", "m", "space"),
        ),
    )


def _place_rate() -> sp.Basic:
    velocity = R * rotation() * constant(scalars(cross(omega, gamma)))
    return constant(velocity[:2])


def _in_space(robot: SphericalRobot, momentum: Column, state: Pairs) -> ControlledSystem:
    """The equations with attitude and position; `state` names M if it belongs to the state."""
    parts = _formulas(robot, momentum)
    field = [(attitude, quaternion_rate(omega)), (place, _place_rate())]
    field += [(name, constant(list(parts.momentum_rate))) for name, _ in state]
    vertical = ((gamma, constant(list(rotation().row(2)))),)
    x, y = place.symbols
    relations: tuple[sp.Expr, ...] = (unit_length(),)
    if state and robot.contact == "rubber":
        relations += (sp.Add(*(p * q for p, q in zip(M, rotation().row(2), strict=True))),)
    return ControlledSystem(
        "spherical-robot",
        (*field, *parts.joint_rates),
        parts.inputs,
        (*vertical, *parts.definitions),
        parts.parameters,
        relations,
        (x, y),
    )


def _formulas(robot: SphericalRobot, momentum: Column) -> _Formulas:
    vertical = gamma.entries
    inertia = Diagonal("I") if _principal(robot) else Symmetric("I")
    speeds = tuple(real_symbol(f"u_{a}") for a in range(1, len(robot.rotors) + 1))
    gyration = robot.gyration * sp.Matrix(speeds) if speeds else sp.zeros(3, 1)
    # a, the reverse of the vector from centre of mass to geometric centre.
    offset = -sp.Matrix([exact_number(x) for x in robot.centre])
    tensor = sp.Matrix(inertia.entries)
    arm = R * vertical + offset
    # γ is a unit vector: with a = 0 this is m R²(1 − γγᵀ).
    square = R**2 + 2 * R * vertical.dot(offset) + offset.dot(offset)
    tensor += m * (square * sp.eye(3) - arm * arm.T)
    turn = omega.entries
    velocity = R * turn.cross(vertical)
    definitions: list[tuple[sp.Basic, sp.Basic]] = []
    torque, shift = sp.zeros(3, 1), sp.zeros(3, 1)
    if any(offset):
        torque -= g * m * offset.cross(vertical) + velocity.cross(m * turn.cross(offset))
    joints: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    if robot.moving_mass is not None:
        mass = robot.moving_mass
        rates = tuple(real_symbol(f"{q}_rate") for q in mass.joints)
        joints = tuple(zip(mass.symbols, rates, strict=True))
        formulas = sp.Matrix(mass.formulas)
        definitions.append((rho, constant(list(formulas))))
        definitions.append(
            (rhodot, constant(list(formulas.jacobian(mass.symbols) * sp.Matrix(rates))))
        )
        spot, drift = rho.entries, rhodot.entries
        arm = R * vertical + spot
        tensor += mu * (
            (R**2 + 2 * R * vertical.dot(spot) + spot.dot(spot)) * sp.eye(3) - arm * arm.T
        )
        shift += mu * arm.cross(drift)
        torque -= mu * (g * spot.cross(vertical) + velocity.cross(turn.cross(spot) + drift))
        speeds += rates
    definitions.append((A, constant(tensor)))
    definitions.append((b, constant(list(gyration + shift))))
    entries = sp.Matrix(A.entries)
    # A⁻¹ as cofactors over a named determinant, which keeps the formulas short; in ℓ the
    # determinant cancels.
    cofactors = entries.adjugate()
    definitions.append((Delta, entries.det(method="berkowitz")))
    known = momentum - b.entries
    if robot.contact == "rubber":
        up = (cofactors * vertical).T
        definitions.append((ell, -(up * known)[0] / (up * vertical)[0]))
        known += ell * vertical
        # M×ω and γ×ω keep (M, γ) = 0 by themselves; λ takes the vertical part of the torque.
        torque -= torque.dot(vertical) * vertical
    definitions.append((omega, constant(list(cofactors * known / Delta))))
    _check_names(robot)
    rate = momentum.cross(turn) + torque
    return _Formulas(speeds, tuple(definitions), rate, joints, _parameters(robot, inertia))


def _principal(robot: SphericalRobot) -> bool:
    tensor = robot.tensor
    return not any(tensor[i, j] for i in range(3) for j in range(3) if i != j)


def _parameters(robot: SphericalRobot, inertia: Diagonal | Symmetric) -> tuple[Parameter, ...]:
    parameters = [
        Parameter(m, "mass of the ball", robot.mass, "kg", (m > 0,)),
        Parameter(R, "radius of the ball", robot.radius, "m", (R > 0,)),
    ]
    parameters += [
        Parameter(s, "entry of the inertia tensor", float(value), "kg m^2")
        for s, value in zip(inertia.symbols, inertia.independent(robot.tensor), strict=True)
    ]
    if robot.moving_mass is not None:
        parameters.append(Parameter(mu, "moving mass", robot.moving_mass.mass, "kg", (mu > 0,)))
    if not robot.is_balanced:
        parameters.append(Parameter(g, "acceleration of gravity", robot.gravity, "m/s^2"))
    return tuple(parameters)


def _check_names(robot: SphericalRobot) -> None:
    taken = {
        "t",
        *(
            str(s)
            for v in (M, gamma, omega, b, rho, rhodot, attitude, place, A)
            for s in (v, *v.symbols)
        ),
        "m",
        "mu",
        "R",
        "g",
        "Delta",
        "ell",
    }
    taken |= {f"u_{a}" for a in range(1, 4)} | {f"I_{i}" for i in (1, 2, 3)}
    joints = robot.moving_mass.joints if robot.moving_mass else ()
    for name in joints:
        if name in taken:
            raise InputError(f"moving mass: the joint {name} has the name of another variable")
