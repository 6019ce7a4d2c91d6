"""Derivatives through named definitions: intermediate results have names and are not expanded.

A formula of mechanics is a short expression in named quantities, which are short expressions in
others.  A derivation (∂/∂w_i, a vector field, the rate along a motion) is applied by the chain
rule, and its result for a named quantity gets one name of its own.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache
from graphlib import TopologicalSorter
from itertools import count

import sympy as sp

from ..system.vectors import real_symbol
from .cancellation import in_lowest_terms

SHORT = 2
"""Operations up to which a value is written out instead of being named."""
SMALL = 40
"""Operations up to which a formula is written out and shortened as a whole."""
LARGEST = 60
"""Operations up to which a formula is shortened at all."""
SPREAD = 400
"""Terms up to which a formula may be multiplied out to that end."""

Step = tuple[sp.Symbol, sp.Expr]

_operations = lru_cache(maxsize=4096)(sp.count_ops)


@dataclass(frozen=True)
class Derivation:
    """First-order differential operator, given by its action on symbols.

    Other symbols are constant if they have no definition; otherwise the action follows from it.
    """

    rates: tuple[Step, ...]

    @cached_property
    def table(self) -> Mapping[sp.Symbol, sp.Expr]:
        """Rates by symbol."""
        return dict(self.rates)


class Tape:
    """Definitions to which derivatives and other intermediate results are added.

    Parameters
    ----------
    steps : iterable of (Symbol, Expr)
        Initial definitions.
    reserved_names : iterable of Symbol
        Names that must not be used for new definitions.
    """

    def __init__(self, steps: Iterable[Step], reserved_names: Iterable[sp.Symbol]) -> None:
        self._values = dict(steps)
        self._input_symbols = frozenset(self._values)
        self._names = {value: symbol for symbol, value in self._values.items()}
        self._reserved_names = {str(s) for s in reserved_names} | {str(s) for s in self._values}
        self._memo: dict[tuple[Derivation, sp.Symbol], sp.Expr] = {}

    def define(self, symbol: sp.Symbol, value: sp.Expr) -> None:
        """Add a definition under a given name."""
        self._values[symbol] = value
        self._reserved_names.add(str(symbol))

    def value(self, symbol: sp.Symbol) -> sp.Expr:
        """Value of a name."""
        return self._values[symbol]

    def fresh(self, label: str) -> sp.Symbol:
        """Unused name: `label` if it is free and ends in a digit."""
        symbol = real_symbol(self._free(label))
        self._reserved_names.add(str(symbol))
        return symbol

    def name(self, value: sp.Expr, label: str = "z") -> sp.Expr:
        """Name for a value, made from `label`, or the value itself if it is short."""
        if _operations(value) <= SHORT:
            return value
        if value not in self._names:
            symbol = self.fresh(label)
            self._names[value] = symbol
            self._values[symbol] = value
        return self._names[value]

    def _free(self, label: str) -> str:
        if label[-1].isdigit() and label not in self._reserved_names:
            return label
        stem = label.rstrip("0123456789_")
        return next(f"{stem}_{n}" for n in count(1) if f"{stem}_{n}" not in self._reserved_names)

    def along(self, derivation: Derivation, value: sp.Expr) -> sp.Expr:
        """Apply a derivation to a formula."""
        terms = []
        for symbol in sorted(value.free_symbols, key=str):
            rate = self._rate(derivation, symbol)
            if rate != 0:
                terms.append(sp.diff(value, symbol) * rate)
        return sp.Add(*terms)

    def _rate(self, derivation: Derivation, symbol: sp.Symbol) -> sp.Expr:
        if symbol in derivation.table:
            return derivation.table[symbol]
        if symbol not in self._values:
            return sp.S.Zero
        key = (derivation, symbol)
        if key not in self._memo:
            # The rate of a name gets a name itself, once, so that repeated differentiation does
            # not grow.
            self._memo[key] = self.name(self.short(self.along(derivation, self._values[symbol])))
        return self._memo[key]

    def short(self, value: sp.Expr, hold: Collection[sp.Symbol] = ()) -> sp.Expr:
        """Formula with names substituted and simplified, if that is small.

        The initial definitions of the tape and the names in `hold` are not substituted.
        """
        if value.is_Atom:
            return value
        written = value
        # Names are substituted until only input symbols are left, or the formula is too large.
        while True:
            inner = {
                s: self._values[s]
                for s in written.free_symbols
                if s in self._values and s not in self._input_symbols and s not in hold
            }
            if not inner:
                break
            written = written.xreplace(inner)
            if _operations(written) > LARGEST:
                return value
        shortened = simplify_small(written)
        # A longer result is used only if it is small in any case.
        limit = max(SMALL // 2, _operations(value))
        return shortened if _operations(shortened) <= limit else value

    def steps(self, formulas: Iterable[sp.Expr]) -> tuple[Step, ...]:
        """Definitions on which formulas depend, in an order in which they can be computed."""
        graph: dict[sp.Symbol, set[sp.Symbol]] = {}
        waiting = [s for value in formulas for s in value.free_symbols]
        while waiting:
            symbol = waiting.pop()
            if symbol in graph or symbol not in self._values:
                continue
            needs = self._values[symbol].free_symbols & self._values.keys()
            graph[symbol] = needs
            waiting += needs
        # Names in the order of their creation, so that the same input gives the same output.
        position = {symbol: index for index, symbol in enumerate(self._values)}
        ordered = {
            symbol: sorted(graph[symbol], key=position.__getitem__)
            for symbol in sorted(graph, key=position.__getitem__)
        }
        return tuple((s, self._values[s]) for s in TopologicalSorter(ordered).static_order())


@lru_cache(maxsize=4096)
def simplify_small(value: sp.Expr) -> sp.Expr:
    """Small formula simplified by cancellation and sin² + cos² = 1; a large one is unchanged."""
    if value.is_Atom or _operations(value) > LARGEST or _expanded_size(value) > SPREAD:
        return value
    candidates = [value]
    angles = sorted({f.args[0] for f in value.atoms(sp.sin, sp.cos)}, key=str)
    if angles:
        candidates.append(_on_circles(value, angles))
    # Each form is also tried in lowest terms; the shortest one is taken.
    if not value.has(sp.Derivative, sp.Subs):
        candidates.extend(in_lowest_terms(c) for c in tuple(candidates))
    return min(candidates, key=_operations)


def _expanded_size(value: sp.Expr) -> int:
    """Bound of the number of terms of an expanded formula."""
    match value:
        case sp.Add():
            return sum(_expanded_size(part) for part in value.args)
        case sp.Mul():
            return math.prod(map(_expanded_size, value.args))
        case sp.Pow() if value.exp.is_Integer:
            return int(_expanded_size(value.base) ** abs(int(value.exp)))
    return 1


def _on_circles(value: sp.Expr, angles: Iterable[sp.Expr]) -> sp.Expr:
    """Numerator and denominator reduced modulo sin² + cos² = 1, in the shorter way."""
    above, below = (sp.expand(part) for part in sp.fraction(sp.together(value)))
    for angle in angles:
        above, below = (_on_circle(part, sp.sin(angle), sp.cos(angle)) for part in (above, below))
    return above / below


def _on_circle(value: sp.Expr, sine: sp.Expr, cosine: sp.Expr) -> sp.Expr:
    """Expanded formula without squares of the sine or without those of the cosine."""
    squares = {p for p in value.atoms(sp.Pow) if p.base in (sine, cosine) and _is_power(p.exp)}
    candidates = [value]
    for one, other in ((sine, cosine), (cosine, sine)):
        table = {
            p: one ** (p.exp % 2) * (1 - other**2) ** (p.exp // 2) for p in squares if p.base == one
        }
        # sin^n = sin^(n mod 2) (1 − cos²)^⌊n/2⌋
        if table:
            candidates.append(sp.expand(value.xreplace(table)))
    return min(candidates, key=_operations)


def _is_power(exponent: sp.Expr) -> bool:
    return bool(exponent.is_Integer and exponent >= 2)
