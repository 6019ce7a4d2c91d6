"""Parameters of a system: values by symbol or name, and conditions on them."""

from __future__ import annotations

import difflib
import math
from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any, TypeAlias

import numpy as np
import sympy as sp
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean, BooleanFunction

from ..arguments import ParameterValue
from ..errors import InputError
from .system import Parameter, System

#: Values by name or symbol: numbers, or arrays with one entry for each motion.
Parameters: TypeAlias = Mapping[str, ParameterValue] | Mapping[sp.Symbol, ParameterValue]

#: A condition on parameters: a relation, or a truth value.
Condition: TypeAlias = Relational | Boolean

#: Relative difference below which the two sides of a condition count as equal.
ROUNDING = 1e-12


# --- names -----------------------------------------------------------------------------------


def require_parameters(owner: str, parameters: Iterable[object], names: Iterable[object]) -> None:
    """Raise InputError if a name or symbol is not among the parameters of the owner.

    Parameters
    ----------
    owner : str
        Name of the system, for the message.
    parameters : iterable of Symbol or str
        Its parameters.
    names : iterable of Symbol or str
    """
    allowed = list(map(str, parameters))
    for name in names:
        if str(name) not in allowed:
            close = difflib.get_close_matches(str(name), allowed, n=1)
            guess = f" (did you mean {close[0]}?)" if close else ""
            raise InputError(
                f"{owner}: no parameter {name}{guess}; it has {', '.join(allowed) or 'none'}"
            )


def parameters_by_symbol(
    system: System, parameters: Parameters | None
) -> dict[sp.Symbol, ParameterValue]:
    """Parameter values by symbol, from values by symbol or name.

    Raises
    ------
    InputError
        If the system has no parameter of this name.
    """
    if not parameters:
        return {}
    given = {key: value for key, value in parameters.items() if isinstance(key, sp.Symbol)}
    if len(given) == len(parameters) and given.keys() <= system.defaults.keys():
        return given
    symbols = {str(symbol): symbol for symbol in system.defaults}
    require_parameters(system.name, symbols, parameters)
    return {symbols[str(key)]: value for key, value in parameters.items()}


def parameter_values(
    system: System, parameters: Parameters | None
) -> dict[sp.Symbol, ParameterValue]:
    """Values of all parameters by symbol, given or default.

    Raises
    ------
    InputError
        If the system has no parameter of this name.
    """
    return {**system.defaults, **parameters_by_symbol(system, parameters)}


# --- conditions ------------------------------------------------------------------------------


def conditions(parameters: Iterable[Parameter]) -> list[tuple[Parameter, Condition]]:
    """Pairs of a parameter and one of its conditions.

    Conditions on a single parameter come first: if one fails, this parameter is reported, and not
    another one that is compared with it.
    """
    pairs = [(item, part) for item in parameters for c in item.admissible for part in conjuncts(c)]
    return sorted(pairs, key=lambda pair: len(pair[1].free_symbols))


def conjuncts(condition: Condition) -> tuple[Condition, ...]:
    """The conjuncts of a condition: relations, and disjunctions in normal form.

    A disjunction is an `Or` of relations and of conjunctions of them.

    Examples
    --------
    >>> a, b = sp.symbols("a b", real=True)
    >>> conjuncts((b > 0) & ~((a <= 1) & (a >= -1)))
    (b > 0, (a > 1) | (a < -1))
    """
    whole = sp.sympify(condition)
    if whole.has(sp.Not, sp.Xor, sp.Implies, sp.Equivalent, sp.ITE):
        whole = sp.to_nnf(whole, simplify=False)
    # `args` are ordered; `make_args` returns a set.
    parts = whole.args if isinstance(whole, sp.And) else (whole,)
    return tuple(sp.to_dnf(p, simplify=False) if isinstance(p, sp.Or) else p for p in parts)


def condition_words(condition: Condition) -> str:
    """Text of a condition, such as ``(a > 1) or (a < -1)``."""
    return str(condition).replace(" | ", " or ").replace(" & ", " and ")


def satisfies(condition: Condition, numbers: Mapping[sp.Symbol, Any]) -> Any:
    """Truth value of a condition on parameters, for numbers or arrays.

    Conditions with equality tolerate rounding: the moments of inertia of a flat body, one of which
    is the sum of the others, may violate it in their last digits.

    Parameters
    ----------
    condition : SymPy relation
    numbers : mapping of Symbol to number or array
        Values of at least its symbols.

    Returns
    -------
    bool or array of bool
    """
    symbols, check = _check(condition)
    return check(*(numbers[symbol] for symbol in symbols))


def require_finite(system: System, values: Mapping[sp.Symbol, Any]) -> None:
    """Raise InputError if a value is not a finite number."""
    for symbol, value in values.items():
        if not math.isfinite(float(value)):
            raise InputError(f"{system.name}: {symbol} = {value} must be a finite number")


def require_admissible(
    system: System,
    numbers: Mapping[sp.Symbol, Any],
    values: Mapping[sp.Symbol, Any] | None = None,
) -> None:
    """Raise InputError if a condition on the parameters fails.

    Parameters
    ----------
    system : System
    numbers : mapping of Symbol to float or array of float
        Values of all parameters, for one motion or several.
    values : mapping of Symbol to number, optional
        The same values as shown in the message.
    """
    for parameter, condition in conditions(system.parameters):
        if strange := sorted(map(str, condition.free_symbols - numbers.keys())):
            raise InputError(
                f"{system.name}: the condition {condition_words(condition)} on {parameter.symbol} "
                f"uses {', '.join(strange)}, which is no parameter"
            )
        failures = np.flatnonzero(np.logical_not(satisfies(condition, numbers)))
        if not failures.size:
            continue
        value = (values or numbers)[parameter.symbol]
        text = f"{value[failures[0]]:.10g}" if isinstance(value, np.ndarray) else f"{value}"
        raise InputError(
            f"{system.name}: {parameter.symbol} = {text} is not admissible; "
            f"{condition_words(condition)} must hold"
        )


@lru_cache(maxsize=256)
def _check(condition: Condition) -> tuple[list[sp.Symbol], Any]:
    """The symbols of a condition, and a function of them that returns its truth value."""
    relation = _with_rounding(sp.sympify(condition))
    symbols = sorted(relation.free_symbols, key=str)
    return symbols, sp.lambdify(symbols, relation, "numpy")


def _with_rounding(condition: Condition) -> Condition:
    if isinstance(condition, sp.Ge | sp.Le):
        more, less = condition.gts, condition.lts
        return more - less + ROUNDING * (sp.Abs(more) + sp.Abs(less)) >= 0
    if isinstance(condition, BooleanFunction):
        return condition.func(*map(_with_rounding, condition.args))
    return condition
