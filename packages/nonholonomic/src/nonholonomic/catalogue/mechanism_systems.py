"""Systems of the catalogue that a file describes by a Lagrangian."""

from __future__ import annotations

from dataclasses import replace
from functools import cache, partial
from typing import Any

from pydantic import Field

from flowlanes.system.system import System

from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.lagrangian.plan import Plan, plan_of
from ..mechanics.lagrangian.poincare_suslov import equations_of_motion
from ..system_files.conditions import require_fulfilled
from ..system_files.described import MechanismFile
from ..system_files.mechanisms import mechanism_of, with_claims
from ..system_files.plans import described_plan
from ..system_files.tables import NumberValue
from .catalogue_entry import Entry, Numbers, entry_with, function_of
from .entry_files import EntryFile, entry_file
from .file_systems import read_tables, target_in_catalogue


class _Mechanism(MechanismFile):
    """The Lagrangian of a file, beside its start and the time for which it is followed."""

    start: dict[str, NumberValue] = Field(default={})
    run: dict[str, Any] = Field(default={})


def mechanism_system(name: str, numbers: Numbers) -> System:
    """The system of a Lagrangian in a file of the catalogue, with values of its parameters.

    Raises
    ------
    InputError
        For what is wrong in the file, or with the values.
    """
    mechanism = mechanism_in_catalogue(name)
    parameters = tuple(
        replace(p, default=numbers.get(str(p.symbol), p.default)) for p in mechanism.parameters
    )
    require_fulfilled(name, parameters, ())
    derived = equations_of_motion(replace(mechanism, parameters=parameters))
    return with_claims(_mechanism_file(name), derived, target_in_catalogue)


@cache
def _mechanism_file(name: str) -> _Mechanism:
    return read_tables(_Mechanism, entry_file(name))


@cache
def mechanism_in_catalogue(name: str) -> Mechanism:
    """The Lagrangian, frame and constraints of a file of the catalogue."""
    return mechanism_of(_mechanism_file(name))


def mechanism_entry(file: EntryFile) -> Entry:
    """The entry of a file with a Lagrangian.

    Raises
    ------
    InputError
        If the file has a drawing, and a formula of it cannot be read.
    """
    return entry_with(
        file.name,
        build=partial(mechanism_system, file.name),
        general=function_of(file.general) if file.general else None,
        plan=_plan(file.name) if "plan" in file.tables else None,
    )


def _plan(name: str) -> Plan | None:
    mechanism = mechanism_in_catalogue(name)
    return described_plan(_mechanism_file(name), equations_of_motion(mechanism)) or plan_of(
        mechanism
    )
