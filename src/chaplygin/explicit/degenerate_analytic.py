"""Formulas on complex balls: a value where they are analytic, no number where a root may be cut."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp
from flint import acb, arb

from .degenerate_quaternion import cross, dot
from .numbers import Steps, ball

__all__ = ["analytic", "root", "triad"]


def root(x: Any) -> Any:
    """A square root; NaN where a complex ball meets the negative real axis."""
    return x.sqrt(analytic=True) if isinstance(x, acb) else x.sqrt()


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

    def function(*arguments: Any) -> list[Any]:
        known: dict[Any, Any] = dict(zip(names, arguments, strict=True))
        for name, formula in steps:
            known[name] = _value(formula, known)
        return [_value(sp.sympify(formula), known) for formula in formulas]

    return function


def _value(node: Any, known: dict[Any, Any]) -> Any:
    if node not in known:
        known[node] = _computed(node, known)
    return known[node]


def _computed(node: Any, known: dict[Any, Any]) -> Any:
    if node.is_Number:
        return ball(node)
    if node.is_Add:
        return sum((_value(part, known) for part in node.args), arb(0))
    if node.is_Mul:
        product: Any = arb(1)
        for part in node.args:
            product = product * _value(part, known)
        return product
    base, power = _value(node.base, known), int(2 * node.exp)
    if power % 2:
        base = root(base)
    else:
        power //= 2
    # a ball around zero has no power in python-flint, but it has a product
    value: Any = arb(1)
    for _ in range(abs(power)):
        value = value * base
    return value if power > 0 else 1 / value


def triad(first: Sequence[Any], second: Sequence[Any]) -> list[list[Any]]:
    """Orthonormal vectors: along the first one, across it, and across both."""
    normal = cross(first, second)
    one, three = ([x / root(dot(v, v)) for x in v] for v in (first, normal))
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
