"""Symbolic 3-vectors, and their components.

A vector is a SymPy matrix expression of shape (3, 1).  Formulas built from
:func:`dot`, :func:`cross` and :func:`outer` keep their vector form, so that they print as
``M×ω + m ṙ×(ω×r)``; :func:`to_components` turns the same formula into three scalars.

Examples
--------
>>> M, omega = Vector("M"), Vector("omega")
>>> cross(M, omega), cross(M, 2 * M), norm_squared(M)
(Cross(M, omega), 0, Dot(M, M))
>>> to_components(dot(M, Diagonal("I") * omega))
I_1*M_1*omega_1 + I_2*M_2*omega_2 + I_3*M_3*omega_3
>>> to_components(dot(constant([1, 2, real_symbol("k")]), M) - dot(unit_vector(3), M))
M_1 + 2*M_2 + M_3*k - M_3
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Self, TypeAlias

import sympy as sp
from sympy.core.symbol import Str
from sympy.matrices.expressions import (
    Identity,
    Inverse,
    MatAdd,
    MatMul,
    MatPow,
    MatrixExpr,
    Transpose,
    ZeroMatrix,
)
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import PRECEDENCE

from ..arguments import Formulas, arguments_checked
from ..errors import InputError
from .display import formula_latex

Scalar: TypeAlias = sp.Expr
Components: TypeAlias = sp.ImmutableDenseMatrix
_LABELS = {2: ("x", "y"), 3: ("1", "2", "3"), 4: ("w", "x", "y", "z")}

zero: MatrixExpr = ZeroMatrix(3, 1)
identity: MatrixExpr = Identity(3)


def by_name(formula: sp.Basic | float, symbols: Iterable[sp.Symbol]) -> sp.Expr:
    """The formula with the known symbols in place of others of the same name.

    ``Symbol("gamma_3")`` and ``Symbol("gamma_3", real=True)`` differ for SymPy, but mean the same
    in a formula that a user writes.
    """
    named = {symbol.name: symbol for symbol in symbols}
    written = sp.sympify(formula)
    return written.xreplace({s: named[s.name] for s in written.free_symbols if s.name in named})


@arguments_checked
def real_symbol(name: str) -> sp.Symbol:
    """A real scalar symbol, the only kind used in this package."""
    return sp.Symbol(name, real=True)


class Vector(sp.MatrixSymbol):
    """A named vector with the components ``name_1``, ``name_2``, ``name_3``.

    Parameters
    ----------
    name : str
        Name as spelt in code; Greek names and the endings ``dot`` and ``tilde`` are
        typeset (``gamma``, ``rdot``).
    size : int
        3; 2 for points of a plane, 4 for quaternions (components w, x, y, z).
    """

    def __new__(cls, name: str | Str, size: int = 3, *_: object) -> Vector:
        """Make the symbol; SymPy rebuilds expressions through here."""
        if not isinstance(size, int | sp.Integer) or size < 1:
            raise InputError(f"the size of {name} must be a positive whole number, not {size}")
        vector: Vector = sp.Basic.__new__(cls, Str(str(name)), sp.Integer(size), sp.S.One)
        return vector

    def doit(self, **_: object) -> Vector:
        """A name is evaluated already."""
        return self

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The component symbols, in order."""
        return tuple(real_symbol(f"{self.name}_{label}") for label in _LABELS[int(self.shape[0])])

    def __iter__(self) -> Iterator[sp.Symbol]:
        return iter(self.symbols)

    def _latex(self, printer: LatexPrinter) -> str:
        return formula_latex(self)


class _Tensor(sp.MatrixSymbol):
    def __new__(cls, name: str | Str, *_: object) -> Self:
        tensor: Self = sp.Basic.__new__(cls, Str(str(name)), sp.Integer(3), sp.Integer(3))
        return tensor

    def doit(self, **_: object) -> Self:
        """A name is evaluated already."""
        return self

    def _latex(self, printer: LatexPrinter) -> str:
        return formula_latex(self)


