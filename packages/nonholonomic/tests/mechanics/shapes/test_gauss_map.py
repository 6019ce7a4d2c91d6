"""Contact points at many normals at once, against the points of the reference."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

import reference
from flowlanes.errors import InputError
from flowlanes.system.vectors import Vector
from mechanics.bodies import CENTRE, SHAPES
from mechanics.compare import XYZ, draw, shape_of
from nonholonomic.mechanics.shapes.gauss_map import contact_points_of_normals
from nonholonomic.mechanics.shapes.implicit import ImplicitShape
from nonholonomic.mechanics.shapes.revolution import ShapeOfRevolution
from nonholonomic.mechanics.shapes.shape_base import Shape
from nonholonomic.mechanics.shapes.shapes import Ball, Disk, Ellipsoid, Torus

X, Y, Z = XYZ
NORMALS = np.random.default_rng(2).normal(size=(40, 3))
NORMALS /= np.linalg.norm(NORMALS, axis=1)[:, None]


@pytest.mark.slow
@pytest.mark.parametrize("name", reference.SHAPES)
def test_points_are_those_of_the_reference(name):
    case = draw(name, "outside", "marble", "principal", seed=1)
    shape = case.body.shape
    expected = [np.asarray(shape.centre) + shape.touching(gamma) for gamma in NORMALS]
    found = shape_of(case.shape_table).contact_points()(NORMALS)
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-13)


def test_ball_without_displacement():
    np.testing.assert_allclose(
        SHAPES["ball centred"].contact_points()(NORMALS), -0.9 * NORMALS, rtol=0, atol=1e-15
    )


def test_parameters_of_a_surface_have_their_values():
    flattening = sp.Symbol("flattening", real=True)
    shape = ImplicitShape(X**2 + Y**2 + flattening * Z**2 - 1, {flattening: 4.0}, centre=CENTRE)
    (top,) = shape.contact_points()(np.array([[0.0, 0.0, -1.0]]))
    np.testing.assert_allclose(top, np.add(CENTRE, (0.0, 0.0, 0.5)), rtol=0, atol=1e-14)


def test_points_near_a_flat_spot():
    """On x^4 + y^4 + z^4 = 1 the gradient is along the cubes of the coordinates."""
    gamma = np.array([[1e-3, -2e-3, 1.0], [0.3, 0.5, -0.8]])
    gamma /= np.linalg.norm(gamma, axis=1)[:, None]
    points = contact_points_of_normals(X**4 + Y**4 + Z**4 - 1, XYZ, gamma)
    cubes = points**3
    np.testing.assert_allclose(
        cubes / np.linalg.norm(cubes, axis=1)[:, None], -gamma, rtol=0, atol=1e-12
    )
    np.testing.assert_allclose(np.sum(points**4, axis=1), 1.0, rtol=1e-14)


def test_open_surface_is_refused():
    with pytest.raises(InputError, match="surface f = 0: it is not closed, f stays negative"):
        contact_points_of_normals(X**2 + Y**2 - 1, XYZ, np.array([[0.0, 0.0, 1.0]]))


CUSHION = XYZ[0] ** 4 + XYZ[1] ** 4 + XYZ[2] ** 4 - 1


@pytest.mark.parametrize(
    ("shape", "outside"),
    [
        (Ball(1.0), False),
        (Ball(1.0, centre=(0.6, 0.0, 0.79)), False),
        (Ball(1.0, centre=(0.6, 0.0, 0.81)), True),
        (Ellipsoid((2.0, 1.0, 0.5), centre=(1.9, 0.0, 0.0)), False),
        (Ellipsoid((2.0, 1.0, 0.5), centre=(0.0, 0.0, 0.6)), True),
        (Torus(1.0, 0.2, centre=(0.0, 0.0, 0.19)), False),
        (Torus(1.0, 0.2, centre=(0.0, 0.0, 0.25)), False),
        (Torus(1.0, 0.2, centre=(1.3, 0.0, 0.0)), True),
        (
            ShapeOfRevolution(sp.S(1) + Vector("gamma").symbols[2] / 10, centre=(0.0, 0.0, 0.5)),
            False,
        ),
        (ImplicitShape(CUSHION, centre=(0.8, 0.8, 0.5)), False),
        (ImplicitShape(CUSHION, centre=(0.9, 0.9, 0.9)), True),
        (Disk(1.0, centre=(0.5, 0.0, 0.0)), False),
        (Disk(1.0, centre=(1.5, 0.0, 0.0)), True),
    ],
)
def test_whether_the_centre_of_mass_is_outside(shape: Shape, outside: bool) -> None:
    assert shape.centre_outside == outside
