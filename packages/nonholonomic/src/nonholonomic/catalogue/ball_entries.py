"""Systems of the catalogue whose file describes a homogeneous ball on a surface."""

from __future__ import annotations

from functools import partial
from typing import Any

from ..mechanics.ball.ball import RollingBall
from ..system_files.ball_objects import rolling_ball
from ..system_files.bodies import BallFile
from .ball_entry import ball_entry
from .body_entries import no_laws, tables_with
from .catalogue_entry import Entry, Numbers, function_of
from .entry_files import EntryFile


class _BallEntry(BallFile):
    """A homogeneous ball, beside its title, its start and the time for which it is followed."""

    title: str
    start: dict[str, Any]
    run: dict[str, Any]


def entry_of_ball(file: EntryFile) -> Entry:
    """The entry of a file with a ball; ``catalogue.laws`` states laws of this ball only."""
    return ball_entry(
        name=file.name,
        ball=partial(_ball, file.name),
        further=function_of(file.laws) if file.laws else no_laws,
        general=function_of(file.general) if file.general else None,
    )


def _ball(name: str, numbers: Numbers) -> RollingBall:
    return rolling_ball(tables_with(_BallEntry, name, numbers))
