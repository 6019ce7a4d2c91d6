"""Arithmetic of the vector code: in doubles, and in double-double numbers."""

from __future__ import annotations

from fractions import Fraction
from typing import Protocol, TypeAlias, TypeVar

from ...errors import InputError
from .ir_writer import IRWriter

#: Name of one vector register, or names of two that together hold a double-double number.
V = TypeVar("V")
#: The two registers of a double-double number.
Registers: TypeAlias = tuple[str, str]


class Arithmetic(Protocol[V]):
    """Arithmetic whose operations are emitted as vector instructions."""

    def __init__(self, writer: IRWriter) -> None: ...

    writer: IRWriter
    #: Number of doubles per number.
    words: int
    #: Number of bits of precision.
    bits: int

    def number(self, value: Fraction) -> V:
        """A constant."""
        ...

    def load(self, base: str, index: str | int) -> V:
        """An element of an array."""
        ...

    def store(self, value: V, base: str, index: str | int) -> None:
        """Write an element of an array."""
        ...

    def add(self, a: V, b: V) -> V:
        """a + b."""
        ...

    def sub(self, a: V, b: V) -> V:
        """a − b."""
        ...

    def mul(self, a: V, b: V) -> V:
        """a b."""
        ...

    def fma(self, a: V, b: V, c: V) -> V:
        """a b + c."""
        ...

    def plus(self, a: V, b: V) -> V:
        """a + b with an error relative to the larger of the two."""
        ...

    def multiply_add(self, a: V, b: V, c: V) -> V:
        """a b + c with an error relative to the larger of the product and c."""
        ...

    def neg(self, a: V) -> V:
        """−a."""
        ...

    def recip(self, a: V) -> V:
        """1/a."""
        ...

    def sqrt(self, a: V) -> V:
        """The square root of a."""
        ...

    def difference(self, a: str, b: str) -> V:
        """Difference of two registers, with all digits of the arithmetic."""
        ...

    def leading(self, a: V) -> str:
        """Number rounded to one register."""
        ...

    def whole(self, a: str) -> V:
        """One register converted to a number."""
        ...

    def choose(self, mask: str, yes: V, no: V) -> V:
        """`yes` where the mask is set, else `no`."""
        ...


def _nearest_double(value: Fraction) -> float:
    """Double nearest to a constant of a formula.

    Raises InputError outside the range of doubles.
    """
    try:
        return float(value)
    except OverflowError:
        size = len(str(abs(round(value)))) - 1
        raise InputError(
            f"a formula contains a number of about 1e{size}; the largest that can be computed "
            "with is 1.8e308"
        ) from None


class Double:
    """Numbers of 53 bits: one register."""

    words, bits = 1, 53

    def __init__(self, writer: IRWriter) -> None:
        self.writer = writer

    def number(self, value: Fraction) -> str:
        """A constant, rounded."""
        return self.writer.constant(_nearest_double(value))

    def load(self, base: str, index: str | int) -> str:
        """An element of an array of vectors."""
        w = self.writer
        return w.load(w.type, w.address(w.type, base, index))

    def store(self, value: str, base: str, index: str | int) -> None:
        """Write an element of an array of vectors."""
        w = self.writer
        w.store(w.type, value, w.address(w.type, base, index))

    def add(self, a: str, b: str) -> str:
        """a + b."""
        return self.writer.op("fadd", a, b)

    def sub(self, a: str, b: str) -> str:
        """a − b."""
        return self.writer.op("fsub", a, b)

    def mul(self, a: str, b: str) -> str:
        """a b."""
        return self.writer.op("fmul", a, b)

    def fma(self, a: str, b: str, c: str) -> str:
        """a b + c, rounded once."""
        return self.writer.call("fma", a, b, c)

    def plus(self, a: str, b: str) -> str:
        """a + b."""
        return self.add(a, b)

    def multiply_add(self, a: str, b: str, c: str) -> str:
        """a b + c, rounded once."""
        return self.fma(a, b, c)

    def neg(self, a: str) -> str:
        """−a."""
        return self.writer.op("fneg", a)

    def recip(self, a: str) -> str:
        """1/a."""
        return self.writer.op("fdiv", self.number(Fraction(1)), a)

    def sqrt(self, a: str) -> str:
        """The square root of a."""
        return self.writer.call("sqrt", a)

    def difference(self, a: str, b: str) -> str:
        """The difference of two registers, rounded."""
        return self.sub(a, b)

    def leading(self, a: str) -> str:
        """The number as one register."""
        return a

    def whole(self, a: str) -> str:
        """One register converted to a number."""
        return a

    def choose(self, mask: str, yes: str, no: str) -> str:
        """`yes` where the mask is set, else `no`."""
        return self.writer.choose(mask, yes, no)


