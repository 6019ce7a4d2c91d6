"""``chaplygin ensemble``: many motions at once, streamed to a store."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE

from .terminal.options import inform, print_json, study_of
from .terminal.progress import progress
from .terminal.stores import (
    check_store,
    check_workers,
    device_of,
    level_of,
    outcomes,
    require_parameter,
    resumable,
    vacate,
)

if TYPE_CHECKING:
    from flowlanes.flow.devices.graphics import Device
    from flowlanes.flow.ensembles.members import Members
    from flowlanes.flow.ensembles.task import Task

    from ..experiment.study import Study


def command(
    what: str,
    output: Path,
    starts: int = 1,
    level: str | None = None,
    draw: list[str] | None = None,
    seed: int = 0,
    over: list[str] | None = None,
    record: list[str] | None = None,
    tolerance: float = ENSEMBLE_TOLERANCE,
    workers: str | None = None,
    device: str = "cpu",
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Integrate motions from many starts and parameters; resumes an interrupted run.

    Every start is combined with every parameter value. The start (the initial
    state) is that of the experiment, or starts are drawn at random on a level of
    the integrals; the times are those of the experiment. With friction, numbers
    of the file are drawn from ranges.
    """
    from flowlanes.scans.axis_text import axis_parts

    check_store(output)
    client, chosen = check_workers(workers), device_of(device)
    for text in over or ():
        axis_parts(text, "--over")
    study = study_of(what, overrides)
    from flowlanes.flow.ensembles.computation import compute

    if study.subject.changes_equations:
        from flowlanes.flow.devices.graphics import refuse_graphics

        from ..experiment.friction_studies.ensemble import contact_ensemble_task

        refuse_graphics(chosen)
        task = contact_ensemble_task(
            study,
            _numbers(starts, level, draw or [], seed, over or []),
            record=record or (),
            tolerance=tolerance,
        )
    else:
        task = _task(study, starts, level, draw, seed, over, record, (tolerance, chosen), workers)
    vacate(output, force)
    title = study.system.title
    with progress(title) as report, resumable(output, report, force) as update:
        dataset = compute(task, output, client=client, progress=update)
    result = {
        "file": str(output),
        "members": dataset.attrs["members"],
        "measure": dataset.attrs.get("measure", ""),
        "motions": dataset.sizes["run"],
        "times": dataset.sizes["time"],
        "outcomes": outcomes(dataset["outcome"]),
    }
    if json:
        print_json(result)
        return
    typer.echo(f"{study.system.title}: {result['members']}")
    if result["measure"]:
        typer.echo(f"starts drawn according to the {result['measure']}")
    for reason, count in result["outcomes"].items():
        typer.echo(f"{count:,} of {result['motions']:,} motions: {reason}")
    inform(f"written to {output}")


def _task(
    study: Study,
    starts: int,
    level: str | None,
    draw: list[str] | None,
    seed: int,
    over: list[str] | None,
    record: list[str] | None,
    numerics: tuple[float, Device],
    workers: str | None,
) -> Task:
    """Ensemble of a system whose equations do not change at events."""
    from dataclasses import replace

    from flowlanes.errors import InputError
    from flowlanes.flow.ensembles.run import SHARES, ensemble_task

    from ..experiment.single_system import without_reconstruction

    if draw:
        raise InputError(
            f"--draw {draw[0]}: only with friction are starts drawn from ranges; here they are "
            "drawn on a level of the integrals, with --level"
        )
    task = ensemble_task(
        without_reconstruction(study),
        _members(study, starts, level, seed, over or []),
        study.times,
        record=record or (),
        tolerance=numerics[0],
        device=numerics[1],
        shares=1 if workers is None else SHARES,
    )
    return replace(task, attributes={**task.attributes, "experiment": study.complete_toml()})


def _numbers(
    starts: int, level: str | None, draw: list[str], seed: int, over: list[str]
) -> Members:
    """Members of an ensemble with friction: numbers of its file."""
    import numpy as np

    from flowlanes.errors import InputError
    from flowlanes.flow.ensembles.members import grid
    from flowlanes.scans.grid import axis

    from ..experiment.friction_studies.random_starts import random_numbers

    if level is not None:
        raise InputError(
            f"--level {level}: with friction no integrals remain; draw numbers of the file from "
            "ranges, as in --draw omega_3=0:10"
        )
    if starts > 1 and not draw:
        raise InputError(
            f"--starts {starts}: it is not said what differs; --draw NAME=A:B draws a number"
        )
    factors = [random_numbers(starts, dict(map(_range, draw)), seed)] if draw else []
    for text in over:
        chosen = axis(text, "--over")
        values = np.linspace(chosen.first, chosen.last, chosen.count)
        factors.append(grid(**{chosen.name: values}))
    if not factors:
        raise InputError("an ensemble needs --draw NAME=A:B or --over NAME=A:B:N")
    everyone = factors[0]
    for factor in factors[1:]:
        everyone = everyone * factor
    return everyone


def _range(text: str) -> tuple[str, tuple[float, float] | None]:
    """Number with a range; None for a direction."""
    from flowlanes.errors import InputError

    name, equals, span = (part.strip() for part in text.partition("="))
    if not equals:
        return name, None
    try:
        first, last = map(float, span.split(":"))
    except ValueError:
        raise InputError(
            f"--draw {text}: it is written NAME=A:B, such as omega_3=0:10, or gamma or attitude "
            "alone"
        ) from None
    return name, (first, last)


def _members(study: Study, starts: int, level: str | None, seed: int, over: list[str]) -> Members:
    """Members of the ensemble."""
    import numpy as np

    from flowlanes.errors import InputError
    from flowlanes.flow.ensembles.members import grid, random_starts, single
    from flowlanes.scans.grid import axis

    if level is not None:
        everyone = random_starts(starts, level_of(level), seed)
    elif starts == 1:
        everyone = single(**given_start(study))
    else:
        raise InputError(f"--starts {starts}: they are drawn on a level; --level is needed")
    for text in over:
        chosen = axis(text, "--over")
        require_parameter("--over", chosen.name, study)
        values = np.linspace(chosen.first, chosen.last, chosen.count)
        everyone = everyone * grid(**{chosen.name: values})
    return everyone


def given_start(study: Study) -> dict[str, Any]:
    """Start of the experiment: ω and γ, or the whole state."""
    if study.subject.starts_by_velocity and set(study.start_values) == {"omega", "gamma"}:
        return dict(study.start_values)
    size = len(study.system.symbols)
    return {"state": [float(value) for value in study.start[:size]]}
