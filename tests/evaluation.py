"""Formulas of a System as numbers, by roads that do not pass through the integrator."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from chaplygin.system import System
from chaplygin.vectors import explicit


def numeric(
    system: System, formulas: Iterable[Any], values: Mapping[sp.Symbol, float] | None = None
) -> Callable[[Any], Any]:
    """Scalar formulas as a NumPy function of states (size, ...), real or complex.

    The result has the shape (formulas, ...). `values` replace defaults of parameters.
    """
    scalars = [explicit(formula) for formula in formulas]
    names = [*system.symbols, *system.defaults]
    steps = list(system.needed(scalars))
    function = sp.lambdify(names, scalars, "numpy", cse=lambda e: (steps, e))
    constants = list({**system.defaults, **(values or {})}.values())

    def at(states: Any) -> Any:
        columns = np.asarray(states)
        found = function(*columns, *constants)
        return np.array([np.broadcast_to(x, columns.shape[1:]) for x in found])

    return at


def jacobian(field: Callable[[Any], Any], state: Any) -> Any:
    """Derivative of an analytic vector function, by an imaginary step that costs no digits."""
    columns = []
    for i in range(len(state)):
        point = np.array(state, dtype=complex)
        point[i] += 1e-30j
        columns.append(field(point).imag / 1e-30)
    return np.array(columns).T


@dataclass(frozen=True)
class Dual:
    """A number with its rate of change along a vector field."""

    value: Any
    rate: Any

    def power(self, exponent: Any) -> Dual:
        return Dual(self.value**exponent, exponent * self.value ** (exponent - 1) * self.rate)


def rates_of_change(
    system: System, formulas: Sequence[Any], known: Mapping[sp.Symbol, Any]
) -> list[Dual]:
    """Values of scalar formulas and their derivatives along the field of a system.

    `known` gives the state and the parameters, as Fractions (everything is then exact) or as
    numbers of mpmath.
    """
    number = type(next(iter(known.values())))
    still = {symbol: Dual(value, number(0)) for symbol, value in known.items()}
    here = _Evaluation(number, dict(still))
    for symbol, step in system.steps:
        here.seen[symbol] = here(step)
    speeds = [here(rate).value for rate in system.rates]
    moving = dict(still)
    for symbol, speed in zip(system.symbols, speeds, strict=True):
        moving[symbol] = Dual(known[symbol], speed)
    along = _Evaluation(number, moving)
    for symbol, step in system.steps:
        along.seen[symbol] = along(step)
    return [along(explicit(formula)) for formula in formulas]


@dataclass(frozen=True)
class _Evaluation:
    number: Any
    seen: dict[sp.Expr, Dual]

    def __call__(self, node: sp.Expr) -> Dual:
        if node not in self.seen:
            self.seen[node] = self._build(node)
        return self.seen[node]

    def _build(self, node: sp.Expr) -> Dual:
        zero = self.number(0)
        if node.is_Rational:
            return Dual(self.number(int(node.p)) / int(node.q), zero)
        parts = [self(arg) for arg in node.args]
        if node.is_Add:
            return Dual(sum((x.value for x in parts), zero), sum((x.rate for x in parts), zero))
        if node.is_Mul:
            product = Dual(self.number(1), zero)
            for x in parts:
                product = Dual(
                    product.value * x.value, product.rate * x.value + product.value * x.rate
                )
            return product
        if node.is_Pow:
            p, q = int(node.exp.p), int(node.exp.q)
            return parts[0].power(p if q == 1 else self.number(p) / q)
        (inside,) = parts
        if node.func is sp.cos:
            return Dual(mpmath.cos(inside.value), -mpmath.sin(inside.value) * inside.rate)
        if node.func is sp.sin:
            return Dual(mpmath.sin(inside.value), mpmath.cos(inside.value) * inside.rate)
        raise TypeError(node)


def is_rational(system: System, formulas: Iterable[Any]) -> bool:
    """Whether formulas and field take rational values at rational points."""
    nodes = {*system.rates, *(explicit(f) for f in formulas), *(step for _, step in system.steps)}
    return not any(
        part.is_Function or (part.is_Pow and not part.exp.is_Integer)
        for node in nodes
        for part in sp.preorder_traversal(node)
    )


def as_fraction(decimal: float) -> Fraction:
    """The decimal number as written: 0.1 is one tenth."""
    return Fraction(repr(float(decimal)))
