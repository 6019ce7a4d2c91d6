"""A System compiled by heyoka for Taylor integration with 34 digits."""

from __future__ import annotations

import copy
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import heyoka as hy
import numpy as np
import sympy as sp

from ...system.system import System
from .heyoka_expressions import Translator
from .state_series import Step
from .working_numbers import Direction, WorkingArray, WorkingNumber

# heyoka prints warnings directly to the terminal, outside Python; its errors contain the same
# information.
hy.set_logger_level_error()

# Outcomes of a step: failures are below these values, events above.
_SUCCESS, _LIMIT = -4294967297, -4294967299


@dataclass(frozen=True)
class HeyokaFormulas:
    """Formulas as one function compiled by heyoka.

    Attributes
    ----------
    function : heyoka.cfunc
        Function of the formulas and of an additional formula that is ignored.
    """

    function: hy.cfunc

    def __call__(self, states: WorkingArray, parameters: WorkingArray) -> WorkingArray:
        """Values (m,) or (m, n) at states (size,) or (size, n)."""
        # heyoka expects the parameters up to the last one that occurs in the formulas.
        values = parameters[: self.function.nparams]
        if states.ndim == 2:
            values = np.repeat(values[:, None], states.shape[1], axis=1)
        result: WorkingArray = self.function(np.ascontiguousarray(states), pars=values)
        return result[:-1]


class HeyokaSeries:
    """State that advances by steps of its Taylor series.

    Like :class:`~flowlanes.flow.taylor.state_series.TaylorSeries`, with 34 digits.

    Parameters
    ----------
    integrator : heyoka.taylor_adaptive
    """

    def __init__(self, integrator: hy.taylor_adaptive) -> None:
        # A copy, because steps change it and the code is shared.
        self._integrator = copy.copy(integrator)
        self.order: int = integrator.order

    @property
    def state(self) -> WorkingArray:
        """State (size,); it may be changed in place."""
        state: WorkingArray = self._integrator.state
        return state

    @property
    def parameters(self) -> WorkingArray:
        """Parameters in use; they may be changed in place."""
        parameters: WorkingArray = self._integrator.pars
        return parameters

    @property
    def series(self) -> WorkingArray:
        """Coefficients (size, order + 1) of the powers of time since the start of the last step."""
        series: WorkingArray = self._integrator.tc
        return series

    @property
    def time(self) -> WorkingNumber:
        """Time; it can be set."""
        return self._integrator.time

    @time.setter
    def time(self, value: WorkingNumber) -> None:
        self._integrator.time = value

    def copy(self) -> HeyokaSeries:
        """Copy that advances independently with the same code."""
        return HeyokaSeries(self._integrator)

    def reset(self) -> None:
        """Reset the events of the last step."""
        self._integrator.reset_cooldowns()

    def step(self, limit: WorkingNumber) -> Step:
        """Make one step, not longer than `limit`."""
        outcome, length = self._integrator.step(max_delta_t=limit, write_tc=True)
        code = int(outcome)
        if code > _SUCCESS:
            return Step(float(length), -code - 1 if code < 0 else code)
        return Step(float(length), is_failure=code not in (_SUCCESS, _LIMIT))

    def state_at(self, time: WorkingNumber) -> WorkingArray:
        """State at a time within the last step."""
        self._integrator.update_d_output(time)
        state: WorkingArray = self._integrator.d_output
        return state


@dataclass(frozen=True)
class HeyokaCode:
    """Code compiled by heyoka for a system; it can be stored on disk.

    Attributes
    ----------
    integrator : heyoka.taylor_adaptive
    functions : dict of str to heyoka.cfunc
    """

    integrator: hy.taylor_adaptive
    functions: dict[str, hy.cfunc]


def heyoka_code(
    system: System,
    formulas: Mapping[str, Sequence[sp.Expr]],
    variable_guards: Sequence[int],
    tolerance: float,
    direction: Direction,
) -> HeyokaCode:
    """Compile a system with 34 digits.

    Parameters
    ----------
    system : System
        System with its motion in space.
    formulas : mapping of str to sequence of Expr
        Formulas to be compiled as functions.
    variable_guards : sequence of int
        Guards that are terminal events, each with a factor after the parameters.
    tolerance : float
    direction : ``"forward"`` or ``"backward"``
        Direction of time.
    """
    kind = hy.real128
    translate = Translator(system)
    variables = translate.variables
    guards = translate.all([guard.value for guard in system.guards])
    # heyoka tests the derivative with respect to time, for any direction of integration.
    falling = {
        "forward": hy.event_direction.negative,
        "backward": hy.event_direction.positive,
    }[direction]
    first = len(system.parameters)
    integrator = hy.taylor_adaptive(
        list(zip(variables, translate.all(system.rates), strict=True)),
        [kind(1)] * len(variables),
        tol=kind(tolerance),
        fp_type=kind,
        t_events=[
            hy.t_event(guards[i] * hy.par[first + place], direction=falling, fp_type=kind)
            for place, i in enumerate(variable_guards)
        ],
        compact_mode=True,
    )
    # A variable is added, because lists must not be empty.
    functions = {
        name: hy.cfunc([*translate.all(items), variables[0]], variables, fp_type=kind)
        for name, items in formulas.items()
    }
    return HeyokaCode(integrator, functions)
