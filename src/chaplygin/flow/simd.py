"""From terms to vector instructions: one lane per trajectory, stage, deviation or parameter.

LLVM's own language is written as text.  Every operation is exactly rounded and products are fused
into sums where the graph says so, never where a compiler likes to, so that a lane gives the same
bits at every vector width and whatever its neighbours do.
"""

from __future__ import annotations

import itertools
import struct
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any, Protocol, TypeAlias

from . import special
from .graph import Term, ordered

__all__ = ["Arithmetic", "Double", "Pair", "Value", "Writer", "evaluate", "hoisted"]

#: The name of one vector register, or of two that hold one number of twice the digits.
Value: TypeAlias = Any


class Writer:
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

    def narrow(self) -> Writer:
        """A writer of the same text for vectors of one lane."""
        other = Writer(1)
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
        """A place for a value that changes (made in the first block, whatever loop this is in)."""
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

    def at(self, kind: str, base: str, index: str | int) -> str:
        """The address of an element of an array."""
        return self.emit(f"getelementptr {kind}, ptr {base}, i64 {index}")

    def label(self, name: str) -> None:
        """Begin a block, which the one before runs into."""
        self.line(f"br label %{name}")
        self.lines.append(f"{name}:")

    @contextmanager
    def when(self, condition: str) -> Iterator[None]:
        """What is written inside happens only if a bit is set."""
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
        """A mask: where an ordered relation (``"olt"``, ``"ole"``, …) holds; never for a NaN."""
        return self.op(f"fcmp {relation}", a, b)

    def choose(self, mask: str, yes: str, no: str) -> str:
        """`yes` where the mask is set, else `no`."""
        kind = self.type
        return self.emit(f"select {self.mask} {mask}, {kind} {yes}, {kind} {no}")

    def both(self, a: str, b: str) -> str:
        """Where both masks are set."""
        return self.emit(f"and {self.mask} {a}, {b}")

    def either(self, a: str, b: str) -> str:
        """Where at least one of two masks is set."""
        return self.emit(f"or {self.mask} {a}, {b}")

    def unless(self, a: str) -> str:
        """Where a mask is not set."""
        return self.emit(f"xor {self.mask} {a}, splat (i1 true)")

    def any(self, mask: str) -> str:
        """A bit: whether a mask is set anywhere."""
        return self.emit(f"call i1 @llvm.vector.reduce.or.v{self.lanes}i1({self.mask} {mask})")

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
    """Vectors are aligned as memory is handed out; lanes are powers of two."""
    if kind.startswith("<"):
        return min(64, 8 * int(kind[1 : kind.index(" ")]))
    return 8


# --- numbers ----------------------------------------------------------------------------------


class Arithmetic(Protocol):
    """What the lanes compute with."""

    def __init__(self, writer: Writer) -> None: ...

    writer: Writer
    #: Doubles that one number takes.
    words: int
    #: Bits of a number.
    bits: int

    def number(self, value: Fraction) -> Value: ...
    def load(self, base: str, index: str | int) -> Value: ...
    def store(self, value: Value, base: str, index: str | int) -> None: ...
    def add(self, a: Value, b: Value) -> Value: ...
    def sub(self, a: Value, b: Value) -> Value: ...
    def mul(self, a: Value, b: Value) -> Value: ...
    def fma(self, a: Value, b: Value, c: Value) -> Value: ...
    def neg(self, a: Value) -> Value: ...
    def recip(self, a: Value) -> Value: ...
    def sqrt(self, a: Value) -> Value: ...
    def leading(self, a: Value) -> str: ...
    def whole(self, a: str) -> Value: ...
    def choose(self, mask: str, yes: Value, no: Value) -> Value: ...


