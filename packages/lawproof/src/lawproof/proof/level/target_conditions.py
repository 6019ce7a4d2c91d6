"""Conditions of an isomorphism on the parameters of its target.

The target is defined only for its admissible parameters. An isomorphism states nothing where it
maps the parameters to inadmissible values, or where time would run backwards.
"""

from __future__ import annotations

from typing import TypeGuard

import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law
from flowlanes.system.parameters import conjuncts

from ..fields.field import Field
from ..fields.signs import Sign
from .level_set import LevelSet, certain
from .named_formulas import components


def has_target(law: Law) -> TypeGuard[Isomorphism]:
    """True if a law maps to another system, which imposes conditions on its parameters."""
    return isinstance(law, Isomorphism)


def target_conditions(law: Law, level: LevelSet) -> tuple[sp.Basic, ...]:
    """The conditions on the parameters of the target, in terms of the source system.

    Conditions that are true are left out; false ones are kept.
    """
    if not has_target(law):
        return ()
    values = components(law.constants, level)
    asked: list[sp.Basic] = []
    for parameter in law.target.parameters:
        for condition in parameter.admissible:
            asked += conjuncts(sp.sympify(condition).xreplace(values))
    return tuple(dict.fromkeys(c for c in asked if c != sp.true))


def is_admissible_target(law: Law, level: LevelSet, field: Field) -> bool:
    """True if the parameters of the target are certainly admissible at a point."""
    evaluate = level.evaluator(field)
    return all(
        condition != sp.false and certain(condition, evaluate)
        for condition in target_conditions(law, level)
    )


def open_conditions(law: Law, level: LevelSet) -> tuple[sp.Basic, ...]:
    """The conditions on the parameters of the target that are not known to hold."""
    return tuple(c for c in target_conditions(law, level) if not _is_known(c, level))


def _is_known(condition: sp.Basic, level: LevelSet) -> bool:
    if condition in level.requirements or _by_assumptions(condition, level) == sp.true:
        return True
    if isinstance(condition, sp.Or):
        return any(_is_known(part, level) for part in condition.args)
    if isinstance(condition, sp.And):
        return all(_is_known(part, level) for part in condition.args)
    if isinstance(condition, sp.Gt | sp.Lt):
        return level.sign(condition.gts - condition.lts) is Sign.POSITIVE
    if isinstance(condition, sp.Ge | sp.Le):
        sign = level.sign(condition.gts - condition.lts)
        return sign >= Sign.NOT_NEGATIVE
    if isinstance(condition, sp.Ne):
        return abs(level.sign(condition.lhs - condition.rhs)) == Sign.POSITIVE
    return False


def _by_assumptions(condition: sp.Basic, level: LevelSet) -> sp.Basic:
    """A condition with definitions expanded and known signs of parameters substituted."""
    assumed = {
        sp.Gt: {"positive": True},
        sp.Lt: {"negative": True},
        sp.Ge: {"nonnegative": True},
        sp.Le: {"nonpositive": True},
        sp.Ne: {"nonzero": True},
    }
    names: dict[sp.Symbol, sp.Symbol] = {}
    for known in level.requirements:
        if type(known) not in assumed:
            continue
        left, right = known.args
        if left.is_Symbol and right == 0:
            names.setdefault(left, sp.Dummy(str(left), real=True, **assumed[type(known)]))
    written = [level.expand(side).xreplace(names) for side in condition.args]
    if isinstance(condition, sp.Ne):
        # A quotient is non-zero if and only if its numerator is.
        above, _ = sp.fraction(sp.together(written[0] - written[1]))
        return sp.Ne(above, 0)
    return condition.func(*written)
