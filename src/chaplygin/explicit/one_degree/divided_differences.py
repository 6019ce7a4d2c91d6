"""Divided differences of analytic functions in ball arithmetic.

A function f at points x₀, …, x_n (any of which may coincide) is the upper triangular matrix of all
its divided differences f[x_i, …, x_j], which is f of the matrix with the points on the diagonal and
ones above it (Opitz).  Sums, products, quotients and functions of such matrices are those of the
functions, so a formula evaluated on them yields f[x₀, …, x_n] without cancellation: with a root of
f among the points, f divided by its linear factor; with equal points, derivatives.

Roots take no value where a complex ball meets their branch cut, so that a finite result on a ball
says that the formula is analytic there.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from flint import acb, acb_mat, arb

__all__ = ["DividedDifferences", "jet", "slope", "value"]

#: What becomes of a formula when its variable takes a value.
Formula = Callable[[Any], Any]

_NOWHERE = acb(float("nan"), float("nan"))


class DividedDifferences:
    """A function at several points, as the matrix of its divided differences.

    Parameters
    ----------
    matrix : flint.acb_mat
        Upper triangular.
    """

    __slots__ = ("matrix",)

    def __init__(self, matrix: Any) -> None:
        self.matrix = matrix

    @classmethod
    def variable(cls, points: Sequence[Any]) -> DividedDifferences:
        """The function x at `points` (arb or acb)."""
        size = len(points)
        matrix = acb_mat(size, size)
        for i, point in enumerate(points):
            matrix[i, i] = point
            if i + 1 < size:
                matrix[i, i + 1] = 1
        return cls(matrix)

    def _constant(self, number: Any) -> Any:
        size = self.matrix.nrows()
        matrix = acb_mat(size, size)
        for i in range(size):
            matrix[i, i] = number
        return matrix

    def __neg__(self) -> DividedDifferences:
        return DividedDifferences(-self.matrix)

    def __add__(self, other: Any) -> DividedDifferences:
        matrix = other.matrix if isinstance(other, DividedDifferences) else self._constant(other)
        return DividedDifferences(self.matrix + matrix)

    __radd__ = __add__

    def __sub__(self, other: Any) -> DividedDifferences:
        matrix = other.matrix if isinstance(other, DividedDifferences) else self._constant(other)
        return DividedDifferences(self.matrix - matrix)

    def __rsub__(self, other: Any) -> DividedDifferences:
        return DividedDifferences(self._constant(other) - self.matrix)

    def __mul__(self, other: Any) -> DividedDifferences:
        return DividedDifferences(
            self.matrix * (other.matrix if isinstance(other, DividedDifferences) else acb(other))
        )

    __rmul__ = __mul__

    def inverse(self) -> DividedDifferences:
        """1/f; not finite where f may vanish."""
        size = self.matrix.nrows()
        known, found = self.matrix, acb_mat(size, size)
        for i in range(size):
            found[i, i] = 1 / known[i, i]
        for width in range(1, size):
            for i in range(size - width):
                j = i + width
                rest = sum((known[i, k] * found[k, j] for k in range(i + 1, j + 1)), acb(0))
                found[i, j] = -rest * found[i, i]
        return DividedDifferences(found)

    def __truediv__(self, other: Any) -> DividedDifferences:
        return self * (other.inverse() if isinstance(other, DividedDifferences) else 1 / acb(other))

    def __rtruediv__(self, other: Any) -> DividedDifferences:
        return DividedDifferences(self.inverse().matrix * acb(other))

    def __pow__(self, exponent: int) -> DividedDifferences:
        if exponent < 0:
            positive: DividedDifferences = self**-exponent
            return positive.inverse()
        result = DividedDifferences(self._constant(1))
        for _ in range(exponent):
            result = result * self
        return result

    def sqrt(self) -> DividedDifferences:
        """The root with positive real part; not finite where a ball meets the negative axis."""
        size = self.matrix.nrows()
        known, found = self.matrix, acb_mat(size, size)
        for i in range(size):
            found[i, i] = known[i, i].sqrt(analytic=True)
        for width in range(1, size):
            for i in range(size - width):
                j = i + width
                rest = sum((found[i, k] * found[k, j] for k in range(i + 1, j)), acb(0))
                found[i, j] = (known[i, j] - rest) / (found[i, i] + found[j, j])
        return DividedDifferences(found)

    def exp(self) -> DividedDifferences:
        """e to the power of the function."""
        return DividedDifferences(self.matrix.exp())

    def cos(self) -> DividedDifferences:
        """The cosine of the function."""
        turned = self.matrix * acb(0, 1)
        return DividedDifferences((turned.exp() + (-turned).exp()) * acb(0.5))

    def sin(self) -> DividedDifferences:
        """The sine of the function."""
        turned = self.matrix * acb(0, 1)
        return DividedDifferences((turned.exp() - (-turned).exp()) * acb(0, -0.5))


def _last(function: Formula, points: Sequence[Any]) -> Any:
    result = function(DividedDifferences.variable(points))
    if not isinstance(result, DividedDifferences):
        # a constant
        return acb(result) if len(points) == 1 else acb(0)
    found = result.matrix[0, len(points) - 1]
    return found if found.is_finite() else _NOWHERE


def value(function: Formula, point: Any) -> Any:
    """The function at a point (acb), not finite where it may not be analytic."""
    if isinstance(point, acb) and not point.imag.is_zero():
        return _last(function, (point,))
    return acb(function(point.real))


def slope(function: Formula, *points: Any) -> Any:
    """The divided difference f[x₀, …, x_n] as an acb."""
    return _last(function, points)


def jet(function: Formula, ball: Any) -> tuple[Any, Any, Any]:
    """f, f′ and f″/2 on a real ball (arb)."""
    result = function(DividedDifferences.variable((ball, ball, ball)))
    if not isinstance(result, DividedDifferences):
        return arb(result), arb(0), arb(0)
    row = [result.matrix[0, j] for j in range(3)]
    return row[0].real, row[1].real, row[2].real
