"""Numbers on a small box of the torus: an affine function of the place and a bound of the rest.

    x(c + δ) = x₀ + x₁δ₁ + x₂δ₂ + ε,      |δ_j| ≤ h_j real,  |ε| ≤ rest,

all complex.  Where plain balls lose in every operation in proportion to the size of the box, here
it is in proportion to its square.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

__all__ = ["Affine", "clear"]

_Pair = tuple[Any, Any]


#: Cosine of the largest argument of a trial value, whose neighbours are to avoid (−∞, 0] too.
_TRIAL = -0.35


def clear(number: Any, sign: int = 1) -> bool:
    """Whether a number, times a sign, surely avoids (−∞, 0].

    Parameters
    ----------
    number : arb, Affine or complex array
        Of arrays, whether all entries avoid it amply.
    sign : ±1
    """
    if isinstance(number, arb):
        return bool(number * sign > 0)
    if isinstance(number, np.ndarray):
        return bool(np.all(number.real * sign > _TRIAL * np.abs(number)))
    spread = number.spread
    middle = number.middle * sign
    return bool(middle.real > spread) or bool(abs(middle.imag) > spread)


@dataclass(frozen=True)
class Affine:
    """A function on a box.

    Attributes
    ----------
    middle : acb
        x₀.
    slopes : (acb, acb)
        x₁, x₂.
    rest : arb
    half : (arb, arb)
        h₁, h₂.
    """

    middle: Any
    slopes: _Pair
    rest: Any
    half: _Pair

    @property
    def sway(self) -> Any:
        """A bound of |x₁δ₁ + x₂δ₂|."""
        return abs(self.slopes[0]) * self.half[0] + abs(self.slopes[1]) * self.half[1]

    @property
    def spread(self) -> Any:
        """A bound of |x − x₀|."""
        return self.sway + self.rest

    @property
    def size(self) -> Any:
        """A bound of |x|."""
        return (abs(self.middle) + self.spread).upper()

    def _made(self, middle: Any, first: Any, second: Any, rest: Any) -> Affine:
        return Affine(middle, (first, second), rest.upper(), self.half)

    def __add__(self, other: Any) -> Affine:
        if not isinstance(other, Affine):
            return Affine(self.middle + other, self.slopes, self.rest, self.half)
        return self._made(
            self.middle + other.middle,
            self.slopes[0] + other.slopes[0],
            self.slopes[1] + other.slopes[1],
            self.rest + other.rest,
        )

    __radd__ = __add__

    def __sub__(self, other: Affine) -> Affine:
        return self + other * -1

    def __mul__(self, other: Any) -> Affine:
        if not isinstance(other, Affine):
            a, b = self.slopes
            return self._made(self.middle * other, a * other, b * other, self.rest * abs(other))
        x, y = self.middle, other.middle
        rest = (
            self.sway * other.sway
            + self.rest * (abs(y) + other.spread)
            + other.rest * (abs(x) + self.sway)
        )
        (a, b), (c, d) = self.slopes, other.slopes
        return self._made(x * y, x * c + y * a, x * d + y * b, rest)

    __rmul__ = __mul__

    def _through(self, value: Any, slope: Any, curvature: Any) -> Affine:
        """f(x) from f(x₀), f′(x₀) and a bound of ½|f″| on the disc that contains x."""
        a, b = self.slopes
        rest = abs(slope) * self.rest + curvature * self.spread * self.spread
        return self._made(value, slope * a, slope * b, rest)

    @property
    def _least(self) -> Any:
        """A lower bound of |x|."""
        return abs(self.middle) - self.spread

    def inverse(self) -> Affine:
        """1/x, for x that is clear of zero."""
        value = 1 / self.middle
        return self._through(value, -value * value, 1 / self._least**3)

    def sqrt(self) -> Affine:
        """The principal root, for x that is clear of the negative axis."""
        value = self.middle.sqrt()
        return self._through(value, 1 / (2 * value), 1 / (8 * (self._least**3).sqrt()))
