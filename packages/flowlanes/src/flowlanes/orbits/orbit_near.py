"""A periodic orbit near a motion, and the branch through it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..errors import InputError, RunError
from ..flow.kernel.equations import poincare_section
from ..flow.sections.poincare_map import PoincareMap
from ..formulas.array_evaluation import formula
from ..system.system import System
from .continuation import Branch, continue_orbit
from .periodic import Orbit, find_periodic
from .return_map import ReturnMap, parameters_to_state


def orbit_near(
    system: System,
    state: Sequence[float],
    t_end: float,
    where: tuple[str, float, int, bool],
    how: tuple[int, int, float],
    hold: Sequence[str] = (),
    followed_value: tuple[str, float] | None = None,
    progress: Callable[[float], None] = lambda share: None,
) -> tuple[Orbit, Branch | None]:
    """The periodic orbit found by Newton's method from a motion, and its branch.

    Parameters
    ----------
    system : System
        The system without its motion in space.
    state : sequence of float
        The initial state of the motion.
    t_end : float
        Time limit for each return.
    where : (str, float, int, bool)
        The section: quantity, value, direction (1 rising, −1 falling, 0 both), and whether the
        quantity is an angle.
    how : (int, int, float)
        Number of returns before the search, period of the orbit in returns, tolerance.
    hold : sequence of str
        Integrals whose values are fixed.
    followed_value : (str, float) or None
        Integral or parameter along which the orbit is continued, and its final value.
    progress : callable
        Called with the completed fraction.

    Raises
    ------
    InputError
        If section, integrals or parameter are invalid.
    RunError
        If the motion does not return, or no orbit is found.
    """
    (on, value, direction, angle), (after, period, tolerance) = where, how
    start = list(state)
    laws = [law.name for law in system.integrals]
    keeps = list(hold)
    if followed_value is not None and followed_value[0] not in laws:
        known = [str(parameter.symbol) for parameter in system.parameters]
        if followed_value[0] not in known:
            raise InputError(
                f"--follow {followed_value[0]}: it must be one of {', '.join((*laws, *known))}"
            )
        start.append(dict(system.default_values)[followed_value[0]])
        system = parameters_to_state(system, followed_value[0])
        keeps.append(followed_value[0])
    for name in hold:
        if name not in laws:
            raise InputError(f"--hold {name}: it must be one of {', '.join(laws) or 'none'}")
    progress(0.0)
    limit = t_end * max(after, 1)
    quantity = formula(system, on, "--on")
    section = poincare_section(system, quantity, value, direction, angle)
    returns = ReturnMap(PoincareMap(system, section, tolerance=tolerance, t_end=limit))
    crossed = returns.section.crossings(np.array([start]), max(after, 1))
    if crossed.outcome[0]:
        raise RunError(
            f"the motion does not return to {on} = {value:g} often enough: "
            f"{returns.section.status_message(int(crossed.outcome[0]))}",
            float(crossed.end_times[0]),
        )
    returns = ReturnMap(PoincareMap(system, section, tolerance=tolerance))
    progress(0.25)
    orbit = find_periodic(returns, crossed.states[0, -1], period, keeps)
    progress(1.0 if followed_value is None else 0.5)
    if followed_value is None:
        return orbit, None
    held = [name for name in keeps if name != followed_value[0]]
    return orbit, continue_orbit(returns, orbit, *followed_value, hold=held)


def orbit_facts(orbit: Orbit) -> dict[str, object]:
    """The data of an orbit, JSON-compatible."""
    multipliers = orbit.multipliers
    return {
        "period": orbit.duration,
        "returns": orbit.period,
        "kind": orbit.kind,
        "points": [
            dict(zip(orbit.names, map(float, point), strict=True)) for point in orbit.points
        ],
        "values": dict(orbit.values),
        "multipliers": [
            {"real": float(x.real), "imaginary": float(x.imag), "error": float(error)}
            for x, error in zip(multipliers.values, multipliers.errors, strict=True)
        ],
        "one_by_force": list(multipliers.trivial),
        "gap": orbit.gap,
        "error": orbit.error,
    }
