"""Real hyperelliptic curves of genus two with real branch points.

The curve is y² = R(z) = leading ∏ (z − root) with five or six roots.  They divide the real line,
closed at infinity, into six intervals on which R is alternately positive (*ovals*) and negative
(*gaps*).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from flint import arb


class DegenerateError(ValueError):
    """Two branch points cannot be separated: the curve may have a smaller genus."""


@dataclass(frozen=True)
class Curve:
    """y² = leading ∏ (z − root).

    Attributes
    ----------
    roots : tuple of arb
        Five or six, increasing.
    """

    leading: arb
    roots: tuple[arb, ...]

    @classmethod
    def of(cls, leading: arb, roots: Sequence[arb]) -> Curve:
        """The curve with given roots in any order.

        Raises
        ------
        DegenerateError
            If two of them overlap.
        """
        ordered = tuple(sorted(roots, key=lambda root: root.mid()))
        for low, high in pairwise(ordered):
            if not low < high:
                raise DegenerateError
        return cls(leading, ordered)

    def __call__(self, z: arb) -> arb:
        """R(z)."""
        value = self.leading
        for root in self.roots:
            value = value * (z - root)
        return value

    def cofactor(self, left: int, s: Any) -> Any:
        """|R| / ((z − l)(r − z)) at the angle s of the interval from root number `left` = l to r.

        There z = ½(l + r) − ½(r − l) cos s.  It is positive on the closed interval and analytic
        around it, and a product of positive sums: nothing cancels near other roots.

        Parameters
        ----------
        s : arb or acb
            In radians; 0 at l and π at r.
        """
        low, high = self.ends(left)
        half = s / 2
        from_low, to_high = (high - low) * half.sin() ** 2, (high - low) * half.cos() ** 2
        value = abs(self.leading)
        for place, root in enumerate(self.roots):
            if place < left:
                value = value * (low - root + from_low)
            elif place > left + 1:
                value = value * (root - high + to_high)
        return value

    @cached_property
    def first_oval(self) -> int:
        """0 or 1: the parity of the indices `left` of the intervals on which R > 0."""
        # To the right of all roots R has the sign of its leading coefficient.
        last = len(self.roots) - 1
        return last % 2 if self.leading > 0 else (last + 1) % 2

    @property
    def ovals(self) -> tuple[int, ...]:
        """Indices of the left ends of the bounded ovals."""
        return tuple(range(self.first_oval, len(self.roots) - 1, 2))

    def oval_of(self, z: arb) -> int:
        """The bounded oval nearest to z, as the index of its left end."""
        middle = z.mid()

        def distance(left: int) -> arb:
            low, high = self.roots[left].mid(), self.roots[left + 1].mid()
            return max(low - middle, middle - high, arb(0))

        return min(self.ovals, key=distance)

    def ends(self, left: int) -> tuple[arb, arb]:
        """The two roots that bound an interval."""
        return self.roots[left], self.roots[left + 1]