class Diagonal(_Tensor):
    """A named diagonal tensor diag(name_1, name_2, name_3)."""

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The diagonal, in order."""
        return tuple(real_symbol(f"{self.name}_{i}") for i in (1, 2, 3))

    @property
    def entries(self) -> Components:
        """The 3×3 matrix of scalars."""
        return Components(sp.diag(*self.symbols))

    @staticmethod
    def independent(matrix: sp.MatrixBase) -> tuple[Scalar, ...]:
        """The entries of `matrix` that belong to `symbols`."""
        return tuple(matrix[i, i] for i in range(3))


class Symmetric(_Tensor):
    """A named symmetric tensor with entries name_11, name_12, …, name_33."""

    _pairs = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The upper triangle, row by row."""
        return tuple(real_symbol(f"{self.name}_{i + 1}{j + 1}") for i, j in self._pairs)

    @property
    def entries(self) -> Components:
        """The 3×3 matrix of scalars."""
        table = dict(zip(self._pairs, self.symbols, strict=True))
        return Components(3, 3, lambda i, j: table[min(i, j), max(i, j)])

    @staticmethod
    def independent(matrix: sp.MatrixBase) -> tuple[Scalar, ...]:
        """The entries of `matrix` that belong to `symbols`."""
        return tuple(matrix[i, j] for i, j in Symmetric._pairs)


class Cross(MatrixExpr):
    """The vector product; build it with :func:`cross`."""

    shape = (sp.Integer(3), sp.S.One)

    def __new__(cls, left: MatrixExpr, right: MatrixExpr) -> Cross:
        """Make the node as it stands, without evaluation."""
        node: Cross = sp.Basic.__new__(cls, left, right)
        return node

    def doit(self, **_: object) -> Cross:
        """Stay as written: components are taken by :func:`to_components`."""
        return self

    def _latex(self, printer: LatexPrinter) -> str:
        return formula_latex(self)


class ScalarOfTensors(sp.Expr):
    """A scalar made of vectors or matrices, which it shows unevaluated."""

    is_commutative = True
    is_real = True
    precedence = PRECEDENCE["Atom"]

    def explicit(self) -> Scalar:
        """The components."""
        raise NotImplementedError

    def _latex(self, printer: LatexPrinter) -> str:
        return formula_latex(self)


class Dot(ScalarOfTensors):
    """The scalar product (u, v); build it with :func:`dot`."""

    def __new__(cls, left: MatrixExpr, right: MatrixExpr) -> Dot:
        """Make the node as it stands, without evaluation."""
        node: Dot = sp.Basic.__new__(cls, left, right)
        return node

    def explicit(self) -> Scalar:
        """The sum of the products of components."""
        left, right = (to_components(arg) for arg in self.args)
        return sp.Add(*(a * b for a, b in zip(left, right, strict=True)))


class Gradient(MatrixExpr):
    """∂U/∂u for a scalar `U` written in the components of the vector `u`.

    The name under which U is printed is the third argument.
    """

    shape = (sp.Integer(3), sp.S.One)

    def __new__(cls, value: Scalar, variable: Vector, name: sp.Symbol) -> Gradient:
        """Make the node as it stands, without evaluation."""
        node: Gradient = sp.Basic.__new__(cls, value, variable, name)
        return node

    def doit(self, **_: object) -> Gradient:
        """Stay as written: components are taken by :func:`to_components`."""
        return self

    def _latex(self, printer: LatexPrinter) -> str:
        return formula_latex(self)


def vectors(names: str) -> tuple[Vector, ...]:
    """Several vectors at once: ``M, gamma = vectors("M gamma")``."""
    return tuple(Vector(name) for name in names.split())


@arguments_checked
def unit_vector(axis: int) -> MatrixExpr:
    """The unit vector along body axis 1, 2 or 3; InputError for another one."""
    if axis not in (1, 2, 3):
        raise InputError(f"unit_vector: axis must be 1, 2 or 3, not {axis}")
    return constant([int(axis == i) for i in (1, 2, 3)])


@arguments_checked
def constant(values: Formulas) -> MatrixExpr:
    """A vector or matrix given by its entries (numbers or scalars).

    Raises
    ------
    InputError
        If it is a single number or formula.
    """
    if not hasattr(values, "__len__"):
        raise InputError(f"constant: the entries of a vector or matrix are needed, not {values}")
    return sp.ImmutableDenseMatrix(values)


def _parts(vector: MatrixExpr) -> list[tuple[Scalar, MatrixExpr]]:
    """A vector as a sum of scalar multiples of atoms."""
    if isinstance(vector, ZeroMatrix):
        return []
    if isinstance(vector, MatAdd):
        return [part for arg in vector.args for part in _parts(arg)]
    if isinstance(vector, MatMul):
        scalars = [arg for arg in vector.args if not getattr(arg, "is_Matrix", False)]
        factors = [arg for arg in vector.args if getattr(arg, "is_Matrix", False)]
        if len(factors) == 1 and scalars:
            return [(sp.Mul(*scalars) * c, atom) for c, atom in _parts(factors[0])]
        matrix = factors[0] if len(factors) == 1 else MatMul(*factors)
        return [(sp.Mul(*scalars), matrix)]
    return [(sp.S.One, vector)]


