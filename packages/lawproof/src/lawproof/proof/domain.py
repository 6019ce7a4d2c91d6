"""Divisors and radicands of a law, as elements of a field.

The certificate checker finds these formulas by itself; the certificate gives the factorisation of
each.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence

import sympy as sp

from certificate_checker.claim.claim import Claim as CheckedClaim
from certificate_checker.claim.domain import GRAM, domain
from certificate_checker.claim.formulas import Formula
from certificate_checker.claim.parsing import parse
from flowlanes.formulas.errors import OutOfReachError, UnknownSymbolError
from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.system.formula_text import short_text
from flowlanes.system.laws import Law, Rate

from .fields.field import dot
from .fields.quotient_ring import Element
from .fields.unreduced_fields import UnreducedField
from .level.level_set import LevelSet
from .level.named_formulas import quantities_in_order
from .level.target_conditions import has_target
from .residuals import target_state

#: Formula, side ("own" or "target"), value, and whether it must be positive.
Divisor = tuple[str, str, Element, bool]
_Value = Callable[[Formula], tuple[str, Element]]


def divisors(
    claim: CheckedClaim, law: Law, level: LevelSet, field: UnreducedField
) -> Iterator[Divisor]:
    """All divisors and radicands of a law that have a value in the field."""
    settled = {
        str(s): parse(short_text(v), "a settled parameter")
        for s, v in level.fixed_parameters.items()
    }
    own_domain = domain(claim, settled)
    positive = dict.fromkeys(
        [*((where, f) for where, f, _ in own_domain.positive), *own_domain.logarithms]
    )
    places = {"own": _own(law, level, field), "target": _target(law, level, field)}
    for where, formula in dict.fromkeys([*own_domain.nonzero, *positive]):
        seen = set()
        for place in places[where]:
            try:
                written, value = place(formula)
            except (OutOfReachError, UnknownSymbolError, ZeroDivisionError):
                continue
            form = str(value.poly), tuple(sorted(value.powers.items()))
            if value.poly and form not in seen:
                seen.add(form)
                yield written, where, value, (where, formula) in positive
            if (where, formula) in positive:
                break
    if own_domain.gram:
        for value in _volumes(level, field):
            yield GRAM, "own", value, False


def _own(law: Law, level: LevelSet, field: UnreducedField) -> list[_Value]:
    """Evaluators with and without time derivatives, which may give different forms."""
    quantities = quantities_in_order(law, level)
    evaluators = (level.along(field), level.evaluator(field), level.partial(field))
    return [_value(level, quantities, e.with_steps(quantities)) for e in evaluators]


def _value(level: LevelSet, quantities: Mapping[sp.Symbol, sp.Expr], evaluate: Evaluator) -> _Value:
    table = {**level.symbols_by_name, **{str(s): s for s in quantities}}

    def value(formula: Formula) -> tuple[str, Element]:
        made_of = sympy_formula(formula, table)
        return short_text(made_of), evaluate.value(level.without_second_rates(made_of, quantities))

    return value


def _target(law: Law, level: LevelSet, field: UnreducedField) -> list[_Value]:
    if not has_target(law):
        return []
    along = level.along(field)
    seeds = {s: Jet(jet.value, {}) for s, jet in target_state(law, level, along).items()}
    there = Evaluator(field, seeds.get, dict(law.target.scalar_definitions))
    table = {str(s): s for s in (*seeds, *(s for s, _ in law.target.scalar_definitions))}

    def value(formula: Formula) -> tuple[str, Element]:
        made_of = sympy_formula(formula, table)
        return short_text(made_of), there.value(made_of)

    return [value]


def _volumes(level: LevelSet, field: UnreducedField) -> Iterator[Element]:
    """The leading principal minors of the Gram matrix of the gradients."""
    partial = level.partial(field)
    symbols = level.system.symbols
    normals = [[partial.value(sp.diff(c, s)) for s in symbols] for c in level.moving]
    rows = [[dot(field.zero, a, b) for b in normals] for a in normals]
    for size in range(1, len(rows) + 1):
        yield _determinant(field, [row[:size] for row in rows[:size]])


def _determinant(field: UnreducedField, rows: Sequence[Sequence[Element]]) -> Element:
    # Laplace expansion needs no divisions; the matrices are small.
    if not rows:
        return field.one
    total = field.zero
    for j, entry in enumerate(rows[0]):
        minor = [[x for i, x in enumerate(row) if i != j] for row in rows[1:]]
        part = entry * _determinant(field, minor)
        total = total + part if j % 2 == 0 else total - part
    return total


def sympy_formula(formula: Formula, table: Mapping[str, sp.Symbol]) -> sp.Expr:
    """A formula of the checker as a SymPy expression."""
    parts = [sympy_formula(part, table) for part in formula.parts]
    if formula.kind == "number":
        return sp.Rational(formula.word.numerator, formula.word.denominator)
    if formula.kind == "name":
        return table.get(formula.word, sp.pi) if formula.word == "pi" else table[formula.word]
    if formula.kind == "sum":
        return sp.Add(*parts)
    if formula.kind == "product":
        return sp.Mul(*parts)
    if formula.kind == "power":
        return sp.Pow(*parts)
    if formula.kind == "call":
        return Rate(*parts) if formula.word == "Rate" else getattr(sp, formula.word)(*parts)
    word, orders = formula.word
    function = sp.Function(word)
    if not any(orders):
        return function(*parts)
    places = [sp.Symbol(f"place_{i}", real=True) for i in range(len(parts))]
    counted = [(p, n) for p, n in zip(places, orders, strict=True) if n]
    return sp.Subs(sp.Derivative(function(*places), *counted), places, parts)
