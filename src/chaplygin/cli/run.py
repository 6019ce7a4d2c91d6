"""``chaplygin run``: the trajectory alone."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .common import Force, Json, Override, Precision, What, inform, print_json, progress, study_of

__all__ = ["command"]


def command(
    what: What,
    output: Annotated[
        Path,
        typer.Option(
            "-o", "--output", metavar="FILE", help="Written by its ending: .nc, .zarr or .csv."
        ),
    ],
    overrides: Override = None,
    precision: Precision = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Integrate a motion and write it to a file: NetCDF, Zarr, or a table for a spreadsheet."""
    from ..errors import InputError, RunError
    from ..study.dataset import write
    from ..study.formats import check_output
    from ..study.prepare import dataset_of
    from ..study.summary import summary, summary_text

    check_output(output, force)
    if output.exists() and Path(what).exists() and output.samefile(what):
        raise InputError(f"{output} is the experiment file itself: choose another name")
    study = study_of(what, overrides, precision)
    try:
        with progress(study.system.title) as update:
            trajectory = study.trajectory(update)
    except RunError as error:
        if error.partial is not None:
            write(dataset_of(study, error.partial, complete=False), output, force)
            inform(f"what was computed until then is in {output}")
        raise
    write(dataset_of(study, trajectory), output, force)
    result = summary(trajectory)
    if json:
        print_json({"file": str(output), **result})
    else:
        typer.echo(summary_text(study.system, trajectory, result))
        typer.echo(f"written to {output}")