def _ordered_product(atom: MatrixExpr) -> tuple[int, MatrixExpr]:
    """A vector product with its factors in a fixed order, and its sign."""
    if isinstance(atom, Cross):
        left, right = atom.args
        if sp.default_sort_key(left) > sp.default_sort_key(right):
            return -1, Cross(right, left)
    return 1, atom


@arguments_checked
def cross(left: MatrixExpr, right: MatrixExpr) -> MatrixExpr:
    """Vector product, bilinear; products of parallel vectors vanish at once."""
    total: MatrixExpr = zero
    for a, u in _parts(left):
        for b, v in _parts(right):
            if _ordered_product(u)[1] != _ordered_product(v)[1]:
                total = total + (a * b) * Cross(u, v)
    return total


@arguments_checked
def dot(left: MatrixExpr, right: MatrixExpr) -> Scalar:
    """Scalar product; scalar factors are taken out."""
    if isinstance(left, ZeroMatrix) or isinstance(right, ZeroMatrix):
        return sp.S.Zero
    factor = sp.S.One
    ends = []
    for side in (left, right):
        parts = _parts(side)
        share, end = parts[0] if len(parts) == 1 else (sp.S.One, side)
        factor = factor * share
        ends.append(end)
    return factor * Dot(*ends)


@arguments_checked
def norm_squared(vector: MatrixExpr) -> Scalar:
    """The square (u, u)."""
    return dot(vector, vector)


def outer(left: MatrixExpr, right: MatrixExpr) -> MatrixExpr:
    """The dyad u ⊗ v, as the matrix u vᵀ."""
    return left * Transpose(right)


def hat(vector: MatrixExpr) -> Components:
    """The skew matrix with hat(u) v = u × v."""
    x, y, z = to_components(vector)
    return Components([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def gradient(value: Scalar, variable: Vector, name: str = "U") -> MatrixExpr:
    """∂value/∂variable, shown as ∂U/∂γ; zero when `value` does not depend on it."""
    if not to_components(value).has(*variable.symbols):
        return zero
    return Gradient(value, variable, real_symbol(name))


def to_components(expression: sp.Basic) -> sp.Basic:
    """Turn a formula into components.

    Parameters
    ----------
    expression : sympy.Expr or MatrixExpr
        A scalar or vector formula.

    Returns
    -------
    sympy.Expr or ImmutableDenseMatrix
        The same without any vector left in it; nothing is expanded.
    """
    if isinstance(expression, sp.MatrixBase):
        return Components(expression.applyfunc(to_components))
    if not isinstance(expression, sp.Basic):
        expression = _as_formula(expression)
    return _components_of(expression)


@lru_cache(maxsize=10_000)
def _components_of(expression: sp.Basic) -> sp.Basic:
    """The components of a formula; those of a system are asked for again and again."""
    if not isinstance(expression, MatrixExpr):
        # from the top down, so that products inside products are reached with their factors
        return expression.xreplace({d: d.explicit() for d in expression.atoms(ScalarOfTensors)})
    return _explicit_matrix(expression)


def _as_formula(value: object) -> sp.Basic:
    """A number as an expression.

    Raises
    ------
    InputError
        If it is no number.
    """
    try:
        return sp.sympify(value, strict=True)
    except sp.SympifyError:
        raise InputError(f"{value!r} is no formula: a SymPy expression is needed") from None


def _explicit_matrix(expression: MatrixExpr) -> Components:
    match expression:
        case Vector():
            return Components(expression.symbols)
        case Diagonal() | Symmetric():
            return expression.entries
        case Cross():
            (a, b, c), (x, y, z) = (to_components(arg) for arg in expression.args)
            return Components([b * z - c * y, c * x - a * z, a * y - b * x])
        case Gradient():
            value, variable, _ = expression.args
            return Components([sp.diff(to_components(value), s) for s in variable.symbols])
        case MatAdd():
            terms = [to_components(arg) for arg in expression.args]
            return Components(sum(terms[1:], terms[0]))
        case MatMul():
            product = sp.S.One
            # from the right, so that matrices act on vectors and dyads never appear
            for arg in reversed(expression.args):
                product = to_components(arg) * product
            return product
        case Transpose():
            return to_components(expression.arg).T
        case Inverse() | MatPow():
            matrix = to_components(expression.args[0])
            if expression.args[1] != -1:
                return Components(matrix ** expression.args[1])
            if matrix.is_diagonal():
                return Components(sp.diag(*(1 / matrix[i, i] for i in range(3))))
            return Components(matrix.adjugate() / matrix.det(method="berkowitz"))
    return Components(expression.as_explicit())
