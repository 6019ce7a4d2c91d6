"""Symbolic 3-vectors, and their components.

A vector is a SymPy matrix expression of shape (3, 1).  Formulas built from
:func:`dot`, :func:`cross` and ``outer`` keep their vector form, so that they print as
``M×ω + m ṙ×(ω×r)``; :func:`to_components` turns the same formula into three scalars.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from typing import ClassVar, Self, TypeAlias

import sympy as sp
from sympy.core.symbol import Str
from sympy.matrices.expressions import MatAdd, MatMul, MatrixExpr, ZeroMatrix
from sympy.printing.latex import LatexPrinter
from sympy.printing.precedence import PRECEDENCE

from ..arguments import Formulas, arguments_checked
from ..errors import InputError
from .display import formula_latex

Scalar: TypeAlias = sp.Expr
Components: TypeAlias = sp.ImmutableDenseMatrix
_LABELS = {2: ("x", "y"), 3: ("1", "2", "3"), 4: ("w", "x", "y", "z")}

zero: MatrixExpr = ZeroMatrix(3, 1)
identity: MatrixExpr = sp.Identity(3)


@arguments_checked
def real_symbol(name: str) -> sp.Symbol:
    """A real scalar symbol, the only kind used in this package.

    Parameters
    ----------
    name : str

    Returns
    -------
    sympy.Symbol

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> real_symbol("k").is_real
    True
    """
    return sp.Symbol(name, real=True)


class Node:
    """A node that stays as written until :func:`to_components` takes its components."""

    def doit(self, **_: object) -> Self:
        """Itself."""
        return self

    def _latex(self, printer: LatexPrinter) -> str:
        return formula_latex(self)


class Vector(Node, sp.MatrixSymbol):
    """A named vector with the components ``name_1``, ``name_2``, ``name_3``.

    Parameters
    ----------
    name : str
        Name as spelt in code; Greek names and the endings ``dot`` and ``tilde`` are
        typeset (``gamma``, ``rdot``).
    size : int
        3; 2 for points of a plane, 4 for quaternions (components w, x, y, z).

    Raises
    ------
    InputError
        If the size is not a positive whole number.

    Examples
    --------
    >>> Vector("gamma").symbols, Vector("q", 4).symbols
    ((gamma_1, gamma_2, gamma_3), (q_w, q_x, q_y, q_z))
    """

    def __new__(cls, name: str | Str, size: int = 3, *_: object) -> Vector:
        """Make the symbol; SymPy rebuilds expressions through here."""
        if not isinstance(size, int | sp.Integer) or size < 1:
            raise InputError(f"the size of {name} must be a positive whole number, not {size}")
        vector: Vector = sp.Basic.__new__(cls, Str(str(name)), sp.Integer(size), sp.S.One)
        return vector

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The component symbols, in order."""
        return tuple(real_symbol(f"{self.name}_{label}") for label in _LABELS[int(self.shape[0])])

    @property
    def entries(self) -> Components:
        """The components as a matrix of one column."""
        return Components(self.symbols)

    def __iter__(self) -> Iterator[sp.Symbol]:
        return iter(self.symbols)


class _Tensor(Node, sp.MatrixSymbol):
    _labels: ClassVar[tuple[str, ...]]
    _pairs: ClassVar[tuple[tuple[int, int], ...]]

    def __new__(cls, name: str | Str, *_: object) -> Self:
        tensor: Self = sp.Basic.__new__(cls, Str(str(name)), sp.Integer(3), sp.Integer(3))
        return tensor

    @property
    def symbols(self) -> tuple[sp.Symbol, ...]:
        """The independent entries, row by row."""
        return tuple(real_symbol(f"{self.name}_{label}") for label in self._labels)

    @property
    def entries(self) -> Components:
        """The 3×3 matrix of scalars."""
        table = dict(zip(self._pairs, self.symbols, strict=True))
        return Components(3, 3, lambda i, j: table.get((min(i, j), max(i, j)), 0))

    @classmethod
    def independent(cls, matrix: sp.MatrixBase) -> tuple[Scalar, ...]:
        """The entries of `matrix` that belong to `symbols`."""
        return tuple(matrix[i, j] for i, j in cls._pairs)


class Diagonal(_Tensor):
    """A named diagonal tensor diag(name_1, name_2, name_3).

    Parameters
    ----------
    name : str

    Examples
    --------
    >>> to_components(Diagonal("I") * Vector("omega")).T
    Matrix([[I_1*omega_1, I_2*omega_2, I_3*omega_3]])
    """

    _labels = ("1", "2", "3")
    _pairs = ((0, 0), (1, 1), (2, 2))


class Symmetric(_Tensor):
    """A named symmetric tensor with entries name_11, name_12, …, name_33."""

    _labels = ("11", "12", "13", "22", "23", "33")
    _pairs = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2))


class Cross(Node, MatrixExpr):
    """The vector product; build it with :func:`cross`."""

    shape = (sp.Integer(3), sp.S.One)


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

    def explicit(self) -> Scalar:
        """The sum of the products of components."""
        left, right = (to_components(arg) for arg in self.args)
        return sp.Add(*(a * b for a, b in zip(left, right, strict=True)))


