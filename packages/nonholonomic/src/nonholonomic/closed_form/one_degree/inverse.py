"""The inverse of an increasing function, with a proven error bound."""

from __future__ import annotations

from collections.abc import Callable

from flint import arb, ctx

#: Number of Newton steps, and of doublings of the radius of the last step.
STEPS, DOUBLINGS = 8, 60


def enclosed_root(
    function: Callable[[arb], arb], slope: Callable[[arb], arb], guess: float | arb
) -> arb:
    """The root of an increasing function: Newton's method, then an interval step as a proof.

    Parameters
    ----------
    function : callable
        Evaluated at exact numbers.
    slope : callable
        Its derivative, positive, on balls.
    guess : float or arb
    """
    x = arb(guess).mid()
    for _ in range(STEPS):
        step = function(x) / slope(x)
        x = (x - step).mid()
        if abs(step) < arb(2) ** (-ctx.prec // 2):
            break
    defect = function(x)
    reach = 2 * abs(defect / slope(x)).upper()
    for _ in range(DOUBLINGS):
        ball = arb(x, reach)
        image = x - defect / slope(ball)
        if image.is_finite() and ball.contains(image):
            return image
        reach = 2 * reach
    return arb(x, arb("inf"))
