"""Affine functions on many small boxes of the torus, with bounds of the remainder.

    x(c + δ) = x₀ + x₁δ₁ + x₂δ₂ + ε,      |δ_j| ≤ h_j real,  |ε| ≤ rest,

all complex.  Plain intervals lose accuracy in proportion to the size of the box in every operation,
affine functions in proportion to its square.  The coefficients are doubles, for all boxes at once;
their rounding errors, at most a few units of 1.1e-16 of the sizes involved, are included in the
remainder with a wide margin.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from flint import arb

from flowlanes.formulas.balls import number
from flowlanes.system.arrays import BoolArray, ComplexArray, FloatArray

#: A bound of the relative error of a dozen roundings.
ROUNDING = 1e-14


@dataclass(frozen=True)
class Affine:
    """A function on boxes.

    Attributes
    ----------
    middle : complex array (n,)
        x₀.
    slopes : complex array (2, n)
        x₁, x₂.
    rest : array (n,)
        Infinite where the function may not exist.
    half : (float, float)
        h₁, h₂.
    """

    middle: ComplexArray
    slopes: ComplexArray
    rest: FloatArray
    half: tuple[float, float]

    @cached_property
    def linear_bound(self) -> FloatArray:
        """A bound of |x₁δ₁ + x₂δ₂|."""
        moduli: FloatArray = np.abs(self.slopes)
        sway: FloatArray = moduli[0] * self.half[0] + moduli[1] * self.half[1]
        return sway * (1 + ROUNDING)

    @cached_property
    def deviation_bound(self) -> FloatArray:
        """A bound of |x − x₀|."""
        return (self.linear_bound + self.rest) * (1 + ROUNDING)

    @cached_property
    def size(self) -> FloatArray:
        """A bound of |x|."""
        return (np.abs(self.middle) + self.deviation_bound) * (1 + ROUNDING)

    def __add__(self, other: Affine | arb | float) -> Affine:
        if not isinstance(other, Affine):
            value = number(other)
            slack = ROUNDING * (self.size + abs(value))
            return Affine(self.middle + value, self.slopes, self.rest + slack, self.half)
        rest = self.rest + other.rest + ROUNDING * (self.size + other.size)
        return Affine(self.middle + other.middle, self.slopes + other.slopes, rest, self.half)

    __radd__ = __add__

    def __sub__(self, other: Affine) -> Affine:
        return self + other * -1

    def __mul__(self, other: Affine | arb | float) -> Affine:
        if not isinstance(other, Affine):
            value = number(other)
            rest = abs(value) * (self.rest + ROUNDING * self.size)
            return Affine(self.middle * value, self.slopes * value, rest, self.half)
        x, y = self.middle, other.middle
        rest = (
            self.linear_bound * other.linear_bound
            + self.rest * other.size
            + other.rest * self.size
            + ROUNDING * self.size * other.size
        )
        return Affine(x * y, x * other.slopes + y * self.slopes, rest, self.half)

    __rmul__ = __mul__

    def clear(self, sign: int = 1) -> BoolArray:
        """The boxes on which x, times a sign, certainly avoids (−∞, 0]."""
        room = self.deviation_bound + ROUNDING * self.size
        return (self.middle.real * sign > room) | (np.abs(self.middle.imag) > room)

    def _through(
        self,
        value: ComplexArray,
        slope: ComplexArray,
        curvature: FloatArray,
        error: FloatArray,
        safe: BoolArray,
    ) -> Affine:
        """f(x) from f(x₀), f′(x₀), a bound of ½|f″| on the disc of x, and the error of f(x₀)."""
        rest = np.abs(slope) * self.rest + curvature * self.deviation_bound**2 + error
        rest = rest * (1 + ROUNDING) + ROUNDING * (
            np.abs(value) + np.abs(slope) * self.deviation_bound
        )
        return Affine(value, slope * self.slopes, np.where(safe, rest, np.inf), self.half)

    @property
    def _least(self) -> FloatArray:
        """A lower bound of |x|."""
        return np.abs(self.middle) * (1 - ROUNDING) - self.deviation_bound

    def inverse(self, sign: int = 1) -> Affine:
        """1/x, where x times the sign is known to avoid (−∞, 0]."""
        value = 1 / self.middle
        miss = np.abs(1 - self.middle * value) + ROUNDING
        error = miss / np.abs(self.middle)
        return self._through(value, -value * value, self._least**-3, error, self.clear(sign))

    def sqrt(self) -> Affine:
        """The principal root, where x is known to avoid (−∞, 0]."""
        value: ComplexArray = np.sqrt(self.middle)
        miss = np.abs(value * value - self.middle) + ROUNDING * np.abs(self.middle)
        error = miss / np.abs(value)
        slope, curvature = 0.5 / value, 0.125 * self._least**-1.5
        return self._through(value, slope, curvature, error, self.clear())
