"""The rolling body that the tables of a file describe."""

from __future__ import annotations

import sympy as sp

from ..mechanics.rolling.body import Body
from ..mechanics.rolling.equations import Forces, RollingBody
from .bodies import BodyOnSurface, RollingFile


def rolling_body(file: RollingFile) -> RollingBody:
    """The rolling body of a file.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    body = body_of(file)
    with file.placing_errors("surface"):
        ground = file.surface.surface()
    return RollingBody(body, ground, file.contact.model, forces_of(file))


def body_of(file: BodyOnSurface) -> Body:
    """The body of an file.

    Raises
    ------
    InputError
        If its parts do not fit together; the message names the place in the file.
    """
    with file.placing_errors("body", "shape"):
        shape = file.body.shape.shape()
    # the shape first, since its mistakes have keys of their own, and those of the body the rest
    table = file.body
    with file.placing_errors("body"):
        return Body(table.mass, table.inertia, shape, table.gyrostat, table.cavities)


def forces_of(file: BodyOnSurface) -> Forces:
    """Gravity and potential of an file.

    Raises
    ------
    InputError
        If the potential is unusable; the message names the place in the file.
    """
    forces = file.field
    with file.placing_errors("field"):
        potential = forces.expression(forces.potential) if forces.potential else sp.S.Zero
        return Forces(forces.gravity, potential, forces.parameters)