class WithoutFused(Double):
    """Doubles on a machine without fused multiply-add.

    Where the rounding error of a product is needed, the product is split (Dekker 1971); in other
    formulas products and sums are rounded separately.
    """

    def fma(self, a: str, b: str, c: str) -> str:
        """a b + c, with an error of little more than half a unit in the last place."""
        w = self.writer
        product, lost = split_product(w, a, b)
        total = w.op("fadd", product, c)
        moved = w.op("fsub", total, product)
        rest = w.op("fsub", product, w.op("fsub", total, moved))
        rest = w.op("fadd", rest, w.op("fsub", c, moved))
        return w.op("fadd", total, w.op("fadd", rest, lost))

    def multiply_add(self, a: str, b: str, c: str) -> str:
        """a b + c, rounded twice."""
        w = self.writer
        return w.op("fadd", w.op("fmul", a, b), c)


def split_product(w: IRWriter, a: str, b: str) -> Registers:
    """A product and its rounding error, without fused operations (Dekker)."""
    product = w.op("fmul", a, b)
    (high, low), (other_high, other_low) = _halves(w, a), _halves(w, b)
    lost = w.op("fsub", w.op("fmul", high, other_high), product)
    lost = w.op("fadd", lost, w.op("fmul", high, other_low))
    lost = w.op("fadd", lost, w.op("fmul", low, other_high))
    return product, w.op("fadd", lost, w.op("fmul", low, other_low))


def _halves(w: IRWriter, a: str) -> Registers:
    """A number as the sum of two numbers of 26 bits (Veltkamp)."""
    scaled = w.op("fmul", a, w.constant(2.0**27 + 1.0))
    high = w.op("fsub", scaled, w.op("fsub", scaled, a))
    return high, w.op("fsub", a, high)


