"""Holonomic constraints as first integrals: functions constant along all admissible motions.

Such a function F(q) is sought as a combination of monomials in the coordinates, the definitions,
sines and cosines, and, if that is not enough, inverses and logarithms.  η_s(F) = 0 at sufficiently
many points modulo a prime is a linear system for the coefficients.  Each solution is then
verified as an identity.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations_with_replacement
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from flowlanes.formulas.expansion import angles
from flowlanes.formulas.taylor import PRIMES, IrrationalError, Modular

from ..lagrangian.structure_functions import lie_derivative
from .distribution import Distribution
from .exact_points import NoPointError, random_point
from .growth import SEED
from .vector_field_series import SingularError, Values, slopes, values_at
from .zero_test import vanishes

#: Degrees of the monomials tried, with or without inverses and logarithms.
STAGES = ((1, False), (2, False), (2, True), (3, False))
MONOMIALS = 500
"""Stages with more monomials are skipped."""
SPARE = 8
"""Surplus of equations over unknowns."""


@dataclass(frozen=True)
class ConstraintIntegral:
    """A function that is constant along all admissible motions.

    Attributes
    ----------
    formula : formula
        F of F(q) = const.
    proven : bool
        Whether η_s(F) = 0 was verified as an identity, not only at many points modulo a prime.
    """

    formula: sp.Expr
    proven: bool


def constant_along(distribution: Distribution, function: sp.Expr) -> bool:
    """Whether a function is proven constant along all admissible motions."""
    return all(
        vanishes(rate, distribution.relations, distribution.steps)
        for rate in _rates(distribution, function)
    )


def _rates(distribution: Distribution, function: sp.Expr) -> Iterator[sp.Expr]:
    """η_s(F) for each s, with definitions differentiated by the chain rule."""
    for field in distribution.fields:
        total = lie_derivative(field, function)
        known: dict[sp.Symbol, sp.Expr] = {}
        for symbol, value in distribution.steps:
            rate = lie_derivative(field, value) + sum(
                (sp.diff(value, s) * r for s, r in known.items()), sp.S.Zero
            )
            if rate != 0:
                known[symbol] = rate
                total += sp.diff(function, symbol) * rate
        yield total


def constraint_integrals(
    distribution: Distribution, many: int, free: Sequence[sp.Symbol] = ()
) -> tuple[ConstraintIntegral, ...]:
    """Independent functions that are constant along all admissible motions.

    Parameters
    ----------
    distribution : Distribution
    many : int
        Their number, known from the growth vector; fewer may be found.
    free : sequence of Symbol
        Parameters that may occur in the functions, which are then integrals for all their values.
    """
    chosen: tuple[ConstraintIntegral, ...] = ()
    narrow = _Search(distribution, free, wide=False)
    for degree, wide in STAGES:
        if len(chosen) == many:
            break
        search = _Search(distribution, free, wide=True) if wide else narrow
        if search.count(degree) <= MONOMIALS:
            chosen = search.extension(degree, many, chosen)
    return chosen


class _Search:
    """Monomials in a set of letters, and points at which they are evaluated."""

    def __init__(self, distribution: Distribution, free: Sequence[sp.Symbol], wide: bool) -> None:
        self.distribution, self.free = distribution, tuple(free)
        written = {s for f in distribution.formulas for s in f.free_symbols}
        letters: list[sp.Expr] = [*distribution.coordinates, *(s for s in free if s in written)]
        letters += _named_letters(distribution)
        for core, n in angles(distribution.formulas, dict(distribution.steps)).items():
            if core.free_symbols & set(distribution.coordinates):
                letters += [sp.sin(core / n), sp.cos(core / n)]
        everything = (*distribution.formulas, *(value for _, value in distribution.steps))
        functions = {n for f in everything for n in f.atoms(sp.exp, AppliedUndef)}
        functions |= {n.expr for f in everything for n in f.atoms(sp.Derivative)}
        letters += sorted(functions, key=str)
        if wide:
            own = set(distribution.coordinates)
            plain = [s for s in letters if s.free_symbols & own]
            plain += _factors(distribution)
            letters += [f for s in plain for f in (1 / s, sp.log(s))] + _arcs(plain, own)
        self.letters = tuple(letters)
        self.numbers = Modular(PRIMES[1])
        self.space = distribution.space(self.free, self.letters)
        self.rng = random.Random(SEED)
        self.values: list[Values] = []

    def count(self, degree: int) -> int:
        """The number of monomials."""
        return len(self._monomials(degree))

    def _monomials(self, degree: int) -> list[tuple[int, ...]]:
        """Monomials as tuples of letter indices, the most complex first, without 1."""
        monomials = []
        for d in range(degree, 0, -1):
            level = combinations_with_replacement(range(len(self.letters)), d)
            monomials += [m for m in reversed(list(level)) if self._sensible(m)]
        return monomials

    def _sensible(self, monomial: tuple[int, ...]) -> bool:
        names = {self.letters[i] for i in monomial}
        logs = sum(isinstance(self.letters[i], sp.log) for i in monomial)
        return logs <= 1 and not any(1 / name in names for name in names)

    def points(self, many: int) -> list[Values]:
        """Values and rates of the letters at generic points."""
        points, failures = self.values, 0
        while len(points) < many:
            try:
                place = random_point(self.space, self.numbers, self.rng)
                points.append(values_at(self.distribution, place, self.space, self.letters))
            except (NoPointError, IrrationalError, SingularError, ZeroDivisionError):
                failures += 1
                if failures > 4 * many:
                    return []
        return points[:many]

    def extension(
        self, degree: int, many: int, integrals: tuple[ConstraintIntegral, ...]
    ) -> tuple[ConstraintIntegral, ...]:
        """The given integrals, extended by new ones of the given degree."""
        monomials = self._monomials(degree)
        width = max(1, len(self.distribution.fields))
        points = self.points((len(monomials) + SPARE) // width + 2)
        if not points:
            return integrals
        rows = [
            [_rate(monomial, point.letters, rates) for monomial in monomials]
            for point in points
            for rates in point.along
        ]
        # A solution counts if its gradient at a test point is independent of the relations and of
        # the integrals found before; so constants and functions of known integrals drop out.
        kernel = _kernel(self.numbers, rows, len(monomials))
        test = points[-1]
        span = test.normals + [slopes(test.germs, f.formula) for f in integrals]
        rank = int(self.numbers.matrix(span, len(test.gradient)).rank()) if span else 0
        for vector in reversed(kernel):
            if len(integrals) == many:
                break
            row = [
                sum(
                    (c * _rate(monomials[i], test.letters, rates) for i, c in vector.items()),
                    self.numbers.number(0),
                )
                for rates in test.gradient
            ]
            grown = int(self.numbers.matrix([*span, row], len(row)).rank())
            formula = self._formula(vector, monomials)
            if grown > rank and formula is not None:
                span, rank = [*span, row], grown
                integrals += (
                    ConstraintIntegral(formula, constant_along(self.distribution, formula)),
                )
        return integrals

    def _formula(
        self, vector: Mapping[int, Any], monomials: Sequence[tuple[int, ...]]
    ) -> sp.Expr | None:
        fractions: list[tuple[int, Fraction]] = []
        for i, value in vector.items():
            fraction = self.numbers.fraction(value)
            if fraction is None:
                return None
            fractions.append((i, fraction))
        products = [sp.Mul(*(self.letters[n] for n in monomials[i])) for i, _ in fractions]
        terms = [
            sp.Rational(c.numerator, c.denominator) * product
            for (_, c), product in zip(fractions, products, strict=True)
        ]
        # without a common numerical factor, and with a positive simplest term
        content = sp.Add(*terms).as_content_primitive()[0]
        sign = -1 if fractions[-1][1] < 0 else 1
        return sp.Add(*(sign * term / content for term in terms))


def _named_letters(distribution: Distribution) -> list[sp.Symbol]:
    """Definitions that occur in the constraints or the rates of coordinates."""
    used = {s for row in distribution.forms for entry in row for s in entry.free_symbols}
    used |= {v for field in distribution.frame for v in field.values()}
    constant = {s for s, _ in distribution.constants}
    return [s for s, v in distribution.steps if s in used and v.free_symbols - constant]


def _factors(distribution: Distribution) -> list[sp.Expr]:
    """Sums among the polynomial factors of numerators and denominators in the constraints."""
    own = set(distribution.coordinates)
    factors: set[sp.Expr] = set()
    for entry in {entry for row in distribution.forms for entry in row}:
        for part in sp.fraction(sp.together(entry)):
            if part.is_polynomial(*part.free_symbols) and part.free_symbols & own:
                factors |= {f for f, _ in sp.factor_list(part)[1] if f.is_Add}
    return sorted((f for f in factors if f.free_symbols & own), key=str)


def _arcs(factors: Sequence[sp.Expr], own: set[sp.Symbol]) -> list[sp.Expr]:
    """Arctangents whose derivatives have these denominators, such as atan(x/y) for x² + y²."""
    arcs = []
    for factor in factors:
        for s in sorted(factor.free_symbols & own, key=str):
            if factor.is_Add and sp.degree(factor, s) == 2:
                # ∫ ds/(as² + bs + c) = 2/√D atan((2as + b)/√D) with D = 4ac − b²
                a, b, c = sp.Poly(factor, s).all_coeffs()
                root = sp.sqrt(sp.factor(4 * a * c - b**2)).replace(sp.Abs, lambda x: x)
                if root.is_polynomial(*own) and not root.has(sp.I):
                    arcs.append(sp.atan((2 * a * s + b) / root))
                    break
    return arcs


def _rate(monomial: Sequence[int], letters: Sequence[Any], rates: Sequence[Any]) -> Any:
    """The derivative of a monomial from values and rates of its letters."""
    total = letters[0] * 0
    for i, own in enumerate(monomial):
        product = rates[own]
        if product == 0:
            continue
        for j, other in enumerate(monomial):
            if j != i:
                product = product * letters[other]
        total = total + product
    return total


def _kernel(numbers: Modular, rows: Sequence[Sequence[Any]], width: int) -> list[dict[int, Any]]:
    """A basis of the solutions in echelon form, the simplest one last."""
    reduced, rank = numbers.matrix(rows, width).rref()
    pivots: list[int] = []
    table = [[numbers.number(int(reduced[r, c])) for c in range(width)] for r in range(rank)]
    for row in table:
        pivots.append(next(c for c in range(width) if row[c] != 0))
    basis = []
    for free in (c for c in range(width) if c not in pivots):
        vector = {free: numbers.number(1)}
        vector |= {p: -table[r][free] for r, p in enumerate(pivots) if table[r][free] != 0}
        basis.append([vector.get(c, numbers.number(0)) for c in range(width)])
    if not basis:
        return []
    echelon, _ = numbers.matrix(basis, width).rref()
    return [
        {c: numbers.number(int(echelon[r, c])) for c in range(width) if echelon[r, c] != 0}
        for r in range(len(basis))
    ]
