"""Reversible equations: changing signs of some variables makes time run backwards.

Like a rotation, a reversal is shown definition by definition: each is even or odd in what was
before it, and the rates have the parity that a reversal needs.
"""

from __future__ import annotations

from collections.abc import Set
from itertools import combinations
from typing import Any

import sympy as sp

from ..system import Name, System, flat
from ..vectors import explicit
from .turning import vanishes

__all__ = ["reversal", "reverses"]

#: State variables, a vector counted as one, above which no reversal is looked for.
LARGEST = 6


def reversal(system: System) -> tuple[Name, ...]:
    """The fewest state variables whose change of sign, with that of the time, keeps the equations.

    Parameters
    ----------
    system : System

    Returns
    -------
    tuple of Vector or Symbol
        Empty if there are none, or the proof does not reach.
    """
    names = system.state
    if len(names) > LARGEST:
        return ()
    for count in range(1, len(names) + 1):
        for chosen in combinations(names, count):
            if reverses(system, set(flat(chosen))):
                return chosen
    return ()


def reverses(system: System, odd: Set[sp.Symbol]) -> bool:
    """Whether the equations keep their form when some symbols and the time change sign; exact.

    Parameters
    ----------
    system : System
    odd : set of Symbol
        State variables, and parameters as well: then the systems with both values are meant.

    Returns
    -------
    bool
        False also where the proof does not reach.
    """
    signs = {s: -1 if s in odd else 1 for s in (*system.symbols, *system.defaults)}
    zeros: dict[sp.Symbol, sp.Expr] = {}
    for symbol, formula in system.steps:
        value = formula.xreplace(zeros)
        if value == 0:  # even and odd at once
            zeros[symbol] = sp.S.Zero
            continue
        parity = _parity(value, signs)
        if parity is None:
            return False
        signs[symbol] = parity
    relations = all(_parity(explicit(f).xreplace(zeros), signs) for f in system.relations)
    rates = ((s, f.xreplace(zeros)) for s, f in zip(system.symbols, system.rates, strict=True))
    return relations and all(vanishes(_reflected(f, signs) + signs[s] * f) for s, f in rates)


def _reflected(formula: Any, signs: dict[sp.Symbol, int]) -> Any:
    odd = {s: -s for s in formula.free_symbols if signs.get(s) == -1}
    return formula.xreplace(odd)


def _parity(formula: Any, signs: dict[sp.Symbol, int]) -> int | None:
    """1 for an even formula, −1 for an odd one; None if it is shown neither."""
    other = _reflected(formula, signs)
    if vanishes(other - formula):
        return 1
    return -1 if vanishes(other + formula) else None
