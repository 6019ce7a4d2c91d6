"""Every shape on every surface with every contact, for tests that go through all of them."""

from __future__ import annotations

import itertools

import sympy as sp

from flowlanes.system.system import System
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

x, y, z = ImplicitShape.coordinates
gamma_1, gamma_3 = sp.Symbol("gamma_1", real=True), sp.Symbol("gamma_3", real=True)

SHAPES = {
    "ball": Ball(1.0),
    "unbalanced ball": Ball(1.0, centre=(0.1, 0.05, -0.1)),
    "hollow ball": Ball(6.0, hollow=True),
    "ellipsoid": Ellipsoid((1.0, 0.9, 0.8)),
    "rattleback": Ellipsoid((1.0, 0.9, 0.8), turn=0.3, centre=(0.0, 0.0, 0.1)),
    "disk": Disk(1.0),
    "torus": Torus(1.0, 0.2),
    "revolution": ShapeOfRevolution(sp.sqrt(1 + gamma_3**2)),
    "implicit": ImplicitShape(x**4 + y**4 + z**4 - 1, centre=(0.1, 0.0, 0.0)),
}
SURFACES = {"plane": Plane(), "sphere": Sphere(5.0)}
CONTACTS = ("marble", "rubber")
CASES = tuple(
    case
    for case in itertools.product(SHAPES, SURFACES, CONTACTS)
    if case[:2] != ("hollow ball", "plane")
)


def bare(shape: str, surface: str, contact: str) -> System:
    """A free body, with principal axes of inertia as body axes."""
    body = Body(1.0, (1.0, 1.5, 2.1), SHAPES[shape])
    return rolling_system(body, SURFACES[surface], contact)


def laden(shape: str, surface: str, contact: str) -> System:
    """A heavy gyrostat with a full inertia tensor in a potential: every term there is."""
    inertia = ((1.0, 0.1, 0.0), (0.1, 1.5, -0.05), (0.0, -0.05, 2.1))
    body = Body(1.3, inertia, SHAPES[shape], gyrostat=(0.1, 0.0, -0.2))
    field = Forces(9.81, gamma_1**2 / 2 + sp.sin(gamma_3))
    return rolling_system(
        body, SURFACES[surface], contact, field, name=f"{shape}-{surface}-{contact}"
    )