class Double:
    """Numbers of 53 bits: one register."""

    words, bits = 1, 53

    def __init__(self, writer: Writer) -> None:
        self.writer = writer

    def number(self, value: Fraction) -> Value:
        """A constant, rounded."""
        return self.writer.constant(float(value))

    def load(self, base: str, index: str | int) -> Value:
        """An element of an array of vectors."""
        w = self.writer
        return w.load(w.type, w.at(w.type, base, index))

    def store(self, value: Value, base: str, index: str | int) -> None:
        """Write an element of an array of vectors."""
        w = self.writer
        w.store(w.type, value, w.at(w.type, base, index))

    def add(self, a: Value, b: Value) -> Value:
        """a + b."""
        return self.writer.op("fadd", a, b)

    def sub(self, a: Value, b: Value) -> Value:
        """a − b."""
        return self.writer.op("fsub", a, b)

    def mul(self, a: Value, b: Value) -> Value:
        """a b."""
        return self.writer.op("fmul", a, b)

    def fma(self, a: Value, b: Value, c: Value) -> Value:
        """a b + c, rounded once."""
        return self.writer.call("fma", a, b, c)

    def neg(self, a: Value) -> Value:
        """−a."""
        return self.writer.op("fneg", a)

    def recip(self, a: Value) -> Value:
        """1/a."""
        return self.writer.op("fdiv", self.number(Fraction(1)), a)

    def sqrt(self, a: Value) -> Value:
        """The root of a."""
        return self.writer.call("sqrt", a)

    def leading(self, a: Value) -> str:
        """The number as one register."""
        register: str = a
        return register

    def whole(self, a: str) -> Value:
        """One register as a number."""
        return a

    def choose(self, mask: str, yes: Value, no: Value) -> Value:
        """`yes` where the mask is set, else `no`."""
        return self.writer.choose(mask, yes, no)


class Pair:
    """Numbers of 106 bits: the unevaluated sum of two doubles, the second below half a unit in
    the last place of the first (Dekker 1971; sums and products as in Joldes, Muller, Popescu
    2017, with relative errors below 2⁻¹⁰⁴).
    """

    words, bits = 2, 104

    def __init__(self, writer: Writer) -> None:
        self.writer = writer

    def number(self, value: Fraction) -> Value:
        """A constant, rounded."""
        high = float(value)
        return self.writer.constant(high), self.writer.constant(float(value - Fraction(high)))

    def load(self, base: str, index: str | int) -> Value:
        """An element of an array of pairs of vectors."""
        w = self.writer
        kind = f"[2 x {w.type}]"
        place = w.at(kind, base, index)
        return w.load(w.type, place), w.load(w.type, w.at(w.type, place, 1))

    def store(self, value: Value, base: str, index: str | int) -> None:
        """Write an element of an array of pairs of vectors."""
        w = self.writer
        place = w.at(f"[2 x {w.type}]", base, index)
        w.store(w.type, value[0], place)
        w.store(w.type, value[1], w.at(w.type, place, 1))

    def two_sum(self, a: str, b: str) -> Value:
        """The sum of two doubles without error (Knuth)."""
        w = self.writer
        s = w.op("fadd", a, b)
        t = w.op("fsub", s, a)
        rest = w.op("fadd", w.op("fsub", a, w.op("fsub", s, t)), w.op("fsub", b, t))
        return s, rest

    def fast_sum(self, a: str, b: str) -> Value:
        """The same where a is the larger (Dekker)."""
        w = self.writer
        s = w.op("fadd", a, b)
        return s, w.op("fsub", b, w.op("fsub", s, a))

    def add(self, a: Value, b: Value) -> Value:
        """a + b."""
        w = self.writer
        s, s_rest = self.two_sum(a[0], b[0])
        t, t_rest = self.two_sum(a[1], b[1])
        s, s_rest = self.fast_sum(s, w.op("fadd", s_rest, t))
        return self.fast_sum(s, w.op("fadd", s_rest, t_rest))

    def sub(self, a: Value, b: Value) -> Value:
        """a − b."""
        return self.add(a, self.neg(b))

    def mul(self, a: Value, b: Value) -> Value:
        """a b."""
        w = self.writer
        p = w.op("fmul", a[0], b[0])
        rest = w.call("fma", a[0], b[0], w.op("fneg", p))
        low = w.op("fmul", a[1], b[1])
        low = w.call("fma", a[0], b[1], low)
        low = w.call("fma", a[1], b[0], low)
        return self.fast_sum(p, w.op("fadd", rest, low))

    def fma(self, a: Value, b: Value, c: Value) -> Value:
        """a b + c."""
        return self.add(self.mul(a, b), c)

    def neg(self, a: Value) -> Value:
        """−a."""
        return self.writer.op("fneg", a[0]), self.writer.op("fneg", a[1])

    def recip(self, a: Value) -> Value:
        """1/a: Newton's step from the quotient of doubles, twice."""
        w, one = self.writer, self.number(Fraction(1))
        first = w.op("fdiv", one[0], a[0])
        left = self.sub(one, self.mul(a, self.whole(first)))
        second = w.op("fdiv", left[0], a[0])
        left = self.sub(left, self.mul(a, self.whole(second)))
        third = w.op("fdiv", left[0], a[0])
        return self.add(self.fast_sum(first, second), self.whole(third))

    def sqrt(self, a: Value) -> Value:
        """The root of a; of zero it is zero."""
        w = self.writer
        root = w.call("sqrt", a[0])
        left = self.sub(a, self.mul(self.whole(root), self.whole(root)))
        change = w.op("fdiv", left[0], w.op("fadd", root, root))
        made = self.fast_sum(root, change)
        zero = w.compare("oeq", a[0], w.constant(0.0))
        return self.choose(zero, self.whole(w.constant(0.0)), made)

    def leading(self, a: Value) -> str:
        """The number rounded to one register."""
        register: str = a[0]
        return register

    def whole(self, a: str) -> Value:
        """One register as a number."""
        return a, self.writer.constant(0.0)

    def choose(self, mask: str, yes: Value, no: Value) -> Value:
        """`yes` where the mask is set, else `no`."""
        w = self.writer
        return w.choose(mask, yes[0], no[0]), w.choose(mask, yes[1], no[1])


