"""Scalings that preserve the form of a system: its physical dimensions.

A weight is a tuple of exponents, one for each independent scaling. An integral splits into parts
of pure weight, each of which is an integral; this keeps the linear algebra of a search small.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import lcm
from typing import TypeAlias

import sympy as sp
from flint import fmpq, fmpq_mat

from .phase_space import RestrictedSystem

Weight: TypeAlias = tuple[int, ...]
#: A symbol, or the string that stands for time.
Base: TypeAlias = sp.Basic | str
Form: TypeAlias = dict[Base, Fraction]

_TIME = "time"


def _plus(left: Form, right: Form, factor: Fraction) -> Form:
    form = dict(left)
    for key, value in right.items():
        form[key] = form.get(key, Fraction(0)) + factor * value
    return {key: value for key, value in form.items() if value}


@dataclass
class _Walk:
    """Weights of formulas as linear forms in the weights of base symbols, with constraints."""

    forms: dict[sp.Basic, Form]
    ties: list[Form] = field(default_factory=list)

    def equate(self, left: Form | None, right: Form | None) -> None:
        """Require that two weights agree; None agrees with everything."""
        if left is not None and right is not None:
            self.ties.append(_plus(left, right, Fraction(-1)))

    def __call__(self, formula: sp.Basic) -> Form | None:
        """The weight of a formula; None for zero, which has every weight."""
        if formula == 0:
            return None
        form = self.forms.get(formula)
        if form is None:
            form = self.forms[formula] = self._fresh(formula)
        return form

    def _fresh(self, formula: sp.Basic) -> Form:
        if isinstance(formula, sp.Add):
            # All terms of a sum have the same weight.
            first, *others = [self(arg) for arg in formula.args]
            for other in others:
                self.equate(first, other)
            return first or {}
        if isinstance(formula, sp.Mul):
            product: Form = {}
            for arg in formula.args:
                product = _plus(product, self(arg) or {}, Fraction(1))
            return product
        if isinstance(formula, sp.Pow) and formula.exp.is_Rational:
            return _plus({}, self(formula.base) or {}, Fraction(int(formula.exp.p), formula.exp.q))
        # Arguments of other functions are dimensionless.
        for arg in formula.args:
            self.equate(self(arg), {})
        return {}


def weights(space: RestrictedSystem) -> dict[sp.Symbol, Weight]:
    """Weights of all state variables, parameters and definitions of a system.

    Every scaling of these symbols and of time that preserves vector field, definitions, relations,
    level and conditions on the parameters is a combination of the returned scalings.
    """
    system = space.system
    steps = (*space.substitutions, *system.required_definitions([*system.rates, *space.relations]))
    # Zero has every weight.
    empty = [symbol for symbol, formula in steps if formula == 0]
    bases: list[Base] = [*space.free, *system.symbols, *empty, _TIME]
    walk = _Walk({symbol: {symbol: Fraction(1)} for symbol in bases})
    symbols = [*space.free, *system.symbols, *empty]
    for symbol, formula in ((s, f) for s, f in steps if f != 0):
        walk.forms[symbol] = walk(formula) or {}
        symbols.append(symbol)
    for symbol, rate in zip(system.symbols, system.rates, strict=True):
        # A rate has the weight of its variable divided by time.
        walk.equate(walk(rate), {symbol: Fraction(1), _TIME: Fraction(-1)})
    for relation in space.relations:
        walk(relation)
    scalings = _solutions(walk.ties, bases)
    exact = {symbol: _weight(walk.forms[symbol], scalings) for symbol in symbols}
    common = lcm(*(w.denominator for weight in exact.values() for w in weight))
    return {symbol: tuple(int(w * common) for w in weight) for symbol, weight in exact.items()}


def _weight(form: Form, scalings: Iterable[Mapping[Base, Fraction]]) -> tuple[Fraction, ...]:
    return tuple(
        sum((value * scaling[key] for key, value in form.items()), Fraction(0))
        for scaling in scalings
    )


def total(*weights: Weight) -> Weight:
    """The weight of a product."""
    return tuple(sum(parts) for parts in zip(*weights, strict=True))


def weight_of(
    factors: Sequence[sp.Expr], powers: Sequence[int], table: Mapping[sp.Symbol, Weight]
) -> Weight:
    """The weight of a product of powers; a factor without its own weight is a pure number."""
    zero = tuple(0 for _ in next(iter(table.values())))
    return total(
        zero,
        *(
            tuple(exponent * w for w in table.get(factor, zero))
            for factor, exponent in zip(factors, powers, strict=True)
        ),
    )


def _solutions(ties: list[Form], bases: list[Base]) -> list[Form]:
    """A basis of the weights of base symbols that satisfy all constraints."""
    distinct = {tuple(sorted((bases.index(k), v) for k, v in tie.items())) for tie in ties}
    rows = [tie for tie in distinct if tie]
    matrix = fmpq_mat(max(len(rows), 1), len(bases))
    for i, row in enumerate(rows):
        for j, value in row:
            matrix[i, j] = fmpq(value.numerator, value.denominator)
    reduced, rank = matrix.rref()
    pivots = [next(j for j in range(len(bases)) if reduced[i, j] != 0) for i in range(rank)]
    basis = []
    for column in (j for j in range(len(bases)) if j not in pivots):
        scaling = {base: Fraction(0) for base in bases}
        scaling[bases[column]] = Fraction(1)
        for i, pivot in enumerate(pivots):
            entry = reduced[i, column]
            scaling[bases[pivot]] = -Fraction(int(entry.p), int(entry.q))
        basis.append(scaling)
    return basis
