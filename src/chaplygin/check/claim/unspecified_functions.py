"""Values of unspecified functions: invented once for every function, order and argument."""

from __future__ import annotations

import random
from collections.abc import Sequence

from flint import arb

from .jets import Jet, Number, add, multiply


class Functions:
    """Smooth functions about which nothing is known, at one point.

    A smooth function may have any values and derivatives at finitely many different arguments, so
    each is chosen freely, but the same where all arguments agree.

    Parameters
    ----------
    seed : str
        The choice is the same for the same seed and the same order of questions.
    """

    def __init__(self, seed: str) -> None:
        self._generator = random.Random(seed)
        self._values: dict[
            tuple[str, tuple[int, ...]], list[tuple[tuple[Number, ...], Number]]
        ] = {}

    def settle(
        self, word: str, orders: Sequence[int], arguments: Sequence[Number], value: Number
    ) -> None:
        """Give a value that is not chosen freely."""
        self._values.setdefault((word, tuple(orders)), []).append((tuple(arguments), value))

    def value(self, word: str, orders: tuple[int, ...], arguments: Sequence[Number]) -> Number:
        """A value, with derivatives as the arguments have them."""
        level = max((p.level for p in arguments if isinstance(p, Jet)), default=0)
        if level == 0:
            return self._free_value(word, orders, tuple(arguments))
        moving = {i: p for i, p in enumerate(arguments) if isinstance(p, Jet) and p.level == level}
        lower = [moving[i].value if i in moving else p for i, p in enumerate(arguments)]
        slopes: dict[int, Number] = {}
        for i, argument in moving.items():
            if not argument.slopes:
                continue
            partial = self.value(word, tuple(n + (i == j) for j, n in enumerate(orders)), lower)
            for k, slope in argument.slopes.items():
                part = multiply(partial, slope)
                slopes[k] = add(slopes[k], part) if k in slopes else part
        return Jet(level, self.value(word, orders, lower), slopes)

    def _free_value(
        self, word: str, orders: tuple[int, ...], arguments: tuple[Number, ...]
    ) -> Number:
        table = self._values.setdefault((word, orders), [])
        for known, value in table:
            if all(a.overlaps(b) for a, b in zip(known, arguments, strict=True)):
                return value
        size = 2 ** self._generator.randint(16, 28)
        value_chosen = arb(self._generator.randint(-(2**24), 2**24)) / size
        table.append((arguments, value_chosen))
        return value_chosen
