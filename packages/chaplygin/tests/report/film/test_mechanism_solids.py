"""Solids of mechanisms: closed surfaces seen from outside, in the places of the plan."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from chaplygin.experiment.subjects.plan import PlanMotion
from chaplygin.report.film.gltf import Solid, gltf
from chaplygin.report.film.mechanism_solids import mechanism_solids
from report.film.test_gltf import read

TIMES = np.linspace(0.0, 2.0, 5)
PATH = np.column_stack([3 * TIMES, np.sin(TIMES)])
HEADING = np.cos(TIMES)
END = PATH + np.column_stack([np.cos(HEADING), np.sin(HEADING)])
POSE = np.column_stack([END, HEADING])[:, None]
PLAN = PlanMotion(
    path=PATH,
    links=np.column_stack([PATH, END])[:, None],
    wheels=POSE,
    axles=POSE,
    blades=POSE,
    points=PATH[:, None],
)


def solids() -> dict[str, Solid]:
    return {solid.name: solid for solid in mechanism_solids(PLAN)}


def volume(solid: Solid) -> float:
    """By the divergence theorem, from the triangles."""
    a, b, c, d = np.moveaxis(solid.facets.polygons, 1, 0)
    return float(sum(np.sum(np.cross(p, q) * r) for p, q, r in ((a, b, c), (a, c, d))) / 6)


def test_there_is_a_solid_for_every_part() -> None:
    assert list(solids()) == ["rod 1", "wheel 1", "axle 1", "blade 1", "point 1"]


@pytest.mark.parametrize("name", ["rod 1", "wheel 1", "axle 1", "blade 1", "point 1"])
def test_surfaces_are_closed_and_seen_from_outside(name: str) -> None:
    solid = solids()[name]
    a, b, c, d = np.moveaxis(solid.facets.polygons, 1, 0)
    area = (np.cross(b - a, c - a) + np.cross(c - a, d - a)) / 2
    assert np.allclose(area.sum(axis=0), 0.0, atol=1e-12)
    assert np.all(np.sum(area * solid.facets.normals, axis=1) > 0.0)
    assert volume(solid) > 0.0


def test_a_wheel_is_a_cylinder_that_stands_on_the_plane() -> None:
    wheel = solids()["wheel 1"]
    low, high = (getattr(wheel.facets.polygons, side)(axis=(0, 1)) for side in ("min", "max"))
    radius = high[0]
    assert low[2] == pytest.approx(0.0, abs=1e-12)
    width = high[1] - low[1]
    assert volume(wheel) == pytest.approx(np.pi * radius**2 * width, rel=0.01)


def test_a_rod_reaches_from_place_to_place() -> None:
    document, arrays = read(gltf(TIMES, mechanism_solids(PLAN), "a trailer"))
    moves = {}
    for channel in document["animations"][0]["channels"]:  # type: ignore[index]
        if channel["target"]["node"] == 1:
            sampler = document["animations"][0]["samplers"][channel["sampler"]]  # type: ignore[index]
            moves[channel["target"]["path"]] = arrays[sampler["output"]]
    turned = Rotation.from_quat(moves["rotation"]).apply([0.5, 0.0, 0.0]) * moves["scale"][:, :1]
    for sign, end in ((-1, PATH), (1, END)):
        assert np.allclose((moves["translation"] + sign * turned)[:, :2], end, atol=1e-5)
