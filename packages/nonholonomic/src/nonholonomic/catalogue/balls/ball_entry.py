"""Entries of homogeneous balls on surfaces in the catalogue."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from flowlanes.system.laws import Law
from flowlanes.system.system import System

from ...mechanics.ball.ball import RollingBall
from ..catalogue_entry import Entry, Numbers, Start, Values
from .ball_laws import known_ball_laws

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
    title: str,
    summary: str,
    defaults: Numbers,
    ball: Callable[[Numbers], RollingBall],
    start: Values,
    until: float,
    further: Callable[[RollingBall], tuple[Law, ...]] = _nothing,
    general: Callable[[], System] | None = None,
    source: str = "§2.2, §2.3",
) -> Entry:
    """An entry with all laws that are known of the ball.

    Parameters
    ----------
    name, title, summary, defaults, general, source
        As of an Entry.
    ball : callable
        Numbers by symbol name ↦ the ball and its surface.
    start : mapping
        R or x, and ω, space axes.
    until : float
    further : callable
        Laws besides those of :func:`known_ball_laws`.
    """

    def build(numbers: Numbers) -> System:
        rolling_ball = ball(numbers)
        system = rolling_ball.system(name, title).with_laws(
            *known_ball_laws(rolling_ball), *further(rolling_ball)
        )
        return replace(system, source=source, summary=summary)

    return Entry(
        name=name,
        title=title,
        summary=summary,
        source=source,
        defaults=defaults,
        build=build,
        start=Start(state=start, until=until),
        general=general,
        variables=ball_variables,
        ball=ball,
    )
