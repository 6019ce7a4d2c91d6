"""NVIDIA graphics processors, through the driver and the cuda-core library."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any, Protocol, TypeAlias

import numpy as np
import numpy.typing as npt

from ...errors import InputError

#: A contiguous array in host memory.
Array: TypeAlias = npt.NDArray[np.float64] | npt.NDArray[np.int64]

#: An argument of a kernel.
Argument: TypeAlias = Array | int | float

#: Threads per block: one warp, so that blocks with many registers still fill a multiprocessor.
BLOCK = 32

#: Maximum number of blocks per multiprocessor: with more, their stages no longer fit into the
#: cache.
BLOCKS = 8

#: Alignment of arrays within a buffer, in bytes.
ALIGNMENT = 256


class GraphicsProcessor(Protocol):
    """Operations of a graphics processor that are used by the integration loop."""

    def run(
        self,
        ptx: str,
        entry: str,
        inputs: Sequence[Argument],
        outputs: Sequence[Array],
        most: int,
    ) -> None:
        """Run a kernel and wait for its end.

        Parameters
        ----------
        ptx : str
        entry : str
            Name of the kernel.
        inputs : sequence of array, int or float
            First arguments of the kernel: arrays are copied to the device, 64-bit numbers are
            passed by value.
        outputs : sequence of array
            Further arguments: arrays written by the kernel.  Values that it does not write are NaN
            for floats and zero for integers.
        most : int
            Maximum number of threads; not more are started than can run at the same time.
        """
        ...


@dataclass(frozen=True)
class CudaProcessor:
    """Device opened with cuda-core.

    Attributes
    ----------
    core : module
        ``cuda.core``.
    device : cuda.core.Device
    staging : list of cuda.core.Buffer
        Page-locked host memory for copies from and to the device that is not in use.  To lock
        memory takes longer than many kernels, so it is kept.
    """

    core: Any
    device: Any
    staging: list[Any] = field(default_factory=list, repr=False, compare=False)

    def run(
        self,
        ptx: str,
        entry: str,
        inputs: Sequence[Argument],
        outputs: Sequence[Array],
        most: int,
    ) -> None:
        """Run a kernel; see :class:`GraphicsProcessor`."""
        core, device = self.core, self.device
        # Each host thread has its own current device.
        device.set_current()
        into = [argument for argument in inputs if isinstance(argument, np.ndarray)]
        *places, size = _places([*into, *outputs])
        first = places[len(into)]
        pinned = self._pinned_buffer(size)
        stream = device.create_stream()
        there = device.allocate(size, stream=stream)
        view = np.from_dlpack(pinned).view(np.uint8)
        try:
            kernel = _kernel(core, device.device_id, ptx, entry)
            for array, place in zip(into, places, strict=False):
                view[place : place + array.nbytes] = _bytes(array)
            self._part(there, 0, first).copy_from(self._part(pinned, 0, first), stream=stream)
            for array, place in zip(outputs, places[len(into) :], strict=True):
                # A float with all bits set is NaN.
                byte = 0xFF if array.dtype.kind == "f" else 0
                self._part(there, place, max(array.nbytes, 1)).fill(byte, stream=stream)
            addresses = iter([np.uint64(int(there.handle) + place) for place in places])
            passed = [
                next(addresses) if isinstance(argument, np.ndarray) else _number(argument)
                for argument in (*inputs, *outputs)
            ]
            resident = kernel.occupancy.max_active_blocks_per_multiprocessor(BLOCK, 0)
            blocks = min(resident, BLOCKS) * device.properties.multiprocessor_count
            blocks = max(1, min(blocks, -(-most // BLOCK)))
            core.launch(stream, core.LaunchConfig(grid=blocks, block=BLOCK), kernel, *passed)
            results = self._part(there, first, size - first)
            results.copy_to(self._part(pinned, first, size - first), stream=stream)
            stream.sync()
            for array, place in zip(outputs, places[len(into) :], strict=True):
                _bytes(array)[:] = view[place : place + array.nbytes]
        finally:
            there.close(stream)
            stream.close()
            self.staging.append(pinned)

    def _part(self, buffer: Any, first: int, size: int) -> Any:
        """A slice of a buffer, in bytes."""
        return self.core.Buffer.from_handle(int(buffer.handle) + first, size, owner=buffer)

    def _pinned_buffer(self, size: int) -> Any:
        """Page-locked host memory, reused from earlier calls if it is large enough."""
        try:
            pinned = self.staging.pop()
        except IndexError:
            pass
        else:
            if pinned.size >= size:
                return pinned
            pinned.close()
        return self.core.LegacyPinnedMemoryResource().allocate(size)


def _places(arrays: Sequence[Array]) -> list[int]:
    """Offset of each array in a common buffer, and the size of the buffer in bytes."""
    sizes = [max(1, -(-array.nbytes // ALIGNMENT)) * ALIGNMENT for array in arrays]
    return [0, *itertools.accumulate(sizes)]


def _number(argument: float) -> np.float64 | np.int64:
    return np.float64(argument) if isinstance(argument, float) else np.int64(argument)


def _bytes(array: Array) -> npt.NDArray[np.uint8]:
    return array.reshape(-1).view(np.uint8)


@lru_cache(maxsize=64)
def _kernel(core: Any, _device: int, ptx: str, entry: str) -> Any:
    """Kernel, compiled by the driver on first use."""
    return core.ObjectCode.from_ptx(ptx.encode()).get_kernel(entry)


def open_processor() -> GraphicsProcessor:
    """Open the first graphics processor of this machine.

    Raises
    ------
    InputError
        If there is no such processor, or cuda-core is not installed.
    """
    try:
        import cuda.core as core
    except ImportError:
        raise InputError(
            "device = 'gpu' needs the library cuda-core: pip install 'flowlanes[gpu]'"
        ) from None
    try:
        return _first_device(core)
    # A missing driver, a missing device and an old driver raise different errors.
    except Exception as error:
        reason = " ".join(str(error).split()).rstrip(".")
        raise InputError(
            f"device = 'gpu': no graphics processor of NVIDIA can be used here ({reason})"
        ) from None


@lru_cache(maxsize=1)
def _first_device(core: Any) -> CudaProcessor:
    """Device, opened once per process, so that all calls share the page-locked memory."""
    device = core.Device()
    device.set_current()
    return CudaProcessor(core, device)
