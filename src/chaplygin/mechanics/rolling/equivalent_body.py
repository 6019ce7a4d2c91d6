"""The rigid body that a body with fluid is equivalent to while its fluid is in potential flow.

Zhukovsky's theorem: an ideal fluid in potential flow acts on the body that holds it as a rigid body
of the same mass and centre of mass.  For an ellipsoidal cavity its inertia tensor about the centre
is K(E − C²) of :mod:`chaplygin.mechanics.rolling.cavity`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
import sympy as sp

from ...parsing.exact_decimals import exact_number
from .body import Body, Inertia, WithInertia, as_tuple
from .shapes import Shape


@dataclass(frozen=True)
class EquivalentBody(WithInertia):
    """The solid body together with the equivalent bodies of its fluid.

    It is no rigid body that could be built: a fluid turns less than it weighs, and the three
    moments need not obey the triangle inequality.

    Attributes
    ----------
    mass : float
        Of body and fluid.
    inertia : 3 floats or 3×3 floats
        About their common centre of mass, body axes.
    shape : Shape
        Its centre relative to the common centre of mass.
    gyrostat : 3 floats
        Momentum of the rotors.
    """

    mass: float
    inertia: Inertia
    shape: Shape
    gyrostat: tuple[float, float, float]

    buildable = False


AnyBody = Body | EquivalentBody


def equivalent_body(body: AnyBody) -> AnyBody:
    """The equivalent rigid body; the body itself if it holds no fluid.

    Computed in rational numbers and rounded once, so that equal moments stay equal.
    """
    if isinstance(body, EquivalentBody) or not body.has_fluid:
        return body
    parts = [(exact_number(body.mass), sp.zeros(3, 1))]
    inertia = sp.Matrix(body.tensor.tolist()).applyfunc(exact_number)
    for cavity in body.cavities:
        centre = sp.Matrix([exact_number(x) for x in cavity.centre])
        parts.append((exact_number(cavity.mass), centre))
        inertia += cavity.equivalent_inertia
    mass = sum(share for share, _ in parts)
    common = sum((share * centre for share, centre in parts), sp.zeros(3, 1)) / mass
    for share, centre in parts:
        arm = centre - common
        inertia += share * (arm.dot(arm) * sp.eye(3) - arm * arm.T)
    offset = sp.Matrix([exact_number(x) for x in body.shape.centre]) - common
    tensor = np.array(inertia.tolist(), dtype=float)
    moments = np.diag(tensor) if inertia.is_diagonal() else tensor
    return EquivalentBody(
        float(mass),
        as_tuple(moments),
        replace(body.shape, centre=(float(offset[0]), float(offset[1]), float(offset[2]))),
        body.gyrostat,
    )
