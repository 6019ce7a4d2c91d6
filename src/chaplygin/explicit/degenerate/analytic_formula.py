"""Formulas on complex balls: a value where they are analytic, no number where a root may be cut."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp

from ...formulas.program import ANALYTIC, Steps, StraightLineProgram
from ..one_degree.vectors import cross

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
    """Orthonormal vectors: along the first one, across it, and across both.

    `sizes` are the lengths of the first and of the vector product, constants of the motion.
    """
    one = [x / sizes[0] for x in first]
    three = [x / sizes[1] for x in cross(first, second)]
    return [one, cross(three, one), three]


def velocity(
    rates: Sequence[sp.Expr], names: Sequence[sp.Symbol]
) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """The velocity in body axes, of which the rates of the place are two space components.

    Read off at two attitudes: upright, and one that takes the third body axis to the first one of
    space.

    Parameters
    ----------
    rates : two formulas
        In the attitude and other things.
    names : four Symbols
        The attitude.
    """
    upright: Mapping[Any, Any] = dict(zip(names, (1, 0, 0, 0), strict=True))
    turned: Mapping[Any, Any] = dict.fromkeys(names, sp.Rational(1, 2))
    first, second = (rate.xreplace(_exact(upright)) for rate in rates)
    return first, second, rates[0].xreplace(_exact(turned))


def _exact(values: Mapping[Any, Any]) -> dict[Any, Any]:
    return {name: sp.sympify(value) for name, value in values.items()}