# --- formulas ---------------------------------------------------------------------------------


def evaluate(
    arithmetic: Arithmetic, terms: Sequence[Term], leaf: Callable[[Term], Value]
) -> list[Value]:
    """Instructions that compute terms.

    Parameters
    ----------
    arithmetic : Arithmetic
    terms : sequence of Term
    leaf : callable
        The value of a term that is known; None if it is to be computed.
    """
    known: dict[int, Value] = {}
    nodes = _reached(terms, leaf, known)
    uses = Counter(id(a) for node in nodes for a in node.operands)
    uses.update(id(term) for term in terms)

    def single(node: Term) -> bool:
        return node.kind == "mul" and uses[id(node)] == 1 and id(node) not in known

    fused: dict[int, int] = {}
    inside: set[int] = set()
    for node in nodes:
        if node.kind in ("add", "sub"):
            for place in (1, 0):
                if single(node.args[place]):
                    fused[id(node)] = place
                    inside.add(id(node.args[place]))
                    break
    for node in nodes:
        if id(node) not in inside:
            known[id(node)] = _compute(arithmetic, node, fused.get(id(node)), known)
    return [known[id(term)] for term in terms]


def _reached(
    terms: Sequence[Term], leaf: Callable[[Term], Value], known: dict[int, Value]
) -> list[Term]:
    """What is to be computed, operands first; what is known goes into `known`."""
    seen: set[int] = set()
    found: list[Term] = []
    for root in terms:
        pending: list[tuple[Term, bool]] = [(root, False)]
        while pending:
            node, ready = pending.pop()
            if ready:
                found.append(node)
                continue
            if id(node) in seen:
                continue
            seen.add(id(node))
            value = leaf(node)
            if value is not None:
                known[id(node)] = value
                continue
            pending.append((node, True))
            pending.extend((a, False) for a in reversed(node.operands))
    return found


def _compute(
    arithmetic: Arithmetic, node: Term, fused: int | None, known: Mapping[int, Value]
) -> Value:
    if fused is not None:
        other = known[id(node.args[1 - fused])]
        a, b = (known[id(x)] for x in node.args[fused].args)
        if node.kind == "sub":
            if fused == 1:
                a = arithmetic.neg(a)
            else:
                other = arithmetic.neg(other)
        return arithmetic.fma(a, b, other)
    values = [known[id(a)] for a in node.operands]
    match node.kind:
        case "number":
            return arithmetic.number(node.args[0])
        case "add":
            return arithmetic.add(*values)
        case "sub":
            return arithmetic.sub(*values)
        case "mul":
            return arithmetic.mul(*values)
        case "neg":
            return arithmetic.neg(*values)
        case "recip":
            return arithmetic.recip(*values)
        case "sqrt":
            return arithmetic.sqrt(*values)
        case "positive":
            w = arithmetic.writer
            mask = w.compare("ogt", arithmetic.leading(values[0]), w.constant(0.0))
            return arithmetic.choose(mask, values[1], values[2])
        case _:
            return special.FUNCTIONS[node.kind](arithmetic, *values)


def hoisted(terms: Sequence[Term]) -> list[Term]:
    """Terms that depend on parameters alone and are used by those that depend on the state.

    They are computed once for a trajectory; numbers are not among them.
    """
    nodes = ordered(terms)
    moving: set[int] = set()
    for node in nodes:
        if node.kind == "state" or any(id(a) in moving for a in node.operands):
            moving.add(id(node))
    wanted: dict[int, Term] = {}
    for node in nodes:
        if id(node) in moving:
            wanted |= {id(a): a for a in node.operands if id(a) not in moving}
    wanted |= {id(t): t for t in terms if id(t) not in moving}
    return [t for t in wanted.values() if t.kind != "number"]
