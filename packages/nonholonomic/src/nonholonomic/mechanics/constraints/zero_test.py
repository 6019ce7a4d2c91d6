"""Test whether a formula vanishes identically on a configuration space."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.formulas.expansion import Angles, add_angle, angles, combination
from flowlanes.system.named_formulas import expand

Steps = Sequence[tuple[sp.Symbol, sp.Expr]]


def vanishes(formula: sp.Expr, relations: Sequence[sp.Expr], steps: Steps = ()) -> bool:
    """Whether a formula is proven to vanish wherever the relations hold.

    Roots, sines and cosines become symbols with a relation of their own; the numerator is
    divided by a Gröbner basis of the relations that share symbols with it.
    """
    whole = expand(formula, steps)
    conditions = [expand(r, steps) for r in relations]
    kernels = _Kernels(angles([whole, *conditions], {}))
    total = kernels.plain(whole)
    numerator = sp.numer(sp.together(total))
    numerator = sp.expand(numerator)
    if numerator == 0:
        return True
    # Membership in the ideal of the relations is sufficient, not necessary: a formula that vanishes
    # on the real points alone is not recognised.
    ideal = _touching(numerator, [*map(kernels.plain, conditions), *kernels.relations])
    if not ideal:
        return False
    symbols = sorted(
        numerator.free_symbols.union(*(r.free_symbols for r in ideal)),
        key=lambda s: (s not in kernels.symbols, str(s)),
    )
    basis = sp.groebner([sp.numer(sp.together(r)) for r in ideal], *symbols, order="grevlex")
    return bool(basis.contains(numerator))


def _touching(formula: sp.Expr, relations: Sequence[sp.Expr]) -> list[sp.Expr]:
    """The relations by which a formula may be reduced."""
    chosen: list[sp.Expr] = []
    reached = set(formula.free_symbols)
    waiting = [r for r in relations if r != 0]
    while True:
        near = [r for r in waiting if r.free_symbols <= reached or _is_root(r, reached)]
        if not near:
            return chosen
        chosen += near
        reached = reached.union(*(r.free_symbols for r in near))
        waiting = [r for r in waiting if r not in near]


def _is_root(relation: sp.Expr, symbols: set[sp.Symbol]) -> bool:
    """Whether a relation defines a root or angle that occurs in the symbols."""
    return any(isinstance(s, sp.Dummy) and s in symbols for s in relation.free_symbols)


class _Kernels:
    """Symbols in place of roots, sines, cosines and other functions."""

    def __init__(self, units: Angles) -> None:
        self.units = units
        self.table: dict[sp.Expr, sp.Symbol] = {}
        self.relations: list[sp.Expr] = []

    @property
    def symbols(self) -> set[sp.Symbol]:
        """The symbols introduced."""
        return set(self.table.values())

    def plain(self, formula: sp.Expr) -> sp.Expr:
        """The formula with roots, sines, cosines and other functions replaced."""
        return self._with_symbols(formula.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x)))

    def _with_symbols(self, formula: sp.Expr) -> sp.Expr:
        if formula.is_Atom:
            return formula
        if formula.is_Pow and formula.exp.is_Rational and not formula.exp.is_Integer:
            return self._root(formula.base, int(formula.exp.q)) ** int(formula.exp.p)
        if isinstance(formula, (sp.sin, sp.cos)):
            return self._circular(formula)
        if formula.is_Add or formula.is_Mul or formula.is_Pow:
            return formula.func(*(self._with_symbols(arg) for arg in formula.args))
        return self.table.setdefault(formula, sp.Dummy("f", real=True))

    def _root(self, base: sp.Expr, degree: int) -> sp.Symbol:
        key = sp.Pow(base, sp.Rational(1, degree))
        if key not in self.table:
            self.table[key] = sp.Dummy("s", real=True)
            self.relations.append(self.table[key] ** degree - self._with_symbols(base))
        return self.table[key]

    def _circular(self, formula: sp.Expr) -> sp.Expr:
        """A sine or cosine by the addition theorem, in terms of the unit angles of `angles`."""
        total: tuple[sp.Expr, sp.Expr] = (sp.S.Zero, sp.S.One)
        for core, factor in combination(formula.args[0], {}).items():
            unit = core / self.units[core]
            pair = (sp.sin(unit), sp.cos(unit)) if unit.has(sp.pi) else self._unit(unit)
            total = add_angle(total, pair, int(factor * self.units[core]), (sp.S.Zero, sp.S.One))
        return sp.expand(total[0] if isinstance(formula, sp.sin) else total[1])

    def _unit(self, angle: sp.Expr) -> tuple[sp.Symbol, sp.Symbol]:
        sine, cosine = sp.sin(angle), sp.cos(angle)
        if sine not in self.table:
            self.table[sine], self.table[cosine] = (
                sp.Dummy("s", real=True),
                sp.Dummy("c", real=True),
            )
            self.relations.append(self.table[sine] ** 2 + self.table[cosine] ** 2 - 1)
        return self.table[sine], self.table[cosine]
