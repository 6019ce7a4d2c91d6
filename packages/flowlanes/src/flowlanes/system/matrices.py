"""Named columns and matrices of dimension n, n = 2 to 9, and scalars made of them.

They complement the 3-vectors of :mod:`flowlanes.system.vectors`: formulas keep their matrix form,
so that they print as ``k ω − ω k``, and `to_components` converts them to scalars.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, combinations_with_replacement, product
from typing import Self, TypeAlias

import sympy as sp
from sympy.core.symbol import Str
from sympy.matrices.expressions import MatrixExpr

from .vectors import Components, Node, Scalar, ScalarOfTensors, Vector, real_symbol, to_components

IndexPair: TypeAlias = tuple[int, int]


class Column(Vector):
    """A named vector with the components ``name_1`` to ``name_n``.

    Parameters
    ----------
    name : str
    size : int
        The dimension n.
    """

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The component symbols, in order."""
        return tuple(real_symbol(f"{self.name}_{i}") for i in range(1, int(self.shape[0]) + 1))


class NamedMatrix(Node, sp.MatrixSymbol):
    """A named n × n matrix with some independent entries."""

    def __new__(cls, name: str | Str, size: int, *_: object) -> Self:
        """Create the symbol; SymPy also rebuilds expressions through this method."""
        matrix: Self = sp.Basic.__new__(cls, Str(str(name)), sp.Integer(size), sp.Integer(size))
        return matrix

    @property
    def places(self) -> tuple[IndexPair, ...]:
        """The indices of the independent entries, in order."""
        raise NotImplementedError

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The independent entries, in order."""
        return tuple(real_symbol(f"{self.name}_{i + 1}{j + 1}") for i, j in self.places)

    @property
    def entries(self) -> Components:
        """The n × n matrix of scalars."""
        raise NotImplementedError

    def independent(self, matrix: sp.MatrixBase) -> tuple[Scalar, ...]:
        """The entries of `matrix` that belong to `symbols`."""
        return tuple(matrix[i, j] for i, j in self.places)

    def as_explicit(self) -> Components:
        """The n × n matrix of scalars."""
        return self.entries


class Skew(NamedMatrix):
    """A named skew-symmetric matrix with entries ``name_12``, ``name_13``, …, row by row."""

    @property
    def places(self) -> tuple[IndexPair, ...]:
        """The indices above the diagonal, row by row."""
        return tuple(combinations(range(int(self.shape[0])), 2))

    @property
    def entries(self) -> Components:
        """The n × n matrix of scalars."""
        table = dict(zip(self.places, self.symbols, strict=True))
        return Components(
            *self.shape, lambda i, j: table[i, j] if i < j else -table[j, i] if j < i else 0
        )


class SymmetricMatrix(NamedMatrix):
    """A named symmetric matrix with the entries ``name_11``, ``name_12``, …, ``name_nn``."""

    @property
    def places(self) -> tuple[IndexPair, ...]:
        """The indices of the upper triangle, row by row."""
        return tuple(combinations_with_replacement(range(int(self.shape[0])), 2))

    @property
    def entries(self) -> Components:
        """The n × n matrix of scalars."""
        table = dict(zip(self.places, self.symbols, strict=True))
        return Components(*self.shape, lambda i, j: table[min(i, j), max(i, j)])


class SquareMatrix(NamedMatrix):
    """A named n × n matrix with all entries independent."""

    @property
    def places(self) -> tuple[IndexPair, ...]:
        """All indices, row by row."""
        rows = range(int(self.shape[0]))
        return tuple(product(rows, rows))

    @property
    def entries(self) -> Components:
        """The n × n matrix of scalars."""
        return Components(*self.shape, self.symbols)


class Image(Node, MatrixExpr):
    """The image of a skew-symmetric matrix under a named operator, printed as ``I(ω)``.

    Parameters
    ----------
    name : sympy.Symbol
        The name of the operator.
    argument : MatrixExpr
    value : sympy.Matrix
        The image as a matrix.
    """

    def __new__(cls, name: sp.Symbol, argument: MatrixExpr, value: sp.MatrixBase) -> Image:
        """Create the node without evaluation."""
        node: Image = sp.Basic.__new__(cls, name, argument, sp.ImmutableDenseMatrix(value))
        return node

    @property
    def shape(self) -> tuple[sp.Expr, sp.Expr]:
        """Rows and columns."""
        return tuple(self.args[1].shape)

    def as_explicit(self) -> Components:
        """The n × n matrix of scalars."""
        return Components(self.args[2])


class Blocks(Node, MatrixExpr):
    """A matrix printed by blocks, such as ``[0, w; −wᵀ, 0]``.

    Parameters
    ----------
    rows : sequence of sequences of MatrixExpr or sympy.Expr
        The blocks; a scalar is a 1 × 1 block.
    """

    def __new__(cls, rows: Sequence[Sequence[sp.Basic]]) -> Blocks:
        """Create the node without evaluation."""
        node: Blocks = sp.Basic.__new__(cls, sp.Tuple(*(sp.Tuple(*row) for row in rows)))
        return node

    @property
    def rows_of_blocks(self) -> tuple[tuple[sp.Basic, ...], ...]:
        """The blocks."""
        return tuple(tuple(row) for row in self.args[0])

    @property
    def shape(self) -> tuple[sp.Expr, sp.Expr]:
        """Rows and columns."""
        explicit = self.as_explicit()
        return sp.Integer(explicit.rows), sp.Integer(explicit.cols)

    def as_explicit(self) -> Components:
        """The matrix of scalars."""
        rows = (
            sp.Matrix.hstack(*(sp.Matrix([to_components(block)]) for block in row))
            for row in self.rows_of_blocks
        )
        return Components(sp.Matrix.vstack(*rows))


class MatrixProduct(ScalarOfTensors):
    """The scalar product (A, B) = ½ tr AᵀB of n × n matrices."""

    def explicit(self) -> Scalar:
        """The sum in components."""
        left, right = (to_components(arg) for arg in self.args)
        # For skew-symmetric matrices ½ Σ A_ij B_ij over all i, j is the sum over i < j.
        if left == -left.T and right == -right.T:
            pairs = combinations(range(left.shape[0]), 2)
            return sp.Add(*(left[i, j] * right[i, j] for i, j in pairs))
        return sp.Add(*(a * b for a, b in zip(left, right, strict=True))) / 2


class Pfaffian(ScalarOfTensors):
    """The Pfaffian of a skew-symmetric matrix of even size, printed as ``Pf k``; Pf² = det."""

    def explicit(self) -> Scalar:
        """The sum over pairings, in components."""
        return _pfaffian(to_components(self.args[0]), tuple(range(int(self.args[0].shape[0]))))


def _pfaffian(matrix: Components, rows: tuple[int, ...]) -> Scalar:
    """The Pfaffian by expansion along the first row."""
    if not rows:
        return sp.S.One
    first, *others = rows
    return sp.Add(
        *(
            (-1) ** place * matrix[first, j] * _pfaffian(matrix, tuple(i for i in others if i != j))
            for place, j in enumerate(others)
        )
    )


class Jacobian(ScalarOfTensors):
    """The determinant of a linear map, printed as ``det ∂k/∂ω``, with a given value.

    Parameters
    ----------
    image, argument : MatrixExpr
        k and ω, where k is linear in ω.
    value : sympy.Expr
        The determinant, such as the product of the pivots of an elimination.
    """

    def __new__(cls, image: MatrixExpr, argument: MatrixExpr, value: sp.Expr) -> Jacobian:
        """Create the node without evaluation."""
        node: Jacobian = sp.Basic.__new__(cls, image, argument, value)
        return node

    def explicit(self) -> Scalar:
        """The value."""
        return to_components(self.args[2])


def wedge(left: MatrixExpr, right: MatrixExpr) -> Components:
    """u ∧ v = u vᵀ − v uᵀ by components."""
    u, v = to_components(left), to_components(right)
    return Components(u * v.T - v * u.T)
