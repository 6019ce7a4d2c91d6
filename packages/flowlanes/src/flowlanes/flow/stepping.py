"""One motion, advanced from call to call: for control loops and other programs that ask often.

A call of :class:`~flowlanes.flow.batch.BatchIntegrator` reads its arguments, checks the start and
makes arrays for its results, which together cost more than the steps of a short motion.  A stepper
does this once: every call writes a state and the inputs into memory that the machine code knows,
runs it, and copies the new state out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import sympy as sp

from ..arguments import Parameters, arguments_checked
from ..errors import InputError, RunError
from ..formulas.array_evaluation import as_float_array, parameter_rows, relation_terms
from ..system.arrays import FloatArray
from ..system.system import System
from ..system.tolerance import ENSEMBLE_TOLERANCE
from .batch import batch_integrator
from .cost import MOST_STEPS
from .devices.batch_arrays import BatchInput
from .devices.processor import PreparedCall, ProcessorLoop
from .kernel.outcomes import outcome_message
from .validation import check_state_shape, require_on_phase_space


class Stepper:
    """The flow of a system over short times; see :func:`stepper`.

    A stepper has memory of its own for one motion: use one for each thread.

    Attributes
    ----------
    system : System
    inputs : tuple of str
        Names of the parameters that a call may change.
    tolerance : float

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v = sp.symbols("x v", real=True)
    >>> oscillator = flowlanes.System("oscillator", "Oscillator", {x: v, v: -x})
    >>> flowlanes.flow.stepper(oscillator)
    <Stepper of oscillator: tolerance 1e-13>
    """

    def __init__(
        self, system: System, inputs: tuple[str, ...], tolerance: float, parameters: FloatArray
    ) -> None:
        loops = tuple(
            batch_integrator(system, tolerance=tolerance, backward=backward).loop
            for backward in (False, True)
        )
        names = [str(p.symbol) for p in system.parameters]
        self.system = system
        self.inputs = inputs
        self.tolerance = tolerance
        self._places = np.array([names.index(name) for name in inputs], dtype=int)
        self._start = np.zeros((1, len(system.symbols), 1))
        self._constants = np.ascontiguousarray(parameters.reshape(1, -1, 1))
        self._duration = np.zeros(1)
        task = BatchInput(
            self._start, self._constants, self._duration, 1, tolerance, MOST_STEPS, self._start.size
        )
        self._forward, self._backward = (
            PreparedCall(loop, task) for loop in loops if isinstance(loop, ProcessorLoop)
        )
        self._relations = relation_terms(system)
        self._last: npt.ArrayLike | None = None

    def __reduce__(self) -> tuple[type[Stepper], tuple[object, ...]]:
        return Stepper, (self.system, self.inputs, self.tolerance, self._constants[0, :, 0])

    def __repr__(self) -> str:
        changing = f", inputs {', '.join(self.inputs)}" if self.inputs else ""
        return f"<Stepper of {self.system.name}: tolerance {self.tolerance:g}{changing}>"

    def __call__(
        self, state: npt.ArrayLike, duration: float, inputs: Sequence[float] | FloatArray = ()
    ) -> FloatArray:
        """The state after a duration.

        Parameters
        ----------
        state : array (size,)
            In flat order of ``system.symbols``.  A state that the call before returned is not
            checked again.
        duration : float
            In s; negative to go back.
        inputs : sequence of float
            Values of the inputs during the call, in the order of `inputs`.

        Returns
        -------
        array (size,)
            Read-only.

        Raises
        ------
        InputError
            If the state is not one of the system, the inputs are not as many numbers, or the
            duration is not finite.
        RunError
            If the motion does not reach the end: a guard, a singularity.
        """
        if len(inputs) != len(self.inputs):
            raise InputError(
                f"inputs: {len(inputs)} are given, and the stepper has {len(self.inputs)}"
                + (f" ({', '.join(self.inputs)})" if self.inputs else "")
            )
        if self.inputs:
            self._constants[0, self._places, 0] = inputs
        if not math.isfinite(duration):
            raise InputError(f"duration = {duration}: it must be a finite number")
        if state is not self._last:
            self._check(state)
        call = self._forward if duration >= 0 else self._backward
        self._start[0, :, 0] = state
        self._duration[0] = abs(duration)
        outcome, reached = call()
        if outcome:
            self._last = None
            raise RunError(
                f"{self.system.name}: {outcome_message(self.system, outcome)}",
                time=float(reached if duration >= 0 else -reached),
            )
        end: FloatArray = call.states[0, 0, :, 0].copy()
        end.flags.writeable = False
        self._last = end
        return end

    def _check(self, state: npt.ArrayLike) -> None:
        point = as_float_array("state", state)[None]
        check_state_shape(self.system, point)
        require_on_phase_space(self.system, self._relations, point, self._constants[..., 0])


@arguments_checked
def stepper(
    system: System,
    *,
    inputs: Sequence[str | sp.Symbol] = (),
    parameters: Parameters = None,
    tolerance: float = ENSEMBLE_TOLERANCE,
) -> Stepper:
    """Compile the flow of a system for many short calls of one motion.

    Parameters
    ----------
    system : System
        As it is to be integrated; ``system.lifted()`` carries its motion in space along.
    inputs : sequence of str or Symbol
        Parameters that get new values in every call, such as torques.
    parameters : mapping of Symbol or name to number, optional
        Values of the others that replace the defaults.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.

    Returns
    -------
    Stepper
        ``step(state, duration, inputs)`` is the state after the duration.

    Raises
    ------
    InputError
        If an input is no parameter of the system, or occurs twice.

    Examples
    --------
    A pendulum that is driven by a torque, at 10 kHz:

    >>> import flowlanes
    >>> import sympy as sp
    >>> theta, rate, torque = sp.symbols("theta rate torque", real=True)
    >>> pendulum = flowlanes.System(
    ...     "pendulum",
    ...     "Pendulum",
    ...     {theta: rate, rate: -sp.sin(theta) + torque},
    ...     parameters=(flowlanes.Parameter(torque, "torque", 0.0),),
    ... )
    >>> step = flowlanes.flow.stepper(pendulum, inputs=["torque"])
    >>> state = [0.1, 0.0]
    >>> for _ in range(10_000):
    ...     state = step(state, 1e-4, [-0.5 * state[1]])
    >>> [round(float(x), 4) for x in state]
    [0.0608, -0.0662]
    """
    names = [str(p.symbol) for p in system.parameters]
    chosen = tuple(map(str, inputs))
    for name in chosen:
        if name not in names:
            known = ", ".join(names) or "none"
            raise InputError(f"inputs: {system.name} has no parameter {name!r}; it has {known}")
    if len(set(chosen)) < len(chosen):
        raise InputError("inputs: a name occurs twice")
    return Stepper(system, chosen, tolerance, parameter_rows(system, parameters, 1)[0])
