"""Whether the equations of a reduction are closed, that is, determine the rates.

The unknowns are the rates of all variables in the equations; if an equation contains a second
rate, the first rate is a variable too. Each equation, differentiated first if it contains no rate,
gives a row: its derivatives by the unknowns along the motion. Further rows come from the
conditions between the variables and from the definitions of quantities that are functions of the
other variables.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Rate, Reduction
from flowlanes.system.named_formulas import expand

from ..fields.field import Field, FieldElement
from .level_set import LevelSet
from .named_formulas import quantities_in_order


@dataclass(frozen=True)
class _Rates:
    """The equations of a reduction, with symbols for the rates.

    Attributes
    ----------
    equations : tuple of sympy.Expr
        The equations with definitions expanded.
    meaning : mapping of Symbol to Rate
        The rates for which the symbols stand.
    unknowns : tuple of Symbol
        The highest rate of every variable.
    first : mapping of Symbol to Symbol
        The unknowns that are first rates, by their variables.
    """

    equations: tuple[sp.Expr, ...]
    meaning: dict[sp.Symbol, sp.Expr]
    unknowns: tuple[sp.Symbol, ...]
    first: dict[sp.Symbol, sp.Symbol]

    @property
    def homogeneous(self) -> bool:
        """True if all equations are homogeneous in the first rates and leave time open."""
        return (
            len(self.unknowns) > 1
            and len(self.first) == len(self.unknowns) == len(self.meaning)
            and all(_homogeneous(equation, self.unknowns) for equation in self.equations)
        )


def up_to_time(law: Reduction, level: LevelSet) -> bool:
    """True if the equations are homogeneous in the rates and so determine paths only."""
    return _rates(law, level).homogeneous


def rows_of_equations_and_identities(
    law: Reduction, level: LevelSet, field: Field
) -> tuple[list[list[FieldElement]], list[list[FieldElement]], int]:
    """Rows of the equations, rows of the identities, and the number of unknown rates.

    Raises
    ------
    InputError
        If the equations contain no variable.
    """
    rates = _rates(law, level)
    quantities = quantities_in_order(law, level)
    evaluate = level.along(field).with_steps(quantities)

    def value(formula: sp.Expr) -> FieldElement:
        restored = sp.sympify(formula).xreplace(rates.meaning)
        number: FieldElement = evaluate.value(level.without_second_rates(restored, quantities))
        return number

    stated = [[value(slope) for slope in row] for row in _equation_rows(rates)]
    known = [[value(slope) for slope in row] for row in _identity_rows(rates, quantities, level)]
    return stated, known, len(rates.unknowns)


def _rates(law: Reduction, level: LevelSet) -> _Rates:
    quantities = quantities_in_order(law, level)
    variables = {*level.system.symbols, *quantities}
    meaning: dict[sp.Symbol, sp.Expr] = {}
    symbols: dict[sp.Expr, sp.Symbol] = {}

    def symbol_of(rate: sp.Expr) -> sp.Symbol:
        if rate not in symbols:
            symbols[rate] = sp.Dummy(str(rate), real=True)
            meaning[symbols[rate]] = rate
        return symbols[rate]

    def rate_of(formula: sp.Expr) -> sp.Expr:
        """The time derivative Σ ∂f/∂x ẋ over all variables and rates in a formula."""
        moving = [s for s in formula.free_symbols if s in variables or s in meaning]
        return sp.Add(
            *(
                sp.diff(formula, s) * symbol_of(Rate(s.xreplace(meaning)))
                for s in sorted(moving, key=str)
            )
        )

    def with_symbols(formula: sp.Expr) -> sp.Expr:
        """A formula with symbols for its rates, starting from the innermost."""
        while rates := [r for r in formula.atoms(Rate) if not r.args[0].has(Rate)]:
            formula = formula.xreplace({r: rate_of(r.args[0]) for r in rates})
        return formula

    equations = tuple(with_symbols(level.expand(e)) for e in law.scalar.equations)
    seen = {s for e in equations for s in e.free_symbols}
    moving = {s for s in seen if s in variables}
    # A variable may occur only through its rate.
    moving |= {r for r in _below(meaning[s] for s in seen if s in meaning) if r in variables}
    if not moving:
        raise InputError(f"the equations of the law {law.name!r} hold nothing that moves")
    first, unknowns = {}, []
    for variable in sorted(moving, key=str):
        top = Rate(variable)
        while Rate(top) in symbols:
            top = Rate(top)
        unknowns.append(symbol_of(top))
        if top == Rate(variable):
            first[variable] = symbols[top]
    return _Rates(equations, meaning, tuple(unknowns), first)


def _below(rates: Iterable[sp.Expr]) -> Iterator[sp.Expr]:
    """The variables whose rates are given."""
    for rate in rates:
        inner = rate
        while isinstance(inner, Rate):
            inner = inner.args[0]
        yield inner


def _equation_rows(rates: _Rates) -> Iterator[list[sp.Expr]]:
    for equation in rates.equations:
        if equation.free_symbols & set(rates.unknowns):
            yield [sp.diff(equation, u) for u in rates.unknowns]
        else:
            yield _derivatives(equation, rates)


def _identity_rows(
    rates: _Rates, quantities: dict[sp.Symbol, sp.Expr], level: LevelSet
) -> Iterator[list[sp.Expr]]:
    """Rows from the definitions of the quantities and from the conditions."""
    own = {s for rate in rates.meaning.values() for s in rate.free_symbols}
    own |= {s for e in rates.equations for s in e.free_symbols} - set(rates.meaning)
    for symbol, formula in quantities.items():
        if symbol in own:
            others = {s: f for s, f in quantities.items() if s not in own}
            with_symbols = level.expand(expand(formula, others))
            if _within(with_symbols, own, quantities, level):
                yield _derivatives(symbol - with_symbols, rates)
    for condition in level.moving:
        if _within(condition, own, quantities, level):
            yield _derivatives(condition, rates)


def _derivatives(formula: sp.Expr, rates: _Rates) -> list[sp.Expr]:
    back = {unknown: variable for variable, unknown in rates.first.items()}
    return [sp.diff(formula, back[u]) if u in back else sp.S.Zero for u in rates.unknowns]


def _within(
    formula: sp.Expr, own: set[sp.Symbol], quantities: dict[sp.Symbol, sp.Expr], level: LevelSet
) -> bool:
    """True if all variables of a formula are variables of the equations."""
    moving: set[sp.Symbol] = formula.free_symbols & {*level.system.symbols, *quantities}
    return moving <= own


def _homogeneous(equation: sp.Expr, unknowns: tuple[sp.Symbol, ...]) -> bool:
    if not equation.free_symbols & set(unknowns):
        return True
    try:
        poly = sp.Poly(sp.fraction(sp.together(equation))[0], *unknowns)
    except sp.PolynomialError:
        return False
    return bool(poly.is_homogeneous)
