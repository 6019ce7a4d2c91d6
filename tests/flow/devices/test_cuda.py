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

from chaplygin.errors import InputError
from chaplygin.flow.batch import batch_integrator
from chaplygin.flow.devices.cuda import BLOCK, CudaProcessor, open_processor
from chaplygin.flow.kernel.equations import equations_of
from flow.devices.ptx_machine import PtxMachine
from flow.small import OSCILLATOR


@dataclass(eq=False)
class Buffer:
    """A piece of memory, of the host or of the device."""

    memory: np.ndarray
    pinned: bool
    closed: bool = False

    def __dlpack__(self, **options: Any) -> Any:
        assert self.pinned, "the host cannot read the memory of a device"
        return self.memory.__dlpack__(**options)

    def __dlpack_device__(self) -> Any:
        return self.memory.__dlpack_device__()

    def copy_to(self, other: Buffer, *, stream: Any) -> None:
        other.memory[:] = self.memory

    def copy_from(self, other: Buffer, *, stream: Any) -> None:
        self.memory[:] = other.memory

    def close(self, stream: Any) -> None:
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

    def _from_ptx(self, module: bytes) -> Any:
        self.compiled.append(module.decode())
        return SimpleNamespace(get_kernel=lambda name: Kernel(module.decode(), name))

    def launch(self, stream: Any, config: tuple[int, int], kernel: Kernel, *passed: Any) -> None:
        self.grids.append(config)
        kinds = [np.int64, None, *[np.float64] * 2, None, np.float64, *[None] * 3]
        kinds += [np.float64] * 2 + [np.int64] * 2 + [np.float64, np.int64]
        arguments = []
        for argument, kind in zip(passed, kinds, strict=True):
            if kind is None:
                assert isinstance(argument, (np.int64, np.float64))
                arguments.append(argument.item())
            else:
                assert not argument.pinned
                arguments.append(argument.memory.view(kind))
        wanted = [k for k, kind in enumerate(kinds) if kind is not None]
        PtxMachine(3).run(kernel.ptx, kernel.name, arguments, wanted, 1 << 30)


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
    assert all(buffer.closed for buffer in core.buffers)
    assert len(core.compiled) == 1
    assert core.grids == [(1, BLOCK)] * 2
    assert core.current >= 3


@pytest.mark.parametrize(("motions", "blocks"), [(1, 1), (BLOCK + 1, 2), (10**6, 8)])
def test_as_many_threads_as_run_at_once(motions: int, blocks: int) -> None:
    core = StandIn()
    grids = []
    core.launch = lambda stream, config, kernel, *passed: grids.append(config)  # type: ignore
    array = np.arange(3.0)
    CudaProcessor(core, core.Device()).run("", "march", [array, 1, 2.5], [0], motions)
    assert grids == [(blocks, BLOCK)]
    assert array.tolist() == [0.0, 1.0, 2.0]


def test_memory_is_returned_when_a_kernel_fails() -> None:
    core = StandIn()

    def fail(*_: Any) -> None:
        raise RuntimeError("an illegal address")

    core.launch = fail  # type: ignore[method-assign]
    with pytest.raises(RuntimeError, match="illegal"):
        CudaProcessor(core, core.Device()).run("", "march", [np.zeros(4)], [0], 1)
    assert len(core.buffers) == 2
    assert all(buffer.closed for buffer in core.buffers)


def test_the_stand_in_has_the_names_of_the_library() -> None:
    core = pytest.importorskip("cuda.core", reason="cuda-core is not installed")
    stream = buffer = object()
    inspect.signature(core.launch).bind(stream, object(), object(), 1, 2.0)
    assert core.LaunchConfig(grid=1, block=BLOCK).block == (BLOCK, 1, 1)
    inspect.signature(core.ObjectCode.from_ptx).bind(b"")
    inspect.signature(core.ObjectCode.get_kernel).bind(object(), "march")
    inspect.signature(core.Device.allocate).bind(object(), 8, stream=stream)
    inspect.signature(core.LegacyPinnedMemoryResource.allocate).bind(object(), 8)
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
    from chaplygin.flow.devices.graphics import graphics_loop

    def opened() -> Any:
        raise InputError("none")

    monkeypatch.setattr("chaplygin.flow.devices.graphics.cached_ptx", lambda *_: 1 / 0)
    with pytest.raises(InputError, match="none"):
        graphics_loop(equations_of(OSCILLATOR, 0, None, False), 16, opened)
