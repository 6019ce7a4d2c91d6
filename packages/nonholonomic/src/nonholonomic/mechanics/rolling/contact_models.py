"""The equations of both contact models, from tensors, forces and the kinematics of the contact.

Fluid in cavities acts as a gyrostat whose momentum CN, a part of M, obeys an equation of its own.
With it the equations of :mod:`nonholonomic.mechanics.rolling.equations` are those of the equivalent
rigid body with the rotors k + CN, and −CṄ on the right side of Ĩω̇.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import Pairs, by_dependence
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vectors import Vector, cross, dot, norm_squared, real_symbol, zero

from ..conventions import BodyConventions
from ..shapes.kinematics import Contact
from ..shapes.surfaces import Surface
from .attitude import motion_in_space
from .fluid import Fluid

M, omega, gamma, zeta = (Vector(name) for name in ("M", "omega", "gamma", "zeta"))
X, omegadot, N, f = (Vector(name) for name in ("X", "omegadot", "N", "f"))
m, U, lambda_0 = (real_symbol(name) for name in ("m", "U", "lambda_0"))


@dataclass(frozen=True)
class Balance:
    """Tensors, forces and definitions shared by both contact models."""

    kinematics: Contact
    definitions: Pairs
    inertia: MatrixExpr
    solve: Callable[[MatrixExpr], MatrixExpr]
    force: MatrixExpr
    torque: MatrixExpr
    rotors: MatrixExpr
    energy: sp.Expr
    parameters: tuple[Parameter, ...]
    vertical: MatrixExpr
    fluids: tuple[Fluid, ...]

    @property
    def reaction(self) -> Vector:
        """Name of the contact force: f if N is the circulation vector of a fluid."""
        return f if self.fluids else N

    @property
    def motion_of_fluids(self) -> Pairs:
        """The motion of each fluid relative to the body."""
        return tuple(pair for fluid in self.fluids for pair in fluid.motion)

    @property
    def momentum_of_fluids(self) -> MatrixExpr:
        """The contribution of the fluids to M."""
        return sum((fluid.momentum for fluid in self.fluids), zero)

    @property
    def rate_of_fluids(self) -> MatrixExpr:
        """The rate of `momentum_of_fluids` in body axes."""
        return sum((fluid.C * fluid.rate for fluid in self.fluids), zero)


def _momentum(balance: Balance) -> MatrixExpr:
    """Iω + m r×(ω×r), the momentum of the equivalent body about the contact point."""
    kinematics = balance.kinematics
    return balance.inertia * omega + m * cross(kinematics.r, cross(omega, kinematics.r))


def marble(balance: Balance, surface: Surface, name: str, title: str) -> System:
    """The equations without slip; the state is M, γ and N of each fluid."""
    kinematics = balance.kinematics
    r, rdot = kinematics.r, kinematics.rdot
    rate = (
        cross(M, omega)
        + cross(balance.rotors, omega)
        + m * cross(rdot, cross(omega, r))
        - cross(r, balance.force)
        + balance.torque
    )
    # M determines ω through M − CN = Ĩω, and Ĩ depends on the position
    # definitions of the position that use ω come after it
    before, after = by_dependence(kinematics.definitions, omega.symbols)
    at_start = sum((fluid.C * fluid.initial for fluid in balance.fluids), zero)
    tensors = tuple(pair for pair in balance.definitions if pair not in kinematics.definitions)
    body_tensors = tuple(pair for pair in tensors if pair[0] != U)
    definitions = (
        *before,
        *body_tensors,
        (omega, balance.solve(M - balance.momentum_of_fluids)),
        *balance.motion_of_fluids,
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
        field=((M, rate), *kinematics.state),
        definitions=definitions,
        relations=kinematics.relations,
        momentum=M,
        start=((M, _momentum(balance) + at_start), *_circulations(balance), *kinematics.start),
        contact_law="without slipping (marble contact)",
        observables=(Observable("omega", omega, "angular velocity", "rad/s", "body"),),
        source="(1.17), (10.1)",
    )


def rubber(balance: Balance, surface: Surface, name: str, title: str) -> System:
    """The equations without slip and spin; the state is ω, γ and N of each fluid."""
    kinematics = balance.kinematics
    # The multiplier λ₀ follows from the derivative of (ω, γ) = 0: (ω̇, γ) + (ω, γ̇) = 0 with ω̇ =
    # Ĩ⁻¹(X + λ₀γ). On a plane γ̇ = γ×ω is orthogonal to ω.
    B, acceleration = Vector("gammatilde"), balance.solve(X)
    spin_rate = sp.S.Zero if surface.is_flat else dot(omega, kinematics.gammadot)
    definitions = (
        *balance.definitions,
        *balance.motion_of_fluids,
        (M, _momentum(balance) + balance.momentum_of_fluids),
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
        field=((omega, omegadot), *kinematics.state),
        definitions=definitions,
        relations=(*kinematics.relations, dot(omega, gamma)),
        momentum=M,
        start=(*_circulations(balance), *kinematics.start),
        contact_law="with neither slipping nor spinning (rubber contact)",
        observables=(
            Observable("M", M, "angular momentum about the contact point", "kg m^2/s", "body"),
            Observable("spin_torque", lambda_0, "torque about the normal", "N m", source="(1.19)"),
        ),
        source="(1.18), (1.23)",
    )


def _free_torque(balance: Balance) -> MatrixExpr:
    """Right-hand side of Ĩ ω̇ without the torque λ₀γ, (1.18)."""
    kinematics = balance.kinematics
    return (
        cross(M, omega)
        + cross(balance.rotors, omega)
        - m * cross(kinematics.r, cross(omega, kinematics.rdot))
        - cross(kinematics.r, balance.force)
        + balance.torque
        - balance.rate_of_fluids
    )


def _circulations(balance: Balance) -> Pairs:
    """Initial values of N of each fluid."""
    return tuple((fluid.N, fluid.initial) for fluid in balance.fluids)


# --- energy, contact force, motion in space ------------------------------------------------


def _system(
    balance: Balance,
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
    kinematics = balance.kinematics
    r = kinematics.r
    fluids, reaction = balance.fluids, balance.reaction
    # without slip 2T = (Ĩω, ω) = (M, ω) for the equivalent rigid body
    kinetic = sp.Rational(1, 2) * dot(momentum - balance.momentum_of_fluids, omega)
    kinetic = sp.Add(kinetic, *(fluid.energy for fluid in fluids))
    # v̇ + ω×v with v = r×ω, in body axes
    acceleration = (
        cross(kinematics.rdot, omega) + cross(r, omegadot) + cross(omega, cross(r, omega))
    )
    definitions += ((reaction, m * acceleration - balance.force),)
    guards = kinematics.guards
    if balance.force != zero:
        guards += (
            Guard("contact", dot(reaction, gamma), "the normal force changes sign", lift_off=True),
        )
    if balance.vertical == zeta and balance.force != zero:
        field += ((zeta, cross(zeta, omega)),)
        relations += (norm_squared(zeta) - 1, *surface.relations_of_vertical)
    field += tuple((fluid.N, fluid.rate) for fluid in fluids)
    friction = reaction - dot(reaction, gamma) * gamma
    normal = Observable("gamma", gamma, "normal of the surface at the contact", "", "body")
    shown = {name for name, _ in field}
    what = "body with a cavity full of fluid" if fluids else "rigid body"
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
            *(fluid.circulation for fluid in fluids),
        ),
        observables=(
            *(item for item in (*observables, normal) if item.value not in shown),
            *(fluid.observable for fluid in fluids),
            Observable("normal_force", dot(reaction, gamma), "normal force", "N", source="(1.17)"),
            Observable("friction_force", friction, "friction force", "N", "body", "(1.17)"),
        ),
        guards=guards,
        reconstruction=motion_in_space(kinematics, surface, tilting=balance.force != zero),
        source=source,
        summary=f"A {what} rolls {contact_law} on {surface.words}.",
        conventions=BodyConventions(start),
    )
