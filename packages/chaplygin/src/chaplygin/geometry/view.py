"""An orthographic view of space, and rotations.

A picture is made by projecting space orthographically on a sheet of paper (`View`), keeping the
facets that face the reader. Bodies are convex, so that these never overlap, and whole bodies and
grounds are painted from the farthest to the nearest: two of them that touch in one point are
separated by the plane of contact. All lengths are in the units of the trajectory, all angles in
radians.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from flowlanes.system.arrays import BoolArray, FloatArray
from nonholonomic.mechanics.rotations import rotation_rows


def unit(vectors: FloatArray) -> FloatArray:
    """Vectors of length one along the given ones; a zero vector stays zero."""
    lengths = np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors / np.where(lengths > 0.0, lengths, 1.0)


def rotation_matrices(attitude: FloatArray) -> FloatArray:
    """Matrices of the rotations given by quaternions.

    Parameters
    ----------
    attitude : (..., 4) array
        Quaternions (w, x, y, z), body to space; they are normalised first.

    Returns
    -------
    (..., 3, 3) array
        R with v_space = R v_body.
    """
    rows = rotation_rows(np.moveaxis(unit(attitude), -1, 0))
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


@dataclass(frozen=True)
class View:
    """An orthographic view of space from a direction.

    Attributes
    ----------
    azimuth, elevation : float
        Direction of the reader: angle in the xy plane from the x axis, and angle above that plane.
    """

    azimuth: float
    elevation: float

    @cached_property
    def toward(self) -> FloatArray:
        """Unit vector of space from the scene to the reader."""
        flat = np.cos(self.elevation)
        return np.array(
            [flat * np.cos(self.azimuth), flat * np.sin(self.azimuth), np.sin(self.elevation)]
        )

    @cached_property
    def right(self) -> FloatArray:
        """Unit vector of space that points to the right on the paper."""
        return np.array([-np.sin(self.azimuth), np.cos(self.azimuth), 0.0])

    @cached_property
    def up(self) -> FloatArray:
        """Unit vector of space that points upwards on the paper."""
        return np.cross(self.toward, self.right)

    @cached_property
    def light(self) -> FloatArray:
        """Unit vector towards the light, over the reader's left shoulder."""
        return unit(-0.55 * self.right + 0.75 * self.up + 0.65 * self.toward)

    def project(self, points: FloatArray) -> FloatArray:
        """Points of the paper (..., 2) for points of space (..., 3)."""
        return np.stack([points @ self.right, points @ self.up], axis=-1)

    def depth(self, points: FloatArray) -> FloatArray:
        """Nearness to the reader of points of space (..., 3): larger is nearer."""
        return np.asarray(points @ self.toward, dtype=np.float64)

    def faces_reader(self, normals: FloatArray) -> BoolArray:
        """Whether a surface with these outward normals (..., 3) shows its outer side."""
        return np.asarray(normals @ self.toward > 0.0, dtype=np.bool_)
