"""A motion with friction as a dataset: contact mode of each sample, events, dissipated work."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.friction.modes import MODE_NAMES

from .trajectory import ContactTrajectory, work_names

#: Dimensions, values and attributes of a variable of the events.
EventVariable: TypeAlias = tuple[
    str | tuple[str, ...], FloatArray | npt.NDArray[Any], Mapping[str, object]
]

#: State variables that the dataset stores in space axes under other names.
_ELSEWHERE = ("position", "v")

#: Maximum number of events listed in the text attribute; the variables hold all of them.
_MOST_EVENTS = 100

_WORKS = {
    "work_impact": "work lost in impacts",
    "work_support": "work lost to the moving support",
}


def contact_dataset(trajectory: ContactTrajectory, samples: xr.Dataset) -> xr.Dataset:
    """The dataset of a motion with friction.

    Parameters
    ----------
    trajectory : ContactTrajectory
    samples : xarray.Dataset
        What any trajectory has: its states, observables and laws.

    Returns
    -------
    xarray.Dataset
        The variables of a rolling body; ``velocity``, ``slip``, ``spin``, ``friction_force``,
        ``friction_couple``, ``power_lost``, ``gap``, the work lost to each law ``work_<law>``,
        and ``mode``, a flag.  A dimension ``event`` has ``event_time``, ``event_kind``, the mode
        that follows, states before and after (dimension ``state``), and impulses.
    """
    dataset = samples.drop_vars([name for name in _ELSEWHERE if name in samples])
    modes = trajectory.modes.astype(np.int8)
    dataset["mode"] = ("time", modes, mode_flags("mode of the contact"))
    dataset = dataset.assign(_event_variables(trajectory))
    dataset = dataset.assign_coords(state=("state", _columns(trajectory), _STATE))
    lines = [str(event) for event in trajectory.events]
    if len(lines) > _MOST_EVENTS + 1:
        more = f"... {len(lines) - _MOST_EVENTS - 1} more events: see event_time and event_kind"
        lines = [*lines[:_MOST_EVENTS], more, lines[-1]]
    return dataset.assign_attrs(
        events="\n".join(lines),
        end_time=float(trajectory.times[-1]),
        end_reason=trajectory.reason,
        energy_balance_drift=trajectory.drift,
        friction=trajectory.contact.setting,
        restitution=trajectory.rules.restitution,
        impact_law=trajectory.rules.impact_law,
    )


_STATE = {
    "long_name": "column of the state; v is the velocity of the centre of mass along body axes",
    "units": "1",
    "source": "",
}


def work_meanings(contact: FrictionalContact, system: System) -> dict[str, tuple[str, str]]:
    """Meaning and unit of the work dissipated by each law, by the names of a system."""
    words = {f"work_{law.name}": f"work lost to {law.words}" for law in contact.laws}
    return {name: ((_WORKS | words).get(name, name), "J") for name in work_names(system)}


def _columns(trajectory: ContactTrajectory) -> list[str]:
    return [str(symbol) for symbol in trajectory.system.symbols]


def mode_flags(meaning: str) -> dict[str, object]:
    """The attributes of a mode flag, by the CF conventions."""
    return {
        "long_name": meaning,
        "units": "1",
        "source": "",
        "flag_values": np.arange(len(MODE_NAMES), dtype=np.int8),
        "flag_meanings": " ".join(name.replace(" ", "_") for name in MODE_NAMES),
    }


def _event_variables(trajectory: ContactTrajectory) -> dict[str, EventVariable]:
    """The variables of the dimension ``event``."""
    events, size = trajectory.changes, len(trajectory.system.symbols)

    def rows(values: list[FloatArray], width: int) -> FloatArray:
        return np.array(values, dtype=float).reshape(len(events), width)

    def notes(meaning: str, unit: str, **more: str) -> dict[str, str]:
        return {"long_name": meaning, "units": unit, "source": "", **more}

    modes = np.array([MODE_NAMES.index(event.mode) for event in events], dtype=np.int8)
    kinds = np.array([event.kind for event in events], dtype="<U30")
    times = np.array([event.time for event in events], dtype=float)
    unique = np.array([event.unique for event in events], dtype=np.int8)
    couples = np.array([event.couple_impulse for event in events], dtype=float)
    before = rows([event.before[:size] for event in events], size)
    after = rows([event.after[:size] for event in events], size)
    impulses = rows([event.impulse for event in events], 3)
    body = "body axes"
    return {
        "event_time": ("event", times, notes("time of the event", "s")),
        "event_kind": ("event", kinds, notes("what happened at the contact", "1")),
        "event_mode": ("event", modes, mode_flags("mode after the event")),
        "event_state_before": (
            ("event", "state"),
            before,
            notes("state before the event", "SI"),
        ),
        "event_state_after": (("event", "state"), after, notes("state after the event", "SI")),
        "event_impulse": (
            ("event", "axis"),
            impulses,
            notes("impulse of the support on the body", "N s", frame=body),
        ),
        "event_unique": ("event", unique, notes("1 if no other motion is possible after it", "1")),
        "event_couple_impulse": (
            "event",
            couples,
            notes("impulse of the couple about the normal", "N m s"),
        ),
    }
