"""Entries of homogeneous balls on surfaces in the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ..mechanics.ball.ball import RollingBall
from .ball_laws import known_ball_laws
from .catalogue_entry import Entry, Numbers, entry_with
from .entry_files import entry_file

#: Meaning and unit of the variables in which the start of a ball is given.
ball_variables: Mapping[str, tuple[str, str]] = {
    "R": ("centre of the ball, space axes", "m"),
    "x": ("contact point, space axes", "m"),
    "omega": ("angular velocity, space axes", "rad/s"),
}


def _nothing(ball: RollingBall) -> tuple[Law, ...]:
    return ()


def ball_entry(
    *,
    name: str,
    ball: Callable[[Numbers], RollingBall],
    further: Callable[[RollingBall], tuple[Law, ...]] = _nothing,
    general: Callable[[], System] | None = None,
) -> Entry:
    """An entry with all laws that are known of the ball.

    Parameters
    ----------
    name, general
        As of an Entry.
    ball : callable
        Numbers by symbol name ↦ the ball and its surface.
    further : callable
        Laws besides those of :func:`known_ball_laws`.
    """
    file = entry_file(name)

    def build(numbers: Numbers) -> System:
        rolling_ball = ball(numbers)
        system = rolling_ball.system(name, file.title).with_laws(
            *known_ball_laws(rolling_ball), *further(rolling_ball)
        )
        return replace(system, source=file.source, summary=file.summary)

    return replace(
        entry_with(name, build=build, general=general, ball=ball), variables=ball_variables
    )
