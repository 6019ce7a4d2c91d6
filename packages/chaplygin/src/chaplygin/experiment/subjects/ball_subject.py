"""The homogeneous ball described by an experiment file."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath

from flowlanes.printing.numerals import number
from nonholonomic.catalogue.ball_entry import ball_variables
from nonholonomic.catalogue.ball_laws import known_ball_laws
from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.starts import initial_state
from nonholonomic.system_files.ball_objects import rolling_ball
from nonholonomic.system_files.sourced import identifier

from ..models.ball_model import BallExperiment
from .subject import BallSubject


@dataclass(frozen=True, kw_only=True)
class PlacedBallSubject(BallSubject):
    """A homogeneous ball whose start gives its contact point or its centre, and ω.

    Attributes
    ----------
    setting_words : str
        The ball, its support, the contact and the forces in one line.
    """

    setting_words: str

    @property
    def setting(self) -> str:
        """The ball, its support, the contact and the forces."""
        return self.setting_words

    @property
    def summary(self) -> str:
        """Empty, since the setting describes the system."""
        return ""

    @property
    def directions(self) -> set[str]:
        """Empty: the position of the ball and ω are not unit vectors."""
        return set()

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state that follows from the position of the ball and ω."""
        place = "contact" if self.ball.carrier == "support" else "centre"
        position, omega = self.start_vector(place), self.start_vector("omega")
        return initial_state(self.ball, omega, place=position)


def ball_subject(experiment: BallExperiment) -> PlacedBallSubject:
    """The ball of an experiment, with all its known integrals.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    ball = rolling_ball(experiment)
    with experiment.placing_errors("surface"):
        title = experiment.title or _title(experiment, ball)
        system = ball.system(identifier(title), title)
    return PlacedBallSubject(
        system=system.with_laws(*known_ball_laws(ball)),
        start_values=experiment.start.model_dump(exclude_none=True),
        until=experiment.run.until,
        variables=ball_variables,
        setting_words=_description(experiment, ball),
        ball=ball,
    )


def _support(experiment: BallExperiment, ball: RollingBall) -> str:
    """A description of the surface that carries the ball."""
    name = experiment.surface.title
    if ball.carrier == "centre":
        return f"with its centre on {name}"
    inside = ball.surface.side == "inside"
    return f"inside {name}" if inside else f"on {name}"


def _title(experiment: BallExperiment, ball: RollingBall) -> str:
    """A title for a ball that is not in the catalogue."""
    manner = "" if ball.contact == "marble" else ", rubber contact"
    return f"Homogeneous ball {_support(experiment, ball)}{manner}"


def _description(experiment: BallExperiment, ball: RollingBall) -> str:
    """The ball, its support, the contact and the forces in one line."""
    manner = "without slipping"
    if ball.contact == "rubber":
        manner = "with neither slipping nor spinning"
    force = f"gravity {number(ball.gravity, 6)} m/s²" if ball.gravity else "no gravity"
    if ball.potential != 0:
        force += ", a potential U(x, y, z)"
    return f"Homogeneous ball {_support(experiment, ball)}, {manner}; {force}"
