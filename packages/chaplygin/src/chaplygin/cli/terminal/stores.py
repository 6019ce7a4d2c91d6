"""Functions for commands that fill a store."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from ...interruption import NOTHING_SAVED, message_on_interrupt

if TYPE_CHECKING:
    import xarray as xr

    from flowlanes.flow.devices.graphics import Device
    from flowlanes.flow.ensembles.task import Progress

    from ...experiment.study import Study

#: Maximum number of processes per processor; each needs some hundred megabytes.
MOST_PROCESSES = 4


def device_of(text: str) -> Device:
    """Device for the computation of motions.

    Raises
    ------
    InputError
        If there is no graphics processor.
    """
    if text != "gpu":
        return "cpu"
    from flowlanes.flow.devices.cuda import open_processor

    # Checked before anything is prepared.
    open_processor()
    return "gpu"


def level_of(text: str) -> dict[str, float]:
    """Integrals and their values.

    Raises
    ------
    InputError
        If the text is not of the form NAME=VALUE,NAME=VALUE.
    """
    from flowlanes.errors import InputError

    level: dict[str, float] = {}
    for part in text.split(","):
        name, equals, number = (piece.strip() for piece in part.partition("="))
        if name in level:
            raise InputError(f"--level {text}: {name} is given twice: leave out one of them")
        try:
            if not (name and equals):
                raise ValueError
            level[name] = float(number)
        except ValueError:
            raise InputError(
                f"--level {text}: it is written NAME=VALUE,NAME=VALUE, such as energy=1,area=0.3"
            ) from None
    return level


def check_store(output: Path) -> None:
    """Raise InputError if a store cannot be written."""
    from stat import S_ISDIR

    from flowlanes.errors import InputError

    from ...experiment.files import status_of_target

    if output.suffix != ".zarr":
        raise InputError(f"--output {output}: its name must end in .zarr")
    status = status_of_target(output)
    # A folder that is not a store is detected later too, but only after the import of Zarr.
    foreign = output.is_dir() and any(output.iterdir()) and not (output / "zarr.json").exists()
    if foreign or (status is not None and not S_ISDIR(status.st_mode)):
        raise InputError(f"{output} is no store of a computation in blocks: choose another name")


def vacate(output: Path, force: bool) -> None:
    """Remove an existing store if this is allowed.

    Raises
    ------
    InputError
        If it is not a store of this program, or is being written.
    """
    from flowlanes.flow.ensembles.zarr_store import remove_store

    from ...experiment.files import check_replaced_store

    if output.exists() and force:
        check_replaced_store(output)
        remove_store(output)


def check_picture(output: Path, picture: Path, force: bool, by_user: bool = False) -> None:
    """Check that the figure of a store may be written.

    The default figure of a store is redrawn with the store, but a figure named `by_user` is
    replaced only with `force`.
    """
    from ...experiment.files import check_target

    check_target(picture, force or (output.exists() and not by_user))


def check_workers(workers: str | None) -> str | int | None:
    """Workers: None, a number of processes, or the address of a scheduler.

    Raises
    ------
    InputError
        If it is neither a number nor an address.
    """
    from flowlanes.errors import InputError

    if workers is None or "://" in workers:
        return workers
    if not workers.isdecimal() or int(workers) < 1:
        raise InputError(
            f"--workers {workers}: it must be a whole number from 1 on, or an address such as "
            "tcp://host:8786"
        )
    require_processes(int(workers))
    return int(workers)


def require_processes(count: int) -> None:
    """Raise InputError for more processes than are reasonable for the processors and memory.

    Raises
    ------
    InputError
        If there are fewer than one, or more than four per processor.
    """
    import os

    from flowlanes.errors import InputError

    processors = os.cpu_count() or 1
    most = MOST_PROCESSES * processors
    if not 1 <= count <= most:
        raise InputError(
            f"--workers {count}: it must be a whole number from 1 to {most}, "
            f"{MOST_PROCESSES} for each of the {processors} processors of this machine"
        )


def require_parameter(option: str, name: str, study: Study) -> None:
    """Raise an error if the varied quantity is not a parameter of the system.

    Raises
    ------
    InputError
        If the equations have no parameter of this name.
    """
    from flowlanes.errors import InputError
    from nonholonomic.catalogue import CATALOGUE

    from ...experiment.file.tables import OF_A_DIMENSION

    known = [str(parameter.symbol) for parameter in study.system.parameters]
    if name in known:
        return
    item = CATALOGUE.get(study.system.name)
    wrong = (
        f"the equations depend on it, so that all motions have the same (--set {name}=…)"
        if item is not None and item.family is not None and name in OF_A_DIMENSION
        else f"no parameter of {study.system.name}"
    )
    raise InputError(f"{option} {name}: {wrong}; allowed: {', '.join(known) or 'none'}")


@contextmanager
def resumable(store: Path, report: Progress, force: bool) -> Iterator[Progress]:
    """Progress of a store; after an interruption, a message on how to resume.

    Parameters
    ----------
    store : Path
    report : callable
        Function that is called with the completed fraction.
    force : bool
        True if the command replaces a store; the next command should not do so.
    """
    import shutil

    from flowlanes.errors import InputError

    share = 0.0

    def update(fraction: float) -> None:
        nonlocal share
        share = fraction
        report(fraction)

    def words() -> str:
        if not store.exists():
            return NOTHING_SAVED
        command = "the same command without --force" if force else "the same command"
        if not share:
            return f"{store} stays, with nothing added; {command} resumes there"
        return f"{share:.0%} is computed and saved in {store}; {command} resumes from there"

    begun = store.exists()
    try:
        with message_on_interrupt(words):
            yield update
    except InputError:
        # If nothing was computed, the store is removed, so that the command can be corrected.
        if not begun:
            shutil.rmtree(store, ignore_errors=True)
        raise


def outcomes(variable: xr.DataArray) -> dict[str, int]:
    """Number of members with each outcome.

    Parameters
    ----------
    variable : xarray.DataArray
        Variable with ``flag_values`` and ``flag_meanings``, as in the CF conventions.
    """
    import numpy as np

    flags, words = variable.attrs["flag_values"], variable.attrs["flag_meanings"].split()
    meanings = {int(f): w.replace("_", " ") for f, w in zip(flags, words, strict=True)}
    codes, counts = np.unique(variable.values, return_counts=True)
    return {meanings[int(c)]: int(n) for c, n in zip(codes, counts, strict=True)}
