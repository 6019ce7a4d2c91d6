"""Formulas as text that parses to the same formula; vectors and tensors stay symbolic."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp
from sympy.matrices.expressions import Identity, MatAdd, MatMul, MatrixExpr
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.str import StrPrinter

from ..arguments import Formula, arguments_checked
from ..errors import InputError
from ..system.laws import Rate
from ..system.vector_operators import Gradient
from ..system.vectors import Cross, Diagonal, Dot, Symmetric, Vector
from .exact_decimals import with_exact_decimals
from .grammar import FUNCTIONS

#: Functions by class; square roots are powers.
_WORDS: Mapping[type, str] = {
    function: name for name, function in FUNCTIONS.items() if isinstance(function, type)
}
_ZERO = "[0, 0, 0]"


class _FilePrinter(StrPrinter):
    """Printer of formulas in the language of :mod:`flowlanes.parsing`."""

    def __init__(self, definitions: Mapping[sp.Symbol, sp.Basic]) -> None:
        super().__init__()
        self.definitions = definitions

    def emptyPrinter(self, expr: object) -> str:
        """Raise InputError for a node that the language cannot express."""
        raise InputError(f"{type(expr).__name__} in a formula has no form in a file")

    def _print_Basic(self, expr: sp.Basic) -> str:
        return self.emptyPrinter(expr)

    def _print_Function(self, expr: sp.Function) -> str:
        if isinstance(expr, Rate):
            return f"Rate({self._print(expr.args[0])})"
        if type(expr) not in _WORDS:
            raise InputError(f"the function {expr.func} has no form in a file")
        return f"{_WORDS[type(expr)]}({', '.join(map(self._print, expr.args))})"

    _print_Max = _print_Min = _print_Abs = _print_sign = _print_Function  # noqa: N815
    _print_log = _print_exp = _print_Function

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        base, exponent = expr.args
        if exponent is sp.S.Half:
            return f"sqrt({self._print(base)})"
        if exponent == -sp.S.Half:
            return f"1/sqrt({self._print(base)})"
        power = PRECEDENCE["Pow"]
        if exponent is sp.S.NegativeOne:
            return f"1/{self.parenthesize(base, power, strict=False)}"
        text = self.parenthesize(exponent, power, strict=False)
        return f"{self.parenthesize(base, power, strict=False)}**{text}"

    def _print_Mul(self, expr: sp.Mul) -> str:
        """A product; its number is printed separately, so that it is not distributed over a sum."""
        factor, rest = expr.as_coeff_Mul()
        factors = [sp.Integer(abs(factor.p))] if abs(factor.p) != 1 else []
        divisors = [sp.Integer(factor.q)] if factor.q != 1 else []
        for part in sp.Mul.make_args(rest):
            base, exponent = part.as_base_exp()
            if isinstance(part, sp.Pow) and exponent.is_Rational and exponent < 0:
                divisors.append(sp.Pow(base, -exponent, evaluate=False) if exponent != -1 else base)
            else:
                factors.append(part)
        level = PRECEDENCE["Mul"]
        above = [self.parenthesize(f, level, strict=False) for f in factors] or ["1"]
        below = [self.parenthesize(d, PRECEDENCE["Pow"], strict=False) for d in divisors]
        if factor < 0:
            above = ["-1", *above] if above[0].startswith("(") else [f"-{above[0]}", *above[1:]]
        words = "*".join(above)
        if len(below) < 2 or any(isinstance(d, sp.Add) for d in divisors):
            return "/".join([words, *below])
        return f"{words}/({'*'.join(below)})"

    # --- vectors and tensors ---------------------------------------------------------------

    def _print_Vector(self, expr: Vector) -> str:
        return str(expr.name)

    _print_Diagonal = _print_Symmetric = _print_Vector  # noqa: N815

    def _print_MatrixSymbol(self, expr: sp.MatrixSymbol) -> str:
        if isinstance(expr, Vector | Diagonal | Symmetric) and type(expr).__name__ != "Column":
            return str(expr.name)
        return self.emptyPrinter(expr)

    def _print_Dot(self, expr: Dot) -> str:
        return f"dot({', '.join(map(self._print, expr.args))})"

    def _print_Cross(self, expr: Cross) -> str:
        return f"cross({', '.join(map(self._print, expr.args))})"

    def _print_ZeroMatrix(self, expr: sp.ZeroMatrix) -> str:
        return _ZERO if expr.shape == (3, 1) else self.emptyPrinter(expr)

    def _print_Identity(self, expr: Identity) -> str:
        return "identity()" if expr.shape == (3, 3) else self.emptyPrinter(expr)

    def _print_Inverse(self, expr: sp.Inverse) -> str:
        return f"{self.parenthesize(expr.arg, PRECEDENCE['Pow'], strict=False)}**-1"

    def _print_MatAdd(self, expr: MatAdd) -> str:
        text = ""
        for term in expr.args:
            printed = self.parenthesize(term, PRECEDENCE["Add"])
            text += (
                f" - {printed[1:]}"
                if printed.startswith("-") and text
                else (f" + {printed}" if text else printed)
            )
        return text

    def _print_MatMul(self, expr: MatMul) -> str:
        factor, matrices = expr.as_coeff_matrices()
        sign = ""
        if factor.could_extract_minus_sign():
            sign, factor = "-", -factor
        parts: list[str] = []
        for matrix in matrices:
            if isinstance(matrix, sp.Transpose):
                parts[-1] = f"outer({parts[-1]}, {self._print(matrix.arg)})"
            else:
                parts.append(self.parenthesize(matrix, PRECEDENCE["Mul"], strict=False))
        if factor != 1:
            parts.insert(0, self.parenthesize(factor, PRECEDENCE["Mul"], strict=False))
        return sign + "*".join(parts)

    def _print_Gradient(self, expr: Gradient) -> str:
        value, variable, name = expr.args
        if self.definitions.get(name) == value:
            return f"gradient({name}, {self._print(variable)})"
        if name != sp.Symbol("U", real=True):
            raise InputError(f"the gradient of {name}, which has no formula, has no form in a file")
        return f"gradient({self._print(value)}, {self._print(variable)})"

    def _print_MatrixBase(self, expr: sp.MatrixBase) -> str:
        if expr.cols == 1:
            return f"[{', '.join(map(self._print, expr))}]"
        if expr.shape == (3, 3) and expr.is_diagonal():
            return f"diagonal({', '.join(self._print(expr[i, i]) for i in range(3))})"
        rows = (f"[{', '.join(map(self._print, expr.row(i)))}]" for i in range(expr.rows))
        return f"[{', '.join(rows)}]"

    _print_ImmutableDenseMatrix = _print_DenseMatrix = _print_MatrixBase  # noqa: N815


@arguments_checked
def formula_text(formula: Formula, definitions: Mapping[sp.Symbol, sp.Basic] | None = None) -> str:
    """A formula as a user would type it, with exact numbers.

    Parameters
    ----------
    formula : sympy.Expr or MatrixExpr
    definitions : mapping of Symbol to formula, optional
        Named formulas, of which a gradient may be taken.

    Raises
    ------
    InputError
        If an argument has another type, a number is not finite, or a part of the formula, such as
        an unspecified function, cannot be written in a file.

    Examples
    --------
    >>> from flowlanes.system.vectors import Diagonal, Vector, cross
    >>> formula_text(cross(Diagonal("I") * Vector("w"), Vector("w")))
    'cross(I*w, w)'
    """
    value: Any = sp.sympify(formula)
    if value.has(sp.zoo, sp.nan, sp.oo, -sp.oo):
        raise InputError(f"{value} has a value that is not finite")
    if not isinstance(value, MatrixExpr):
        value = with_exact_decimals(value)
    return str(_FilePrinter(definitions or {}).doprint(value))
