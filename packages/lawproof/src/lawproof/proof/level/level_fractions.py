"""Fields of fractions on a level, with the signs known there."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TypeVar

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.errors import (
    EmptyLevelError,
    NeedMoreGeneratorsError,
    OutOfReachError,
    UnknownSymbolError,
)
from flowlanes.formulas.jets import Evaluator
from flowlanes.system.parameters import conjuncts

from ..fields.budget import Budget
from ..fields.function_field import FunctionField
from ..fields.quotient_ring import Element, Poly
from ..fields.signs import Sign, Signs
from .level_formulas import LevelFormulas, assumed_relations
from .triangular_set import TriangularSet, numerator, triangle

Kind = TypeVar("Kind", bound=FunctionField)


@dataclass(frozen=True)
class LevelFractions(LevelFormulas):
    """A level with its triangular set and fields of fractions modulo it."""

    @cached_property
    def requirements(self) -> tuple[sp.Expr, ...]:
        """The relations known to hold on the domain."""
        relations = [guard.value > 0 for guard in self.system.scalar.guards if not guard.lift_off]
        for parameter in self.system.parameters:
            for condition in parameter.admissible:
                relations += conjuncts(condition)
        for symbol in self.symbols:
            relations += assumed_relations(symbol)
        if sp.false in relations:
            guards = (g.name for g in self.system.scalar.guards if (g.value > 0) == sp.false)
            what = next((f"the guard {name!r} is positive" for name in guards), "")
            raise InputError(
                f"{self.system.name}: {what or 'what is asked of the parameters holds'} nowhere"
            )
        return tuple(r for r in relations if r != sp.true)

    def sign(self, formula: sp.Expr) -> Sign:
        """The sign of a formula on the domain, as far as it is known."""
        if any(r.func is sp.Gt and r.lhs - r.rhs == formula for r in self.requirements):
            return Sign.POSITIVE
        # Either form, as written or reduced by the conditions, may show a sign that the other
        # hides.
        plain = replace(self, system=replace(self.system, relations=(), laws=()), level=())
        written = replace(plain, equations=None)._sign(formula)
        return self._sign(formula) if written is Sign.UNKNOWN else written

    def _sign(self, formula: sp.Expr) -> Sign:
        spare = 8
        while True:
            field = self.fractions(FunctionField, spare, None, Budget())
            try:
                element = self.evaluator(field).value(formula)
            except NeedMoreGeneratorsError:
                spare *= 2
                continue
            except (OutOfReachError, ZeroDivisionError):
                return Sign.UNKNOWN
            sign = field.signs.of(element.poly)
            for factor, power in element.powers.items():
                if power % 2:
                    sign = sign.times(field.signs.of(field.factors[factor]))
            return sign

    @cached_property
    def _names_of_known_sign(self) -> frozenset[str]:
        """State variables and parameters of known sign."""
        names = set()
        for relation in self.requirements:
            if isinstance(relation, sp.Gt | sp.Ge | sp.Lt | sp.Le) and 0 in relation.args:
                names |= {str(a) for a in relation.args if a.is_Symbol}
        return frozenset(names)

    def signs(self, field: FunctionField) -> Signs:
        """The known signs, in the ring of a field of fractions."""
        return self.signs_with(field, [poly for _, poly, _ in field.relations])

    def signs_with(self, field: FunctionField, conditions: Sequence[Poly]) -> Signs:
        """The known signs on the zero set of given polynomials."""
        return self._signs_in(field, self.evaluator(field), conditions)

    def _signs_in(
        self, field: FunctionField, evaluate: Evaluator, conditions: Sequence[Poly]
    ) -> Signs:
        known: dict[str, Sign] = {}
        facts: list[tuple[Poly, Sign]] = []
        nonzero: list[Poly] = []
        # Signs of single symbols first, since others may follow from them.
        for relation in sorted(self.requirements, key=lambda r: len(r.free_symbols)):
            decided = len(field.decisions)
            poly = _as_polynomial(field, evaluate, relation)
            if len(field.decisions) > decided:
                # The relation was evaluated with a chosen sign under a root, so it proves nothing.
                for key in list(field.decisions)[decided:]:
                    del field.decisions[key]
                continue
            if poly is None or poly.is_constant():
                continue
            if isinstance(relation, sp.Ne):
                nonzero.append(poly)
                continue
            strict = isinstance(relation, sp.StrictGreaterThan | sp.StrictLessThan)
            sign = Sign.POSITIVE if strict else Sign.NOT_NEGATIVE
            if len(poly) == 1 and poly.total_degree() == 1:
                name = next(n for n, d in zip(field.names, poly.degrees(), strict=True) if d)
                own = sign if poly.leading_coefficient() > 0 else Sign(-sign)
                known[name] = max(known.get(name, own), own, key=abs)
            facts.append((poly, sign))
            field.signs = Signs(field.ring, {**field.signs.symbol_signs, **known}, facts, nonzero)
        known = {**field.signs.symbol_signs, **known}
        return Signs(field.ring, known, facts, nonzero, conditions)

    @cached_property
    def _triangle(self) -> TriangularSet:
        draft = FunctionField([str(s) for s in self.generators])
        evaluate = self.evaluator(draft)
        conditions = [
            polynomial_of(draft, evaluate.value(condition), condition)
            for condition in self._settlement[1]
            if condition not in self.zeros
        ]
        names = [str(s) for s in self.generators]
        moving = {str(s) for s in self.system.symbols}
        try:
            return triangle(draft, names, conditions, moving)
        except EmptyLevelError:
            raise self._empty() from None

    def fractions(
        self,
        kind: type[Kind],
        spare: int,
        sample: Mapping[str, float] | None,
        budget: Budget,
        choices: Mapping[str, int] | None = None,
    ) -> Kind:
        """The field of fractions, of the given class, modulo the conditions."""
        field = kind(self._triangle.order, spare, sample, budget, choices)
        for main, terms in self._triangle.relations:
            polynomial = {}
            for named, number in terms.items():
                powers = dict(named)
                polynomial[tuple(powers.get(n, 0) for n in field.names)] = number
            field.impose(main, field.ring.from_dict(polynomial))
        field.signs = self.signs(field)
        return field


def polynomial_of(draft: FunctionField, element: Element, condition: sp.Expr) -> Poly:
    """The polynomial that a condition states to vanish."""
    poly = numerator(draft, element)
    if poly and any(poly.degrees()[: draft.spare]):
        raise OutOfReachError(
            f"the condition {condition} = 0 contains a root or a function; state it as a polynomial"
        )
    return poly


def _as_polynomial(field: FunctionField, evaluate: Evaluator, relation: sp.Basic) -> Poly | None:
    """A polynomial with the sign of greater side minus smaller side; None if there is none.

    Odd powers of a denominator f are replaced by a factor f, which has the same sign.
    """
    if isinstance(relation, sp.Ne):
        formula = relation.lhs - relation.rhs
    elif isinstance(relation, sp.Gt | sp.Ge | sp.Lt | sp.Le):
        formula = relation.gts - relation.lts
    else:
        return None
    try:
        element: Element = evaluate.value(formula)
    except (OutOfReachError, NeedMoreGeneratorsError, UnknownSymbolError, ZeroDivisionError):
        return None
    poly = element.poly
    for number, power in element.powers.items():
        if power % 2:
            poly = poly * field.factors[number]
    if not poly or any(poly.degrees()[: field.spare]):
        return None
    return poly
