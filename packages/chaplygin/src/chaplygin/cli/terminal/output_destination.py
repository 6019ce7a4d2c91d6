"""Output of commands: to a new file, or to standard output."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager, nullcontext, redirect_stdout
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr

#: File name endings of figures.
FIGURES = (".png", ".svg", ".pdf")

#: Name of the standard output.
STANDARD_OUTPUT = Path("-")


def check_output(
    option: str,
    output: Path,
    force: bool,
    json: bool,
    what: str = "",
    binary: bool = True,
    place: Callable[[Path, bool], None] | None = None,
) -> None:
    """Check that a file may be written, before the computation.

    Parameters
    ----------
    option : str
        Option with the file name, for messages.
    output : Path
        File; a dash for standard output.
    force : bool
        True if an existing file may be replaced.
    json : bool
        True if the result is printed as JSON.
    what : str
        Experiment file, which is never replaced.
    binary : bool
        True if the output is of no use on a terminal.
    place : callable, optional
        Function that raises InputError if the output is not allowed; by default for a plain file.

    Raises
    ------
    InputError
        If the output is not allowed.
    """
    from flowlanes.errors import InputError

    from ...experiment.files import check_target

    if output == STANDARD_OUTPUT:
        if json:
            raise InputError(
                f"{option} - and --json both write to standard output: choose one of them"
            )
        if binary and sys.stdout.isatty():
            raise InputError(
                f"{option} -: a file of numbers is not for a terminal; send it to a file or a "
                "program, as in > FILE or | PROGRAM"
            )
        return
    if what and output.exists() and Path(what).exists() and output.samefile(what):
        raise InputError(f"{output} is the experiment file itself: choose another name")
    (place or check_target)(output, force)


def check_figure(option: str, figure: Path) -> None:
    """Raise InputError unless a figure can have this name."""
    from flowlanes.errors import InputError

    if figure.suffix not in FIGURES:
        raise InputError(f"{option} {figure}: its name must end in {', '.join(FIGURES)}")


def deliver(dataset: xr.Dataset, output: Path, force: bool) -> None:
    """Write a dataset in the format of the file name, or as NetCDF to standard output."""
    from ...experiment.dataset import write_dataset
    from ...experiment.formats import netcdf

    if output == STANDARD_OUTPUT:
        sys.stdout.buffer.write(netcdf(dataset))
        sys.stdout.buffer.flush()
    else:
        write_dataset(dataset, output, force)


def name_of(output: Path) -> str:
    """Name of an output in messages."""
    return "standard output" if output == STANDARD_OUTPUT else str(output)


def beside(output: Path | None) -> AbstractContextManager[object]:
    """Context that prints to standard error while the output itself goes to standard output."""
    return redirect_stdout(sys.stderr) if output == STANDARD_OUTPUT else nullcontext()


@contextmanager
def output_file(output: Path) -> Iterator[Path]:
    """Temporary path whose content becomes the output on success."""
    from tempfile import TemporaryDirectory

    from ...experiment.files import atomic_file

    if output != STANDARD_OUTPUT:
        with atomic_file(output) as place:
            yield place
        return
    with TemporaryDirectory() as folder:
        place = Path(folder) / "output"
        yield place
        sys.stdout.buffer.write(place.read_bytes())
        sys.stdout.buffer.flush()
