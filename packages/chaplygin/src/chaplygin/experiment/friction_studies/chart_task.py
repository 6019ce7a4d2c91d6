"""A chart of an experiment, with or without friction, as a task."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from flowlanes.errors import InputError
from flowlanes.flow.devices.graphics import Device, refuse_graphics
from flowlanes.flow.ensembles.task import Task
from flowlanes.scans.grid import Axis
from flowlanes.scans.scan_task import scan

from ..scan import chart_of
from ..study import Study
from .chart import contact_chart, contact_chart_task


def chart_task(
    study: Study,
    of: str,
    x: Axis,
    y: Axis,
    *,
    t_end: float | None = None,
    formulas: Mapping[str, str] | None = None,
    fixed: Collection[str] = (),
    device: Device = "cpu",
) -> tuple[Task, str]:
    """The task of a chart, and the meaning of its number.

    Parameters
    ----------
    study, of, x, y, t_end, formulas, held, device
        See :func:`chaplygin.experiment.scan.chart_of`; with friction
        :func:`chaplygin.experiment.friction_studies.chart.contact_chart`, where nothing is held
        and the device is the processor.

    Raises
    ------
    InputError
        If the number, an axis or a formula cannot be used.
    """
    if not study.subject.changes_equations:
        chart = chart_of(
            study, of, x, y, t_end=t_end, formulas=formulas, fixed=fixed, device=device
        )
        return scan(chart, {"experiment": study.complete_toml()}), chart.title
    refuse_graphics(device)
    if fixed:
        raise InputError(
            f"--hold {next(iter(fixed))}: with friction nothing of a start is moved, so that "
            "nothing need be held"
        )
    with_friction = contact_chart(study, of, x, y, t_end=t_end, formulas=formulas)
    return contact_chart_task(with_friction, study.system.title), with_friction.of.title
