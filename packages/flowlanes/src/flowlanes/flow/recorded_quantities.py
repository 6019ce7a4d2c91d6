"""Quantities recorded along motions: the observables of a system, and its integrals."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy.typing as npt
import sympy as sp

from ..arguments import Parameters
from ..formulas.array_evaluation import values
from ..system.arrays import FloatArray
from ..system.laws import Integral
from ..system.system import Observable, System
from .motion import Number


@dataclass(frozen=True)
class RecordedQuantity:
    """Quantity recorded along motions.

    Attributes
    ----------
    name : str
    formulas : tuple of sympy.Expr
        Its components; one for a scalar.
    is_vector : bool
    frame : str
        ``"body"`` or ``"space"`` for a vector in these axes.
    meaning, unit, source : str
    """

    name: str
    formulas: tuple[sp.Expr, ...]
    is_vector: bool
    frame: str
    meaning: str
    unit: str
    source: str


@lru_cache(maxsize=32)
def recorded_quantities(system: System) -> tuple[RecordedQuantity, ...]:
    """Observables of a system, and its integrals as ``law_<name>``."""
    quantities = [_quantity(item.name, item.frame, item) for item in system.scalar.observables]
    quantities += [_quantity(f"law_{law.name}", "", law) for law in system.scalar.integrals]
    return tuple(quantities)


def _quantity(name: str, frame: str, item: Observable | Integral) -> RecordedQuantity:
    is_vector = isinstance(item.value, sp.MatrixBase)
    components = tuple(item.value) if is_vector else (item.value,)
    return RecordedQuantity(
        name, components, is_vector, frame, item.meaning, item.unit or "1", item.source
    )


def columns_by_name(system: System, columns: npt.NDArray[Number]) -> dict[str, npt.NDArray[Number]]:
    """Columns grouped into the recorded quantities, by name.

    Parameters
    ----------
    system : System
    columns : array (components, n)
        Columns of all quantities, in order; further columns are ignored.

    Returns
    -------
    dict of str to array
        (n,) for a scalar, (n, components) for a vector.
    """
    recorded: dict[str, npt.NDArray[Number]] = {}
    first = 0
    for quantity in recorded_quantities(system):
        block = columns[first : first + len(quantity.formulas)]
        recorded[quantity.name] = block.T if quantity.is_vector else block[0]
        first += len(quantity.formulas)
    return recorded


def recorded_values(
    system: System, states: FloatArray, parameters: Parameters = None
) -> dict[str, FloatArray]:
    """Observables and integrals at states (n, size), by name; see `columns_by_name`."""
    formulas = [
        formula for quantity in recorded_quantities(system) for formula in quantity.formulas
    ]
    return columns_by_name(system, values(system, formulas, states, parameters).T)
