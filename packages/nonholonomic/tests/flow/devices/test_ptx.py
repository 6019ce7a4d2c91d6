"""Code for graphics processors, translated by NVIDIA's assembler without such a processor."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest

from flowlanes.flow.devices.graphics_text import ENTRY, thread_loop
from flowlanes.flow.devices.ptx import ARCHITECTURE, cached_ptx, compile_ptx
from flowlanes.flow.kernel.equations import Equations, equations_of, poincare_section
from flowlanes.flow.kernel.tableaux import arithmetic_and_method
from flowlanes.system.tolerance import Precision
from needs import optional
from nonholonomic.catalogue import CATALOGUE, from_catalogue

#: Registers that a thread can have.
MOST_REGISTERS = 255
#: Arithmetic whose rounding is not left to the assembler.
ROUNDED = re.compile(r"\b(?:add|sub|mul|fma|div|rcp|sqrt)\.(?:[a-z]+\.)*f64")


def assembler() -> Path:
    """NVIDIA's assembler, from the wheel nvidia-cuda-nvcc; without it the test is skipped."""
    nvidia = optional("nvidia")
    for folder in nvidia.__path__:
        for path in Path(folder).rglob("bin/ptxas"):
            return path
    pytest.skip("nvidia-cuda-nvcc: not installed")


def assemble(ptx: str, folder: Path, *options: str) -> str:
    """What the assembler says of a text; an AssertionError if it refuses it."""
    source = folder / "kernel.ptx"
    source.write_text(ptx)
    command = [assembler(), "-v", f"-arch={ARCHITECTURE}", *options, "-o", folder / "kernel.cubin"]
    done = subprocess.run([*command, source], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stderr


def spills(text: str) -> int:
    """Bytes that were moved out of registers, by the words of the assembler."""
    found = re.findall(r"(\d+) bytes spill stores, (\d+) bytes spill loads", text)
    assert found, text
    return sum(int(stores) + int(loads) for stores, loads in found)


def registers(text: str) -> int:
    """Registers of a thread."""
    (number,) = re.findall(r"Used (\d+) registers", text)
    return int(number)


def ptx_of(equations: Equations, precision: Precision = "double") -> str:
    """The loop over motions for some equations."""
    return compile_ptx(thread_loop(*arithmetic_and_method(precision, 1e-13), equations))


def require_sound(ptx: str, folder: Path) -> int:
    """No foreign symbol, no rounding left open; bytes of spilled registers."""
    assert ".extern" not in ptx
    operations = ROUNDED.findall(ptx)
    assert operations
    assert all(".rn." in operation for operation in operations)
    text = assemble(ptx, folder)
    assert 0 < registers(text) <= MOST_REGISTERS
    return spills(text)


@pytest.mark.parametrize("name", ["chaplygin-sleigh-reduced", "marble-body", "ball-on-two-balls"])
def test_systems_are_assembled(name: str, tmp_path: Path) -> None:
    ptx = ptx_of(equations_of(from_catalogue(name), 0, None, False))
    assert require_sound(ptx, tmp_path) == 0


@pytest.mark.slow
@pytest.mark.parametrize("name", CATALOGUE)
def test_all_systems_are_assembled(name: str, tmp_path: Path) -> None:
    ptx = ptx_of(equations_of(from_catalogue(name), 0, None, False))
    assert require_sound(ptx, tmp_path) == 0


def test_a_section_is_assembled(tmp_path: Path) -> None:
    ball = from_catalogue("unbalanced-ball")
    section = poincare_section(ball, "gamma_3")
    assert require_sound(ptx_of(equations_of(ball, 0, section, True)), tmp_path) == 0


def test_a_deviation_is_assembled(tmp_path: Path) -> None:
    equations = equations_of(from_catalogue("chaplygin-ball"), 1, None, False)
    assert require_sound(ptx_of(equations), tmp_path) == 0


@pytest.mark.slow
@pytest.mark.parametrize(("deviations", "precision"), [(2, "double"), (6, "double"), (0, "quad")])
def test_large_states_are_assembled(deviations: int, precision: Precision, tmp_path: Path) -> None:
    """Their sums need more registers than there are, so some spill (flowlanes/docs/engine.md)."""
    equations = equations_of(from_catalogue("chaplygin-ball"), deviations, None, False)
    assert 0 < require_sound(ptx_of(equations, precision), tmp_path) < 8000


def test_spills_are_noticed(tmp_path: Path) -> None:
    ptx = ptx_of(equations_of(from_catalogue("marble-body"), 0, None, False))
    assert spills(assemble(ptx, tmp_path, "-maxrregcount=24")) > 0


def test_foreign_symbols_are_noticed(tmp_path: Path) -> None:
    ptx = compile_ptx(
        "declare double @sin(double)\n"
        "define ptx_kernel void @march(ptr %x) {\n"
        "  %a = load double, ptr %x\n"
        "  %b = call double @sin(double %a)\n"
        "  store double %b, ptr %x\n"
        "  ret void\n}\n"
    )
    with pytest.raises(AssertionError):
        require_sound(ptx, tmp_path)


def test_code_is_kept(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("FLOWLANES_CACHE", str(tmp_path))
    written = []

    def text() -> str:
        written.append(1)
        return thread_loop(
            *arithmetic_and_method(16, 1e-13),
            equations_of(from_catalogue("chaplygin-sleigh-reduced"), 0, None, False),
        )

    first = cached_ptx("a key of this test", text)
    assert f".entry {ENTRY}(" in first
    assert cached_ptx("a key of this test", text) == first
    assert written == [1]
