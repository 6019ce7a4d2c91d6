"""Formulas in print notation, in Unicode and in LaTeX, by one set of rules.

A :class:`_Writer` traverses a formula and decides on brackets and fraction lines;
:mod:`flowlanes.printing.ordering` determines the order of terms and factors, and
:mod:`flowlanes.printing.notation` the notation of each part.
"""

from __future__ import annotations

import unicodedata
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TypeAlias

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
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

from ..system.laws import Rate
from ..system.matrices import Blocks, Image, Jacobian, MatrixProduct, Pfaffian
from ..system.vector_operators import Gradient
from ..system.vectors import Cross, Dot
from .notation import LATEX, UNICODE, Fragment, Notation, Precedence
from .ordering import (
    Factors,
    as_unit_vector_multiple,
    common_fraction,
    factors_of,
    is_negative,
    sort_terms,
    vector_of,
)
from .symbol_names import SymbolName, letter_of

#: Values that SymPy converts to a formula.
Formula: TypeAlias = sp.Basic | float

_FUNCTION_NAMES = {"asin": "arcsin", "acos": "arccos", "atan": "arctan"}


def text(formula: Formula) -> str:
    """A formula in one line of Unicode, such as ``A M + m (A r, M) A r / 2``.

    Parameters
    ----------
    formula : sympy.Expr, MatrixExpr or number
        A scalar or vector formula, a tensor, or a relation between scalars.

    Returns
    -------
    str
        ``×`` is the vector product, ``(u, v)`` the scalar product, ``u²`` the square (u, u),
        ``u ⊗ v`` the dyad, ``E`` the unit tensor and ``∂U/∂u`` a gradient.
    """
    return _Writer(UNICODE).piece(sp.sympify(formula)).text


def latex(formula: Formula) -> str:
    r"""A formula in LaTeX (math mode), by the same rules as :func:`text`.

    Vectors and tensors are bold: ``\mathbf{M} \times \boldsymbol{\theta}``.
    """
    return _Writer(LATEX).piece(sp.sympify(formula)).text


def rate(name: sp.Basic, notation: Notation) -> str:
    """The time derivative of a named vector or scalar: ``ẋ``."""
    letter = letter_of(str(name)).rate()
    return notation.letter(letter, bold=not isinstance(name, sp.Symbol)).text


def signed_terms(formula: Formula, notation: Notation) -> list[tuple[str, str]]:
    """The terms of a sum in order, each with its sign (``""`` for a leading plus)."""
    writer = _Writer(notation)
    terms = []
    for index, (negative, piece) in enumerate(writer.terms(sp.sympify(formula))):
        plus = "+" if index else ""
        terms.append(
            (notation.minus if negative else plus, notation.guard(piece, Precedence.RATIO))
        )
    return terms


def width(line: str) -> int:
    """The number of terminal columns of `line`; combining accents take none."""
    return sum(not unicodedata.combining(character) for character in line)


