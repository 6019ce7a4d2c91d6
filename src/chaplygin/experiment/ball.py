"""From the tables of an experiment to the homogeneous ball that they describe."""

from __future__ import annotations

import sympy as sp

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
    Side,
    SmoothSurface,
    SphericalSurface,
)
from ..parsing import parse
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
from .file.tables import BallTable, FormulaTable

__all__ = ["ball_title", "potential_of", "rolling_ball", "setting", "smooth_surface"]

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
        Parameter(sp.Symbol(name, real=True), f"number in the {where}", value)
        for name, value in table.parameters.items()
    )


def _formula(table: FormulaTable, text: str) -> sp.Expr:
    return parse(text, {name: sp.Symbol(name, real=True) for name in table.names})


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
            inside: Side = "inside" if table.radius < 0 else side
            return SphericalSurface(abs(table.radius), side=inside, axis=axis)
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
            formula = _formula(table, table.equation)
            return ImplicitSurface(formula, _numbers(table, "surface"), side=side, axis=axis)


def potential_of(experiment: BallExperiment) -> sp.Expr:
    """U in the components of R."""
    table = experiment.field
    if not table.potential:
        return sp.S.Zero
    centre = dict(zip(ImplicitSurface.coordinates, R.symbols, strict=True))
    return _formula(table, table.potential).xreplace(centre)


def rolling_ball(
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


def _where(experiment: BallExperiment, ball: RollingBall) -> str:
    """On what the ball rolls."""
    name = _NAMES[experiment.surface.kind]
    if ball.carrier == "centre":
        return f"with its centre on {name}"
    inside = ball.surface.side == "inside"
    return f"inside {name}" if inside else f"on {name}"


def ball_title(experiment: BallExperiment, ball: RollingBall) -> str:
    """A name for a ball that the catalogue has none for."""
    manner = "" if ball.contact == "marble" else ", rubber contact"
    return f"Homogeneous ball {_where(experiment, ball)}{manner}"


def setting(experiment: BallExperiment, ball: RollingBall) -> str:
    """What rolls on what, in one line."""
    manner = "without slipping"
    if ball.contact == "rubber":
        manner = "with neither slipping nor spinning"
    force = f"gravity {number(ball.gravity, 6)} m/s²" if ball.gravity else "no gravity"
    if ball.potential != 0:
        force += ", a potential U(x, y, z)"
    return f"Homogeneous ball {_where(experiment, ball)}, {manner}; {force}"
