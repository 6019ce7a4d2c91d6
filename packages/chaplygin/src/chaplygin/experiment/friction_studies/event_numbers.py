"""Quantities of a motion with friction: counts and sums over its events, values along it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any, get_args

import numpy as np
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import nearest, parse
from flowlanes.system.arrays import FloatArray
from flowlanes.system.named_formulas import flat
from flowlanes.system.system import System
from nonholonomic.contact.dataset import work_names
from nonholonomic.contact.friction.modes import MODE_NAMES
from nonholonomic.contact.motion import ContactMotion
from nonholonomic.contact.simulation.events import EventKind
from nonholonomic.contact.simulation.mode_integrator import ModeIntegrator

#: The final fraction of a motion whose mean is ``late_mean``.
LATE = 0.2


@dataclass(frozen=True)
class EventNumber:
    """A quantity derived from the events of a motion.

    Attributes
    ----------
    meaning, unit : str
    of : callable
        Function of a motion.
    """

    meaning: str
    unit: str
    of: Callable[[ContactMotion], float]


def _last_event(motion: ContactMotion) -> float:
    return motion.events[-1].time if motion.events else float("nan")


def _time_of(kind: str) -> Callable[[ContactMotion], float]:
    return lambda motion: next((e.time for e in motion.events if e.kind == kind), float("nan"))


#: Quantities of every motion of an ensemble or a chart.
EVENT_NUMBERS: Mapping[str, EventNumber] = {
    "events": EventNumber("number of events", "1", lambda m: float(len(m.events))),
    "final_mode": EventNumber(
        "mode at the end", "1", lambda m: float(MODE_NAMES.index(m.intervals[-1].mode))
    ),
    "last_event": EventNumber("time of the last event", "s", _last_event),
    "first_stick": EventNumber("time at which sliding ends first", "s", _time_of("stick")),
    "energy_lost": EventNumber("energy lost to friction and impacts", "J", lambda m: m.energy_lost),
    "duration": EventNumber("time until the motion ends", "s", lambda m: m.end_time),
}


def _mean(values: FloatArray, times: FloatArray) -> float:
    return float(np.trapezoid(values, times) / (times[-1] - times[0]))


def _late_mean(values: FloatArray, times: FloatArray) -> float:
    return float(values[times >= times[-1] - LATE * (times[-1] - times[0])].mean())


#: Quantities of a formula at the samples of a motion: title, and computation.
_OF_FORMULA: Mapping[str, tuple[str, Callable[[FloatArray, FloatArray], float]]] = {
    "highest": ("highest value of {}", lambda values, _: float(values.max())),
    "lowest": ("lowest value of {}", lambda values, _: float(values.min())),
    "mean": ("mean of {}", _mean),
    "final": ("final value of {}", lambda values, _: float(values[-1])),
    "late_mean": ("mean of {} over the last fifth", _late_mean),
}

_KINDS: tuple[str, ...] = get_args(EventKind)

#: Quantities of a kind of event: title, unit.
_OF_KIND = {"first": ("time of the first {}", "s"), "count": ("number of events: {}", "1")}


@dataclass(frozen=True)
class MotionNumber:
    """A quantity of a motion with friction, as requested by a user.

    Attributes
    ----------
    word : str
        One of `EVENT_NUMBERS`, or ``first``, ``count``, ``highest``, ``lowest``, ``mean``,
        ``late_mean``, ``final``.
    subject : str
        The kind of event, or the formula; empty for those of `EVENT_NUMBERS`.
    """

    word: str
    subject: str = ""

    @property
    def title(self) -> str:
        """Its meaning."""
        if self.word in EVENT_NUMBERS:
            return EVENT_NUMBERS[self.word].meaning
        titles = {word: title for word, (title, _) in (*_OF_FORMULA.items(), *_OF_KIND.items())}
        return titles[self.word].format(self.subject)

    def unit(self, system: System) -> str:
        """Its unit; that of a formula is known if it is a single quantity."""
        if self.word in EVENT_NUMBERS:
            return EVENT_NUMBERS[self.word].unit
        if self.word in _OF_KIND:
            return _OF_KIND[self.word][1]
        return _units(system).get(self.subject, "unknown")

    def __call__(self, motion: ContactMotion, system: System, complete: bool) -> float:
        """The value; NaN if the motion has none.

        Parameters
        ----------
        motion : ContactMotion
        system : System
        complete : bool
            Whether it reached its last time; otherwise values along it are not used.
        """
        if self.word in EVENT_NUMBERS:
            return EVENT_NUMBERS[self.word].of(motion)
        if self.word == "first":
            return _time_of(self.subject)(motion)
        if self.word == "count":
            return float(sum(event.kind == self.subject for event in motion.events))
        if not complete:
            return float("nan")
        values = values_of_formula(self.subject, motion, system)
        return _OF_FORMULA[self.word][1](values, motion.times)


def motion_number(text: str, system: System) -> MotionNumber:
    """Parse a quantity: ``events``, ``first:slip``, ``lowest:gamma_3``.

    Parameters
    ----------
    text : str
    system : System
        The equations of one mode of the contact.

    Raises
    ------
    InputError
        If there is no such number.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from nonholonomic.contact import FrictionalContact
    >>> from nonholonomic.contact.equations.equations_of_motion import contact_equations
    >>> from nonholonomic.contact.friction.modes import Mode
    >>> from chaplygin.experiment.friction_studies.event_numbers import motion_number
    >>> ball = FrictionalContact(ch.Body(1.0, (0.4, 0.4, 0.4), ch.Ball(1.0)))
    >>> motion_number("first:spin-stop", contact_equations(ball, Mode())).title
    'time of the first spin stop'
    """
    word, colon, subject = (part.strip() for part in text.partition(":"))
    words = (*EVENT_NUMBERS, *_OF_KIND, *_OF_FORMULA)
    if word not in words:
        raise InputError(
            f"{word}: no number of a motion with friction has this name{nearest(word, words)}; "
            "some are written with an event or a formula, as in first:slip and lowest:gamma_3"
        )
    if word in EVENT_NUMBERS:
        if colon:
            raise InputError(f"{text}: this number is written {word}")
        return MotionNumber(word)
    if not subject:
        what = "EVENT" if word in _OF_KIND else "FORMULA"
        raise InputError(f"{text}: this number is written {word}:{what}")
    if word in _OF_KIND:
        kind = subject.replace("-", " ").replace("_", " ")
        kind = "lift-off" if kind == "lift off" else kind
        if kind not in _KINDS:
            raise InputError(f"{text}: no event is called {subject}{nearest(subject, _KINDS)}")
        return MotionNumber(word, kind)
    numerical_function(subject, tuple(_columns(system)), text)
    return MotionNumber(word, subject)


def recorded_values(motion: ContactMotion, system: System) -> dict[str, FloatArray]:
    """States and observables at the samples, (n,) or (n, size), by their dataset names.

    A friction law with coefficient zero, which the motion does not have, does no work.
    """
    none = dict.fromkeys(work_names(system), np.zeros(len(motion.times)))
    return none | {name: motion[name] for name in motion}


def values_of_formula(text: str, motion: ContactMotion, system: System) -> FloatArray:
    """A formula at the samples of a motion, (n,)."""
    columns = _columns(system)
    function, used = numerical_function(text, tuple(columns))
    recorded = recorded_values(motion, system)
    arguments = []
    for name in used:
        vector, place = columns[name]
        arguments.append(recorded[vector] if place < 0 else recorded[vector][:, place])
    with np.errstate(all="ignore"):
        values: FloatArray = np.broadcast_to(function(*arguments), motion.times.shape)
    return values


def require_formula(text: str, system: System, where: str = "quantity") -> None:
    """Raise InputError unless a text is a nonconstant formula in recorded quantities."""
    if not numerical_function(text, tuple(_columns(system)), where)[1]:
        raise InputError(f"{where} {text}: it is the same at all times")


def formula_at(text: str, mode: ModeIntegrator, states: FloatArray, system: System) -> FloatArray:
    """A formula in recorded quantities at states (n, columns) of a mode, (n,)."""
    columns = _columns(system)
    function, used = numerical_function(text, tuple(columns))
    needed = {columns[name][0] for name in used}
    absent = set(work_names(system)) - {str(name) for name in mode.system.state}
    places = {str(variable): columns.start for variable, columns in mode.system.slices}
    values = mode.outputs(states) if needed - places.keys() - absent else {}
    arguments = []
    for name in used:
        variable, place = columns[name]
        if variable in absent:
            arguments.append(np.zeros(len(states)))
        elif variable in places:
            arguments.append(states[:, places[variable] + max(place, 0)])
        else:
            block = values[variable]
            arguments.append(block if place < 0 else block[:, place])
    with np.errstate(all="ignore"):
        result: FloatArray = np.broadcast_to(function(*arguments), (len(states),))
    return result


@lru_cache(maxsize=8)
def _columns(system: System) -> dict[str, tuple[str, int]]:
    """Recorded scalars and components: their variable, and the index in it (−1 for a scalar)."""
    columns: dict[str, tuple[str, int]] = {}
    for name in system.state:
        symbols = flat([name])
        for place, symbol in enumerate(symbols):
            columns[str(symbol)] = (str(name), place if len(symbols) > 1 else -1)
    for item in system.scalar.observables:
        if not isinstance(item.value, sp.MatrixBase):
            columns[item.name] = (item.name, -1)
            continue
        for place in range(len(item.value)):
            columns.setdefault(f"{item.name}_{place + 1}", (item.name, place))
    return columns


def _units(system: System) -> dict[str, str]:
    """Units of recorded quantities by name."""
    known = {item.name: item.unit for item in system.observables}
    known |= {"omega": "rad/s", "gamma": "1", "position": "m", "v": "m/s"}
    known |= dict.fromkeys(work_names(system), "J")
    units = {name: known.get(variable, "") for name, (variable, _) in _columns(system).items()}
    return {name: unit or "1" for name, unit in units.items()}


@lru_cache(maxsize=256)
def numerical_function(
    text: str, names: tuple[str, ...], where: str = "", module: str = "numpy"
) -> tuple[Callable[..., Any], list[str]]:
    """A formula as a function of numbers or arrays, and the quantities it uses, in order."""
    known = {name: sp.Symbol(name, real=True) for name in names}
    value = parse(text, known, where)
    used = sorted(value.free_symbols, key=str)
    return sp.lambdify(used, value, module), [str(symbol) for symbol in used]
