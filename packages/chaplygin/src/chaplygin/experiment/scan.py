"""Charts of an experiment."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace

from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.devices.graphics import Device
from flowlanes.scans.grid import Axis, ScanGrid, scan_grid
from flowlanes.scans.quantity_names import quantity_from_text
from flowlanes.scans.scan_task import Scan
from flowlanes.scans.system_quantities import meaning
from flowlanes.system.named_formulas import flat
from flowlanes.system.system import System
from nonholonomic.mechanics.conventions import start_vectors

from .single_system import without_reconstruction
from .study import Study

#: Meaning and unit of the vectors of a rolling body.
VECTORS = {
    "omega": ("angular velocity", "rad/s"),
    "gamma": ("normal at the contact", "1"),
    "M": ("angular momentum", "kg m^2/s"),
}


def chart_of(
    study: Study,
    of: str,
    x: Axis,
    y: Axis,
    *,
    t_end: float | None = None,
    formulas: Mapping[str, str] | None = None,
    fixed: Collection[str] = (),
    device: Device = "cpu",
) -> Scan:
    """A quantity of motions that start in a plane through the start of an experiment.

    Parameters
    ----------
    study : Study
    of : str
        The number; see :func:`flowlanes.scans.quantity_names.quantity_from_text`.
    x, y : Axis
    t_end : float, optional
        Duration of the motions; by default that of the experiment.
    formulas, fixed
        See :func:`flowlanes.scans.grid.scan_grid`.
    device : "cpu" or "gpu"
        Device of the computation; see :func:`flowlanes.flow.batch.batch_integrator`.

    Raises
    ------
    InputError
        If the number, an axis or a formula cannot be used.
    """
    plane = plane_of(study, x, y, formulas=formulas, fixed=fixed)
    span = study.until if t_end is None else t_end
    point = [float(value) for value in study.start[: len(plane.system.symbols)]]
    batch_integrator(plane.system, backward=span < 0).require_reach(point, span)
    number = quantity_from_text(
        plane.system, of, span, device=device, variables={**VECTORS, **study.variables}
    )
    return Scan(plane, number.rule, number.name, number.title, number.unit)


def plane_of(
    study: Study,
    x: Axis,
    y: Axis,
    *,
    formulas: Mapping[str, str] | None = None,
    fixed: Collection[str] = (),
) -> ScanGrid:
    """A plane through the start of an experiment, with meaning and unit of its axes."""
    system = without_reconstruction(study)
    text = {**VECTORS, **study.variables}

    def with_meaning(item: Axis) -> Axis:
        words, unit = meaning(system, item.name, text)
        return replace(item, meaning=words, unit=unit)

    start = _start(study, system)
    return scan_grid(
        system, with_meaning(x), with_meaning(y), start, formulas=formulas, fixed=fixed
    )


def _start(study: Study, system: System) -> dict[str, float | Sequence[float]]:
    """The start by ω and γ if the state follows from these, otherwise by the state."""
    follow = {
        str(name) for name, _ in system.conventions.start_formulas
    } | study.start_values.keys()
    if study.subject.starts_by_velocity and all(str(name) in follow for name in system.state):
        # A fluid that is not mentioned is at rest in the body.
        names = ("omega", "gamma", *map(str, start_vectors(system)))
        return {name: study.start_values.get(name, (0.0, 0.0, 0.0)) for name in names}
    numbers = iter([float(value) for value in study.start])
    return {str(name): [next(numbers) for _ in flat([name])] for name in system.state}
