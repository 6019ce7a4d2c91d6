"""Charts of motions with friction: a quantity of each motion over two numbers of the file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.task import Task, Variable
from flowlanes.flow.variable_metadata import cf_attributes
from flowlanes.parsing import nearest
from flowlanes.scans.grid import NO_NUMBER, REASONS, Axis
from flowlanes.scans.scan_task import axis_coordinate
from flowlanes.system.arrays import FloatArray

from ..._version import __version__
from ..study import Study
from ..subjects.contact_subject import ContactSubject
from .ensemble import mode_attributes, outcome_attributes
from .event_numbers import EVENT_NUMBERS, MotionNumber, motion_number, numerical_function
from .file_numbers import FileNumbers
from .members import friction_experiment, friction_subject, member_motion


@dataclass(frozen=True)
class ContactChart:
    """A quantity over a plane: maps rows first, …, last − 1 to arrays of numbers.

    Attributes
    ----------
    experiment : str
        The text of the file.
    of : MotionNumber
        The quantity that is charted.
    x, y : Axis
        Numbers of the file, or names that `formulas` use; y varies from row to row.
    formulas : tuple of (str, str)
        Numbers of the file, by formulas in the axes and the numbers of the file.
    times : tuple of float
    tolerance : float
    """

    experiment: str
    of: MotionNumber
    x: Axis
    y: Axis
    formulas: tuple[tuple[str, str], ...]
    times: tuple[float, ...]
    tolerance: float

    def __call__(self, first: int, last: int) -> dict[str, npt.NDArray[np.number]]:
        """Rows of the chart: numbers, outcomes and end times, (last − first, columns)."""
        shape = (last - first, self.x.count)
        names = dict.fromkeys((*EVENT_NUMBERS, self.of.word, "ended"))
        arrays: dict[str, npt.NDArray[np.number]] = {n: np.full(shape, np.nan) for n in names}
        arrays["outcome"] = np.zeros(shape, np.int16)
        system = friction_subject(self.experiment).system
        times = np.array(self.times)
        for row, column in np.ndindex(shape):
            place = {
                self.x.name: float(self.x.values[column]),
                self.y.name: float(self.y.values[first + row]),
            }
            member = member_motion(self.experiment, self.values(place), times, self.tolerance)
            arrays["outcome"][row, column] = member.outcome
            motion = member.motion
            if motion is None:
                continue
            arrays["ended"][row, column] = motion.end_time
            for name, item in EVENT_NUMBERS.items():
                arrays[name][row, column] = item.of(motion)
            number = self.of(motion, system, not motion.reason)
            arrays[self.of.word][row, column] = number
            if not member.outcome and not np.isfinite(number):
                arrays["outcome"][row, column] = NO_NUMBER
        return arrays

    def values(self, place: Mapping[str, float]) -> Mapping[str, float | FloatArray]:
        """The numbers of the file at a point of the plane."""
        known = {**_file_numbers(self.experiment), **place}
        formulas = {
            name: numerical_function(text, tuple(known), module="math")
            for name, text in self.formulas
        }
        used = {name for _, names in formulas.values() for name in names}
        direct = {
            n: v for n, v in place.items() if n not in used or n in _file_numbers(self.experiment)
        }
        values = {name: float(f(*[known[n] for n in used])) for name, (f, used) in formulas.items()}
        return {n: v for n, v in direct.items() if n not in formulas} | values


@lru_cache(maxsize=8)
def _file_numbers(experiment: str) -> dict[str, float]:
    """Numbers of the file that formulas may use."""
    return FileNumbers(friction_experiment(experiment)).values_by_name()


def contact_chart(
    study: Study,
    of: str,
    x: Axis,
    y: Axis,
    *,
    t_end: float | None = None,
    formulas: Mapping[str, str] | None = None,
    tolerance: float | None = None,
) -> ContactChart:
    """Define a chart of an experiment with friction over two of its numbers.

    Parameters
    ----------
    study : Study
    of : str
        The number; see :func:`chaplygin.experiment.friction_studies.event_numbers.motion_number`.
    x, y : Axis
        A number of the file, such as ``mu`` or ``omega_3``, or a new name that `formulas` use.
    t_end : float, optional
        Duration of the motions; by default that of the experiment.
    formulas : mapping of str to str, optional
        Numbers of the file, by formulas in the axes and in other numbers of the file.
    tolerance : float, optional
        See :mod:`flowlanes.system.tolerance`; by default that of the experiment.

    Raises
    ------
    InputError
        If the experiment has no friction, or the number, an axis or a formula cannot be used.
    """
    subject = study.subject
    if not isinstance(subject, ContactSubject):
        raise InputError("contact_chart: the experiment has no friction")
    number = motion_number(of, subject.system)
    span = study.until if t_end is None else t_end
    if not 0 < span < np.inf:
        raise InputError(f"t_end = {span:g}: motions must be followed for a positive, finite time")
    if x.name == y.name:
        raise InputError(f"{x.name}: the two axes need names that differ")
    experiment = study.complete_toml()
    numbers = FileNumbers(friction_experiment(experiment))
    texts = dict(formulas or {})
    names = (*numbers.values_by_name(), x.name, y.name)
    read = (numerical_function(text, names, f"{name} = {text}") for name, text in texts.items())
    used = {name for _, needed in read for name in needed}
    for name in texts:
        numbers.path(name)
    for item in (x, y):
        if item.name in texts:
            raise InputError(f"{item.name}: it is an axis and cannot be given by a formula besides")
        if item.name in {*EVENT_NUMBERS, number.word, "outcome", "ended"}:
            raise InputError(f"{item.name}: an axis must not have the name of a result")
        if item.name not in used:
            _require_number(numbers, item.name)
    return ContactChart(
        experiment,
        number,
        _labelled_axis(numbers, x),
        _labelled_axis(numbers, y),
        tuple(texts.items()),
        tuple(np.linspace(0.0, span, len(study.times)).tolist()),
        study.experiment.run.tolerance if tolerance is None else tolerance,
    )


def _require_number(numbers: FileNumbers, name: str) -> None:
    """Raise an error for an axis that is neither a number of the file nor used in a formula."""
    try:
        numbers.path(name)
    except InputError as problem:
        if "several" in problem.message:
            raise InputError(f"{problem.message} in --let, with an axis of another name") from None
        raise InputError(
            f"{name}: the experiment has no number of this name, and no formula uses it"
            f"{nearest(name, numbers.values_by_name())}"
        ) from None


def _labelled_axis(numbers: FileNumbers, item: Axis) -> Axis:
    """An axis with meaning and unit, if it is a number of the file."""
    if item.name not in numbers.values_by_name():
        return item
    meaning, unit = numbers.meaning(item.name)
    return replace(item, meaning=meaning, unit=unit)


def contact_chart_task(chart: ContactChart, title: str) -> Task:
    """The task of a chart; see :func:`flowlanes.flow.ensembles.compute`.

    Parameters
    ----------
    chart : ContactChart
    title : str
        Description of the motion.

    Returns
    -------
    Task
        Its result has the dimensions of y and x, the number asked for, those of `EVENT_NUMBERS`,
        ``outcome`` (see its ``flag_meanings``) and ``ended`` (the time reached).
    """
    system = friction_subject(chart.experiment).system
    columns, shape = (chart.x.name,), (chart.x.count,)
    notes: dict[str, Mapping[str, object]] = {
        name: cf_attributes(item.meaning, item.unit) for name, item in EVENT_NUMBERS.items()
    }
    notes["final_mode"] = mode_attributes("mode at the end")
    if chart.of.word not in notes:
        notes[chart.of.word] = cf_attributes(chart.of.title, chart.of.unit(system))
    notes["ended"] = cf_attributes("time reached", "s")
    variables = {n: Variable(columns, shape, attributes=about) for n, about in notes.items()}
    reasons = outcome_attributes({NO_NUMBER: REASONS[NO_NUMBER]})
    variables["outcome"] = Variable(columns, shape, "int16", reasons)
    return Task(
        work=chart,
        size=chart.y.count,
        block=1,
        variables=variables,
        member=chart.y.name,
        coordinates={item.name: axis_coordinate(item) for item in (chart.x, chart.y)},
        attributes={
            "system": title,
            "number": chart.of.word,
            "until": chart.times[-1],
            "tolerance": chart.tolerance,
            "formulas": [f"{name} = {text}" for name, text in chart.formulas],
            "version": __version__,
            "experiment": chart.experiment,
        },
    )
