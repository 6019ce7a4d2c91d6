"""``chaplygin chart``: a quantity over a plane of parameters and starts."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import typer

from .terminal.options import console, inform, print_json, study_of
from .terminal.output_destination import check_figure
from .terminal.progress import progress
from .terminal.stores import (
    check_picture,
    check_store,
    check_workers,
    device_of,
    outcomes,
    resumable,
    vacate,
)

if TYPE_CHECKING:
    import xarray as xr


def command(
    what: str,
    of: str,
    x: str,
    y: str,
    output: Path,
    until: float | None = None,
    let: list[str] | None = None,
    hold: list[str] | None = None,
    figure: Path | None = None,
    workers: str | None = None,
    device: str = "cpu",
    overrides: list[str] | None = None,
    force: bool = False,
    json: bool = False,
) -> None:
    """Chart a number over a plane of parameters and starts; resumes an interrupted run.

    An axis is a parameter, a variable of the start (the initial state), a
    quantity such as energy on whose level the start is placed, or a new name for
    the formulas of --let. With friction it is a number of the file, such as mu or
    omega_3, or a new name.
    """
    from flowlanes.scans.axis_text import axis_parts

    picture = output.with_suffix(".png") if figure is None else figure
    check_store(output)
    check_figure("--figure", picture)
    check_picture(output, picture, force, by_user=figure is not None)
    client, chosen = check_workers(workers), device_of(device)
    formulas = dict(_assignment(item) for item in let or ())
    for text, option in ((x, "--x"), (y, "--y")):
        axis_parts(text, option)
    study = study_of(what, overrides)
    from flowlanes.flow.ensembles.computation import compute
    from flowlanes.scans.grid import axis

    from ..experiment.friction_studies.chart_task import chart_task
    from ..report.drawing.files import save
    from ..report.figures.scan import chart as drawn

    horizontal, vertical = axis(x, "--x"), axis(y, "--y")
    task, title = chart_task(
        study,
        of,
        horizontal,
        vertical,
        t_end=until,
        formulas=formulas,
        fixed=hold or (),
        device=chosen,
    )
    vacate(output, force)
    with progress(title) as report, resumable(output, report, force) as update:
        dataset = compute(task, output, client=client, progress=update)
        report.say("drawing")
        save(drawn(dataset), picture)
    result = {"file": str(output), "figure": str(picture), **_summary(dataset)}
    if json:
        print_json(result)
    else:
        _print(study.system.title, result)


def _assignment(text: str) -> tuple[str, str]:
    """Name and formula of an option NAME=FORMULA."""
    from flowlanes.errors import InputError

    name, equals, formula = (part.strip() for part in text.partition("="))
    if not (name and equals and formula):
        raise InputError(f"--let {text}: it is written NAME=FORMULA, such as gamma_1=sin(theta)")
    return name, formula


def _summary(dataset: xr.Dataset) -> dict[str, Any]:
    """Facts of a chart: file, number, range and outcomes."""
    import numpy as np

    name = str(dataset.attrs["number"])
    number = dataset[name]
    values = number.values[np.isfinite(number.values)]
    lowest, median, highest = (
        np.quantile(values, [0.0, 0.5, 1.0]).tolist() if len(values) else [None] * 3
    )
    y, x = number.dims
    return {
        "number": name,
        "title": number.attrs["long_name"],
        "units": number.attrs["units"],
        "x": x,
        "y": y,
        "cells": number.size,
        "with_number": len(values),
        "lowest": lowest,
        "median": median,
        "highest": highest,
        "outcomes": outcomes(dataset["outcome"]),
    }


def _print(title: str, result: dict[str, Any]) -> None:
    from rich import box
    from rich.markup import escape
    from rich.table import Table

    from flowlanes.printing.numerals import unit as unit_text

    typer.echo(title)
    unit = "" if result["units"] in ("1", "unknown") else f" {unit_text(result['units'])}"
    table = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False, show_header=False)
    table.add_column(style="bold", no_wrap=True)
    table.add_column()
    table.add_row("number", escape(result["title"]))
    for word in ("lowest", "median", "highest"):
        if result[word] is not None:
            table.add_row(word, f"{result[word]:.6g}{unit}")
    table.add_row("cells", f"{result['with_number']:,} of {result['cells']:,} have a number")
    for reason, count in result["outcomes"].items():
        table.add_row(f"{count:,} of {result['cells']:,}", escape(reason))
    console().print(table)
    inform(f"written to {result['file']}, figure: {result['figure']}")
