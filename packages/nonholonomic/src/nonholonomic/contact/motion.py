"""Motions of a body with friction, through all changes of its contact."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import groupby
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.flow.motion import Motion, read_only, unknown_variable
from flowlanes.formulas.array_evaluation import as_float_array
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import flat
from flowlanes.system.overview import Overview, WithOverview
from flowlanes.system.system import System
from flowlanes.system.tolerance import FINEST_TOLERANCE

from .dataset import with_contact, work_meanings
from .equations.situation import FrictionalContact
from .friction.modes import FLIGHT, MODE_NAMES
from .simulation.compiled import ATTITUDE, WORK, CompiledContact
from .simulation.course import Course
from .simulation.course_state import Piece
from .simulation.end_reasons import EndReason
from .simulation.event_rules import EventRules
from .simulation.events import ContactEvent

if TYPE_CHECKING:
    import xarray as xr

#: Depth, relative to the body size, by which a body may start inside the support: decimal rounding.
DEEPEST = 1e-9


@dataclass(frozen=True)
class Interval:
    """A time interval in which the contact mode does not change.

    Attributes
    ----------
    mode : str
        One of ``MODE_NAMES``.
    begin, end : float
        In s.
    """

    mode: str
    begin: float
    end: float


class InterruptedMotionError(KeyboardInterrupt):
    """Raised by Ctrl-C during a motion with friction; `partial` is the motion so far."""

    def __init__(self, partial: ContactMotion) -> None:
        super().__init__()
        self.partial = partial


@dataclass(frozen=True, eq=False, repr=False)
class ContactMotion(Motion, WithOverview):
    """A motion with friction.

    State variables and recorded quantities are accessible by name.

    Attributes
    ----------
    contact : FrictionalContact
    times : array (n,)
        The sample times that were reached and, if it ended before the last of them, its end.
    states : array (n, size)
        Attitude (quaternion), centre of mass (space axes), its velocity, ω, γ (body axes), works.
    modes : int array (n,)
        Mode at each sample, as an index into ``MODE_NAMES``.
    events : tuple of ContactEvent
    intervals : tuple of Interval
        The times between changes of the mode.
    end_time : float
    end_state : array (size,)
    reason : str
        Reason of an early end; empty if the last sample time was reached.
    steps : int
        Steps of integration.
    ending : str
        The reason as a keyword, one of ``END_REASONS``.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact, contact_motion
    >>> ball = nonholonomic.Body(0.2, (2e-4, 2e-4, 2e-4), nonholonomic.Ball(0.05))
    >>> table = FrictionalContact(
    ...     ball, laws=(Coulomb(0.2),), field=nonholonomic.Forces(gravity=9.81)
    ... )
    >>> start = [1, 0, 0, 0, 0, 0, 0.05, 1.4, 0, 0, 0, 0, 0, 0, 0, 1]
    >>> motion = contact_motion(table, start, [0.0, 1.0])
    >>> motion.times.tolist(), len(motion.events)
    ([0.0, 1.0], 1)
    """

    contact: FrictionalContact
    times: FloatArray
    states: FloatArray
    modes: npt.NDArray[np.int8]
    events: tuple[ContactEvent, ...]
    intervals: tuple[Interval, ...]
    end_time: float
    end_state: FloatArray
    reason: str
    steps: int
    ending: EndReason
    _pieces: tuple[Piece, ...] = field(repr=False)
    _columns: Mapping[str, slice] = field(repr=False)
    _system: System = field(repr=False)

    def __post_init__(self) -> None:
        for name in ("times", "states", "modes", "end_state"):
            object.__setattr__(self, name, read_only(getattr(self, name)))

    def __getstate__(self) -> dict[str, object]:
        """The pickled state: recorded quantities in place of compiled code."""
        return {**self.__dict__, "observables": self.observables, "_pieces": ()}

    def __getitem__(self, name: str) -> FloatArray:
        if name in self.observables:
            return self.observables[name]
        if name not in self._columns:
            raise unknown_variable("motion with friction", name, self)
        place = self._columns[name]
        return self.states[:, place if place.stop - place.start > 1 else place.start]

    def __iter__(self) -> Iterator[str]:
        return iter(dict.fromkeys([*self._columns, *self.observables]))

    @property
    def energy_lost(self) -> float:
        """The energy lost to friction and impacts until the end (J)."""
        works = (place for name, place in self._columns.items() if name.startswith("work_"))
        return float(sum(self.end_state[place].sum() for place in works))

    @cached_property
    def observables(self) -> Mapping[str, FloatArray]:
        """Recorded quantities at the samples, (n,) or (n, 3), by name."""
        blocks = [p.integrator.outputs(p.states) for p in self._pieces if len(p.times)]
        return {
            name: read_only(np.concatenate([block[name] for block in blocks])) for name in blocks[0]
        }

    def to_dataset(self) -> xr.Dataset:
        """The motion as a dataset.

        Returns
        -------
        xarray.Dataset
            Dimension ``time``: the quantities of the motion and ``mode``, a flag. The dimension
            ``event`` has the events of the contact; see
            :func:`nonholonomic.contact.dataset.with_contact`.
        """
        from flowlanes.flow.motion_dataset import motion_dataset

        samples = motion_dataset(
            self._system,
            self._system.defaults,
            self.times,
            {name: self[name] for name in self},
            start=self.states[0],
            facts={
                "system": "Body in contact with friction",
                "end_time": self.end_time,
                "end_reason": self.reason,
            },
            meanings=work_meanings(self.contact, self._system),
        )
        columns = [
            str(symbol)
            for variable in self._system.state
            if str(variable) in self._columns
            for symbol in flat([variable])
        ]
        return with_contact(samples, self.modes, self.events, columns)

    def overview(self) -> Overview:
        """Body and contact, interval of time, events and the end."""
        kinds = Counter(event.kind for event in self.events)
        return Overview(
            f"Motion with friction: t = {self.times[0]:.9g} to {self.end_time:.9g}, "
            f"{len(self.times):,} samples",
            (
                ("contact", self.contact.setting),
                ("modes", ", ".join(dict.fromkeys(piece.mode for piece in self.intervals))),
                ("events", ", ".join(f"{n:,} {kind}" for kind, n in kinds.most_common())),
                ("ended early", self.reason),
                ("energy lost", f"{self.energy_lost:.6g} J"),
                ("steps", f"{self.steps:,}"),
            ),
        )


@arguments_checked
def contact_motion(
    contact: FrictionalContact | CompiledContact,
    state: Sequence[float] | FloatArray,
    times: Sequence[float] | FloatArray,
    rules: EventRules = EventRules(),  # noqa: B008  (immutable)
    *,
    tolerance: float = FINEST_TOLERANCE["double"],
    progress: Callable[[float], None] | None = None,
) -> ContactMotion:
    """The motion of a body with friction, through all changes of its contact.

    Parameters
    ----------
    contact : FrictionalContact or CompiledContact
        A compiled contact can be reused for several motions of one body.
    state : array (16,) or (size,)
        At the first time, as from :func:`nonholonomic.initial_state`; without works, those are
        zero.
    times : array (n,)
        Sample times, increasing.
    rules : EventRules
        Rules for lift-off, landing and impacts.
    tolerance : float
        See :mod:`flowlanes.system.tolerance`; by default the finest of doubles, since events
        magnify errors.
    progress : callable, optional
        Called with the fraction completed.

    Returns
    -------
    ContactMotion

    Raises
    ------
    InputError
        If the times do not increase, or the body lies in its support.

    Examples
    --------
    A billiard ball slides for 2|u|/(7μg) and then rolls with 5/7 of its velocity.

    >>> import numpy as np
    >>> import flowlanes
    >>> import nonholonomic
    >>> from nonholonomic.contact import Coulomb, FrictionalContact, contact_motion
    >>> ball = nonholonomic.Body(0.2, (2e-4, 2e-4, 2e-4), nonholonomic.Ball(0.05))
    >>> table = FrictionalContact(
    ...     ball, laws=(Coulomb(0.2),), field=nonholonomic.Forces(gravity=9.81)
    ... )
    >>> start = [1, 0, 0, 0, 0, 0, 0.05, 1.4, 0, 0, 0, 0, 0, 0, 0, 1]
    >>> motion = contact_motion(table, start, [0.0, 1.0])
    >>> print(motion.events[0])
    t = 0.203873598: stick, then rolling
    >>> round(float(motion["velocity"][-1, 0]), 12)
    1.0
    """
    moments = as_float_array("times", times)
    increasing = moments.ndim == 1 and len(moments) and np.all(np.diff(moments) > 0)
    if not increasing or not np.isfinite(moments).all():
        raise InputError("times: they must be finite numbers that increase")
    compiled = contact
    if not isinstance(compiled, CompiledContact):
        compiled = CompiledContact(compiled, tolerance)
    course = Course(compiled, _checked_start(compiled, state), moments, rules)
    span = float(moments[-1] - moments[0]) or 1.0
    try:
        course.run(progress and (lambda time: progress((time - float(moments[0])) / span)))
    except KeyboardInterrupt:
        if not any(len(piece.times) for piece in course.pieces):
            raise
        raise InterruptedMotionError(_motion_to_last_sample(course)) from None
    return _motion(course, course.pieces)


def _motion(course: Course, pieces: Sequence[Piece]) -> ContactMotion:
    """The motion computed by a simulation."""
    samples = [p.states[:, : course.contact.size] for p in pieces]
    modes = [np.full(len(p.times), MODE_NAMES.index(p.mode.name), np.int8) for p in pieces]
    return ContactMotion(
        contact=course.contact.situation,
        times=np.concatenate([p.times for p in pieces]),
        states=np.concatenate(samples),
        modes=np.concatenate(modes),
        events=tuple(course.events),
        intervals=_intervals(pieces),
        end_time=course.time,
        end_state=course.state,
        reason=course.reason,
        steps=course.steps,
        ending=course.ending,
        _pieces=tuple(pieces),
        _columns=course.contact.columns,
        _system=course.contact.mode(FLIGHT).system,
    )


def _motion_to_last_sample(course: Course) -> ContactMotion:
    """The motion of a simulation that may have been interrupted within an event."""
    motion = _motion(course, course.pieces)
    end = float(motion.times[-1])
    return replace(
        motion,
        events=tuple(event for event in motion.events if event.time <= end),
        end_time=end,
        end_state=motion.states[-1],
        reason="interrupted",
        ending="failure",
    )


def _checked_start(contact: CompiledContact, state: Sequence[float] | FloatArray) -> FloatArray:
    """The state extended by the work columns, in contact or above the support."""
    start = as_float_array("state", state).copy()
    if start.shape not in ((WORK,), (contact.size,)):
        raise InputError(
            f"state: {start.shape} numbers; a state has {WORK}, or {contact.size} "
            "with the works lost"
        )
    if not np.isfinite(start).all():
        raise InputError("state: all its numbers must be finite")
    if not start[ATTITUDE].any():
        raise InputError("state: its first four numbers, the attitude, are zero")
    if obstacle := contact.obstacle(start):
        raise InputError(f"state: {obstacle}")
    if len(start) == WORK:
        start = np.append(start, np.zeros(contact.size - WORK))
    known = contact.numbers(start)
    if known.gap < -DEEPEST * float(np.linalg.norm(known.r)):
        raise InputError(
            f"position: the body lies {-known.gap:.6g} m inside the support; raise it at least so "
            "much"
        )
    return start


def _intervals(pieces: Sequence[Piece]) -> tuple[Interval, ...]:
    """The intervals between mode changes; consecutive pieces of the same mode are merged."""
    groups = [list(group) for _, group in groupby(pieces, key=lambda p: p.mode.name)]
    return tuple(Interval(g[0].mode.name, g[0].begin, g[-1].end) for g in groups)
