"""Whether parameters satisfy what is asked of them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import lru_cache
from typing import Any

import sympy as sp

from ..errors import InputError
from .system import Parameter, System

__all__ = ["conditions", "parameters_by_symbol", "require_parameters", "satisfies"]

#: Two sides of a condition that differ by this share of them are equal.
ROUNDING = 1e-12


def conditions(parameters: Iterable[Parameter]) -> list[tuple[Parameter, Any]]:
    """Parameters with a condition of each, as often as they have some.

    Conditions on one parameter alone come first: where one of them fails, that parameter is wrong,
    and not another one that is compared with it.
    """
    found = [(item, sp.sympify(condition)) for item in parameters for condition in item.admissible]
    return sorted(found, key=lambda pair: len(pair[1].free_symbols))


def satisfies(condition: Any, numbers: Mapping[sp.Symbol, Any]) -> Any:
    """Where a condition on parameters holds.

    Where it allows equality, so does rounding: the moments of inertia of a flat body, of which one
    is the sum of the others, may miss this in their last digits.

    Parameters
    ----------
    condition : SymPy relation
    numbers : mapping of Symbol to number or array
        Values of its symbols at least.

    Returns
    -------
    bool or array of bool
    """
    symbols, check = _check(condition)
    return check(*(numbers[symbol] for symbol in symbols))


def parameters_by_symbol(
    system: System, parameters: Mapping[Any, Any] | None
) -> dict[sp.Symbol, Any]:
    """Values that are given by symbol or name, by the symbols of the system.

    Raises
    ------
    InputError
        If the system has no parameter of a name.
    """
    require_parameters(system, parameters)
    symbols = {str(item.symbol): item.symbol for item in system.parameters}
    return {symbols[str(key)]: value for key, value in (parameters or {}).items()}


def require_parameters(system: System, parameters: Mapping[Any, Any] | None) -> None:
    """Raise InputError if one of the names, or symbols, is none of a parameter of the system."""
    known = [str(item.symbol) for item in system.parameters]
    for key in parameters or {}:
        if str(key) not in known:
            raise InputError(
                f"{system.name}: no parameter {key}; it has {', '.join(known) or 'none'}"
            )


@lru_cache(maxsize=256)
def _check(condition: Any) -> tuple[list[sp.Symbol], Any]:
    """The symbols of a condition, and whether it holds as a function of them."""
    asked = sp.sympify(condition)
    if isinstance(asked, sp.Ge | sp.Le):
        more, less = asked.gts, asked.lts
        asked = more - less + ROUNDING * (sp.Abs(more) + sp.Abs(less)) >= 0
    symbols = sorted(asked.free_symbols, key=str)
    return symbols, sp.lambdify(symbols, asked, "numpy")
