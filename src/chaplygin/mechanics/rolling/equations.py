"""Equations of motion of a rigid body rolling on a plane or a sphere.

Newton's and Euler's equations with the contact force N at the contact point r and, for a rubber
body, the torque λ₀γ about the normal (§1.3),

    m (v̇ + ω×v) = N + F,      I ω̇ + ω×(I ω + k) = r×N + τ + λ₀ γ,      v = r×ω,

hold for every shape and surface.  Without N they read, in the momentum M = Iω + m r×(ω×r) about
the contact point,

    Ṁ = (M + k)×ω + m ṙ×(ω×r) − r×F + τ + λ₀ γ.

The kinematics depends on shape and surface; see :mod:`chaplygin.mechanics.rolling.contact`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from ...arguments import arguments_checked
from ...core.laws import Integral
from ...core.named_formulas import Pairs
from ...core.system import Guard, Observable, Parameter, System
from ...core.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    by_name,
    cross,
    dot,
    gradient,
    identity,
    norm_squared,
    real_symbol,
    zero,
)
from ...errors import InputError
from .body import Body, body_parameters
from .contact import Contact, contact as contact_of, definitions_by_velocity
from .motion_in_space import motion_in_space
from .shape_base import check_values, real_values
from .surfaces import Plane, Surface

ContactModel = Literal["marble", "rubber"]

M, omega, gamma, zeta = (Vector(name) for name in ("M", "omega", "gamma", "zeta"))
k, X, omegadot, N, F = (Vector(name) for name in ("k", "X", "omegadot", "N", "F"))
place = Vector("place", 2)
m, g, a, U, lambda_0 = (real_symbol(name) for name in ("m", "g", "a", "U", "lambda_0"))


@arguments_checked
@dataclass(frozen=True)
class Forces:
    """The forces that act besides the contact.

    Parameters
    ----------
    gravity : float
        Acceleration g along −z of space (m/s²).
    potential : sympy.Expr, optional
        U(γ), in J, of ``gamma_1``, ``gamma_2``, ``gamma_3``; it may also use the body's parameters
        ``I_1`` … and ``m``.  It acts as a couple, so that it does not enter the contact force.
    values : mapping of Symbol to float
        Values of further symbols in `potential`.

    Examples
    --------
    >>> import chaplygin as ch
    >>> import sympy as sp
    >>> gamma_3, k = sp.symbols("gamma_3 k")
    >>> spring = ch.Forces(potential=k * gamma_3**2 / 2, values={k: 0.1})
    >>> ball = ch.roll(ch.Body(1.0, (0.4, 0.5, 0.6), ch.Ball(1.0)), field=spring)
    >>> [(verdict.law, verdict.decision) for verdict in ch.prove(ball)]
    [('energy', 'proven')]
    """

    gravity: float = 0.0
    potential: sp.Expr = sp.S.Zero
    values: tuple[tuple[sp.Symbol, float], ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "values", real_values(self.values))
        check_values(self.values)
        if not (np.isfinite(self.gravity) and self.gravity >= 0):
            raise InputError(f"gravity {self.gravity}: it must be finite and not negative")


@arguments_checked
@dataclass(frozen=True)
class Rolling:
    """A body, a surface, a contact model and a field, with their numbers.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.Body(1.0, (0.4, 0.5, 0.6), ch.Ball(1.0, centre=(0.0, 0.0, 0.1)))
    >>> rolling = ch.Rolling(ball, ch.Plane(), "rubber")
    >>> ch.measure_exists(rolling).decision
    'none'
    """

    body: Body
    surface: Surface = Plane()  # noqa: RUF009  (immutable)
    contact: ContactModel = "marble"
    field: Forces = Forces()

    def system(self, name: str = "rolling-body", title: str = "Rolling body") -> System:
        """The equations of motion; see :func:`roll`."""
        return roll(self.body, self.surface, self.contact, self.field, name, title)


@dataclass(frozen=True)
class _Balance:
    """Tensors, forces and definitions, which both contact models share."""

    touch: Contact
    definitions: Pairs
    inertia: MatrixExpr
    solve: Callable[[MatrixExpr], MatrixExpr]
    force: MatrixExpr
    torque: MatrixExpr
    rotors: MatrixExpr
    energy: sp.Expr
    parameters: tuple[Parameter, ...]
    vertical: MatrixExpr


@arguments_checked
def roll(
    body: Body,
    surface: Surface = Plane(),  # noqa: B008  (immutable)
    contact: ContactModel = "marble",
    field: Forces = Forces(),
    name: str = "rolling-body",
    title: str = "Rolling body",
) -> System:
    """The System of a body that rolls on a surface.

    Parameters
    ----------
    body : Body
        Mass, inertia, shape and gyrostat; its numbers become the defaults of the parameters.
        A centre offset or gyrostat that is exactly zero is left out of the equations.
    surface : Plane or Sphere
        What it rolls on.
    contact : ``"marble"`` or ``"rubber"``
        No slip; or no slip and no spin about the normal, (ω, γ) = 0.
    field : Forces
        Gravity and a potential U(γ).
    name, title : str
        Identifier and human form.

    Returns
    -------
    System
        State M, γ (marble) or ω, γ (rubber), in body axes; r instead of γ for an implicit shape;
        and ζ, the vertical in body axes, under gravity on a sphere.  It carries the energy
        integral, the contact force as observables, its domain as guards, and the motion in space.

    Raises
    ------
    InputError
        If the contact model is unknown or the potential uses an unknown symbol.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.Body(1.0, (0.4, 0.5, 0.6), ch.Ball(1.0))
    >>> system = ch.roll(ball, ch.Plane(), "marble")
    >>> dict(system.field)
    {M: Cross(M, omega), gamma: Cross(gamma, omega)}
    """
    if contact not in ("marble", "rubber"):
        raise InputError(f"contact {contact!r}: it must be 'marble' or 'rubber'")
    if surface.turntable:
        raise InputError(
            f"turntable {surface.turntable:g}: a turning support needs a contact with friction; a "
            f"{contact} contact rolls on a support at rest"
        )
    balance = _balance(body, surface, field)
    build = _marble if contact == "marble" else _rubber
    return build(balance, surface, name, title)


# --- forces and tensors --------------------------------------------------------------------


def _balance(body: Body, surface: Surface, field: Forces) -> _Balance:
    touch = contact_of(body.shape, surface)
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    parameters = body_parameters(body, inertia) + touch.parameters
    r, rotors = touch.r, k if any(body.gyrostat) else zero

    # the inverse of I + m r² − m r⊗r, by Sherman and Morrison from the one of J = I + m r²
    J, A = type(inertia)("J"), type(inertia)("A")
    definitions = (
        *touch.definitions,
        (J, inertia + m * touch.square * identity),
        (A, J**-1),
    )

    def solve(vector: MatrixExpr) -> MatrixExpr:
        lever = A * r
        share = m * dot(lever, vector) / (1 - m * dot(r, lever))
        return A * vector + share * lever

    vertical = gamma if isinstance(surface, Plane) else zeta
    force, energy, torque = zero, sp.S.Zero, zero
    if field.gravity:
        parameters += (Parameter(g, "acceleration of gravity", field.gravity, "m/s^2", (g >= 0,)),)
        force = -m * g * vertical
        height = touch.height if vertical is gamma else dot(a * gamma - r, zeta)
        energy = m * g * height
    if field.potential != 0:
        parameters += tuple(
            Parameter(s, "parameter of the potential", value, "SI") for s, value in field.values
        )
        potential = by_name(field.potential, (*gamma.symbols, *(p.symbol for p in parameters)))
        _check_potential(potential, parameters)
        definitions += ((U, potential),)
        energy = energy + U
        torque = cross(gamma, touch.pull(gradient(potential, gamma)))
    return _Balance(
        touch=touch,
        definitions=definitions,
        inertia=inertia,
        solve=solve,
        force=force,
        torque=torque,
        rotors=rotors,
        energy=energy,
        parameters=parameters,
        vertical=vertical,
    )


def _check_potential(potential: sp.Expr, parameters: tuple[Parameter, ...]) -> None:
    allowed = [str(p.symbol) for p in parameters]
    unknown = potential.free_symbols - set(gamma.symbols) - {p.symbol for p in parameters}
    if unknown:
        raise InputError(
            f"potential {potential}: {', '.join(sorted(map(str, unknown)))} is not known; it may "
            f"use gamma_1, gamma_2, gamma_3 and {', '.join(allowed)}"
        )


def _momentum(balance: _Balance, spin: MatrixExpr = omega) -> MatrixExpr:
    """M = Iω + m r×(ω×r), the momentum of the body about the contact point."""
    touch = balance.touch
    return balance.inertia * spin + m * cross(touch.r, cross(spin, touch.r))


# --- the two contact models ----------------------------------------------------------------


def _marble(balance: _Balance, surface: Surface, name: str, title: str) -> System:
    touch = balance.touch
    r, rdot = touch.r, touch.rdot
    rate = (
        cross(M, omega)
        + cross(balance.rotors, omega)
        + m * cross(rdot, cross(omega, r))
        - cross(r, balance.force)
        + balance.torque
    )
    # definitions of the position that use ω come after it
    before, after = definitions_by_velocity(touch.definitions)
    tensors = tuple(pair for pair in balance.definitions if pair not in touch.definitions)
    body_tensors = tuple(pair for pair in tensors if pair[0] != U)
    definitions = (
        *before,
        *body_tensors,
        (omega, balance.solve(M)),
        *after,
        *(pair for pair in tensors if pair[0] == U),
        (X, _free_torque(balance)),
        (omegadot, balance.solve(X)),
    )
    return _system(
        balance,
        surface,
        name,
        title,
        field=((M, rate), *touch.state),
        definitions=definitions,
        relations=touch.relations,
        momentum=M,
        start=((M, _momentum(balance)),),
        contact_law="without slipping (marble contact)",
        observables=(Observable("omega", omega, "angular velocity", "rad/s", "body"),),
        source="(1.17), (10.1)",
    )


def _rubber(balance: _Balance, surface: Surface, name: str, title: str) -> System:
    touch = balance.touch
    B, acceleration = Vector("gammatilde"), balance.solve(X)
    spin_rate = dot(omega, touch.gammadot) if not isinstance(surface, Plane) else sp.S.Zero
    definitions = (
        *balance.definitions,
        (M, _momentum(balance)),
        (X, _free_torque(balance)),
        (B, balance.solve(gamma)),
        (lambda_0, -(dot(B, X) + spin_rate) / dot(B, gamma)),
        (omegadot, acceleration + lambda_0 * B),
    )
    return _system(
        balance,
        surface,
        name,
        title,
        field=((omega, omegadot), *touch.state),
        definitions=definitions,
        relations=(*touch.relations, dot(omega, gamma)),
        momentum=M,
        start=(),
        contact_law="with neither slipping nor spinning (rubber contact)",
        observables=(
            Observable("M", M, "angular momentum about the contact point", "kg m^2/s", "body"),
            Observable("spin_torque", lambda_0, "torque about the normal", "N m", source="(1.19)"),
        ),
        source="(1.18), (1.23)",
    )


def _free_torque(balance: _Balance) -> MatrixExpr:
    """Right-hand side of Ĩ ω̇ without the torque λ₀γ, (1.18)."""
    touch = balance.touch
    return (
        cross(M, omega)
        + cross(balance.rotors, omega)
        - m * cross(touch.r, cross(omega, touch.rdot))
        - cross(touch.r, balance.force)
        + balance.torque
    )


# --- energy, contact force, motion in space ------------------------------------------------


def _system(
    balance: _Balance,
    surface: Surface,
    name: str,
    title: str,
    *,
    field: Pairs,
    definitions: Pairs,
    relations: tuple[sp.Expr, ...],
    momentum: MatrixExpr,
    start: Pairs,
    contact_law: str,
    observables: tuple[Observable, ...],
    source: str,
) -> System:
    touch = balance.touch
    r = touch.r
    kinetic = sp.Rational(1, 2) * dot(momentum, omega)
    acceleration = cross(touch.rdot, omega) + cross(r, omegadot) + cross(omega, cross(r, omega))
    definitions += ((N, m * acceleration - balance.force),)
    guards = touch.guards
    if balance.force != zero:
        guards += (Guard("contact", dot(N, gamma), "the normal force changes sign", lift_off=True),)
    if balance.vertical is zeta and balance.force != zero:
        field += ((zeta, cross(zeta, omega)),)
        relations += (norm_squared(zeta) - 1,)
    normal = Observable("gamma", gamma, "normal of the surface at the contact", "", "body")
    shown = {name for name, _ in field}
    return System(
        name=name,
        title=title,
        field=field,
        parameters=balance.parameters,
        definitions=definitions,
        relations=relations,
        laws=(
            Integral(
                "energy", kinetic + balance.energy, "energy", source="(3.3), Theorem 1", unit="J"
            ),
        ),
        observables=(
            *(item for item in (*observables, normal) if item.value not in shown),
            Observable("normal_force", dot(N, gamma), "normal force", "N", source="(1.17)"),
            Observable(
                "friction_force", N - dot(N, gamma) * gamma, "friction force", "N", "body", "(1.17)"
            ),
        ),
        guards=guards,
        reconstruction=motion_in_space(touch, surface, tilting=balance.force != zero),
        source=source,
        summary=f"A rigid body rolls {contact_law} on {surface.words}.",
        start=start,
    )
