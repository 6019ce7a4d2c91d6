"""Conversion of numbers to and from double-double numbers (32 digits)."""

from __future__ import annotations

import mpmath
import numpy as np
import numpy.typing as npt

from ...arguments import Parameters
from ...formulas.array_evaluation import as_float_array, parameter_rows
from ...system.arrays import FloatArray
from ...system.system import System


def as_pairs(name: str, values: npt.ArrayLike) -> FloatArray:
    """Numbers as pairs (..., 2) of doubles: the rounded number and its error.

    Raises
    ------
    InputError
        If they are not real numbers; `name` is used in the message.
    """
    first = as_float_array(name, values)
    numbers = np.asarray(values)
    if numbers.dtype != object:
        return np.ascontiguousarray(np.stack([first, np.zeros_like(first)], axis=-1))
    with mpmath.workdps(50):
        exact = [mpmath.mpmathify(x) for x in numbers.ravel()]
        parts = [(float(x), float(x - mpmath.mpf(float(x)))) for x in exact]
    return np.array(parts).reshape(*numbers.shape, 2)


def parameter_pairs(system: System, parameters: Parameters, count: int) -> FloatArray:
    """Values of the parameters in order: (1 or count, parameters, 2).

    See :func:`flowlanes.formulas.array_evaluation.parameter_rows`; numbers of many digits keep 32
    digits.
    """
    rows = parameter_rows(system, parameters, count)
    pairs = np.stack([rows, np.zeros_like(rows)], axis=-1)
    if not parameters:
        return pairs
    values = {str(key): np.asarray(value) for key, value in parameters.items()}
    for i, parameter in enumerate(system.parameters):
        value = values.get(str(parameter.symbol))
        if value is not None and value.dtype == object:
            pairs[:, i] = as_pairs(str(parameter.symbol), value)
    return pairs


def from_pairs(first: FloatArray, second: FloatArray) -> npt.NDArray[np.object_]:
    """Double-double numbers converted to an array of mpmath numbers."""
    with mpmath.workdps(40):
        sums = [
            mpmath.mpf(float(a)) + mpmath.mpf(float(b))
            for a, b in zip(np.ravel(first), np.ravel(second), strict=True)
        ]
    numbers = np.empty(len(sums), dtype=object)
    numbers[:] = sums
    return numbers.reshape(np.shape(first))
