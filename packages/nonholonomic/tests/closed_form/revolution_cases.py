"""Random rubber bodies of revolution and starts."""

from __future__ import annotations

import random

import numpy as np
import sympy as sp

from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shape_base import Shape
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus
from nonholonomic.starts import initial_state

KINDS = ("ball", "disk", "torus", "ellipsoid", "revolution")

u = sp.Symbol("gamma_3", real=True)
bulge = sp.Symbol("bulge", real=True)


def body(kind: str, rng: random.Random) -> RollingBody:
    """A body of the kind, with its centre of mass on the axis."""
    axial = round(rng.uniform(0.1, 0.6), 3)
    across = round(rng.uniform(axial / 2 + 0.05, 0.8), 3)
    shape = _shape(kind, rng)
    return RollingBody(
        Body(1.0, (across, across, axial), shape), contact="rubber", field=Forces(9.81)
    )


def _shape(kind: str, rng: random.Random) -> Shape:
    centre = (0.0, 0.0, round(rng.uniform(-0.4, 0.4), 3))
    first, second = (round(rng.uniform(0.6, 1.4), 3) for _ in range(2))
    if kind == "ball":
        return Ball(first, centre=centre)
    if kind == "disk":
        return Disk(first, centre=centre)
    if kind == "torus":
        return Torus(first, round(second / 4, 3), centre=centre)
    if kind == "ellipsoid":
        return Ellipsoid((first, first, second), centre=centre)
    support = 1 + bulge * u**2
    return ShapeOfRevolution(support, {bulge: round(rng.uniform(-0.2, 0.3), 3)}, centre=centre)


def start(rolling: RollingBody, rng: random.Random) -> tuple[object, ...]:
    """A lifted state on the phase space, to fifty digits."""
    gamma = np.array([rng.gauss(0, 1) for _ in range(3)])
    gamma /= np.linalg.norm(gamma)
    omega = np.array([rng.gauss(0, 3) for _ in range(3)])
    omega -= gamma * (omega @ gamma)
    return initial_state(rolling.system(), list(omega), list(gamma))
