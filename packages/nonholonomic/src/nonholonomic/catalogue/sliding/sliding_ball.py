"""A homogeneous ball that slides on a plane (§11.2; Coriolis 1835), with its laws."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.system import System

from ...contact.invariants import sliding_ball as ball
from ..catalogue_entry import Numbers, entry_with
from ..positive_numbers import positive

TITLE = "Homogeneous ball that slides"
SUMMARY = (
    "A homogeneous ball that slides on a plane with dry friction: its slip keeps the direction and "
    "its centre describes a parabola."
)


def build(p: Numbers) -> System:
    """The ball with the force −μmg u/|u|."""
    parameters = (
        *(
            positive(item.symbol, item.meaning, p[str(item.symbol)], item.unit)
            for item in ball.ball_parameters()
        ),
        positive(ball.mu, "coefficient of friction", p["mu"], "1"),
    )
    system = ball.dry_ball(parameters)
    laws = (*ball.momenta(), *ball.slip_direction(), *ball.dry_laws())
    return replace(system, title=TITLE, summary=SUMMARY, laws=laws)


def under_any_friction() -> System:
    """The ball under any force against the slip and any couple about the normal."""
    system = ball.sliding_ball(
        ball.against_slip(), ball.ANY_COUPLE, name="sliding-ball-any-friction"
    )
    return replace(
        system,
        title=TITLE,
        summary="A homogeneous ball under any force against its slip and any couple against its "
        "spin.",
        laws=(*ball.momenta()[:2], *ball.slip_direction()),
    )


ENTRIES = (
    entry_with(
        name="sliding-ball",
        build=build,
        general=under_any_friction,
    ),
)
