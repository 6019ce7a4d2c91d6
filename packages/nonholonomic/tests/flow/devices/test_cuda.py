"""What is asked of cuda-core, by a stand-in with the same names that has memory and no device."""

from __future__ import annotations

import inspect
import sys
from dataclasses import dataclass, field
from inspect import unwrap
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from flow.devices.ptx_machine import PtxMachine
from flow.small import OSCILLATOR
from flowlanes.errors import InputError
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.devices.cuda import BLOCK, CudaProcessor, open_processor
from flowlanes.flow.kernel.equations import equations_of
from needs import optional


@dataclass(eq=False)
class Buffer:
    """A piece of memory, of the host or of the device."""

    memory: np.ndarray
    pinned: bool
    closed: bool = False

    @property
    def size(self) -> int:
        return self.memory.size

    @property
    def handle(self) -> int:
        return int(self.memory.ctypes.data)

    def __dlpack__(self, **options: Any) -> Any:
        assert self.pinned, "the host cannot read the memory of a device"
        return self.memory.__dlpack__(**options)

    def __dlpack_device__(self) -> Any:
        return self.memory.__dlpack_device__()

    def copy_to(self, other: Buffer, *, stream: Any) -> None:
        other.memory[:] = self.memory

    def copy_from(self, other: Buffer, *, stream: Any) -> None:
        self.memory[:] = other.memory

    def fill(self, byte: int, *, stream: Any) -> None:
        self.memory[:] = byte

    def close(self, stream: Any = None) -> None:
        self.closed = True


@dataclass
class Kernel:
    """A kernel of a text, of whose blocks four fit a multiprocessor."""

    ptx: str
    name: str
    occupancy: Any = field(
        default_factory=lambda: SimpleNamespace(
            max_active_blocks_per_multiprocessor=lambda block, shared: 4
        )
    )


class StandIn(ModuleType):
    """The names of ``cuda.core``; kernels are carried out by `PtxMachine`."""

    def __init__(self, multiprocessors: int = 2) -> None:
        super().__init__("cuda.core")
        self.buffers: list[Buffer] = []
        self.compiled: list[str] = []
        self.grids: list[tuple[int, int]] = []
        self.current = 0
        self.multiprocessors = multiprocessors
        self.ObjectCode = SimpleNamespace(from_ptx=self._from_ptx)
        self.LegacyPinnedMemoryResource = lambda: SimpleNamespace(
            allocate=lambda size: self._buffer(size, True)
        )
        self.LaunchConfig = lambda *, grid, block: (grid, block)
        self.Buffer = SimpleNamespace(from_handle=self._part)

    def Device(self) -> Any:
        def set_current() -> None:
            self.current += 1

        return SimpleNamespace(
            device_id=id(self),
            set_current=set_current,
            create_stream=lambda: SimpleNamespace(sync=lambda: None, close=lambda: None),
            allocate=lambda size, *, stream: self._buffer(size, False),
            properties=SimpleNamespace(multiprocessor_count=self.multiprocessors),
        )

    def _buffer(self, size: int, pinned: bool) -> Buffer:
        # memory of a device contains anything
        self.buffers.append(Buffer(np.full(size, 0xA5, dtype=np.uint8), pinned))
        return self.buffers[-1]

    def _part(self, handle: int, size: int, *, owner: Buffer) -> Buffer:
        first = handle - owner.handle
        assert 0 <= first <= first + size <= owner.size
        return Buffer(owner.memory[first : first + size], owner.pinned)

    def _memory_at(self, address: int) -> np.ndarray:
        """The memory of the device from an address on."""
        for buffer in self.buffers:
            first = address - buffer.handle
            if 0 <= first < buffer.size and not buffer.closed:
                assert not buffer.pinned
                return buffer.memory[first:]
        raise AssertionError("no memory has this address")

    def _from_ptx(self, module: bytes) -> Any:
        self.compiled.append(module.decode())
        return SimpleNamespace(get_kernel=lambda name: Kernel(module.decode(), name))

    def launch(self, stream: Any, config: tuple[int, int], kernel: Kernel, *passed: Any) -> None:
        self.grids.append(config)
        kinds = [np.int64, None, *[np.float64] * 2, None, np.float64, *[None] * 3]
        kinds += [np.float64] * 2 + [np.int64] * 2 + [np.float64, np.int64]
        arguments: list[Any] = []
        for argument, kind in zip(passed, kinds, strict=True):
            if kind is None:
                assert isinstance(argument, (np.int64, np.float64))
                arguments.append(argument.item())
            else:
                assert isinstance(argument, np.uint64)
                arguments.append(self._memory_at(int(argument)).view(kind))
        # parts of one memory, in the order of their places
        PtxMachine(3).carry_out(kernel.ptx, kernel.name, arguments, 1 << 30)


