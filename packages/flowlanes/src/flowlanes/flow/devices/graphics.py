"""The loop over motions on a graphics processor, with a motion in each of its threads."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

import numpy as np

from ...errors import InputError
from ..kernel.equations import Equations, serial
from ..kernel.tableaux import arithmetic_and_method
from .batch_arrays import BatchInput, BatchOutput, empty_output
from .cuda import GraphicsProcessor, open_processor
from .graphics_text import ENTRY, thread_loop
from .ptx import cached_ptx

#: Where motions are computed.
Device: TypeAlias = Literal["cpu", "gpu"]

#: Motions that are computed at a time: some for each thread of a large device.
MOTIONS = 2**17

#: Bytes of their results at most, about.
PIECE = 2**28

#: Pieces at once: while one is computed, others are copied to the device and from it.
PIECES = 3


@dataclass(frozen=True)
class GraphicsLoop:
    """The loop in PTX, and the processor that runs it.

    Attributes
    ----------
    processor : GraphicsProcessor
    ptx : str
    """

    processor: GraphicsProcessor
    ptx: str = field(repr=False)

    def run(self, task: BatchInput, threads: int | None) -> BatchOutput:
        """The motions, piece by piece; `threads` of the host have nothing to do here."""
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
    """Raise InputError where motions with friction are wanted on a graphics processor."""
    if device == "gpu":
        raise InputError(
            "device = 'gpu': motions with friction, whose equations change, are computed on the "
            "'cpu' alone"
        )


def graphics_loop(
    equations: Equations,
    digits: int,
    tolerance: float,
    open_device: Callable[[], GraphicsProcessor] = open_processor,
) -> GraphicsLoop:
    """The loop for some equations, with 16 or 30 digits and the method for a tolerance.

    Parameters
    ----------
    equations : Equations
    digits : 16 or 30
    tolerance : float
    open_device : callable
        Opens the graphics processor.

    Raises
    ------
    InputError
        If there is no graphics processor, or its library is missing.
    """
    processor = open_device()
    arithmetic, method = arithmetic_and_method(digits, tolerance)
    key = f"thread {digits} {method.name} {serial(equations)}"
    return GraphicsLoop(
        processor, cached_ptx(key, lambda: thread_loop(arithmetic, method, equations))
    )
