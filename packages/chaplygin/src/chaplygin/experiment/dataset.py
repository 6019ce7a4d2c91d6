"""Datasets of motions to and from files."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import xarray as xr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError

from .formats import save


@arguments_checked
def write_dataset(dataset: xr.Dataset, path: str | Path, force: bool = False) -> Path:
    """Write a dataset to a file or store atomically.

    Parameters
    ----------
    dataset : xarray.Dataset
    path : str or Path
        Name ending in ``.nc`` (NetCDF), ``.zarr`` (a Zarr store) or ``.csv`` (a table).
    force : bool
        Whether an existing file may be replaced.

    Returns
    -------
    Path
        The path of the file.

    Raises
    ------
    InputError
        If the ending is another one, the file exists and `force` is false, or its place cannot
        be written.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin.experiment import write_dataset
    >>> from tempfile import TemporaryDirectory
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> motion = ch.integrate(ball, {"omega": (1, 0, 2), "gamma": (0, 0, 1)}, [0.0, 5.0, 10.0])
    >>> with TemporaryDirectory() as folder:
    ...     write_dataset(motion.to_dataset(), f"{folder}/ball.csv").name
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
def open_dataset(path: str | Path) -> xr.Dataset:
    """Read a dataset written by ``write_dataset`` to NetCDF or Zarr, into memory.

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
    >>> from chaplygin.experiment import write_dataset
    >>> from tempfile import TemporaryDirectory
    >>> ball = ch.from_catalogue("chaplygin-ball")
    >>> motion = ch.integrate(ball, {"omega": (1, 0, 2), "gamma": (0, 0, 1)}, [0.0, 5.0, 10.0])
    >>> with TemporaryDirectory() as folder:
    ...     ch.open_dataset(write_dataset(motion.to_dataset(), f"{folder}/ball.nc"))["omega"].shape
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
