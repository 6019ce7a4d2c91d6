"""The text of functions: loops, branches, places, masks, run as machine code."""

from __future__ import annotations

import ctypes
import math
from collections.abc import Callable

import llvmlite.binding as llvm
import numpy as np
import pytest
from hypothesis import given, strategies as st

from flowlanes.flow.machine_code.ir_writer import IRWriter, literal
from flowlanes.flow.machine_code.jit import ATTRIBUTES, aligned_zeros, load_code, optimise

WIDTHS = pytest.mark.parametrize("lanes", [1, 2, 4, 8, 16])
_P = ctypes.c_void_p


def run(lanes: int, write: Callable[[IRWriter], None], given: list[float]) -> list[float]:
    """What instructions make of an array of doubles."""
    w = IRWriter(lanes)
    write(w)
    text = w.text("void @work(ptr %data, i64 %count)", "#0")
    code = load_code(text, lambda: (text, 0), {"work": (_P, ctypes.c_int64)})
    data = aligned_zeros(max(len(given), lanes))
    data[: len(given)] = given
    code.functions["work"](data.ctypes.data, len(given))
    return data[: len(given)].tolist()


@given(st.floats(allow_nan=False))
def test_literals_are_the_number_to_the_bit(value: float) -> None:
    text = literal(value)
    found = np.array([int(text, 16)], dtype=np.uint64).view(float)[0]
    assert found == value
    assert math.copysign(1, found) == math.copysign(1, value)


def test_loops_and_branches() -> None:
    """Each even entry is doubled, each odd one left; a loop within a loop counts up."""

    def write(w: IRWriter) -> None:
        with w.count("%count") as i:
            place = w.address("double", "%data", i)
            even = w.emit(f"icmp eq i64 {w.emit(f'urem i64 {i}, 2')}, 0")
            with w.branch(even):
                value = w.load("double", place)
                w.store("double", w.emit(f"fadd double {value}, {value}"), place)
            with w.count(3, 1):
                value = w.load("double", place)
                w.store("double", w.emit(f"fadd double {value}, {literal(10.0)}"), place)

    assert run(1, write, [1, 2, 3, 4, 5]) == [22, 22, 26, 24, 30]


def test_a_loop_without_turns() -> None:
    def write(w: IRWriter) -> None:
        with w.count("%count", 7) as i:
            w.store("double", literal(-1.0), w.address("double", "%data", i))

    assert run(1, write, [1, 2, 3]) == [1, 2, 3]


def test_leaving_a_loop_from_several_places() -> None:
    """Sum until the total passes 10 or the array ends; a place keeps it through the loop."""

    def write(w: IRWriter) -> None:
        total = w.variable("double", "0.0")
        index = w.variable("i64", "0")
        with w.forever() as leave:
            i = w.load("i64", index)
            leave(w.emit(f"icmp sge i64 {i}, %count"))
            more = w.load("double", w.address("double", "%data", i))
            w.store("double", w.emit(f"fadd double {w.load('double', total)}, {more}"), total)
            w.store("i64", w.emit(f"add i64 {i}, 1"), index)
            leave(w.emit(f"fcmp ogt double {w.load('double', total)}, {literal(10.0)}"))
        w.store("double", w.load("double", total), "%data")

    assert run(1, write, [1, 2, 3, 2])[0] == 8
    assert run(1, write, [4, 5, 6, 7])[0] == 15


@WIDTHS
def test_masks(lanes: int) -> None:
    """Compared, joined, turned round, chosen by; a NaN is in no order."""

    def write(w: IRWriter) -> None:
        x = w.load(w.type, "%data")
        above = w.compare("ogt", x, w.constant(1.0))
        below = w.compare("olt", x, w.constant(3.0))
        inside = w.conjunction(above, below)
        outside = w.conjunction(w.complement(inside), w.disjunction(above, below))
        value = w.choose(inside, w.constant(10.0), w.choose(outside, w.constant(-10.0), x))
        w.store(w.type, value, "%data")

    first = [0.5, 2.0, 3.5, math.nan, 1.0, 3.0, 2.9, -4.0][:lanes]
    right = [-10.0, 10.0, -10.0, math.nan, -10.0, -10.0, 10.0, -10.0][:lanes]
    assert run(lanes, write, first) == pytest.approx(right, nan_ok=True)


@pytest.mark.parametrize(
    "features, masked", [("+avx2,+fma", "vmaskmov"), ("+avx512f,+avx512vl", ") {%k")]
)
def test_choices_are_stored_whole(features: str, masked: str) -> None:
    """Back to where one of the two came from; stores through a mask are slow on some processors."""
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    target = llvm.Target.from_triple("x86_64-unknown-linux-gnu")
    machine = target.create_target_machine(features=features, opt=2)

    w = IRWriter(8)
    x, y = w.load(w.type, "%data"), w.load(w.type, w.address(w.type, "%data", 1))
    w.store(w.type, w.choose(w.compare("olt", x, y), y, x), "%data")
    text = w.text("void @work(ptr %data)", "#0") + ATTRIBUTES
    assert masked not in machine.emit_assembly(optimise(text, machine))


@WIDTHS
def test_any_and_splat(lanes: int) -> None:
    """A bit for all lanes decides; the first entry is spread over them."""

    def write(w: IRWriter) -> None:
        x = w.load(w.type, "%data")
        with w.branch(w.any(w.compare("olt", x, w.constant(0.0)))):
            w.store(w.type, w.splat(w.load("double", "%data")), "%data")

    quiet = [float(k + 1) for k in range(lanes)]
    assert run(lanes, write, quiet) == quiet
    loud = [*quiet[:-1], -1.0]
    assert run(lanes, write, loud) == [loud[0]] * lanes


def test_a_narrow_writer_shares_its_text() -> None:
    w = IRWriter(8)
    thin = w.narrow()
    assert (thin.lanes, thin.type) == (1, "<1 x double>")
    names = [w.name(), thin.name(), w.name()]
    assert len(set(names)) == 3
    thin.line("nothing")
    assert w.lines == ["  nothing"]


def test_places_are_made_in_the_first_block() -> None:
    """A place made in a loop takes room once, not in every turn."""
    w = IRWriter(4)
    with w.count(5):
        w.variable("double", "0.0")
    text = w.text("void @f()")
    assert text.count("alloca") == 2
    assert text.index("alloca") < text.index("br label")
    assert text.rindex("alloca") < text.index("br label")
