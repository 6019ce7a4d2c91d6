"""Numbers as sums of a head and a tail, and bit operations on doubles."""

from __future__ import annotations

from fractions import Fraction
from typing import Generic, NamedTuple

from .approximation import parts, series
from .arithmetic import Arithmetic, V
from .ir_writer import IRWriter

#: Adding this constant rounds to an integer, which then occupies the lowest bits (Moler's trick).
#: Half of the machines lack a vector instruction for this.
MAGIC = 1.5 * 2.0**52


class HeadTail(NamedTuple, Generic[V]):
    """A number as the sum of a rounded number and a small remainder."""

    head: V
    tail: V


# --- bits -------------------------------------------------------------------------------------


def as_integers(w: IRWriter, a: str) -> str:
    """Reinterpret doubles as integers."""
    return w.emit(f"bitcast {w.type} {a} to {w.whole}")


def as_doubles(w: IRWriter, bits: str) -> str:
    """Reinterpret integers as doubles."""
    return w.emit(f"bitcast {w.whole} {bits} to {w.type}")


def integers(w: IRWriter, name: str, a: str, b: int) -> str:
    """An integer instruction with a constant."""
    return w.emit(f"{name} {w.whole} {a}, splat (i64 {b})")


def is_negative(w: IRWriter, a: str) -> str:
    """The mask of negative numbers, from their sign bit."""
    return w.emit(f"icmp slt {w.whole} {as_integers(w, a)}, zeroinitializer")


def is_odd(w: IRWriter, bits: str) -> str:
    """The mask of odd integers."""
    return w.emit(f"trunc {w.whole} {bits} to {w.mask}")


def nearest(w: IRWriter, a: str, factor: Fraction) -> tuple[str, str]:
    """Integer nearest to a multiple: as a double, and in the lowest bits."""
    magic = w.constant(MAGIC)
    moved = w.call("fma", a, w.constant(float(factor)), magic)
    return w.op("fsub", moved, magic), as_integers(w, moved)


def power_of_two(w: IRWriter, n: str) -> str:
    """2ⁿ for an integer (as a double) between −1022 and 1023."""
    bits = as_integers(w, w.op("fadd", n, w.constant(MAGIC)))
    return as_doubles(w, integers(w, "shl", integers(w, "add", bits, 1023), 52))


# --- sums, quotients and polynomials ----------------------------------------------------------


def unit(k: Arithmetic[V]) -> V:
    """1."""
    return k.number(Fraction(1))


def fast_sum(k: Arithmetic[V], a: V, b: V) -> HeadTail[V]:
    """The exact sum a + b for |a| ≥ |b| (Dekker)."""
    head = k.add(a, b)
    return HeadTail(head, k.sub(b, k.sub(head, a)))


def any_sum(k: Arithmetic[V], a: V, b: V) -> HeadTail[V]:
    """The exact sum a + b (Knuth)."""
    head = k.add(a, b)
    moved = k.sub(head, a)
    return HeadTail(head, k.add(k.sub(a, k.sub(head, moved)), k.sub(b, moved)))


def total_of(k: Arithmetic[V], a: HeadTail[V]) -> V:
    """Convert to a single number."""
    return k.add(a.head, a.tail)


def select(k: Arithmetic[V], mask: str, yes: HeadTail[V], no: HeadTail[V]) -> HeadTail[V]:
    """`yes` where the mask is set, else `no`."""
    return HeadTail(k.choose(mask, yes.head, no.head), k.choose(mask, yes.tail, no.tail))


def quotient(k: Arithmetic[V], a: HeadTail[V], b: HeadTail[V]) -> HeadTail[V]:
    """a/b."""
    inverse = k.recip(b.head)
    head = k.mul(a.head, inverse)
    minus = k.neg(head)
    left = k.fma(minus, b.tail, k.add(k.fma(minus, b.head, a.head), a.tail))
    return HeadTail(head, k.mul(left, inverse))


def polynomial(k: Arithmetic[V], name: str, t: V) -> V:
    """Smooth part of a function, by Horner's rule.

    High-order terms are so small that only their first 53 bits matter, so they use one register in
    any arithmetic.
    """
    approximation = series(name, k.bits + 6)
    sizes = [
        abs(c) * Fraction(approximation.reach) ** i
        for i, c in enumerate(approximation.coefficients)
    ]
    short = [size * 2 ** (k.bits - 50) < sizes[0] for size in sizes]
    w, lead = k.writer, k.leading(t)
    *others, top = zip(approximation.coefficients, short, strict=True)
    register = w.constant(float(top[0]))
    total: V | None = None
    for coefficient, small in reversed(others):
        if small:
            register = w.call("fma", register, lead, w.constant(float(coefficient)))
        else:
            total = k.whole(register) if total is None else total
            total = k.fma(total, t, k.number(coefficient))
    assert total is not None
    return total


def difference(k: Arithmetic[V], a: HeadTail[V], b: HeadTail[V]) -> HeadTail[V]:
    """a − b, where |a| ≥ |b| or a is zero."""
    total = fast_sum(k, a.head, k.neg(b.head))
    return HeadTail(total.head, k.add(total.tail, k.sub(a.tail, b.tail)))


def constant(k: Arithmetic[V], name: str, factor: Fraction) -> HeadTail[V]:
    """Constant and its rounding error."""
    head, tail = parts(name, (53 * k.words,))
    return HeadTail(k.number(head * factor), k.number(tail * factor))


def where(k: Arithmetic[V], x: V, relation: str, limit: float) -> str:
    """Mask of the lanes in which x satisfies a relation with a number."""
    w = k.writer
    return w.compare(relation, k.leading(x), w.constant(limit))


def where_constant(k: Arithmetic[V], mask: str, value: float, result: V) -> V:
    """Replace a result by a constant where a mask is set."""
    return k.choose(mask, k.whole(k.writer.constant(value)), result)


def copy_sign(k: Arithmetic[V], x: V, magnitude: V) -> V:
    """Number with the sign of x."""
    return k.choose(is_negative(k.writer, k.leading(x)), k.neg(magnitude), magnitude)


def reduce_argument(
    k: Arithmetic[V], x: V, name: str, factor: Fraction
) -> tuple[HeadTail[V], str, str]:
    """Subtract from x the nearest multiple of a constant; also return the multiplier n.

    n is returned as a double, and as an integer in the lowest bits.

    Multiples of short parts of the constant are subtracted one after another, all but the last two
    exactly (Cody and Waite 1980; with fused products Boldo, Daumas and Li 2009).
    """
    w = k.writer
    *pieces, _ = (piece * factor for piece in parts(name, (53,) * (k.words + 2)))
    turns, bits = nearest(w, k.leading(x), 1 / sum(pieces, Fraction(0)))
    n = k.whole(turns)
    *exact, next_to_last, last = (k.number(-piece) for piece in pieces)
    for piece in exact:
        x = k.fma(n, piece, x)
    product = k.mul(n, next_to_last)
    lost = k.fma(n, next_to_last, k.neg(product))
    head, tail = any_sum(k, x, product)
    return HeadTail(head, k.add(tail, k.fma(n, last, lost))), turns, bits
