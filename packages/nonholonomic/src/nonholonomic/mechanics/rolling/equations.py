"""Equations of motion of a rigid body rolling on a plane or a sphere.

Newton's and Euler's equations with the contact force N at the contact point r and, for a rubber
body, the torque λ₀γ about the normal (§1.3),

    m (v̇ + ω×v) = N + F,      I ω̇ + ω×(I ω + k) = r×N + τ + λ₀ γ,      v = r×ω,

hold for every shape and surface.  Without N they read, in the momentum M = Iω + m r×(ω×r) about
the contact point,

    Ṁ = (M + k)×ω + m ṙ×(ω×r) − r×F + τ + λ₀ γ.

Fluid in a cavity of the body adds to M and has an equation of its own; see
:mod:`nonholonomic.mechanics.rolling.fluid` and
:mod:`nonholonomic.mechanics.rolling.contact_models`. The kinematics depends on shape and surface;
see :mod:`nonholonomic.mechanics.rolling.contact`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.arguments import FormulaParameters, arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.named_formulas import by_name
from flowlanes.system.system import Parameter, System
from flowlanes.system.vector_operators import gradient
from flowlanes.system.vectors import (
    Diagonal,
    Symmetric,
    Vector,
    cross,
    dot,
    identity,
    real_symbol,
    zero,
)

from ..formula_parameters import formula_parameters
from ..shapes.surfaces import Plane, Surface
from .body import AnyBody, body_parameters, equivalent_body
from .contact import contact as contact_of
from .contact_models import Balance, marble, rubber

ContactModel = Literal["marble", "rubber"]

gamma, k = Vector("gamma"), Vector("k")
m, g, U = (real_symbol(name) for name in ("m", "g", "U"))


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
    parameters : mapping of str or Symbol to float, or sequence of Parameter
        Further symbols in `potential`, with their values.

    Raises
    ------
    InputError
        If gravity is negative, or a symbol of `potential` has no value.

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> import sympy as sp
    >>> gamma_3, k = sp.symbols("gamma_3 k")
    >>> spring = nonholonomic.Forces(potential=k * gamma_3**2 / 2, parameters={k: 0.1})
    >>> ball = nonholonomic.rolling_system(
    ...     nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0)), field=spring
    ... )
    >>> [(verdict.law, verdict.decision) for verdict in lawproof.prove_all(ball)]
    [('energy', 'proven')]
    """

    gravity: float = 0.0
    potential: sp.Expr = sp.S.Zero
    parameters: FormulaParameters = ()

    def __post_init__(self) -> None:
        declared = formula_parameters(self.parameters, "parameter of the potential", "SI")
        object.__setattr__(self, "parameters", declared)
        if not (np.isfinite(self.gravity) and self.gravity >= 0):
            raise InputError(f"gravity {self.gravity}: it must be finite and not negative")


@arguments_checked
@dataclass(frozen=True)
class RollingBody:
    """A body, a surface, a contact model and forces, with their numerical values.

    Parameters
    ----------
    body : Body
    surface : Surface
    contact : "marble" or "rubber"
        Rolling with or without spinning about the normal of the contact.
    field : Forces

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(
    ...     1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0, centre=(0.0, 0.0, 0.1))
    ... )
    >>> rolling = nonholonomic.RollingBody(ball, nonholonomic.Plane(), "rubber")
    >>> nonholonomic.invariant_measure(rolling).decision
    'none'
    """

    body: AnyBody
    surface: Surface = Plane()  # noqa: RUF009  (immutable)
    contact: ContactModel = "marble"
    field: Forces = Forces()

    @property
    def equivalent(self) -> RollingBody:
        """The same rolling body with the equivalent rigid body in place of body and fluid.

        The fluid is then in potential flow (Zhukovsky); a body without fluid stays as it is.
        """
        return replace(self, body=equivalent_body(self.body))

    @arguments_checked
    def system(self, name: str = "rolling-body", title: str = "Rolling body") -> System:
        """The equations of motion; see :func:`rolling_system`."""
        return rolling_system(self.body, self.surface, self.contact, self.field, name, title)


