"""Smooth branches of equations with absolute values and signs, between the zeros of arguments.

A Taylor series is not valid across the corner of |u| at u = 0.  With |u| = σu and sign u = σ the
equations are smooth while σ = ±1 is constant.  The step ends where σu decreases to zero, and σ
changes its sign.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import sympy as sp

from ..formulas.evaluation import with_absolute_values
from ..system.system import Guard, Parameter, System
from ..system.vectors import real_symbol
from .taylor.compiled_system import SignedOutputs
from .taylor.working_numbers import WorkingArray

#: Relative to the state; a negative value that is larger than this is not a rounding error.
ROUNDING = 1e-9
KINDS = (sp.Abs, sp.sign, sp.Max, sp.Min)


@dataclass(frozen=True)
class SignBranches:
    """System with signs as parameters.

    Attributes
    ----------
    system : System
        System with a parameter σ for each argument u after its own parameters, and a guard σu for
        each after its own guards.
    arguments : tuple of sympy.Expr
        Arguments u, for messages.
    """

    system: System
    arguments: tuple[sp.Expr, ...]


@lru_cache(maxsize=32)
def sign_branches(system: System) -> SignBranches | None:
    """Smooth system between zeros of the arguments, or None if there are no corners."""
    watched = [guard.value for guard in system.scalar.guards]
    formulas = [*system.rates, *watched]
    steps = system.required_definitions(formulas)
    if not any(formula.has(*KINDS) for formula in (*formulas, *(f for _, f in steps))):
        return None
    branches = _Branches(system)
    definitions = {}
    for symbol, formula in system.scalar_definitions:
        definitions[symbol] = branches.smooth(formula)
        branches.note(symbol, formula)
    rates = [branches.smooth(rate) for rate in system.rates]
    own = [
        replace(g, value=branches.smooth(v)) for g, v in zip(system.guards, watched, strict=True)
    ]
    if not branches.signs:
        return None
    signs = list(branches.signs.items())
    guards = tuple(
        Guard(str(sign), sign * argument, f"{argument} changes its sign", lift_off=True)
        for argument, sign in signs
    )
    parameters = tuple(Parameter(sign, "sign of an argument", 1.0) for _, sign in signs)
    return SignBranches(
        System(
            system.name,
            system.title,
            dict(zip(system.symbols, rates, strict=True)),
            parameters=(*system.parameters, *parameters),
            definitions=definitions,
            relations=system.relations,
            guards=(*own, *guards),
        ),
        tuple(argument for argument, _ in signs),
    )


class RunningSigns:
    """Signs of a motion, which are parameters of its series.

    Parameters
    ----------
    signed : SignedOutputs, optional
        None if there are no corners.
    parameters : array (parameters,)
        Values of the parameters of the original system.
    numbers : array
        Parameters of the series, which begin with these values and the signs; changed in place.
    """

    def __init__(
        self, signed: SignedOutputs | None, parameters: WorkingArray, numbers: WorkingArray
    ) -> None:
        self._signed = signed
        self.count = 0 if signed is None else len(signed.arguments)
        self._numbers = numbers[: len(parameters) + self.count]
        self._signs = numbers[len(parameters) :][: self.count]

    def _values(self, state: WorkingArray) -> WorkingArray:
        assert self._signed is not None
        values = self._signed.outputs(np.array(state), np.array(self._numbers))
        return values[len(values) - self.count :]

    def set(self, state: WorkingArray) -> None:
        """Set the signs at a start; an argument may contain the signs of earlier ones."""
        for i in range(self.count):
            self._signs[i] = self._signs[i] * 0 + 1
            if float(self._values(state)[i]) < 0:
                self._signs[i] *= -1

    def turn(self, number: int) -> None:
        """Reverse a sign."""
        self._signs[number] *= -1

    def wrong(self, state: WorkingArray, changing: int | None) -> str:
        """Description of a sign that disagrees with its argument, which may only have touched zero.

        Parameters
        ----------
        changing : int, optional
            Sign that was reversed last, and whose argument is zero.
        """
        if self._signed is None:
            return ""
        scale = 1 + max(abs(float(x)) for x in state)
        for i, value in enumerate(self._values(state)):
            if i != changing and float(value) < -ROUNDING * scale:
                return f"{self._signed.arguments[i]} is zero, without certainly changing its sign"
        return ""


class _Branches:
    """Formulas with a symbol for the sign of each argument that is not constant."""

    def __init__(self, system: System) -> None:
        self.signs: dict[sp.Expr, sp.Symbol] = {}
        self._moving = set(system.symbols)
        self._names = {str(s) for s in (*system.symbols, *dict(system.scalar_definitions))}
        self._names |= {str(p.symbol) for p in system.parameters}

    def note(self, symbol: sp.Symbol, formula: sp.Expr) -> None:
        """Record that a definition is not constant if its formula is not."""
        if self._moves([formula]):
            self._moving.add(symbol)

    def _moves(self, formulas: Iterable[sp.Expr]) -> bool:
        return any(formula.free_symbols & self._moving for formula in formulas)

    def smooth(self, formula: sp.Expr) -> sp.Expr:
        """Formula with signs as symbols."""
        if not formula.args or not formula.has(*KINDS):
            return formula
        if isinstance(formula, sp.Max | sp.Min):
            return self.smooth(with_absolute_values(formula))
        parts = [self.smooth(part) for part in formula.args]
        if isinstance(formula, sp.Abs | sp.sign) and self._moves(parts):
            sign = self._sign(parts[0])
            return sign * parts[0] if isinstance(formula, sp.Abs) else sign
        return formula.func(*parts)

    def _sign(self, argument: sp.Expr) -> sp.Symbol:
        if argument not in self.signs:
            name = f"sign_{len(self.signs) + 1}"
            while name in self._names:
                name += "_"
            self.signs[argument] = real_symbol(name)
        return self.signs[argument]
