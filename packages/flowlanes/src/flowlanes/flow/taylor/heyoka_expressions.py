"""Translation of the SymPy formulas of a System to heyoka, with shared named quantities."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

import heyoka as hy
import sympy as sp

from ...errors import InputError
from ...formulas.evaluation import Evaluation, numerator_and_denominator
from ...system.named_formulas import scalars
from ...system.system import System

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

# The widest number type of this heyoka build makes 1/3 exact to working precision.
_WIDE = getattr(hy, "real128", float)


class Translator(Evaluation[hy.expression]):
    """Translator of the formulas of one system to heyoka expressions.

    The flat state becomes heyoka variables with the same names, the parameters ``par[i]`` in the
    order of ``system.parameters``.  Definitions are translated on first use, so unused definitions
    cost nothing.
    """

    def __init__(self, system: System) -> None:
        self.variables = hy.make_vars(*map(str, system.symbols))
        if len(system.symbols) == 1:
            self.variables = [self.variables]
        variables = dict(zip(system.symbols, self.variables, strict=True))
        parameters = {p.symbol: hy.par[i] for i, p in enumerate(system.parameters)}
        super().__init__({**variables, **parameters}, dict(system.scalar_definitions))

    def __call__(self, formula: sp.Expr) -> hy.expression:
        """Heyoka expression of a scalar formula."""
        return self._visit(*scalars(formula))

    def all(self, formulas: Iterable[sp.Expr]) -> list[hy.expression]:
        """Heyoka expressions of several formulas; vectors are flattened."""
        return list(map(self._visit, scalars(tuple(formulas))))

    def _constant(self, number: sp.Expr) -> hy.expression:
        if number.is_Rational:
            return hy.expression(_WIDE(int(number.p)) / _WIDE(int(number.q)))
        return hy.expression(_WIDE(str(sp.N(number, 40))))

    def _symbol(self, symbol: sp.Symbol) -> hy.expression:
        return self._function(symbol)

    def _sum(self, formula: sp.Add) -> hy.expression:
        return hy.sum(self._parts(formula))

    def _product(self, formula: sp.Mul) -> hy.expression:
        above, below = numerator_and_denominator(formula)
        product = hy.prod([self._visit(factor) for factor in above])
        return product / hy.prod([self._visit(factor) for factor in below]) if below else product

    def _power(self, formula: sp.Pow) -> hy.expression:
        return self._integer_power(self._visit(formula.base), formula.exp)

    def _integer_power(self, base: hy.expression, exponent: sp.Expr) -> hy.expression:
        if exponent.is_Integer and exponent < 0:
            return hy.expression(1.0) / self._integer_power(base, -exponent)
        if exponent == sp.Rational(1, 2):
            return hy.sqrt(base)
        if exponent == sp.Rational(-1, 2):
            return hy.expression(1.0) / hy.sqrt(base)
        if exponent.is_Integer:
            # Short products differentiate faster than a general power.
            return hy.prod([base] * int(exponent)) if exponent <= 4 else base ** float(exponent)
        return base ** self._visit(exponent)

    def _function(self, formula: sp.Expr) -> hy.expression:
        if formula.is_number and not formula.args:
            return self._constant(formula)
        function = _FUNCTIONS.get(formula.func)
        if function is None:
            raise InputError(f"{formula}: the integrator has no function {formula.func.__name__}")
        return function(*self._parts(formula))
