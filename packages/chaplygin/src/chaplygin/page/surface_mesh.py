"""A surface f = 0 as a mesh.

Each grid cell crossed by the surface contains one vertex, the mean of the crossings of its edges,
projected onto the surface; around each crossed edge there is a face (the surface nets method). The
grid extends beyond the box and the border of the surface, and the mesh is clipped there, so that
its rim is a smooth curve.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

import numpy as np

from flowlanes.system.arrays import BoolArray, FloatArray, IntArray

from ..geometry.ball_surface import Box, SurfaceGround
from ..geometry.view import unit

#: Number of cells along the longest side of the box.
_CELLS = 32
#: Number of Newton steps that project vertices onto the surface.
_STEPS = 3

_CORNERS = np.array(list(product((0, 1), repeat=3)))
_EDGES = [
    (i, j)
    for i, a in enumerate(_CORNERS)
    for j, b in enumerate(_CORNERS)
    if (b - a).sum() == 1 and (b >= a).all()
]


class SurfaceMesh(NamedTuple):
    """Triangles of a surface, with normals on the ball's side."""

    positions: FloatArray
    normals: FloatArray
    indices: IntArray


def surface_mesh(ground: SurfaceGround, box: Box, cells: int = _CELLS) -> SurfaceMesh:
    """The part of a surface in a box.

    Parameters
    ----------
    ground : SurfaceGround
    box : Box
    cells : int
        Number of cells along the longest side.

    Returns
    -------
    SurfaceMesh
        Positions and normals (n, 3), indices (m, 3); anticlockwise as seen from the ball's side.
    """
    size = box.high - box.low
    counts = np.maximum(4, np.ceil(cells * size / size.max())).astype(int)
    low, high = box.low - size / counts, box.high + size / counts
    axes = [np.linspace(a, b, n + 3) for a, b, n in zip(low, high, counts, strict=True)]
    points = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)
    with np.errstate(all="ignore"):
        heights = ground.continued_height(points.reshape(-1, 3)).reshape(points.shape[:3])
    corners = np.stack([_corner_values(heights, c) for c in _CORNERS])
    places = np.stack([_corner_values(points, c) for c in _CORNERS])
    inside = corners > 0.0
    crossed = np.isfinite(corners).all(axis=0) & (inside.any(axis=0) & ~inside.all(axis=0))
    total = np.zeros((*crossed.shape, 3))
    number = np.zeros(crossed.shape)
    for i, j in _EDGES:
        cut = crossed & (inside[i] != inside[j])
        with np.errstate(all="ignore"):
            share = np.where(cut, corners[i] / (corners[i] - corners[j]), 0.0)
        at = places[i] + share[..., None] * (places[j] - places[i])
        total += np.where(cut[..., None], at, 0.0)
        number += cut
    vertices = total[crossed] / number[crossed][:, None]
    with np.errstate(all="ignore"):
        for _ in range(_STEPS):
            fall = np.nan_to_num(ground.continued_height(vertices))[:, None] * ground.normals(
                vertices
            )
            vertices = np.clip(vertices - fall, low, high)
        normals = ground.normals(vertices)
    names = np.full(crossed.shape, -1)
    names[crossed] = np.arange(len(vertices))
    mesh = SurfaceMesh(vertices, normals, _triangles(heights > 0.0, names))
    for axis in range(3):
        mesh = _cut(mesh, mesh.positions[:, axis] - box.high[axis])
        mesh = _cut(mesh, box.low[axis] - mesh.positions[:, axis])
    return _cut(mesh, -ground.extent(mesh.positions))


def _corner_values(array: FloatArray, corner: IntArray) -> FloatArray:
    """The values of a grid at one corner of every cell."""
    part = tuple(slice(c, n - 1 + c) for c, n in zip(corner, array.shape[:3], strict=True))
    return array[part]


def _triangles(above: BoolArray, names: IntArray) -> IntArray:
    """Two triangles around every crossed edge, between the vertices of the four adjacent cells."""
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        turned = np.moveaxis(above, (axis, u, v), (0, 1, 2))
        cells = np.moveaxis(names, (axis, u, v), (0, 1, 2))
        rising = turned[1:, 1:-1, 1:-1] & ~turned[:-1, 1:-1, 1:-1]
        falling = ~turned[1:, 1:-1, 1:-1] & turned[:-1, 1:-1, 1:-1]
        ring = [cells[:, :-1, :-1], cells[:, 1:, :-1], cells[:, 1:, 1:], cells[:, :-1, 1:]]
        for cut, order in ((rising, (0, 1, 2, 3)), (falling, (3, 2, 1, 0))):
            quads = np.stack([ring[k][cut] for k in order], axis=-1)
            quads = quads[(quads >= 0).all(axis=1)]
            faces += [quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]
    return np.concatenate(faces)


def _cut(mesh: SurfaceMesh, beyond: FloatArray) -> SurfaceMesh:
    """The part of a mesh where a function, given at its vertices, is not positive."""
    out = beyond > 0.0
    if not out.any():
        return mesh
    faces = mesh.indices
    count = out[faces].sum(axis=1)
    # the vertex that is alone on its side comes first
    alone = np.where(count == 1, out[faces].argmax(axis=1), out[faces].argmin(axis=1))
    faces = np.take_along_axis(faces, (alone[:, None] + np.arange(3)) % 3, axis=1)
    corner, left = faces[count == 2], faces[count == 1]
    edges = np.concatenate([corner[:, [0, 1]], corner[:, [0, 2]], left[:, [0, 1]], left[:, [0, 2]]])
    ends, names = np.unique(np.sort(edges, axis=1), axis=0, return_inverse=True)
    first, second = ends.T
    share = (beyond[first] / (beyond[first] - beyond[second]))[:, None]
    positions, normals = (
        np.concatenate([array, array[first] + share * (array[second] - array[first])])
        for array in (mesh.positions, mesh.normals)
    )
    names = names.ravel() + len(beyond)
    a, b, c, d = np.split(names, np.cumsum([len(corner), len(corner), len(left)]))
    indices = np.concatenate(
        [
            faces[count == 0],
            np.column_stack([corner[:, 0], a, b]),
            np.column_stack([c, left[:, 1], left[:, 2]]),
            np.column_stack([c, left[:, 2], d]),
        ]
    )
    used, names = np.unique(indices, return_inverse=True)
    return SurfaceMesh(positions[used], unit(normals[used]), names.reshape(-1, 3))
