"""Trajectories as xarray datasets, and to and from files."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from importlib.metadata import version
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.trajectory import Trajectory
from flowlanes.flow.variable_metadata import (
    FRAMES,
    LABELS,
    N_DIMENSIONAL,
    dimensions_of,
    labels_of,
    variable_metadata,
)
from flowlanes.system.arrays import FloatArray
from flowlanes.system.matrices import SquareMatrix

from .contact.dataset import contact_dataset, work_meanings
from .contact.trajectory import ContactTrajectory
from .formats import save

#: Values along a trajectory: doubles, or numbers of 34 digits.
Samples: TypeAlias = npt.NDArray[Any]

#: Dimensions, values and attributes of a variable.
Variable: TypeAlias = tuple[str | tuple[str, ...], FloatArray | list[object], dict[str, str]]

#: Horizontal position of a centre of mass in the lift to space, which is recorded as part of it.
_PLACE = "place"


@arguments_checked
def to_dataset(
    trajectory: Trajectory,
    attributes: Mapping[str, object] | None = None,
    meanings: Mapping[str, tuple[str, str]] | None = None,
) -> xr.Dataset:
    """Convert a trajectory to a dataset.

    Parameters
    ----------
    trajectory : Trajectory
    attributes : mapping, optional
        Further global attributes, such as the text of the experiment file.
    meanings : mapping of str to (str, str), optional
        Meaning and SI unit of variables of the state, by name.

    Returns
    -------
    xarray.Dataset
        Dimension ``time``; vectors have ``axis`` (body), ``space`` or ``quaternion``, and
        vectors of the state in no known frame a dimension ``<name>_component``.  Every
        variable has ``long_name``, ``units`` and ``source``.  Numbers of 34 digits are split: the
        variable ``<name>_low`` is what must be added to ``<name>`` to have all of them.  That of a
        motion with friction has its mode and, with a dimension ``event``, what happened.

    Raises
    ------
    InputError
        If an argument is of another kind.

    Examples
    --------
    >>> import chaplygin as ch
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> motion = ch.integrate(ball, {"omega": (1, 0, 2), "gamma": (0, 0, 1)}, [0.0, 5.0, 10.0])
    >>> omega = ch.to_dataset(motion)["omega"]
    >>> omega.dims, omega.attrs["units"], omega.attrs["frame"]
    (('time', 'axis'), 'rad/s', 'body axes')
    """
    system = trajectory.system
    known = dict(meanings or {})
    if isinstance(trajectory, ContactTrajectory):
        known = work_meanings(trajectory.contact, system) | known
    variables: dict[str, Variable] = {}
    for name in map(str, system.state):
        if name != _PLACE and name not in trajectory.records:
            _add_state(variables, trajectory, name, known.get(name))
    for item in system.observables:
        values = trajectory.records[item.name]
        _add(variables, item.name, values, item.frame, item.meaning, item.unit, item.source)
    for law in system.integrals:
        label = f"law_{law.name}"
        _add(variables, label, trajectory.records[label], "", law.meaning, law.unit, law.source)
    for part in ("", "_low"):
        if f"law_energy{part}" in variables:
            variables[f"energy{part}"] = variables[f"law_energy{part}"]
    time, low = _split(trajectory.times)
    sizes = {
        dim: size
        for dims, values, _ in variables.values()
        if isinstance(values, np.ndarray) and isinstance(dims, tuple)
        for dim, size in zip(dims, values.shape, strict=True)
        if dim in N_DIMENSIONAL
    }
    coordinates: dict[str, Variable] = {
        "time": ("time", time, {"long_name": "time", "units": "s", "source": ""}),
        **{
            dim: (dim, list(labels), {"long_name": LABELS[dim], "units": "1", "source": ""})
            for dim, labels in FRAMES.values()
            if _is_dimension(variables, dim)
        },
        **{
            dim: (
                dim,
                list(labels_of(dim, size)),
                {"long_name": LABELS[dim], "units": "1", "source": ""},
            )
            for dim, size in sizes.items()
        },
    }
    if low is not None:
        notes = {"long_name": "time, low part", "units": "s", "source": ""}
        variables["time_low"] = ("time", low, notes)
    statistics = trajectory.statistics
    facts = {
        "Conventions": "CF-1.11",
        "system": system.title,
        "system_name": system.name,
        "summary": system.summary,
        "source": system.source,
        "parameters": "; ".join(f"{s} = {_text(v)}" for s, v in trajectory.parameters.items()),
        "start": "; ".join(
            f"{s} = {_text(v)}" for s, v in zip(system.symbols, trajectory.states[0], strict=True)
        ),
        "events": "\n".join(map(str, trajectory.events)),
        "warnings": "\n".join(trajectory.warnings),
        "tolerance": statistics.tolerance,
        "precision": statistics.precision,
        "integrator": statistics.integrator,
        "versions": ", ".join(
            f"{name} {version(name)}" for name in ("chaplygin", "llvmlite", "numpy", "sympy")
        ),
    }
    dataset = xr.Dataset(variables, coordinates, {**facts, **(attributes or {})})
    if isinstance(trajectory, ContactTrajectory):
        return contact_dataset(trajectory, dataset)
    return dataset


def _text(value: object) -> str:
    return repr(float(value)) if isinstance(value, (int, float, np.floating)) else str(value)


def _is_dimension(variables: Mapping[str, Variable], dim: str) -> bool:
    return any(dim in dims for dims, _, _ in variables.values())


def _add_state(
    variables: dict[str, Variable],
    trajectory: Trajectory,
    name: str,
    description: tuple[str, str] | None,
) -> None:
    """Add a state variable, with its meaning given or inferred from its name."""
    values = trajectory[name]
    size = values.shape[1] if values.ndim > 1 else 1
    meaning, units, source, frame = variable_metadata(trajectory.system, name, size, description)
    variable = next(v for v in trajectory.system.state if str(v) == name)
    if isinstance(variable, SquareMatrix):
        dims = dimensions_of(variable)
        matrix = values.reshape(len(values), *map(int, variable.shape))
        high, low = _split(matrix)
        notes = {"long_name": meaning, "units": units, "source": source}
        variables[name] = (("time", *dims), high, notes)
        if low is not None:
            more = {**notes, "long_name": f"{meaning}, low part"}
            variables[f"{name}_low"] = (("time", *dims), low, more)
        return
    _add(variables, name, values, frame, meaning, units, source)


def _add(
    variables: dict[str, Variable],
    name: str,
    values: Samples,
    frame: str,
    meaning: str,
    units: str,
    source: str,
) -> None:
    dims = ("time", FRAMES[frame][0] if frame in FRAMES else frame) if frame else ("time",)
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


@arguments_checked
def write(dataset: xr.Dataset, path: str | Path, force: bool = False) -> Path:
    """Write a dataset to a file or store atomically.

    Parameters
    ----------
    dataset : xarray.Dataset
    path : str or Path
        Name ending in ``.nc`` (NetCDF), ``.zarr`` (a Zarr store) or ``.csv`` (a table).
    force : bool
        Whether to replace what is there.

    Returns
    -------
    Path
        Where it was written.

    Raises
    ------
    InputError
        If the ending is another one, the file exists and `force` is false, or its place cannot
        be written.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from tempfile import TemporaryDirectory
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> motion = ch.integrate(ball, {"omega": (1, 0, 2), "gamma": (0, 0, 1)}, [0.0, 5.0, 10.0])
    >>> with TemporaryDirectory() as folder:
    ...     ch.write(ch.to_dataset(motion), f"{folder}/ball.csv").name
    'ball.csv'
    """
    target = Path(path)
    save(dataset, target, force)
    return target


#: Scan the file with h5py only: h5netcdf prints to stderr when the file is not HDF5.
_LOOK = """
import h5py, sys
try:
    with h5py.File(sys.argv[1], "r") as file:
        dict(file.attrs)
        file.visititems(lambda _, item: dict(item.attrs) and None)
