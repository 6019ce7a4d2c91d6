"""Elementary functions in vector instructions, without branches, tables or calls.

Every function is written once for any arithmetic, so doubles and double-doubles share it.  The
argument is reduced to a short interval, on which the function is an exact leading part plus a
polynomial times a small factor.  Both parts are kept separate as long as possible (a `HeadTail`
number), so there is little more than one rounding: errors are below 0.9 units in the last place
for doubles, and about 10⁻³¹ for double-doubles.  Circular functions of arguments above 2⁴⁰ are
NaN.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any

from .approximation import parts
from .arithmetic import Arithmetic, V
from .compensated import (
    HeadTail,
    as_doubles,
    as_integers,
    constant,
    copy_sign,
    difference,
    fast_sum,
    integers,
    is_negative,
    is_odd,
    nearest,
    polynomial,
    power_of_two,
    quotient,
    reduce_argument,
    select,
    total_of,
    unit,
    where,
    where_constant,
)

INFINITY = float("inf")

# --- signs ------------------------------------------------------------------------------------


def absolute(k: Arithmetic[V], x: V) -> V:
    """Magnitude."""
    return copy_sign(k, x, x)


def sign(k: Arithmetic[V], x: V) -> V:
    """1, −1; zero for zero, NaN for NaN."""
    negative = where_constant(k, where(k, x, "olt", 0.0), -1.0, x)
    return where_constant(k, where(k, x, "ogt", 0.0), 1.0, negative)


# --- circular functions -----------------------------------------------------------------------

#: Argument beyond which the nearest multiple of π/2 cannot be determined.
FARTHEST = 2.0**40


def _circular(k: Arithmetic[V], x: V) -> tuple[HeadTail[V], HeadTail[V], str]:
    """Sine and cosine of x − n π/2, |x − n π/2| ≤ π/4, and n in the lowest bits."""
    (r, tail), _, quadrant = reduce_argument(k, x, "pi", Fraction(1, 2))
    t = k.mul(r, r)
    # sin r = r + r³ g(r²); the tail of r is added to the small part.
    sine = HeadTail(r, k.fma(k.mul(r, t), polynomial(k, "sin", t), tail))
    # cos r = 1 − r²/2 + r⁴ g(r²), minus r · tail for the tail of the argument.
    top = fast_sum(k, unit(k), k.mul(t, k.number(Fraction(-1, 2))))
    small = k.fma(k.mul(t, t), polynomial(k, "cos", t), k.neg(k.mul(r, tail)))
    return sine, HeadTail(top.head, k.add(top.tail, small)), quadrant


def _shifted_sine(k: Arithmetic[V], x: V, quarters: int) -> V:
    """sin(x + quarters π/2)."""
    w = k.writer
    sine, cosine, quadrant = _circular(k, x)
    # A shift by quarter turns is an integer addition; odd quadrants exchange sine and cosine, and
    # bit 1 changes the sign.
    quadrant = integers(w, "add", quadrant, quarters)
    value = total_of(k, select(k, is_odd(w, quadrant), cosine, sine))
    other = is_odd(w, integers(w, "lshr", quadrant, 1))
    return _within(k, x, k.choose(other, k.neg(value), value))


def _within(k: Arithmetic[V], x: V, value: V) -> V:
    """NaN where the angle is too large, else the value."""
    return where_constant(k, where(k, absolute(k, x), "ogt", FARTHEST), float("nan"), value)


def _through_zero(k: Arithmetic[V], x: V, value: V) -> V:
    """x where it is zero, to keep its sign, else the value."""
    return k.choose(where(k, x, "oeq", 0.0), x, value)


def sin(k: Arithmetic[V], x: V) -> V:
    """Sine."""
    return _through_zero(k, x, _shifted_sine(k, x, 0))


def cos(k: Arithmetic[V], x: V) -> V:
    """Cosine."""
    return _shifted_sine(k, x, 1)


def tan(k: Arithmetic[V], x: V) -> V:
    """Tangent."""
    sine, cosine, quadrant = _circular(k, x)
    odd = is_odd(k.writer, quadrant)
    above, below = select(k, odd, cosine, sine), select(k, odd, sine, cosine)
    below = fast_sum(k, *below)
    ratio = total_of(k, quotient(k, fast_sum(k, *above), below))
    return _through_zero(k, x, _within(k, x, k.choose(odd, k.neg(ratio), ratio)))


# --- their inverses ---------------------------------------------------------------------------


def _arcsine(k: Arithmetic[V], x: V) -> tuple[HeadTail[V], str]:
    """The arcsine of |x| ≤ ½, or of √((1 − |x|)/2) where the mask is set; the mask."""
    size = absolute(k, x)
    large = where(k, size, "ogt", 0.5)
    # For large x: asin x = π/2 − 2 asin √((1 − x)/2).
    t = k.mul(k.sub(unit(k), size), k.number(Fraction(1, 2)))
    root = k.sqrt(t)
    # One Newton step gives the rounding error of the root.
    lost = k.mul(k.fma(k.neg(root), root, t), k.recip(k.add(root, root)))
    zero = k.number(Fraction(0))
    safe = k.choose(where(k, root, "oeq", 0.0), zero, lost)
    s = select(k, large, HeadTail(root, safe), HeadTail(size, zero))
    square = k.choose(large, t, k.mul(size, size))
    cubic = k.mul(k.mul(s.head, square), polynomial(k, "asin", square))
    return HeadTail(s.head, k.add(s.tail, cubic)), large


def asin(k: Arithmetic[V], x: V) -> V:
    """Arcsine."""
    s, large = _arcsine(k, x)
    twice = HeadTail(*(k.add(part, part) for part in s))
    far = difference(k, constant(k, "pi", Fraction(1, 2)), twice)
    return copy_sign(k, x, total_of(k, select(k, large, far, s)))


def acos(k: Arithmetic[V], x: V) -> V:
    """Arccosine: π/2 ∓ s for small arguments, 2 s or π − 2 s for those near 1 or −1."""
    w = k.writer
    s, large = _arcsine(k, x)
    negative = is_negative(w, k.leading(x))
    minus = w.emit(f"xor {w.mask} {large}, {negative}")
    s = HeadTail(*(k.choose(large, k.add(part, part), part) for part in s))
    s = HeadTail(*(k.choose(minus, k.neg(part), part) for part in s))
    zero = k.number(Fraction(0))
    end = select(k, negative, constant(k, "pi", Fraction(1)), HeadTail(zero, zero))
    middle = constant(k, "pi", Fraction(1, 2))
    return total_of(k, difference(k, select(k, large, end, middle), s))


def atan2(k: Arithmetic[V], y: V, x: V) -> V:
    """The angle of a point (x, y): a multiple of π/4 plus the arctangent of at most ½."""
    w, one, zero = k.writer, unit(k), k.number(Fraction(0))
    steep = w.compare("ogt", k.leading(absolute(k, y)), k.leading(absolute(k, x)))
    above, below = _proper(k, absolute(k, y), absolute(k, x), steep)
    half = k.leading(k.mul(below, k.number(Fraction(1, 2))))
    middle = w.compare("ogt", k.leading(above), half)
    # atan(a/b) = π/4 + atan((a − b)/(a + b)) reduces the slope to at most 1/2.
    top = k.choose(middle, k.sub(above, below), above)
    bottom = fast_sum(k, below, k.choose(middle, above, zero))
    slope = quotient(k, HeadTail(top, zero), bottom)
    t = k.mul(slope.head, slope.head)
    cubic = k.mul(k.mul(slope.head, t), polynomial(k, "atan", t))
    angle = HeadTail(slope.head, k.add(slope.tail, cubic))

    behind = is_negative(w, k.leading(x))
    backward = w.emit(f"xor {w.mask} {steep}, {behind}")
    eighths = k.choose(middle, one, zero)
    start = k.choose(steep, k.number(Fraction(2)), k.choose(behind, k.number(Fraction(4)), zero))
    eighths = k.add(start, k.choose(backward, k.neg(eighths), eighths))
    eighth = constant(k, "pi", Fraction(1, 4))
    head = k.mul(eighths, eighth.head)
    lost = k.fma(eighths, eighth.head, k.neg(head))
    turned = HeadTail(head, k.fma(eighths, eighth.tail, lost))
    minus = HeadTail(*(k.choose(backward, part, k.neg(part)) for part in angle))
    return copy_sign(k, y, total_of(k, difference(k, turned, minus)))


def _proper(k: Arithmetic[V], a: V, b: V, swap: str) -> tuple[V, V]:
    """Two magnitudes with the same ratio, the smaller first, scaled to order one."""
    one = unit(k)
    above, below = k.choose(swap, b, a), k.choose(swap, a, b)
    # Scaling by powers of two is exact and avoids overflow and underflow of the quotient.
    factor = where_constant(k, where(k, below, "olt", 2.0**-500), 2.0**600, one)
    factor = where_constant(k, where(k, below, "ogt", 2.0**500), 2.0**-600, factor)
    # Both infinite gives the angle π/4, one infinite 0 or π/2, as in IEEE 754.
    endless = where(k, below, "oeq", INFINITY)
    corner = where_constant(
        k, where(k, above, "oeq", INFINITY), 1.0, k.mul(above, k.number(Fraction(0)))
    )
    above = k.choose(endless, corner, k.mul(above, factor))
    below = k.choose(endless, one, k.mul(below, factor))
    return above, k.choose(where(k, below, "oeq", 0.0), one, below)


def atan(k: Arithmetic[V], x: V) -> V:
    """Arctangent."""
    return atan2(k, x, unit(k))


# --- exponentials -----------------------------------------------------------------------------

#: Arguments at which exp, sinh and cosh overflow, and at which exp underflows.
HIGHEST, HIGHEST_HYPERBOLIC, LOWEST = 709.782712893384, 710.4758600739439, -746.0
#: Above this the hyperbolic tangent is 1 to 106 bits.
SATURATION = 40.0


def _exponential(k: Arithmetic[V], x: V, halvings: int) -> HeadTail[V]:
    """eˣ as a power of two times a correction: 2ⁿ (1 + r + …), |r| ≤ (log 2)/2."""
    w = k.writer
    (r, tail), turns, _ = reduce_argument(k, x, "ln2", Fraction(1))
    top = fast_sum(k, unit(k), r)
    small = k.fma(k.mul(r, r), polynomial(k, "exp", r), tail)
    turns = w.op("fsub", turns, w.constant(float(halvings)))
    # Two factors, because 2ⁿ alone overflows or underflows before the result does.
    first, _ = nearest(w, turns, Fraction(1, 2))
    powers = (first, w.op("fsub", turns, first))
    near, far = (k.whole(power_of_two(w, power)) for power in powers)
    mantissa = fast_sum(k, top.head, k.add(top.tail, small))
    return HeadTail(*(k.mul(k.mul(part, near), far) for part in mantissa))


def exp(k: Arithmetic[V], x: V) -> V:
    """Exponential function."""
    value = total_of(k, _exponential(k, x, 0))
    value = where_constant(k, where(k, x, "ogt", HIGHEST), INFINITY, value)
    return where_constant(k, where(k, x, "olt", LOWEST), 0.0, value)


def _hyperbolic(k: Arithmetic[V], x: V) -> tuple[HeadTail[V], HeadTail[V]]:
    """Hyperbolic sine and cosine of a magnitude."""
    # The factor 1/2 is included in the exponential, so the result may be finite where eˣ
    # overflows.
    large = _exponential(k, x, 1)
    inverse = k.recip(large.head)
    # One Newton step for the reciprocal, with the tail of eˣ.
    left = k.fma(k.neg(inverse), large.tail, k.fma(k.neg(inverse), large.head, unit(k)))
    quarter = k.number(Fraction(1, 4))
    small = HeadTail(k.mul(inverse, quarter), k.mul(k.mul(inverse, left), quarter))
    t = k.mul(x, x)
    # For small x the difference of exponentials would cancel.
    near = HeadTail(x, k.mul(k.mul(x, t), polynomial(k, "sinh", t)))
    cosine = difference(k, large, HeadTail(*map(k.neg, small)))
    sine = select(k, where(k, x, "olt", 0.5), near, difference(k, large, small))
    return sine, cosine


def sinh(k: Arithmetic[V], x: V) -> V:
    """Hyperbolic sine."""
    size = absolute(k, x)
    sine, _ = _hyperbolic(k, size)
    far = where(k, size, "ogt", HIGHEST_HYPERBOLIC)
    return copy_sign(k, x, where_constant(k, far, INFINITY, total_of(k, sine)))


def cosh(k: Arithmetic[V], x: V) -> V:
    """Hyperbolic cosine."""
    size = absolute(k, x)
    _, cosine = _hyperbolic(k, size)
    return where_constant(
        k, where(k, size, "ogt", HIGHEST_HYPERBOLIC), INFINITY, total_of(k, cosine)
    )


def tanh(k: Arithmetic[V], x: V) -> V:
    """Hyperbolic tangent."""
    size = absolute(k, x)
    sine, cosine = _hyperbolic(k, size)
    ratio = total_of(k, quotient(k, fast_sum(k, *sine), cosine))
    return copy_sign(k, x, where_constant(k, where(k, size, "ogt", SATURATION), 1.0, ratio))


def log(k: Arithmetic[V], x: V) -> V:
    """Logarithm: of 2ⁿ m it is n log 2 + 2 artanh((m − 1)/(m + 1)), √½ ≤ m < √2."""
    w, one = k.writer, unit(k)
    # Subnormal numbers are scaled first, because their exponent field is zero.
    tiny, huge = where(k, x, "olt", 2.0**-500), where(k, x, "ogt", 2.0**500)
    m = k.mul(x, where_constant(k, huge, 2.0**-600, where_constant(k, tiny, 2.0**600, one)))
    n = w.choose(huge, w.constant(600.0), w.choose(tiny, w.constant(-600.0), w.constant(0.0)))
    # Exponent bits relative to √½ instead of 1.
    field = integers(
        w, "add", as_integers(w, k.leading(m)), 0x3FF0000000000000 - 0x3FE6A09E667F3BCD
    )
    field = integers(w, "lshr", field, 52)
    as_double = as_doubles(w, integers(w, "or", field, 0x4330000000000000))
    n = w.op("fadd", n, w.op("fsub", as_double, w.constant(2.0**52 + 1023.0)))
    inverse = w.emit(f"sub {w.whole} splat (i64 2046), {field}")
    m = k.mul(m, k.whole(as_doubles(w, integers(w, "shl", inverse, 52))))

    above = k.sub(m, one)
    below = fast_sum(k, k.number(Fraction(2)), above)
    s = quotient(k, HeadTail(above, k.number(Fraction(0))), below)
    twice = HeadTail(*(k.add(part, part) for part in s))
    t = k.mul(s.head, s.head)
    cubic = k.mul(k.mul(twice.head, t), polynomial(k, "atanh", t))
    # A short constant, so that its multiples are exact.
    high, low = parts("ln2", (k.bits - 11,))
    total = fast_sum(k, k.mul(k.whole(n), k.number(high)), twice.head)
    tail = k.add(twice.tail, k.fma(k.whole(n), k.number(low), cubic))
    value = k.add(total.head, k.add(total.tail, tail))
    value = where_constant(k, where(k, x, "olt", 0.0), float("nan"), value)
    value = where_constant(k, where(k, x, "oeq", INFINITY), INFINITY, value)
    return where_constant(k, where(k, x, "oeq", 0.0), -INFINITY, value)


FUNCTIONS: Mapping[str, Callable[..., Any]] = {
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