def vectors(names: str) -> tuple[Vector, ...]:
    """Several vectors at once: ``M, gamma = vectors("M gamma")``."""
    return tuple(Vector(name) for name in names.split())


@arguments_checked
def constant(values: Formulas) -> MatrixExpr:
    """A vector or matrix given by its entries.

    Parameters
    ----------
    values : sequence of n scalars, or of n rows
        Numbers or formulas; all components in the same frame.

    Returns
    -------
    MatrixExpr (n, 1) or (n, m)

    Raises
    ------
    InputError
        If it is a single number or formula.

    Examples
    --------
    >>> to_components(dot(constant([1, 2, real_symbol("k")]), Vector("M")))
    M_1 + 2*M_2 + M_3*k
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


def _ordered_product(atom: MatrixExpr) -> MatrixExpr:
    """A vector product with its factors in a fixed order, whatever its sign."""
    return Cross(*sorted(atom.args, key=sp.default_sort_key)) if isinstance(atom, Cross) else atom


@arguments_checked
def cross(left: MatrixExpr, right: MatrixExpr) -> MatrixExpr:
    """The vector product u × v, with sums and scalar factors taken out.

    Parameters
    ----------
    left, right : MatrixExpr (3, 1)
        u and v, with components in the same right-handed frame.

    Returns
    -------
    MatrixExpr (3, 1)
        The product of parallel vectors is zero at once.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> M, omega = Vector("M"), Vector("omega")
    >>> cross(M, omega), cross(M, 2 * M)
    (Cross(M, omega), 0)
    """
    total: MatrixExpr = zero
    for a, u in _parts(left):
        for b, v in _parts(right):
            if _ordered_product(u) != _ordered_product(v):
                total = total + (a * b) * Cross(u, v)
    return total


@arguments_checked
def dot(left: MatrixExpr, right: MatrixExpr) -> Scalar:
    """The scalar product (u, v), with scalar factors taken out.

    Parameters
    ----------
    left, right : MatrixExpr (n, 1)
        u and v, with components in the same frame.

    Returns
    -------
    sympy.Expr

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> dot(2 * Vector("M"), Vector("omega"))
    2*Dot(M, omega)
    """
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
    """The square (u, u).

    Parameters
    ----------
    vector : MatrixExpr (n, 1)

    Returns
    -------
    sympy.Expr

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> to_components(norm_squared(Vector("gamma")))
    gamma_1**2 + gamma_2**2 + gamma_3**2
    """
    return dot(vector, vector)


def to_components(expression: sp.Basic) -> sp.Basic:
    """A formula in components.

    Parameters
    ----------
    expression : sympy.Expr or MatrixExpr
        A scalar or vector formula.

    Returns
    -------
    sympy.Expr or ImmutableDenseMatrix
        The same without any vector left in it; nothing is expanded.

    Raises
    ------
    InputError
        If it is not a formula.

    Examples
    --------
    >>> to_components(dot(Vector("M"), Diagonal("I") * Vector("omega")))
    I_1*M_1*omega_1 + I_2*M_2*omega_2 + I_3*M_3*omega_3
    """
    if isinstance(expression, sp.MatrixBase):
        return Components(expression.applyfunc(to_components))
    try:
        expression = sp.sympify(expression, strict=True)
    except sp.SympifyError:
        raise InputError(f"{expression!r} is no formula: a SymPy expression is needed") from None
    return _components_of(expression)


@lru_cache(maxsize=10_000)
def _components_of(expression: sp.Basic) -> sp.Basic:
    """The components of a formula; those of a system are asked for again and again."""
    if not isinstance(expression, MatrixExpr):
        # from the top down, so that products inside products are reached with their factors
        return expression.xreplace({d: d.explicit() for d in expression.atoms(ScalarOfTensors)})
    return _explicit_matrix(expression)


def _explicit_matrix(expression: MatrixExpr) -> Components:
    match expression:
        case Vector() | Diagonal() | Symmetric():
            return expression.entries
        case Cross():
            (a, b, c), (x, y, z) = (to_components(arg) for arg in expression.args)
            return Components([b * z - c * y, c * x - a * z, a * y - b * x])
        case MatAdd():
            terms = [to_components(arg) for arg in expression.args]
            return Components(sum(terms[1:], terms[0]))
        case MatMul():
            product = sp.S.One
            # from the right, so that matrices act on vectors and dyads never appear
            for arg in reversed(expression.args):
                product = to_components(arg) * product
            return product
        case sp.Transpose():
            return to_components(expression.arg).T
        case sp.Inverse() | sp.MatPow():
            matrix = to_components(expression.args[0])
            if expression.args[1] != -1:
                return Components(matrix ** expression.args[1])
            if matrix.is_diagonal():
                return Components(sp.diag(*(1 / matrix[i, i] for i in range(3))))
            return Components(matrix.adjugate() / matrix.det(method="berkowitz"))
    return Components(expression.as_explicit())
