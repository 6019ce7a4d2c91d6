"""Machine code from text: found again on disk, never trusted when damaged, its own for each."""

from __future__ import annotations

import ctypes
import os
import subprocess
import sys
from dataclasses import replace
from inspect import unwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from flow.small import OSCILLATOR, body, p, x, y
from flowlanes.files import cache as core_cache, private_files
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.gauss import _compiled_integrator
from flowlanes.flow.kernel.equations import equations_of, poincare_section, serial
from flowlanes.flow.machine_code import code_cache as cache, jit as native
from flowlanes.flow.machine_code.ir_writer import IRWriter
from flowlanes.system.system import Guard, Parameter, System

_P = ctypes.c_void_p


def doubling(lanes_of: int, factor: str = "2.0") -> Any:
    """Code that multiplies a vector by a number."""
    w = IRWriter(lanes_of)
    place = w.address(w.type, "%given", 0)
    w.store(w.type, w.op("fmul", w.load(w.type, place), w.constant(float(factor))), place)
    text = w.text("void @doubled(ptr %given)", "#0")
    return native.load_code(text, lambda: (text, lanes_of), {"doubled": (_P,)})


def run(code: native.Native) -> list[float]:
    numbers = native.aligned_zeros(code.work_size)
    numbers[:] = np.arange(code.work_size)
    code.functions["doubled"](numbers.ctypes.data)
    return numbers.tolist()


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty cache of the test's own, without what this process has at hand."""
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path / "code"))
    monkeypatch.setattr(cache, "_file_version", lambda path: object())
    return tmp_path / "code"


@pytest.mark.parametrize("lanes_of", [1, 2, 4, 8, 16])
def test_code_runs_at_every_width(lanes_of: int) -> None:
    assert run(doubling(lanes_of)) == [2.0 * k for k in range(lanes_of)]


def test_code_is_found_the_second_time(folder: Path) -> None:
    first, second = doubling(4), doubling(4)
    assert (first.from_cache, second.from_cache) == (False, True)
    assert run(first) == run(second)
    assert first.work_size == second.work_size
    assert len(list(folder.iterdir())) == 1


def test_other_text_is_other_code(folder: Path) -> None:
    doubling(4)
    other = doubling(4, "3.0")
    assert not other.from_cache
    assert run(other) == [0.0, 3.0, 6.0, 9.0]
    assert len(list(folder.iterdir())) == 2


