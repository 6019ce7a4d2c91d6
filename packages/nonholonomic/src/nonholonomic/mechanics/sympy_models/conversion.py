"""Conversion of models made with `sympy.physics.mechanics`.

`KanesMethod`, `LagrangesMethod` and `System` objects of SymPy become a System of this package, for
integration, linearisation and the search for integrals, or a `Mechanism`, for questions of
nonholonomy, invariant measure and reduction. Functions of time become plain symbols of the same
name (`q1(t)` is ``q1``, its rate ``q1dot``), constants become parameters.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp
from sympy.physics.mechanics import (
    KanesMethod,
    LagrangesMethod,
    Lagrangian,
    System as SympySystem,
    dynamicsymbols,
)

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol

from ..lagrangian.mechanism import Mechanism, coordinates
from ..lagrangian.poincare_suslov import equations_of_motion
from .kane import Kane, kane
from .names import Defaults, Inputs, name_translation

NOTHING: Mapping[Any, Any] = {}


@arguments_checked
def from_sympy(
    model: Any,
    parameters: Mapping[Any, Any] = NOTHING,
    *,
    inputs: Mapping[Any, Any] = NOTHING,
    name: str = "imported",
    title: str = "",
) -> System:
    """A SymPy mechanics model as a System.

    Parameters
    ----------
    model : KanesMethod, LagrangesMethod or System of sympy.physics.mechanics
        It is not changed. A `System` is converted by the method that formed its equations; if there
        is none, by Lagrange's method if its speeds are the rates of its coordinates, by Kane's
        method otherwise.
    parameters : mapping of Symbol or name to number or Parameter
        A default for every constant of the model.
    inputs : mapping of function of time or name to Expr
        Formulas for functions of time that are neither coordinates nor speeds (a torque, a
        driven angle), in the time, coordinates, speeds and constants.
    name, title : str

    Returns
    -------
    System
        State: coordinates and speeds.  Relations: the configuration and velocity constraints.
        Multipliers are definitions and observables ``lambda_1``, …; those of a `LagrangesMethod`
        have the sign opposite to SymPy's.

    Raises
    ------
    InputError
        If the object is of another kind or not ready, if a constant has no default, or if its
        constraints depend on each other.

    Examples
    --------
    >>> import nonholonomic
    >>> import sympy as sp
    >>> from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols
    >>> theta, (g, l) = dynamicsymbols("theta"), sp.symbols("g l")
    >>> lagrangian = l**2 * theta.diff() ** 2 / 2 + g * l * sp.cos(theta)
    >>> pendulum = nonholonomic.from_sympy(LagrangesMethod(lagrangian, [theta]), {g: 9.81, l: 1.0})
    >>> dict(pendulum.field)
    {theta: thetadot, thetadot: -g*sin(theta)/l}
    """
    translation = _translation(model, parameters, inputs, name, title or name)
    return (
        translation.system() if isinstance(translation, Kane) else equations_of_motion(translation)
    )


@arguments_checked
def mechanism_from_sympy(
    model: Any,
    parameters: Mapping[Any, Any] = NOTHING,
    *,
    inputs: Mapping[Any, Any] = NOTHING,
    name: str = "imported",
    title: str = "",
) -> Mechanism:
    """A SymPy mechanics model as a mechanism: frame, Lagrangian, forces, constraints.

    A `LagrangesMethod` has all of these. A model of Kane's method has a kinetic energy and active
    forces; they define a mechanism if Lagrange's equations agree with Kane's. They differ if a
    constraint was built into the velocities of points (a contact point at rest).

    Parameters
    ----------
    model, parameters, inputs, name, title
        As of :func:`from_sympy`.

    Returns
    -------
    Mechanism

    Raises
    ------
    InputError
        As :func:`from_sympy`, and if Lagrange's equations of a model of Kane's method differ from
        Kane's.

    Examples
    --------
    >>> import lawproof
    >>> import nonholonomic
    >>> import sympy as sp
    >>> from sympy.physics.mechanics import LagrangesMethod, dynamicsymbols
    >>> theta, (g, l) = dynamicsymbols("theta"), sp.symbols("g l")
    >>> lagrangian = l**2 * theta.diff() ** 2 / 2 + g * l * sp.cos(theta)
    >>> pendulum = nonholonomic.mechanism_from_sympy(
    ...     LagrangesMethod(lagrangian, [theta]), {g: 9.81, l: 1.0}
    ... )
    >>> lawproof.prove(nonholonomic.equations_of_motion(pendulum), "energy").decision
    'proven'
    """
    translation = _translation(model, parameters, inputs, name, title or name)
    if not isinstance(translation, Kane):
        return translation
    mechanism = translation.mechanism()
    translation.require_same_motion(mechanism)
    return mechanism


def _translation(
    model: object,
    parameters: Defaults,
    inputs: Inputs,
    name: str,
    title: str,
) -> Kane | Mechanism:
    if isinstance(model, SympySystem):
        model = _method(model, name)
    if isinstance(model, KanesMethod):
        return kane(model, name, title, parameters, inputs)
    if isinstance(model, LagrangesMethod):
        return _lagrange(model, name, title, parameters, inputs)
    raise InputError(
        f"{name}: {type(model).__name__} is no model that can be taken in; allowed: KanesMethod, "
        "LagrangesMethod and System of sympy.physics.mechanics"
    )


def _method(model: SympySystem, name: str) -> KanesMethod | LagrangesMethod:
    """The method of a SymPy `System`, without forming its equations in place."""
    if isinstance(model.eom_method, (KanesMethod, LagrangesMethod)):
        return model.eom_method
    if not model.bodies:
        raise InputError(f"{name}: the System object has no bodies")
    loads = [*model.loads, *(load for part in model.actuators for load in part.to_loads())]
    if all(u in list(model.q.diff(dynamicsymbols._t)) for u in model.u):
        return LagrangesMethod(
            Lagrangian(model.frame, *model.bodies),
            model.q,
            forcelist=loads,
            bodies=model.bodies,
            frame=model.frame,
            hol_coneqs=model.holonomic_constraints,
            nonhol_coneqs=model.nonholonomic_constraints,
        )
    try:
        model.validate_system()
    except ValueError as mistake:
        raise InputError(f"{name}: {' '.join(str(mistake).split())}") from None
    return KanesMethod(
        model.frame,
        q_ind=model.q_ind,
        u_ind=model.u_ind,
        kd_eqs=model.kdes,
        q_dependent=model.q_dep,
        u_dependent=model.u_dep,
        configuration_constraints=model.holonomic_constraints,
        velocity_constraints=model.velocity_constraints,
        u_auxiliary=model.u_aux,
        forcelist=loads or None,
        bodies=model.bodies,
    )


def _lagrange(
    model: LagrangesMethod,
    name: str,
    title: str,
    parameters: Defaults,
    inputs: Inputs,
) -> Mechanism:
    if model.forcelist and model.inertial is None:
        raise InputError(f"{name}: the LagrangesMethod object has loads but no inertial frame")
    q = list(model.q)
    rates = [x.diff(dynamicsymbols._t) for x in q]
    positions = list(model._hol_coneqs)
    constraints = list(model.coneqs)[len(positions) :]
    forces = [_generalised_force(model, rate) for rate in rates]
    plain = {rate: real_symbol(f"{x.func}dot") for x, rate in zip(q, rates, strict=True)}
    formulas = [*model._L, *positions, *constraints, *forces]
    words = name_translation(name, formulas, q, plain, parameters, inputs)
    frame = coordinates(*map(words, q))
    acting = {s: words(f) for s, f in zip(frame.w, forces, strict=True) if f != 0}
    return Mechanism(
        name=name,
        title=title,
        frame=frame,
        lagrangian=words(model._L[0]),
        constraints=tuple(words.all(constraints)),
        positions=tuple(words.all(positions)),
        forces=acting,
        parameters=words.parameters,
        source="SymPy, Lagrange's method",
    )


def _generalised_force(model: LagrangesMethod, rate: sp.Expr) -> sp.Expr:
    """The generalised force of the loads, Σ F·∂v/∂q̇ over points and Σ τ·∂ω/∂q̇ over frames."""
    total = sp.S.Zero
    for place, load in model.forcelist:
        moves = place.ang_vel_in if hasattr(place, "ang_vel_in") else place.vel
        velocity = moves(model.inertial)
        total += velocity.diff(rate, model.inertial, var_in_dcm=False).dot(load)
    return total
