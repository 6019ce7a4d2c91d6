"""Reversible equations: sign changes of some variables that reverse the direction of time.

Like a rotation, a reversal is proven definition by definition: each is even or odd in the earlier
quantities, and the rates have the parity that a reversal requires.
"""

from __future__ import annotations

from collections.abc import Set
from itertools import combinations

import sympy as sp

from ..formulas.exact_zero import vanishes
from ..system.named_formulas import flat
from ..system.system import Name, System

#: Number of state variables (a vector counts as one) above which no reversal is searched.
LARGEST = 6


def reversal(system: System) -> tuple[Name, ...]:
    """The smallest set of variables whose sign change is a reversing symmetry.

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
    """Whether a sign change of some symbols reverses the equations; exact.

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
    for symbol, formula in system.scalar_definitions:
        value = formula.xreplace(zeros)
        if value == 0:  # even and odd at once
            zeros[symbol] = sp.S.Zero
            continue
        parity = _parity(value, signs)
        if parity is None:
            return False
        signs[symbol] = parity
    if any(_parity(f.xreplace(zeros), signs) is None for f in system.scalar.relations):
        return False
    rates = zip(system.symbols, (f.xreplace(zeros) for f in system.rates), strict=True)
    return all(f == 0 or _parity(f, signs) == -signs[s] for s, f in rates)


def _parity(formula: sp.Expr, signs: dict[sp.Symbol, int]) -> int | None:
    """1 for an even formula, −1 for an odd one; None if neither is shown."""
    seen = _parity_of_operands(formula, signs)
    if seen is not None:
        return seen
    other = formula.xreplace({s: -s for s in formula.free_symbols if signs.get(s) == -1})
    if vanishes(other - formula):
        return 1
    return -1 if vanishes(other + formula) else None


def _parity_of_operands(formula: sp.Expr, signs: dict[sp.Symbol, int]) -> int | None:
    """The parity that follows from those of the operands, without computation."""
    if formula.is_Symbol or not formula.args:
        return signs.get(formula, 1)
    parts = [_parity_of_operands(part, signs) for part in formula.args]
    if all(part == 1 for part in parts):
        return 1
    if None in parts:
        return None
    if formula.is_Mul:
        return -1 if parts.count(-1) % 2 else 1
    if formula.is_Add:
        return None if 1 in parts else -1
    if formula.is_Pow and formula.exp.is_Integer:
        return -1 if formula.exp % 2 else 1
    return {sp.sin: -1, sp.cos: 1, sp.tan: -1, sp.Abs: 1}.get(formula.func)
