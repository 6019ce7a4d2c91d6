"""Machine code for steps of a motion along its Taylor series."""

from __future__ import annotations

import math
from fractions import Fraction

from ..machine_code.arithmetic import Double
from ..machine_code.elementary import FUNCTIONS
from ..machine_code.ir_writer import IRWriter

_ONE = "<1 x double>"
_ATTRIBUTES = "#1"


def emit_sums(size: int, stride: int, order: int) -> str:
    """Emit the evaluation of the series at a time, with the rounding error of the result."""
    w = IRWriter(1)
    number = Double(w)
    t = number.load("%time", 0)
    with w.count(size) as i:
        row = w.emit(f"mul i64 {i}, {stride}")
        total = number.load("%memory", w.emit(f"add i64 {row}, {order}"))
        for k in range(order - 1, 0, -1):
            total = number.fma(total, t, number.load("%memory", w.emit(f"add i64 {row}, {k}")))
        change = number.fma(total, t, number.load("%rest", i))
        first = number.load("%memory", row)
        value = number.add(first, change)
        part = number.sub(value, first)
        lost = number.add(number.sub(first, number.sub(value, part)), number.sub(change, part))
        number.store(value, "%result", i)
        number.store(lost, "%lost", i)
    head = "void @sums(ptr %memory, ptr %rest, ptr %time, ptr %result, ptr %lost)"
    return w.text(head, _ATTRIBUTES)


def emit_step(size: int, events: int, stride: int, order: int) -> str:
    """Emit a step whose length follows from the last two coefficients (Jorba, Zou 2005).

    With the coefficients x_k of the series (of the state and of the events), M_0 = max(1, |x_0|)
    and M_k = max|x_k|, the radius of convergence is estimated by (M_0/M_k)^{1/k} for k = p − 1 and
    k = p, the last two orders.  The step is the smaller of both times exp(−2 − 0.7/(p − 1)): at
    1/e² of the radius the remainder of order p = 1 − ½ ln(tolerance) has the size of the tolerance
    (A. Jorba, M. Zou, Experimental Mathematics 14 (2005) 99–117).  This is an estimate, not a
    bound.

    An event with series e_k cannot occur within the step h if |e_0| > Σ_{k≥1} |e_k| hᵏ.  All
    others, and those whose sign has changed by rounding since the last step, are counted in
    ``control``.  If the number is positive, no step is made, and the caller isolates the roots of
    the events.

    ``control`` contains the maximum length, then the chosen length (NaN if there is none), and the
    number of possible events; the step is made if this number is zero.  ``ends`` contains the
    event values at the end of the previous step.
    """
    w = IRWriter(1)
    number = Double(w)
    p = order
    with w.count(size) as i:
        number.store(number.load("%rest", i), "%before", i)
    w.line("call void @series(ptr %memory, ptr %state)")
    one, zero = number.number(Fraction(1)), number.number(Fraction(0))
    largest = [w.variable(_ONE, x) for x in (one, zero, zero)]
    doubt = w.variable(_ONE, zero)
    with w.count(size + events) as i:
        row = w.emit(f"mul i64 {i}, {stride}")
        for place, k in zip(largest, (0, p - 1, p), strict=True):
            value = _size_at(number, row, k)
            largest_yet = w.load(_ONE, place)
            greater = w.compare("ogt", value, largest_yet)
            w.store(_ONE, number.choose(greater, value, largest_yet), place)
            # Zero unless the value is not finite.
            value = number.sub(value, value)
            w.store(_ONE, number.add(w.load(_ONE, doubt), value), doubt)
    largest_now, last_but_one, last = (w.load(_ONE, place) for place in largest)
    length = number.number(Fraction(2) ** 1000)
    for value, k in ((last_but_one, p - 1), (last, p)):
        root = FUNCTIONS["log"](number, w.op("fdiv", largest_now, value))
        root = FUNCTIONS["exp"](number, number.mul(root, number.number(Fraction(1, k))))
        root = number.mul(root, w.constant(math.exp(-2 - 0.7 / (p - 1))))
        shorter = w.conjunction(w.compare("olt", root, length), w.compare("ogt", value, zero))
        length = number.choose(shorter, root, length)
    finite = w.compare("oeq", w.load(_ONE, doubt), zero)
    limit = number.load("%control", 0)
    within = w.call("fabs", limit)
    length = number.choose(w.compare("olt", length, within), length, within)
    length = number.choose(finite, length, w.constant(math.nan))
    suspects = w.variable(_ONE, zero)
    with w.count(events) as i:
        row = w.emit(f"mul i64 {i}, {stride}")
        row = w.emit(f"add i64 {row}, {size * stride}")
        bound = _size_at(number, row, p)
        for k in range(p - 1, 0, -1):
            bound = number.fma(bound, length, _size_at(number, row, k))
        bound = number.mul(bound, length)
        value = number.load("%memory", row)
        hidden = w.conjunction(
            w.compare("ogt", number.load("%ends", i), zero), w.compare("ole", value, zero)
        )
        near = w.compare("ole", w.call("fabs", value), bound)
        suspect = number.choose(w.disjunction(hidden, near), one, zero)
        w.store(_ONE, number.add(w.load(_ONE, suspects), suspect), suspects)
    length = w.call("copysign", length, limit)
    number.store(length, "%control", 1)
    number.store(w.load(_ONE, suspects), "%control", 2)
    done = w.conjunction(finite, w.compare("oeq", w.load(_ONE, suspects), zero))
    with w.branch(w.emit(f"extractelement {w.mask} {done}, i64 0")):
        place = w.address("double", "%control", 1)
        w.line(f"call void @sums(ptr %memory, ptr %before, ptr {place}, ptr %result, ptr %rest)")
        with w.count(size) as i:
            value = number.load("%result", i)
            value = number.sub(value, value)
            w.store(_ONE, number.add(w.load(_ONE, doubt), value), doubt)
        number.store(number.add(length, w.load(_ONE, doubt)), "%control", 1)
        finite = w.compare("oeq", w.load(_ONE, doubt), zero)
        with (
            w.branch(w.emit(f"extractelement {w.mask} {finite}, i64 0")),
            w.count(size) as i,
        ):
            number.store(number.load("%result", i), "%state", i)
        with w.count(events) as i:
            row = w.emit(f"mul i64 {i}, {stride}")
            row = w.emit(f"add i64 {row}, {size * stride}")
            number.store(number.load("%memory", row), "%ends", i)
    arguments = ["memory", "state", "before", "rest", "ends", "result", "control"]
    head = f"void @step({', '.join(f'ptr %{name}' for name in arguments)})"
    return w.text(head, _ATTRIBUTES)


def _size_at(number: Double, row: str, k: int) -> str:
    """Magnitude of a coefficient."""
    w = number.writer
    return w.call("fabs", number.load("%memory", w.emit(f"add i64 {row}, {k}")))
