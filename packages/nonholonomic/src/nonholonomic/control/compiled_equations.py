"""The equations of a controlled system compiled to floating point, with exact derivatives."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from flowlanes.formulas.compiled import CompiledTerms, SystemFormulas
from flowlanes.system.arrays import FloatArray

from .controlled import ControlledSystem


class CompiledEquations:
    """Rates ż = f(z, u) and their derivatives in z and u, at many points at once.

    The derivatives are terms of the same graph as the rates (chain rule), not differences.

    Parameters
    ----------
    system : ControlledSystem
    """

    def __init__(self, system: ControlledSystem) -> None:
        whole = system.whole
        self.size, self.inputs = len(system.state), len(system.inputs)
        self._parameters = np.array([p.default for p in whole.parameters], dtype=float)
        formulas = SystemFormulas(whole)
        terms = [formulas.term_of(rate) for rate in whole.rates[: self.size]]
        self._rates = CompiledTerms(terms)
        self._slopes, self._at = _entries(formulas, terms)
        conditions = [formulas.term_of(relation) for relation in whole.relations]
        self.relations = len(conditions)
        self._conditions = CompiledTerms(conditions)
        self._normals, self._normals_at = _entries(formulas, conditions)

    def rates(self, points: FloatArray) -> FloatArray:
        """f (k, n) at points (k, n + m) of states and inputs."""
        return self._rates(points.T, self._parameters).T

    def slopes(self, points: FloatArray) -> FloatArray:
        """The derivatives of f, (k, n, n + m)."""
        return self._dense(self._slopes, self._at, self.size, points)

    def conditions(self, points: FloatArray) -> FloatArray:
        """The relations (k, r), which vanish on the state space."""
        return self._conditions(points.T, self._parameters).T

    def normals(self, points: FloatArray) -> FloatArray:
        """The derivatives of the relations, (k, r, n + m)."""
        return self._dense(self._normals, self._normals_at, self.relations, points)

    def _dense(
        self, code: CompiledTerms, at: tuple[list[int], list[int]], rows: int, points: FloatArray
    ) -> FloatArray:
        result = np.zeros((len(points), rows, points.shape[1]))
        result[:, at[0], at[1]] = code(points.T, self._parameters).T
        return result


def _entries(
    formulas: SystemFormulas, terms: Sequence[object]
) -> tuple[CompiledTerms, tuple[list[int], list[int]]]:
    """The structurally nonzero derivatives, compiled, with their rows and columns."""
    table = formulas.slopes(terms)  # type: ignore[arg-type]
    places = [
        (i, j) for i, row in enumerate(table) for j, entry in enumerate(row) if entry.number != 0
    ]
    code = CompiledTerms([table[i][j] for i, j in places])
    return code, ([i for i, _ in places], [j for _, j in places])
