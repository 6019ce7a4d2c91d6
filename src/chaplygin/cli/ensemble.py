"""``chaplygin ensemble``: many motions at once, streamed to a store."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .common import Force, Json, Override, What, inform, print_json, study_of
from .progress import progress
from .stores import Workers, check_store, check_workers, level_of, outcomes, resumable, vacate

if TYPE_CHECKING:
    from ..experiment.study import Study
    from ..flow.ensemble.members import Members


def command(
    what: What,
    output: Annotated[Path, typer.Option("-o", "--output", help="Zarr store to write, FILE.zarr.")],
    starts: Annotated[
        int, typer.Option(help="Number of starts to draw at random; needs --level.")
    ] = 1,
    level: Annotated[
        str | None,
        typer.Option(
            metavar="NAME=VALUE,…", help="Level of the integrals on which starts are drawn."
        ),
    ] = None,
    seed: Annotated[int, typer.Option(help="Seed of the random starts.")] = 0,
    over: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME=A:B:N", help="Vary a parameter: N values from A to B."),
    ] = None,
    record: Annotated[
        list[str] | None,
        typer.Option(metavar="NAME", help="Also record this observable or integral."),
    ] = None,
    tolerance: Annotated[float, typer.Option(help="Error tolerance of one step.")] = 1e-13,
    workers: Workers = None,
    overrides: Override = None,
    force: Force = False,
    json: Json = False,
) -> None:
    """Integrate motions from many starts and parameters; resumes an interrupted run.

    Every start is combined with every parameter value. The start (the initial
    state) is that of the experiment, or starts are drawn at random on a level of
    the integrals; the times are those of the experiment.
    """
    check_store(output)
    client = check_workers(workers)
    study = study_of(what, overrides)
    from dataclasses import replace

    from ..experiment.without_lift import without_reconstruction
    from ..flow.ensemble.compute import compute
    from ..flow.ensemble.run import SHARES, ensemble_task

    task = ensemble_task(
        without_reconstruction(study),
        _members(study, starts, level, seed, over or []),
        study.times,
        record=record or (),
        tolerance=tolerance,
        shares=1 if workers is None else SHARES,
    )
    task = replace(task, attributes={**task.attributes, "experiment": study.complete_toml()})
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


def _members(study: Study, starts: int, level: str | None, seed: int, over: list[str]) -> Members:
    """The members of the ensemble."""
    import numpy as np

    from ..analysis.scans.grid import axis
    from ..errors import InputError
    from ..flow.ensemble.run import grid, random_starts, single

    if starts < 1:
        raise InputError(f"--starts {starts}: there must be one at least")
    if level is not None:
        everyone = random_starts(starts, level_of(level), seed)
    elif starts == 1:
        everyone = single(**given_start(study))
    else:
        raise InputError(f"--starts {starts}: they are drawn on a level; --level is needed")
    for text in over:
        chosen = axis(text, "--over")
        values = np.linspace(chosen.first, chosen.last, chosen.count)
        everyone = everyone * grid(**{chosen.name: values})
    return everyone


def given_start(study: Study) -> dict[str, Any]:
    """The start of the experiment: ω and γ, or the whole state."""
    if study.subject.starts_by_velocity and set(study.start_values) == {"omega", "gamma"}:
        return dict(study.start_values)
    size = len(study.system.symbols)
    return {"state": [float(value) for value in study.start[:size]]}
