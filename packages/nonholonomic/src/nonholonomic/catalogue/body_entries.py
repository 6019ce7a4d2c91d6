"""Systems of the catalogue whose file describes a body that rolls on a plane or a sphere."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar

from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ..mechanics.rolling.equations import RollingBody
from ..system_files.bodies import BodyFile, RollingFile
from ..system_files.body_objects import rolling_body
from ..system_files.source import Source
from ..system_files.sourced import validated
from .catalogue_entry import Entry, Numbers, entry_with, function_of
from .entry_files import EntryFile, entry_file

FileModel = TypeVar("FileModel", bound=BodyFile)


class _RollingEntry(RollingFile):
    """A rolling body, beside its title, its start and the time for which it is followed."""

    title: str
    start: dict[str, Any]
    run: dict[str, Any]


def tables_with(model: type[FileModel], name: str, numbers: Numbers) -> FileModel:
    """The tables of a body's file for some values of the parameters.

    Raises
    ------
    InputError
        If the values are not admissible; it names the keys, but no line, since whoever gives
        values did not write the file.
    """
    values = {symbol: float(value) for symbol, value in numbers.items()}
    return validated(model, {**entry_file(name).tables, "parameters": values}, Source(name, ""))


def no_laws(*described: object) -> tuple[Law, ...]:
    """No laws, where a file names no function that states some."""
    return ()


def body_entry(file: EntryFile) -> Entry:
    """Catalogue entry for a body that is described in a file.

    Laws are stated in Python, as they hold for every body of a kind.
    """
    general: Callable[[], System] | None = function_of(file.general) if file.general else None
    return entry_with(
        file.name,
        build=partial(_body, file.name),
        laws=function_of(file.laws) if file.laws else no_laws,
        general=general,
    )


def catalogue_body(name: str) -> RollingBody:
    """The rolling body of an entry, with the values of its file."""
    return _body(name, entry_file(name).parameters)


def _body(name: str, numbers: Numbers) -> RollingBody:
    return rolling_body(tables_with(_RollingEntry, name, numbers))