class Pair:
    """Numbers of 106 bits: unevaluated sums of two doubles (double-double).

    The second double is at most half a unit in the last place of the first (Dekker 1971); sums and
    products are those of Joldes, Muller, Popescu 2017, with relative errors below 2⁻¹⁰⁴.
    """

    words, bits = 2, 104

    def __init__(self, writer: IRWriter) -> None:
        self.writer = writer

    def number(self, value: Fraction) -> Registers:
        """A constant, rounded."""
        high = _nearest_double(value)
        return self.writer.constant(high), self.writer.constant(float(value - Fraction(high)))

    def load(self, base: str, index: str | int) -> Registers:
        """An element of an array of pairs of vectors."""
        w = self.writer
        kind = f"[2 x {w.type}]"
        place = w.address(kind, base, index)
        return w.load(w.type, place), w.load(w.type, w.address(w.type, place, 1))

    def store(self, value: Registers, base: str, index: str | int) -> None:
        """Write an element of an array of pairs of vectors."""
        w = self.writer
        place = w.address(f"[2 x {w.type}]", base, index)
        w.store(w.type, value[0], place)
        w.store(w.type, value[1], w.address(w.type, place, 1))

    def two_sum(self, a: str, b: str) -> Registers:
        """The exact sum of two doubles (Knuth)."""
        w = self.writer
        s = w.op("fadd", a, b)
        t = w.op("fsub", s, a)
        error = w.op("fadd", w.op("fsub", a, w.op("fsub", s, t)), w.op("fsub", b, t))
        return s, error

    def fast_sum(self, a: str, b: str) -> Registers:
        """The exact sum of two doubles, for |a| ≥ |b| (Dekker)."""
        w = self.writer
        s = w.op("fadd", a, b)
        return s, w.op("fsub", b, w.op("fsub", s, a))

    def add(self, a: Registers, b: Registers) -> Registers:
        """a + b."""
        w = self.writer
        s, s_error = self.two_sum(a[0], b[0])
        t, t_error = self.two_sum(a[1], b[1])
        s, s_error = self.fast_sum(s, w.op("fadd", s_error, t))
        return self.fast_sum(s, w.op("fadd", s_error, t_error))

    def sub(self, a: Registers, b: Registers) -> Registers:
        """a − b."""
        return self.add(a, self.neg(b))

    def mul(self, a: Registers, b: Registers) -> Registers:
        """a b."""
        w = self.writer
        p = w.op("fmul", a[0], b[0])
        error = w.call("fma", a[0], b[0], w.op("fneg", p))
        low = w.op("fmul", a[1], b[1])
        low = w.call("fma", a[0], b[1], low)
        low = w.call("fma", a[1], b[0], low)
        return self.fast_sum(p, w.op("fadd", error, low))

    def fma(self, a: Registers, b: Registers, c: Registers) -> Registers:
        """a b + c."""
        return self.add(self.mul(a, b), c)

    def plus(self, a: Registers, b: Registers) -> Registers:
        """a + b with half as many operations.

        If a and b nearly cancel, the error is below 2⁻¹⁰⁴ of them, not of the difference: rounded
        inputs are uncertain by as much.
        """
        w = self.writer
        s, error = self.two_sum(a[0], b[0])
        return self.fast_sum(s, w.op("fadd", error, w.op("fadd", a[1], b[1])))

    def multiply_add(self, a: Registers, b: Registers, c: Registers) -> Registers:
        """a b + c with an error relative to the larger of the product and c."""
        return self.plus(self.mul(a, b), c)

    def neg(self, a: Registers) -> Registers:
        """−a."""
        return self.writer.op("fneg", a[0]), self.writer.op("fneg", a[1])

    def recip(self, a: Registers) -> Registers:
        """1/a: two Newton steps from the quotient in doubles."""
        w, one = self.writer, self.number(Fraction(1))
        first = w.op("fdiv", one[0], a[0])
        left = self.sub(one, self.mul(a, self.whole(first)))
        second = w.op("fdiv", left[0], a[0])
        left = self.sub(left, self.mul(a, self.whole(second)))
        third = w.op("fdiv", left[0], a[0])
        return self.add(self.fast_sum(first, second), self.whole(third))

    def sqrt(self, a: Registers) -> Registers:
        """The square root of a; zero for zero."""
        w = self.writer
        root = w.call("sqrt", a[0])
        left = self.sub(a, self.mul(self.whole(root), self.whole(root)))
        change = w.op("fdiv", left[0], w.op("fadd", root, root))
        corrected = self.fast_sum(root, change)
        zero = w.compare("oeq", a[0], w.constant(0.0))
        return self.choose(zero, self.whole(w.constant(0.0)), corrected)

    def difference(self, a: str, b: str) -> Registers:
        """The exact difference of two registers."""
        return self.two_sum(a, self.writer.op("fneg", b))

    def leading(self, a: Registers) -> str:
        """The number rounded to one register."""
        return a[0]

    def whole(self, a: str) -> Registers:
        """One register converted to a number."""
        return a, self.writer.constant(0.0)

    def choose(self, mask: str, yes: Registers, no: Registers) -> Registers:
        """`yes` where the mask is set, else `no`."""
        w = self.writer
        return w.choose(mask, yes[0], no[0]), w.choose(mask, yes[1], no[1])


class PairWithoutFused(Pair):
    """Double-double numbers on a machine without fused multiply-add."""

    def mul(self, a: Registers, b: Registers) -> Registers:
        """a b."""
        w = self.writer
        p, error = split_product(w, a[0], b[0])
        low = w.op("fadd", w.op("fmul", a[0], b[1]), w.op("fmul", a[1], b[0]))
        return self.fast_sum(p, w.op("fadd", error, low))


def pair_of(arithmetic: Arithmetic[V]) -> Pair:
    """The arithmetic with twice the digits on the same machine."""
    fused = not isinstance(arithmetic, WithoutFused)
    return Pair(arithmetic.writer) if fused else PairWithoutFused(arithmetic.writer)
