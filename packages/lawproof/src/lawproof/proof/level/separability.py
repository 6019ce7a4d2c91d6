"""Conditions for equations to separate: one for each quantity, with a common factor.

The equations of a `Separation` determine the rates r_i of its quantities u_i. Up to a common
factor these are functions f_i(u_i) if and only if log(r_i/r_k) has no mixed derivative by u_i and
u_k and no derivative by any other variable.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Rate, Separation

from ..fields.field import Field, FieldElement
from .level_set import LevelSet
from .named_formulas import quantities_in_order


@dataclass(frozen=True)
class _Parts:
    """The separated quantities with the squares of their rates, and the constants."""

    squares: dict[sp.Symbol, sp.Expr]
    constants: frozenset[sp.Symbol]


def separation_residuals(law: Separation, level: LevelSet) -> Iterator[tuple[str, sp.Expr]]:
    """Formulas in the quantities and the state that vanish if the equations separate.

    Raises
    ------
    InputError
        If there is not one equation for each quantity.
    """
    parts = _parts(law, level)
    still = {*parts.constants, *(p.symbol for p in level.system.parameters)}
    for (first, own), (second, other) in combinations(parts.squares.items(), 2):
        ratio = own / other
        label = f"the ratio of the rates of {first} and {second}"
        left = _mixed_part(ratio, first, second, still)
        if left is None:
            yield f"{label} is a product", sp.S.Zero
            continue
        slopes = {s: sp.diff(left, s) / left for s in left.free_symbols - still}
        for symbol in sorted(slopes.keys() - {first, second}, key=str):
            yield f"{label} by {symbol}", slopes[symbol]
        if first in slopes:
            yield f"{label} is a product", sp.diff(slopes[first], second)


def separation_gradients(
    law: Separation, level: LevelSet, field: Field
) -> tuple[list[list[FieldElement]], list[list[FieldElement]]]:
    """Gradients of conditions and constants of a separation, and of its separated quantities."""
    parts = _parts(law, level)
    partial = level.partial(field).with_steps(quantities_in_order(law, level))
    size = len(level.system.symbols)

    def row(formula: sp.Expr) -> list[FieldElement]:
        slopes = partial(formula).slopes
        return [slopes.get(i, field.zero) for i in range(size)]

    constants = sorted(parts.constants, key=str)
    return [row(f) for f in (*level.moving, *constants)], [row(u) for u in parts.squares]


def _parts(law: Separation, level: LevelSet) -> _Parts:
    variables = {*level.system.symbols, *quantities_in_order(law, level)}
    squares: dict[sp.Symbol, sp.Expr] = {}
    constants = set()
    for number, raw in enumerate(law.scalar.equations, 1):
        equation = level.expand(raw)
        rates = equation.atoms(Rate)
        symbols = {rate.args[0] for rate in rates}
        if len(rates) != 1 or not symbols <= variables:
            raise InputError(
                f"the law {law.name!r}: equation {number} of a separation must hold the rate of "
                "one quantity, and no other"
            )
        (rate,), (symbol,) = rates, symbols
        if equation == rate:
            constants.add(symbol)
            continue
        square = _square(equation, rate)
        if square is None or symbol in squares:
            raise InputError(
                f"the law {law.name!r}: equation {number} of a separation must be the only one of "
                f"{symbol}, and give its rate or the square of it"
            )
        squares[symbol] = square
    if len(squares) < 2:
        raise InputError(
            f"the law {law.name!r}: {len(squares) or 'no'} "
            f"{'quantity has' if len(squares) < 2 else ''} an equation of its own; a separation "
            "has two or more"
        )
    return _Parts(squares, frozenset(constants))


def _square(equation: sp.Expr, rate: sp.Expr) -> sp.Expr | None:
    """The square of the rate as given by an equation; None if it does not give it."""
    # a r + b = 0 gives r² = (b/a)²; a r² / 2 + b = 0 gives r² = −2 b / a.
    symbol = sp.Dummy(real=True)
    above = sp.fraction(sp.together(equation.xreplace({rate: symbol})))[0]
    slope = sp.diff(above, symbol)
    remainder = above.xreplace({symbol: sp.S.Zero})
    if symbol not in slope.free_symbols:
        return (remainder / slope) ** 2
    curvature = sp.diff(slope, symbol)
    linear = slope.xreplace({symbol: sp.S.Zero})
    if symbol in curvature.free_symbols or sp.expand(linear) != 0:
        return None
    return -2 * remainder / curvature


def _mixed_part(
    ratio: sp.Expr, first: sp.Symbol, second: sp.Symbol, still: set[sp.Symbol]
) -> sp.Expr | None:
    """A ratio without the factors that depend on only one of two quantities."""
    left = []
    for factor in sp.Mul.make_args(sp.factor(ratio)):
        moving = factor.free_symbols - still
        if not (moving <= {first} or moving <= {second}):
            left.append(factor)
    return sp.Mul(*left) if left else None
