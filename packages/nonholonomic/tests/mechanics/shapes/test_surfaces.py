"""Surfaces."""

from __future__ import annotations

import re

import pytest

from flowlanes.errors import InputError
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import rolling_system
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere


@pytest.mark.parametrize(("signed", "side"), [(2.0, "outside"), (-0.5, "inside"), (1e9, "outside")])
def test_sphere_has_a_positive_radius_and_a_side(signed, side):
    sphere = Sphere.of_signed_radius(signed)
    assert sphere == Sphere(abs(signed), side)
    assert sphere.signed_radius == signed


@pytest.mark.parametrize("radius", [0.0, -0.0, float("inf"), float("-inf"), float("nan")])
def test_radius_must_be_finite_and_positive(radius):
    message = f"radius {radius} of the supporting sphere: it must be a positive finite number"
    with pytest.raises(InputError, match=f"^{re.escape(message)}$"):
        Sphere(radius)


def test_a_negative_radius_is_answered_with_what_to_write():
    with pytest.raises(InputError, match=re.escape('write Sphere(3.0, side="inside")')):
        Sphere(-3.0)
    with pytest.raises(InputError, match="side"):
        Sphere(3.0, "within")


def test_surfaces_are_values():
    assert Plane() == Plane()
    assert Sphere(2.0) == Sphere(2.0) != Sphere(2.0, "inside")
    assert len({Plane(), Plane(), Sphere(1.0), Sphere(1.0)}) == 2


@pytest.mark.parametrize("turntable", [float("inf"), float("-inf"), float("nan")])
def test_a_turning_support_has_a_finite_angular_velocity(turntable):
    message = f"turntable {turntable}: it must be a finite angular velocity"
    for surface in (Plane, lambda turntable: Sphere(1.0, turntable=turntable)):
        with pytest.raises(InputError, match=f"^{re.escape(message)}$"):
            surface(turntable=turntable)


def test_a_support_at_rest_is_another_value_than_a_turning_one():
    assert Plane() == Plane(turntable=0.0) != Plane(turntable=0.5)
    assert Sphere(1.0, turntable=-0.5).turntable == -0.5


@pytest.mark.parametrize("surface", [Plane(turntable=0.5), Sphere(3.0, turntable=0.5)])
@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_without_friction_bodies_roll_on_a_support_at_rest(surface, contact):
    message = f"turntable 0.5: a turning support needs a contact with friction; a {contact} contact"
    with pytest.raises(InputError, match=message):
        rolling_system(Body(1.0, (0.4, 0.5, 0.6), Ball(1.0)), surface, contact)
