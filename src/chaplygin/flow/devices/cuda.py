"""A graphics processor of NVIDIA, through its driver and the library cuda-core."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from ...errors import InputError

#: An argument of a kernel: an array in the memory of the host, or a number.
Argument: TypeAlias = npt.NDArray[Any] | int | float

#: Threads of a block: few, so that blocks with many registers fill a processor.
BLOCK = 64


class GraphicsProcessor(Protocol):
    """A graphics processor, as far as it is needed here."""

    def run(
        self, ptx: str, entry: str, arguments: Sequence[Argument], outputs: Sequence[int], most: int
    ) -> None:
        """Run a kernel to its end.

        Parameters
        ----------
        ptx : str
        entry : str
            The name of the kernel.
        arguments : sequence of array, int or float
            Arrays are copied to the device, 64-bit numbers passed as they are.
        outputs : sequence of int
            Places of the arrays that are copied back.
        most : int
            Threads at most; as many as run at once are started, if these are fewer.
        """
        ...


@dataclass(frozen=True)
class CudaProcessor:
    """A device that cuda-core has opened.

    Attributes
    ----------
    core : module
        ``cuda.core``.
    device : cuda.core.Device
    """

    core: Any
    device: Any

    def run(
        self, ptx: str, entry: str, arguments: Sequence[Argument], outputs: Sequence[int], most: int
    ) -> None:
        """Run a kernel; see :class:`GraphicsProcessor`."""
        core, device = self.core, self.device
        # each thread of the host has a current device of its own
        device.set_current()
        stream = device.create_stream()
        buffers: dict[int, tuple[Any, Any]] = {}
        try:
            kernel = _kernel(core, device.device_id, ptx, entry)
            passed: list[Any] = []
            for place, argument in enumerate(arguments):
                if not isinstance(argument, np.ndarray):
                    number = np.float64 if isinstance(argument, float) else np.int64
                    passed.append(number(argument))
                    continue
                buffers[place] = self._device_copy(argument, stream)
                passed.append(buffers[place][1])
            resident = kernel.occupancy.max_active_blocks_per_multiprocessor(BLOCK, 0)
            blocks = resident * device.properties.multiprocessor_count
            blocks = max(1, min(blocks, -(-most // BLOCK)))
            core.launch(stream, core.LaunchConfig(grid=blocks, block=BLOCK), kernel, *passed)
            for place in outputs:
                pinned, there = buffers[place]
                there.copy_to(pinned, stream=stream)
            stream.sync()
            for place in outputs:
                array = arguments[place]
                assert isinstance(array, np.ndarray)
                array.reshape(-1).view(np.uint8)[:] = self._bytes(buffers[place][0])
        finally:
            for pair in buffers.values():
                for buffer in pair:
                    buffer.close(stream)
            stream.close()

    def _device_copy(self, array: npt.NDArray[Any], stream: Any) -> tuple[Any, Any]:
        """A buffer in pinned memory of the host, and its copy on the device."""
        size = max(array.nbytes, 8)
        pinned = self.core.LegacyPinnedMemoryResource().allocate(size)
        self._bytes(pinned)[: array.nbytes] = array.reshape(-1).view(np.uint8)
        there = self.device.allocate(size, stream=stream)
        there.copy_from(pinned, stream=stream)
        return pinned, there

    @staticmethod
    def _bytes(buffer: Any) -> npt.NDArray[np.uint8]:
        return np.from_dlpack(buffer).view(np.uint8)


@lru_cache(maxsize=64)
def _kernel(core: Any, _device: int, ptx: str, entry: str) -> Any:
    """A kernel, which the driver compiles for a device the first time."""
    return core.ObjectCode.from_ptx(ptx.encode()).get_kernel(entry)


def open_processor() -> GraphicsProcessor:
    """The first graphics processor of this machine.

    Raises
    ------
    InputError
        If there is none, or cuda-core is not installed.
    """
    try:
        import cuda.core as core
    except ImportError:
        raise InputError(
            "device = 'gpu' needs the library cuda-core: pip install 'chaplygin[gpu]'"
        ) from None
    try:
        device = core.Device()
        device.set_current()
    # without a driver, without a device, with a driver too old: each raises an error of its own
    except Exception as error:
        reason = " ".join(str(error).split()).rstrip(".")
        raise InputError(
            f"device = 'gpu': no graphics processor of NVIDIA can be used here ({reason})"
        ) from None
    return CudaProcessor(core, device)
