"""Formulas as straight-line programs for numbers of any kind.

With balls, a program encloses the exact value: its constants are exact and are rounded to balls of
the working precision during the computation, and the result is not finite where there is no value.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import sympy as sp
from flint import acb, arb, fmpq

from ..errors import InputError
from ..parsing.exact_decimals import exact_number
from ..system.named_formulas import needed_steps
from .evaluation import Evaluation

#: Named intermediate quantities, in order.
Steps = tuple[tuple[sp.Symbol, sp.Expr], ...]

#: Entire functions: analytic at every complex number.
ENTIRE = ("sin", "cos", "exp")
#: Functions of real balls, by their SymPy names.
REAL = (
    *ENTIRE,
    "tan",
    "sinh",
    "cosh",
    "tanh",
    "log",
    "asin",
    "acos",
    "atan",
    "atan2",
    "Abs",
    "sign",
    "Pow",
)

ZERO = fmpq(0)
_ALGEBRAIC = "neither a sum, a product nor a root, and without a value"


class Operation(NamedTuple):
    """One step of a program.

    Attributes
    ----------
    kind : str
        ``"constant"``, ``"sum"``, ``"product"``, ``"root"`` (the square root), ``"inverse"`` or
        the name of a function.
    operands : tuple of int
        Indices of the operands in the list of arguments and then results.
    number : fmpq
        Value of a constant.
    """

    kind: str
    operands: tuple[int, ...] = ()
    number: fmpq = ZERO


class BallArithmetic:
    """Arithmetic of real balls, complex balls and similar numbers.

    A root of a complex ball is the principal value, also across its branch cut.
    """

    def constant(self, number: fmpq) -> Any:
        """Rational number as a ball."""
        return arb(number)

    def root(self, x: Any) -> Any:
        """The square root."""
        return x.sqrt()

    def inverse(self, x: Any, index: int) -> Any:
        """Reciprocal of x, the result with this index in the program."""
        return 1 / x

    def function(self, name: str, arguments: Sequence[Any]) -> Any:
        """A function of :data:`REAL`, or π."""
        if name == "Pi":
            return arb.pi()
        if name == "Abs":
            return abs(arguments[0])
        if name == "sign":
            return arguments[0].sgn()
        if name == "Pow":
            return arguments[0] ** arguments[1]
        return getattr(type(arguments[0]), name)(*arguments)


class AnalyticArithmetic(BallArithmetic):
    """Arithmetic of complex balls in which a root is not finite if it may meet its branch cut."""

    def root(self, x: Any) -> Any:
        """Square root, where it is analytic."""
        return x.sqrt(analytic=True) if isinstance(x, acb) else x.sqrt()


class FieldArithmetic(BallArithmetic):
    """Arithmetic of the field of the number `one`; it has no roots."""

    def __init__(self, one: Any) -> None:
        self.one = one

    def constant(self, number: fmpq) -> Any:
        """A rational number."""
        return self.one * int(number.p) / int(number.q)


BALLS = BallArithmetic()
ANALYTIC = AnalyticArithmetic()


class StraightLineProgram(Evaluation[int]):
    """Scalar formulas as a list of operations, each on arguments and earlier results.

    Parameters
    ----------
    names : sequence of Symbol
        Arguments of the program.
    formulas : sequence of sympy.Expr
        Sums, products, powers and the functions below.
    steps : tuple of (Symbol, sympy.Expr), optional
        Intermediate quantities used in the formulas, in order.
    functions : sequence of str, optional
        Allowed functions, by their SymPy names.

    Raises
    ------
    InputError
        If another function occurs, or a symbol without a value.
    """

    def __init__(
        self,
        names: Sequence[sp.Symbol],
        formulas: Sequence[sp.Expr],
        steps: Steps = (),
        functions: Sequence[str] = (),
    ) -> None:
        super().__init__({name: index for index, name in enumerate(names)})
        self.operations: list[Operation] = []
        self._arguments = len(names)
        self._functions = functions
        self.define(needed_steps(steps, formulas))
        self.results = [self(sp.sympify(formula)) for formula in formulas]

    def run(self, arguments: Sequence[Any], arithmetic: BallArithmetic = BALLS) -> list[Any]:
        """Values of the formulas.

        Parameters
        ----------
        arguments : sequence of numbers
            One number for each name.
        arithmetic : BallArithmetic
            Constants, roots, reciprocals and functions; sums and products are those of the
            numbers.
        """
        values = list(arguments)
        for kind, operands, number in self.operations:
            if kind == "constant":
                value = arithmetic.constant(number)
            elif kind == "sum":
                value = values[operands[0]]
                for index in operands[1:]:
                    value = value + values[index]
            elif kind == "product":
                value = values[operands[0]]
                for index in operands[1:]:
                    value = value * values[index]
            elif kind == "root":
                value = arithmetic.root(values[operands[0]])
            elif kind == "inverse":
                value = arithmetic.inverse(values[operands[0]], len(values))
            else:
                value = arithmetic.function(kind, [values[index] for index in operands])
            values.append(value)
        return [values[index] for index in self.results]

    # --- from formulas to operations -----------------------------------------------------------

    def _operation(self, kind: str, *operands: int, number: fmpq = ZERO) -> int:
        """Append an operation; the index of its result is returned."""
        self.operations.append(Operation(kind, operands, number))
        return self._arguments + len(self.operations) - 1

    def _constant(self, number: sp.Expr) -> int:
        exact = exact_number(number)
        return self._operation("constant", number=fmpq(int(exact.p), int(exact.q)))

    def _symbol(self, symbol: sp.Symbol) -> int:
        raise InputError(f"{symbol}: {_ALGEBRAIC}")

    def _sum(self, formula: sp.Add) -> int:
        return self._operation("sum", *self._parts(formula))

    def _product(self, formula: sp.Mul) -> int:
        return self._operation("product", *self._parts(formula))

    def _power(self, formula: sp.Pow) -> int:
        exponent = formula.exp
        if exponent.is_Rational and exponent.q in (1, 2):
            base = self(formula.base)
            if exponent.q == 2:
                base = self._operation("root", base)
            # python-flint has no power of a ball around zero, but it has products.
            count = abs(int(exponent.p))
            power = self._operation("product", *[base] * count) if count > 1 else base
            return power if exponent > 0 else self._operation("inverse", power)
        return self._function(formula)

    def _function(self, formula: sp.Expr) -> int:
        name = type(formula).__name__
        if formula is sp.E and "exp" in self._functions:
            return self._operation("exp", self(sp.S.One))
        if formula is sp.pi or name in self._functions:
            return self._operation(name, *self._parts(formula))
        if not self._functions:
            raise InputError(f"{formula}: {_ALGEBRAIC}")
        *others, last = ("sums", "products", "roots", *self._functions)
        raise InputError(
            f"{formula}: closed forms are computed of {', '.join(others)} and {last} alone"
        )
