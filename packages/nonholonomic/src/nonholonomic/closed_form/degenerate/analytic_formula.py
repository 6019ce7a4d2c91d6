"""Formulas on complex balls: the value where they are analytic, NaN near a branch cut."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp

from flowlanes.formulas.straight_line_program import ANALYTIC, Steps, StraightLineProgram
from flowlanes.system.tuple_vectors import cross

from ...mechanics.rolling.attitude import attitude

root = ANALYTIC.root


def analytic(
    names: Sequence[sp.Symbol], formulas: Sequence[sp.Expr], steps: Steps
) -> Callable[..., list[Any]]:
    """Scalar formulas as a function of real or complex balls.

    Parameters
    ----------
    names : sequence of Symbol
        The arguments.
    formulas : sequence of sympy.Expr
        Sums, products, powers with whole or half exponents.
    steps : pairs of Symbol and formula
        Intermediate quantities, in order.
    """
    program = StraightLineProgram(names, formulas, steps)
    return lambda *arguments: program.run(arguments, ANALYTIC)


def triad(first: Sequence[Any], second: Sequence[Any], sizes: tuple[Any, Any]) -> list[list[Any]]:
    """Orthonormal vectors: along the first one, across it in their plane, normal to both.

    `sizes` are the lengths of the first and of the vector product, constants of the motion.
    """
    one = [x / sizes[0] for x in first]
    three = [x / sizes[1] for x in cross(first, second)]
    return [one, cross(three, one), three]


def velocity(rates: Sequence[sp.Expr]) -> tuple[sp.Expr, ...]:
    """The velocity in body axes, two of whose space components are the rates of the position.

    It is evaluated at two attitudes: upright, and one that takes the third body axis to the first
    space axis.  Empty if there are no rates.
    """
    upright = dict(zip(attitude.symbols, (sp.S.One, *[sp.S.Zero] * 3), strict=True))
    turned = dict.fromkeys(attitude.symbols, sp.S.Half)
    return (*(rate.xreplace(upright) for rate in rates), *(r.xreplace(turned) for r in rates[:1]))
