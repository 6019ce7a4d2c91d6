"""Polygon meshes of bodies for drawings, and curves on them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from flowlanes.system.arrays import BoolArray, FloatArray, IntArray

from .view import View, unit

_POLE_OFFSET = 1e-6
"""Angle between the direction grid and its poles, where a flat face has no single point."""

_FLAT_THICKNESS = 0.04
"""Thickness of a drawn disk without thickness, relative to its radius."""

_SMALLEST_STEP = 1e-7
"""Smallest step of the direction grid; a surface that extends over less than it is flat."""


@dataclass(frozen=True, eq=False)
class Facets:
    """Polygons of a surface.

    Attributes
    ----------
    polygons : (m, 4, 3) array
        Corners, anticlockwise as seen from outside; a triangle repeats its last corner.
    normals : (m, 3) array
        Outward unit normals of the smooth surface in the middle of each polygon, for shading.
    tones : (m,) array of int
        Colour of each polygon, 0 or 1.
    """

    polygons: FloatArray
    normals: FloatArray
    tones: IntArray

    def __len__(self) -> int:
        """Count the polygons."""
        return len(self.polygons)

    def select(self, mask: BoolArray) -> Facets:
        """The polygons marked true in `mask` (m,)."""
        return Facets(self.polygons[mask], self.normals[mask], self.tones[mask])

    def faces_reader(self, view: View) -> BoolArray:
        """Whether each polygon shows its outer side in `view`, as a (m,) array."""
        return view.faces_reader(_plane_normals(self.polygons))


@dataclass(frozen=True, eq=False)
class SurfaceCurve:
    """A curve on a surface, with the outward unit normals of the surface.

    Attributes
    ----------
    points, normals : (n, 3) arrays
        Points of the curve and outward unit normals of the surface there, in the same axes.
    """

    points: FloatArray
    normals: FloatArray


@dataclass(frozen=True, eq=False)
class BodyMesh:
    """A body as a closed convex mesh in body axes, its centre of mass at the origin.

    Attributes
    ----------
    vertices : (n, 3) array
        Points of the surface.
    faces : (m, 4) array of int
        Corners of the facets as indices of vertices, anticlockwise as seen from outside; a
        triangle repeats its last corner.
    normals : (m, 3) array
        Outward unit normals of the smooth surface in the middle of each facet.
    tones : (m,) array of int
        Colour of each facet, 0 or 1: neighbouring octants of directions alternate, so that the
        rotation of a ball is visible.
    seams : tuple of SurfaceCurve
        Curves between the octants.
    hollow : bool
        Whether the body is a shell that rolls with its inner side.
    """

    vertices: FloatArray
    faces: IntArray
    normals: FloatArray
    tones: IntArray
    seams: tuple[SurfaceCurve, ...]
    hollow: bool

    @property
    def diameter(self) -> float:
        """Longest extent of the body along a body axis."""
        return float(np.max(np.ptp(self.vertices, axis=0)))

    @property
    def facets(self) -> Facets:
        """The polygons of the mesh."""
        return Facets(self.vertices[self.faces], self.normals, self.tones)

    def in_space(self, rotation: FloatArray, centre: FloatArray) -> BodyMesh:
        """The body in space.

        Parameters
        ----------
        rotation : (3, 3) array
            Matrix R with v_space = R v_body.
        centre : (3,) array
            Centre of mass in space.
        """
        return BodyMesh(
            self.vertices @ rotation.T + centre,
            self.faces,
            self.normals @ rotation.T,
            self.tones,
            tuple(
                SurfaceCurve(seam.points @ rotation.T + centre, seam.normals @ rotation.T)
                for seam in self.seams
            ),
            self.hollow,
        )


def outline_from_contact(
    contact_of_gamma: Callable[[FloatArray], FloatArray], rows: int = 48, columns: int = 96
) -> BodyMesh:
    """Mesh of a strictly convex body, or of one with flat faces normal to axis 3.

    The contact vector is sampled on a grid of directions with its poles on body axis 3. Grid lines
    are added where neighbouring points of the surface are farthest apart, so that edges and flat
    parts are resolved as well as round ones. The two poles are closed by caps: the faces of a disk,
    or single points of a ball.

    Parameters
    ----------
    contact_of_gamma : callable
        r(gamma): for unit vectors (n, 3), the points (n, 3) of the body surface whose outward
        normal is -gamma (or +gamma, for a shell that rolls with its inner side), body axes.
    rows, columns : int
        Number of steps of the grid from pole to pole, and around.

    Returns
    -------
    BodyMesh
        The mesh; a body without thickness gets a small one, to be visible edge-on.
    """
    grid = direction_grid(contact_of_gamma, rows, columns)
    return _closed_mesh(grid.points, grid.outward, grid.theta, grid.phi, grid.hollow)


@dataclass(frozen=True, eq=False)
class DirectionGrid:
    """The surface of a body over a grid of directions γ.

    Attributes
    ----------
    theta, phi : (rows,), (columns,) arrays
        Angles of γ: from body axis 3, and about it.
    points : (rows, columns, 3) array
        Points in body axes, including any added thickness.
    hollow : bool
        Whether the body is a shell that rolls with its inner side.
    thickness : float
        Thickness added on each side of a body without thickness.
    """

    theta: FloatArray
    phi: FloatArray
    points: FloatArray
    hollow: bool
    thickness: float

    @property
    def outward(self) -> FloatArray:
        """Outward unit normals (rows, columns, 3)."""
        gamma = _direction(*np.meshgrid(self.theta, self.phi, indexing="ij"))
        return gamma if self.hollow else -gamma


def direction_grid(
    contact_of_gamma: Callable[[FloatArray], FloatArray], rows: int, columns: int
) -> DirectionGrid:
    """The surface of a convex body over directions; see :func:`outline_from_contact`."""

    def contact(theta: FloatArray, phi: FloatArray) -> FloatArray:
        gamma = _direction(theta, phi)
        return np.asarray(contact_of_gamma(gamma.reshape(-1, 3)), np.float64).reshape(gamma.shape)

    around = np.linspace(0.0, 2 * np.pi, 17)
    theta = _even_steps(
        np.array([_POLE_OFFSET, np.pi / 2, np.pi - _POLE_OFFSET]),
        lambda angle: contact(np.full_like(around, angle), around),
        rows,
    )
    phi = _even_steps(
        np.linspace(0.0, 2 * np.pi, 5),
        lambda angle: contact(theta, np.full_like(theta, angle)),
        columns,
    )[:-1]
    grid_theta, grid_phi = np.meshgrid(theta, phi, indexing="ij")
    gamma = _direction(grid_theta, grid_phi)
    points = contact(grid_theta, grid_phi)
    # Points of a convex surface lie on the side of their outward normal, seen from their mean: on
    # that of −γ for a body, of γ for a shell that rolls with its inner side.
    hollow = bool(np.mean(np.sum((points - points.mean(axis=(0, 1))) * gamma, axis=-1)) > 0.0)
    outward = gamma if hollow else -gamma
    thickness = _thickness(points)
    points[..., 2] += thickness * np.sign(np.round(outward[..., 2], 9))
    return DirectionGrid(theta, phi, points, hollow, thickness)


def _direction(theta: FloatArray, phi: FloatArray) -> FloatArray:
    """Unit vectors with polar angle `theta` from axis 3 and azimuth `phi`."""
    return np.stack(
        [np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)], axis=-1
    )


def _even_steps(nodes: FloatArray, sample: Callable[[float], FloatArray], count: int) -> FloatArray:
    """About `count` steps between given nodes, of nearly equal width on the surface.

    The width of a step is the largest distance between the points of `sample` at its ends. The
    widest step is halved repeatedly; then the steps between two nodes are equalised.
    """
    angles = [float(node) for node in nodes]
    points = [sample(angle) for angle in angles]
    size = max(float(np.max(np.abs(p))) for p in points)

    def width(step: int) -> float:
        if angles[step + 1] - angles[step] < _SMALLEST_STEP:
            return 0.0
        return float(np.max(np.linalg.norm(points[step + 1] - points[step], axis=-1)))

    widths = [width(step) for step in range(len(angles) - 1)]
    while len(widths) < count and max(widths) > 1e-6 * size:
        step = int(np.argmax(widths))
        middle = (angles[step] + angles[step + 1]) / 2
        angles.insert(step + 1, middle)
        points.insert(step + 1, sample(middle))
        widths[step : step + 1] = [width(step), width(step + 1)]
    distances = np.concatenate([[0.0], np.cumsum(widths)])
    even = [nodes[:1]]
    for start, stop in pairwise(np.searchsorted(angles, nodes)):
        total = distances[stop] - distances[start]
        steps = max(1, round(count * total / distances[-1])) if total > 0.0 else 1
        targets = np.linspace(distances[start], distances[stop], steps + 1)[1:-1]
        between = np.interp(targets, distances[start : stop + 1], angles[start : stop + 1])
        even += [between, np.array([angles[stop]])]
    return np.concatenate(even)


def _thickness(points: FloatArray) -> float:
    """The distance by which the sides of a body without thickness are moved apart along axis 3."""
    across = float(np.max(np.ptp(points[..., :2], axis=(0, 1))))
    if float(np.ptp(points[..., 2])) >= _FLAT_THICKNESS * across / 2:
        return 0.0
    return _FLAT_THICKNESS / 4 * across


def _closed_mesh(
    points: FloatArray, outward: FloatArray, theta: FloatArray, phi: FloatArray, hollow: bool
) -> BodyMesh:
    """Quadrilaterals between the rows of a grid (rows, columns, 3), and two caps."""
    rows, columns = points.shape[:2]
    caps = points[[0, -1]].mean(axis=1)
    cap_normals = unit(outward[[0, -1]].mean(axis=1))
    vertices = np.concatenate([points.reshape(-1, 3), caps])
    vertex_normals = np.concatenate([outward.reshape(-1, 3), cap_normals])

    column = np.arange(columns)
    following = (column + 1) % columns
    strips = [
        np.stack([a + column, a + following, b + following, b + column], axis=-1)
        for a, b in zip(
            range(0, (rows - 1) * columns, columns),
            range(columns, rows * columns, columns),
            strict=True,
        )
    ]
    fans = [
        np.stack(
            [ring + column, ring + following, np.full(columns, cap), np.full(columns, cap)], -1
        )
        for ring, cap in ((0, rows * columns), ((rows - 1) * columns, rows * columns + 1))
    ]
    quadrant = np.floor((phi + 1e-9) / (np.pi / 2)).astype(np.int64)
    northern = ((theta[:-1] + theta[1:]) / 2 < np.pi / 2).astype(np.int64)
    strip_tones = [(quadrant + half) % 2 for half in northern]
    fan_tones = [(quadrant + half) % 2 for half in (1, 0)]

    faces = np.concatenate(fans + strips)
    tones = np.concatenate(fan_tones + strip_tones)
    # caps are flat: near a rim their normal must not be blended with that of the wall
    smooth = unit(vertex_normals[np.concatenate(strips)].mean(axis=1))
    flat = np.repeat(cap_normals, columns, axis=0)
    normals = np.concatenate([flat, smooth])

    geometric = _plane_normals(vertices[faces])
    inverted = np.sum(geometric * normals, axis=-1) < 0.0
    faces[inverted] = faces[inverted][:, ::-1]
    size = float(np.max(np.ptp(vertices, axis=0)))
    solid = np.linalg.norm(geometric, axis=-1) > 1e-9 * size**2
    return BodyMesh(
        vertices,
        faces[solid],
        normals[solid],
        tones[solid],
        _seams(points, outward, caps, cap_normals, theta, phi),
        hollow,
    )


def _seams(
    points: FloatArray,
    outward: FloatArray,
    caps: FloatArray,
    cap_normals: FloatArray,
    theta: FloatArray,
    phi: FloatArray,
) -> tuple[SurfaceCurve, ...]:
    """The equator and the four quarter meridians of the grid, continued over the caps."""
    equator = int(np.argmin(np.abs(theta - np.pi / 2)))
    closing = [*range(len(phi)), 0]
    seams = [SurfaceCurve(points[equator, closing], outward[equator, closing])]
    for quarter in range(4):
        column = int(np.argmin(np.abs(phi - quarter * np.pi / 2)))
        # at the rim of a flat cap the curve has a corner, and is visible from the side of the cap
        # too
        seams.append(SurfaceCurve(points[:, column], outward[:, column]))
        for cap, normal, row in zip(caps, cap_normals, (0, -1), strict=True):
            seams.append(
                SurfaceCurve(np.stack([cap, points[row, column]]), np.stack([normal, normal]))
            )
    return tuple(seams)


def _plane_normals(polygons: FloatArray) -> FloatArray:
    """Normals (m, 3) of polygons (m, 4, 3), of length twice the area."""
    return np.cross(polygons[:, 2] - polygons[:, 0], polygons[:, 3] - polygons[:, 1])


def sphere_cap(radius: float, pole: float, opening: float, rows: int, columns: int) -> Facets:
    """Part of a sphere about the origin, around the axis z of space.

    Parameters
    ----------
    radius : float
        Positive.
    pole : float
        1 for the part around the top, -1 around the bottom.
    opening : float
        Angle from the pole to the rim; pi gives the whole sphere.
    rows, columns : int
        Number of facets from the pole to the rim, and around.
    """
    theta, phi = np.meshgrid(
        np.linspace(0.0, opening, rows + 1), np.linspace(0.0, 2 * np.pi, columns + 1), indexing="ij"
    )
    grid = _direction(theta, phi) * np.array([1.0, pole, pole])
    corners = np.stack([grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]], axis=2)
    corners = corners.reshape(-1, 4, 3)
    return Facets(
        radius * corners, unit(corners.mean(axis=1)), np.zeros(len(corners), dtype=np.int64)
    )
