"""What commands share that fill a store: room for it, who computes, what became of its members."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any

import typer

from .common import inform

__all__ = ["Workers", "clear", "cluster", "level_of", "outcomes", "resumable", "vacate"]

Workers = Annotated[
    str | None,
    typer.Option(metavar="N|ADDRESS", help="So many processes, or those of a Dask scheduler."),
]


def level_of(text: str) -> dict[str, float]:
    """Integrals and their values.

    Raises
    ------
    InputError
        If the text is not of the form NAME=VALUE,NAME=VALUE.
    """
    from ..errors import InputError

    found = {}
    for part in text.split(","):
        name, equals, number = (piece.strip() for piece in part.partition("="))
        try:
            if not (name and equals):
                raise ValueError
            found[name] = float(number)
        except ValueError:
            raise InputError(
                f"--level {text}: it is written NAME=VALUE,NAME=VALUE, such as energy=1,area=0.3"
            ) from None
    return found


def vacate(output: Path, force: bool) -> None:
    """Make room for a store where that is wished.

    Raises
    ------
    InputError
        If that would destroy something that is not ours.
    """
    import shutil

    from ..flow.store import read

    if output.exists() and force:
        read(output).close()
        shutil.rmtree(output)


def clear(output: Path, picture: Path, force: bool) -> None:
    """Make room for a store and its picture where that is wished.

    Raises
    ------
    InputError
        If that would destroy something that is not ours, or was not to be replaced.
    """
    from ..study.files import check_target

    vacate(output, force)
    check_target(picture, force or output.exists())


@contextmanager
def cluster(workers: str | None) -> Iterator[Any]:
    """Who computes: this process, so many processes, or those of a scheduler.

    Raises
    ------
    InputError
        If it is neither a number nor an address.
    """
    from ..errors import InputError

    if workers is None:
        yield None
        return
    if "://" in workers:
        yield workers
        return
    if not workers.isdecimal() or int(workers) < 1:
        raise InputError(
            f"--workers {workers}: it must be a whole number from 1 on, or an address such as "
            "tcp://host:8786"
        )
    yield int(workers)


@contextmanager
def resumable(store: Path) -> Iterator[None]:
    """Say how an interrupted command goes on, and end it with exit code 130."""
    try:
        yield
    except KeyboardInterrupt:
        inform(f"interrupted; the same command goes on with what is in {store}")
        raise typer.Exit(130) from None


def outcomes(variable: Any) -> dict[str, int]:
    """How many members had which outcome, in words.

    Parameters
    ----------
    variable : xarray.DataArray
        With ``flag_values`` and ``flag_meanings``, as in the CF conventions.
    """
    import numpy as np

    flags, words = variable.attrs["flag_values"], variable.attrs["flag_meanings"].split()
    meanings = {int(f): w.replace("_", " ") for f, w in zip(flags, words, strict=True)}
    codes, counts = np.unique(variable.values, return_counts=True)
    return {meanings[int(c)]: int(n) for c, n in zip(codes, counts, strict=True)}
