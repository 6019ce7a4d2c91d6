"""``chaplygin sweep``: one start, a list of parameter values."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import typer

from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE

from .ensemble import given_start
from .terminal.options import inform, print_json, study_of
from .terminal.output_destination import check_figure
from .terminal.progress import progress
from .terminal.stores import (
    check_picture,
    check_store,
    check_workers,
    outcomes,
    require_parameter,
    resumable,
    vacate,
)


def command(
    what: str,
    over: list[str],
    output: Path,
    record: list[str] | None = None,
    draw: str | None = None,
    figure: Path | None = None,
    tolerance: float = ENSEMBLE_TOLERANCE,
    workers: str | None = None,
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Integrate one motion for each value of a parameter; resumes an interrupted run.

    Every motion has the start and the times of the experiment and is streamed to
    a store, like the motions of an ensemble.
    """
    from flowlanes.scans.axis_text import axis_parts

    check_store(output)
    client = check_workers(workers)
    picture = output.with_suffix(".png") if figure is None else figure
    check_figure("--figure", picture)
    check_picture(output, picture, force, by_user=figure is not None)
    for text in over:
        if ":" in text:
            axis_parts(text, "--over")
        else:
            values_of(text)
    study = study_of(what, overrides)
    values = [values_of(text) for text in over]
    from dataclasses import replace

    from flowlanes.flow.ensembles.computation import compute
    from flowlanes.flow.ensembles.members import grid, single
    from flowlanes.flow.ensembles.run import SHARES, ensemble_task

    from ..experiment.single_system import without_reconstruction
    from ..report.drawing.files import save
    from ..report.figures.sweep import sweep as drawn

    system = without_reconstruction(study)
    everyone = single(**given_start(study))
    for name, numbers in values:
        require_parameter("--over", name, study)
        everyone = everyone * grid(**{name: numbers})
    label = str(system.symbols[0]) if draw is None else draw
    task = ensemble_task(
        system,
        everyone,
        study.times,
        record=record or (),
        tolerance=tolerance,
        shares=1 if workers is None else SHARES,
    )
    _require_drawable(label, [str(s) for s in system.symbols], record or [])
    task = replace(task, attributes={**task.attributes, "experiment": study.complete_toml()})
    vacate(output, force)
    title = study.system.title
    with progress(title) as report, resumable(output, report, force) as update:
        dataset = compute(task, output, client=client, progress=update)
    names = [name for name, _ in values]
    figure_of_motions = drawn(dataset, names, label)
    save(figure_of_motions, picture)
    if figure_of_motions.axes[0].lines[0].get_linestyle() == "None":
        inform(
            "note: the samples are too far apart to be joined by lines; "
            f"--set run.samples={10 * (len(study.times) - 1) + 1} takes ten times as many"
        )
    result: dict[str, Any] = {
        "file": str(output),
        "figure": str(picture),
        "parameters": dict(values),
        "motions": dataset.sizes["run"],
        "times": dataset.sizes["time"],
        "outcomes": outcomes(dataset["outcome"]),
    }
    if json:
        print_json(result)
        return
    words = ", ".join(f"{len(numbers)} of {name}" for name, numbers in values)
    typer.echo(f"{study.system.title}: {result['motions']:,} motions, {words}")
    for reason, count in result["outcomes"].items():
        typer.echo(f"{count:,} of {result['motions']:,} motions: {reason}")
    inform(f"written to {output}, figure: {picture}")


def values_of(text: str) -> tuple[str, list[float]]:
    """Parameter and its values, from ``m=1,1.5,2`` or ``m=1:2:5``.

    Raises
    ------
    InputError
        If the text has a different form.
    """
    from flowlanes.errors import InputError

    name, _, span = (part.strip() for part in text.partition("="))
    if ":" in span:
        from flowlanes.scans.grid import axis

        chosen = axis(text, "--over")
        return chosen.name, [float(value) for value in chosen.values]
    try:
        if not name.isidentifier():
            raise ValueError
        numbers = [float(part) for part in span.split(",")]
    except ValueError:
        raise InputError(
            f"--over {text}: it is written NAME=VALUE,VALUE,… or NAME=FIRST:LAST:COUNT, such as "
            "m=1,1.5,2 or m=1:2:5"
        ) from None
    if not all(map(math.isfinite, numbers)) or len(set(numbers)) < len(numbers):
        raise InputError(f"--over {text}: its values must be finite and differ from one another")
    return name, numbers


def _require_drawable(label: str, symbols: list[str], records: list[Any]) -> None:
    """Raise an error for a figure of a quantity that is not recorded."""
    from flowlanes.errors import InputError

    names = [*symbols, *records]
    if label not in names and label.rpartition("_")[0] not in records:
        raise InputError(
            f"--draw {label}: it must be one of {', '.join(names)}, or be recorded (--record)"
        )
