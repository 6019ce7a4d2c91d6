"""Formulas of a System at many states at once, with their gradients."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy.typing as npt
import sympy as sp

from ..arguments import arguments_checked
from ..errors import InputError
from ..system.arrays import FloatArray
from ..system.parameters import Parameters
from ..system.system import System
from .array_evaluation import as_float_array, numbers, parameter_rows
from .graph import Graph, Reader, Term


@dataclass(frozen=True)
class Formulas:
    """Scalar formulas in state, definitions and parameters of a System.

    The value at a state does not depend on the other states.

    Parameters
    ----------
    system : System
    formulas : sequence of sympy.Expr

    Raises
    ------
    InputError
        On the first evaluation of a formula with an unknown name or function.

    Examples
    --------
    >>> import flowlanes
    >>> x, v = sp.symbols("x v", real=True)
    >>> pendulum = flowlanes.System("pendulum", "Pendulum", {x: v, v: -sp.sin(x)})
    >>> flowlanes.formulas.Formulas(pendulum, [v**2 / 2, x * v])([1.0, 2.0])
    array([2., 2.])
    """

    system: System
    formulas: Sequence[sp.Expr]

    @arguments_checked
    def __call__(self, states: npt.ArrayLike, parameters: Parameters | None = None) -> FloatArray:
        """Values of the formulas at states.

        Parameters
        ----------
        states : array (..., size)
            In flat order.
        parameters : mapping of Symbol or name to number or array (n,), optional
            Values that replace the defaults; an array has a value for each row of `states` (first
            axis).

        Returns
        -------
        array (..., formulas)
            Infinite or NaN where a formula has no value.
        """
        return self._values(self._terms, states, parameters)

    @arguments_checked
    def slopes(self, states: npt.ArrayLike, parameters: Parameters | None = None) -> FloatArray:
        """Derivatives with respect to the state.

        Returns
        -------
        array (..., formulas, size)
        """
        flat = self._values(self._slope_terms, states, parameters)
        return flat.reshape(*flat.shape[:-1], len(self.formulas), len(self.system.symbols))

    @cached_property
    def _terms(self) -> tuple[Term, ...]:
        return _read(self.system, tuple(self.formulas))

    @cached_property
    def _slope_terms(self) -> tuple[Term, ...]:
        return _slopes(self.system, tuple(self.formulas))

    def _values(
        self, terms: Sequence[Term], states: npt.ArrayLike, parameters: Parameters | None
    ) -> FloatArray:
        points = as_float_array("states", states)
        if points.shape[-1:] != (len(self.system.symbols),):
            raise InputError(
                f"{self.system.name}: states of {len(self.system.symbols)} numbers are needed, not "
                f"an array of the shape {points.shape}"
            )
        count = len(points) if points.ndim > 1 else 1
        rows = parameter_rows(self.system, parameters, count)
        if len(rows) == 1:
            return numbers(terms, points, rows[0])
        return numbers(terms, points, rows.reshape(count, *(1,) * (points.ndim - 2), -1))

    def __getstate__(self) -> dict[str, object]:
        # Terms are identified by object identity, which is not the same in another process.
        return {"system": self.system, "formulas": self.formulas}


# Cached for all instances, because code for many motions creates one for each block.
@lru_cache(maxsize=256)
def _read(system: System, formulas: tuple[sp.Expr, ...]) -> tuple[Term, ...]:
    known = {*system.symbols, *system.defaults, *dict(system.scalar_definitions)}
    scalars = [system.scalar.of(formula) for formula in formulas]
    for formula in scalars:
        unknown = sorted(map(str, formula.free_symbols - known))
        if unknown:
            raise InputError(
                f"{system.name}: the formula {formula} uses {', '.join(unknown)}, which is neither "
                "a state variable, a definition nor a parameter"
            )
    reader = Reader(system, Graph())
    return tuple(reader(formula) for formula in scalars)


@lru_cache(maxsize=256)
def _slopes(system: System, formulas: tuple[sp.Expr, ...]) -> tuple[Term, ...]:
    terms = _read(system, formulas)
    if not terms:
        return ()
    graph = terms[0].graph
    states = [graph.state(i) for i in range(len(system.symbols))]
    return tuple(slope for row in graph.jacobian(terms, states) for slope in row)
