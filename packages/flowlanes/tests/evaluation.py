"""Formulas of a System as numbers, by roads that do not pass through the integrator."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import sympy as sp

from flowlanes.system.system import System
from flowlanes.system.vectors import to_components


def numeric(
    system: System, formulas: Iterable[Any], values: Mapping[sp.Symbol, float] | None = None
) -> Callable[[Any], Any]:
    """Scalar formulas as a NumPy function of states (size, ...), real or complex.

    The result has the shape (formulas, ...). `values` replace defaults of parameters.
    """
    scalars = [to_components(formula) for formula in formulas]
    names = [*system.symbols, *system.defaults]
    steps = list(system.required_definitions(scalars))
    function = sp.lambdify(names, scalars, "numpy", cse=lambda e: (steps, e))
    constants = list({**system.defaults, **(values or {})}.values())

    def at(states: Any) -> Any:
        columns = np.asarray(states)
        found = function(*columns, *constants)
        return np.array([np.broadcast_to(x, columns.shape[1:]) for x in found])

    return at


def drift(values: Any) -> float:
    """Largest change of values, relative to the first unless that is zero."""
    numbers = [x - values[0] for x in values]
    return float(max(map(abs, numbers)) / (abs(values[0]) or 1))


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
    speeds = [dual.value for dual in slopes(system, system.rates, known, {})]
    return slopes(system, formulas, known, dict(zip(system.symbols, speeds, strict=True)))


def slopes(
    system: System,
    formulas: Sequence[Any],
    known: Mapping[sp.Symbol, Any],
    direction: Mapping[sp.Symbol, Any],
) -> list[Dual]:
    """Values of scalar formulas and their derivatives in a direction of the state space."""
    number = type(next(iter(known.values())))
    zero = number(0)
    scalars = [to_components(formula) for formula in formulas]
    evaluate = _Evaluation(
        number, {s: Dual(value, direction.get(s, zero)) for s, value in known.items()}
    )
    for symbol, step in system.required_definitions(scalars, known):
        evaluate.seen[symbol] = evaluate(step)
    return [evaluate(scalar) for scalar in scalars]


def parameter_values(system: System, number: type) -> dict[sp.Symbol, Any]:
    """Default values of the parameters, as written."""
    exact = {symbol: as_fraction(value) for symbol, value in system.defaults.items()}
    return {symbol: number(x.numerator) / x.denominator for symbol, x in exact.items()}


def on_conditions(
    system: System,
    conditions: Sequence[Any],
    known: Mapping[sp.Symbol, Any],
    free: Sequence[sp.Symbol],
) -> dict[sp.Symbol, Any]:
    """A point of mpmath numbers moved in the variables `free` to where all conditions vanish.

    The inverse is rounded to doubles, so that every step gains some fifteen digits.
    """
    point = dict(known)
    one = mpmath.mpf(1)
    for _ in range(40):
        defects = [dual.value for dual in slopes(system, conditions, point, {})]
        if max(map(abs, defects), default=0) < mpmath.mpf(10) ** (5 - mpmath.mp.dps):
            return point
        columns = [
            [float(dual.rate) for dual in slopes(system, conditions, point, {s: one})] for s in free
        ]
        # redundant conditions make the rows dependent
        inverse = np.linalg.pinv(np.array(columns).T, rcond=1e-9)
        for symbol, row in zip(free, inverse, strict=True):
            point[symbol] -= sum(float(a) * x for a, x in zip(row, defects, strict=True))
    raise ArithmeticError(f"{system.name}: no point of {conditions} was found near {known}")


_FUNCTIONS: dict[type, tuple[Callable[[Any], Any], Callable[[Any], Any]]] = {
    sp.sin: (mpmath.sin, mpmath.cos),
    sp.cos: (mpmath.cos, lambda x: -mpmath.sin(x)),
    sp.tan: (mpmath.tan, lambda x: 1 + mpmath.tan(x) ** 2),
    sp.cot: (mpmath.cot, lambda x: -1 - mpmath.cot(x) ** 2),
    sp.exp: (mpmath.exp, mpmath.exp),
    sp.log: (mpmath.log, lambda x: 1 / x),
}
"""Functions of one variable with their derivatives."""


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
            if node.exp.is_Integer:
                return parts[0].power(int(node.exp))
            if parts[1].rate:
                raise TypeError(node)
            return parts[0].power(parts[1].value)
        value, slope = _FUNCTIONS[node.func]
        (inside,) = parts
        return Dual(value(inside.value), slope(inside.value) * inside.rate)


def is_rational(system: System, formulas: Iterable[Any]) -> bool:
    """Whether formulas and field take rational values at rational points."""
    nodes = {
        *system.rates,
        *(to_components(f) for f in formulas),
        *(step for _, step in system.scalar_definitions),
    }
    return not any(
        part.is_Function or (part.is_Pow and not part.exp.is_Integer)
        for node in nodes
        for part in sp.preorder_traversal(node)
    )


def as_fraction(decimal: float) -> Fraction:
    """The decimal number as written: 0.1 is one tenth."""
    return Fraction(repr(float(decimal)))
