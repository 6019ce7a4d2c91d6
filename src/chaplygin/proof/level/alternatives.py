"""Conditions with functions that are products: one alternative for each factor.

A condition such as y sin x = 0 or f(x) y = 0 says that one of its factors vanishes.  Conditions
that are polynomials are decomposed exactly, see :mod:`chaplygin.proof.level.components`.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

import sympy as sp

from ...core.laws import Identity, Integral, Law, Measure
from ...core.system import System
from ...core.vectors import to_components
from ...formulas.errors import OutOfReachError
from ..fields.signs import Sign
from .level_set import LevelSet

#: Laws that say of the points of a level alone what holds there, not of the conditions.
POINTWISE = (Identity, Integral)

ONE_TO_ONE = (sp.exp, sp.log, sp.sinh, sp.tanh, sp.asin, sp.acos, sp.atan)

MOST = 32
"""Alternatives that are followed."""


@dataclass(frozen=True)
class Alternative:
    """A part of a level on which certain factors of its conditions vanish.

    Attributes
    ----------
    law : Law
        With factors in place of the conditions they are factors of.
    defining_factors : tuple of sympy.Expr
        The factors, of those conditions that have several.
    """

    system: System
    law: Law
    defining_factors: tuple[sp.Expr, ...] = ()


def alternatives(system: System, law: Law) -> tuple[Alternative, ...]:
    """The parts of the level of a law that its conditions with functions distinguish."""
    conditions = [to_components(c) for c in (*system.relations, *law.on)]
    factors = [_factors(condition) for condition in conditions]
    changed = False
    if isinstance(law, POINTWISE):
        arguments = [tuple(map(_of_equal_arguments, choices)) for choices in factors]
        changed = arguments != factors
        factors = arguments
    if not changed and all(len(choices) == 1 for choices in factors):
        return (Alternative(system, law),)
    if isinstance(law, POINTWISE):
        factors = [_that_may_vanish(system, choices) for choices in factors]
    split = len(system.relations)
    parts = []
    for choice in _first(product(*factors)):
        there = replace(law, on=choice[split:], as_printed=None)
        if isinstance(there, Measure):
            there = _among(there, conditions, choice)
        parts.append(
            Alternative(
                replace(system, relations=choice[:split], laws=()),
                there,
                tuple(c for c, choices in zip(choice, factors, strict=True) if len(choices) > 1),
            )
        )
    return tuple(parts)


def _among(law: Measure, conditions: list[sp.Expr], choice: tuple[sp.Expr, ...]) -> Measure:
    """A measure for the volume that factors cut out in place of the conditions.

    Where f = 0 is a part of f g = 0, the volume that f g cuts out is 1/|g| times that of f.
    """
    ratios = [sp.cancel(c / factor) for c, factor in zip(conditions, choice, strict=True)]
    more = tuple((g**2, -sp.Rational(1, 2)) for g in ratios if g.free_symbols)
    return replace(law, density=(*law.density, *more))


def _of_equal_arguments(condition: sp.Expr) -> sp.Expr:
    """The condition f(a) = f(b) of a one-to-one function as a = b; any other as it is."""
    constant, terms = condition.as_coeff_add()
    if len(terms) == 1 and constant != 0 and isinstance(-terms[0] / constant, sp.exp):
        return (-terms[0] / constant).args[0]
    if constant != 0 or len(terms) != 2:
        return condition
    (number, first), (other, second) = (term.as_coeff_Mul() for term in terms)
    if isinstance(first, ONE_TO_ONE) and first.func == second.func and number == -other:
        return first.args[0] - second.args[0]
    return condition


def _that_may_vanish(system: System, choices: tuple[sp.Expr, ...]) -> tuple[sp.Expr, ...]:
    """The factors whose signs on the domain leave it open; all of them if none is left."""
    if len(choices) == 1:
        return choices
    domain = LevelSet(replace(system, relations=(), laws=()))
    return tuple(f for f in choices if abs(domain.sign(f)) < Sign.POSITIVE) or choices


def _first(choices: Iterator[tuple[sp.Expr, ...]]) -> Iterator[tuple[sp.Expr, ...]]:
    for number, choice in enumerate(choices):
        if number == MOST:
            raise OutOfReachError(f"the level falls into more than {MOST} parts")
        yield choice


def _factors(condition: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of a condition with functions; a polynomial condition itself."""
    functions = condition.atoms(sp.Function, sp.Derivative, sp.Subs)
    roots = any(not power.exp.is_Integer for power in condition.atoms(sp.Pow))
    if not functions and not roots:
        return (condition,)
    # functions and roots are symbols here: they are factored with, not into
    names = {
        part: sp.Dummy(real=True)
        for part in sp.preorder_traversal(condition)
        if isinstance(part, sp.Function | sp.Derivative | sp.Subs)
        or (part.is_Pow and not part.exp.is_Integer)
    }
    above, _ = sp.fraction(sp.together(condition.xreplace(names)))
    back = {symbol: part for part, symbol in names.items()}
    factors = []
    for part in sp.Mul.make_args(sp.factor(above)):
        factor = part.xreplace(back)
        base = factor.base if factor.is_Pow and factor.exp.is_positive else factor
        if not base.is_number and not isinstance(base, sp.exp):
            factors.append(base)
    return tuple(dict.fromkeys(factors)) or (condition,)
