"""Formulas evaluated in balls (python-flint) and arrays (NumPy)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any, SupportsFloat, TypeAlias

import mpmath
import numpy as np
import sympy as sp
from flint import acb, arb, fmpq

from ..arguments import arguments_checked
from ..errors import InputError
from ..system.named_formulas import scalars
from .straight_line_program import REAL, Steps, StraightLineProgram

#: Balls (arb or acb) by symbol.
Values: TypeAlias = Mapping[sp.Symbol, Any]


def ball(value: Any) -> Any:
    """Number as a ball: doubles as the decimals that represent them, other numbers exactly.

    Parameters
    ----------
    value : float, int, Fraction, str, sympy number, mpmath number or flint.arb

    Returns
    -------
    flint.arb, or flint.acb for one

    Raises
    ------
    InputError
        If it is not a real number.

    Examples
    --------
    >>> from flowlanes.formulas import ball
    >>> ball(0.5)
    0.500000000000000
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
        # Any arithmetic operation would round to the precision of mpmath.
        sign, mantissa, exponent, _ = value._mpf_
        return (-1) ** int(sign) * arb(int(mantissa)) * arb(2) ** int(exponent)
    try:
        return arb(str(float(value)) if isinstance(value, np.floating) else str(value))
    except ValueError:
        shown = repr(value) if isinstance(value, str) else f"of the class {type(value).__name__}"
        raise InputError(f"ball: value must be a real number, not {shown}") from None


def exact(value: Any) -> Fraction:
    """Number as a fraction: the shortest decimal for a double, the midpoint for a ball."""
    if isinstance(value, arb):
        mantissa, exponent = value.mid().man_exp()
        return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    if isinstance(value, mpmath.mpf):
        sign, mantissa, exponent, _ = value._mpf_
        return Fraction((-1) ** sign * int(mantissa)) * Fraction(2) ** int(exponent)
    if isinstance(value, sp.Rational):
        return Fraction(int(value.p), int(value.q))
    return value if isinstance(value, Fraction) else Fraction(str(value))


def number(value: SupportsFloat | str) -> float:
    """Double nearest to the midpoint of a ball."""
    return float(value.mid()) if isinstance(value, arb) else float(value)


def components(formula: sp.Expr) -> tuple[sp.Expr, ...]:
    """Scalar or vector formula as scalar formulas."""
    return tuple(scalars(formula))


@arguments_checked
def ball_values(formulas: Iterable[sp.Expr], values: Values) -> tuple[Any, ...]:
    """Scalar formulas in balls.

    Parameters
    ----------
    formulas : iterable of sympy.Expr
    values : mapping of Symbol to arb or acb

    Returns
    -------
    tuple of arb or acb
        Not finite where a formula has no value.

    Raises
    ------
    InputError
        If a symbol has no value.

    Examples
    --------
    >>> from flint import arb
    >>> from flowlanes.formulas import ball_values
    >>> x = sp.Symbol("x")
    >>> ball_values([x**2], {x: arb(3)})
    (9.00000000000000,)
    """
    scalars = tuple(sp.sympify(formula) for formula in formulas)
    symbols = set[sp.Symbol]().union(*(formula.free_symbols for formula in scalars))
    names = tuple(sorted(symbols, key=str))
    if missing := [str(name) for name in names if name not in values]:
        raise InputError(f"no value is given for {', '.join(missing)}")
    return ball_function(names, scalars)(*(values[name] for name in names))


@arguments_checked
def ball_function(
    names: tuple[sp.Symbol, ...], formulas: tuple[sp.Expr, ...], steps: Steps = ()
) -> Callable[..., tuple[Any, ...]]:
    """Scalar formulas as a function of balls.

    Parameters
    ----------
    names : tuple of Symbol
        Arguments of the function.
    formulas : tuple of sympy.Expr
    steps : tuple of (Symbol, sympy.Expr), optional
        Intermediate quantities used in the formulas, in order.

    Returns
    -------
    callable
        Function of one ball for each name, which returns a tuple of balls.

    Examples
    --------
    >>> from flint import arb
    >>> from flowlanes.formulas import ball_function
    >>> x = sp.Symbol("x")
    >>> ball_function((x,), (x**2, x + 1))(arb(3))
    (9.00000000000000, 4.00000000000000)
    """
    return _ball_function(
        tuple(names), tuple(map(sp.sympify, formulas)), tuple(dict(steps).items())
    )


@lru_cache(maxsize=512)
def _ball_function(
    names: tuple[sp.Symbol, ...], formulas: tuple[sp.Expr, ...], steps: Steps
) -> Callable[..., tuple[Any, ...]]:
    program = StraightLineProgram(names, formulas, steps, REAL)
    return lambda *values: tuple(ball(value) for value in program.run(values))


def array_function(
    names: Sequence[sp.Symbol], formulas: Sequence[sp.Expr], steps: Steps = ()
) -> Callable[..., tuple[Any, ...]]:
    """Scalar formulas as a function of NumPy arrays.

    Parameters
    ----------
    names : sequence of Symbol
        Arguments of the function.
    formulas : sequence of sympy.Expr
    steps : tuple of (Symbol, sympy.Expr), optional
        Intermediate quantities used in the formulas, in order; by default their common parts.
    """
    shared = (lambda e: (list(steps), list(e))) if steps else (lambda e: sp.cse(e, list=False))
    function = sp.lambdify(tuple(names), tuple(formulas), "numpy", cse=shared)
    return lambda *arrays: tuple(function(*arrays))
