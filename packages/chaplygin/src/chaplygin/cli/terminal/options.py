"""Options and arguments that several commands share, and their output."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .progress import LOG, waiting

if TYPE_CHECKING:
    from rich.console import Console

    from ...experiment.study import Study

NO_LAWS = "No laws of it are known."
PRECISIONS = ("double", "quad")
DIRECTIONS = ("rising", "falling", "both")

#: Bounds of the tolerance of one step.
FINEST, COARSEST = 1e-16, 0.1

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
        help="Override a key of the experiment file, e.g. body.mass=2 or run.until=5; a parameter "
        "by its name alone, e.g. I_1=2.",
    ),
]
Effort = Annotated[
    float,
    typer.Option(
        metavar="FACTOR",
        help="Work allowed for the proof of one law before it is left undecided: 1 is two "
        "thousand million operations, some minutes on one core; 0.1 is a tenth of that. "
        "Operations are counted, so every machine reaches the same answer.",
    ),
]
Json = Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")]
Force = Annotated[bool, typer.Option("--force", help="Replace files that exist already.")]
Precision = Annotated[
    str | None,
    typer.Option(help="double (16 digits) or quad (34 digits); short for --set run.precision=…."),
]


def _checked_tolerance(value: float) -> float:
    from flowlanes.errors import InputError

    if not FINEST <= value <= COARSEST:
        raise InputError(f"--tolerance {value:g}: it must lie between {FINEST:g} and {COARSEST:g}")
    return value


def _checked_direction(value: str) -> str:
    from flowlanes.errors import InputError

    if value not in DIRECTIONS:
        raise InputError(f"--direction {value}: it must be one of {', '.join(DIRECTIONS)}")
    return value


def at_least_one(option: typer.CallbackParam, value: int) -> int:
    """The number of an option that counts, or an InputError."""
    from flowlanes.errors import InputError

    if value < 1:
        raise InputError(f"{option.opts[0]} {value}: there must be one at least")
    return value


# What costs nothing to check is refused before anything is imported.
Tolerance = Annotated[
    float, typer.Option(help="Error tolerance of one step.", callback=_checked_tolerance)
]
Direction = Annotated[
    str,
    typer.Option(help="Crossings to count: rising, falling or both.", callback=_checked_direction),
]


#: Columns of a table that nothing cuts.
NO_LIMIT = 10_000


def complain(text: str) -> None:
    """Say what went wrong, on standard error."""
    typer.secho("error: ", fg="red", bold=True, err=True, nl=False)
    typer.echo(text, err=True)


def inform(text: str) -> None:
    """Say something besides the result, on standard error, unless that is not wanted."""
    LOG.info(text)


def console() -> Console:
    """The console for tables, as wide as the terminal, unlimited in a file."""
    from rich.console import Console

    limited = sys.stdout.isatty() or "COLUMNS" in os.environ
    return Console(width=None if limited else NO_LIMIT, highlight=False)


def print_json(value: object) -> None:
    """The result for another program."""
    typer.echo(json.dumps(value, indent=2, ensure_ascii=False))


def operations(effort: float) -> int:
    """The term operations that ``--effort`` stands for.

    Raises
    ------
    InputError
        If it is not positive and finite.
    """
    from flowlanes.errors import InputError
    from lawproof.proof.fields.budget import EFFORT

    if not 0 < effort < float("inf"):
        raise InputError(f"--effort {effort:g}: it must be a positive number")
    return max(1, round(effort * EFFORT))


def is_name(what: str) -> bool:
    """Whether NAME or FILE means a system of the catalogue; what it means is there.

    Raises
    ------
    InputError
        If there is no such file or system.
    """
    from flowlanes.errors import InputError
    from nonholonomic.catalogue.groups import NAMES
    from nonholonomic.catalogue.names import lookup

    if not what.strip():
        raise InputError("NAME|FILE is empty: a catalogue name or a file is needed")
    path = Path(what)
    named = path.suffix not in (".py", ".toml") and len(path.parts) == 1 and not path.is_file()
    if named:
        lookup(dict.fromkeys(NAMES, True), what)
    elif not path.exists():
        raise InputError(f"{what}: there is no such file")
    return named


def study_of(what: str, overrides: list[str] | None, precision: str | None = None) -> Study:
    """Make ready the experiment that NAME or FILE means.

    Raises
    ------
    InputError
        If there is no such file or system, or something in it is wrong.
    """
    from flowlanes.errors import InputError

    path, named = Path(what), is_name(what)
    options = list(overrides or [])
    if precision is not None:
        if precision not in PRECISIONS:
            raise InputError(f"--precision {precision}: it must be {' or '.join(PRECISIONS)}")
        options.append(f"run.precision={precision}")
    keys = [option.partition("=")[0].strip() for option in options]
    if twice := next((key for key in keys if keys.count(key) > 1), ""):
        raise InputError(f"{twice} is set twice: leave out one of them")
    with waiting(f"preparing {what}") as report:
        if path.suffix == ".py":
            report.say(f"running {what}")
            from ...experiment.python_file import load_python

            study = load_python(path, options)
        else:
            from ...experiment.models.experiment import catalogue_experiment, load

            experiment = catalogue_experiment(what, options) if named else load(path, options)
            from ...experiment.subjects.subject_of import subject_of

            # what is wrong with a name, a file or a parameter is said before the rest is imported
            subject = subject_of(experiment)
            report.say(f"preparing {subject.system.title}")
            from ...experiment.study import Study

            study = Study(experiment, subject)
    for remark in study.remarks:
        inform(f"note: {remark}")
    return study
