"""Functions of one number and more, in vector instructions: no branches, no tables, no calls.

Every function is written once over an arithmetic, so that doubles and pairs of doubles share it.
The argument is reduced to a short interval; there the function is its leading part, exact, and a
polynomial times something small.  Both are kept apart as long as anything is done with them (a
`Split` number, head and rest), so that rounding is felt hardly more than once.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from .series import parts, series

if TYPE_CHECKING:
    from .simd import Arithmetic, Value, Writer

__all__ = ["FUNCTIONS"]

#: Adding this rounds to an integer, which then stands in the lowest bits (Moler's trick; vector
#: instructions for it are missing on half of the machines).
MAGIC = 1.5 * 2.0**52
INFINITY = float("inf")


class Split(NamedTuple):
    """A number as a sum of a rounded number and a small rest."""

    head: Value
    rest: Value


# --- bits -------------------------------------------------------------------------------------


def _bits(w: Writer, a: str) -> str:
    """Doubles as integers."""
    return w.emit(f"bitcast {w.type} {a} to {w.whole}")


def _doubles(w: Writer, bits: str) -> str:
    """Integers as doubles."""
    return w.emit(f"bitcast {w.whole} {bits} to {w.type}")


def _integers(w: Writer, name: str, a: str, b: int) -> str:
    """An instruction on integers, with a constant."""
    return w.emit(f"{name} {w.whole} {a}, splat (i64 {b})")


def _negative(w: Writer, a: str) -> str:
    """Where the sign bit is set."""
    return w.emit(f"icmp slt {w.whole} {_bits(w, a)}, zeroinitializer")


def _odd(w: Writer, bits: str) -> str:
    """Where an integer is odd."""
    return w.emit(f"trunc {w.whole} {bits} to {w.mask}")


def _nearest(w: Writer, a: str, factor: Fraction) -> tuple[str, str]:
    """The integer nearest to a multiple: as a double, and in the lowest bits."""
    magic = w.constant(MAGIC)
    moved = w.call("fma", a, w.constant(float(factor)), magic)
    return w.op("fsub", moved, magic), _bits(w, moved)


def _power_of_two(w: Writer, n: str) -> str:
    """2ⁿ for an integer (as a double) between −1022 and 1023."""
    bits = _bits(w, w.op("fadd", n, w.constant(MAGIC)))
    return _doubles(w, _integers(w, "shl", _integers(w, "add", bits, 1023), 52))


# --- sums, quotients and polynomials ----------------------------------------------------------


def _one(k: Arithmetic) -> Value:
    return k.number(Fraction(1))


def _sum(k: Arithmetic, a: Value, b: Value) -> Split:
    """a + b without error, where a is the larger (Dekker)."""
    head = k.add(a, b)
    return Split(head, k.sub(b, k.sub(head, a)))


def _any_sum(k: Arithmetic, a: Value, b: Value) -> Split:
    """The same whichever is the larger (Knuth)."""
    head = k.add(a, b)
    moved = k.sub(head, a)
    return Split(head, k.add(k.sub(a, k.sub(head, moved)), k.sub(b, moved)))


def _joined(k: Arithmetic, a: Split) -> Value:
    return k.add(a.head, a.rest)


def _selected(k: Arithmetic, mask: str, yes: Split, no: Split) -> Split:
    return Split(k.choose(mask, yes.head, no.head), k.choose(mask, yes.rest, no.rest))


def _quotient(k: Arithmetic, a: Split, b: Split) -> Split:
    """a/b."""
    inverse = k.recip(b.head)
    head = k.mul(a.head, inverse)
    minus = k.neg(head)
    left = k.fma(minus, b.rest, k.add(k.fma(minus, b.head, a.head), a.rest))
    return Split(head, k.mul(left, inverse))


def _polynomial(k: Arithmetic, name: str, t: Value) -> Value:
    """The smooth part of a function, by Horner's rule.

    High terms are too small for more than their first 53 bits to matter: they take one register
    in any arithmetic.
    """
    found = series(name, k.bits + 6)
    sizes = [abs(c) * Fraction(found.reach) ** i for i, c in enumerate(found.coefficients)]
    short = [size * 2 ** (k.bits - 50) < sizes[0] for size in sizes]
    w, lead = k.writer, k.leading(t)
    *others, top = zip(found.coefficients, short, strict=True)
    register, total = w.constant(float(top[0])), None
    for coefficient, small in reversed(others):
        if small:
            register = w.call("fma", register, lead, w.constant(float(coefficient)))
        else:
            total = k.whole(register) if total is None else total
            total = k.fma(total, t, k.number(coefficient))
    return total


def _difference(k: Arithmetic, a: Split, b: Split) -> Split:
    """a − b, where a is the larger or zero."""
    total = _sum(k, a.head, k.neg(b.head))
    return Split(total.head, k.add(total.rest, k.sub(a.rest, b.rest)))


def _constant(k: Arithmetic, name: str, factor: Fraction) -> Split:
    """A constant and what is lost by rounding it."""
    head, rest = parts(name, (53 * k.words,))
    return Split(k.number(head * factor), k.number(rest * factor))


def _where(k: Arithmetic, x: Value, relation: str, limit: float) -> str:
    """Where x has a relation to a number."""
    w = k.writer
    return w.compare(relation, k.leading(x), w.constant(limit))


def _put(k: Arithmetic, mask: str, value: float, result: Value) -> Value:
    """A result with a constant in some places."""
    return k.choose(mask, k.whole(k.writer.constant(value)), result)


def _like(k: Arithmetic, x: Value, magnitude: Value) -> Value:
    """With the sign of x."""
    return k.choose(_negative(k.writer, k.leading(x)), k.neg(magnitude), magnitude)


# --- signs ------------------------------------------------------------------------------------


def absolute(k: Arithmetic, x: Value) -> Value:
    """Magnitude."""
    return _like(k, x, x)


def sign(k: Arithmetic, x: Value) -> Value:
    """1, −1; zero for zero, not a number for what is none."""
    found = _put(k, _where(k, x, "olt", 0.0), -1.0, x)
    return _put(k, _where(k, x, "ogt", 0.0), 1.0, found)


def _reduced(k: Arithmetic, x: Value, name: str, factor: Fraction) -> tuple[Split, str, str]:
    """x less the nearest multiple n of a constant; n as a double, and in the lowest bits.

    Multiples of short pieces of the constant are taken off one after another, all but the last
    two without error (Cody and Waite 1980; with fused products Boldo, Daumas and Li 2009).
    """
    w = k.writer
    *pieces, _ = (piece * factor for piece in parts(name, (53,) * (k.words + 2)))
    turns, bits = _nearest(w, k.leading(x), 1 / sum(pieces, Fraction(0)))
    n = k.whole(turns)
    *exact, next_to_last, last = (k.number(-piece) for piece in pieces)
    for piece in exact:
        x = k.fma(n, piece, x)
    product = k.mul(n, next_to_last)
    lost = k.fma(n, next_to_last, k.neg(product))
    head, rest = _any_sum(k, x, product)
    return Split(head, k.add(rest, k.fma(n, last, lost))), turns, bits


# --- circular functions -----------------------------------------------------------------------

#: Beyond this the nearest multiple of π/2 is not told apart any more.
FARTHEST = 2.0**40


def _circular(k: Arithmetic, x: Value) -> tuple[Split, Split, str]:
    """Sine and cosine of x − n π/2, at most π/4 in magnitude, and n in the lowest bits."""
    (r, rest), _, quadrant = _reduced(k, x, "pi", Fraction(1, 2))
    t = k.mul(r, r)
    sine = Split(r, k.fma(k.mul(r, t), _polynomial(k, "sin", t), rest))
    top = _sum(k, _one(k), k.mul(t, k.number(Fraction(-1, 2))))
    small = k.fma(k.mul(t, t), _polynomial(k, "cos", t), k.neg(k.mul(r, rest)))
    return sine, Split(top.head, k.add(top.rest, small)), quadrant


def _turned(k: Arithmetic, x: Value, quarters: int) -> Value:
    """sin(x + quarters π/2)."""
    w = k.writer
    sine, cosine, quadrant = _circular(k, x)
    quadrant = _integers(w, "add", quadrant, quarters)
    found = _joined(k, _selected(k, _odd(w, quadrant), cosine, sine))
    other = _odd(w, _integers(w, "lshr", quadrant, 1))
    return _within(k, x, k.choose(other, k.neg(found), found))


def _within(k: Arithmetic, x: Value, value: Value) -> Value:
    """Not a number where the angle is too large."""
    return _put(k, _where(k, absolute(k, x), "ogt", FARTHEST), float("nan"), value)


def _through_zero(k: Arithmetic, x: Value, value: Value) -> Value:
    """x itself where that is zero, for the sign."""
    return k.choose(_where(k, x, "oeq", 0.0), x, value)


def sin(k: Arithmetic, x: Value) -> Value:
    """Sine."""
    return _through_zero(k, x, _turned(k, x, 0))


def cos(k: Arithmetic, x: Value) -> Value:
    """Cosine."""
    return _turned(k, x, 1)


def tan(k: Arithmetic, x: Value) -> Value:
    """Tangent."""
    sine, cosine, quadrant = _circular(k, x)
    odd = _odd(k.writer, quadrant)
    above, below = _selected(k, odd, cosine, sine), _selected(k, odd, sine, cosine)
    below = _sum(k, *below)
    found = _joined(k, _quotient(k, _sum(k, *above), below))
    return _through_zero(k, x, _within(k, x, k.choose(odd, k.neg(found), found)))


# --- their inverses ---------------------------------------------------------------------------


def _arcsine(k: Arithmetic, x: Value) -> tuple[Split, str]:
    """The arcsine of what is at most ½: of |x|, or of √((1 − |x|)/2) where the mask is set."""
    size = absolute(k, x)
    large = _where(k, size, "ogt", 0.5)
    t = k.mul(k.sub(_one(k), size), k.number(Fraction(1, 2)))
    root = k.sqrt(t)
    lost = k.mul(k.fma(k.neg(root), root, t), k.recip(k.add(root, root)))
    zero = k.number(Fraction(0))
    safe = k.choose(_where(k, root, "oeq", 0.0), zero, lost)
    s = _selected(k, large, Split(root, safe), Split(size, zero))
    square = k.choose(large, t, k.mul(size, size))
    cubic = k.mul(k.mul(s.head, square), _polynomial(k, "asin", square))
    return Split(s.head, k.add(s.rest, cubic)), large


def asin(k: Arithmetic, x: Value) -> Value:
    """Arcsine."""
    s, large = _arcsine(k, x)
    twice = Split(*(k.add(part, part) for part in s))
    far = _difference(k, _constant(k, "pi", Fraction(1, 2)), twice)
    return _like(k, x, _joined(k, _selected(k, large, far, s)))


def acos(k: Arithmetic, x: Value) -> Value:
    """Arccosine: π/2 ∓ s for small arguments, 2 s or π − 2 s for those near 1 or −1."""
    w = k.writer
    s, large = _arcsine(k, x)
    negative = _negative(w, k.leading(x))
    minus = w.emit(f"xor {w.mask} {large}, {negative}")
    s = Split(*(k.choose(large, k.add(part, part), part) for part in s))
    s = Split(*(k.choose(minus, k.neg(part), part) for part in s))
    zero = k.number(Fraction(0))
    end = _selected(k, negative, _constant(k, "pi", Fraction(1)), Split(zero, zero))
    middle = _constant(k, "pi", Fraction(1, 2))
    return _joined(k, _difference(k, _selected(k, large, end, middle), s))


def atan2(k: Arithmetic, y: Value, x: Value) -> Value:
    """The angle of a point (x, y): a multiple of π/4, and the arctangent of at most ½."""
    w, one, zero = k.writer, _one(k), k.number(Fraction(0))
    steep = w.compare("ogt", k.leading(absolute(k, y)), k.leading(absolute(k, x)))
    above, below = _proper(k, absolute(k, y), absolute(k, x), steep)
    half = k.leading(k.mul(below, k.number(Fraction(1, 2))))
    middle = w.compare("ogt", k.leading(above), half)
    top = k.choose(middle, k.sub(above, below), above)
    bottom = _sum(k, below, k.choose(middle, above, zero))
    slope = _quotient(k, Split(top, zero), bottom)
    t = k.mul(slope.head, slope.head)
    cubic = k.mul(k.mul(slope.head, t), _polynomial(k, "atan", t))
    angle = Split(slope.head, k.add(slope.rest, cubic))

    behind = _negative(w, k.leading(x))
    backward = w.emit(f"xor {w.mask} {steep}, {behind}")
    eighths = k.choose(middle, one, zero)
    start = k.choose(steep, k.number(Fraction(2)), k.choose(behind, k.number(Fraction(4)), zero))
    eighths = k.add(start, k.choose(backward, k.neg(eighths), eighths))
    eighth = _constant(k, "pi", Fraction(1, 4))
    head = k.mul(eighths, eighth.head)
    lost = k.fma(eighths, eighth.head, k.neg(head))
    turned = Split(head, k.fma(eighths, eighth.rest, lost))
    minus = Split(*(k.choose(backward, part, k.neg(part)) for part in angle))
    return _like(k, y, _joined(k, _difference(k, turned, minus)))


def _proper(k: Arithmetic, a: Value, b: Value, swapped: str) -> tuple[Value, Value]:
    """Two magnitudes with the same ratio, the smaller first, neither huge nor tiny nor 0/0."""
    one = _one(k)
    above, below = k.choose(swapped, b, a), k.choose(swapped, a, b)
    factor = _put(k, _where(k, below, "olt", 2.0**-500), 2.0**600, one)
    factor = _put(k, _where(k, below, "ogt", 2.0**500), 2.0**-600, factor)
    endless = _where(k, below, "oeq", INFINITY)
    corner = _put(k, _where(k, above, "oeq", INFINITY), 1.0, k.mul(above, k.number(Fraction(0))))
    above = k.choose(endless, corner, k.mul(above, factor))
    below = k.choose(endless, one, k.mul(below, factor))
    return above, k.choose(_where(k, below, "oeq", 0.0), one, below)


def atan(k: Arithmetic, x: Value) -> Value:
    """Arctangent."""
    return atan2(k, x, _one(k))


# --- exponentials -----------------------------------------------------------------------------

#: Where the results of exp and of sinh and cosh end, and where exp is nothing any more.
HIGHEST, HIGHEST_HYPERBOLIC, LOWEST = 709.782712893384, 710.4758600739439, -746.0
#: From here on the hyperbolic tangent is 1 to 106 bits.
SATURATED = 40.0


def _exponential(k: Arithmetic, x: Value, halvings: int) -> Split:
    """eˣ by a power of two: 2ⁿ (1 + r + …), |r| ≤ (log 2)/2."""
    w = k.writer
    (r, rest), turns, _ = _reduced(k, x, "ln2", Fraction(1))
    top = _sum(k, _one(k), r)
    small = k.fma(k.mul(r, r), _polynomial(k, "exp", r), rest)
    turns = w.op("fsub", turns, w.constant(float(halvings)))
    # in two steps, for the last numbers before infinity and zero
    first, _ = _nearest(w, turns, Fraction(1, 2))
    powers = (first, w.op("fsub", turns, first))
    near, far = (k.whole(_power_of_two(w, power)) for power in powers)
    made = _sum(k, top.head, k.add(top.rest, small))
    return Split(*(k.mul(k.mul(part, near), far) for part in made))


def exp(k: Arithmetic, x: Value) -> Value:
    """Exponential function."""
    found = _joined(k, _exponential(k, x, 0))
    found = _put(k, _where(k, x, "ogt", HIGHEST), INFINITY, found)
    return _put(k, _where(k, x, "olt", LOWEST), 0.0, found)


def _hyperbolic(k: Arithmetic, x: Value) -> tuple[Split, Split]:
    """Hyperbolic sine and cosine of a magnitude."""
    large = _exponential(k, x, 1)
    inverse = k.recip(large.head)
    left = k.fma(k.neg(inverse), large.rest, k.fma(k.neg(inverse), large.head, _one(k)))
    quarter = k.number(Fraction(1, 4))
    small = Split(k.mul(inverse, quarter), k.mul(k.mul(inverse, left), quarter))
    t = k.mul(x, x)
    near = Split(x, k.mul(k.mul(x, t), _polynomial(k, "sinh", t)))
    cosine = _difference(k, large, Split(*map(k.neg, small)))
    sine = _selected(k, _where(k, x, "olt", 0.5), near, _difference(k, large, small))
    return sine, cosine


def sinh(k: Arithmetic, x: Value) -> Value:
    """Hyperbolic sine."""
    size = absolute(k, x)
    sine, _ = _hyperbolic(k, size)
    far = _where(k, size, "ogt", HIGHEST_HYPERBOLIC)
    return _like(k, x, _put(k, far, INFINITY, _joined(k, sine)))


def cosh(k: Arithmetic, x: Value) -> Value:
    """Hyperbolic cosine."""
    size = absolute(k, x)
    _, cosine = _hyperbolic(k, size)
    return _put(k, _where(k, size, "ogt", HIGHEST_HYPERBOLIC), INFINITY, _joined(k, cosine))


def tanh(k: Arithmetic, x: Value) -> Value:
    """Hyperbolic tangent."""
    size = absolute(k, x)
    sine, cosine = _hyperbolic(k, size)
    found = _joined(k, _quotient(k, _sum(k, *sine), cosine))
    return _like(k, x, _put(k, _where(k, size, "ogt", SATURATED), 1.0, found))


def log(k: Arithmetic, x: Value) -> Value:
    """Logarithm: of 2ⁿ m it is n log 2 + 2 artanh((m − 1)/(m + 1)), √½ ≤ m < √2."""
    w, one = k.writer, _one(k)
    tiny, huge = _where(k, x, "olt", 2.0**-500), _where(k, x, "ogt", 2.0**500)
    m = k.mul(x, _put(k, huge, 2.0**-600, _put(k, tiny, 2.0**600, one)))
    n = w.choose(huge, w.constant(600.0), w.choose(tiny, w.constant(-600.0), w.constant(0.0)))
    # the exponent's field, counted from √½ instead of 1
    field = _integers(w, "add", _bits(w, k.leading(m)), 0x3FF0000000000000 - 0x3FE6A09E667F3BCD)
    field = _integers(w, "lshr", field, 52)
    as_double = _doubles(w, _integers(w, "or", field, 0x4330000000000000))
    n = w.op("fadd", n, w.op("fsub", as_double, w.constant(2.0**52 + 1023.0)))
    inverse = w.emit(f"sub {w.whole} splat (i64 2046), {field}")
    m = k.mul(m, k.whole(_doubles(w, _integers(w, "shl", inverse, 52))))

    above = k.sub(m, one)
    below = _sum(k, k.number(Fraction(2)), above)
    s = _quotient(k, Split(above, k.number(Fraction(0))), below)
    twice = Split(*(k.add(part, part) for part in s))
    t = k.mul(s.head, s.head)
    cubic = k.mul(k.mul(twice.head, t), _polynomial(k, "atanh", t))
    # short, so that its multiples are exact
    high, low = parts("ln2", (k.bits - 11,))
    total = _sum(k, k.mul(k.whole(n), k.number(high)), twice.head)
    rest = k.add(twice.rest, k.fma(k.whole(n), k.number(low), cubic))
    found = k.add(total.head, k.add(total.rest, rest))
    found = _put(k, _where(k, x, "olt", 0.0), float("nan"), found)
    found = _put(k, _where(k, x, "oeq", INFINITY), INFINITY, found)
    return _put(k, _where(k, x, "oeq", 0.0), -INFINITY, found)


FUNCTIONS: Mapping[str, Callable[..., Value]] = {
    "abs": absolute,
    "sign": sign,
    "sin": sin,
    "cos": cos,
    "tan": tan,
    "asin": asin,
    "acos": acos,
    "atan": atan,
    "atan2": atan2,
    "sinh": sinh,
    "cosh": cosh,
    "tanh": tanh,
    "exp": exp,
    "log": log,
}
