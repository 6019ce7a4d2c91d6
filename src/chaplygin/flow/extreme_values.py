"""Which numbers of a start are so large or so small that formulas have no number there."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

__all__ = ["too_extreme"]

#: Numbers nearer to one than by this many powers of ten are not suspected.
_POWERS = 30


def too_extreme(numbers: Sequence[float], finite: Callable[[Sequence[float]], bool]) -> list[int]:
    """The places of the numbers but for whose size there would be a finite value.

    Parameters
    ----------
    numbers : sequence of float
    finite : callable
        Whether there is a finite value with such numbers.

    Returns
    -------
    list of int
        Without these no fewer do; empty where the sizes of the numbers are not to blame.
    """
    sizes = {i: abs(math.log10(abs(x))) for i, x in enumerate(numbers) if x}
    blamed = [i for i in sorted(sizes, key=sizes.__getitem__) if sizes[i] > _POWERS]

    def tame(places: Sequence[int]) -> bool:
        return finite([math.copysign(1.0, x) if i in places else x for i, x in enumerate(numbers)])

    if not blamed or not tame(blamed):
        return []
    for place in tuple(blamed):
        rest = [i for i in blamed if i != place]
        if tame(rest):
            blamed = rest
    return sorted(blamed)
