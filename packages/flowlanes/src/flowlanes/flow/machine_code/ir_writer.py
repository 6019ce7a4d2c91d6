"""Write LLVM functions on vectors of doubles."""

from __future__ import annotations

import itertools
import struct
from collections.abc import Callable, Iterator
from contextlib import contextmanager


class IRWriter:
    """LLVM text of one function.

    Parameters
    ----------
    lanes : int
        Number of doubles in a vector.
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
        """Writer of the same function for vectors of one lane."""
        other = IRWriter(1)
        other.entry, other.lines, other._numbers = self.entry, self.lines, self._numbers
        return other

    def name(self) -> str:
        """Create a new name."""
        return f"v{next(self._numbers)}"

    def line(self, text: str) -> None:
        """Emit an instruction without a result."""
        self.lines.append(f"  {text}")

    def emit(self, text: str) -> str:
        """Emit an instruction with a result; return its name."""
        name = f"%{self.name()}"
        self.lines.append(f"  {name} = {text}")
        return name

    # --- memory and control ------------------------------------------------------------------

    def variable(self, kind: str, value: str) -> str:
        """Address of a local variable, allocated in the first block even inside a loop."""
        place = f"%{self.name()}"
        self.entry.append(f"  {place} = alloca {kind}, align 64")
        self.store(kind, value, place)
        return place

    def load(self, kind: str, place: str) -> str:
        """Load from an address."""
        return self.emit(f"load {kind}, ptr {place}, align {_align(kind)}")

    def store(self, kind: str, value: str, place: str) -> None:
        """Store to an address."""
        self.line(f"store {kind} {value}, ptr {place}, align {_align(kind)}")

    def address(self, kind: str, base: str, index: str | int) -> str:
        """The address of an element of an array."""
        return self.emit(f"getelementptr {kind}, ptr {base}, i64 {index}")

    def label(self, name: str) -> None:
        """Begin a block that continues the previous one."""
        self.line(f"br label %{name}")
        self.lines.append(f"{name}:")

    @contextmanager
    def branch(self, condition: str) -> Iterator[None]:
        """Branch whose instructions are executed only if a bit is set."""
        inside, after = self.name(), self.name()
        self.line(f"br i1 {condition}, label %{inside}, label %{after}")
        self.lines.append(f"{inside}:")
        yield
        self.label(after)

    @contextmanager
    def forever(self) -> Iterator[Callable[[str], None]]:
        """Loop; the yielded function leaves it if a bit is set."""
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
        """Loop over integers from `start` to below `end`."""
        place = self.variable("i64", str(start))
        with self.forever() as leave:
            index = self.load("i64", place)
            leave(self.emit(f"icmp sge i64 {index}, {end}"))
            yield index
            self.store("i64", self.emit(f"add i64 {index}, 1"), place)

    # --- vectors -----------------------------------------------------------------------------

    def op(self, name: str, *values: str) -> str:
        """Emit an instruction on vectors of doubles."""
        return self.emit(f"{name} {self.type} {', '.join(values)}")

    def call(self, name: str, *values: str) -> str:
        """Emit an intrinsic on vectors of doubles."""
        listed = ", ".join(f"{self.type} {v}" for v in values)
        return self.emit(f"call {self.type} @llvm.{name}.v{self.lanes}f64({listed})")

    def compare(self, relation: str, a: str, b: str) -> str:
        """The mask of an ordered relation (``"olt"``, ``"ole"``, …); false for NaN."""
        return self.op(f"fcmp {relation}", a, b)

    def choose(self, mask: str, yes: str, no: str) -> str:
        """`yes` where the mask is set, else `no`."""
        kind = self.type
        # A dependence on the stored value is removed here: otherwise LLVM would turn a choice that
        # is written back into a masked store, which is slow on AMD processors.
        other = self.emit(f"freeze {kind} {no}")
        return self.emit(f"select {self.mask} {mask}, {kind} {yes}, {kind} {other}")

    def conjunction(self, a: str, b: str) -> str:
        """Mask that is set where both masks are set."""
        return self.emit(f"and {self.mask} {a}, {b}")

    def disjunction(self, a: str, b: str) -> str:
        """Mask that is set where at least one of two masks is set."""
        return self.emit(f"or {self.mask} {a}, {b}")

    def complement(self, a: str) -> str:
        """The complement of a mask."""
        return self.emit(f"xor {self.mask} {a}, splat (i1 true)")

    def any(self, mask: str) -> str:
        """Bit that is set if a mask is set anywhere."""
        return self.emit(f"call i1 @llvm.vector.reduce.or.v{self.lanes}i1({self.mask} {mask})")

    def inverse_root(self, value: str, degree: int) -> str:
        """value^(−1/degree) to about a percent, from the exponent bits; degree a power of 2.

        The bits of a double, read as an integer, are about 2⁵² (1023 + log₂ x).
        """
        bits = self.emit(f"bitcast {self.type} {value} to {self.whole}")
        share = self.emit(f"lshr {self.whole} {bits}, splat (i64 {degree.bit_length() - 1})")
        one = 1023 << 52
        turned = self.emit(f"sub {self.whole} splat (i64 {one + one // degree}), {share}")
        return self.emit(f"bitcast {self.whole} {turned} to {self.type}")

    def splat(self, value: str) -> str:
        """Scalar in all lanes."""
        one = self.emit(f"insertelement {self.type} poison, double {value}, i64 0")
        zeros = f"<{self.lanes} x i32> zeroinitializer"
        return self.emit(f"shufflevector {self.type} {one}, {self.type} poison, {zeros}")

    def constant(self, value: float) -> str:
        """Number in all lanes."""
        return f"splat (double {literal(value)})"

    def text(self, head: str, attributes: str = "") -> str:
        """Complete function."""
        body = "\n".join(["entry:", *self.entry, *self.lines, "  ret void"])
        return f"define {head} {attributes} {{\n{body}\n}}\n"


def literal(value: float) -> str:
    """A double as an exact literal."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


def _align(kind: str) -> int:
    """Alignment of vectors: that of `aligned_zeros`; the number of lanes is a power of two."""
    if kind.startswith("<"):
        return min(64, 8 * int(kind[1 : kind.index(" ")]))
    return 8
