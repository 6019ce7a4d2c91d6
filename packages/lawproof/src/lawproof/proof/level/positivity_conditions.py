"""Conditions of positivity under which a law is defined.

A formula is positive on a whole level, or the law makes sense only where it is.  What is positive
by its form wherever it is real is left out: roots, exponentials, positive numbers, and squares in
denominators.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import scalars

from ..fields.field import Field, FieldElement
from .level_set import LevelSet

NamedFormula = tuple[str, sp.Expr]


def positive_formulas(law: Law, level: LevelSet) -> tuple[NamedFormula, ...]:
    """Quantities that a law needs to be positive, each in words and as a formula.

    Of an isomorphism it is dτ/dt; of a measure every base of its density that stands under a root,
    so that the density is real.

    Returns
    -------
    tuple of (str, sympy.Expr)
        Formulas in state, definitions and parameters whose signs their forms do not settle; one
        that is a number is negative or zero.
        Where all of them are positive the law makes sense, provided that its formulas are real.
    """
    bases = _bases(law, level, lambda power: not power.is_Integer)
    return tuple((what, formula) for what, formula in bases if formula != 1)


def sign_determining_bases(law: Law, level: LevelSet) -> tuple[NamedFormula, ...]:
    """The bases of a density with odd exponents, which decide its sign.

    Where the product of all of them has one sign, the density or its negative is positive; where it
    has either sign, the measure is a signed one.
    """
    bases = _bases(law, level, lambda power: power.is_Integer and power % 2 == 1)
    return tuple((what, formula) for what, formula in bases if not formula.is_number)


def unmet_conditions(
    law: Law, level: LevelSet, field: Field
) -> tuple[tuple[str, FieldElement], ...]:
    """Quantities that are not positive at a point though a law needs them.

    Raises
    ------
    NotExactError
        If a value is not rational, in `Rationals`.
    ZeroDivisionError
        If a formula has no value at the point, or if a ball leaves the sign open.
    """
    evaluate = level.evaluator(field)
    failures = []
    for what, formula in positive_formulas(law, level):
        value = evaluate.value(formula)
        if value > 0:
            continue
        if not field.exact and not value <= 0:
            raise ZeroDivisionError
        failures.append((what, value))
    return tuple(failures)


def _bases(law: Law, level: LevelSet, meets: Callable[[sp.Expr], bool]) -> Iterator[NamedFormula]:
    """The bases in a law whose exponents, as they are on the level, meet a condition.

    Each in words, and by its factors of unknown sign; a base with exponent zero is left out.
    """
    for words, base, exponent in law.powers:
        power = level.expand(sp.sympify(exponent))
        if power != 0 and meets(power):
            formula = _factors_of_open_sign(_without_rates(base, level), level)
            yield words.format(text(base)) if "{}" in words else words, formula


def _without_rates(formula: sp.Expr, level: LevelSet) -> sp.Expr:
    return level.without_rates(*scalars(formula))


def _factors_of_open_sign(formula: sp.Expr, level: LevelSet) -> sp.Expr:
    """The factors whose signs count: a formula that is positive where the given one is."""
    steps = level.steps
    left = []
    for factor in sp.Mul.make_args(sp.sympify(formula)):
        if factor.is_positive:
            continue
        base, exponent = factor.as_base_exp()
        # with an exponent that is no number, as with a root, it is positive where it is real
        if (
            not exponent.is_Rational
            or exponent.q % 2 == 0
            or (exponent < 0 and exponent.p % 2 == 0)
        ):
            continue
        elif base not in steps or _factors_of_open_sign(steps[base], level) != 1:
            left.append(base if exponent == -1 else factor)
    return sp.Mul(*left)
