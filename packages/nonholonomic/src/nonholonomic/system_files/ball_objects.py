"""The homogeneous ball that the tables of a file describe."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.vectors import Vector

from ..mechanics.ball.ball import RollingBall
from ..mechanics.ball.surface import ImplicitSurface
from .bodies import BallFile, moment

R = Vector("R")


def rolling_ball(file: BallFile) -> RollingBall:
    """The ball of a file.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    body, field = file.body, file.field
    with file.placing_errors("surface"):
        surface = file.surface.surface()
    with file.placing_errors("field"):
        potential = _potential(file)
    radius = body.shape.size[0] if body.shape.is_ball else 0.0
    with file.placing_errors("body", "shape"):
        return RollingBall(
            mass=body.mass,
            inertia=moment(body) or 0.0,
            radius=radius,
            surface=surface,
            carrier=file.surface.given,
            contact=file.contact.model,
            gravity=field.gravity,
            direction=field.direction,
            potential=potential,
            parameters=field.parameters,
        )


def _potential(file: BallFile) -> sp.Expr:
    """U in the components of R."""
    table = file.field
    if not table.potential:
        return sp.S.Zero
    centre = dict(zip(ImplicitSurface.coordinates, R.symbols, strict=True))
    return table.expression(table.potential).xreplace(centre)
