"""Charts stored on disk and sent to a page row by row, as they are computed."""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.zarr_store import open_store
from flowlanes.scans.grid import axis

from ..experiment.friction_studies.chart_task import chart_task
from ..experiment.study import Study
from .json_numbers import numbers
from .requests import MOST_CELLS, Chart
from .workers import Message


def store_name(request: Chart, experiment: str | None) -> str:
    """The name of the store of a chart; the same request gives the same store."""
    words = "-".join(
        "".join(c if c.isalnum() or c == "_" else "-" for c in part.partition("=")[0])[:24]
        for part in (request.subject.what.removesuffix(".toml"), request.of, request.x, request.y)
    )
    asked = f"{request.model_dump_json()}\n{experiment}"
    return f"{words}-{hashlib.sha256(asked.encode()).hexdigest()[:12]}.zarr"


def tiles(study: Study, request: Chart, store: str) -> Iterator[Message]:
    """Rows of a chart: first those in the store, then the others as they are computed.

    Parameters
    ----------
    study : Study
    request : Chart
    store : str
        Path of the store, which is created or resumed.

    Raises
    ------
    InputError
        If the number or an axis cannot be used.
    """
    x, y = axis(request.x, "x"), axis(request.y, "y")
    for item in (x, y):
        if item.count > MOST_CELLS:
            raise InputError(
                f"{item.name}: the laboratory computes at most {MOST_CELLS:,} cells along an axis; "
                "chaplygin chart computes more"
            )
    task, title = chart_task(study, request.of, x, y, t_end=request.until)
    number = str(task.attributes["number"])
    yield {
        "chart": {
            "of": number,
            "title": title,
            "unit": str(task.variables[number].attributes.get("units", "")),
            "x": {"name": x.name, "low": x.first, "high": x.last, "count": x.count},
            "y": {"name": y.name, "low": y.first, "high": y.last, "count": y.count},
            "store": f"{Path(store).parent.name}/{Path(store).name}",
        }
    }
    with open_store(task, Path(store)) as opened:
        task = opened.task
        missing = set(opened.missing)
        for block in (*(b for b in range(task.blocks) if b not in missing), *opened.missing):
            first, last = task.members(block)
            if block in missing:
                arrays = task.require_arrays(task.work(first, last), first, last)
                opened.write(block, arrays)
                values = arrays[number]
            else:
                values = np.asarray(opened.arrays[number][first:last])
            yield {
                "tile": {
                    "column": 0,
                    "row": first,
                    "width": x.count,
                    "height": last - first,
                    "values": numbers(values),
                }
            }
            yield {"progress": 1 - len(opened.missing) / task.blocks}
