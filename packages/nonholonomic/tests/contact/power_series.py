"""Truncated power series in one variable, with the arithmetic of numbers.

A formula written for floats runs on `Series` unchanged, so that the Taylor coefficients of a motion
follow from its equations order by order. Comparisons look at the constant term.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.floating[Any]]


class Series:
    """Polynomial ``c[0] + c[1] t + ... + c[n-1] t**(n-1)``, higher powers dropped."""

    __array_ufunc__ = None
    __slots__ = ("c",)

    def __init__(self, c: Array) -> None:
        self.c = c

    @staticmethod
    def constant(value: Any, terms: int) -> Series:
        """Series of a constant."""
        c = np.zeros(terms, dtype=type(value))
        c[0] = value
        return Series(c)

    def __float__(self) -> float:
        return float(self.c[0])

    def __neg__(self) -> Series:
        return Series(-self.c)

    def __add__(self, other: Series | float) -> Series:
        if isinstance(other, Series):
            return Series(self.c + other.c)
        c = self.c.copy()
        c[0] += other
        return Series(c)

    __radd__ = __add__

    def __sub__(self, other: Series | float) -> Series:
        return self + (-other)

    def __rsub__(self, other: float) -> Series:
        return (-self) + other

    def __mul__(self, other: Series | float) -> Series:
        if isinstance(other, Series):
            return Series(np.convolve(self.c, other.c)[: len(self.c)])
        return Series(self.c * other)

    __rmul__ = __mul__

    def reciprocal(self) -> Series:
        """One over the series."""
        a = self.c
        b = np.zeros_like(a)
        b[0] = 1.0 / a[0]
        for k in range(1, len(a)):
            b[k] = -b[0] * (a[1 : k + 1] @ b[k - 1 :: -1][:k])
        return Series(b)

    def __truediv__(self, other: Series | float) -> Series:
        if isinstance(other, Series):
            return self * other.reciprocal()
        return Series(self.c / other)

    def __rtruediv__(self, other: float) -> Series:
        return self.reciprocal() * other

    def __lt__(self, other: Series | float) -> bool:
        return float(self) < float(other)

    def __le__(self, other: Series | float) -> bool:
        return float(self) <= float(other)

    def __gt__(self, other: Series | float) -> bool:
        return float(self) > float(other)

    def __ge__(self, other: Series | float) -> bool:
        return float(self) >= float(other)

    def __abs__(self) -> Series:
        return self if self.c[0] >= 0.0 else -self

    def sqrt(self) -> Series:
        """Square root; the constant term must be positive."""
        a = self.c
        b = np.zeros_like(a)
        b[0] = np.sqrt(a[0])
        for k in range(1, len(a)):
            b[k] = (a[k] - b[1:k] @ b[k - 1 : 0 : -1]) / (2.0 * b[0])
        return Series(b)

    def __pow__(self, exponent: float) -> Series:
        if exponent == int(exponent) and exponent >= 0:
            product = Series.constant(self.c[0] * 0 + 1, len(self.c))
            for _ in range(int(exponent)):
                product = product * self
            return product
        a = self.c
        b = np.zeros_like(a)
        b[0] = a[0] ** exponent
        for k in range(1, len(a)):
            j = np.arange(1, k + 1)
            b[k] = ((exponent * j - (k - j)) * a[1 : k + 1] * b[k - 1 :: -1][:k]).sum() / (k * a[0])
        return Series(b)

    def exp(self) -> Series:
        """Exponential function."""
        b = np.zeros_like(self.c)
        b[0] = np.exp(self.c[0])
        for k in range(1, len(b)):
            j = np.arange(1, k + 1)
            b[k] = (j * self.c[1 : k + 1] * b[k - 1 :: -1][:k]).sum() / k
        return Series(b)

    def shifted(self, orders: int) -> Series:
        """Series times a power of `t`, which may be negative; coefficients that leave are lost."""
        c = np.zeros_like(self.c)
        if orders >= 0:
            c[orders:] = self.c[: len(c) - orders]
        else:
            c[:orders] = self.c[-orders:]
        return Series(c)

    def integral(self, start: float) -> Series:
        """Integral from 0 with value `start` there; the last coefficient is dropped."""
        c = np.empty_like(self.c)
        c[0] = start
        c[1:] = self.c[:-1] / np.arange(1, len(c))
        return Series(c)

    def derivative(self) -> Series:
        """Derivative; the last coefficient is set to zero."""
        c = np.zeros_like(self.c)
        c[:-1] = self.c[1:] * np.arange(1, len(c))
        return Series(c)

    def at(self, t: float) -> Any:
        """Value at `t`."""
        return np.polynomial.polynomial.polyval(t, self.c)


Number = float | np.longdouble | Series


def root(x: Any) -> Any:
    """Square root."""
    if isinstance(x, Series):
        return x.sqrt()
    return np.sqrt(x) if isinstance(x, np.longdouble) else math.sqrt(x)


def exponential(x: Any) -> Any:
    """Exponential function."""
    if isinstance(x, Series):
        return x.exp()
    return np.exp(x) if isinstance(x, np.longdouble) else math.exp(x)


def logarithm(x: Any) -> Any:
    """Natural logarithm of a number."""
    return np.log(x) if isinstance(x, np.longdouble) else math.log(x)


def arcsine(x: Any) -> Any:
    """Inverse sine, for a value below 1."""
    if isinstance(x, np.longdouble):
        return np.arcsin(x)
    if not isinstance(x, Series):
        return math.asin(x)
    return (x.derivative() / root(1.0 - x * x)).integral(math.asin(float(x)))


def solution(matrix: Sequence[Sequence[Any]], right: Sequence[Any]) -> list[Any]:
    """Solution of a square linear system; by elimination with pivots unless all are floats."""
    if type(right[0]) is float:
        solved: list[Any] = np.linalg.solve(np.array(matrix), np.array(right)).tolist()
        return solved
    rows = [[*row, b] for row, b in zip(matrix, right, strict=True)]
    size = len(rows)
    for i in range(size):
        best = max(range(i, size), key=lambda j: abs(float(rows[j][i])))
        rows[i], rows[best] = rows[best], rows[i]
        inverse = 1.0 / rows[i][i]
        rows[i] = [entry * inverse for entry in rows[i]]
        for j in range(size):
            factor = rows[j][i]
            if j != i and (isinstance(factor, Series) or factor != 0.0):
                rows[j] = [a - factor * b for a, b in zip(rows[j], rows[i], strict=True)]
    return [row[-1] for row in rows]
