"""Level sets: the phase space of a system restricted to a level, in triangular form."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import sympy as sp
from flint import arb, fmpq

from flowlanes.formulas.errors import NotExactError, OutOfReachError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.formulas.number_fields import Balls, Rationals

from ..fields.budget import Budget
from ..fields.function_field import FunctionField
from ..fields.quotient_ring import Poly
from .components import Component, Decomposition
from .level_formulas import conditions_text
from .level_fractions import LevelFractions, polynomial_of
from .sample_points import number_near_default, number_text, point_on_sphere, real_root

DECOMPOSITION = 5_000_000
"""Maximum number of term operations for the components of a level."""

#: A random number, given a default, a generator and whether the sign is known.
Draw: TypeAlias = Callable[[float | None, random.Random, bool], fmpq]


@dataclass(frozen=True)
class LevelSet(LevelFractions):
    """The set on which a law is claimed, with its components and random points."""

    @cached_property
    def components(self) -> tuple[LevelSet, ...]:
        """The components of the level; the level itself if there is only one.

        Raises
        ------
        InputError
            If the level is empty.
        OutOfReachError
            If the decomposition exceeds its limits.
        """
        if self.equations is not None:
            return (self,)
        budget = Budget(effort=DECOMPOSITION)
        draft = FunctionField([str(s) for s in self.symbols], budget=budget)
        evaluate = Evaluator(draft, self._seeds(draft, self.symbols), self._definitions)
        for condition in self.conditions:
            self._check_symbols(condition)
        conditions = [
            polynomial_of(draft, evaluate.value(condition), condition)
            for condition in self.conditions
            if condition not in self.zeros
        ]
        names = [str(s) for s in self.symbols]
        moving = {str(s) for s in self.system.symbols}
        signs = self._signs_in(draft, evaluate, conditions)
        components = Decomposition(draft, names, moving, signs).components(conditions)
        if not components:
            raise self._empty()
        if len(components) == 1 and components[0].equations == tuple(conditions):
            return (self,)
        return tuple(self._component(part) for part in components)

    def _component(self, part: Component) -> LevelSet:
        by_name = {str(s): s for s in self.symbols}

        def formulas(polys: Sequence[Poly]) -> tuple[sp.Expr, ...]:
            return tuple(_as_formula(poly, by_name) for poly in polys)

        equations = (*formulas(part.equations), *self.zeros)
        parent = None
        if part.parent is not None:
            parent = (*formulas(part.parent.equations), *self.zeros)
        return LevelSet(
            self.system, self.level, equations, parent, formulas(part.defining_factors), part.inner
        )

    def point(
        self, generator: random.Random, draw: Draw = number_near_default
    ) -> tuple[dict[str, fmpq | arb], bool]:
        """A random point that satisfies the conditions, and whether it is exactly rational.

        If the level has several components, the point lies on the first.

        Parameters
        ----------
        draw : callable
            Draws the free numbers, from a default and the generator.

        Raises
        ------
        OutOfReachError
            If no point was found.
        """
        component: LevelSet = self._first_component
        for _ in range(60):
            try:
                return component._try_point(generator, draw)
            except ZeroDivisionError:
                continue
        raise OutOfReachError(f"no real point was found on the level {conditions_text(self.level)}")

    @cached_property
    def _first_component(self) -> LevelSet:
        """The first component; the level itself if it cannot be decomposed."""
        try:
            return self.components[0]
        except OutOfReachError:
            return self

    def _try_point(
        self, generator: random.Random, draw: Draw
    ) -> tuple[dict[str, fmpq | arb], bool]:
        names, chain = self._triangle.order, self._triangle.relations
        mains = {main for main, _ in chain}
        values: dict[str, fmpq | arb] = {}
        for main, terms in chain:
            values |= point_on_sphere(main, terms, (mains - {main}) | {*values}, generator) or {}
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        exchanged = {str(s) for s in self.generators if s in self._definitions}
        involved = {n for _, terms in chain for named in terms for n, power in named if power}
        for name in names:
            if name in mains or name in values:
                continue
            if name not in exchanged:
                values[name] = draw(
                    defaults.get(name), generator, name in self._names_of_known_sign
                )
            elif name in involved:
                values[name] = fmpq(generator.randint(20, 40), 20)
        exact = True
        for main, terms in chain:
            if main not in values:
                values[main] = real_root(main, terms, values, generator)
                exact = exact and isinstance(values[main], fmpq)
        return self._with_exchanged(values, generator, draw, exact)

    def _with_exchanged(
        self, values: dict[str, fmpq | arb], generator: random.Random, draw: Draw, exact: bool
    ) -> tuple[dict[str, fmpq | arb], bool]:
        """The point with the replaced parameters drawn near their defaults."""
        defaults = {str(p.symbol): p.default for p in self.system.parameters}
        known = {
            str(s): s for s in (*self.generators, *(e.parameter for e in self.swapped_generators))
        }
        known_values = {known[name]: value for name, value in values.items()}
        for change in self.swapped_generators:
            if change.name not in known_values:
                name = str(change.parameter)
                known_values[change.parameter] = draw(
                    defaults[name], generator, name in self._names_of_known_sign
                )
        own = [s for s in self.generators if s in self._definitions]
        names = [s for s in own if s not in known_values]
        for rational in (True, False) if exact else (False,):
            numbers = {str(s): v for s, v in known_values.items()}
            field = self.numbers(numbers, rational)
            jets = {s: Jet(field.generator(str(s)), {}) for s in known_values}
            evaluate = Evaluator(field, jets.get, self.steps)
            try:
                exchanged = {str(n): evaluate.value(n) for n in names}
            except NotExactError:
                continue
            # Include the parameters that were drawn in place of generators.
            drawn = {n: v for n, v in numbers.items() if n not in values}
            return {**drawn, **values, **exchanged}, rational
        raise ZeroDivisionError

    def inside(self, values: Mapping[str, fmpq | arb], exact: bool) -> bool:
        """True if a point satisfies the guards and the conditions on the parameters."""
        for rational in (True, False) if exact else (False,):
            field = self.numbers(values, rational)
            evaluate = self.evaluator(field)
            try:
                return all(certain(condition, evaluate) for condition in self.requirements)
            except NotExactError:
                continue
            except (ZeroDivisionError, OutOfReachError):
                return False
        return False

    def point_shown(self, field: Rationals | Balls) -> dict[str, str]:
        """Texts of state and parameters at a point."""
        evaluate = self.evaluator(field)
        return {str(s): number_text(evaluate.value(s)) for s in self.symbols}

    def roots(self, values: Mapping[str, fmpq | arb]) -> dict[str, dict[str, object]]:
        """The irrational main variables at a point, as roots of polynomials.

        Each is given by a polynomial, with the rational values substituted, and an interval that
        contains one root.
        """
        roots: dict[str, dict[str, object]] = {}
        for main, terms in self._triangle.relations:
            value = values[main]
            if isinstance(value, fmpq):
                continue
            polynomial: dict[tuple[tuple[str, int], ...], fmpq] = {}
            for named, coefficient in terms.items():
                number, left = coefficient, []
                for name, power in named:
                    own = values[name] if power else None
                    if isinstance(own, fmpq):
                        number = number * own**power
                    elif power:
                        left.append((name, power))
                polynomial[tuple(left)] = polynomial.get(tuple(left), fmpq(0)) + number
            names = list(dict.fromkeys(name for left in polynomial for name, _ in left))
            texts = [
                [str(number), [x for name, power in left for x in (names.index(name), power)]]
                for left, number in polynomial.items()
                if number
            ]
            roots[main] = {
                "poly": {"ring": names, "terms": texts},
                "near": value.mid().str(60, radius=False),
                "radius": "1e-50",
            }
        return roots


def _as_formula(poly: Poly, by_name: Mapping[str, sp.Symbol]) -> sp.Expr:
    """A polynomial as a SymPy expression."""
    names = poly.context().names()
    return sp.Add(
        *(
            sp.Rational(int(number.p), int(number.q))
            * sp.Mul(*(by_name[n] ** int(e) for n, e in zip(names, exponents, strict=True) if e))
            for exponents, number in poly.to_dict().items()
        )
    )


def certain(condition: sp.Basic, evaluate: Evaluator) -> bool:
    """True if a condition certainly holds at the point of an evaluator."""
    if isinstance(condition, sp.Or):
        return any(certain(part, evaluate) for part in condition.args)
    if isinstance(condition, sp.And):
        return all(certain(part, evaluate) for part in condition.args)
    return _holds(condition, evaluate.value(condition.lhs - condition.rhs))


def _holds(relation: sp.Basic, difference: fmpq | arb) -> bool:
    """True if a relation certainly holds, given the difference of its sides."""
    exact = isinstance(difference, fmpq)
    if isinstance(relation, sp.Ne):
        return bool(difference != 0) if isinstance(difference, fmpq) else 0 not in difference
    if isinstance(relation, sp.Eq):
        return exact and bool(difference == 0)
    if isinstance(relation, sp.Gt | sp.Ge):
        return bool(difference > 0 or (exact and relation.func is sp.Ge and difference == 0))
    if isinstance(relation, sp.Lt | sp.Le):
        return bool(difference < 0 or (exact and relation.func is sp.Le and difference == 0))
    return False
