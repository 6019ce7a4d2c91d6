"""Formulas of a System as numbers at many states, with their derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from ..errors import InputError
from ..system import System
from ..vectors import explicit
from .graph import Graph, Reader, Term, ordered

__all__ = ["Formulas", "parameter_values"]

#: What the operations of a graph are in NumPy.
OPERATIONS: Mapping[str, Callable[..., Any]] = {
    "add": np.add,
    "sub": np.subtract,
    "mul": np.multiply,
    "neg": np.negative,
    "recip": lambda a: 1.0 / a,
    "sqrt": np.sqrt,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "asin": np.arcsin,
    "acos": np.arccos,
    "atan": np.arctan,
    "atan2": np.arctan2,
    "sinh": np.sinh,
    "cosh": np.cosh,
    "tanh": np.tanh,
    "exp": np.exp,
    "log": np.log,
    "abs": np.abs,
    "sign": np.sign,
    "positive": lambda test, yes, no: np.where(test > 0.0, yes, no),
}


@dataclass(frozen=True)
class Formulas:
    """Scalar formulas in state, definitions and parameters of a System.

    Parameters
    ----------
    system : System
    formulas : sequence of sympy.Expr

    Raises
    ------
    InputError
        When a formula is first evaluated that has a name of neither kind, or an unknown function.
    """

    system: System
    formulas: Sequence[Any]

    def __call__(self, states: Any, parameters: Mapping[Any, Any] | None = None) -> Any:
        """The formulas at states.

        Parameters
        ----------
        states : array (..., size)
            In flat order.
        parameters : mapping of Symbol or name to number or array (...), optional
            Values that replace the defaults.

        Returns
        -------
        array (..., formulas)
        """
        return self._evaluated(self._terms, states, parameters)

    def slopes(self, states: Any, parameters: Mapping[Any, Any] | None = None) -> Any:
        """Their derivatives with respect to the state.

        Returns
        -------
        array (..., formulas, size)
        """
        flat = self._evaluated(self._slope_terms, states, parameters)
        return flat.reshape(*flat.shape[:-1], len(self.formulas), len(self.system.symbols))

    @cached_property
    def _terms(self) -> list[Term]:
        known = {*self.system.symbols, *self.system.defaults, *dict(self.system.steps)}
        for formula in self.formulas:
            strange = sorted(map(str, explicit(formula).free_symbols - known))
            if strange:
                raise InputError(
                    f"{self.system.name}: the formula {formula} uses {', '.join(strange)}, which "
                    "is neither a state variable, a definition nor a parameter"
                )
        reader = Reader(self.system, Graph())
        return [reader(formula) for formula in self.formulas]

    @cached_property
    def _slope_terms(self) -> list[Term]:
        if not self._terms:
            return []
        graph = self._terms[0].graph
        size = len(self.system.symbols)
        columns = [
            graph.along(
                self._terms,
                {graph.state(i): graph.number(int(i == j)) for i in range(size)},
            )
            for j in range(size)
        ]
        return [term for row in zip(*columns, strict=True) for term in row]

    def _evaluated(
        self, terms: Sequence[Term], states: Any, parameters: Mapping[Any, Any] | None
    ) -> Any:
        points = np.asarray(states, dtype=float)
        numbers = parameter_values(self.system, parameters)
        made = np.empty((*points.shape[:-1], len(terms)))
        known: dict[int, Any] = {}
        # a place where a formula is infinite or undefined is told by its value
        with np.errstate(all="ignore"):
            for node in ordered(terms):
                known[id(node)] = _value(node, points, numbers, known)
        for i, term in enumerate(terms):
            made[..., i] = known[id(term)]
        return made

    def __getstate__(self) -> dict[str, Any]:
        # terms are told apart by their identity, which another process does not keep
        return {"system": self.system, "formulas": self.formulas}


def _value(node: Term, points: Any, numbers: Sequence[Any], known: Mapping[int, Any]) -> Any:
    match node.kind:
        case "state":
            return points[..., node.args[0]]
        case "parameter":
            return numbers[node.args[0]]
        case "number":
            return float(node.args[0])
        case kind:
            return OPERATIONS[kind](*(known[id(a)] for a in node.operands))


def parameter_values(system: System, parameters: Mapping[Any, Any] | None) -> list[Any]:
    """Values of all parameters, in order; those not given have their defaults.

    Parameters
    ----------
    system : System
    parameters : mapping of Symbol or name to number or array, optional

    Raises
    ------
    InputError
        If a name is no parameter of the system.
    """
    given = {str(name): value for name, value in (parameters or {}).items()}
    names = [str(item.symbol) for item in system.parameters]
    strange = sorted(given.keys() - set(names))
    if strange:
        raise InputError(
            f"{system.name} has no parameter {', '.join(strange)}; it has {', '.join(names)}"
            if names
            else f"{system.name} has no parameters, and {', '.join(strange)} was given"
        )
    return [
        np.asarray(given.get(name, item.default), dtype=float)
        for name, item in zip(names, system.parameters, strict=True)
    ]
