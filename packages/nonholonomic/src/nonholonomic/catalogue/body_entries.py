"""Systems of the catalogue whose file describes a body that rolls, or a homogeneous ball."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any, TypeVar

from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ..mechanics.ball.ball import RollingBall
from ..mechanics.rolling.equations import RollingBody
from ..system_files.ball_objects import rolling_ball
from ..system_files.bodies import BallFile, BodyFile, RollingFile, is_ball_file
from ..system_files.body_objects import rolling_body
from ..system_files.source import Source
from ..system_files.sourced import validated
from .ball_entry import ball_entry
from .catalogue_entry import Entry, Numbers, entry_with, function_of
from .entry_files import EntryFile, entry_file


class _RollingEntry(RollingFile):
    """A rolling body, beside its title, its start and the time for which it is followed."""

    title: str
    start: dict[str, Any]
    run: dict[str, Any]


class _BallEntry(BallFile):
    """A homogeneous ball, beside its title, its start and the time for which it is followed."""

    title: str
    start: dict[str, Any]
    run: dict[str, Any]


FileModel = TypeVar("FileModel", bound=BodyFile)


def _tables(model: type[FileModel], name: str, numbers: Numbers) -> FileModel:
    """The tables of a file for some values of the parameters.

    Raises
    ------
    InputError
        If the values are not admissible.
    """
    values = {symbol: float(value) for symbol, value in numbers.items()}
    # the lines of the file are of no use to whoever gave the values
    return validated(model, {**entry_file(name).tables, "parameters": values}, Source(name, ""))


def body_entry(file: EntryFile) -> Entry:
    """The entry of a file with a body.

    Laws, which hold for every body of a kind, are stated in Python.
    """
    general: Callable[[], System] | None = function_of(file.general) if file.general else None
    laws = function_of(file.laws) if file.laws else _no_laws
    if is_ball_file(file.tables):
        return ball_entry(
            name=file.name, ball=partial(_ball, file.name), further=laws, general=general
        )
    return entry_with(file.name, build=partial(_body, file.name), laws=laws, general=general)


def _no_laws(*described: object) -> tuple[Law, ...]:
    return ()


def _body(name: str, numbers: Numbers) -> RollingBody:
    return rolling_body(_tables(_RollingEntry, name, numbers))


def _ball(name: str, numbers: Numbers) -> RollingBall:
    return rolling_ball(_tables(_BallEntry, name, numbers))


def catalogue_body(name: str) -> RollingBody:
    """The rolling body of an entry, with the values of its file."""
    return _body(name, entry_file(name).parameters)