@arguments_checked
def rolling_system(
    body: AnyBody,
    surface: Surface = Plane(),  # noqa: B008  (immutable)
    contact: ContactModel = "marble",
    field: Forces = Forces(),
    name: str = "rolling-body",
    title: str = "Rolling body",
) -> System:
    """The equations of motion of a body that rolls on a surface.

    Parameters
    ----------
    body : Body
        Mass, inertia, shape, gyrostat and cavities; its numbers become the defaults of the
        parameters.  A centre offset or gyrostat that is exactly zero is left out of the equations.
        With fluid the parameters m, I and c are those of the equivalent rigid body.
    surface : Surface
        The supporting surface.
    contact : ``"marble"`` or ``"rubber"``
        No slip; or no slip and no spin about the normal, (ω, γ) = 0.
    field : Forces
        Gravity and a potential U(γ).
    name, title : str
        Identifier and display title.

    Returns
    -------
    System
        State M, γ (marble) or ω, γ (rubber), in body axes; r instead of γ for an implicit shape;
        and ζ, the vertical in body axes, under gravity on a sphere; and the circulation vector N
        of a fluid (N1, N2, … of several).  It carries the energy
        integral, the contact force as observables, its domain as guards, and the motion in space.

    Raises
    ------
    InputError
        If the contact model is unknown or the potential uses an unknown symbol.

    Examples
    --------
    >>> import nonholonomic
    >>> ball = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> system = nonholonomic.rolling_system(ball, nonholonomic.Plane(), "marble")
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
    build = marble if contact == "marble" else rubber
    return build(balance, surface, name, title)


# --- forces and tensors --------------------------------------------------------------------


def _balance(whole: AnyBody, surface: Surface, field: Forces) -> Balance:
    body = equivalent_body(whole)
    kinematics = contact_of(body.shape, surface)
    inertia = Diagonal("I") if body.principal else Symmetric("I")
    of_fluids = tuple(p for fluid in whole.fluids for p in fluid.parameters)
    parameters = body_parameters(body, inertia) + of_fluids + kinematics.parameters
    r, rotors = kinematics.r, k if any(body.gyrostat) else zero

    # the inverse of I + m r² − m r⊗r, by Sherman and Morrison from the one of J = I + m r²
    J, A = type(inertia)("J"), type(inertia)("A")
    definitions = (
        *kinematics.definitions,
        (J, inertia + m * kinematics.square * identity),
        (A, J**-1),
    )

    def solve(vector: MatrixExpr) -> MatrixExpr:
        lever = A * r
        share = m * dot(lever, vector) / (1 - m * dot(r, lever))
        return A * vector + share * lever

    vertical = surface.vertical
    force, energy, torque = zero, sp.S.Zero, zero
    if field.gravity:
        parameters += (Parameter(g, "acceleration of gravity", field.gravity, "m/s^2", (g >= 0,)),)
        force = -m * g * vertical
        energy = m * g * surface.height(r, kinematics.height)
    if field.potential != 0:
        parameters += field.parameters
        potential = by_name(field.potential, (*gamma.symbols, *(p.symbol for p in parameters)))
        _check_potential(potential, parameters)
        definitions += ((U, potential),)
        energy = energy + U
        # γ̇ = P(γ×ω) gives U̇ = (∂U/∂γ, γ̇) = −(γ×Pᵀ∂U/∂γ, ω), so that this torque has the power
        # −U̇
        torque = cross(gamma, kinematics.pull(gradient(potential, gamma)))
    return Balance(
        kinematics=kinematics,
        definitions=definitions,
        inertia=inertia,
        solve=solve,
        force=force,
        torque=torque,
        rotors=rotors,
        energy=energy,
        parameters=parameters,
        vertical=vertical,
        fluids=whole.fluids,
    )


def _check_potential(potential: sp.Expr, parameters: tuple[Parameter, ...]) -> None:
    allowed = [str(p.symbol) for p in parameters]
    unknown = potential.free_symbols - set(gamma.symbols) - {p.symbol for p in parameters}
    if unknown:
        raise InputError(
            f"potential {potential}: {', '.join(sorted(map(str, unknown)))} is not known; it may "
            f"use gamma_1, gamma_2, gamma_3 and {', '.join(allowed)}"
        )
