"""The scene of a page: the body, its support, links, vectors."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TypeAlias

import numpy as np
import xarray as xr

from flowlanes.formulas.array_evaluation import values
from flowlanes.system.arrays import FloatArray
from nonholonomic.mechanics.shapes.surfaces import Surface

from ..experiment.study import Study
from ..geometry.ball_surface import SurfaceGround, frame_of, ground_of_ball, ground_of_surface
from ..geometry.mesh import DirectionGrid, direction_grid
from .columns import Column
from .encoding import floats, integers
from .surface_mesh import surface_mesh

#: The types of JSON.
Json: TypeAlias = "bool | int | float | str | Sequence[Json] | dict[str, Json] | None"

#: Number of steps of the grid of directions from pole to pole and around.
ROWS, COLUMNS = 32, 64

#: Vectors that are drawn, by column, with their starting points.
_VECTORS = {
    "omega": "centre",
    "M": "contact",
    "contact_force": "contact",
}


def scene_model(study: Study, columns: Sequence[Column], dataset: xr.Dataset | None) -> Json:
    """The scene of a study.

    Parameters
    ----------
    study : Study
    columns : sequence of Column
        The recorded quantities.
    dataset : xarray.Dataset or None
        The motion, which determines the visible part of an unbounded surface.
    """
    subject, size = study.subject, 1.0
    grid = None if subject.outline is None else direction_grid(subject.outline, ROWS, COLUMNS)
    support = None
    if subject.ball is not None:
        support = _mesh(ground_of_ball(subject.ball), subject.ball.radius, dataset)
    elif subject.surface is not None:
        support = _support(subject.surface, grid, dataset)
    names = {column.name for column in columns}
    axes, turn = _inertia(study)
    if grid is None and subject.plan is None and "attitude" in names and axes is not None:
        grid = _ellipsoid_grid(axes)
        support = {"kind": "point"}
    if grid is not None:
        size = float(np.max(np.ptp(grid.points.reshape(-1, 3), axis=0)))
    elif subject.plan is not None:
        size = _size_of_mechanism(study, columns)
    return {
        "body": None if grid is None else _body(grid),
        "inertia_axes": None if axes is None else [float(x) for x in axes],
        "inertia_turn": [float(x) for x in turn],
        "support": support,
        "links": [
            {"kind": column.name.split("_")[1], "column": column.name}
            for column in columns
            if column.name.startswith("plan_") and column.name != "plan_path"
        ],
        "path": "plan_path" if "plan_path" in names else None,
        "vectors": list(_vectors(columns)) if grid is not None else [],
        "size": size,
    }


def _size_of_mechanism(study: Study, columns: Sequence[Column]) -> float:
    """The extent of a mechanism at the start; 1 if it is a point."""
    formulas = [
        formula
        for column in columns
        if column.name.startswith("plan_")
        # A heading has no length.
        for formula in column.formulas[: 2 if len(column.formulas) == 3 else None]
    ]
    whole = study.system.lifted() if study.system.reconstruction else study.system
    start = np.array([[float(x) for x in study.start]])
    places = values(whole, formulas, start).reshape(-1, 2)
    return float(np.max(np.ptp(places, axis=0))) or 1.0


def _body(grid: DirectionGrid) -> dict[str, Json]:
    return {
        "theta": [float(x) for x in grid.theta],
        "phi": [float(x) for x in grid.phi],
        "positions": floats(grid.points),
        "hollow": grid.hollow,
        "thickness": grid.thickness,
    }


def _support(
    surface: Surface, grid: DirectionGrid | None, dataset: xr.Dataset | None
) -> dict[str, Json]:
    """A plane, a sphere, or the mesh of any other surface around the motion."""
    radius = surface.signed_radius
    if surface.is_flat:
        return {"kind": "plane"}
    if radius is not None:
        return {"kind": "sphere", "radius": abs(radius), "inside": radius < 0}
    size = 1.0 if grid is None else float(np.max(np.ptp(grid.points.reshape(-1, 3), axis=0)))
    return _mesh(ground_of_surface(surface), size / 2, dataset)


def _ellipsoid_grid(axes: FloatArray) -> DirectionGrid:
    """The ellipsoid of inertia, for a body whose shape is irrelevant."""
    squares = axes**2

    def contact(gamma: FloatArray) -> FloatArray:
        points: FloatArray = -gamma * squares / np.sqrt(gamma**2 @ squares)[:, None]
        return points

    return direction_grid(contact, ROWS, COLUMNS)


def _mesh(ground: SurfaceGround, radius: float, dataset: xr.Dataset | None) -> dict[str, Json]:
    """The part of a surface around the motion of a body of that radius, or around the origin."""
    points = np.zeros((1, 3))
    if dataset is not None:
        both = [dataset[name].to_numpy() for name in ("contact", "centre")]
        points = np.concatenate(both).astype(np.float64)
        points = points[np.isfinite(points).all(axis=1)]
    extent = float(np.max(np.ptp(points, axis=0)))
    margin = 1.5 * radius + extent * np.array([0.15, 0.15, 0.05])
    mesh = surface_mesh(ground, frame_of(points, margin, ground))
    return {
        "kind": "mesh",
        "positions": floats(mesh.positions),
        "normals": floats(mesh.normals),
        "indices": integers(mesh.indices),
    }


def _inertia(study: Study) -> tuple[FloatArray | None, FloatArray]:
    """Semi-axes of (x, Ix) = 1, the longest scaled to 1, and the rotation of its axes."""
    upright = np.array([1.0, 0.0, 0.0, 0.0])
    tensor = study.subject.inertia
    if tensor is None:
        return None, upright
    squares, frame = np.linalg.eigh(tensor)
    if np.count_nonzero(tensor - np.diag(np.diag(tensor))) == 0:
        squares, frame = np.diag(tensor), np.eye(3)
    if np.linalg.det(frame) < 0.0:
        frame[:, 0] *= -1.0
    axes = 1.0 / np.sqrt(squares)
    return axes / axes.max(), _quaternion(frame)


def _quaternion(frame: FloatArray) -> FloatArray:
    """The unit quaternion (w, x, y, z) of a rotation."""
    from scipy.spatial.transform import Rotation

    x, y, z, w = Rotation.from_matrix(frame).as_quat()
    return np.array([w, x, y, z])


def _vectors(columns: Iterable[Column]) -> Iterable[dict[str, Json]]:
    for column in columns:
        at = _VECTORS.get(column.name)
        if at is None or len(column.formulas) != 3 or column.axes not in ("body", "space"):
            continue
        yield {
            "name": column.meaning or column.name,
            "column": column.name,
            "axes": column.axes,
            "at": at,
            "unit": column.unit,
            "mathml": column.mathml,
        }
