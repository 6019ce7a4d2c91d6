"""SymPy formulas of a System as heyoka expressions, sharing every named quantity."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any, TypeAlias

import heyoka as hy
import numpy.typing as npt
import sympy as sp

from ..core.system import System
from ..core.vectors import to_components
from ..errors import InputError

__all__ = ["Translator", "WorkingArray", "WorkingNumber"]

#: A number of the working precision: a double, or one of heyoka's with 34 digits; and arrays.
WorkingNumber: TypeAlias = Any
WorkingArray: TypeAlias = npt.NDArray[Any]

_FUNCTIONS: Mapping[type[sp.Function], Callable[..., hy.expression]] = {
    sp.sin: hy.sin,
    sp.cos: hy.cos,
    sp.tan: hy.tan,
    sp.asin: hy.asin,
    sp.acos: hy.acos,
    sp.atan: hy.atan,
    sp.atan2: hy.atan2,
    sp.sinh: hy.sinh,
    sp.cosh: hy.cosh,
    sp.tanh: hy.tanh,
    sp.exp: hy.exp,
    sp.log: hy.log,
    sp.Abs: lambda x: hy.sqrt(x * x),
}

# the widest number heyoka was built with, so that 1/3 is exact to the working precision
_WIDE = getattr(hy, "real128", float)


class Translator:
    """Turns the formulas of one system into heyoka expressions.

    The flat state becomes heyoka variables of the same name, the parameters ``par[i]`` in the
    order of ``system.parameters``.  Definitions are translated when first needed, so that
    unused ones cost nothing.
    """

    def __init__(self, system: System) -> None:
        self.variables = hy.make_vars(*map(str, system.symbols))
        if len(system.symbols) == 1:
            self.variables = [self.variables]
        self._known: dict[sp.Expr, hy.expression] = dict(
            zip(system.symbols, self.variables, strict=True)
        )
        self._known |= {p.symbol: hy.par[i] for i, p in enumerate(system.parameters)}
        self._steps = dict(system.steps)

    def __call__(self, formula: sp.Expr) -> hy.expression:
        """The heyoka expression of a scalar formula."""
        return self._visit(to_components(formula))

    def all(self, formulas: Iterable[sp.Expr]) -> list[hy.expression]:
        """Several at once; vectors are flattened."""
        flat: list[hy.expression] = []
        for formula in formulas:
            value = to_components(formula)
            flat.extend(
                map(self._visit, value)
                if isinstance(value, sp.MatrixBase)
                else [self._visit(value)]
            )
        return flat

    def _visit(self, node: sp.Expr) -> hy.expression:
        if node not in self._known:
            if node in self._steps:
                self._known[node] = self._visit(self._steps[node])
            else:
                self._known[node] = self._build(node)
        return self._known[node]

    def _build(self, node: sp.Expr) -> hy.expression:
        if node.is_Rational:
            return hy.expression(_WIDE(int(node.p)) / _WIDE(int(node.q)))
        if node.is_number and not node.args:
            return hy.expression(_WIDE(str(sp.N(node, 40))))
        if node.is_Add:
            return hy.sum([self._visit(arg) for arg in node.args])
        if node.is_Mul:
            return self._product(node)
        if node.is_Pow:
            base, exponent = node.args
            return self._power(self._visit(base), exponent)
        function = _FUNCTIONS.get(node.func)
        if function is None:
            raise InputError(f"{node}: the integrator has no function {node.func.__name__}")
        return function(*(self._visit(arg) for arg in node.args))

    def _product(self, node: sp.Expr) -> hy.expression:
        above = [arg for arg in node.args if not _reciprocal(arg)]
        below = [1 / arg for arg in node.args if _reciprocal(arg)]
        product = hy.prod([self._visit(arg) for arg in above])
        return product / hy.prod([self._visit(arg) for arg in below]) if below else product

    def _power(self, base: hy.expression, exponent: sp.Expr) -> hy.expression:
        if exponent.is_Integer and exponent < 0:
            return hy.expression(1.0) / self._power(base, -exponent)
        if exponent == sp.Rational(1, 2):
            return hy.sqrt(base)
        if exponent == sp.Rational(-1, 2):
            return hy.expression(1.0) / hy.sqrt(base)
        if exponent.is_Integer:
            # short products differentiate faster than the general power
            return hy.prod([base] * int(exponent)) if exponent <= 4 else base ** float(exponent)
        return base ** self._visit(exponent)


def _reciprocal(factor: sp.Expr) -> bool:
    return bool(factor.is_Pow and factor.exp.is_number and factor.exp.is_negative)
