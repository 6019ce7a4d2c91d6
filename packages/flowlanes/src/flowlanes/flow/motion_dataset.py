"""Datasets of motions."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import version
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import sympy as sp
import xarray as xr

from ..system.arrays import FloatArray
from ..system.matrices import SquareMatrix
from ..system.system import Conventions, System
from .taylor.working_numbers import WorkingNumber
from .variable_metadata import labels_of, system_attributes, variable_metadata

#: Values along a trajectory: doubles, or numbers of 34 digits.
Samples: TypeAlias = npt.NDArray[Any]

#: Dimensions, values and attributes of a variable.
Variable: TypeAlias = tuple[str | tuple[str, ...], FloatArray | list[object], dict[str, str]]


def motion_dataset(
    system: System,
    parameters: Mapping[sp.Symbol, WorkingNumber],
    times: Samples,
    quantities: Mapping[str, Samples],
    *,
    start: Samples,
    facts: Mapping[str, object],
    meanings: Mapping[str, tuple[str, str]] | None = None,
) -> xr.Dataset:
    """The dataset of a motion; see :meth:`flowlanes.flow.motion.SystemMotion.to_dataset`.

    Parameters
    ----------
    system : System
    parameters : mapping of Symbol to number
    times : array (n,)
    quantities : mapping of str to array
        Variables of the state, observables and laws (``law_<name>``) by name, (n,) or
        (n, components); those that are missing are left out.
    start : array (size,)
        The first state.
    facts : mapping
        How the motion was computed, for the attributes.
    meanings : mapping of str to (str, str), optional
        Meaning and SI unit of variables of the state, by name.
    """
    known, conventions = dict(meanings or {}), system.conventions
    variables: dict[str, Variable] = {}
    recorded = {item.name for item in system.observables}
    for name in map(str, system.state):
        if name not in recorded | conventions.unrecorded and name in quantities:
            _add_state(variables, system, name, quantities[name], known.get(name))
    for item in system.observables:
        if item.name in quantities:
            values = quantities[item.name]
            about = (item.frame, item.meaning, item.unit, item.source)
            _add(variables, conventions, item.name, values, *about)
    for law in system.integrals:
        label = f"law_{law.name}"
        if label in quantities:
            about = ("", law.meaning, law.unit, law.source)
            _add(variables, conventions, label, quantities[label], *about)
    for part in ("", "_low"):
        if f"law_energy{part}" in variables:
            variables[f"energy{part}"] = variables[f"law_energy{part}"]
    time, low = _split(times)
    frames, axis_meanings = conventions.frames, conventions.axis_meanings
    matrix_axes = axis_meanings.keys() - {dim for dim, _ in frames.values()}
    sizes = {
        dim: size
        for dims, values, _ in variables.values()
        if isinstance(values, np.ndarray) and isinstance(dims, tuple)
        for dim, size in zip(dims, values.shape, strict=True)
        if dim in matrix_axes
    }
    axes: dict[str, list[object]] = {
        dim: list(labels) for dim, labels in frames.values() if _is_dimension(variables, dim)
    }
    axes |= {dim: list(labels_of(dim, size)) for dim, size in sizes.items()}
    coordinates: dict[str, Variable] = {
        "time": ("time", time, {"long_name": "time", "units": "s", "source": ""}),
        **{
            dim: (dim, labels, {"long_name": axis_meanings[dim], "units": "1", "source": ""})
            for dim, labels in axes.items()
        },
    }
    if low is not None:
        meaning = {"long_name": "time, low part", "units": "s", "source": ""}
        variables["time_low"] = ("time", low, meaning)
    notes = {
        **system_attributes(system),
        "parameters": "; ".join(f"{s} = {_text(v)}" for s, v in parameters.items()),
        "start": "; ".join(
            f"{s} = {_text(v)}" for s, v in zip(system.symbols, start, strict=False)
        ),
        **facts,
        "versions": ", ".join(
            f"{name} {version(name)}" for name in ("flowlanes", "llvmlite", "numpy", "sympy")
        ),
    }
    return xr.Dataset(variables, coordinates, notes)


def _text(value: object) -> str:
    return repr(float(value)) if isinstance(value, (int, float, np.floating)) else str(value)


def _is_dimension(variables: Mapping[str, Variable], dim: str) -> bool:
    return any(dim in dims for dims, _, _ in variables.values())


def _add_state(
    variables: dict[str, Variable],
    system: System,
    name: str,
    values: Samples,
    description: tuple[str, str] | None,
) -> None:
    """Add a state variable, with its meaning given or inferred from its name."""
    size = values.shape[1] if values.ndim > 1 else 1
    meaning, units, source, frame = variable_metadata(system, name, size, description)
    variable = next(v for v in system.state if str(v) == name)
    if isinstance(variable, SquareMatrix):
        dims = system.conventions.dimensions(variable)
        matrix = values.reshape(len(values), *map(int, variable.shape))
        high, low = _split(matrix)
        notes = {"long_name": meaning, "units": units, "source": source}
        variables[name] = (("time", *dims), high, notes)
        if low is not None:
            more = {**notes, "long_name": f"{meaning}, low part"}
            variables[f"{name}_low"] = (("time", *dims), low, more)
        return
    _add(variables, system.conventions, name, values, frame, meaning, units, source)


def _add(
    variables: dict[str, Variable],
    conventions: Conventions,
    name: str,
    values: Samples,
    frame: str,
    meaning: str,
    units: str,
    source: str,
) -> None:
    axis = conventions.frames[frame][0] if frame in conventions.frames else frame
    dims = ("time", axis) if frame else ("time",)
    high, low = _split(values)
    notes = {"long_name": meaning, "units": units or "1", "source": source}
    if frame in ("body", "space"):
        notes["frame"] = f"{frame} axes"
    variables[name] = (dims, high, notes)
    if low is not None:
        variables[f"{name}_low"] = (dims, low, {**notes, "long_name": f"{meaning}, low part"})


def _split(values: Samples) -> tuple[FloatArray, FloatArray | None]:
    """Doubles and, for 34-digit numbers, the remainders."""
    array = np.asarray(values)
    if array.dtype == np.float64:
        return array, None
    high = np.vectorize(float, otypes=[float])(array)
    low = array - high.astype(array.dtype)
    return high, np.vectorize(float, otypes=[float])(low)
