"""Formulas evaluated in numbers: balls (python-flint) and arrays (NumPy)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeAlias

import mpmath
import numpy as np
import sympy as sp
from flint import acb, arb, fmpq
from sympy.printing.pycode import PythonCodePrinter

from ..core.vectors import to_components

__all__ = [
    "Steps",
    "Values",
    "array_function",
    "ball",
    "ball_function",
    "components",
    "evaluated",
    "exact",
    "needed",
    "number",
]

#: Numbers by the symbol that names them.
Values: TypeAlias = Mapping[sp.Symbol, Any]
#: Named intermediate quantities, in order.
Steps: TypeAlias = tuple[tuple[sp.Symbol, sp.Expr], ...]


def ball(value: Any) -> Any:
    """A number as a ball: doubles as the decimals that they are written as, the rest exactly.

    Parameters
    ----------
    value : float, int, Fraction, str, sympy number, mpmath number or flint.arb
    """
    if isinstance(value, arb | acb):
        return value
    if isinstance(value, Fraction):
        return arb(fmpq(value.numerator, value.denominator))
    if isinstance(value, sp.Rational):
        return arb(fmpq(int(value.p), int(value.q)))
    if isinstance(value, int | np.integer):
        return arb(int(value))
    if isinstance(value, mpmath.mpf):
        # any arithmetic would round to mpmath's own precision
        sign, mantissa, exponent, _ = value._mpf_
        return (-1) ** int(sign) * arb(int(mantissa)) * arb(2) ** int(exponent)
    return arb(str(float(value)) if isinstance(value, np.floating) else str(value))


def exact(value: Any) -> Fraction:
    """A number as a fraction: the decimal that a double is written as, the middle of a ball."""
    if isinstance(value, arb):
        mantissa, exponent = value.mid().man_exp()
        return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    if isinstance(value, mpmath.mpf):
        sign, mantissa, exponent, _ = value._mpf_
        return Fraction((-1) ** sign * int(mantissa)) * Fraction(2) ** int(exponent)
    if isinstance(value, sp.Rational):
        return Fraction(int(value.p), int(value.q))
    return value if isinstance(value, Fraction) else Fraction(str(value))


def number(value: Any) -> float:
    """The double nearest to the middle of a ball."""
    return float(value.mid()) if isinstance(value, arb) else float(value)


def components(formula: Any) -> tuple[sp.Expr, ...]:
    """A scalar or vector formula as scalar formulas."""
    value = to_components(sp.sympify(formula))
    return tuple(value) if isinstance(value, sp.MatrixBase) else (value,)


def evaluated(formulas: Iterable[Any], values: Values) -> tuple[Any, ...]:
    """Scalar formulas in balls.

    Parameters
    ----------
    formulas : iterable of sympy.Expr
    values : mapping of Symbol to arb or acb

    Returns
    -------
    tuple of arb or acb
        Not finite where a formula has no value.
    """
    wanted = tuple(sp.sympify(formula) for formula in formulas)
    used = set[Any]().union(*(formula.free_symbols for formula in wanted))
    names = tuple(sorted(used, key=str))
    function = ball_function(names, wanted)
    return function(*(values[name] for name in names))


class _BallPrinter(PythonCodePrinter):
    """Formulas as Python code for balls: fractions exact, roots as square roots."""

    def _print_Rational(self, expr: Any) -> str:
        return f"_fraction({expr.p}, {expr.q})"

    def _print_Float(self, expr: Any) -> str:
        return f"_float({float(expr)!r})"

    def _print_Pow(self, expr: Any, **settings: Any) -> str:
        # a whole number would stay a Python number, without a root
        whole = expr.base.is_Integer
        base = f"_fraction({expr.base}, 1)" if whole else f"({self._print(expr.base)})"
        exponent = expr.exp
        if exponent.is_Integer:
            # a whole power of a ball that contains zero is none; a product is
            product = "*".join([base] * abs(int(exponent)))
            return f"({product})" if exponent > 0 else f"(1/({product}))"
        if exponent.is_Rational and exponent.q == 2:
            root = "*".join([f"{base}.sqrt()"] * abs(int(exponent.p)))
            return f"({root})" if exponent > 0 else f"(1/({root}))"
        return f"{base}**{self._print(exponent)}"

    def _print_Abs(self, expr: Any) -> str:
        return f"abs({self._print(expr.args[0])})"


@lru_cache(maxsize=512)
def ball_function(
    names: tuple[sp.Symbol, ...], formulas: tuple[sp.Expr, ...], steps: Steps = ()
) -> Callable[..., tuple[Any, ...]]:
    """Scalar formulas as a function of balls.

    Parameters
    ----------
    names : tuple of Symbol
        The arguments.
    formulas : tuple of sympy.Expr
    steps : tuple of (Symbol, sympy.Expr), optional
        Intermediate quantities that the formulas use, in order.
    """
    made = sp.lambdify(
        names,
        tuple(formulas),
        [{"_fraction": lambda p, q: arb(fmpq(p, q)), "_float": arb}],
        printer=_BallPrinter({"fully_qualified_modules": False, "user_functions": {}}),
        cse=lambda expressions: (list(steps), list(expressions)) if steps else _shared(expressions),
    )

    def function(*values: Any) -> tuple[Any, ...]:
        # a constant formula prints as a Python number
        return tuple(ball(value) for value in made(*values))

    return function


def _shared(expressions: Any) -> Any:
    return sp.cse(expressions, list=False)


def array_function(
    names: Sequence[sp.Symbol], formulas: Sequence[sp.Expr], steps: Steps = ()
) -> Callable[..., tuple[Any, ...]]:
    """The same as a function of NumPy arrays."""
    made = sp.lambdify(
        tuple(names),
        tuple(formulas),
        "numpy",
        cse=lambda expressions: (list(steps), list(expressions)) if steps else _shared(expressions),
    )

    def function(*arrays: Any) -> tuple[Any, ...]:
        return tuple(made(*arrays))

    return function


def needed(steps: Steps, formulas: Iterable[sp.Expr]) -> Steps:
    """Those steps alone on which the formulas depend."""
    wanted = set[Any]().union(*(formula.free_symbols for formula in formulas))
    kept = []
    for name, formula in reversed(steps):
        if name in wanted:
            kept.append((name, formula))
            wanted |= formula.free_symbols
    return tuple(reversed(kept))
