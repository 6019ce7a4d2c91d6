"""Surfaces of balls: sides, parallel surfaces, axes, refusals."""

from __future__ import annotations

import math

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.system import Parameter
from flowlanes.system.vectors import Vector
from mechanics.balls import POINTS, SURFACES
from nonholonomic.mechanics.ball.surface import (
    CircularCylinder,
    Cone,
    EllipsoidSurface,
    ImplicitSurface,
    Paraboloid,
    Ring,
    SphericalSurface,
)

X = Vector("x").symbols
PARALLEL = ("plane", "sphere", "cylinder", "torus")


def at(surface, formula, point):
    numbers = {p.symbol: p.default for p in surface.parameters}
    return float(formula.subs(numbers).subs(dict(zip(X, point, strict=True))))


def normal(surface, point):
    f = surface.equation(X)
    slope = np.array([at(surface, f.diff(s), point) for s in X])
    return slope / np.linalg.norm(slope)


@pytest.mark.parametrize("name", SURFACES)
def test_the_point_lies_on_it(name):
    assert at(SURFACES[name], SURFACES[name].equation(X), POINTS[name]) == pytest.approx(0)


@pytest.mark.parametrize("side", ["outside", "inside"])
@pytest.mark.parametrize("name", PARALLEL)
def test_the_parallel_surface_is_at_that_distance(name, side):
    made = SURFACES[name]
    surface = type(made)(**{**vars(made), "side": side})
    point = np.array(POINTS[name])
    for distance in (0.2, 0.7):
        moved = point + distance * normal(surface, point)
        away = surface.equation(X, sp.Float(distance))
        assert at(surface, away, moved) == pytest.approx(0, abs=1e-12)


@pytest.mark.parametrize("name", [n for n in SURFACES if n not in PARALLEL])
def test_others_have_no_equation_at_a_distance(name):
    assert SURFACES[name].equation(X, sp.Symbol("b")) is None


@pytest.mark.parametrize("name", SURFACES)
def test_the_inside_is_where_the_equation_is_negative(name):
    made = SURFACES[name]
    inside = type(made)(**{**vars(made), "side": "inside"})
    assert inside.equation(X) == -made.equation(X)


def test_an_axis_turns_the_surface():
    upright, lying = CircularCylinder(2.0), CircularCylinder(2.0, axis="x")
    x, y, z = X
    assert upright.equation(X) == x**2 + y**2 - sp.Symbol("a", real=True) ** 2
    assert lying.equation(X) == y**2 + z**2 - sp.Symbol("a", real=True) ** 2
    assert Paraboloid((1.0, 2.0), axis="y").equation(X).coeff(y) == 1


def test_a_cone_is_one_half():
    (guard,) = Cone(1.0, axis="x").domain(X)
    assert guard.value == X[0]


@pytest.mark.parametrize(
    ("surface", "message"),
    [
        (SphericalSurface(-1.0), "radius of the sphere -1.0: it must be a positive finite number"),
        (CircularCylinder(math.inf), "radius of the cylinder inf: it must be a finite number"),
        (Ring(3.0, 0.0), "radius of the tube 0.0: it must be a positive finite number"),
        (EllipsoidSurface((1.0, 0.0, 1.0)), "semi-axis 2 of the ellipsoid 0.0"),
        (Paraboloid((0.0, 1.0)), "radius of curvature at the vertex, along x: it must not be zero"),
    ],
)
def test_wrong_numbers_are_refused(surface, message):
    with pytest.raises(InputError, match=message):
        _ = surface.parameters


@pytest.mark.parametrize(
    "parameters", [{"c": math.nan}, (Parameter(sp.Symbol("c"), "number", math.nan),)]
)
def test_a_parameter_of_a_formula_is_finite(parameters):
    with pytest.raises(InputError, match="parameter c = nan: it must be a finite number"):
        ImplicitSurface(sp.Symbol("x", real=True), parameters)
