"""Formulas on complex balls: a value where they are analytic, no number where a root may be cut."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import sympy as sp
from flint import acb

from ...formulas.balls import Steps, ball
from ..one_degree.vectors import cross

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
    tape = _Tape(names)
    for name, formula in steps:
        tape.places[name] = tape.place(formula)
    results = [tape.place(sp.sympify(formula)) for formula in formulas]

    def function(*arguments: Any) -> list[Any]:
        values = tape.run(arguments)
        return [values[place] for place in results]

    return function


class _Tape:
    """Operations in order, each on the results of earlier ones."""

    def __init__(self, names: Sequence[sp.Symbol]) -> None:
        self.places: dict[Any, int] = {name: place for place, name in enumerate(names)}
        self._length = len(names)
        self._operations: list[tuple[Callable[..., Any], tuple[int, ...]]] = []

    def place(self, node: Any) -> int:
        """Where the value of a formula will be."""
        if node not in self.places:
            self.places[node] = self._add(*self._operation(node))
        return self.places[node]

    def _add(self, operation: Callable[..., Any], operands: tuple[int, ...]) -> int:
        self._operations.append((operation, operands))
        return self._length + len(self._operations) - 1

    def _operation(self, node: Any) -> tuple[Callable[..., Any], tuple[int, ...]]:
        if node.is_Number:
            constant = ball(node)
            return (lambda: constant), ()
        if node.is_Add:
            return _sum, tuple(self.place(part) for part in node.args)
        if node.is_Mul:
            return _product, tuple(self.place(part) for part in node.args)
        base, power = self.place(node.base), int(2 * node.exp)
        if power % 2:
            base = self._add(root, (base,))
        else:
            power //= 2
        # a ball around zero has no power in python-flint, but it has a product
        if abs(power) > 1:
            base = self._add(_product, (base,) * abs(power))
        return (_inverse if power < 0 else _product), (base,)

    def run(self, arguments: Sequence[Any]) -> list[Any]:
        """All values."""
        values = list(arguments)
        for operation, operands in self._operations:
            values.append(operation(*[values[k] for k in operands]))
        return values


def _sum(first: Any, *others: Any) -> Any:
    for other in others:
        first = first + other
    return first


def _product(first: Any, *others: Any) -> Any:
    for other in others:
        first = first * other
    return first


def _inverse(value: Any) -> Any:
    return 1 / value


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
