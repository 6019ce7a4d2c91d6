"""The turning points of a motion x′² = N(x)/B(x): root isolation in ball arithmetic.

From its start a motion runs to the nearest root of N on either side.  Every interval on the way is
proven to contain no root, or exactly one, from the signs of N, N′ and N″ over the whole interval.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import arb, ctx

from flowlanes.errors import InputError
from flowlanes.formulas.relative_zero import vanishes

from .divided_differences import Argument, Formula, jet, slope

#: Width below which intervals are not halved.
NARROWEST = 1e-13

#: Maximum number of bisections before Newton's method must succeed.
HALVINGS = 400

#: N, N′ and N″/2 over an interval.
Jet = Callable[[arb], tuple[arb, arb, arb]]


@dataclass(frozen=True)
class End:
    """A root at which a motion turns, or which it approaches asymptotically.

    Attributes
    ----------
    x : flint.arb
    double : bool
        Whether it is a double root, within the resolution; it is then never reached.
    edge : bool
        Whether it is the edge of the domain itself, a root by construction.
    """

    x: arb
    double: bool = False
    edge: bool = False


def next_turning_point(
    function: Formula, start: arb, edge: arb, *, leaving: bool, closed: bool
) -> End | None:
    """The nearest root between a point and the edge of the domain.

    Parameters
    ----------
    function : formula
        Positive at `start`, or zero there and positive beyond it.
    start, edge : arb
    leaving : bool
        Whether it is zero at the start.
    closed : bool
        Whether the edge itself is a turning point where no root comes before it; otherwise the
        function has a root, or is singular at the edge and negative near it.

    Returns
    -------
    End or None
        None if there is no root, up to and including a closed edge.

    Raises
    ------
    InputError
        If roots are so close together that their number is not decided.
    """
    sign = 1 if edge > start else -1
    length = abs(edge - start)

    def outward(distance: Argument) -> Argument | arb:
        return function(sign * distance + start)

    def quotient_jet(ball: arb) -> tuple[arb, arb, arb]:
        points = (arb(0), ball, ball, ball)
        first, second, third = (slope(outward, *points[:n]).real for n in (2, 3, 4))
        return first, second, third

    jets: Jet = quotient_jet if leaving else lambda ball: jet(outward, ball)
    if closed:
        last = jets(length)[0]
        if vanishes(last, jets(arb(0))[0]):
            inner = _first_root(jets, length * (1 - arb(NARROWEST)))
            nearest = inner or End(length, double=True, edge=True)
        else:
            first = _first_root(jets, length)
            if first is None:
                return None
            nearest = first
    else:
        regular = all(part.is_finite() for part in jets(length))
        first = _first_root(jets, length if regular else _beyond(jets, length))
        if first is None:
            raise InputError("the motion reaches the edge of its domain")
        nearest = first
    if nearest.edge:
        return End(edge, double=True, edge=True)
    return End(start + sign * nearest.x, nearest.double)


def _beyond(jets: Jet, length: arb) -> arb:
    """A point close to the edge at which the value is negative."""
    remaining = length
    for _ in range(HALVINGS):
        remaining = (remaining / 2).mid()
        point = length - remaining
        if jets(point)[0] < 0:
            return point.mid()
    raise InputError("the motion reaches the edge of its domain")


def _first_root(jets: Jet, length: arb) -> End | None:
    """The first root in (0, length] of a function that is positive at zero.

    Intervals are examined from left to right; before each, the function f is known to have no root
    so far, so that f(left) > 0.  Ball arithmetic encloses f, f′ and f″/2 over the interval:

    * f > 0, or f′ > 0 (f increases from a positive value): no root;
    * f′ < 0 (monotone) or f″ < 0 (concave): at most one root, since a concave function that is
      positive at both ends has none; f(right) decides between none and one;
    * f″ > 0 (convex): f′(left) > 0 means that f increases, and f′(right) < 0 that f decreases, so
      that f(right) decides; if f′ changes its sign, the minimum is located.  A positive minimum
      means no root, a negative one a first root before it, and one that vanishes to the
      precision of the computation is reported as a double root.

    Anything else is undecided, and the interval is divided.  This ends for simple and double roots,
    because f′ or f″ has a sign on small intervals around them; where f″ vanishes too, the width
    falls below NARROWEST and an error is raised.
    """
    waiting = [(arb(0), arb(length.mid()))]
    while waiting:
        left, right = waiting.pop()
        ball = left.union(right)
        value, rate, bend = jets(ball)
        if value > 0:
            continue
        if rate > 0:
            continue
        at_left, at_right = jets(left), jets(right)
        if rate < 0 or bend < 0:
            if at_right[0] > 0:
                continue
            if at_right[0] < 0:
                return End(_root(jets, left, right))
        elif bend > 0:
            if at_left[1] > 0 or (at_right[1] < 0 and at_right[0] > 0):
                continue
            if at_left[1] < 0 and at_right[1] > 0:
                lowest = _critical(jets, left, right)
                depth = jets(lowest)[0]
                if depth > 0 and not vanishes(depth, bend):
                    continue
                if depth < 0 and not vanishes(depth, bend):
                    return End(_root(jets, left, lowest.mid()))
                return End(lowest, double=True)
            if at_right[1] < 0 and at_right[0] < 0:
                return End(_root(jets, left, right))
        if right - left < NARROWEST:
            raise InputError(
                f"the motion comes within {NARROWEST:g} of a place where more than two roots meet: "
                "such motions are not treated"
            )
        # Not in the middle, where symmetric functions may have a root.
        middle = (left + (right - left) * arb("0.4871")).mid()
        waiting += [(middle, right), (left, middle)]
    return None


def _root(jets: Jet, left: arb, right: arb) -> arb:
    """The root between a positive value on the left and a negative one on the right."""
    for _ in range(HALVINGS):
        middle = ((left + right) / 2).mid()
        tight = _newton(lambda ball: jets(ball)[:2], middle, right - left)
        if tight is not None:
            return tight
        value = jets(middle)[0]
        if value > 0:
            left = middle
        elif value < 0:
            right = middle
        else:
            left, right = (left + middle) / 2, (right + middle) / 2
    raise InputError("a turning point could not be isolated")


def _critical(jets: Jet, left: arb, right: arb) -> arb:
    """The zero of the first derivative, which changes from negative to positive."""

    def slopes(ball: arb) -> tuple[arb, arb]:
        _, rate, bend = jets(ball)
        return rate, 2 * bend

    for _ in range(HALVINGS):
        middle = ((left + right) / 2).mid()
        tight = _newton(slopes, middle, right - left)
        if tight is not None:
            return tight
        if slopes(middle)[0] < 0:
            left = middle
        else:
            right = middle
    raise InputError("an equilibrium could not be isolated")


def _newton(function: Callable[[arb], tuple[arb, arb]], guess: arb, width: arb) -> arb | None:
    """Interval Newton from a guess; None unless it proves a root within `width` of the guess.

    If the image g − f(g)/f′(B) of the ball B lies inside B, f has exactly one zero in B, and it
    lies in the image (W. Tucker, Validated Numerics, chapter 5).
    """
    for _ in range(12):
        value, rate = function(guess)
        step = value / rate
        if not step.is_finite() or abs(step) > width:
            return None
        guess = (guess - step).mid()
        if abs(step) < arb(2) ** (-ctx.prec // 2):
            break
    value, rate = function(guess)
    reach = 4 * abs(value / rate).upper() + arb(2) ** (-ctx.prec)
    ball = arb(guess, reach)
    image = guess - value / function(ball)[1]
    if not (image.is_finite() and ball.contains(image) and abs(image - guess) < width):
        return None
    return _contraction(function, image)


def _contraction(function: Callable[[arb], tuple[arb, arb]], ball: arb) -> arb:
    """A ball with exactly one root, as small as the precision allows."""
    for _ in range(HALVINGS):
        middle = ball.mid()
        # The derivative over the whole ball, which contains both the midpoint and the root.
        image = (middle - function(middle)[0] / function(ball)[1]).intersection(ball)
        if not image.rad() < ball.rad() / 2:
            return image if image.rad() < ball.rad() else ball
        ball = image
    return ball
