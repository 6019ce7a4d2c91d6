"""Surfaces."""

from __future__ import annotations

import re

import pytest

from chaplygin.errors import InputError
from chaplygin.mechanics.rolling.surfaces import Plane, Sphere


@pytest.mark.parametrize("radius", [2.0, -0.5, 1e9])
def test_sphere_has_a_signed_radius(radius):
    assert Sphere(radius).radius == radius


@pytest.mark.parametrize("radius", [0.0, -0.0, float("inf"), float("-inf"), float("nan")])
def test_radius_must_be_finite_and_not_zero(radius):
    message = (
        f"radius {radius} of the supporting sphere: it must be a finite number, "
        "positive for rolling outside, negative for rolling inside"
    )
    with pytest.raises(InputError, match=re.escape(message)):
        Sphere(radius)


def test_surfaces_are_values():
    assert Plane() == Plane()
    assert Sphere(2.0) == Sphere(2.0) != Sphere(-2.0)
    assert len({Plane(), Plane(), Sphere(1.0), Sphere(1.0)}) == 2
