"""Ensembles of motions with friction: many starts and coefficients, in blocks."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version

import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.members import ListedMembers, Members
from flowlanes.flow.ensembles.run import sample_coordinates, sampled_variable
from flowlanes.flow.ensembles.task import Arrays, Task, Variable
from flowlanes.flow.variable_metadata import cf_attributes, system_attributes, variable_metadata
from flowlanes.scans.grid import INADMISSIBLE, NO_STATE
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import scalars
from flowlanes.system.system import System
from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE
from nonholonomic.contact.dataset import mode_flags, work_meanings
from nonholonomic.contact.friction.modes import MODE_NAMES
from nonholonomic.contact.simulation.end_reasons import END_REASONS

from ..contact.trajectory import BALANCE
from ..study import Study
from ..subjects.contact_subject import ContactSubject
from .event_numbers import EVENT_NUMBERS, recorded_values
from .file_numbers import FileNumbers
from .members import (
    MemberMotion,
    friction_experiment,
    friction_subject,
    member_motion,
    samples_reached,
)
from .random_starts import DIRECTIONS

#: Number of members computed and written together, and lost by an interruption: a few seconds of
#: work.
BLOCK = 16

#: State variables that are recorded under other names, as observables in space axes.
_ELSEWHERE = {"position": "centre", "v": "velocity"}

#: Attributes of the outcomes of motions with friction, by the CF conventions.
OUTCOMES: dict[int, str] = {
    **dict(enumerate(END_REASONS.values())),
    -1: "not computed yet",
    NO_STATE: "the start cannot be used",
    INADMISSIBLE: "the body or the contact is not admissible",
}


def mode_attributes(meaning: str) -> dict[str, object]:
    """Mode flags, with numbers that a store can hold."""
    return {**mode_flags(meaning), "flag_values": list(range(len(MODE_NAMES)))}


def outcome_attributes(more: dict[int, str] | None = None) -> dict[str, object]:
    """Flags of the reasons why a motion ended."""
    reasons = OUTCOMES | (more or {})
    return {
        **cf_attributes("why the motion ended", "1"),
        "flag_values": list(reasons),
        "flag_meanings": " ".join("_".join(re.findall(r"\w+", text)) for text in reasons.values()),
        "reasons": list(reasons.values()),
    }


@dataclass(frozen=True, eq=False)
class ContactEnsembleWork:
    """The work of an ensemble; see :class:`flowlanes.flow.ensembles.task.Work`.

    Parameters
    ----------
    experiment : str
        The text of the file.
    members : Members
        Values by the names of :class:`FileNumbers`.
    times : tuple of float
    tolerance : float
    record : tuple of str
        Observables recorded besides the state.
    offset : int
        Number of the first of the members.
    """

    experiment: str
    members: Members
    times: tuple[float, ...]
    tolerance: float
    record: tuple[str, ...]
    offset: int = 0

    def __call__(self, first: int, last: int) -> Arrays:
        """Compute the motions first, …, last − 1; arrays by name, one row per motion."""
        subject = friction_subject(self.experiment)
        rows, _ = self.members.rows(first - self.offset, last - self.offset)
        times = np.array(self.times)
        arrays: dict[str, npt.NDArray[np.number]] = {
            given_name(name): np.ascontiguousarray(values) for name, values in rows.items()
        }
        for name, variable in ensemble_variables(subject, self.record, len(times)).items():
            fill = np.nan if variable.dtype == "float64" else -1
            arrays[name] = np.full((last - first, *variable.shape), fill, variable.dtype)
        for place in range(last - first):
            values = {name: array[place] for name, array in rows.items()}
            member = member_motion(self.experiment, values, times, self.tolerance)
            self._store_motion(member, subject.system, arrays, place, times)
        return arrays

    def _store_motion(
        self,
        member: MemberMotion,
        system: System,
        arrays: dict[str, npt.NDArray[np.number]],
        place: int,
        times: FloatArray,
    ) -> None:
        """Store the numbers of one motion in the arrays."""
        arrays["outcome"][place] = member.outcome
        motion = member.motion
        if motion is None:
            return
        count = samples_reached(motion, times)
        recorded = recorded_values(motion, system)
        works = sum(values for name, values in recorded.items() if name.startswith("work_"))
        recorded[BALANCE] = recorded["energy"] + works
        for name, values in recorded.items():
            if name in arrays:
                arrays[name][place, :count] = values[:count]
        arrays["mode"][place, :count] = motion.modes[:count]
        for name, number in EVENT_NUMBERS.items():
            arrays[name][place] = number.of(motion)
        arrays["lowest_gap"][place] = recorded["gap"].min()
        arrays["steps"][place] = motion.steps

    def part(self, first: int, last: int) -> ContactEnsembleWork:
        """The work restricted to these members, without the rows of others."""
        rows, _ = self.members.rows(first - self.offset, last - self.offset)
        return replace(self, members=Members((ListedMembers(rows),)), offset=first)


def contact_ensemble_task(
    study: Study,
    members: Members,
    *,
    record: Sequence[str] = (),
    tolerance: float = ENSEMBLE_TOLERANCE,
    block: int = BLOCK,
) -> Task:
    """Prepare an ensemble of motions of an experiment with friction.

    Parameters
    ----------
    study : Study
        The study, whose sample times are used for all motions.
    members : Members
        Numbers of the file by name, by :func:`flowlanes.flow.ensembles.members.from_lists` and the
        like, or :func:`chaplygin.experiment.friction_studies.random_starts.random_numbers`.
    record : sequence of str
        Observables recorded in addition to the state, such as ``slip`` or ``normal_force``.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.
    block : int
        Number of members computed and written together.

    Returns
    -------
    Task
        For :func:`flowlanes.flow.ensembles.compute`.  Its result has the variables of the
        state and ``mode`` over ``run`` and ``time``, and over ``run`` the numbers of
        `EVENT_NUMBERS`, ``lowest_gap``, ``outcome`` (see its ``reasons``) and ``steps``.

    Raises
    ------
    InputError
        If the experiment is without friction, or a name or the first member cannot be used.
    """
    subject = study.subject
    if not isinstance(subject, ContactSubject):
        raise InputError("contact_ensemble_task: the experiment has no friction")
    experiment = study.complete_toml()
    numbers = FileNumbers(friction_experiment(experiment))
    for name in members.names:
        if name not in DIRECTIONS:
            numbers.path(name)
    _require_observables(subject.system, record)
    work = ContactEnsembleWork(
        experiment, members, tuple(study.times.tolist()), tolerance, tuple(record)
    )
    first = {name: values[0] for name, values in members.rows(0, 1)[0].items()}
    trial = member_motion(experiment, first, study.times[:1], tolerance)
    if trial.outcome == INADMISSIBLE:
        raise InputError(trial.reason, "run 0")
    variables = {
        given_name(name): _member_variable(name, numbers, np.shape(value))
        for name, value in first.items()
    } | ensemble_variables(subject, tuple(record), len(study.times))
    seeds = [factor.seed for factor in members.factors if hasattr(factor, "seed")]
    return Task(
        work,
        members.size,
        max(1, min(block, members.size)),
        variables,
        "run",
        sample_coordinates(subject.system.conventions, work.times, variables),
        {
            **system_attributes(subject.system),
            "friction": subject.contact.setting,
            "members": str(members),
            "tolerance": tolerance,
            **({"seed": seeds[0]} if seeds else {}),
            "integrator": "Taylor series, pieces joined by events",
            "versions": ", ".join(
                f"{name} {version(name)}" for name in ("chaplygin", "llvmlite", "numpy", "sympy")
            ),
            "experiment": experiment,
        },
    )


def given_name(name: str) -> str:
    """The variable name of a given number; the state has a variable ``gamma`` too."""
    return f"start_{name}" if name in DIRECTIONS else name


def _member_variable(name: str, numbers: FileNumbers, shape: tuple[int, ...]) -> Variable:
    """A number of the file that varies between members."""
    if name in DIRECTIONS:
        notes = cf_attributes(f"start.{name}", "1")
        return Variable((f"{name}_component",), shape, attributes=notes, coordinate=True)
    return Variable(attributes=cf_attributes(*numbers.meaning(name)), coordinate=True)


def _require_observables(system: System, names: Sequence[str]) -> None:
    known = [item.name for item in system.observables] + [BALANCE]
    for name in names:
        if name not in known:
            raise InputError(
                f"{system.name}: there is no {name} to be recorded; there are {', '.join(known)}"
            )


def ensemble_variables(
    subject: ContactSubject, record: Sequence[str], moments: int
) -> dict[str, Variable]:
    """The variables of an ensemble besides the given numbers."""
    system, conventions = subject.system, subject.system.conventions
    observables = {item.name: item for item in system.scalar.observables}
    works = work_meanings(subject.contact, system)
    variables: dict[str, Variable] = {}
    names = [_ELSEWHERE.get(str(name), str(name)) for name in system.state]
    for name in dict.fromkeys((*names, *record)):
        if name in works:
            meaning, unit = works[name]
            variables[name] = sampled_variable(conventions, moments, 1, "", meaning, unit, "")
        elif name in observables:
            item = observables[name]
            size = len(scalars(item.value))
            variables[name] = sampled_variable(
                conventions, moments, size, item.frame, item.meaning, item.unit, item.source
            )
        elif name == BALANCE:
            variables[name] = sampled_variable(
                conventions, moments, 1, "", "energy with all work lost", "J", ""
            )
        else:
            *about, frame = variable_metadata(system, name, 3)
            variables[name] = sampled_variable(conventions, moments, 3, frame, *about)
    flags = mode_attributes("mode of the contact")
    variables["mode"] = Variable(("time",), (moments,), "int8", flags)
    for name, number in EVENT_NUMBERS.items():
        variables[name] = Variable(attributes=cf_attributes(number.meaning, number.unit))
    variables["final_mode"] = Variable(attributes=mode_attributes("mode at the end"))
    variables["lowest_gap"] = Variable(attributes=cf_attributes("lowest gap at the samples", "m"))
    variables["outcome"] = Variable(dtype="int8", attributes=outcome_attributes())
    variables["steps"] = Variable(dtype="int64", attributes=cf_attributes("steps", "1"))
    return variables
