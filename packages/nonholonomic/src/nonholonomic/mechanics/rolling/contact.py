"""The kinematics of a contact: a shape on a surface."""

from __future__ import annotations

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.system.vectors import zero

from ..shapes.kinematics import Contact, a
from ..shapes.shape_base import Shape
from ..shapes.surfaces import Surface


def contact(
    shape: Shape, surface: Surface, slip: MatrixExpr = zero, radius: sp.Expr = a
) -> Contact:
    """The contact of `shape` with `surface`.

    Parameters
    ----------
    shape : Shape
    surface : Surface
    slip : MatrixExpr
        Velocity of the particle at the contact relative to the surface, body axes; it is
        tangential, and zero without slip.
    radius : sympy.Expr
        Signed radius of the supporting sphere; that of a concentric sphere through the nearest
        point of the body if this is in flight.

    Raises
    ------
    InputError
        If a ball does not fit into the sphere, or a hollow one not around it.  For other
        shapes this depends on the point of contact, and a guard checks it.
    """
    return shape.contact(surface, surface.swing(slip, radius), radius)
