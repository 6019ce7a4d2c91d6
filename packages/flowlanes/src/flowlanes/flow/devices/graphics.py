"""The integration loop on a graphics processor, with one motion per thread."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

import numpy as np

from ...errors import InputError
from ...system.tolerance import Precision
from ..kernel.equations import Equations, serial
from ..kernel.tableaux import arithmetic_and_method
from .batch_arrays import BatchInput, BatchOutput, empty_output
from .cuda import GraphicsProcessor, open_processor
from .graphics_text import ENTRY, thread_loop
from .ptx import cached_ptx

#: Available devices.
Device: TypeAlias = Literal["cpu", "gpu"]

#: Number of motions computed per piece: a few for each thread of a large device.
MOTIONS = 2**17

#: Approximate upper bound of the result size of one piece, in bytes.
PIECE = 2**28

#: Number of pieces in flight: while one is computed, others are copied to and from the device.
PIECES = 3


@dataclass(frozen=True)
class GraphicsLoop:
    """Loop as PTX code, and the processor that runs it.

    Attributes
    ----------
    processor : GraphicsProcessor
    ptx : str
    """

    processor: GraphicsProcessor
    ptx: str = field(repr=False)

    def run(self, task: BatchInput, threads: int | None) -> BatchOutput:
        """Integrate the motions piece by piece; `threads` of the host is ignored."""
        result = empty_output(task)
        each = max(1, result.states.nbytes // max(task.motions, 1))
        motions = max(1, min(MOTIONS, PIECE // each))
        pieces = [
            slice(first, min(first + motions, task.motions))
            for first in range(0, task.motions, motions)
        ]
        with ThreadPoolExecutor(PIECES) as pool:
            list(pool.map(lambda some: self._run_piece(task, result, some), pieces))
        return result

    def _run_piece(self, task: BatchInput, result: BatchOutput, some: slice) -> None:
        count = some.stop - some.start
        parameters = task.parameters[some] if task.stride else task.parameters
        inputs = [
            *(np.zeros(1, dtype=np.int64), count, task.starts[some], parameters, task.stride),
            *(task.times, task.samples, task.tolerance, task.limit),
        ]
        outputs = [array[some] for array in result.arrays]
        self.processor.run(self.ptx, ENTRY, inputs, outputs, count)


def refuse_graphics(device: Device) -> None:
    """Raise InputError if motions with friction are requested on a graphics processor."""
    if device == "gpu":
        raise InputError(
            "device = 'gpu': motions with friction, whose equations change, are computed on the "
            "'cpu' alone"
        )


def graphics_loop(
    equations: Equations,
    precision: Precision,
    tolerance: float,
    open_device: Callable[[], GraphicsProcessor] = open_processor,
) -> GraphicsLoop:
    """Generate the loop for given equations, with 16 or 30 digits and the method for a tolerance.

    Parameters
    ----------
    equations : Equations
    precision : ``"double"`` or ``"quad"``
    tolerance : float
    open_device : callable
        Opens the graphics processor.

    Raises
    ------
    InputError
        If there is no graphics processor, or its library is missing.
    """
    processor = open_device()
    arithmetic, method = arithmetic_and_method(precision, tolerance)
    key = f"thread {precision} {method.name} {serial(equations)}"
    return GraphicsLoop(
        processor, cached_ptx(key, lambda: thread_loop(arithmetic, method, equations))
    )
