"""Reduction of a law to claims on phase spaces with polynomial conditions."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from functools import cached_property

import sympy as sp
from sympy.functions.elementary.trigonometric import TrigonometricFunction

from flowlanes.formulas.errors import OutOfReachError
from flowlanes.system.laws import Law
from flowlanes.system.system import System

from .graph_conditions import Graph, graph
from .trigonometric import Circles, circles, formulas_of


@dataclass(frozen=True)
class Claim:
    """A law of a system with polynomial conditions.

    Attributes
    ----------
    excluded_zeros : tuple of sympy.Expr
        Formulas whose zeros the claim excludes.
    circles : tuple of (angle, sine, cosine, unit)
        Angles that were replaced by the sine and cosine of a multiple.
    expressions : tuple of (Symbol, Expr)
        Variables expressed by others.
    """

    system: System
    law: Law
    excluded_zeros: tuple[sp.Expr, ...] = ()
    circles: tuple[tuple[sp.Symbol, sp.Symbol, sp.Symbol, sp.Expr], ...] = ()
    expressions: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()

    def original(self, formula: sp.Expr) -> sp.Expr:
        """A formula with the functions of angles of the original system."""
        return formula.xreplace(self._functions)

    def original_words(self, words: str) -> str:
        """A text about the claim with the functions of angles in place of their symbols."""
        for symbol, function in self._functions.items():
            words = re.sub(rf"\b{symbol}\b", str(function), words)
        return words

    @cached_property
    def _functions(self) -> dict[sp.Symbol, sp.Expr]:
        return {
            symbol: function(unit * angle)
            for angle, sine, cosine, unit in self.circles
            for symbol, function in ((sine, sp.sin), (cosine, sp.cos))
        }


def polynomial_problems(system: System, law: Law) -> tuple[Claim, ...]:
    """The claims equivalent to a law, on phase spaces with polynomial conditions.

    Raises
    ------
    OutOfReachError
        If there are no such claims.
    """
    # Trigonometric conditions become polynomial on circles; other functions need elimination.
    reduced = graph(system, law, tame=(TrigonometricFunction,))
    try:
        base = _on_circles(system, law, reduced)
    except OutOfReachError:
        reduced = graph(system, law)
        if reduced is None:
            raise
        base = Claim(reduced.system, reduced.law, expressions=_expressed_variables(system, reduced))
    if reduced is None:
        return (base,)
    return (
        replace(
            _on_circles(reduced.system, reduced.consistency, None),
            expressions=_expressed_variables(system, reduced),
        ),
        replace(base, excluded_zeros=reduced.excluded_factors),
    )


def _on_circles(system: System, law: Law, reduced: Graph | None) -> Claim:
    expressed: tuple[tuple[sp.Symbol, sp.Expr], ...] = ()
    if reduced is not None:
        expressed = _expressed_variables(system, reduced)
        system, law = reduced.system, reduced.law
    formulas = (*system.relations, *law.level, *(value for _, value in system.definitions))
    changed: Circles | None = None
    if any(sp.sympify(formula).has(TrigonometricFunction) for formula in formulas):
        changed = circles(system, law.level, formulas_of(law))
    if changed is None:
        return Claim(system, law, expressions=expressed)
    lost = tuple((angle, *circle) for angle, circle in changed.replaced_angles.items())
    return Claim(changed.system, changed.law(law), circles=lost, expressions=expressed)


def _expressed_variables(system: System, reduced: Graph) -> tuple[tuple[sp.Symbol, sp.Expr], ...]:
    """The variables that were eliminated from the state, with their formulas."""
    gone = set(system.symbols) - set(reduced.system.symbols)
    return tuple((s, value) for s, value in reduced.system.scalar_definitions if s in gone)
