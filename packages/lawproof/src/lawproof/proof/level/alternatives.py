"""Case distinctions of a law: ranges of its parameters and factors of its conditions.

The conditions on the parameters may admit several ranges, such as a < −1 or a > 1; a law holds if
it holds in each. A condition such as y sin x = 0 or f(x) y = 0 means that one of its factors
vanishes. Polynomial conditions are decomposed exactly, see :mod:`lawproof.proof.level.components`.
"""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import islice, product

import sympy as sp

from flowlanes.formulas.errors import OutOfReachError
from flowlanes.system.laws import Law
from flowlanes.system.named_formulas import Pairs, expand
from flowlanes.system.parameters import conjuncts
from flowlanes.system.system import Parameter, System

from ..fields.signs import Sign
from .level_set import LevelSet

ONE_TO_ONE = (sp.exp, sp.log, sp.sinh, sp.tanh, sp.asin, sp.acos, sp.atan)

MOST = 32
"""Maximum number of alternatives."""
_SIMPLE = tuple(sp.Rational(s * n, 2) for n in (2, 4, 6, 1, 8, 20, 0, 200) for s in (1, -1))
"""Numbers tried as default values."""


@dataclass(frozen=True)
class Alternative:
    """A part of a level on which certain factors of its conditions vanish.

    Attributes
    ----------
    law : Law
        The law with factors in place of the conditions that have several.
    defining_factors : tuple of sympy.Expr
        The chosen factors of the conditions that have several.
    """

    system: System
    law: Law
    defining_factors: tuple[sp.Expr, ...] = ()


def ranges_of_parameters(system: System) -> tuple[System, ...]:
    """Copies of the system, one for each range of the parameters.

    The union of the ranges is the admissible set; within each, all conditions are conjunctions.
    """
    conditions = [
        c for p in system.parameters for condition in p.admissible for c in conjuncts(condition)
    ]
    if not any(isinstance(condition, sp.Or) for condition in conditions):
        return (system,)
    whole = sp.to_dnf(sp.And(*conditions), simplify=False)
    ranges = [
        each.args if isinstance(each, sp.And) else (each,)
        for each in (whole.args if isinstance(whole, sp.Or) else (whole,))
    ]
    return tuple(
        replace(system, parameters=_within(system.parameters, each))
        for each in ranges
        if not _is_empty(each)
    )


def _is_empty(conditions: Sequence[sp.Basic]) -> bool:
    """True if the conditions on some single parameter contradict each other."""
    alone: dict[sp.Basic, sp.Set] = {}
    for condition in conditions:
        if len(condition.free_symbols) == 1:
            (symbol,) = condition.free_symbols
            with contextlib.suppress(NotImplementedError):
                alone[symbol] = alone.get(symbol, sp.S.Reals) & condition.as_set()
    return sp.S.EmptySet in alone.values()


def _within(
    parameters: tuple[Parameter, ...], conditions: tuple[sp.Basic, ...]
) -> tuple[Parameter, ...]:
    """The parameters with a conjunction of conditions and with defaults that satisfy it.

    A default that violates it is replaced by a simple number if one of a few satisfies it.
    """
    defaults = {p.symbol: sp.Rational(repr(float(p.default))) for p in parameters}
    wrong = sorted(
        {s for c in conditions if c.xreplace(defaults) != sp.true for s in c.free_symbols}, key=str
    )
    for values in islice(product(_SIMPLE, repeat=len(wrong)), len(_SIMPLE) ** 2):
        tried = {**defaults, **dict(zip(wrong, values, strict=True))}
        if all(c.xreplace(tried) == sp.true for c in conditions):
            defaults = tried
            break
    first, *others = (
        replace(p, default=float(defaults[p.symbol]), admissible=()) for p in parameters
    )
    return (replace(first, admissible=conditions), *others)


def alternatives(system: System, law: Law) -> tuple[Alternative, ...]:
    """The parts of the domain and the level that are decided separately."""
    parts = [_of_factors(each, law) for each in ranges_of_parameters(system)]
    return tuple(alternative for part in parts for alternative in part)


def _of_factors(system: System, law: Law) -> tuple[Alternative, ...]:
    steps = dict(system.scalar_definitions)
    conditions = [_in_sight(c, steps) for c in (*system.scalar.relations, *law.scalar.level)]
    factors = [_factors(condition) for condition in conditions]
    changed = False
    if law.pointwise:
        arguments = [tuple(map(_of_equal_arguments, choices)) for choices in factors]
        changed = arguments != factors
        factors = arguments
    if law.of_volume:
        # For measures a non-vanishing factor, such as an exponential, contributes to the density.
        changed = any(len(f) == 1 and f != (c,) for f, c in zip(factors, conditions, strict=True))
    if not changed and all(len(choices) == 1 for choices in factors):
        return (Alternative(system, law),)
    if law.pointwise:
        factors = [_that_may_vanish(system, choices) for choices in factors]
    split = len(system.relations)
    parts = []
    for choice in _few(product(*factors)):
        there = replace(law, level=choice[split:], as_printed=None)
        there = there.weighted(_shares_of_volume(conditions, choice))
        parts.append(
            Alternative(
                replace(system, relations=choice[:split], laws=()),
                there,
                tuple(c for c, choices in zip(choice, factors, strict=True) if len(choices) > 1),
            )
        )
    return tuple(parts)


def _shares_of_volume(conditions: list[sp.Expr], choice: tuple[sp.Expr, ...]) -> Pairs:
    """Volume density of the conditions relative to that of their factors, as powers.

    On the part f = 0 of f g = 0, the volume defined by f g is 1/|g| times that defined by f.
    """
    ratios = [sp.cancel(c / factor) for c, factor in zip(conditions, choice, strict=True)]
    return tuple((g**2, -sp.Rational(1, 2)) for g in ratios if g.free_symbols)


def _of_equal_arguments(condition: sp.Expr) -> sp.Expr:
    """The condition a = b for f(a) = f(b) with injective f; any other condition unchanged."""
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
    """The factors that may vanish on the domain; all of them if none is left."""
    if len(choices) == 1:
        return choices
    domain = LevelSet(replace(system, relations=(), laws=()))
    return tuple(f for f in choices if abs(domain.sign(f)) < Sign.POSITIVE) or choices


def _few(choices: Iterator[tuple[sp.Expr, ...]]) -> Iterator[tuple[sp.Expr, ...]]:
    for number, choice in enumerate(choices):
        if number == MOST:
            raise OutOfReachError(f"the level falls into more than {MOST} parts")
        yield choice


def _in_sight(condition: sp.Expr, steps: Mapping[sp.Symbol, sp.Expr]) -> sp.Expr:
    """A condition with its definitions expanded if they contain functions."""
    written = expand(condition, steps)
    return written if _holds_functions(written) else condition


def _holds_functions(condition: sp.Expr) -> bool:
    """True if a condition contains functions or roots."""
    functions = condition.atoms(sp.Function, sp.Derivative, sp.Subs)
    return bool(functions) or any(not p.exp.is_Integer for p in condition.atoms(sp.Pow))


def _factors(condition: sp.Expr) -> tuple[sp.Expr, ...]:
    """The factors of a condition with functions; a polynomial condition as a single factor."""
    if not _holds_functions(condition):
        return (condition,)
    # Functions and roots are replaced by symbols, so that their arguments are not factored.
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
