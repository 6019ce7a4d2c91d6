"""Initial states, of whatever moves and from whatever is known of it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping
from typing import Any, TypeAlias

import mpmath

from flowlanes.arguments import Parameters, arguments_checked
from flowlanes.errors import InputError, nearest
from flowlanes.flow.initial_states import whole_start
from flowlanes.system.matrices import Column
from flowlanes.system.system import System

from .contact.equations.situation import FrictionalContact
from .contact.starts import state_in_contact, state_in_space
from .control.start import driven_state, is_driven
from .mechanics.ball.ball import RollingBall
from .mechanics.ball.initial_state import ball_state
from .mechanics.rolling.equations import RollingBody
from .mechanics.rolling.initial_state import rolling_state

#: What is known of a start, by name.
Known: TypeAlias = Mapping[str, Any]

#: What may be known of a rolling body besides ω and γ.
_OF_ROLLING = ("heading", "normal", "fluid")


@arguments_checked
def initial_state(
    model: System | RollingBody | RollingBall | FrictionalContact,
    omega: Any = None,
    gamma: Any = None,
    *,
    parameters: Parameters = None,
    **known: Any,
) -> tuple[Any, ...]:
    """The state at which a motion begins, from what is known of it.

    Every model gives the same kind of result, which :func:`flowlanes.integrate`,
    :func:`nonholonomic.solve`, ensembles and :func:`nonholonomic.contact.contact_motion` take.

    Parameters
    ----------
    model : System, RollingBody, RollingBall or FrictionalContact
        What moves.
    omega : numbers, optional
        Angular velocity (rad/s): body axes, and space axes of a `RollingBall`.
    gamma : numbers, optional
        Outward normal of the supporting surface at the contact, or vertical, body axes; of any
        length but zero.
    parameters : mapping of Symbol or name to number, optional
        Values that replace the defaults of a system.
    **known
        By name, what else is known:

        of a rolling body
            ``heading`` (rad), the angle by which the body is turned about the normal, from the
            attitude that takes γ to the normal along the shortest way; ``normal``, the normal in
            space axes, (0, 0, 1) on a plane; ``fluid``, the motion ξ of the fluid in a cavity
            relative to the body (rad/s), whose velocity there is A(ξ×A⁻¹x), or one for each of
            several cavities.
        of a `RollingBall`
            ``place``, the contact point if the surface carries the ball, and the centre if that
            moves on the surface.
        of a `FrictionalContact` that touches its support
            ``slip`` (m/s), the velocity of the touching particle of the body over the support,
            body axes; ``heading`` and ``normal``.
        of a `FrictionalContact` anywhere
            ``position`` of the centre of mass (m) and its ``velocity`` (m/s), space axes; the
            quaternion ``attitude`` from body to space axes; ω.
        of a driven ball
            the values of its joints, and the time ``t`` at which speeds are taken (s).
        of any system
            the variables of its state.

    Returns
    -------
    tuple of mpmath.mpf
        In flat order, that of ``system.lifted().symbols`` if the system has a motion in space; of a
        `FrictionalContact` with no work lost.  Of bodies that roll it has 50 digits, and 0.1 means
        one tenth; a contact point starts above or below the origin of space.  Others are doubles.

    Raises
    ------
    InputError
        If something is missing, unknown or of a wrong size; if a direction is zero or outside the
        domain of the equations; or if ω breaks a constraint, such as (ω, γ) = 0 of a rubber
        contact: the message then names the nearest admissible one.

    Examples
    --------
    >>> import nonholonomic
    >>> body = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
    >>> ball = nonholonomic.rolling_system(body)
    >>> start = nonholonomic.initial_state(ball, omega=(1, 0, 2), gamma=(0, 0, 1))
    >>> [float(x) for x in start[:6]]
    [1.4, 0.0, 1.2, 0.0, 0.0, 1.0]
    >>> start = nonholonomic.initial_state(ball, M=(1.4, 0, 1.2), gamma=(0, 0, 1))
    >>> [float(x) for x in start[6:]]  # attitude and place
    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]

    A ball that slips, one above the floor, and one in a hollow sphere:

    >>> from nonholonomic.contact import Coulomb, FrictionalContact
    >>> sliding = FrictionalContact(body, laws=(Coulomb(0.2),))
    >>> start = nonholonomic.initial_state(sliding, (0, 1, 0), (0, 0, 1), slip=(2, 0, 0))
    >>> [float(x) for x in start[7:10]]  # velocity of the centre of mass
    [3.0, 0.0, 0.0]
    >>> start = nonholonomic.initial_state(
    ...     sliding,
    ...     position=(0, 0, 3),
    ...     attitude=(1, 0, 0, 0),
    ...     velocity=(1, 0, 0),
    ...     omega=(0, 0, 2),
    ... )
    >>> [float(x) for x in start[13:16]]
    [0.0, 0.0, 1.0]
    >>> sphere = nonholonomic.mechanics.ball.SphericalSurface(2.0)
    >>> ball = nonholonomic.RollingBall(mass=1.0, inertia=0.1, radius=0.5, surface=sphere)
    >>> len(nonholonomic.initial_state(ball, omega=(1, 0, 0), place=(0, 0, 2)))
    10
    """
    given = {name: x for name, x in (("omega", omega), ("gamma", gamma)) if x is not None} | known
    match model:
        case FrictionalContact():
            _require_no_parameters(parameters)
            return _numbers(_contact_state(model, given))
        case RollingBall():
            _require_no_parameters(parameters)
            return _numbers(_applied(ball_state, model, given, ("place", "omega")))
        case RollingBody():
            return initial_state(model.system(), omega, gamma, parameters=parameters, **known)
    if omega is not None and gamma is not None:
        if is_driven(model):
            _require_no_parameters(parameters)
            named = driven_state(model, omega, gamma, known)
            return _numbers(whole_start(model, named))
        flat = not any(isinstance(v, Column) for v in model.state if str(v) == "gamma")
        if flat and known.keys() <= set(_OF_ROLLING):
            return rolling_state(model, omega, gamma, parameters=parameters, **known)
    return _numbers(whole_start(model, given, parameters))


def _contact_state(contact: FrictionalContact, given: Known) -> Iterable[Any]:
    """The state of a body with friction, in contact or anywhere."""
    if "position" in given:
        needed = ["position", "attitude", "velocity", "omega"]
        return _applied(state_in_space, contact, given, needed)
    others = ["slip", "heading", "normal"]
    return _applied(state_in_contact, contact, given, ["omega", "gamma"], others)


def _applied(
    state: Callable[..., Iterable[Any]],
    model: Any,
    given: Known,
    needed: Collection[str],
    others: Collection[str] = (),
) -> Iterable[Any]:
    """The state of a model from what is given, whose names are checked."""
    for name in given:
        if name not in (*needed, *others):
            raise InputError(f"{name}: unknown{nearest(name, (*needed, *others))}")
    if missing := [name for name in needed if name not in given]:
        raise InputError(f"the start gives no {', '.join(missing)}")
    return state(model, **given)


def _require_no_parameters(parameters: Parameters) -> None:
    if parameters:
        raise InputError("parameters: this model has its numbers itself; leave them out")


def _numbers(state: Iterable[Any]) -> tuple[mpmath.mpf, ...]:
    """Numbers as those of mpmath; doubles keep their value."""
    return tuple(x if isinstance(x, mpmath.mpf) else mpmath.mpf(float(x)) for x in state)
