"""Divided differences of analytic functions in ball arithmetic.

A function f at points x₀, …, x_n (any of which may coincide) is represented by the upper triangular
matrix of all its divided differences f[x_i, …, x_j], which is f applied to the matrix with the
points on the diagonal and ones above it (Opitz).  Sums, products, quotients and functions of such
matrices are those of the functions, so a formula evaluated on them yields f[x₀, …, x_n] without
cancellation: with a root of f among the points, f divided by its linear factor; with equal points,
derivatives.

Roots have no value where a complex ball meets their branch cut, so a finite result on a ball proves
that the formula is analytic there.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol, TypeAlias, TypeVar

from flint import acb, acb_mat, arb, ctx, fmpq

#: Constants in formulas.
Constant: TypeAlias = int | float | fmpq | arb | acb

_NAN = acb(float("nan"), float("nan"))
#: Number of square roots taken before the series of the logarithm.
_ROOTS = 16
#: Powers up to this are computed as products.
_PRODUCTS = 16


class DividedDifferences:
    """A function at several points, as the matrix of its divided differences.

    Parameters
    ----------
    matrix : flint.acb_mat
        Upper triangular.
    """

    __slots__ = ("matrix",)

    def __init__(self, matrix: acb_mat) -> None:
        self.matrix = matrix

    @classmethod
    def variable(cls, points: Sequence[arb | acb]) -> DividedDifferences:
        """The function x at `points` (arb or acb)."""
        size = len(points)
        matrix = acb_mat(size, size)
        for i, point in enumerate(points):
            matrix[i, i] = point
            if i + 1 < size:
                matrix[i, i + 1] = 1
        return cls(matrix)

    def _constant(self, number: Constant) -> acb_mat:
        size = self.matrix.nrows()
        matrix = acb_mat(size, size)
        for i in range(size):
            matrix[i, i] = number
        return matrix

    def __neg__(self) -> DividedDifferences:
        return DividedDifferences(-self.matrix)

    def __add__(self, other: Constant | DividedDifferences) -> DividedDifferences:
        matrix = other.matrix if isinstance(other, DividedDifferences) else self._constant(other)
        return DividedDifferences(self.matrix + matrix)

    __radd__ = __add__

    def __sub__(self, other: Constant | DividedDifferences) -> DividedDifferences:
        matrix = other.matrix if isinstance(other, DividedDifferences) else self._constant(other)
        return DividedDifferences(self.matrix - matrix)

    def __rsub__(self, other: Constant) -> DividedDifferences:
        return DividedDifferences(self._constant(other) - self.matrix)

    def __mul__(self, other: Constant | DividedDifferences) -> DividedDifferences:
        return DividedDifferences(
            self.matrix * (other.matrix if isinstance(other, DividedDifferences) else acb(other))
        )

    __rmul__ = __mul__

    def inverse(self) -> DividedDifferences:
        """1/f; not finite where f may vanish."""
        size = self.matrix.nrows()
        # Back substitution, diagonal by diagonal: entry (i, j) of the product with the inverse
        # vanishes.
        known, inverse = self.matrix, acb_mat(size, size)
        for i in range(size):
            inverse[i, i] = 1 / known[i, i]
        for width in range(1, size):
            for i in range(size - width):
                j = i + width
                inner = sum((known[i, k] * inverse[k, j] for k in range(i + 1, j + 1)), acb(0))
                inverse[i, j] = -inner * inverse[i, i]
        return DividedDifferences(inverse)

    def __truediv__(self, other: Constant | DividedDifferences) -> DividedDifferences:
        return self * (other.inverse() if isinstance(other, DividedDifferences) else 1 / acb(other))

    def __rtruediv__(self, other: Constant) -> DividedDifferences:
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
        """The root with positive real part; not finite if a ball meets the negative axis."""
        size = self.matrix.nrows()
        values = [self.matrix[i, i].sqrt(analytic=True) for i in range(size)]
        return DividedDifferences(_root(self.matrix, values))

    def log(self) -> DividedDifferences:
        """The logarithm; not finite if a ball meets the negative axis.

        By repeated square roots f^(1/2^k) = 1 + z and the series of log(1 + z), with a bound of its
        remainder.
        """
        # Inverse scaling and squaring (Higham, Functions of Matrices, chapter 11).  In the row-sum
        # norm the omitted terms are below length^(terms + 1)/(1 − length), and no entry exceeds the
        # norm.
        size, terms = self.matrix.nrows(), ctx.prec // _ROOTS + 4
        values = [_logarithm(self.matrix[i, i]) for i in range(size)]
        z = self.matrix
        for k in range(1, _ROOTS + 1):
            z = _root(z, [(x / 2**k).exp() for x in values])
        for i in range(size):
            z[i, i] = (values[i] / 2**_ROOTS).expm1()
        length = max(sum((abs(x) for x in row), arb(0)).upper() for row in z.tolist())
        if not length < 0.5:
            return DividedDifferences(self._constant(_NAN))
        total = acb_mat(size, size)
        for k in range(terms, 0, -1):
            total = (self._constant(arb((-1) ** (k + 1)) / k) + total) * z
        rest = arb(0, (length ** (terms + 1) / (1 - length)).upper())
        for i in range(size):
            for j in range(i, size):
                total[i, j] = (total[i, j] + acb(rest, rest)) * 2**_ROOTS
            total[i, i] = values[i]
        return DividedDifferences(total)

    def exp(self) -> DividedDifferences:
        """e to the power of the function."""
        return DividedDifferences(self.matrix.exp())

    def cos(self) -> DividedDifferences:
        """The cosine of the function."""
        rotated = self.matrix * acb(0, 1)
        return DividedDifferences((rotated.exp() + (-rotated).exp()) * acb(0.5))

    def sin(self) -> DividedDifferences:
        """The sine of the function."""
        rotated = self.matrix * acb(0, 1)
        return DividedDifferences((rotated.exp() - (-rotated).exp()) * acb(0, -0.5))


def _root(matrix: acb_mat, values: Sequence[acb]) -> acb_mat:
    """The square root of an upper triangular matrix, with given roots of its diagonal."""
    size = matrix.nrows()
    # The recurrence of Björck and Hammarling (Higham, Functions of Matrices, chapter 6), which
    # follows from entry (i, j) of root² = matrix.
    root = acb_mat(size, size)
    for i in range(size):
        root[i, i] = values[i]
    for width in range(1, size):
        for i in range(size - width):
            j = i + width
            inner = sum((root[i, k] * root[k, j] for k in range(i + 1, j)), acb(0))
            root[i, j] = (matrix[i, j] - inner) / (root[i, i] + root[j, j])
    return root


def _logarithm(x: acb) -> acb:
    """The logarithm, not finite if a ball meets the negative axis."""
    return x.log() if x.real > 0 or not x.imag.contains(0) else _NAN


#: Real or complex balls, or divided differences of them.
Argument = TypeVar("Argument", arb, acb, DividedDifferences)


class Formula(Protocol):
    """A formula in one variable; where it is constant its value may be a ball."""

    def __call__(self, x: Argument, /) -> Argument | arb:
        """The value at a point, or the divided differences at several points."""


def analytic_root(x: Argument) -> Argument:
    """A square root, not finite if a complex ball meets the branch cut."""
    return x.sqrt(analytic=True) if isinstance(x, acb) else x.sqrt()


def power(x: Argument, exponent: fmpq) -> Argument:
    """A real power, not finite if a complex ball meets the branch cut."""
    if abs(exponent) <= _PRODUCTS and exponent.q == 1:
        whole: Argument = x ** int(exponent.p)
        return whole
    if abs(exponent) <= _PRODUCTS and exponent.q == 2:
        half: Argument = analytic_root(x) ** int(exponent.p)
        return half
    logarithm = _logarithm(x) if isinstance(x, acb) else x.log()
    result: Argument = (logarithm * arb(exponent)).exp()
    return result


def value(function: Formula, point: arb | acb) -> acb:
    """The function at a point, not finite where it may not be analytic."""
    if isinstance(point, acb) and not point.imag.is_zero():
        return slope(function, point)
    return acb(function(point.real))


def slope(function: Formula, *points: arb | acb) -> acb:
    """The divided difference f[x₀, …, x_n]."""
    result = function(DividedDifferences.variable(points))
    if not isinstance(result, DividedDifferences):
        # a constant
        return acb(result) if len(points) == 1 else acb(0)
    last = result.matrix[0, len(points) - 1]
    return last if last.is_finite() else _NAN


def jet(function: Formula, ball: arb) -> tuple[arb, arb, arb]:
    """f, f′ and f″/2 on a real ball."""
    result = function(DividedDifferences.variable((ball, ball, ball)))
    if not isinstance(result, DividedDifferences):
        return arb(result), arb(0), arb(0)
    row = [result.matrix[0, j] for j in range(3)]
    return row[0].real, row[1].real, row[2].real
