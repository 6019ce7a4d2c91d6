"""Bodies of every shape for the property tests, and random positions for them."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import sympy as sp

from mechanics.compare import GAMMA, XYZ
from mechanics.portrait import Portrait
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.contact import contact as contact_of
from nonholonomic.mechanics.rolling.equations import Forces, rolling_system
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere

FULL = ((1.2, 0.1, -0.2), (0.1, 1.5, 0.3), (-0.2, 0.3, 2.1))
PRINCIPAL = (1.2, 1.5, 2.1)
ROTORS = (0.3, -0.4, 0.5)
CENTRE = (0.1, -0.2, 0.15)
FIELD = Forces(1.7, GAMMA[0] * GAMMA[1] / 2 + GAMMA[2] ** 2 / 4 - GAMMA[0] / 3)

X, Y, Z = XYZ
QUARTIC = X**2 + sp.Rational(4, 5) * Y**2 + Z**2 + X**4 / 5 + Z**4 / 10 + X * Y * Z / 10 - 1

SHAPES = {
    "ball centred": Ball(0.9),
    "ball": Ball(0.9, centre=CENTRE),
    "hollow ball": Ball(3.4, hollow=True, centre=CENTRE),
    "ellipsoid": Ellipsoid((1.0, 1.2, 0.9), centre=CENTRE),
    "turned ellipsoid": Ellipsoid((1.0, 1.2, 0.9), turn=0.4, centre=CENTRE),
    "disk": Disk(0.8, centre=CENTRE),
    "torus": Torus(0.8, 0.2, centre=CENTRE),
    "revolution": ShapeOfRevolution(1 + GAMMA[2] ** 2 / 10 - GAMMA[2] ** 3 / 30, centre=CENTRE),
    "implicit": ImplicitShape(QUARTIC, centre=CENTRE),
}
SURFACES = {"plane": Plane(), "outside": Sphere(2.0), "inside": Sphere(6.0, side="inside")}

COMBINATIONS = [
    (shape, surface)
    for shape in SHAPES
    for surface in SURFACES
    if shape != "hollow ball" or surface == "outside"
]


@cache
def portrait(shape: str, surface: str, contact: str) -> Portrait:
    """A loaded body of a shape on a surface, with its kinematics told by name."""
    touch = contact_of(SHAPES[shape], SURFACES[surface])
    body = Body(1.3, FULL, SHAPES[shape], ROTORS)
    system = rolling_system(body, SURFACES[surface], contact, FIELD)
    further = {
        "touch r": touch.r,
        "touch rdot": touch.rdot,
        "touch gammadot": touch.gammadot,
        "square": touch.square,
        "height": touch.height,
    }
    return Portrait(system, further)


def state_of(one: Portrait, omega: np.ndarray, gamma: np.ndarray, zeta: np.ndarray) -> np.ndarray:
    """A state of the phase space.

    For an implicit body `gamma` is a direction from its centre to the contact point; a spin that
    the contact forbids is taken out of `omega`.
    """
    given: dict[str, Any] = {"omega": omega, "gamma": gamma, "zeta": zeta}
    system = one.system
    if any(str(name) == "r" for name in system.state):
        given["r"] = np.array(CENTRE) + on_quartic(gamma)
        gamma = one.at(one.state(**given))["gamma"]
    if any(str(name) == "omega" for name in system.state):
        given["omega"] = omega - (omega @ gamma) * gamma
    return one.state(**given)


_LEVEL = sp.lambdify(XYZ, QUARTIC)


def on_quartic(direction: np.ndarray) -> np.ndarray:
    """Where a ray from the centre leaves the body ``QUARTIC < 0``."""
    near, far = 0.0, 2.0
    for _ in range(60):
        middle = (near + far) / 2
        near, far = (near, middle) if _LEVEL(*(middle * direction)) > 0 else (middle, far)
    return near * direction
