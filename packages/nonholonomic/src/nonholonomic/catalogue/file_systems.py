"""Systems of the catalogue that a file describes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, partial
from importlib import import_module
from typing import Any, TypeVar

from pydantic import Field

from flowlanes.errors import InputError
from flowlanes.system.system import System

from ..mechanics.lagrangian.mechanism import Mechanism
from ..mechanics.lagrangian.plan import Plan, plan_of
from ..mechanics.lagrangian.poincare_suslov import equations_of_motion
from ..system_files.conditions import require_fulfilled
from ..system_files.described import EquationsFile, MechanismFile
from ..system_files.source import Source
from ..system_files.sourced import validated
from ..system_files.systems import (
    ClaimedSystem,
    described_plan,
    equations_of,
    mechanism_of,
    name_of,
    with_claims,
)
from ..system_files.tables import NumberValue
from .catalogue_entry import Entry, Numbers, entry_with, function_of
from .entry_files import EntryFile, entry_file, paths
from .names import lookup


class _Equations(EquationsFile):
    """The equations of a file, beside its start and the time for which it is followed."""

    start: dict[str, NumberValue] = Field(default={})
    run: dict[str, Any] = Field(default={})


class _Mechanism(MechanismFile):
    """The Lagrangian of a file, beside its start and the time for which it is followed."""

    start: dict[str, NumberValue] = Field(default={})
    run: dict[str, Any] = Field(default={})


def catalogue_system(name: str, parameters: Mapping[str, Any]) -> System:
    """A system of the catalogue, onto which an isomorphism may lead.

    Raises
    ------
    InputError
        If there is none of that name, or it has no such parameter.
    """
    return entry_of(entry_file(lookup(paths(), name).stem)).system(parameters)


FileModel = TypeVar("FileModel", _Equations, _Mechanism)


def _tables(model: type[FileModel], file: EntryFile) -> FileModel:
    """The tables of a file, which has the name of its system."""
    source = Source(file.path.name, file.text)
    tables = validated(model, source.tables(), source)
    if name_of(tables) != file.name:
        raise InputError(f'must be "{file.name}", as the file is called', tables.where("name"))
    return tables


@cache
def claimed_system(name: str) -> ClaimedSystem:
    """The equations of a file of the catalogue, with all laws that it claims.

    Raises
    ------
    InputError
        For what is wrong in the file: its name, line, key and what is allowed.
    """
    return equations_of(_tables(_Equations, entry_file(name)), catalogue_system)


def file_system(name: str, numbers: Numbers) -> System:
    """The system of a file of the catalogue, with some values of its parameters.

    Raises
    ------
    InputError
        For what is wrong in the file, or if the values are not admissible.
    """
    return claimed_system(name).with_numbers(numbers)


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
    return with_claims(_mechanism_file(name), derived, catalogue_system)


@cache
def _mechanism_file(name: str) -> _Mechanism:
    return _tables(_Mechanism, entry_file(name))


@cache
def mechanism_in_catalogue(name: str) -> Mechanism:
    """The Lagrangian, frame and constraints of a file of the catalogue."""
    return mechanism_of(_mechanism_file(name))


def entry_of(file: EntryFile) -> Entry:
    """The entry of a file, with what Python brings where it does.

    Raises
    ------
    InputError
        If it draws a mechanism and a formula of the drawing cannot be read.
    """
    if file.python:
        entries = import_module(f".{file.python}", __package__).ENTRIES
        found: Entry = next(item for item in entries if item.name == file.name)
        return found
    if "body" in file.tables:
        # the mechanics of rolling takes time to import, and equations do without
        from .body_entries import body_entry

        return body_entry(file)
    name = file.name
    by_lagrangian = "lagrangian" in file.tables
    conditional = any(
        "where" in law
        for kind in file.tables.get("laws", {}).values()
        for law in kind.values()
        if isinstance(law, dict)
    )
    general: Callable[[], System] | None = None
    if file.general:
        general = function_of(file.general)
    elif conditional:
        general = partial(_unclaimed_system, name)
    return entry_with(
        name,
        build=partial(mechanism_system if by_lagrangian else file_system, name),
        general=general,
        plan=_plan(name, by_lagrangian) if "plan" in file.tables else None,
    )


def _unclaimed_system(name: str) -> System:
    return claimed_system(name).unclaimed


def _plan(name: str, by_lagrangian: bool) -> Plan | None:
    if by_lagrangian:
        mechanism = mechanism_in_catalogue(name)
        return described_plan(_mechanism_file(name), equations_of_motion(mechanism)) or plan_of(
            mechanism
        )
    file = _tables(_Equations, entry_file(name))
    return described_plan(file, claimed_system(name).system)
