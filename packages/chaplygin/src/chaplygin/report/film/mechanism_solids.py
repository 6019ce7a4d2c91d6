"""The parts of a planar mechanism as solids: rods, wheels, axles, blades, joints."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from flowlanes.system.arrays import FloatArray

from ...experiment.subjects.plan import PlanMotion
from ...geometry.mesh import Facets, outline_from_contact
from ..scenes.planar_mechanism import OF_MECHANISM, OF_PICTURE, Pose
from .gltf import Solid

_JOINT, _ROD, _WHEEL = 0, 1, 2
_SIDES = 32


def mechanism_solids(motion: PlanMotion) -> tuple[Solid, ...]:
    """The solids of a drawing, standing on the plane z = 0.

    Wheels are as long as in plane drawings: a fraction of the mechanism, or of its path.
    """
    last = Pose(motion, int(np.flatnonzero(np.isfinite(motion.path).all(axis=1))[-1]))
    extent = float(np.max(np.nanmax(motion.path, axis=0) - np.nanmin(motion.path, axis=0)))
    length = max(OF_MECHANISM * last.size, OF_PICTURE * extent) or 1.0
    return tuple(_solids(motion, length))


def _solids(motion: PlanMotion, length: float) -> Iterator[Solid]:
    radius = length / 2
    rod = _box(1.0, 0.14 * length, 0.1 * length, radius, _ROD)
    for number, ends in enumerate(np.moveaxis(motion.links, 1, 0), 1):
        along = ends[:, 2:] - ends[:, :2]
        middle = np.column_stack([(ends[:, :2] + ends[:, 2:]) / 2, np.zeros(len(ends))])
        size = np.hypot(*along.T)
        scale = np.column_stack([size, np.ones((len(size), 2))])
        yield Solid(
            f"rod {number}", rod, middle, _turn(np.arctan2(along[:, 1], along[:, 0])), scale
        )
    bar = _cylinder(0.06 * length, 1.1 * length, 0.0, 0.75 * radius, _ROD)
    small = [
        _cylinder(0.75 * radius, 0.24 * length, side * 0.55 * length, 0.75 * radius, _WHEEL)
        for side in (1, -1)
    ]
    shapes = {
        "wheel": (motion.wheels, _cylinder(radius, 0.3 * length, 0.0, radius, _WHEEL)),
        "axle": (motion.axles, _together(bar, *small)),
        "blade": (
            motion.blades,
            _box(1.3 * length, 0.06 * length, 0.45 * length, 0.225 * length, _WHEEL),
        ),
    }
    for name, (places, facets) in shapes.items():
        for number, place in enumerate(np.moveaxis(places, 1, 0), 1):
            centre = np.column_stack([place[:, :2], np.zeros(len(place))])
            yield Solid(f"{name} {number}", facets, centre, _turn(place[:, 2]))
    joint = outline_from_contact(lambda gamma: -0.16 * length * gamma, 12, 24).facets
    joint = Facets(
        joint.polygons + np.array([0.0, 0.0, radius]), joint.normals, 0 * joint.tones + _JOINT
    )
    for number, place in enumerate(np.moveaxis(motion.points, 1, 0), 1):
        centre = np.column_stack([place, np.zeros(len(place))])
        yield Solid(f"point {number}", joint, centre, _turn(np.zeros(len(place))))


def _turn(heading: FloatArray) -> FloatArray:
    """Quaternions of rotations about z."""
    zero = np.zeros_like(heading)
    return np.column_stack([np.cos(heading / 2), zero, zero, np.sin(heading / 2)])


def _box(length: float, width: float, height: float, middle: float, tone: int) -> Facets:
    """A box along x, with its centre at a height."""
    unit = np.array([[-1.0, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1]])
    faces = [np.roll(side * unit[::side], turn, axis=1) for turn in range(3) for side in (1, -1)]
    polygons = np.array(faces) * [length / 2, width / 2, height / 2]
    polygons += np.array([0.0, 0.0, middle])
    normals = np.array(
        [side * np.roll([0.0, 0.0, 1.0], turn) for turn in range(3) for side in (1, -1)]
    )
    return Facets(polygons, normals, np.full(len(polygons), tone))


def _cylinder(radius: float, width: float, aside: float, height: float, tone: int) -> Facets:
    """A cylinder about the axis y, with its centre to the left of x and at a height."""
    angles = 2 * np.pi * np.arange(_SIDES + 1) / _SIDES
    rim = radius * np.column_stack([np.sin(angles), 0 * angles, np.cos(angles)])
    side = np.array([0.0, width / 2, 0.0])
    left, right = rim + side, rim - side
    mantle = np.stack([right[:-1], right[1:], left[1:], left[:-1]], axis=1)
    half = (angles[:-1] + angles[1:]) / 2
    outwards = np.column_stack([np.sin(half), 0 * half, np.cos(half)])
    hub = np.zeros((_SIDES, 3))
    caps = [
        np.stack([hub + middle, first, second, second], axis=1)
        for middle, first, second in ((side, left[:-1], left[1:]), (-side, right[1:], right[:-1]))
    ]
    flat = [np.tile([0.0, sign, 0.0], (_SIDES, 1)) for sign in (1.0, -1.0)]
    polygons = np.concatenate([mantle, *caps]) + np.array([0.0, aside, height])
    return Facets(polygons, np.concatenate([outwards, *flat]), np.full(3 * _SIDES, tone))


def _together(*parts: Facets) -> Facets:
    columns = zip(*((p.polygons, p.normals, p.tones) for p in parts), strict=True)
    return Facets(*(np.concatenate(column) for column in columns))
