"""Homogeneous balls on surfaces, for tests that go through all of them."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from nonholonomic.mechanics.ball.ball import RollingBall
from nonholonomic.mechanics.ball.surface import (
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

x, y, z = ImplicitSurface.coordinates

SURFACES = {
    "plane": FlatSurface(),
    "sphere": SphericalSurface(2.0),
    "cylinder": CircularCylinder(2.0),
    "elliptic cylinder": EllipticCylinder((2.0, 3.0)),
    "cone": Cone(1.0),
    "ellipsoid": EllipsoidSurface((1.5, 2.0, 3.0)),
    "bowl": Paraboloid((3.0, 4.0)),
    "round bowl": Paraboloid((3.0, 3.0)),
    "saddle": Paraboloid((3.0, -4.0)),
    "lens": EllipsoidSurface((2.0, 2.0, 1.5)),
    "torus": Ring(3.0, 1.0),
    "quartic": ImplicitSurface(x**4 + y**4 + z**4 - 1),
    "waves": ImplicitSurface(z - sp.cos(x) * sp.cos(y) / 4),
}

#: A point of each surface.
POINTS = {
    "plane": (0.3, -0.2, 0.0),
    "sphere": (0.0, 1.2, 1.6),
    "cylinder": (1.2, 1.6, 0.7),
    "elliptic cylinder": (1.2, 2.4, 0.7),
    "cone": (1.2, 1.6, 2.0),
    "ellipsoid": (0.9, 0.0, 2.4),
    "bowl": (3.0, 2.0, 2.0),
    "round bowl": (3.0, 0.0, 1.5),
    "saddle": (3.0, 2.0, 1.0),
    "lens": (1.2, 0.0, 1.2),
    "torus": (3.6, 0.0, 0.8),
    "quartic": (0.0, 1.0, 0.0),
    "waves": (0.0, 0.0, 0.25),
}


def on(surface: SmoothSurface, **changes: object) -> RollingBall:
    """A heavy marble ball that the surface carries, but for the changes."""
    ball = RollingBall(mass=1.0, inertia=0.036, radius=0.3, surface=surface, gravity=9.81)
    return replace(ball, **changes)
