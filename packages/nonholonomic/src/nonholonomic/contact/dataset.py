"""Datasets of motions with friction: the mode of the contact, and its events."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
import xarray as xr

from flowlanes.system.arrays import FloatArray
from flowlanes.system.system import System

from .equations.situation import FrictionalContact
from .friction.modes import MODE_NAMES
from .simulation.events import ContactEvent

#: Dimensions, values and attributes of a variable of the events.
EventVariable: TypeAlias = tuple[
    str | tuple[str, ...], FloatArray | npt.NDArray[Any], Mapping[str, object]
]

#: Variables of the state that a dataset has in space axes under other names.
_ELSEWHERE = ("position", "v")

_WORKS = {
    "work_impact": "work lost in impacts",
    "work_support": "work lost to the moving support",
}


def with_contact(
    samples: xr.Dataset,
    modes: npt.NDArray[np.int8],
    events: Sequence[ContactEvent],
    columns: Sequence[str],
) -> xr.Dataset:
    """A dataset of samples together with the modes of the contact and its events.

    Parameters
    ----------
    samples : xarray.Dataset
    modes : array (n,)
        Mode of each sample, an index into `MODE_NAMES`.
    events : sequence of ContactEvent
    columns : sequence of str
        Names of the components of the state.
    """
    others = samples.drop_vars([name for name in _ELSEWHERE if name in samples])
    dataset = others.assign(mode=("time", modes.astype(np.int8), mode_flags("mode of the contact")))
    dataset = dataset.assign(_event_variables(events, len(columns)))
    return dataset.assign_coords(state=("state", list(columns), _STATE))


def work_names(system: System) -> list[str]:
    """The variables of a state that are dissipated work."""
    return [str(name) for name in system.state if str(name).startswith("work_")]


_STATE = {
    "long_name": "column of the state; v is the velocity of the centre of mass along body axes",
    "units": "1",
    "source": "",
}


def work_meanings(contact: FrictionalContact, system: System) -> dict[str, tuple[str, str]]:
    """Meaning and unit of the work dissipated by each law, by the names of a system."""
    words = {f"work_{law.name}": f"work lost to {law.description}" for law in contact.laws}
    return {name: ((_WORKS | words).get(name, name), "J") for name in work_names(system)}


def mode_flags(meaning: str) -> dict[str, object]:
    """The attributes of a mode flag, by the CF conventions."""
    return {
        "long_name": meaning,
        "units": "1",
        "source": "",
        "flag_values": np.arange(len(MODE_NAMES), dtype=np.int8),
        "flag_meanings": " ".join(name.replace(" ", "_") for name in MODE_NAMES),
    }


def _event_variables(events: Sequence[ContactEvent], size: int) -> dict[str, EventVariable]:
    """The variables of the dimension ``event``."""

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