except Exception:
    sys.exit(3)
"""
_DAMAGE_CODE = 3

#: Seconds after which HDF5 counts as stuck in a loop; a hundredth of a second suffices.
_READ_TIMEOUT = 20.0


def _require_readable(path: Path) -> None:
    """Raise an error for a file that HDF5 cannot read; on some damaged files it never ends.

    The file is therefore scanned in a separate process, which can be killed.
    """
    try:
        looked = subprocess.run(
            [sys.executable, "-c", _LOOK, str(path)],
            env={**os.environ, "PYTHONPATH": os.pathsep.join(filter(None, sys.path))},
            capture_output=True,
            timeout=_READ_TIMEOUT,
            check=False,
        )
    except subprocess.TimeoutExpired:
        raise InputError(
            f"{path}: not a readable NetCDF file: HDF5 came to no end of it in {_READ_TIMEOUT:g} s"
        ) from None
    # A signal kills it if HDF5 crashes.
    if looked.returncode == _DAMAGE_CODE or looked.returncode < 0:
        raise InputError(f"{path}: not a readable NetCDF file")


@arguments_checked
def read(path: str | Path) -> xr.Dataset:
    """Read a dataset written by :func:`write` to NetCDF or Zarr, into memory.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    xarray.Dataset

    Raises
    ------
    InputError
        If the file is missing or damaged, or neither a NetCDF file nor a Zarr store.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from tempfile import TemporaryDirectory
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> motion = ch.integrate(ball, {"omega": (1, 0, 2), "gamma": (0, 0, 1)}, [0.0, 5.0, 10.0])
    >>> with TemporaryDirectory() as folder:
    ...     ch.read(ch.write(ch.to_dataset(motion), f"{folder}/ball.nc"))["omega"].shape
    (3, 3)
    """
    if not Path(path).exists():
        raise InputError(f"{path}: there is no such file")
    zarr = Path(path).is_dir()
    if not zarr:
        _require_readable(Path(path))
    try:
        with xr.open_dataset(
            path, engine="zarr" if zarr else "h5netcdf", decode_times=False
        ) as stored:
            return stored.load()
    except Exception as problem:
        # A damaged file may make the libraries raise any exception.
        kind = "Zarr store" if zarr else "NetCDF file"
        raise InputError(f"{path}: not a readable {kind}") from problem
