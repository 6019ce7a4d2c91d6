"""Systems of the catalogue that a file describes by equations."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, partial
from typing import Any, TypeVar

from pydantic import Field

from flowlanes.errors import InputError
from flowlanes.system.system import System

from ..system_files.described import DescribedFile, EquationsFile
from ..system_files.equations import ClaimedSystem, equations_of
from ..system_files.parts import name_of
from ..system_files.plans import described_plan
from ..system_files.source import Source
from ..system_files.sourced import validated
from ..system_files.tables import NumberValue
from .catalogue_entry import Entry, Numbers, entry_with, function_of
from .entry_files import EntryFile, entry_file, paths
from .names import lookup


class _Equations(EquationsFile):
    """The equations of a file, beside its start and the time for which it is followed."""

    start: dict[str, NumberValue] = Field(default={})
    run: dict[str, Any] = Field(default={})


FileModel = TypeVar("FileModel", bound=DescribedFile)


def read_tables(model: type[FileModel], file: EntryFile) -> FileModel:
    """The tables of a file, which has the name of its system.

    Raises
    ------
    InputError
        For what is wrong in the file: its name, line, key and what is allowed.
    """
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
    return equations_of(read_tables(_Equations, entry_file(name)), target_in_catalogue)


def target_in_catalogue(name: str, parameters: Mapping[str, Any]) -> System:
    """The system onto which an isomorphism of a file of the catalogue leads; it has equations too.

    Raises
    ------
    InputError
        If there is none of that name, or it has no such parameter.
    """
    return equations_entry(entry_file(lookup(paths(), name).stem)).system(parameters)


def file_system(name: str, numbers: Numbers) -> System:
    """The system of a file of the catalogue, with some values of its parameters.

    Raises
    ------
    InputError
        For what is wrong in the file, or if the values are not admissible.
    """
    return claimed_system(name).with_numbers(numbers)


def equations_entry(file: EntryFile) -> Entry:
    """The entry of a file with equations.

    Raises
    ------
    InputError
        If the file has a drawing, and a formula of it cannot be read.
    """
    name = file.name
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
    plan = None
    if "plan" in file.tables:
        plan = described_plan(read_tables(_Equations, file), claimed_system(name).system)
    return entry_with(name, build=partial(file_system, name), general=general, plan=plan)


def _unclaimed_system(name: str) -> System:
    return claimed_system(name).unclaimed
