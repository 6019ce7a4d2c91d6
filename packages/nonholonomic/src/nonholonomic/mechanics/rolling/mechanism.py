"""A rolling body as a mechanism: the free body's Lagrangian and constraints.

The quasi-velocities are ω and the velocity v of the centre of mass, both in body axes, with the
brackets (1.12); the constraints are v + ω×r = 0 (1.14) and, for a rubber body, (ω, γ) = 0 (1.15).
Place and heading are cyclic.  On a plane the height R₃ of the centre of mass stays a coordinate,
so that the multipliers are the contact force itself, gravity apart; on a sphere the centre of mass
X (body axes, from the centre of the sphere) takes this role. Fluid in a cavity adds the velocity ξ
of its motion relative to the body, whose structure constants are those of ω with the opposite sign.
"""

from __future__ import annotations

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.system.named_formulas import by_dependence, expand, flat_pairs, scalars
from flowlanes.system.system import Guard, Parameter
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

from ..lagrangian.mechanism import Frame, Mechanism, StructureConstants, euclidean, rotations
from .contact import contact as contact_of
from .equations import RollingBody
from .fluid import Fluid

omega, v, gamma, zeta, X, k = (Vector(n) for n in ("omega", "v", "gamma", "zeta", "X", "k"))
m, g, R_3, U = (real_symbol(name) for name in ("m", "g", "R_3", "U"))
HALF = sp.Rational(1, 2)


@arguments_checked
def rolling_mechanism(rolling: RollingBody, name: str = "rolling-body") -> Mechanism:
    """The mechanism of a rolling body.

    Parameters
    ----------
    rolling : RollingBody
        Body, surface, contact model and field; the numbers become defaults of the parameters.
    name : str

    Returns
    -------
    Mechanism
        Its equations are those of :func:`nonholonomic.mechanics.rolling.equations.rolling_system`.

    Raises
    ------
    InputError
        As :func:`nonholonomic.mechanics.rolling.contact.contact`.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> mechanism = nonholonomic.rolling_mechanism(nonholonomic.RollingBody(ball, contact="rubber"))
    >>> nonholonomic.nonholonomy(mechanism).growth
    (2, 3, 5)
    """
    body, field = rolling.equivalent.body, rolling.field
    fluids = rolling.body.fluids
    kinematics = contact_of(body.shape, rolling.surface)
    # The rates of a frame must show their dependence on the velocities, so definitions that contain
    # ω are written out; those of the position alone stay names.
    place, moving = by_dependence(kinematics.definitions, omega.symbols)
    swinging = dict(flat_pairs(moving))
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    spin = inertia * omega
    kinetic = HALF * m * norm_squared(v) + HALF * dot(omega, spin)
    if any(body.gyrostat):
        kinetic = kinetic + dot(k, omega)
    kinetic = sp.Add(kinetic, *(fluid.kinetic_energy for fluid in fluids))
    rates = {
        n: constant([expand(part, swinging) for part in scalars(rate)]) if swinging else rate
        for n, rate in kinematics.state
    }
    potential: sp.Expr = sp.S.Zero
    relations = kinematics.relations
    if field.gravity and rolling.surface.is_flat:
        rates[R_3] = dot(gamma, v)
        potential = m * g * R_3
    elif field.gravity:
        rates[X] = cross(X, omega) + v
        rates[zeta] = cross(zeta, omega)
        verticals = rolling.surface.relations_of_vertical
        relations = (*relations, norm_squared(zeta) - 1, *verticals)
        potential = m * g * dot(X, zeta)
    constraints: tuple[sp.Basic, ...] = (v + cross(omega, kinematics.r),)
    if rolling.contact == "rubber":
        constraints += (dot(omega, gamma),)
    return Mechanism(
        name=name,
        title="Rolling body",
        frame=Frame(
            rates,
            (omega, v, *(fluid.xi for fluid in fluids)),
            relations,
            {**euclidean(omega, v), **_brackets(fluids)},
        ),
        lagrangian=kinetic - potential - field.potential,
        constraints=constraints,
        definitions=(*place, *(pair for fluid in fluids for pair in fluid.solid_inertia)),
        parameters=_parameters(rolling, inertia, kinematics.parameters),
        guards=tuple(_guard(guard, swinging) for guard in kinematics.guards),
        source="(1.9), (1.14), (1.15)",
    )


def _brackets(fluids: tuple[Fluid, ...]) -> StructureConstants:
    """Structure constants of ξ, opposite to those of ω: its axes are fixed outside the fluid."""
    return {
        pair: {s: -constant for s, constant in row.items()}
        for fluid in fluids
        for pair, row in rotations(fluid.xi).items()
    }


def _guard(guard: Guard, swinging: dict[sp.Symbol, sp.Expr]) -> Guard:
    return Guard(guard.name, expand(guard.scalar.value, swinging), guard.message, guard.lift_off)


def _parameters(
    rolling: RollingBody, inertia: Diagonal | Symmetric, of_contact: tuple[Parameter, ...]
) -> tuple[Parameter, ...]:
    body, field = rolling.equivalent.body, rolling.field
    parameters = [Parameter(m, "mass", body.mass, "kg", (m > 0,))]
    for s, value in zip(inertia.symbols, inertia.independent(body.tensor), strict=True):
        parameters.append(Parameter(s, "entry of the inertia tensor", float(value), "kg m^2"))
    if any(body.gyrostat):
        parameters += [
            Parameter(s, "gyrostatic momentum, body axes", x, "kg m^2/s")
            for s, x in zip(k.symbols, body.gyrostat, strict=True)
        ]
    parameters += [p for fluid in rolling.body.fluids for p in fluid.parameters]
    if field.gravity:
        parameters.append(Parameter(g, "acceleration of gravity", field.gravity, "m/s^2"))
    return (*parameters, *field.parameters, *of_contact)
