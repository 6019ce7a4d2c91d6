"""From the tables of an experiment to the homogeneous ball that they describe."""

from __future__ import annotations

import sympy as sp

from ..catalogue.balls.ball_entry import ball_variables
from ..catalogue.balls.ball_laws import known_ball_laws
from ..core.system import Parameter
from ..core.vectors import Vector
from ..mechanics.ball.ball import RollingBall
from ..mechanics.ball.surface import (
    CircularCylinder,
    Cone,
    EllipsoidSurface,
    EllipticCylinder,
    FlatSurface,
    ImplicitSurface,
    Paraboloid,
    Ring,
    SmoothSurface,
    SphericalSurface,
)
from ..printing.numerals import number
from .file.ball_model import BallExperiment, moment
from .file.ball_tables import (
    ConeTable,
    CylinderTable,
    EllipsoidSurfaceTable,
    FlatTable,
    ImplicitSurfaceTable,
    ParaboloidTable,
    RingTable,
    RoundTable,
    SmoothTable,
)
from .file.shape_tables import BallTable
from .file.table import FormulaTable
from .mechanism import identifier
from .subject import PlacedBallSubject

__all__ = ["ball_subject", "smooth_surface"]

R = Vector("R")

#: A surface in words, by the kind of its table.
_NAMES = {
    "plane": "a plane",
    "sphere": "a sphere",
    "cylinder": "a cylinder",
    "cone": "a cone",
    "ellipsoid": "an ellipsoid",
    "paraboloid": "a paraboloid",
    "torus": "a torus",
    "implicit": "a surface given by an equation",
}


def _numbers(table: FormulaTable, where: str) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(symbol, f"number in the {where}", value) for symbol, value in table.values
    )


def ball_subject(experiment: BallExperiment) -> PlacedBallSubject:
    """The ball of an experiment, with every integral that the catalogue knows of it.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    with experiment.placing_errors("surface"):
        surface = smooth_surface(experiment.surface)
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
        setting=_setting(experiment, ball),
        ball=ball,
    )


def smooth_surface(table: SmoothTable) -> SmoothSurface:
    """The surface that a table describes.

    Raises
    ------
    InputError
        If a number is not admissible.
    """
    side, axis = table.side, table.axis
    match table:
        case FlatTable():
            return FlatSurface(side=side, axis=axis)
        case RoundTable():
            return SphericalSurface(table.radius, side=side, axis=axis)
        case CylinderTable(axes=None):
            return CircularCylinder(table.radius or 0.0, side=side, axis=axis)
        case CylinderTable():
            return EllipticCylinder(table.axes or (0.0, 0.0), side=side, axis=axis)
        case ConeTable():
            return Cone(table.slope, side=side, axis=axis)
        case EllipsoidSurfaceTable():
            return EllipsoidSurface(table.axes, side=side, axis=axis)
        case ParaboloidTable():
            return Paraboloid(table.radii, side=side, axis=axis)
        case RingTable():
            return Ring(table.radius, table.tube, side=side, axis=axis)
        case ImplicitSurfaceTable():
            formula = table.expression(table.equation)
            return ImplicitSurface(formula, _numbers(table, "surface"), side=side, axis=axis)


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
    radius = body.shape.radius if isinstance(body.shape, BallTable) else 0.0
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
        numbers=_numbers(field, "potential"),
    )


def _support(experiment: BallExperiment, ball: RollingBall) -> str:
    """The surface that carries the ball, in words."""
    name = _NAMES[experiment.surface.kind]
    if ball.carrier == "centre":
        return f"with its centre on {name}"
    inside = ball.surface.side == "inside"
    return f"inside {name}" if inside else f"on {name}"


def _title(experiment: BallExperiment, ball: RollingBall) -> str:
    """A name for a ball that the catalogue has none for."""
    manner = "" if ball.contact == "marble" else ", rubber contact"
    return f"Homogeneous ball {_support(experiment, ball)}{manner}"


def _setting(experiment: BallExperiment, ball: RollingBall) -> str:
    """The ball, its support, the contact and the forces in one line."""
    manner = "without slipping"
    if ball.contact == "rubber":
        manner = "with neither slipping nor spinning"
    force = f"gravity {number(ball.gravity, 6)} m/s²" if ball.gravity else "no gravity"
    if ball.potential != 0:
        force += ", a potential U(x, y, z)"
    return f"Homogeneous ball {_support(experiment, ball)}, {manner}; {force}"
