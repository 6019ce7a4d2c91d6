"""Conditions of positivity under which a law is defined.

A formula is positive on a whole level, or the law makes sense only where it is.  What is positive
by its form wherever it is real is left out: roots, exponentials, positive numbers, and squares in
denominators.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from flowlanes.printing.formula import text
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law, Measure
from flowlanes.system.vectors import to_components

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
    bases: list[NamedFormula] = []
    match law:
        case Isomorphism():
            bases = [("dτ/dt", _without_rates(law.time, level))]
        case Measure():
            bases = [
                (f"the base {text(base)} of the density", formula)
                for base, formula, power in _density_bases(law, level)
                if not power.is_Integer
            ]
    settled = ((what, _factors_of_open_sign(formula, level)) for what, formula in bases)
    return tuple((what, formula) for what, formula in settled if formula != 1)


def sign_determining_bases(law: Law, level: LevelSet) -> tuple[NamedFormula, ...]:
    """The bases of a density with odd exponents, which decide its sign.

    Where the product of all of them has one sign, the density or its negative is positive; where it
    has either sign, the measure is a signed one.
    """
    if not isinstance(law, Measure):
        return ()
    bases = (
        (f"the base {text(base)} of the density", _factors_of_open_sign(formula, level))
        for base, formula, power in _density_bases(law, level)
        if power.is_Integer and power % 2
    )
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


def _density_bases(law: Measure, level: LevelSet) -> Iterator[tuple[sp.Expr, sp.Expr, sp.Expr]]:
    """Base as given, base without rates, and exponent on the level; none of exponent zero."""
    for base, exponent in law.density:
        power = level.expand(sp.sympify(exponent))
        if power != 0:
            yield base, _without_rates(base, level), power


def _without_rates(formula: sp.Expr, level: LevelSet) -> sp.Expr:
    return level.without_rates(to_components(sp.sympify(formula)))


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
