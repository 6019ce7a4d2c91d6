"""``chaplygin run``: the trajectory alone."""

from __future__ import annotations

from pathlib import Path

import typer

from ..interruption import EXIT_CODE, NOTHING_SAVED, message_on_interrupt, print_interruption
from .messages.results import results
from .terminal.options import inform, print_json, study_of
from .terminal.output_destination import beside, check_output, deliver, name_of
from .terminal.progress import progress


def command(
    what: str,
    output: Path,
    overrides: list[str] | None = None,
    precision: str | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Integrate one motion and write the trajectory: NetCDF, Zarr, or a table for a spreadsheet."""
    from ..experiment.formats import check_output as check_trajectory

    check_output("--output", output, force, json, what, place=check_trajectory)
    study = study_of(what, overrides, precision)
    from flowlanes.errors import InterruptionError, RunError

    from ..experiment.study import dataset_of

    place = name_of(output)
    failure: RunError | None = None
    with message_on_interrupt(
        NOTHING_SAVED, f"the trajectory computed so far is being written to {place}"
    ):
        with progress(study.system.title) as report:
            try:
                trajectory = study.trajectory(report)
            except RunError as error:
                if error.partial is None:
                    raise
                trajectory, failure = error.partial, error
        deliver(dataset_of(study, trajectory, complete=failure is None), output, force)
    if isinstance(failure, InterruptionError):
        print_interruption(
            f"the trajectory up to t = {failure.time:.9g} is in {place}; the same command with "
            "--force starts from the beginning"
        )
        raise typer.Exit(EXIT_CODE)
    if failure is not None:
        inform(f"the trajectory up to then is in {place}")
        raise failure
    facts, text = results(study, trajectory)
    if json:
        print_json({"file": str(output), **facts})
    else:
        with beside(output):
            typer.echo(text)
            typer.echo(f"written to {place}")
