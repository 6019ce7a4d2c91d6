"""Conditions on parameters as text: ``I_1 <= I_2 + I_3``, ``a > 1 or a < -1``."""

from __future__ import annotations

import math
import operator
import re
from collections.abc import Callable, Iterable, Mapping
from types import MappingProxyType

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import formula_text
from flowlanes.system.parameters import ROUNDING, Condition, condition_words, conditions
from flowlanes.system.system import Parameter

from .names import Names

_RELATIONS: Mapping[str, Callable[[sp.Expr, sp.Expr], Condition]] = MappingProxyType(
    {"<=": sp.Le, ">=": sp.Ge, "!=": sp.Ne, "==": sp.Eq, "<": sp.Lt, ">": sp.Gt}
)
_RELATION = re.compile(r"<=|>=|!=|==|<|>")


def read_condition(names: Names, text: str, *key: str) -> Condition:
    """A relation of two formulas, or several joined by ``and`` and ``or``.

    Raises
    ------
    InputError
        If it is none; the message names its place.
    """
    # "and" binds more tightly than "or", so that the text is split at "or" first
    for word, join in (("or", sp.Or), ("and", sp.And)):
        parts = re.split(rf"\b{word}\b", text)
        if len(parts) > 1:
            return join(*(read_condition(names, part, *key) for part in parts))
    relations = _RELATION.findall(text)
    if len(relations) != 1:
        raise names.error(
            f"'{text.strip()}' is no condition; it must have one of {', '.join(_RELATIONS)} "
            "between two formulas",
            *key,
        )
    left, right = (names.scalar(side, *key) for side in _RELATION.split(text))
    return _RELATIONS[relations[0]](left, right)


def condition_text(condition: Condition) -> str:
    """The text of a condition, as a file has it."""
    whole = sp.sympify(condition)
    for word, join in ((" or ", sp.Or), (" and ", sp.And)):
        if isinstance(whole, join):
            return word.join(map(condition_text, whole.args))
    left, right = (formula_text(side) for side in whole.args)
    word = "!=" if isinstance(whole, sp.Ne) else whole.rel_op
    return f"{left} {word} {right}"


def fulfilled(conditions: Iterable[Condition], values: Mapping[sp.Symbol, float]) -> bool:
    """Whether numbers fulfil all conditions; where equality is allowed, so is rounding."""
    numbers = {symbol: sp.Float(float(value)) for symbol, value in values.items()}
    return all(_holds(sp.sympify(condition), numbers) for condition in conditions)


def _holds(condition: Condition, numbers: Mapping[sp.Symbol, sp.Float]) -> bool:
    if isinstance(condition, sp.Or | sp.And):
        parts = (_holds(part, numbers) for part in condition.args)
        return any(parts) if isinstance(condition, sp.Or) else all(parts)
    if condition in (sp.true, sp.false):
        return bool(condition)
    left, right = (float(side.xreplace(numbers)) for side in condition.args)
    # a flat body has I_3 = I_1 + I_2, which decimal numbers miss by their last digit
    slack = ROUNDING * (abs(left) + abs(right))
    match condition.rel_op:
        case "<=":
            return left <= right + slack
        case ">=":
            return left >= right - slack
        case word:
            return bool(_COMPARISONS[word](left, right))


_COMPARISONS: Mapping[str, Callable[[float, float], bool]] = MappingProxyType(
    {"<": operator.lt, ">": operator.gt, "==": operator.eq, "!=": operator.ne}
)


def require_fulfilled(
    owner: str, parameters: Iterable[Parameter], further: Iterable[Condition]
) -> None:
    """Refuse values of parameters that break a condition on them.

    Raises
    ------
    InputError
        Naming the parameter and the condition.
    """
    items = tuple(parameters)
    for p in items:
        if not math.isfinite(p.default):
            raise InputError(f"{owner}: {_words(p)} must be a finite number")
    values = {p.symbol: p.default for p in items}
    # conditions on several parameters first, since each of these may be right by itself
    for condition in further:
        if not fulfilled((condition,), values):
            named = sorted(map(str, condition.free_symbols))
            given = ", ".join(f"{p.symbol} = {p.default}" for p in items if str(p.symbol) in named)
            raise InputError(f"{owner}: {given}: {condition_words(condition)} must hold")
    for parameter, condition in conditions(items):
        if not fulfilled((condition,), values):
            raise InputError(
                f"{owner}: {_words(parameter)} is not admissible; "
                f"{condition_words(condition)} must hold"
            )


def _words(parameter: Parameter) -> str:
    """A parameter with its meaning and value, ``mass m = -1.0``."""
    return f"{parameter.meaning} {parameter.symbol} = {parameter.default}".strip()
