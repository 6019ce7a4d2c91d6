"""Elimination of variables by conditions that contain functions but are linear in a variable.

A relation or level condition such as z = f(x, y) or (ω, ∇f) = 0 is not polynomial. If it is linear
in a state variable on which none of its functions depends, this variable is expressed by the
others and removed from the state: the phase space is a graph. That the rate of the variable agrees
with its expression is proved together with the law.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import islice, permutations

import sympy as sp
from sympy.core.function import AppliedUndef

from flowlanes.formulas.errors import NeedMoreGeneratorsError, OutOfReachError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.system.laws import Identity, Law, Rate
from flowlanes.system.named_formulas import expand, scalars
from flowlanes.system.system import System, VariablesByName

from ..fields.function_field import FunctionField
from ..fields.signs import Signs
from .components import Decomposition
from .triangular_set import numerator

MOST_ORDERS = 24
"""Maximum number of orders in which the conditions are tried."""


@dataclass(frozen=True)
class Graph:
    """A system and a law without the eliminated variables.

    Attributes
    ----------
    consistency : Identity
        States that the eliminated variables move as their expressions do.
    excluded_factors : tuple of sympy.Expr
        Coefficients of these variables that could vanish on a part of the level outside the
        closure of the rest.
    """

    system: System
    law: Law
    consistency: Identity
    excluded_factors: tuple[sp.Expr, ...] = ()


def graph(system: System, law: Law, tame: tuple[type, ...] = ()) -> Graph | None:
    """Eliminate variables by non-polynomial conditions; None if there are no such conditions.

    Parameters
    ----------
    tame : tuple of type
        Functions that are allowed in polynomial conditions.
    """
    if law.by_components:
        return None
    steps = dict(system.scalar_definitions)
    gone, factors, left = _choices(system, law, steps, tame)
    if not gone:
        return None
    rates = dict(zip(system.symbols, system.rates, strict=True))
    reduced = replace(
        system,
        field={s: rate for s, rate in rates.items() if s not in gone},
        definitions=_in_order({**steps, **gone}),
        relations=tuple(left),
        laws=(),
        observables=(),
        reconstruction=None,
        conventions=VariablesByName(),
    )
    agreement = tuple(Rate(s) - rates[s] for s in gone)
    consistency = Identity("the conditions are kept", agreement)
    excluded = _excluded_factors(system, (*system.relations, *law.level), factors)
    # d^n x / dF with F = a z − … contributes 1/|∂F/∂z| = 1/|a| to the density.
    there = replace(law, level=(), as_printed=None)
    there = there.weighted(tuple((factor, -sp.S.One) for factor in factors))
    return Graph(reduced, there, consistency, excluded)


def _choices(
    system: System, law: Law, steps: Mapping[sp.Symbol, sp.Expr], tame: tuple[type, ...]
) -> tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr], list[sp.Expr]]:
    """Eliminated variables with their values, the coefficients, and the remaining conditions.

    One condition may use up a variable that another needs, so that several orders are tried until
    all conditions with functions are used.
    """
    conditions = [*system.scalar.relations, *law.scalar.level]
    wild = [i for i, c in enumerate(conditions) if not _polynomial(expand(c, steps), tame)]
    best: tuple[dict[sp.Symbol, sp.Expr], list[sp.Expr], set[int]] | None = None
    for order in islice(permutations(wild), MOST_ORDERS):
        gone: dict[sp.Symbol, sp.Expr] = {}
        factors: list[sp.Expr] = []
        taken: set[int] = set()
        for index in order:
            free = [s for s in system.symbols if s not in gone]
            choice = _linear(conditions[index], free, steps, gone)
            if choice is not None:
                symbol, value, factor = choice
                gone[symbol] = value
                factors.append(factor)
                taken.add(index)
        if best is None or len(taken) > len(best[2]):
            best = gone, factors, taken
        if len(taken) == len(wild):
            break
    gone, factors, taken = best or ({}, [], set())
    return gone, factors, [c for i, c in enumerate(conditions) if i not in taken]


def _excluded_factors(
    system: System, conditions: Iterable[sp.Expr], factors: Iterable[sp.Expr]
) -> tuple[sp.Expr, ...]:
    """Coefficients whose zeros could contain a component of the level.

    Function values are treated as independent variables: a statement that holds for all values
    holds in particular for those of the functions.
    """
    factors = [factor for factor in factors if not factor.is_number]
    spare = 8
    while factors:
        try:
            return tuple(f for f in factors if not _thin(system, tuple(conditions), f, spare))
        except NeedMoreGeneratorsError:
            spare *= 2
        except OutOfReachError:
            return tuple(factors)
    return ()


def _thin(system: System, conditions: tuple[sp.Expr, ...], factor: sp.Expr, spare: int) -> bool:
    symbols = (*system.symbols, *(p.symbol for p in system.parameters))
    draft = FunctionField([str(s) for s in symbols], spare)
    seeds = {s: Jet(draft.generator(str(s)), {}) for s in symbols}
    evaluate = Evaluator(draft, seeds.get, dict(system.scalar_definitions))
    equations = [numerator(draft, evaluate.value(c)) for c in scalars(tuple(conditions))]
    lead = numerator(draft, evaluate.value(factor))
    equations += [poly for _, poly, _ in draft.relations]
    decomposition = Decomposition(
        draft, draft.names, {str(s) for s in system.symbols}, Signs(draft.ring, {})
    )
    parts = [part for part, _ in lead.factor()[1]]
    return all(decomposition.within((*equations, part), len(equations) + 1) for part in parts)


def _polynomial(formula: sp.Expr, tame: tuple[type, ...]) -> bool:
    """True if a formula has no functions or roots but tame ones, or is a single function value."""
    if isinstance(formula, AppliedUndef):
        return True
    functions = formula.atoms(sp.Function, sp.Derivative, sp.Subs)
    whole = all(p.exp.is_Integer for p in formula.atoms(sp.Pow))
    return whole and all(isinstance(f, tame) for f in functions)


def _linear(
    formula: sp.Expr,
    symbols: Iterable[sp.Symbol],
    steps: Mapping[sp.Symbol, sp.Expr],
    expressions: Mapping[sp.Symbol, sp.Expr],
) -> tuple[sp.Symbol, sp.Expr, sp.Expr] | None:
    """A variable in which a condition is linear, its value, and its coefficient."""
    known = {**steps, **expressions}
    reached = expand(formula, steps).free_symbols
    for symbol in reversed(list(symbols)):
        if symbol not in reached:
            continue
        # Definitions that do not depend on the variable stay as names.
        written = expand(formula, _names_that_hide(symbol, steps))
        factor = sp.diff(written, symbol)
        remainder = written.xreplace({symbol: sp.S.Zero})
        slope = expand(factor, known)
        if slope != 0 and symbol not in slope.free_symbols | expand(remainder, known).free_symbols:
            return symbol, -remainder / factor, factor
    return None


def _names_that_hide(
    symbol: sp.Symbol, steps: Mapping[sp.Symbol, sp.Expr]
) -> dict[sp.Symbol, sp.Expr]:
    """The definitions that depend on a symbol, directly or through others."""
    hiding: dict[sp.Symbol, sp.Expr] = {}
    # Definitions are in dependency order, so one pass is enough.
    for name, value in steps.items():
        if value.free_symbols & {symbol, *hiding}:
            hiding[name] = value
    return hiding


def _in_order(steps: Mapping[sp.Symbol, sp.Expr]) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """Definitions in dependency order."""
    done: dict[sp.Symbol, sp.Expr] = {}
    waiting = dict(steps)
    while waiting:
        ready = [s for s, e in waiting.items() if not e.free_symbols & waiting.keys()]
        done |= {s: waiting.pop(s) for s in ready}
    return tuple(done.items())