@pytest.mark.parametrize("damage", ["cut", "bit", "foreign", "empty"])
def test_damaged_code_is_compiled_again(folder: Path, damage: str) -> None:
    doubling(4)
    (path,) = folder.iterdir()
    content = bytearray(path.read_bytes())
    if damage == "bit":
        content[len(content) // 2] ^= 1
    changed = {
        "cut": bytes(content[:-100]),
        "bit": bytes(content),
        "foreign": b"something else altogether",
        "empty": b"",
    }
    path.write_bytes(changed[damage])
    again = doubling(4)
    assert not again.from_cache
    assert run(again) == [0.0, 2.0, 4.0, 6.0]
    assert doubling(4).from_cache


def test_code_for_another_processor_is_not_used(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    doubling(4)
    monkeypatch.setattr(native, "_processor", lambda sets: "another one")
    assert not doubling(4).from_cache


def test_a_change_of_the_program_counts(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    doubling(4)
    monkeypatch.setattr(core_cache, "computation_digest", lambda: "another one")
    assert not doubling(4).from_cache


@pytest.mark.parametrize("place", ["a file in its way", "read-only"])
def test_without_a_cache_code_is_compiled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, place: str
) -> None:
    blocked = tmp_path / "blocked"
    if place == "read-only":
        blocked.mkdir(mode=0o500)
        # also for those to whom permissions mean nothing
        monkeypatch.setattr(private_files, "partial_file", _refuse)
    else:
        blocked.write_text("")
    monkeypatch.setenv("FLOWLANES_CACHE", str(blocked / "code"))
    monkeypatch.setattr(cache, "_file_version", lambda path: object())
    for _ in range(2):
        code = doubling(8)
        assert not code.from_cache
        assert run(code) == [2.0 * k for k in range(8)]


def _refuse(*_: Any) -> Any:
    raise PermissionError("read-only")


@pytest.mark.slow
def test_another_process_finds_the_code(tmp_path: Path) -> None:
    """And computes the same bits with it."""
    script = (
        "import sympy as sp\n"
        "from flowlanes.flow.batch import batch_integrator\n"
        "from flowlanes.system.system import System\n"
        "x, y = sp.symbols('x y', real=True)\n"
        "flow = batch_integrator(System(name='o', title='O', field={x: y, y: -x}))\n"
        "found = flow.propagate([[1.0, 0.0]], [3.0])\n"
        "print(flow.loop.code.from_cache, *(x.hex() for x in found.states[0, 0]))\n"
    )
    environment = os.environ | {"FLOWLANES_CACHE": str(tmp_path / "code")}
    lines = [
        subprocess.run(
            [sys.executable, "-c", script],
            env=environment,
            capture_output=True,
            text=True,
            check=True,
            timeout=120,
        ).stdout.split()
        for _ in range(2)
    ]
    assert [line[0] for line in lines] == ["False", "True"]
    assert lines[0][1:] == lines[1][1:]


# --- what makes code another ------------------------------------------------------------------

BASE: dict[str, Any] = {
    "name": "base",
    "title": "Base",
    "parameters": (Parameter(p, "p", 1.0),),
    "field": {x: y, y: -p * sp.sin(x)},
}
CHANGES: dict[str, dict[str, Any]] = {
    "a sign": {"field": {x: y, y: p * sp.sin(x)}},
    "a function": {"field": {x: y, y: -p * sp.cos(x)}},
    "a digit": {"field": {x: y, y: -sp.Rational(1000000001, 1000000000) * p * sp.sin(x)}},
    "an order": {"field": {y: -p * sp.sin(x), x: y}},
    "a guard": {"guards": (Guard("g", x + 3, "out"),)},
}


@pytest.mark.parametrize("name", CHANGES)
def test_every_change_of_the_formulas_is_other_code(name: str) -> None:
    base, changed = System(**BASE), System(**(BASE | CHANGES[name]))
    keys = {serial(equations_of(s, 0, None, False)) for s in (base, changed)}
    assert len(keys) == 2


@pytest.mark.slow
def test_every_option_is_other_code(folder: Path) -> None:
    """Deviations, sections, their direction, what time does, digits; not the tolerance."""
    system = System(**BASE)
    rising = poincare_section(system, x)
    options: list[dict[str, Any]] = [
        {},
        {"deviations": 1},
        {"section": rising},
        {"section": replace(rising, direction=-1)},
        {"section": replace(rising, direction=0)},
        {"section": replace(rising, where=y)},
        {"backward": True},
        {"digits": 30},
    ]
    made = [unwrap(batch_integrator)(system, **chosen) for chosen in options]
    assert not any(flow.loop.code.from_cache for flow in made)
    assert unwrap(batch_integrator)(system, tolerance=1e-6).loop.code.from_cache
    assert unwrap(batch_integrator)(replace(system, title="Another word")).loop.code.from_cache


def test_what_is_held_is_part_of_the_key(folder: Path) -> None:
    held = _compiled_integrator.__wrapped__(OSCILLATOR, "double", False, ("energy",))
    free = _compiled_integrator.__wrapped__(OSCILLATOR, "double", False, ())
    assert not held.code.from_cache
    assert not free.code.from_cache
    laws = (replace(OSCILLATOR.laws[0], value=2 * OSCILLATOR.laws[0].value),)
    other = _compiled_integrator.__wrapped__(
        replace(OSCILLATOR, laws=laws), "double", False, ("energy",)
    )
    assert not other.code.from_cache


def test_memory_is_aligned() -> None:
    for count in range(1, 40):
        room = native.aligned_zeros(count)
        assert room.size == count
        assert room.ctypes.data % 64 == 0
        assert not room.any()


def test_width_fills_two_registers() -> None:
    assert native.width() in (4, 8, 16)


def test_lanes_of_a_body_are_compiled_once_for_all_processes(folder: Path) -> None:
    ball = body("chaplygin-ball")
    assert [unwrap(batch_integrator)(ball).loop.code.from_cache for _ in range(2)] == [
        False,
        True,
    ]


#: Fills every hole of two pages and more above 3 GiB that are in use, then compiles and runs.
_NO_ROOM_BETWEEN = """
import ctypes

from flowlanes.flow.batch import batch_integrator
from flow.small import body, starts

ball = body("chaplygin-ball")
library = ctypes.CDLL(None)
library.mmap.restype = ctypes.c_void_p
library.mmap.argtypes = [ctypes.c_void_p, ctypes.c_size_t, *[ctypes.c_int] * 3, ctypes.c_long]
reserve = lambda size: library.mmap(None, size, 0, 0x4022, -1, 0)  # without room in memory
large = reserve(3 << 30)
for size in (1 << 20, 1 << 16, 1 << 13):
    while reserve(size) > large:
        pass
print(batch_integrator(ball).propagate(starts("chaplygin-ball", 1), [0.1]).outcome.tolist())
"""


@pytest.mark.skipif(sys.platform != "linux", reason="memory is reserved as Linux does it")
def test_code_and_constants_stay_together() -> None:
    tests = str(Path(__file__).parents[4])
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([tests, *sys.path])}
    run = subprocess.run(
        [sys.executable, "-c", _NO_ROOM_BETWEEN],
        check=False,
        env=environment,
        capture_output=True,
        text=True,
    )
    assert (run.returncode, run.stdout.strip()) == (0, "[0]"), run.stderr[:300]
