"""Reversibility: sign changes of some variables that reverse the direction of time.

The proof goes definition by definition: each definition is even or odd in the earlier quantities,
and each rate has the parity that a reversal requires.
"""

from __future__ import annotations

from collections.abc import Set
from itertools import combinations

import sympy as sp

from ..formulas.exact_zero import vanishes
from ..system.named_formulas import flat
from ..system.system import Name, System

#: Maximum number of state variables (a vector counts as one) for which reversals are searched.
LARGEST = 6


def reversal(system: System) -> tuple[Name, ...]:
    """The smallest set of variables whose sign change is a reversing symmetry.

    Parameters
    ----------
    system : System

    Returns
    -------
    tuple of Vector or Symbol
        Empty if there is none, or none can be proven.
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
    """True if a sign change of some symbols provably reverses the equations.

    Parameters
    ----------
    system : System
    odd : set of Symbol
        State variables and parameters; for parameters, systems with both signs are related.

    Returns
    -------
    bool
        False also if the parity of some formula cannot be determined.
    """
    signs = {s: -1 if s in odd else 1 for s in (*system.symbols, *system.defaults)}
    zeros: dict[sp.Symbol, sp.Expr] = {}
    for symbol, formula in system.scalar_definitions:
        value = formula.xreplace(zeros)
        if value == 0:  # zero is both even and odd
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
    """1 for an even formula, −1 for an odd one; None if undetermined."""
    seen = _parity_of_operands(formula, signs)
    if seen is not None:
        return seen
    # Compare f(−x) with ±f(x) exactly if the operands have no common parity.
    other = formula.xreplace({s: -s for s in formula.free_symbols if signs.get(s) == -1})
    if vanishes(other - formula):
        return 1
    return -1 if vanishes(other + formula) else None


def _parity_of_operands(formula: sp.Expr, signs: dict[sp.Symbol, int]) -> int | None:
    """The parity that follows from the parities of the operands, without computation."""
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
