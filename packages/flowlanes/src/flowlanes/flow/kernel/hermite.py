"""Cubic Hermite interpolation of a function within a step."""

from __future__ import annotations

from ..machine_code.ir_writer import IRWriter

#: Smallest distance, relative to the step, of an extremum from the ends to be considered.
NEAR = 1e-6


def cubic(
    w: IRWriter, step: str, g: str, g_new: str, gdot: str, gdot_new: str
) -> tuple[str, str, str, str]:
    """a, b, c, d of the cubic g + a x + c x² + d x³ through both ends; b is the slope at 1."""
    a, b = w.op("fmul", step, gdot), w.op("fmul", step, gdot_new)
    rise = w.op("fsub", g_new, g)
    d = w.op("fsub", w.op("fadd", a, b), w.op("fmul", w.constant(2.0), rise))
    return a, b, w.op("fsub", w.op("fsub", rise, a), d), d


def crossing_step(w: IRWriter, step: str, g: str, g_new: str, gdot: str, gdot_new: str) -> str:
    """The zero of the cubic interpolant within a step whose ends have opposite signs.

    Five Newton steps from the secant point, each replaced by a bisection if it leaves the interval
    that brackets the zero.
    """
    a, _, c, d = cubic(w, step, g, g_new, gdot, gdot_new)
    low, high = w.constant(0.0), w.constant(1.0)
    # The first iterate is the zero of the secant.
    x = w.op("fdiv", g, w.op("fsub", g, g_new))
    upward = w.compare("olt", g, w.constant(0.0))
    for _ in range(5):
        value = w.call("fma", w.call("fma", w.call("fma", d, x, c), x, a), x, g)
        slope = w.call("fma", w.constant(3.0), w.op("fmul", d, x), w.op("fadd", c, c))
        slope = w.call("fma", slope, x, a)
        above = w.emit(
            f"xor {w.mask} {w.compare('ogt', value, w.constant(0.0))}, {w.complement(upward)}"
        )
        high, low = w.choose(above, x, high), w.choose(above, low, x)
        trial = w.op("fsub", x, w.op("fdiv", value, slope))
        inside = w.conjunction(w.compare("ogt", trial, low), w.compare("olt", trial, high))
        middle = w.op("fmul", w.constant(0.5), w.op("fadd", low, high))
        x = w.choose(inside, trial, middle)
    return w.op("fmul", x, step)


def double_crossing(
    w: IRWriter, step: str, g: str, g_new: str, gdot: str, gdot_new: str, slack: str
) -> tuple[str, str]:
    """The mask of cubics with two zeros within a step, given an error bound of the cubic.

    The ends have the same sign, and the extremum x in between has the opposite sign, or comes
    closer to zero than the error `slack`·x²(1 − x)² of the cubic.  The second result is the step to
    the extremum, which leaves one zero on each side.
    """
    zero = w.constant(0.0)
    a, b, c, d = cubic(w, step, g, g_new, gdot, gdot_new)
    turns = w.conjunction(
        w.compare("olt", w.op("fmul", g, a), zero), w.compare("ogt", w.op("fmul", g, b), zero)
    )
    place = w.variable(w.type, zero)
    with w.branch(w.any(turns)):
        # a + 2 c x + 3 d x² = 0, without cancellation.
        cubed = w.op("fmul", w.constant(3.0), d)
        root = w.call("fma", c, c, w.op("fneg", w.op("fmul", cubed, a)))
        root = w.call("sqrt", w.call("maxnum", root, zero))
        # Both roots follow from one sum without cancellation.
        whole = w.op("fneg", w.op("fadd", c, w.call("copysign", root, c)))
        first, second = w.op("fdiv", a, whole), w.op("fdiv", whole, cubed)
        inside = w.conjunction(
            w.compare("ogt", first, zero), w.compare("olt", first, w.constant(1.0))
        )
        x = w.choose(inside, first, second)
        value = w.call("fma", w.call("fma", w.call("fma", d, x, c), x, a), x, g)
        low, high = w.compare("ogt", x, w.constant(NEAR)), w.compare("olt", x, w.constant(1 - NEAR))
        within = w.conjunction(low, high)
        # Positive if the extremum is on the same side as g.
        depth = w.op("fmul", value, w.call("copysign", w.constant(1.0), g))
        # x − x² = x (1 − x)
        spread = w.call("fma", w.op("fneg", x), x, x)
        error = w.op("fmul", slack, w.op("fmul", spread, spread))
        other = w.compare("olt", depth, error)
        turn = w.choose(
            w.conjunction(turns, w.conjunction(other, within)), w.op("fmul", x, step), zero
        )
        w.store(w.type, turn, place)
    turn = w.load(w.type, place)
    return w.compare("one", turn, zero), turn


def side_after_crossing(w: IRWriter, rate: str) -> str:
    """A tiny value with the sign that the function takes after the crossing."""
    near = w.call("copysign", w.constant(1e-300), rate)
    return w.choose(w.compare("one", rate, w.constant(0.0)), near, w.constant(0.0))
