"""Charts: a number for each motion of a plane of parameters and starts.

A chart is a :class:`flowlanes.flow.ensembles.task.Task` whose members are rows. It is computed in
blocks, in memory or in a Zarr store, locally or on a cluster, always with the same bits.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt
import sympy as sp

from .._version import __version__
from ..arguments import arguments_checked
from ..errors import InputError
from ..flow.batch import batch_integrator
from ..flow.devices.graphics import Device
from ..flow.devices.threads import map_in_threads
from ..flow.ensembles.task import Coordinate, Task, Variable
from ..flow.kernel.outcomes import STATUS_MESSAGES
from ..flow.variable_metadata import cf_attributes
from ..system.arrays import FloatArray, IntArray
from ..system.parameters import Parameters
from ..system.system import System
from .grid import NO_NUMBER, REASONS, Axis, ScanGrid

#: Approximate number of motions computed at once, by device.
AT_ONCE: Mapping[Device, int] = {"cpu": 2048, "gpu": 2**17}


class Rule(Protocol):
    """A quantity computed for many motions independently."""

    @property
    def system(self) -> System:
        """The system of the motions."""

    @property
    def t_end(self) -> float:
        """The length of the motions."""

    @property
    def tolerance(self) -> float:
        """The tolerance of the integration."""

    @property
    def device(self) -> Device:
        """The device on which the motions are computed."""

    @property
    def extra_columns(self) -> Mapping[str, str]:
        """Names and meanings of additional columns, such as an error."""

    def __call__(
        self, starts: FloatArray, parameters: Parameters
    ) -> Mapping[str, FloatArray | IntArray]:
        """Arrays (n,): the number ``"value"``, ``"outcome"``, and the time reached ``"ended"``."""


@dataclass(frozen=True)
class Scan:
    """A quantity over a plane: maps rows first, …, last − 1 to arrays of numbers.

    Attributes
    ----------
    plane : ScanGrid
    rule : Rule
        The quantity.
    name : str
        The name of the variable.
    title, unit : str
        Its description and unit.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> damping = flowlanes.Parameter(k, "damping", 0.1)
    >>> field = {x: v, v: -sp.sin(x) - k * v}
    >>> pendulum = flowlanes.System("pendulum", "Damped pendulum", field, (damping,))
    >>> axes = flowlanes.scans.axis("k=0:1:3"), flowlanes.scans.axis("v=0.5:1:2")
    >>> grid = flowlanes.scans.scan_grid(pendulum, *axes, {"x": 0.5, "v": 0.0})
    >>> rule = flowlanes.scans.time_average(pendulum, 5.0, v**2)
    >>> flowlanes.scans.Scan(grid, rule, "square", "Mean of the square").name
    'square'
    """

    plane: ScanGrid
    rule: Rule
    name: str
    title: str
    unit: str = ""

    def __call__(self, first: int, last: int) -> dict[str, npt.NDArray[np.number]]:
        """Rows of the chart: numbers, outcomes and end times, (last − first, columns)."""
        parts = map_in_threads(lambda a, b: self._rows(first + a, first + b), last - first)
        return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}

    def _rows(self, first: int, last: int) -> dict[str, npt.NDArray[np.number]]:
        cells = self.plane.cells(first, last)
        good = np.flatnonzero(cells.reasons == 0)
        arrays = {name: np.full(len(cells.reasons), np.nan) for name in (*self.numbers, "ended")}
        outcome = cells.reasons.astype(np.int16)
        if len(good):
            parameters = {symbol: numbers[good] for symbol, numbers in cells.parameters.items()}
            results = self.rule(cells.starts[good], parameters)
            outcome[good] = results["outcome"]
            for name, key in (*self.numbers.items(), ("ended", "ended")):
                arrays[name][good] = results[key]
            outcome[(outcome == 0) & ~np.isfinite(arrays[self.name])] = NO_NUMBER
        shape = (last - first, self.plane.x.count)
        arrays["outcome"] = outcome
        return {name: array.reshape(shape) for name, array in arrays.items()}

    @property
    def numbers(self) -> dict[str, str]:
        """The names of the numbers in the result, mapped to those of the rule."""
        return {
            self.name: "value",
            **{f"{self.name}_{key}": key for key in self.rule.extra_columns},
        }


@arguments_checked
def scan(task: Scan, attributes: Mapping[str, Any] | None = None) -> Task:
    """Create the task of a scan.

    See :func:`flowlanes.flow.ensembles.compute`.

    Parameters
    ----------
    task : Scan
    attributes : mapping, optional
        Further attributes of the result: numbers and strings.

    Returns
    -------
    Task
        The result has the dimensions of y and x, their values as coordinates, and the variables
        ``task.name``, ``outcome`` (0, or the reason why there is no number: see its
        ``flag_meanings``) and ``ended`` (the time reached).

    Raises
    ------
    InputError
        If an axis has the name of a variable in the result.

    Examples
    --------
    >>> import flowlanes
    >>> import sympy as sp
    >>> x, v, k = sp.symbols("x v k", real=True)
    >>> damping = flowlanes.Parameter(k, "damping", 0.1)
    >>> field = {x: v, v: -sp.sin(x) - k * v}
    >>> pendulum = flowlanes.System("pendulum", "Damped pendulum", field, (damping,))
    >>> axes = flowlanes.scans.axis("k=0:1:3"), flowlanes.scans.axis("v=0.5:1:2")
    >>> grid = flowlanes.scans.scan_grid(pendulum, *axes, {"x": 0.5, "v": 0.0})
    >>> rule = flowlanes.scans.time_average(pendulum, 5.0, v**2)
    >>> task = flowlanes.scans.scan(
    ...     flowlanes.scans.Scan(grid, rule, "square", "Mean of the square")
    ... )
    >>> dict(flowlanes.flow.ensembles.compute(task).sizes)
    {'v': 2, 'k': 3}
    """
    plane, rule = task.plane, task.rule
    columns = (plane.x.name,)
    shape = (plane.x.count,)
    for item in (plane.x, plane.y):
        if item.name in {*task.numbers, "outcome", "ended"}:
            raise InputError(f"{item.name}: an axis must not have the name of a result")
    titles = {"value": task.title, **rule.extra_columns}
    return Task(
        work=task,
        size=plane.y.count,
        block=max(1, AT_ONCE[rule.device] // plane.x.count),
        variables={
            **{
                name: Variable(columns, shape, attributes=cf_attributes(titles[key], task.unit))
                for name, key in task.numbers.items()
            },
            "outcome": Variable(columns, shape, "int16", _outcomes(rule)),
            "ended": Variable(columns, shape, attributes=cf_attributes("time reached", "s")),
        },
        member=plane.y.name,
        coordinates={item.name: axis_coordinate(item) for item in (plane.x, plane.y)},
        attributes={
            "system": plane.system.title,
            "number": task.name,
            "until": rule.t_end,
            "tolerance": rule.tolerance,
            "parameters": _text_rows(plane.system.defaults),
            "start": _text_rows(dict(zip(plane.original_system.symbols, plane.base, strict=True))),
            "formulas": [f"{symbol} = {value}" for symbol, value in plane.substitutions],
            "levels": [f"{quantity} = {value}" for quantity, value in plane.levels],
            "held": [str(symbol) for symbol in plane.fixed_symbols],
            "version": __version__,
            **(attributes or {}),
        },
    )


def axis_coordinate(item: Axis) -> Coordinate:
    """The coordinate of a dataset for an axis."""
    return Coordinate(
        (item.name,), item.values, cf_attributes(item.meaning or item.name, item.unit)
    )


def _text_rows(values: Mapping[sp.Symbol | str, float]) -> list[str]:
    return [f"{name} = {value!r}" for name, value in values.items()]


def _outcomes(rule: Rule) -> dict[str, object]:
    """Attributes of the outcome codes by the CF conventions."""
    flow = batch_integrator(rule.system, tolerance=rule.tolerance)
    reasons = {0: "followed to the end", -1: "not computed yet", **REASONS}
    reasons |= {
        code: flow.status_message(code)
        for code in range(1, len(STATUS_MESSAGES) + len(rule.system.guards))
    }
    return {
        **cf_attributes("why there is no number", ""),
        "flag_values": list(reasons),
        "flag_meanings": " ".join(text.replace(" ", "_") for text in reasons.values()),
    }
