"""Forms without real zeros on a part of the sphere, by exact Bernstein coefficients.

Each line through the origin meets one of three faces γ_k = 1, |γ_i| ≤ 1, of a cube.  On a rectangle
of a face a form is a polynomial in two variables; it lies between the smallest and the largest of
its Bernstein coefficients, so it has no zero if these have one sign.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from math import comb

from flint import fmpq, fmpq_mat, fmpq_mpoly


@dataclass(frozen=True)
class Rectangle:
    """A part of the face γ_k = 1 of the cube.

    Attributes
    ----------
    face : int
        k, counted from zero.
    low, high : pair of fmpq
        Bounds of the other two components of γ, in order.
    """

    face: int
    low: tuple[fmpq, fmpq]
    high: tuple[fmpq, fmpq]

    @property
    def middle(self) -> tuple[fmpq, fmpq, fmpq]:
        """The centre of the rectangle."""
        inner = [(a + b) / 2 for a, b in zip(self.low, self.high, strict=True)]
        inner.insert(self.face, fmpq(1))
        x, y, z = inner
        return x, y, z

    def halves(self) -> tuple[Rectangle, Rectangle]:
        """Two rectangles, cut across the longer side."""
        sides = [b - a for a, b in zip(self.low, self.high, strict=True)]
        cut = 0 if sides[0] >= sides[1] else 1
        half = (self.low[cut] + self.high[cut]) / 2
        low, high = list(self.low), list(self.high)
        low[cut] = high[cut] = half
        return (
            Rectangle(self.face, self.low, (high[0], high[1])),
            Rectangle(self.face, (low[0], low[1]), self.high),
        )


def faces() -> list[Rectangle]:
    """Three faces of the cube; every line through the origin meets one of them."""
    one = fmpq(1)
    return [Rectangle(k, (-one, -one), (one, one)) for k in range(3)]


def vanishes_nowhere(form: fmpq_mpoly, where: Rectangle) -> bool:
    """Whether the Bernstein coefficients of a form on a rectangle have one sign."""
    first, second = (i for i in range(3) if i != where.face)
    table = form.to_dict()
    degrees = [max((powers[i] for powers in table), default=0) for i in (first, second)]
    rows = [[fmpq(0)] * (degrees[1] + 1) for _ in range(degrees[0] + 1)]
    for powers, number in table.items():
        rows[powers[first]][powers[second]] += number
    left = _bernstein(degrees[0], where.low[0], where.high[0])
    right = _bernstein(degrees[1], where.low[1], where.high[1])
    values = (left * fmpq_mat(rows) * right.transpose()).entries()
    return all(x > 0 for x in values) or all(x < 0 for x in values)


def without_real_zero(form: fmpq_mpoly, depth: int = 9) -> bool | None:
    """Whether a form has no zero except the origin; None if undecided after `depth` cuts."""
    pending = [(face, 0) for face in faces()]
    sign = 0
    while pending:
        where, cuts = pending.pop()
        value = form(*where.middle)
        here = (value > 0) - (value < 0)
        even = form.total_degree() % 2 == 0
        if here == 0 or not even or (sign and here != sign):
            # A form of odd degree takes both signs.
            return False
        sign = here
        if vanishes_nowhere(form, where):
            continue
        if cuts == depth:
            return None
        pending += [(half, cuts + 1) for half in where.halves()]
    return True


@lru_cache(maxsize=4096)
def _bernstein(degree: int, low: fmpq, high: fmpq) -> fmpq_mat:
    """Convert coefficients of powers of x to Bernstein coefficients on [low, high]."""
    # x = low + width·s gives x^j = Σ_k C(j,k) low^(j−k) width^k s^k, and s^k has the Bernstein
    # coefficients C(i,k)/C(n,k) of degree n
    size, width = degree + 1, high - low
    shift = fmpq_mat(
        [
            [comb(j, k) * low ** (j - k) * width**k if j >= k else fmpq(0) for j in range(size)]
            for k in range(size)
        ]
    )
    basis = fmpq_mat(
        [
            [fmpq(comb(i, k), comb(degree, k)) if k <= i else fmpq(0) for k in range(size)]
            for i in range(size)
        ]
    )
    return basis * shift
