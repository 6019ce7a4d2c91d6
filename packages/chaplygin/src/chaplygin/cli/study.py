"""``chaplygin study``: from an experiment file to a report."""

from __future__ import annotations

from pathlib import Path

import typer

from ..interruption import NOTHING_SAVED, message_on_interrupt
from .messages.results import results
from .terminal.options import operations, print_json, study_of
from .terminal.output_destination import STANDARD_OUTPUT
from .terminal.progress import progress


def command(
    what: str,
    output: str | None = None,
    overrides: list[str] | None = None,
    precision: str | None = None,
    quick: bool = False,
    effort: float | None = None,
    force: bool = False,
    json: bool = False,
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
    from ..report.page import EFFORT_PER_PROOF, TIMES
    from ..report.study_output import write_study

    each = allowed or EFFORT_PER_PROOF

    def words() -> str:
        if not is_begun(folder):
            return NOTHING_SAVED
        return f"the part that is done is in {folder}; the same command resumes there"

    with message_on_interrupt(words), progress(f"integrating: {study.system.title}") as report:
        try:
            trajectory, failure = write_study(
                study,
                folder,
                force=force,
                effort=each,
                total_budget=0 if quick else TIMES * each,
                progress=report,
            )
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
