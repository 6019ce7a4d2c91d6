"""Sections of motions with friction: where a formula passes a value, on the smooth pieces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from importlib.metadata import version

import numpy as np
import numpy.typing as npt

from flowlanes.errors import InputError
from flowlanes.flow.ensembles.members import Members
from flowlanes.flow.ensembles.task import Coordinate, Task, Variable
from flowlanes.flow.variable_metadata import cf_attributes, system_attributes, variable_metadata
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import flat
from flowlanes.system.system import System
from flowlanes.system.tolerance import ENSEMBLE_TOLERANCE
from nonholonomic.contact.friction.modes import MODE_NAMES
from nonholonomic.contact.simulation.compiled import CompiledContact
from nonholonomic.contact.simulation.crossings import Crossing, CrossingCourse
from nonholonomic.contact.simulation.mode_integrator import ModeIntegrator
from nonholonomic.mechanics.conventions import AXIS_MEANINGS, FRAMES

from ..poincare import DIRECTIONS, SectionSurface
from ..study import Study
from ..subjects.contact_subject import ContactSubject
from .ensemble import mode_attributes, outcome_attributes
from .event_numbers import formula_at, require_formula
from .file_numbers import FileNumbers
from .members import CODES, friction_experiment, friction_subject, member_start
from .random_starts import DIRECTIONS as WHOLE

#: Coordinates drawn by default.
COORDINATES = "gamma_1,gamma_2"


@dataclass(frozen=True, eq=False)
class ContactSection:
    """The work of a section: the crossings of the motions first, …, last − 1.

    Parameters
    ----------
    experiment : str
        The text of the file.
    members : Members or None
        Numbers of the file member by member; None for the start of the experiment alone.
    surface : SectionSurface
    count : int
        Number of points of each motion.
    t_end : float
    tolerance : float
    coordinates : tuple of (str, str)
        Names and formulas that are recorded.
    """

    experiment: str
    members: Members | None
    surface: SectionSurface
    count: int
    t_end: float
    tolerance: float
    coordinates: tuple[tuple[str, str], ...]

    def __call__(self, first: int, last: int) -> dict[str, npt.NDArray[np.number]]:
        """The arrays of a block, by the names of the dataset."""
        system = friction_subject(self.experiment).system
        rows = {} if self.members is None else self.members.rows(first, last)[0]
        variables = section_variables(system, self.count, self.coordinates)
        arrays: dict[str, npt.NDArray[np.number]] = {
            name: np.full(
                (last - first, *item.shape), np.nan if item.dtype == "float64" else -1, item.dtype
            )
            for name, item in variables.items()
        }
        for place in range(last - first):
            values = {name: array[place] for name, array in rows.items()}
            self._store_crossings(values, system, arrays, place)
        return arrays

    def _store_crossings(
        self,
        values: dict[str, float | FloatArray],
        system: System,
        arrays: dict[str, npt.NDArray[np.number]],
        place: int,
    ) -> None:
        """Store the crossings of one motion in the arrays."""
        outcome, start = member_start(self.experiment, values, self.tolerance)
        arrays["outcome"][place] = outcome
        arrays["points"][place] = 0
        if isinstance(start, str):
            return
        contact, state, rules = start
        course = CrossingCourse(
            contact,
            _with_works(contact, state),
            np.array([0.0, self.t_end]),
            rules,
            lambda mode, states: self._quantity(mode, states, system),
            lambda crossing: self._counts(crossing, system),
            self.count,
        )
        course.run()
        columns = contact.columns
        arrays["outcome"][place] = _outcome_of(course, self.count)
        complete = len(course.crossings) >= self.count
        arrays["ended"][place] = course.crossings[-1].time if complete else course.time
        arrays["points"][place] = len(course.crossings)
        for number, crossing in enumerate(course.crossings):
            arrays["time"][place, number] = crossing.time
            arrays["mode"][place, number] = MODE_NAMES.index(crossing.mode)
            for name in map(str, system.state):
                # A friction law whose coefficient is zero does no work.
                row = crossing.state[columns[name]] if name in columns else np.zeros(1)
                arrays[name][place, number] = row if len(row) > 1 else row[0]
            for name, text in self.coordinates:
                states = crossing.state[None]
                value = formula_at(text, crossing.integrator, states, system)
                arrays[name][place, number] = value[0]

    def _quantity(self, mode: ModeIntegrator, states: FloatArray, system: System) -> FloatArray:
        difference = formula_at(self.surface.quantity, mode, states, system) - self.surface.value
        return np.sin(difference) if self.surface.angle else difference

    def _counts(self, crossing: Crossing, system: System) -> bool:
        """Whether a crossing has the required direction and lies in the slabs of the section."""
        wanted = DIRECTIONS[self.surface.direction]
        if wanted and crossing.rising != (wanted > 0):
            return False
        states, mode = crossing.state[None], crossing.integrator
        if self.surface.angle:
            angle = float(formula_at(self.surface.quantity, mode, states, system)[0])
            if np.cos(angle - self.surface.value) < 0:
                return False
        return all(
            abs(float(formula_at(text, mode, states, system)[0])) < width
            for text, width in self.surface.within
        )

    def part(self, first: int, last: int) -> ContactSection:
        """The work restricted to these members."""
        return self


def _with_works(contact: CompiledContact, state: FloatArray) -> FloatArray:
    return np.append(state, np.zeros(contact.size - len(state)))


def _outcome_of(course: CrossingCourse, count: int) -> int:
    if course.ending:
        return CODES[course.ending]
    return 0 if len(course.crossings) >= count else _TOO_FEW


#: Outcome code of a motion that reached its time limit before its last point.
_TOO_FEW = 100


def contact_section_task(
    study: Study,
    surface: SectionSurface,
    points: int,
    members: Members | None = None,
    coordinates: str = "",
    *,
    t_end: float,
    tolerance: float = ENSEMBLE_TOLERANCE,
) -> tuple[Task, tuple[str, ...]]:
    """Prepare a section of motions with friction; also return the coordinates to be drawn.

    Parameters
    ----------
    study : Study
    surface : SectionSurface
        Its quantities are formulas in recorded quantities, such as ``gamma_3`` or ``slip_1``.
    points : int
        Number of points of each motion.
    members : Members, optional
        Numbers of the file member by member; by default only the start of the experiment.
    coordinates : str
        Two or three, separated by commas: recorded quantities, or ``NAME=FORMULA``.
    t_end : float
        Time limit of each motion.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`.

    Raises
    ------
    InputError
        If the experiment has no friction, or place, coordinates or a number cannot be used.
    """
    subject = study.subject
    if not isinstance(subject, ContactSubject):
        raise InputError("contact_section_task: the experiment has no friction")
    if surface.direction not in DIRECTIONS:
        raise InputError(
            f"--direction {surface.direction}: it must be one of {', '.join(DIRECTIONS)}"
        )
    if points < 1:
        raise InputError(f"{points} points: there must be one at least")
    if not 0 < t_end < np.inf:
        raise InputError(f"--until {t_end:g}: it must be positive and finite")
    system = subject.system
    require_formula(surface.quantity, system, "--on")
    for quantity, _ in surface.within:
        require_formula(quantity, system, "--within")
    chosen = _coordinates(coordinates or COORDINATES, system)
    experiment = study.complete_toml()
    numbers = FileNumbers(friction_experiment(experiment))
    for name in () if members is None else members.names:
        if name not in WHOLE:
            numbers.path(name)
    variables = section_variables(system, points, chosen)
    used = {dimension for item in variables.values() for dimension in item.dimensions}
    task = Task(
        ContactSection(experiment, members, surface, points, t_end, tolerance, chosen),
        1 if members is None else members.size,
        1,
        variables,
        "run",
        {
            axis: Coordinate((axis,), np.array(labels), cf_attributes(AXIS_MEANINGS[axis], "1"))
            for axis, labels in FRAMES.values()
            if axis in used
        },
        {
            **system_attributes(system),
            "friction": subject.contact.setting,
            "section": str(surface),
            "coordinates": [name for name, _ in chosen],
            "starts": "the start of the experiment" if members is None else str(members),
            "tolerance": tolerance,
            "versions": ", ".join(f"{name} {version(name)}" for name in ("chaplygin", "llvmlite")),
            "experiment": experiment,
        },
    )
    return task, tuple(name for name, _ in chosen)


def _coordinates(text: str, system: System) -> tuple[tuple[str, str], ...]:
    """Names and formulas of the coordinates."""
    parts = [part.strip() for part in text.split(",")]
    if len(parts) not in (2, 3):
        raise InputError(f"--coordinates {text}: two or three are needed, separated by commas")
    pairs = []
    for part in parts:
        name, equals, formula = (piece.strip() for piece in part.partition("="))
        require_formula(formula if equals else name, system, "--coordinates")
        if not name.isidentifier():
            raise InputError(
                f"--coordinates {text}: the formula {part} needs a name, as in height = {part}"
            )
        pairs.append((name, formula if equals else name))
    return tuple(pairs)


def section_variables(
    system: System, count: int, coordinates: Sequence[tuple[str, str]]
) -> dict[str, Variable]:
    """The variables of a section."""
    along, shape = ("section_point",), (count,)
    variables = {
        "time": Variable(along, shape, attributes=cf_attributes("time since the start", "s")),
        "points": Variable(dtype="int64", attributes=cf_attributes("number of points", "1")),
        "outcome": Variable(
            dtype="int16",
            attributes=outcome_attributes({0: "all its points", _TOO_FEW: "the time limit"}),
        ),
        "ended": Variable(attributes=cf_attributes("time at which the motion ended", "s")),
        "mode": Variable(along, shape, "int8", mode_attributes("mode of the contact")),
    }
    for item in system.state:
        size = len(flat([item]))
        meaning, unit, source, frame = variable_metadata(system, str(item), size)
        notes = cf_attributes(meaning, unit, source)
        if not frame:
            variables[str(item)] = Variable(along, shape, attributes=notes)
            continue
        axis = FRAMES[frame][0] if frame in FRAMES else frame
        variables[str(item)] = Variable((*along, axis), (*shape, size), attributes=notes)
    for name, text in coordinates:
        if name not in variables:
            notes = cf_attributes(text, "")
            variables[name] = Variable(along, shape, attributes=notes)
    return variables
