"""The integration loop on the CPUs of this machine, with one motion per vector lane."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass, field

from ...system.arrays import FloatArray
from ...system.tolerance import Precision
from ..kernel.equations import Equations, serial
from ..kernel.runge_kutta import runge_kutta_loop
from ..kernel.tableaux import arithmetic_and_method
from ..machine_code import jit as native
from .batch_arrays import BatchInput, BatchOutput, empty_output
from .threads import run_in_threads

_I, _P, _D = ctypes.c_int64, ctypes.c_void_p, ctypes.c_double
#: Argument types of the loop.
SIGNATURE = (_I, _I, _P, _P, _I, _P, _I, _D, _I, _P, _P, _P, _P, _P, _P, _P)


@dataclass(frozen=True)
class ProcessorLoop:
    """Vector code for the CPU.

    Attributes
    ----------
    code : Native
    """

    code: native.Native = field(repr=False)

    def run(self, task: BatchInput, threads: int | None) -> BatchOutput:
        """Integrate the motions; see :class:`flowlanes.flow.devices.batch_arrays.BatchLoop`."""
        result = empty_output(task)

        def compute(first: int, last: int) -> None:
            result.clear(first, last)
            work = native.aligned_zeros(self.code.work_size)
            self.code.functions["march"](first, last, *_addresses(task, result, work))

        run_in_threads(compute, task.motions, threads)
        return result


class PreparedCall:
    """A call of the loop for one motion, again and again with the same arrays.

    Attributes
    ----------
    states : array (1, samples, numbers, words)
        The result of the last call.
    """

    def __init__(self, loop: ProcessorLoop, task: BatchInput) -> None:
        self._result = empty_output(task)
        self._work = native.aligned_zeros(loop.code.work_size)
        self._march = loop.code.functions["march"]
        # the arrays stay alive as long as their addresses
        self._task = task
        self._arguments = (0, 1, *_addresses(task, self._result, self._work))
        self.states = self._result.states

    def __call__(self) -> tuple[int, float]:
        """Run the loop from what the arrays of the task hold; the outcome and the time reached."""
        self._result.outcome[0] = 0
        self._march(*self._arguments)
        return int(self._result.outcome[0]), float(self._result.end_times[0])


def _addresses(task: BatchInput, result: BatchOutput, work: FloatArray) -> tuple[int | float, ...]:
    """The arguments of the loop after the range of motions."""
    return (
        *(task.starts.ctypes.data, task.parameters.ctypes.data),
        *(task.stride, task.times.ctypes.data, task.samples),
        *(task.tolerance, task.limit),
        *(array.ctypes.data for array in result.arrays),
        work.ctypes.data,
    )


def processor_loop(equations: Equations, precision: Precision, tolerance: float) -> ProcessorLoop:
    """Compile the loop for given equations, with 16 or 30 digits and the method for a tolerance."""
    width = native.width()
    arithmetic, method = arithmetic_and_method(precision, tolerance)

    def text() -> tuple[str, int]:
        return runge_kutta_loop(arithmetic, method, equations, width)

    key = f"march {width} {precision} {method.name} {serial(equations)}"
    return ProcessorLoop(native.load_code(key, text, {"march": SIGNATURE}))
