"""Motions with friction of many members, each an experiment with other numbers."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from pydantic import ValidationError

from flowlanes.errors import InputError
from flowlanes.scans.grid import INADMISSIBLE, NO_STATE
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.motion import ContactMotion, contact_motion
from nonholonomic.contact.simulation.compiled import CompiledContact
from nonholonomic.contact.simulation.end_reasons import END_REASONS
from nonholonomic.contact.simulation.event_rules import EventRules
from nonholonomic.system_files.validation import validation_messages

from ..models.experiment import parse_experiment
from ..models.rolling_model import FrictionExperiment
from ..subjects.contact_subject import ContactSubject, contact_and_rules, contact_subject, start_of
from .file_numbers import FileNumbers

#: Codes of the end reasons in datasets, in the order of `END_REASONS`.
CODES = {ending: code for code, ending in enumerate(END_REASONS)}


@dataclass(frozen=True, eq=False)
class MemberMotion:
    """A motion of a member, or the reason why there is none.

    Attributes
    ----------
    outcome : int
        The code of its ending, 0 if the last time was reached; negative if there is no motion.
    motion : ContactMotion or None
    reason : str
    """

    outcome: int
    motion: ContactMotion | None
    reason: str = ""


def member_motion(
    experiment: str, values: Mapping[str, float | FloatArray], times: FloatArray, tolerance: float
) -> MemberMotion:
    """The motion of an experiment with some of its numbers replaced.

    Parameters
    ----------
    experiment : str
        The text of the file.
    values : mapping of str to float or array
        See :class:`FileNumbers`.
    times : array (n,)
    tolerance : float
    """
    outcome, start = member_start(experiment, values, tolerance)
    if isinstance(start, str):
        return MemberMotion(outcome, None, start)
    compiled, state, rules = start
    motion = contact_motion(compiled, state, times, rules)
    return MemberMotion(CODES[motion.ending], motion, motion.reason)


def member_start(
    experiment: str, values: Mapping[str, float | FloatArray], tolerance: float
) -> tuple[int, tuple[CompiledContact, FloatArray, EventRules] | str]:
    """The contact, the start and the rules of a member.

    Or the reason why there are none, with its code.
    """
    tables = _numbers(experiment).tables_with(values)
    try:
        changed = FrictionExperiment.model_validate(tables)
        contact, rules = contact_and_rules(changed)
    except ValidationError as error:
        (key, sentence), *_ = validation_messages(error, FrictionExperiment, tables).items()
        return INADMISSIBLE, f"{'.'.join(key)} {sentence}"
    except InputError as error:
        return INADMISSIBLE, error.message
    try:
        state = start_of(contact, changed.start.model_dump(exclude_none=True))
    except InputError as error:
        return NO_STATE, error.message
    return 0, (_thread_contact(contact, tolerance, threading.get_ident()), state, rules)


def samples_reached(motion: ContactMotion, times: FloatArray) -> int:
    """The number of sample times that a motion reached."""
    count = min(len(motion.times), len(times))
    return int(np.count_nonzero(motion.times[:count] == times[:count]))


@lru_cache(maxsize=8)
def _numbers(text: str) -> FileNumbers:
    return FileNumbers(friction_experiment(text))


@lru_cache(maxsize=8)
def friction_experiment(text: str) -> FrictionExperiment:
    """Read an experiment with friction from text."""
    experiment = parse_experiment(text)
    assert isinstance(experiment, FrictionExperiment)
    return experiment


@lru_cache(maxsize=8)
def friction_subject(text: str) -> ContactSubject:
    """The body with friction of an experiment text, created once for all its members."""
    return contact_subject(friction_experiment(text))


@lru_cache(maxsize=16)
def _thread_contact(contact: FrictionalContact, tolerance: float, _: int) -> CompiledContact:
    """A compiled contact for one thread, whose integrators are modified by use."""
    return CompiledContact(contact, tolerance)
