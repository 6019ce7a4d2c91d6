"""What several commands share: options, reading the argument, progress, tables."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from ..study.prepare import Study

__all__ = [
    "Effort",
    "Force",
    "Json",
    "Override",
    "Precision",
    "What",
    "complain",
    "inform",
    "operations",
    "print_json",
    "progress",
    "study_of",
]

PRECISIONS = ("double", "quad")

What = Annotated[
    str,
    typer.Argument(
        metavar="NAME|FILE", help="A catalogue name, an experiment file, or a Python file."
    ),
]
Override = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=VALUE",
        help="Override a key of the experiment, e.g. body.mass=2 or run.until=5; a parameter "
        "alone by its name, e.g. I_1=2.",
    ),
]
Effort = Annotated[
    float,
    typer.Option(
        metavar="FACTOR",
        help="How much work the proof of one law may take before it is left undecided: 1 is a "
        "thousand million operations, some minutes on one core; 0.1 a tenth of that. Operations "
        "are counted, so that every machine comes to the same answer.",
    ),
]
Json = Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")]
Force = Annotated[bool, typer.Option("--force", help="Replace files that exist already.")]
Precision = Annotated[
    str | None,
    typer.Option(help="double (16 digits) or quad (34 digits); short for --set run.precision=…"),
]


def complain(text: str) -> None:
    """Say what went wrong, on standard error."""
    typer.secho("error: ", fg="red", bold=True, err=True, nl=False)
    typer.echo(text, err=True)


def inform(text: str) -> None:
    """Say something besides the result, on standard error."""
    typer.echo(text, err=True)


def print_json(value: Any) -> None:
    """The result for another program."""
    typer.echo(json.dumps(value, indent=2, ensure_ascii=False))


def operations(effort: float) -> int:
    """The term operations that ``--effort`` stands for.

    Raises
    ------
    InputError
        If it is not positive and finite.
    """
    from ..errors import InputError
    from ..laws.budget import EFFORT

    if not 0 < effort < float("inf"):
        raise InputError(f"--effort {effort:g}: it must be a positive number")
    return max(1, round(effort * EFFORT))


def study_of(what: str, overrides: list[str] | None, precision: str | None = None) -> Study:
    """Make ready the experiment that NAME or FILE means.

    Raises
    ------
    InputError
        If there is no such file or system, or something in it is wrong.
    """
    from ..errors import InputError
    from ..study.experiment import catalogue_experiment, load
    from ..study.prepare import prepare
    from ..study.python_file import load_python

    options = list(overrides or [])
    if precision is not None:
        if precision not in PRECISIONS:
            raise InputError(f"--precision {precision}: it must be {' or '.join(PRECISIONS)}")
        options.append(f"run.precision={precision}")
    path = Path(what)
    if path.suffix == ".py":
        return _told(load_python(path, options))
    if path.suffix == ".toml" or path.is_file() or len(path.parts) > 1:
        experiment = load(path, options)
    else:
        experiment = catalogue_experiment(what, options)
    return _told(prepare(experiment))


def _told(made: Study) -> Study:
    """The same study, its remarks said."""
    for remark in made.remarks:
        inform(f"note: {remark}")
    return made


@contextmanager
def progress(task: str) -> Iterator[Callable[[float], None]]:
    """A progress bar on a terminal, shown only for what takes longer than a second."""
    if not sys.stderr.isatty():
        yield lambda _: None
        return
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeRemainingColumn

    bar = Progress(
        TextColumn("{task.description}"),
        BarColumn(),
        TextColumn("{task.percentage:3.0f} %"),
        TimeRemainingColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    number = bar.add_task(task, total=1.0)
    began = time.monotonic()

    def update(done: float) -> None:
        if not bar.live.is_started and time.monotonic() - began > 1.0:
            bar.start()
        bar.update(number, completed=done)

    try:
        yield update
    finally:
        bar.stop()
