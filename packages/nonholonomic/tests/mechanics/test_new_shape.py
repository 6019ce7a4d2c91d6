"""A shape that no other file knows: what rolls needs nothing but its Gauss map."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import pytest

import flowlanes
import nonholonomic
from nonholonomic.mechanics.shapes.gauss_map import contact_points
from nonholonomic.mechanics.shapes.shape_base import CentredShape, GaussMap

AXES = (0.1, 0.12, 0.15)


@dataclass(frozen=True)
class Pebble(CentredShape):
    """An ellipsoid by another name."""

    size: float

    def gauss(self) -> GaussMap:
        return nonholonomic.Ellipsoid(tuple(self.size * axis for axis in AXES)).gauss()  # type: ignore[arg-type]


def planted() -> nonholonomic.Body:
    body = nonholonomic.Body(1.0, (0.002, 0.003, 0.004), nonholonomic.Ellipsoid(AXES))
    # as if it were a member of Shape
    object.__setattr__(body, "shape", Pebble(1.0))
    return body


def test_what_is_no_member_is_refused() -> None:
    with pytest.raises(
        flowlanes.InputError, match=r"shape must be a Ball, an Ellipsoid, .* not a Pebble"
    ):
        nonholonomic.Body(1.0, (0.002, 0.003, 0.004), Pebble(1.0))  # type: ignore[arg-type]


@pytest.mark.parametrize("contact", ["marble", "rubber"])
def test_a_new_shape_rolls_without_a_change_elsewhere(contact: str) -> None:
    known = nonholonomic.Body(1.0, (0.002, 0.003, 0.004), nonholonomic.Ellipsoid(AXES))
    fields = {"field": nonholonomic.Forces(gravity=9.81)}
    new, old = (
        nonholonomic.roll(body, nonholonomic.Plane(), contact, **fields)
        for body in (planted(), known)
    )
    assert new.field == old.field and new.defaults == old.defaults
    names = {law.name for law in new.laws}
    assert "energy" in names and names <= {law.name for law in old.laws}
    gamma = np.array([[0.6, 0.0, 0.8], [0.0, 0.0, 1.0]])
    points = contact_points(planted().shape)(gamma)
    assert np.allclose(points[1], (0.0, 0.0, -AXES[2]), rtol=0, atol=1e-15)
    assert np.array_equal(points, contact_points(known.shape)(gamma))
