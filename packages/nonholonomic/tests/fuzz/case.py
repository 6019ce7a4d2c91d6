"""A law together with the truth about it."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import sympy as sp

from flowlanes.system.laws import Law
from flowlanes.system.system import Guard, Parameter, System

__all__ = ["Case", "Family", "Point", "Truth", "guards", "parameter", "real", "system"]

Truth = Literal["true", "false", "malformed"]
Point = Mapping[sp.Symbol, Any]


@dataclass(frozen=True)
class Case:
    """A system, a law of it, and whether the law holds.

    Parameters
    ----------
    family : str
        The construction it came from.
    make : callable
        Makes the system and the law; it may raise an InputError if one of them is malformed.
    truth : ``"true"``, ``"false"`` or ``"malformed"``
        Malformed: there is nothing to judge, and an InputError has to say so.
    why : str
        One sentence.
    fails_at : mapping of Symbol to number, optional
        Of a false law: an exact point at which it fails.
    refusable : bool
        Whether an InputError is as good an answer as the truth.
    """

    family: str
    make: Callable[[], tuple[System, Law]]
    truth: Truth
    why: str
    fails_at: Point | None = None
    refusable: bool = False


Family = Callable[[random.Random], Case]


def real(names: str) -> Any:
    """Real symbols."""
    return sp.symbols(names, real=True)


def parameter(symbol: sp.Symbol, default: float, *admissible: Any) -> Parameter:
    """A parameter without a meaning."""
    return Parameter(symbol, "", default, admissible=admissible)


def guards(formulas: tuple[sp.Expr, ...]) -> tuple[Guard, ...]:
    """Guards that keep formulas positive."""
    return tuple(Guard(f"guard{i}", f, "the motion ends") for i, f in enumerate(formulas, 1))


def system(field: Mapping[sp.Symbol, Any], **others: Any) -> System:
    """A system without a title."""
    rates = {name: sp.sympify(rate) for name, rate in field.items()}
    return System(name="planted", title="planted", field=rates, **others)
