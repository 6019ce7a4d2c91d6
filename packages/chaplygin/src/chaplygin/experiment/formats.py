"""File formats of a trajectory: NetCDF, Zarr, and CSV for tables."""

from __future__ import annotations

import csv
import io
import shutil
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

from flowlanes.errors import InputError
from flowlanes.files.partial_files import partial_folder

from .files import atomic_file, check_replaced_store, check_target

if TYPE_CHECKING:
    import xarray as xr

#: File name endings, and their meaning.
FORMATS = {".nc": "NetCDF", ".zarr": "a Zarr store", ".csv": "a table"}


def check_format(path: Path) -> None:
    """Raise InputError unless the ending of a name denotes a known format."""
    if path.suffix.lower() not in FORMATS:
        kinds = ", ".join(f"{ending} ({kind})" for ending, kind in FORMATS.items())
        raise InputError(f"{path}: the name of a trajectory must end in {kinds}")


def check_output(path: Path, force: bool = False) -> None:
    """Raise InputError unless a trajectory may be written to `path`."""
    is_store = path.suffix.lower() == ".zarr"
    store = is_store and path.is_dir()
    if not (path.exists() and not path.is_file()):
        check_format(path)
    if is_store and path.is_symlink() and path.exists():
        raise InputError(f"{path} is a link: give the name of the store itself")
    if is_store and path.is_file():
        raise InputError(f"{path} is a file: a Zarr store is a folder; choose another name")
    if not store:
        check_target(path, force)
    elif any(path.iterdir()) and not _is_trajectory(path):
        raise InputError(f"{path} is a folder with something else in it: choose another name")
    elif any(path.iterdir()) and not force:
        raise InputError(
            f"{path} exists already: choose another name, or have it replaced (--force, in Python "
            "force=True)"
        )
    else:
        check_replaced_store(path)


def save(dataset: xr.Dataset, path: Path, force: bool = False) -> None:
    """Write a trajectory in the format of the file name, atomically.

    Raises
    ------
    InputError
        If the ending means nothing, the place is taken and `force` is false, or it cannot be
        written.
    """
    check_output(path, force)
    ending = path.suffix.lower()
    if ending == ".zarr":
        _save_zarr(dataset, path)
        return
    content = csv_text(dataset).encode("utf-8") if ending == ".csv" else netcdf(dataset)
    with atomic_file(path) as temporary:
        temporary.write_bytes(content)


def netcdf(dataset: xr.Dataset) -> bytes:
    """The content of the NetCDF file of a dataset.

    It is created in memory, since HDF5 may crash the process if a disk is full.
    """
    return bytes(dataset.to_netcdf(engine="h5netcdf", encoding=_encoding(dataset)))


def _encoding(dataset: xr.Dataset) -> dict[str, dict[str, bool]]:
    """The encoding with which HDF5 stores a checksum of all numbers."""
    return {
        str(name): {"fletcher32": True}
        for name, variable in dataset.variables.items()
        if variable.size and variable.ndim and variable.dtype.kind in "fiu"
    }


def csv_text(dataset: xr.Dataset) -> str:
    """A trajectory as a table: one row per sample time, with all digits of every number.

    The columns are ``time`` and the quantities, vectors by components (``M_1``, ``attitude_w``).
    Lines that begin with ``#`` give meaning and unit of each quantity, and how it was computed.
    """
    import numpy as np

    columns = {"time": dataset["time"].values}
    lines = [f"{name}: {value}" for name, value in dataset.attrs.items()]
    # Variables without a time dimension, such as the states at events, have no place in these rows.
    sampled = {name: item for name, item in dataset.data_vars.items() if "time" in item.dims}
    for name, item in {"time": dataset["time"], **sampled}.items():
        lines.append(f"{name}: {item.attrs['long_name']} [{item.attrs['units']}]")
    for name, item in sampled.items():
        rows = item.transpose("time", ...)
        if rows.ndim == 1:
            columns[str(name)] = rows.values
            continue
        # For a matrix, the labels of row and column are combined.
        labels = [
            dataset[axis].values if axis in dataset.coords else range(1, size + 1)
            for axis, size in zip(rows.dims[1:], rows.shape[1:], strict=True)
        ]
        parts = rows.values.reshape(len(rows), -1).T
        columns |= {
            f"{name}_{''.join(map(str, label))}": part
            for label, part in zip(product(*labels), parts, strict=True)
        }
    stream = io.StringIO()
    for text in lines:
        stream.writelines(f"# {line}\n" for line in text.splitlines() or [""])
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(np.stack(list(columns.values()), axis=1).tolist())
    return stream.getvalue()


def _save_zarr(dataset: xr.Dataset, path: Path) -> None:
    """The store is first written under another name."""
    try:
        with partial_folder(path.parent) as provisional:
            dataset.to_zarr(provisional, mode="w", zarr_format=2, consolidated=True)
            if path.exists():
                shutil.rmtree(path)
            provisional.replace(path)
    except OSError as problem:
        raise InputError(f"{path} cannot be written: {problem.strerror or problem}") from problem


def _is_trajectory(folder: Path) -> bool:
    """Whether a folder is a store that holds a trajectory."""
    import xarray as xr

    try:
        with xr.open_dataset(folder, engine="zarr", chunks=None, decode_times=False) as stored:
            return "events" in stored.attrs
    except (OSError, ValueError, KeyError):
        return False
