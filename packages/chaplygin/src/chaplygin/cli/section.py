"""``chaplygin section``: the points at which motions repeatedly cross a surface."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE

from .terminal.options import console, inform, print_json, study_of
from .terminal.output_destination import STANDARD_OUTPUT
from .terminal.progress import progress
from .terminal.stores import (
    check_picture,
    check_store,
    check_workers,
    device_of,
    level_of,
    outcomes,
    resumable,
    vacate,
)

if TYPE_CHECKING:
    import xarray as xr

#: Number of points processed together.
_AT_ONCE = 2**18


def command(
    what: str,
    on: str,
    output: Path,
    value: float = 0.0,
    direction: str = "rising",
    angle: bool = False,
    within: list[str] | None = None,
    points: int = 1000,
    starts: int = 1,
    level: str | None = None,
    seed: int = 0,
    coordinates: str = "",
    until: float | None = None,
    tolerance: float = ENSEMBLE_TOLERANCE,
    workers: str | None = None,
    device: str = "cpu",
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Compute and draw a Poincaré section; resumes an interrupted run.

    The section is the set of states at which a quantity passes a value; every
    motion is integrated until it has crossed the section the required number of
    times.
    """
    store = _store(output)
    client, processor = check_workers(workers), device_of(device)
    picture = store.with_suffix(".png")
    if output.is_dir() or output == store:
        check_picture(store, picture, force)
    study = study_of(what, overrides)
    from shutil import rmtree

    from flowlanes.errors import InputError, RunError
    from flowlanes.flow.ensembles.computation import compute

    from ..experiment.poincare import SectionSurface, Starts, section_of
    from ..report.drawing.files import save
    from ..report.figures.poincare import draw_section

    surface = SectionSurface(
        on, value, direction, angle, tuple(_slab(text) for text in within or ())
    )
    chosen = Starts(starts, None if level is None else level_of(level), seed)
    if study.subject.changes_equations:
        from flowlanes.flow.devices.graphics import refuse_graphics

        from ..experiment.friction_studies.section import contact_section_task

        refuse_graphics(processor)
        if starts != 1 or level is not None:
            raise InputError(
                "--starts, --level: with friction no integrals remain on whose level starts could "
                "be drawn; the section is that of the start in the file"
            )
        task, names = contact_section_task(
            study,
            surface,
            points,
            coordinates=coordinates,
            t_end=study.until if until is None else until,
            tolerance=tolerance,
        )
    else:
        limit = abs(study.until) * max(points, 1) if until is None else until
        task, names = section_of(
            study,
            surface,
            chosen,
            points,
            coordinates,
            t_end=limit,
            tolerance=tolerance,
            device=processor,
        )
    if output != store:
        output.mkdir(exist_ok=True)
    vacate(store, force)
    title = f"{study.system.title}, {surface}"
    with progress(title) as report, resumable(store, report, force) as update:
        dataset = compute(task, store, client=client, progress=update)
    result = {"file": str(store), "figure": str(picture), **_summary(dataset)}
    if not result["points"]:
        dataset.close()
        # Another section may be requested with the same name.
        rmtree(store)
        reasons = ", ".join(result["outcomes"])
        raise RunError(f"no motion passes {surface}: {reasons}", result["longest"])
    save(draw_section(dataset, names), picture)
    if json:
        print_json(result)
    else:
        _print(study.system.title, result)


def _store(output: Path) -> Path:
    """Store: the given path itself, or a store in a folder."""
    from flowlanes.errors import InputError

    if output.suffix == ".zarr":
        check_store(output)
        return output
    if output == STANDARD_OUTPUT:
        raise InputError("--output -: a store is a folder; it cannot go to standard output")
    if output.suffix and not output.is_dir():
        raise InputError(f"--output {output}: its name must end in .zarr, or be that of a folder")
    if output.is_file():
        raise InputError(f"--output {output}: a file has this name, which must be that of a folder")
    if not output.parent.is_dir():
        raise InputError(f"--output {output}: there is no folder {output.parent}")
    return output / "section.zarr"


def _slab(text: str) -> tuple[str, float]:
    """Quantity, and its largest distance from zero."""
    from flowlanes.errors import InputError

    quantity, less, width = (part.strip() for part in text.rpartition("<"))
    try:
        if not (quantity and less):
            raise ValueError
        return quantity, float(width)
    except ValueError:
        raise InputError(
            f"--within {text}: it is written QUANTITY<WIDTH, such as 'M_3 < 0.1'"
        ) from None


def _summary(dataset: xr.Dataset) -> dict[str, Any]:
    """Facts of a section: file, points, drift and outcomes."""
    drifts = {
        str(name).removeprefix("law_"): _drift(dataset[name])
        for name in dataset.data_vars
        if str(name).startswith("law_")
    }
    return {
        "section": dataset.attrs["section"],
        "coordinates": list(dataset.attrs["coordinates"]),
        "starts": dataset.attrs["starts"],
        "runs": dataset.sizes["run"],
        "points": int(dataset["points"].sum()),
        "longest": float(dataset["ended"].max()),
        "drift": drifts,
        "outcomes": outcomes(dataset["outcome"]),
    }


def _drift(values: xr.DataArray) -> float:
    """Largest change of an integral along a run, relative to its size."""
    import numpy as np

    change = size = 0.0
    motions = max(1, _AT_ONCE // values.sizes["section_point"])
    for first in range(0, values.sizes["run"], motions):
        part = values.isel(run=slice(first, first + motions)).values
        change = max(change, float(np.nanmax(np.abs(part - part[:, :1]), initial=0.0)))
        size = max(size, float(np.nanmax(np.abs(part), initial=0.0)))
    return change / size if size else change


def _print(title: str, result: dict[str, Any]) -> None:
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    typer.echo(title)
    motions = "1 motion" if result["runs"] == 1 else f"{result['runs']:,} motions"
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False, show_header=False)
    table.add_column(style="bold", no_wrap=True)
    table.add_column()
    table.add_row("section", escape(result["section"]))
    table.add_row("starts", escape(result["starts"]))
    table.add_row("points", f"{result['points']:,} of {motions}")
    table.add_row("longest motion", f"{result['longest']:.6g} s")
    for name, drift in result["drift"].items():
        table.add_row(f"drift of {escape(name)}", f"{drift:.1e}")
    for reason, count in result["outcomes"].items():
        table.add_row(f"{count:,} of {result['runs']:,}", escape(reason))
    console().print(table)
    inform(f"written to {result['file']}, figure: {result['figure']}")