def test_motions_through_the_driver(monkeypatch: pytest.MonkeyPatch) -> None:
    core = StandIn()
    package = ModuleType("cuda")
    package.core = core  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "cuda", package)
    monkeypatch.setitem(sys.modules, "cuda.core", core)
    # not through the cache of integrators, which would keep the stand-in
    there = unwrap(batch_integrator)(OSCILLATOR, device="gpu")
    states, values = [[1.0, 0.0], [0.0, 1.0], [1.0, 1.0]], {"p": [1.0, 2.0, 3.0]}
    right = batch_integrator(OSCILLATOR).propagate(states, [0.1, 0.3], values)
    for _ in range(2):
        found = there.propagate(states, [0.1, 0.3], values)
        assert found.states.tolist() == right.states.tolist()
        assert found.steps.tolist() == right.steps.tolist()
        assert found.outcome.tolist() == [0, 0, 0]
    # the memory of the host is locked once, that of the device returned after every call
    assert [buffer.closed for buffer in core.buffers] == [False, True, True]
    assert len(core.compiled) == 1
    assert core.grids == [(1, BLOCK)] * 2
    assert core.current >= 3


@pytest.mark.parametrize(("motions", "blocks"), [(1, 1), (BLOCK + 1, 2), (10**6, 8)])
def test_as_many_threads_as_run_at_once(motions: int, blocks: int) -> None:
    core = StandIn()
    grids = []
    core.launch = lambda stream, config, kernel, *passed: grids.append(config)  # type: ignore
    unwritten = np.arange(3.0), np.arange(2)
    CudaProcessor(core, core.Device()).run("", "march", [1, 2.5], unwritten, motions)
    assert grids == [(blocks, BLOCK)]
    assert np.isnan(unwritten[0]).all()
    assert unwritten[1].tolist() == [0, 0]


def test_memory_of_the_host_is_used_again_and_grows() -> None:
    core = StandIn()
    core.launch = lambda *_: None  # type: ignore[method-assign]
    processor = CudaProcessor(core, core.Device())
    for size in (10, 10, 10**4, 20):
        processor.run("", "march", [np.zeros(size)], [np.zeros(1)], 1)
    assert [(b.size > 5000, b.closed) for b in core.buffers if b.pinned] == [
        (False, True),
        (True, False),
    ]


def test_memory_is_returned_when_a_kernel_fails() -> None:
    core = StandIn()

    def fail(*_: Any) -> None:
        raise RuntimeError("an illegal address")

    core.launch = fail  # type: ignore[method-assign]
    with pytest.raises(RuntimeError, match="illegal"):
        CudaProcessor(core, core.Device()).run("", "march", [1], [np.zeros(4)], 1)
    assert [buffer.closed for buffer in core.buffers if not buffer.pinned] == [True]


def test_the_stand_in_has_the_names_of_the_library() -> None:
    core = optional("cuda.core")
    stream = buffer = object()
    inspect.signature(core.launch).bind(stream, object(), object(), 1, 2.0)
    assert core.LaunchConfig(grid=1, block=BLOCK).block == (BLOCK, 1, 1)
    inspect.signature(core.ObjectCode.from_ptx).bind(b"")
    inspect.signature(core.ObjectCode.get_kernel).bind(object(), "march")
    inspect.signature(core.Device.allocate).bind(object(), 8, stream=stream)
    inspect.signature(core.LegacyPinnedMemoryResource.allocate).bind(object(), 8)
    inspect.signature(core.Buffer.from_handle).bind(1, 8, owner=buffer)
    inspect.signature(core.Buffer.fill).bind(buffer, 0xFF, stream=stream)
    for name in ("size", "handle"):
        assert hasattr(core.Buffer, name)
    for name in ("copy_to", "copy_from"):
        inspect.signature(getattr(core.Buffer, name)).bind(buffer, buffer, stream=stream)
    inspect.signature(core.Buffer.close).bind(buffer, stream)
    for name in ("set_current", "create_stream", "device_id", "properties"):
        assert hasattr(core.Device, name)
    assert hasattr(core.Kernel, "occupancy")


def test_no_library(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cuda.core", None)
    with pytest.raises(InputError, match=r"needs the library cuda-core: pip install"):
        open_processor()


def test_no_device(monkeypatch: pytest.MonkeyPatch) -> None:
    core = StandIn()

    def missing() -> Any:
        raise RuntimeError("no driver\n  was found.")

    core.Device = missing  # type: ignore[method-assign]
    package = ModuleType("cuda")
    package.core = core  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "cuda", package)
    monkeypatch.setitem(sys.modules, "cuda.core", core)
    with pytest.raises(InputError, match=r"no graphics processor .* \(no driver was found\)"):
        batch_integrator(OSCILLATOR, device="gpu")


def test_another_device_is_refused() -> None:
    with pytest.raises(InputError, match="device"):
        batch_integrator(OSCILLATOR, device="tpu")


def test_a_refusal_comes_before_the_code(monkeypatch: pytest.MonkeyPatch) -> None:
    from flowlanes.flow.devices.graphics import graphics_loop

    def opened() -> Any:
        raise InputError("none")

    monkeypatch.setattr("flowlanes.flow.devices.graphics.cached_ptx", lambda *_: 1 / 0)
    with pytest.raises(InputError, match="none"):
        graphics_loop(equations_of(OSCILLATOR, 0, None, False), 16, 1e-13, opened)
