"""The homogeneous ball described by an experiment file."""

from __future__ import annotations

from dataclasses import dataclass

import mpmath
import sympy as sp

from flowlanes.printing.numerals import number
from flowlanes.system.vectors import Vector
from nonholonomic.catalogue.balls.ball_entry import ball_variables
from nonholonomic.catalogue.balls.ball_laws import known_ball_laws
from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.mechanics.ball.initial_state import ball_state
from nonholonomic.mechanics.ball.surface import ImplicitSurface, SmoothSurface
from nonholonomic.system_files.sourced import identifier

from ..models.ball_model import BallExperiment, moment
from .subject import BallSubject

R = Vector("R")


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
        return ball_state(self.ball, self.system, position, omega)


def ball_subject(experiment: BallExperiment) -> PlacedBallSubject:
    """The ball of an experiment, with all its known integrals.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    with experiment.placing_errors("surface"):
        surface = experiment.surface.surface()
    with experiment.placing_errors("field"):
        potential = _potential(experiment)
    with experiment.placing_errors("body", "shape"):
        ball = _rolling_ball(experiment, surface, potential)
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


def _potential(experiment: BallExperiment) -> sp.Expr:
    """U in the components of R."""
    table = experiment.field
    if not table.potential:
        return sp.S.Zero
    centre = dict(zip(ImplicitSurface.coordinates, R.symbols, strict=True))
    return table.expression(table.potential).xreplace(centre)


def _rolling_ball(
    experiment: BallExperiment, surface: SmoothSurface, potential: sp.Expr
) -> RollingBall:
    """The ball of an experiment.

    Raises
    ------
    InputError
        If it does not fit the surface.
    """
    body, field = experiment.body, experiment.field
    radius = body.shape.size[0] if body.shape.is_ball else 0.0
    return RollingBall(
        mass=body.mass,
        inertia=moment(body) or 0.0,
        radius=radius,
        surface=surface,
        carrier=experiment.surface.given,
        contact=experiment.contact.model,
        gravity=field.gravity,
        direction=field.direction,
        potential=potential,
        parameters=field.parameters,
    )


def _support(experiment: BallExperiment, ball: RollingBall) -> str:
    """A description of the surface that carries the ball."""
    name = experiment.surface.title
    if ball.carrier == "centre":
        return f"with its centre on {name}"
    inside = ball.surface.side == "inside"
    return f"inside {name}" if inside else f"on {name}"


def _title(experiment: BallExperiment, ball: RollingBall) -> str:
    """A name for a ball that is not in the catalogue."""
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
