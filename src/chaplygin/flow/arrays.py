"""Formulas of a System at many states at once, by NumPy: values and slopes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np
import sympy as sp

from ..errors import InputError
from ..system import System
from .graph import Graph, Reader, Term, ordered

__all__ = ["Sheet", "evaluate", "numbers"]

_UFUNCS: Mapping[str, Callable[..., Any]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "neg": np.negative,
    "recip": np.reciprocal,
    "sqrt": np.sqrt,
    "atan2": np.arctan2,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": np.log,
    "abs": np.abs,
    "sign": np.sign,
    "positive": lambda test, yes, no: np.where(test > 0, yes, no),
}


def evaluate(terms: Sequence[Term], states: Any, parameters: Any) -> Any:
    """Terms at states.

    Parameters
    ----------
    terms : sequence of Term
    states : array (size, k)
        Each variable in a row of its own.
    parameters : array (p,)

    Returns
    -------
    array (len(terms), k)
        Not-a-number where a formula has no real value.
    """
    known: dict[int, Any] = {}
    with np.errstate(all="ignore"):
        for node in ordered(terms):
            if node.kind == "state":
                value = states[node.args[0]]
            elif node.kind == "parameter":
                value = parameters[node.args[0]]
            elif node.number is not None:
                value = np.float64(float(node.number))
            else:
                value = _UFUNCS[node.kind](*(known[id(a)] for a in node.args))
            known[id(node)] = value
    made = np.empty((len(terms), states.shape[1]))
    for row, term in zip(made, terms, strict=True):
        row[:] = known[id(term)]
    return made


class Sheet:
    """The formulas of one System as terms, with derivatives in the state.

    Attributes
    ----------
    graph : Graph
    read : Reader
        From a formula to its term.
    state : tuple of Term
        The state variables in flat order.
    """

    def __init__(self, system: System) -> None:
        self.graph = Graph()
        self.read = Reader(system, self.graph)
        self.state = tuple(self.graph.state(i) for i in range(len(system.symbols)))

    def slopes(self, terms: Sequence[Term]) -> list[list[Term]]:
        """The derivatives of terms: one row for each term, one column for each variable."""
        zero, one = self.graph.number(0), self.graph.number(1)
        columns = [
            self.graph.along(terms, {v: one if v is leaf else zero for v in self.state})
            for leaf in self.state
        ]
        return [list(row) for row in zip(*columns, strict=True)]

    def depends(self, terms: Sequence[Term]) -> set[int]:
        """The places of the state variables that occur in terms."""
        return {node.args[0] for node in ordered(terms) if node.kind == "state"}


def numbers(system: System, parameters: Mapping[Any, Any] | None) -> Any:
    """The values of a system's parameters, in order; given ones replace the defaults.

    Parameters
    ----------
    system : System
    parameters : mapping of Symbol or name to float, optional

    Returns
    -------
    array (p,)

    Raises
    ------
    InputError
        If there is no such parameter, or its value is not a finite number.
    """
    places = {str(p.symbol): i for i, p in enumerate(system.parameters)}
    values = np.array([p.default for p in system.parameters], dtype=float)
    for name, value in (parameters or {}).items():
        if str(name) not in places:
            raise InputError(
                f"no parameter {str(name)!r} in {system.name}; it has {', '.join(places) or 'none'}"
            )
        number = float(sp.Float(value)) if isinstance(value, sp.Basic) else float(value)
        if not np.isfinite(number):
            raise InputError(f"{system.name}: {name} = {value}: a finite number is needed")
        values[places[str(name)]] = number
    return values
