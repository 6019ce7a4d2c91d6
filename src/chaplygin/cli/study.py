"""``chaplygin study``: the main job, from words to a report."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from .common import Force, Json, Override, Precision, What, print_json, progress, study_of

__all__ = ["command"]


def command(
    what: What,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="Folder to write; the name if left out.")
    ] = None,
    overrides: Override = None,
    precision: Precision = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Equations, trajectory, figures and a report of one motion."""
    from ..study.folder import check_folder, write_study
    from ..study.summary import summary, summary_text

    study = study_of(what, overrides, precision)
    folder = output or Path(Path(what).stem)
    check_folder(folder, force)
    with progress(study.system.title) as update:
        trajectory, failure = write_study(study, folder, force, update)
    result = summary(trajectory)
    if json:
        print_json({"folder": str(folder), **result})
    else:
        typer.echo(summary_text(study.system, trajectory, result))
        typer.echo(f"report: {folder / 'report.html'}")
    if failure is not None:
        raise failure
