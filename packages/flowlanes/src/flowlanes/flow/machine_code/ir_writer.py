"""The text of functions in LLVM's language, in vectors of doubles."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager


class IRWriter:
    """The text of one function.

    Parameters
    ----------
    lanes : int
        Doubles in a vector.
    """

    def __init__(self, lanes: int) -> None:
        self.lanes = lanes
        self.type = f"<{lanes} x double>"
        self.mask = f"<{lanes} x i1>"
        self.whole = f"<{lanes} x i64>"
        self.entry: list[str] = []
        self.lines: list[str] = []
        self._numbers = itertools.count()

    def narrow(self) -> IRWriter:
        """A writer of the same text for vectors of one lane."""
        other = IRWriter(1)
        other.entry, other.lines, other._numbers = self.entry, self.lines, self._numbers
        return other

    def name(self) -> str:
        """A fresh name."""
        return f"v{next(self._numbers)}"

    def line(self, text: str) -> None:
        """An instruction without a result."""
        self.lines.append(f"  {text}")

    def emit(self, text: str) -> str:
        """An instruction with a result; returns its name."""
        name = f"%{self.name()}"
        self.lines.append(f"  {name} = {text}")
        return name

    # --- memory and control ------------------------------------------------------------------

    def variable(self, kind: str, value: str) -> str:
        """The address of a variable, allocated in the first block even inside a loop."""
        place = f"%{self.name()}"
        self.entry.append(f"  {place} = alloca {kind}, align 64")
        self.store(kind, value, place)
        return place

    def load(self, kind: str, place: str) -> str:
        """Read a place."""
        return self.emit(f"load {kind}, ptr {place}, align {_align(kind)}")

    def store(self, kind: str, value: str, place: str) -> None:
        """Write a place."""
        self.line(f"store {kind} {value}, ptr {place}, align {_align(kind)}")

    def address(self, kind: str, base: str, index: str | int) -> str:
        """The address of an element of an array."""
        return self.emit(f"getelementptr {kind}, ptr {base}, i64 {index}")

    def label(self, name: str) -> None:
        """Begin a block, which the one before runs into."""
        self.line(f"br label %{name}")
        self.lines.append(f"{name}:")

    @contextmanager
    def branch(self, condition: str) -> Iterator[None]:
        """A branch: instructions inside are executed only if a bit is set."""
        inside, after = self.name(), self.name()
        self.line(f"br i1 {condition}, label %{inside}, label %{after}")
        self.lines.append(f"{inside}:")
        yield
        self.label(after)

    @contextmanager
    def forever(self) -> Iterator[Callable[[str], None]]:
        """A loop; call what it gives with a bit to leave when that is set."""
        head, after = self.name(), self.name()
        self.label(head)

        def leave(condition: str) -> None:
            on = self.name()
            self.line(f"br i1 {condition}, label %{after}, label %{on}")
            self.lines.append(f"{on}:")

        yield leave
        self.line(f"br label %{head}")
        self.lines.append(f"{after}:")

    @contextmanager
    def count(self, end: str | int, start: str | int = 0) -> Iterator[str]:
        """A loop over integers from `start` below `end`."""
        place = self.variable("i64", str(start))
        with self.forever() as leave:
            index = self.load("i64", place)
            leave(self.emit(f"icmp sge i64 {index}, {end}"))
            yield index
            self.store("i64", self.emit(f"add i64 {index}, 1"), place)

    # --- vectors -----------------------------------------------------------------------------

    def op(self, name: str, *values: str) -> str:
        """An instruction on vectors of doubles."""
        return self.emit(f"{name} {self.type} {', '.join(values)}")

    def call(self, name: str, *values: str) -> str:
        """An intrinsic on vectors of doubles."""
        listed = ", ".join(f"{self.type} {v}" for v in values)
        return self.emit(f"call {self.type} @llvm.{name}.v{self.lanes}f64({listed})")

    def compare(self, relation: str, a: str, b: str) -> str:
        """The mask of an ordered relation (``"olt"``, ``"ole"``, …); unset for a NaN."""
        return self.op(f"fcmp {relation}", a, b)

    def choose(self, mask: str, yes: str, no: str) -> str:
        """`yes` where the mask is set, else `no`."""
        kind = self.type
        # a value without history: a choice that goes back to where one of the two came from would
        # be stored through the mask, which AMD's processors do slowly
        other = self.emit(f"freeze {kind} {no}")
        return self.emit(f"select {self.mask} {mask}, {kind} {yes}, {kind} {other}")

    def conjunction(self, a: str, b: str) -> str:
        """The mask that is set where both are."""
        return self.emit(f"and {self.mask} {a}, {b}")

    def disjunction(self, a: str, b: str) -> str:
        """The mask that is set where at least one of two is."""
        return self.emit(f"or {self.mask} {a}, {b}")

    def complement(self, a: str) -> str:
        """The complement of a mask."""
        return self.emit(f"xor {self.mask} {a}, splat (i1 true)")

    def any(self, mask: str) -> str:
        """A bit: whether a mask is set anywhere."""
        return self.emit(f"call i1 @llvm.vector.reduce.or.v{self.lanes}i1({self.mask} {mask})")

    def inverse_root(self, value: str, degree: int) -> str:
        """value^(−1/degree) to a hundredth, from the exponent's bits; degree a power of 2.

        The bits of a double, as an integer, are about 2⁵² (1023 + log₂ x).
        """
        bits = self.emit(f"bitcast {self.type} {value} to {self.whole}")
        share = self.emit(f"lshr {self.whole} {bits}, splat (i64 {degree.bit_length() - 1})")
        one = 1023 << 52
        turned = self.emit(f"sub {self.whole} splat (i64 {one + one // degree}), {share}")
        return self.emit(f"bitcast {self.whole} {turned} to {self.type}")

    def splat(self, value: str) -> str:
        """A scalar in all lanes."""
        one = self.emit(f"insertelement {self.type} poison, double {value}, i64 0")
        zeros = f"<{self.lanes} x i32> zeroinitializer"
        return self.emit(f"shufflevector {self.type} {one}, {self.type} poison, {zeros}")

    def constant(self, value: float) -> str:
        """A number in all lanes."""
        return f"splat (double {literal(value)})"

    def text(self, head: str, attributes: str = "") -> str:
        """The finished function."""
        body = "\n".join(["entry:", *self.entry, *self.lines, "  ret void"])
        return f"define {head} {attributes} {{\n{body}\n}}\n"


def literal(value: float) -> str:
    """A double, to the bit."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


def _align(kind: str) -> int:
    """Vectors are aligned_zeros as memory is handed out; lanes are powers of two."""
    if kind.startswith("<"):
        return min(64, 8 * int(kind[1 : kind.index(" ")]))
    return 8
