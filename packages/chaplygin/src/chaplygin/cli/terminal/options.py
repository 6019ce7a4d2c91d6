"""Options and arguments shared by several commands, and their output."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from .progress import LOG, waiting

if TYPE_CHECKING:
    from rich.console import Console

    from ...experiment.study import Study

NO_LAWS = "No laws of it are known."


#: Number of columns of a table that is never cut.
NO_LIMIT = 10_000


def complain(text: str) -> None:
    """Print an error to standard error."""
    typer.secho("error: ", fg="red", bold=True, err=True, nl=False)
    typer.echo(text, err=True)


def inform(text: str) -> None:
    """Print a note to standard error, unless notes are suppressed."""
    LOG.info(text)


def console() -> Console:
    """Console for tables, as wide as the terminal, and without limit in a file."""
    from rich.console import Console

    limited = sys.stdout.isatty() or "COLUMNS" in os.environ
    return Console(width=None if limited else NO_LIMIT, highlight=False)


def print_json(value: object) -> None:
    """Print the result as JSON."""
    typer.echo(json.dumps(value, indent=2, ensure_ascii=False))


def operations(effort: float) -> int:
    """Number of term operations for a value of ``--effort``.

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
    """True if NAME or FILE is a system of the catalogue; it must exist.

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
    """Prepared experiment for NAME or FILE.

    Raises
    ------
    InputError
        If there is no such file or system, or it contains a mistake.
    """
    from flowlanes.errors import InputError

    path, named = Path(what), is_name(what)
    options = list(overrides or [])
    if precision is not None:
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
            from ...experiment.models.experiment import catalogue_experiment, load_experiment

            experiment = (
                catalogue_experiment(what, options) if named else load_experiment(path, options)
            )
            from ...experiment.subjects.subject_of import subject_of

            # Mistakes in a name, a file or a parameter are reported before the slow imports.
            subject = subject_of(experiment)
            report.say(f"preparing {subject.system.title}")
            from ...experiment.study import Study

            study = Study(experiment, subject)
    inform_remarks(study.remarks)
    return study


def inform_remarks(remarks: Iterable[str]) -> None:
    """Print remarks on the input."""
    for remark in remarks:
        inform(f"note: {remark}")
