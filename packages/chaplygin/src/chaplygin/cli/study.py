"""``chaplygin study``: from an experiment file to a report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from ..interruption import NOTHING_SAVED, message_on_interrupt
from .messages.results import results
from .terminal.options import (
    Force,
    Json,
    Override,
    Precision,
    What,
    operations,
    print_json,
    study_of,
)
from .terminal.output_destination import STANDARD_OUTPUT
from .terminal.progress import progress


def command(
    what: What,
    output: Annotated[
        str | None,
        typer.Option(
            "-o",
            "--output",
            metavar="FOLDER",
            help="Folder to write; default: named after NAME|FILE.",
        ),
    ] = None,
    overrides: Override = None,
    precision: Precision = None,
    quick: Annotated[
        bool, typer.Option("--quick", help="Skip the proofs; laws are only observed.")
    ] = False,
    effort: Annotated[
        float | None,
        typer.Option(
            metavar="FACTOR",
            help="Work allowed for the proof of one law, in the units of prove --effort; default "
            "0.05. All proofs together may take four times as much.",
        ),
    ] = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Write equations, trajectory, figures and a report of one motion; resumes if interrupted."""
    from flowlanes.errors import InputError, InterruptionError

    from ..report.study_folder import check_folder, is_begun

    if output == "":
        raise InputError("--output is empty: the name of a folder is needed")
    if output == str(STANDARD_OUTPUT):
        raise InputError("--output -: a study is a folder; it cannot go to standard output")
    if quick and effort is not None:
        raise InputError("--quick leaves out the proofs that --effort is for: choose one of them")
    folder = Path(output or Path(what).stem)
    check_folder(folder, force, what)
    allowed = None if effort is None else operations(effort)
    study = study_of(what, overrides, precision)
    from nonholonomic.classification.facts import ProofBudget

    from ..report.page import EFFORT_PER_PROOF, TIMES
    from ..report.study_output import write_study

    each = allowed or EFFORT_PER_PROOF
    # a law of one mode alone says nothing of a motion through several
    altogether = 0 if quick or study.subject.changes_equations else TIMES * each

    def words() -> str:
        if not is_begun(folder):
            return NOTHING_SAVED
        return f"the part that is done is in {folder}; the same command resumes there"

    with message_on_interrupt(words), progress(f"integrating: {study.system.title}") as report:
        budget = ProofBudget(each, altogether, lambda what: report.say(f"proving: {what}"))
        try:
            trajectory, failure = write_study(study, folder, force, budget, report)
        except InterruptionError as stop:
            raise KeyboardInterrupt from stop
    facts, text = results(study, trajectory)
    if json:
        print_json({"folder": str(folder), **facts})
    else:
        typer.echo(text)
        typer.echo(f"report: {folder / 'report.html'}")
    if failure is not None:
        raise failure
