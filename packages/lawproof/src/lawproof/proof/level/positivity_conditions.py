"""Positivity conditions under which a law is defined.

Left out are factors that are positive by their form wherever they are real: roots, exponentials,
positive numbers, and squares in denominators.
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
    """Quantities that must be positive for a law, each in words and as a formula.

    For an isomorphism this is dτ/dt; for a measure, every base of its density with a fractional
    exponent, so that the density is real.

    Returns
    -------
    tuple of (str, sympy.Expr)
        Formulas in state, definitions and parameters whose signs are not determined by their form;
        a formula that is a number is negative or zero. Where all are positive the law is defined,
        provided that its formulas are real.
    """
    bases = _bases(law, level, lambda power: not power.is_Integer)
    return tuple((what, formula) for what, formula in bases if formula != 1)


def sign_determining_bases(law: Law, level: LevelSet) -> tuple[NamedFormula, ...]:
    """The bases of a density with odd exponents, which determine its sign.

    If their product has one sign, the density or its negative is positive; otherwise the measure
    is signed.
    """
    bases = _bases(law, level, lambda power: power.is_Integer and power % 2 == 1)
    return tuple((what, formula) for what, formula in bases if not formula.is_number)


def unmet_conditions(
    law: Law, level: LevelSet, field: Field
) -> tuple[tuple[str, FieldElement], ...]:
    """Quantities that a law needs to be positive but are not at a point.

    Raises
    ------
    NotExactError
        If a value is irrational, in `Rationals`.
    ZeroDivisionError
        If a formula is undefined at the point, or a ball contains zero.
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
    """The bases of a law whose exponents on the level satisfy a condition.

    Each in words, and by its factors of unknown sign; exponents equal to zero are left out.
    """
    for words, base, exponent in law.powers:
        power = level.expand(sp.sympify(exponent))
        if power != 0 and meets(power):
            formula = _factors_of_open_sign(_without_rates(base, level), level)
            yield words.format(text(base)) if "{}" in words else words, formula


def _without_rates(formula: sp.Expr, level: LevelSet) -> sp.Expr:
    return level.without_rates(*scalars(formula))


def _factors_of_open_sign(formula: sp.Expr, level: LevelSet) -> sp.Expr:
    """The product of the factors of unknown sign, positive exactly where the formula is."""
    steps = level.steps
    left = []
    for factor in sp.Mul.make_args(sp.sympify(formula)):
        if factor.is_positive:
            continue
        base, exponent = factor.as_base_exp()
        # A fractional or symbolic power is positive wherever it is real.
        if (
            not exponent.is_Rational
            or exponent.q % 2 == 0
            or (exponent < 0 and exponent.p % 2 == 0)
        ):
            continue
        elif base not in steps or _factors_of_open_sign(steps[base], level) != 1:
            left.append(base if exponent == -1 else factor)
    return sp.Mul(*left)
