"""Formulas of a System as one NumPy function each, for loops with repeated calls.

For a single evaluation use :mod:`flowlanes.formulas.array_formulas`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..system.arrays import FloatArray
from ..system.system import System
from .array_evaluation import NUMPY
from .graph import Graph, Reader, Term, topological_order

#: Number of states evaluated at a time, so that intermediate results stay in the processor cache.
_STATES = 2048


class CompiledTerms:
    """Terms as one function of arrays.

    Parameters
    ----------
    terms : sequence of Term
    """

    def __init__(self, terms: Sequence[Term]) -> None:
        names: dict[int, str] = {}
        lines = []
        for i, node in enumerate(topological_order(terms)):
            if node.kind in ("state", "parameter"):
                text = f"{node.kind}[{node.args[0]}]"
            elif node.number is not None:
                text = repr(float(node.number))
            else:
                text = f"{node.kind}({', '.join(names[id(a)] for a in node.operands)})"
            names[id(node)] = f"t{i}"
            lines.append(f"    t{i} = {text}")
        lines += [f"    values[{row}] = {names[id(term)]}" for row, term in enumerate(terms)]
        text = "\n".join(["def function(state, parameter, values):", *lines, "    return values"])
        scope: dict[str, Callable[..., FloatArray]] = dict(NUMPY)
        exec(compile(text, "<formulas>", "exec"), scope)
        self._function = scope["function"]
        self._size = len(terms)

    def __call__(self, states: FloatArray, parameters: FloatArray) -> FloatArray:
        """Values (terms, k) at states (size, k), each variable in a row, and parameters (p,).

        NaN where a formula has no real value.
        """
        values = np.empty((self._size, states.shape[1]))
        with np.errstate(all="ignore"):
            for first in range(0, states.shape[1], _STATES):
                some = slice(first, first + _STATES)
                self._function(states[:, some], parameters, values[:, some])
        return values


class SystemFormulas:
    """Formulas of one System as terms, with derivatives with respect to the state.

    Attributes
    ----------
    graph : Graph
    term_of : Reader
        Reader that converts a formula to its term.
    state : tuple of Term
        State variables in flat order.
    """

    def __init__(self, system: System) -> None:
        self.graph = Graph()
        self.term_of = Reader(system, self.graph)
        self.state = tuple(self.graph.state(i) for i in range(len(system.symbols)))

    def slopes(self, terms: Sequence[Term]) -> list[list[Term]]:
        """Derivatives of terms: one row per term, one column per variable."""
        return self.graph.jacobian(terms, self.state)

    def depends(self, terms: Sequence[Term]) -> set[int]:
        """Indices of the state variables that occur in terms."""
        return {node.args[0] for node in topological_order(terms) if node.kind == "state"}
