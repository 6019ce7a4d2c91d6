"""Closed forms beside integration: starts on the phase space to 34 digits, and what both give."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import mpmath
import numpy as np

from flowlanes.flow.integrator import integrate
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem
from nonholonomic.closed_form.genus_two_solution import GenusTwo, solve_on_torus
from nonholonomic.starts import initial_state

#: A body with nothing special about it.
GAMMA = np.array([0.48, 0.6, 0.64])
OMEGA = np.array([0.5, 1.1, -0.7])


def unit(vector: Any) -> Any:
    """A vector of length one."""
    return np.asarray(vector, dtype=float) / np.linalg.norm(vector)


def without(vector: Any, normal: Any, weights: Any = 1.0) -> Any:
    """What is left of a vector when its part along `normal` makes (vector, weights normal) zero."""
    dual = weights * normal
    return vector - normal * (vector @ dual) / (normal @ dual)


def solution(
    of: SeparatedSystem, omega: Any, gamma: Any, parameters: Mapping[str, Any] | None = None
) -> GenusTwo:
    """The closed form through ω and γ."""
    values = dict(of.system.defaults)
    values |= {s: (parameters or {}).get(str(s), x) for s, x in values.items()}
    start = initial_state(of.system, tuple(map(float, omega)), tuple(map(float, gamma)))
    return solve_on_torus(of, values, start)


def miss(made: GenusTwo, times: Sequence[float]) -> Any:
    """The greatest difference from a 34-digit integration, at each time but the first."""
    system = made.separable.system
    with mpmath.workdps(40):
        reduced = [mpmath.mpf(x.mid().str(40, radius=False)) for x in made.separated_motion.state]
        start = [*reduced, *made.start[len(reduced) :]]
        motion = integrate(
            system, start, [0.0, *times], parameters=made.parameters, precision="quad"
        )
    other = np.array(motion.states, dtype=float)[1:]
    return np.max(np.abs(made.states(np.array(times)) - other), axis=1)