@dataclass(frozen=True)
class _Writer:
    """Writer of formulas in a notation."""

    notation: Notation

    def piece(self, formula: sp.Basic) -> Fragment:
        """A formula of any kind."""
        terms = self.terms(formula)
        if len(terms) == 1 and not terms[0][0]:
            return terms[0][1]
        written = ""
        for negative, term in terms:
            body = self.notation.guard(term, Precedence.RATIO)
            if written:
                written += f" {self.notation.minus if negative else '+'} {body}"
            else:
                written = (self.notation.minus if negative else "") + body
        return Fragment(written, Precedence.SUM)

    def terms(self, formula: sp.Basic) -> list[tuple[bool, Fragment]]:
        """The terms of a sum in order, each with its sign; other formulas are a single term."""
        share = common_fraction(formula)
        if share != 1:
            remainder = sp.Add(*(term / share for term in formula.args))
            return [self._product(factors_of(sp.Mul(share, remainder, evaluate=False)))]
        if isinstance(formula, (sp.Add, MatAdd)):
            return [
                self._term(term) for term in sort_terms(map(as_unit_vector_multiple, formula.args))
            ]
        return [self._term(as_unit_vector_multiple(formula))]

    def _term(self, formula: sp.Basic) -> tuple[bool, Fragment]:
        if isinstance(formula, (sp.Add, MatAdd)):
            return False, self.piece(formula)
        if isinstance(formula, sp.Float):
            return formula < 0, self.notation.number(abs(formula))
        if isinstance(formula, (sp.Mul, MatMul, sp.Rational)) or (
            isinstance(formula, sp.Pow) and is_negative(formula.exp)
        ):
            return self._product(factors_of(formula))
        return False, self._indivisible(formula)

    def _product(self, factors: Factors) -> tuple[bool, Fragment]:
        above = [self.piece(factor) for factor in factors.above]
        below = [self.piece(factor) for factor in factors.below]
        vector = self._chain(factors.tensors) if factors.tensors else None
        if factors.coefficient == (1, 1) and not below:
            if vector and not above:
                return factors.negative, vector
            if len(above) == 1 and not vector:
                return factors.negative, above[0]
        if factors.coefficient[1] == 1 and not (above or below or vector):
            return factors.negative, Fragment(str(factors.coefficient[0]))
        written = self.notation.product(factors.coefficient, above, below, vector)
        return factors.negative, written

    def _chain(self, tensors: Sequence[MatrixExpr]) -> Fragment:
        """Tensors and vectors in juxtaposition; u ⊗ v for a column times a row."""
        for index, tensor in enumerate(tensors):
            if index and isinstance(tensor, Transpose) and tensor.arg.shape[1] == 1:
                left = self._chain(tensors[:index])
                right = self.piece(tensor.arg)
                guard = self.notation.guard
                dyad = self.notation.dyad.join(guard(x, Precedence.PRODUCT) for x in (left, right))
                piece = Fragment(dyad, Precedence.CROSS)
                following = tensors[index + 1 :]
                return (
                    piece if not following else self._juxtaposition(piece, self._chain(following))
                )
        pieces = [self.piece(tensor) for tensor in tensors]
        return pieces[0] if len(pieces) == 1 else self._juxtaposition(*pieces)

    def _juxtaposition(self, *pieces: Fragment) -> Fragment:
        return Fragment(
            " ".join(self.notation.guard(piece, Precedence.PRODUCT) for piece in pieces),
            Precedence.PRODUCT,
        )

    def _indivisible(self, formula: sp.Basic) -> Fragment:
        """A formula that is neither a sum nor a product."""
        if isinstance(formula, (MatrixExpr, sp.MatrixBase)):
            return self._tensor(formula)
        notation = self.notation
        match formula:
            case sp.Symbol():
                return notation.letter(letter_of(str(formula)), bold=False)
            case Dot():
                return self._dot(formula, 1)
            case MatrixProduct():
                return self._matrix_product(formula)
            case Pfaffian():
                return notation.call("Pf", [self.piece(formula.args[0]).text])
            case Jacobian():
                image, argument = (self.piece(part).text for part in formula.args[:2])
                return notation.call("det", [notation.gradient(image, argument).text])
            case sp.Pow():
                return self._power(formula)
            case sp.Abs():
                return notation.norm(self.piece(formula.args[0]).text)
            case Rate():
                return self._rate(formula)
            case sp.Derivative():
                return self._derivative(formula)
            case sp.Function():
                return self._function(formula, 1)
            case Relational():
                sides = (self.piece(side).text for side in formula.args)
                return Fragment(
                    f" {notation.relations[formula.rel_op]} ".join(sides), Precedence.SUM
                )
            case sp.And() | sp.Or():
                parts = sorted(self.piece(part).text for part in formula.args)
                return Fragment(notation.connectives[formula.func].join(parts), Precedence.SUM)
        if formula in notation.constants:
            return Fragment(notation.constants[formula])
        return Fragment(notation.fallback(formula), Precedence.SUM)

    def _dot(self, product: Dot, exponent: int) -> Fragment:
        """(u, v); u² or a power of it for (u, u)."""
        left, right = product.args
        if left == right:
            return self.notation.power(self.piece(left), str(2 * exponent))
        inside = ", ".join(self.piece(side).text for side in product.args)
        pair = Fragment(self.notation.brackets(inside))
        return pair if exponent == 1 else self.notation.power(pair, str(exponent))

    def _matrix_product(self, product: MatrixProduct) -> Fragment:
        """(A, B); |A|² for (A, A)."""
        left, right = (self.piece(side).text for side in product.args)
        if left == right:
            return self.notation.power(self.notation.norm(left), "2")
        return Fragment(self.notation.brackets(f"{left}, {right}"))

    def _power(self, formula: sp.Pow) -> Fragment:
        base, exponent = formula.args
        whole = exponent.is_Integer
        if isinstance(base, Dot) and whole:
            return self._dot(base, int(exponent))
        if isinstance(base, Dot) and base.args[0] == base.args[1] and (2 * exponent).is_Integer:
            length = self.notation.norm(self.piece(base.args[0]).text)
            odd = int(2 * exponent)
            return length if odd == 1 else self.notation.power(length, str(odd))
        if exponent == sp.S.Half:
            return self.notation.root(self.piece(base))
        if isinstance(base, sp.Function) and not isinstance(base, (sp.Abs, Rate)) and whole:
            return self._function(base, int(exponent))
        written = f"{exponent.p}/{exponent.q}" if exponent.is_Rational else None
        if whole:
            written = str(exponent)
        return self.notation.power(self.piece(base), written or self.piece(exponent).text)

    def _function(self, formula: sp.Function, exponent: int) -> Fragment:
        name = str(formula.func.__name__)
        if isinstance(formula, AppliedUndef):
            head = self.notation.letter(letter_of(name), bold=False).text
            written = f"{head}{self.notation.brackets(self._arguments(formula))}"
            piece = Fragment(written, Precedence.ATOM)
            return piece if exponent == 1 else self.notation.power(piece, str(exponent))
        arguments = [self.piece(argument).text for argument in formula.args]
        return self.notation.call(_FUNCTION_NAMES.get(name, name), arguments, exponent)

    def _rate(self, formula: sp.Basic) -> Fragment:
        """ẋ for a letter, d(…)/dt for other formulas."""
        inner, times = formula, 0
        while isinstance(inner, Rate):
            inner, times = inner.args[0], times + 1
        if isinstance(inner, sp.Symbol) and times <= 2:
            letter = letter_of(str(inner))
            for _ in range(times):
                letter = letter.rate()
            return self.notation.letter(letter, bold=False)
        below = self.notation.power(Fragment("dt"), str(times)).text if times > 1 else "dt"
        above = self.notation.power(Fragment("d"), str(times)).text if times > 1 else "d"
        shown = self.notation.guard(self.piece(inner), Precedence.ATOM)
        return self.notation.quotient(f"{above} {shown}", below)

    def _derivative(self, formula: sp.Derivative) -> Fragment:
        """U′(x), U″(x) or ∂U/∂u₁ of an unspecified function."""
        inner, order = formula.expr, sum(count for _, count in formula.variable_count)
        name = self.notation.letter(letter_of(str(inner.func.__name__)), bold=False).text
        if len(inner.args) == 1 and order <= 3:
            letter = replace(letter_of(str(inner.func.__name__)), primes=order)
            head = self.notation.letter(letter, bold=False).text
            return Fragment(
                f"{head}{self.notation.brackets(self._arguments(inner))}", Precedence.POWER
            )
        below = " ".join(
            self.notation.partial(self.piece(s).text, int(count))
            for s, count in formula.variable_count
        )
        return self.notation.quotient(self.notation.partial(name, order, above=True), below)

    def _arguments(self, formula: sp.Function) -> str:
        """Arguments of a function, with the components of a vector abbreviated to its name."""
        listed = list(formula.args)
        shown = []
        while listed:
            whole = vector_of(listed[:3])
            shown.append(self.piece(whole if whole is not None else listed[0]).text)
            listed = listed[3:] if whole is not None else listed[1:]
        return ", ".join(shown)

    def _tensor(self, formula: MatrixExpr | sp.MatrixBase) -> Fragment:
        """A vector or tensor that is neither a sum nor a product."""
        notation = self.notation
        match formula:
            case sp.MatrixSymbol():
                return notation.letter(letter_of(formula.name), bold=True)
            case Image():
                operator, argument, _ = formula.args
                head = notation.letter(letter_of(str(operator)), bold=True).text
                return Fragment(f"{head}{notation.brackets(self.piece(argument).text)}")
            case Blocks():
                return notation.matrix(
                    [[self.piece(block).text for block in row] for row in formula.rows_of_blocks]
                )
            case Identity():
                return notation.letter(SymbolName("E"), bold=True)
            case ZeroMatrix():
                return Fragment("0")
            case Cross():
                sides = (notation.guard(self.piece(x), Precedence.PRODUCT) for x in formula.args)
                return Fragment(notation.cross.join(sides), Precedence.CROSS)
            case Gradient():
                _, variable, name = formula.args
                return notation.gradient(self.piece(name).text, self.piece(variable).text)
            case Transpose():
                return notation.transpose(self.piece(formula.arg))
            case Inverse() | MatPow():
                base, exponent = formula.args
                minus = notation.minus if exponent < 0 else ""
                return notation.power(self.piece(base), f"{minus}{abs(exponent)}")
            case sp.MatrixBase():
                return self._components(formula)
        return Fragment(notation.fallback(formula), Precedence.SUM)

    def _components(self, matrix: sp.MatrixBase) -> Fragment:
        """A vector or tensor given by its entries."""
        rows, columns = matrix.shape
        entries = list(matrix)
        if columns == 1 and 1 in entries and entries.count(0) == rows - 1:
            return self.notation.letter(letter_of(f"e_{entries.index(1) + 1}"), bold=True)
        if columns > 1 and matrix.is_diagonal():
            diagonal = [self.piece(matrix[i, i]).text for i in range(rows)]
            return self.notation.call("diag", diagonal)
        written = [[self.piece(matrix[i, j]).text for j in range(columns)] for i in range(rows)]
        return self.notation.matrix(written)
