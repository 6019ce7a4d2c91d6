"""Motions transported by an isomorphism: states by its map, times by quadrature.

For closed forms on a torus see :mod:`.isomorphism`.  Here the motion is anything that gives states
at times: a closed form of another kind, or an integrated trajectory.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np
import sympy as sp
from numpy.polynomial import chebyshev

from flowlanes.arguments import NumberOrText, Numbers
from flowlanes.errors import InputError
from flowlanes.formulas.balls import array_function, number
from flowlanes.system.arrays import FloatArray
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.named_formulas import flat_pairs
from flowlanes.system.system import System

from .isomorphism import inverse

#: Maps times (n,) to states (n, size).
Motion: TypeAlias = Callable[[FloatArray], FloatArray]
RateAlongMotion: TypeAlias = Callable[[FloatArray], FloatArray]

#: Number of nodes per panel of time; largest relative size of the last coefficients.
_NODES, _TAIL = 24, 1e-13
#: Maximum number of halvings and of Newton steps; three or four of the latter suffice.
_HALVINGS, _STEPS = 80, 60
#: Fraction of the interval that is tried as the first panel.
_AHEAD = 0.1


@dataclass(frozen=True)
class IsomorphismMap:
    """An isomorphism with numerical parameters.

    Attributes
    ----------
    system : System
        The source of the isomorphism `law`; not lifted.
    law : Isomorphism
        With an explicit inverse, see :func:`nonholonomic.closed_form.isomorphism.inverse`.
    values : mapping of Symbol to number
        The parameters of `system`.

    Examples
    --------
    >>> import flowlanes
    >>> import nonholonomic
    >>> veselova = nonholonomic.from_catalogue("veselova")
    >>> law = next(law for law in veselova.laws if isinstance(law, flowlanes.Isomorphism))
    >>> onto = nonholonomic.closed_form.IsomorphismMap(veselova, law, veselova.defaults)
    >>> onto.law.target.name
    'veselova-on-e3'
    """

    system: System
    law: Isomorphism
    values: Mapping[sp.Symbol, NumberOrText]

    def _arrays(
        self, names: Sequence[sp.Symbol], formulas: Sequence[sp.Expr]
    ) -> Callable[[FloatArray], FloatArray]:
        fixed = [number(self.values[p.symbol]) for p in self.system.parameters]
        arguments = (*names, *(p.symbol for p in self.system.parameters))
        function = array_function(arguments, tuple(formulas))

        def on(states: Numbers) -> FloatArray:
            columns = np.asarray(states, dtype=float).T
            values = function(*columns, *fixed)
            return np.stack([np.broadcast_to(x, columns[0].shape) for x in values], axis=1)

        return on

    @cached_property
    def image(self) -> Callable[[FloatArray], FloatArray]:
        """Map states of the system (n, size) to states of the target."""
        formulas = [self.system.expand(f) for _, f in flat_pairs(self.law.map)]
        return self._arrays(self.system.symbols, formulas)

    @cached_property
    def preimage(self) -> Callable[[FloatArray], FloatArray]:
        """Map states of the target (n, size) that are images back to states of the system."""
        formulas = inverse(self.system, self.law)
        names = [s for s, _ in flat_pairs(self.law.map)]
        return self._arrays(names, [formulas[s] for s in self.system.symbols])

    @cached_property
    def rate(self) -> Callable[[FloatArray], FloatArray]:
        """dτ/dt at states of the system, (n,)."""
        formula = self.system.expand(self.law.time)
        on = self._arrays(self.system.symbols, [formula])
        return lambda states: on(states)[:, 0]

    def target_parameters(self, state: Numbers) -> dict[sp.Symbol, float]:
        """The target's parameters for the motion through a state (size,) of the system."""
        names = [p for p, _ in self.law.constants]
        formulas = [self.system.expand(f) for _, f in self.law.constants]
        values = self._arrays(self.system.symbols, formulas)(np.asarray(state)[None, :])[0]
        constants = dict(zip(names, map(float, values), strict=True))
        shared = {p.symbol for p in self.law.target.parameters} - set(constants)
        return {s: number(self.values[s]) for s in shared if s in self.values} | constants

    def target_motion(self, motion: Motion, times: Numbers) -> FloatArray:
        """The target's motion at its times τ (n,), from a motion of the system; both start at 0."""
        moments = _moments(lambda t: self.rate(motion(t)), times)
        return self.image(motion(moments))

    def system_motion(self, motion: Motion, times: Numbers) -> FloatArray:
        """The system's motion at times t (n,), from one of the target; both start at 0."""
        moments = _moments(lambda tau: 1 / self.rate(self.preimage(motion(tau))), times)
        return self.preimage(motion(moments))


def _moments(rate: RateAlongMotion, values: Numbers) -> FloatArray:
    """The s ≥ 0 at which ∫₀ˢ rate ds has given nonnegative values."""
    goals = np.atleast_1d(np.asarray(values, dtype=float))
    if np.any(goals < 0):
        raise InputError("times: a motion is carried forward from time 0; none may be negative")
    moments = np.zeros_like(goals)
    # Initially a fraction of the interval, estimated from the rate at the start.
    left, done, width = 0.0, 0.0, _AHEAD * float(np.max(goals) / rate(np.zeros(1))[0])
    open_ = goals > 0
    while open_.any():
        slope, width = _panel(rate, left, width)
        whole = np.asarray(chebyshev.chebint(slope, lbnd=-1, scl=width / 2), dtype=float)
        total = float(chebyshev.chebval(1.0, whole))
        here = open_ & (goals <= done + total)
        moments[here] = left + width / 2 * (1 + _roots(slope, whole, goals[here] - done, width))
        open_ &= ~here
        left, done, width = left + width, done + total, 1.5 * width
    return moments


def _panel(rate: RateAlongMotion, left: float, width: float) -> tuple[FloatArray, float]:
    """Coefficients of the rate on a panel narrow enough to resolve it, and its width."""
    nodes = chebyshev.chebpts1(_NODES)
    for _ in range(_HALVINGS):
        values = rate(left + width / 2 * (1 + nodes))
        slope = np.asarray(chebyshev.chebfit(nodes, values, _NODES - 1), dtype=float)
        if np.max(np.abs(slope[-3:])) <= _TAIL * np.max(np.abs(slope)):
            return slope, width
        width /= 2
    raise InputError("the rate of the new time is not smooth along this motion")


def _roots(slope: FloatArray, whole: FloatArray, goals: FloatArray, width: float) -> FloatArray:
    """The x in [−1, 1] at which the increasing integral has given values."""
    x: FloatArray = np.clip(2 * goals / chebyshev.chebval(1.0, whole) - 1, -1, 1)
    for _ in range(_STEPS):
        miss = chebyshev.chebval(x, whole) - goals
        step = miss / (width / 2 * chebyshev.chebval(x, slope))
        x = np.clip(x - step, -1, 1)
        if np.all(np.abs(step) < 1e-15):
            break
    return x
