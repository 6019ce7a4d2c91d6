"""The trajectory of a motion with friction: samples, their modes, and all events."""

from __future__ import annotations

import time as clock
from collections import Counter
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import sympy as sp
import xarray as xr

from flowlanes.errors import InputError, InterruptionError, RunError
from flowlanes.flow.motion import by_name
from flowlanes.flow.trajectory import Event, Statistics, Trajectory
from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import Guard, System
from nonholonomic.contact.dataset import with_contact, work_meanings, work_names
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.modes import FLIGHT
from nonholonomic.contact.motion import ContactMotion, InterruptedMotionError, contact_motion
from nonholonomic.contact.simulation.compiled import CompiledContact
from nonholonomic.contact.simulation.event_rules import EventRules
from nonholonomic.contact.simulation.events import ContactEvent

#: The law of energy including all dissipated work.
BALANCE = "energy_balance"

#: Maximum number of events in the text attribute; the variables have all of them.
_MOST_EVENTS = 100


@dataclass(frozen=True, repr=False, eq=False, kw_only=True)
class ContactTrajectory(Trajectory):
    """States and observables along a motion with friction.

    Attributes
    ----------
    contact : FrictionalContact
    rules : EventRules
    modes : array (n,)
        Mode of each sample, an index into :data:`nonholonomic.contact.friction.modes.MODE_NAMES`.
    changes : tuple of ContactEvent
        Events of the contact, with states and impulses.
    reason : str
        Reason of an early end; empty if the motion is complete.
    """

    contact: FrictionalContact
    rules: EventRules
    modes: npt.NDArray[np.int8]
    changes: tuple[ContactEvent, ...]
    reason: str = ""

    @property
    def works(self) -> dict[str, FloatArray]:
        """The work dissipated by each law, by impacts and by a moving support, (n,) each (J)."""
        return {name: by_name(self.system, self.states, name) for name in work_names(self.system)}

    @property
    def drift(self) -> float:
        """Largest change of energy including dissipated work, relative to the energies involved."""
        balance = self.records[f"law_{BALANCE}"]
        sizes = [self.records["energy"], *self.works.values()]
        size = max(float(np.abs(values).max()) for values in sizes)
        change = float(np.abs(balance - balance[0]).max())
        return change / size if size else change

    @property
    def kinds(self) -> dict[str, int]:
        """The kinds of events with their counts, the most frequent first."""
        return dict(Counter(event.kind for event in self.changes).most_common())

    def to_dataset(
        self,
        attributes: Mapping[str, object] | None = None,
        meanings: Mapping[str, tuple[str, str]] | None = None,
    ) -> xr.Dataset:
        """The dataset of a motion with friction.

        Returns
        -------
        xarray.Dataset
            The variables of a rolling body; ``velocity``, ``slip``, ``spin``,
            ``friction_force``, ``friction_couple``, ``power_lost``, ``gap``, the work lost to
            each law ``work_<law>``, and ``mode``, a flag.  A dimension ``event`` has
            ``event_time``, ``event_kind``, the mode that follows, states before and after
            (dimension ``state``), and impulses.
        """
        known = work_meanings(self.contact, self.system) | dict(meanings or {})
        samples = super().to_dataset(attributes, known)
        columns = [str(symbol) for symbol in self.system.symbols]
        lines = [str(event) for event in self.events]
        if len(lines) > _MOST_EVENTS + 1:
            more = f"... {len(lines) - _MOST_EVENTS - 1} more events: see event_time and event_kind"
            lines = [*lines[:_MOST_EVENTS], more, lines[-1]]
        return with_contact(samples, self.modes, self.changes, columns).assign_attrs(
            events="\n".join(lines),
            end_time=float(self.times[-1]),
            end_reason=self.reason,
            energy_balance_drift=self.drift,
            friction=self.contact.setting,
            restitution=self.rules.restitution,
            impact_law=self.rules.impact_law,
        )

    def subsample(self, pieces: int) -> ContactTrajectory:
        """Every `pieces`-th sample, and the last one."""
        thin = super().subsample(pieces)
        assert isinstance(thin, ContactTrajectory)
        last = len(self.times) - 1
        return replace(thin, modes=self.modes[[*range(0, last, pieces), last]])


def contact_trajectory(
    machine: CompiledContact,
    system: System,
    state: FloatArray,
    times: FloatArray,
    rules: EventRules,
    progress: Callable[[float], None] | None = None,
) -> ContactTrajectory:
    """Compute the motion of a body with friction through sample times.

    Parameters
    ----------
    machine : CompiledContact
    system : System
        The equations of one of its modes, with the title of the motion.
    state : array (size,)
    times : array (n,)
        In s, increasing.
    rules : EventRules
    progress : callable, optional
        Called with the fraction completed.

    Raises
    ------
    InputError
        If there is no motion from the start.
    RunError
        If the motion ends early, except at a lift-off at which it was to stop; it carries the
        trajectory so far. An InterruptionError if it is interrupted.
    """
    began = clock.perf_counter()
    interrupted = False
    try:
        motion = contact_motion(machine, state, times, rules, progress=progress)
    except InterruptedMotionError as stop:
        motion, interrupted = stop.partial, True
    stopped = motion.reason and not interrupted
    if not len(motion.times) or (stopped and motion.end_time <= times[0]):
        raise InputError(f"there is no motion from here: {_advice(motion.reason, rules)}")
    recorded = dict(motion.observables)
    works = (by_name(system, motion.states, name) for name in work_names(system))
    recorded[f"law_{BALANCE}"] = recorded["energy"] + sum(works)
    trajectory = ContactTrajectory(
        system=system,
        parameters=system.defaults,
        times=motion.times,
        states=motion.states,
        records=recorded,
        events=_events(motion),
        statistics=Statistics(
            method="Taylor series, pieces joined by events,",
            steps=motion.steps,
            order=machine.mode(FLIGHT).code.series.order,
            tolerance=machine.tolerance,
            precision="double",
            corrections=0,
            seconds=clock.perf_counter() - began,
            from_cache=False,
        ),
        contact=machine.situation,
        rules=rules,
        modes=motion.modes,
        changes=tuple(motion.events),
        reason=motion.reason,
    )
    if interrupted:
        raise InterruptionError(motion.reason, motion.end_time, trajectory)
    if motion.reason and not _is_asked_for(trajectory):
        raise RunError(_advice(motion.reason, rules), motion.end_time, trajectory)
    return trajectory


def _is_asked_for(trajectory: ContactTrajectory) -> bool:
    """Whether a motion ended at the lift-off at which it was meant to stop."""
    last = trajectory.changes[-1:]
    return trajectory.rules.on_liftoff == "stop" and [e.kind for e in last] == ["lift-off"]


def _advice(reason: str, rules: EventRules) -> str:
    """The reason, with advice for the user."""
    if "Painlevé" in reason and rules.on_paradox == "stop":
        return f'{reason}; on_paradox = "impact" in [contact] takes an impact without collision'
    return reason


def _events(motion: ContactMotion) -> tuple[Event, ...]:
    """The events in the form of any trajectory."""
    events = [
        Event(item.time, Guard(item.kind, sp.S.One, f"{item.kind}, then {item.mode}"), False)
        for item in motion.events
    ]
    if motion.reason:
        events.append(Event(motion.end_time, Guard("end", sp.S.One, motion.reason), True))
    return tuple(events)
