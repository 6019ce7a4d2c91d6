"""The ground under a body: grids, spheres, bowls."""

from __future__ import annotations

import numpy as np
from matplotlib.colors import to_hex, to_rgb

from flowlanes.system.arrays import FloatArray

from ...geometry.mesh import SurfaceCurve, sphere_cap
from ...geometry.view import View, unit
from ..drawing.canvas import Canvas, visible_pieces
from ..drawing.curves import convex_hull, runs
from ..drawing.shading import Ground, PlaneGround
from ..drawing.style import LINES

#: Distance from a sphere, relative to its radius, above which it is not rounding.
_ABOVE = 1e-4


def on_ground(points: FloatArray, ground: Ground) -> SurfaceCurve:
    """A curve laid exactly on the ground, except where it is clearly above it."""
    if isinstance(ground, PlaneGround):
        return SurfaceCurve(points, np.tile([0.0, 0.0, 1.0], (len(points), 1)))
    normals, radius = unit(points), abs(ground.radius)
    above = np.abs(np.linalg.norm(points, axis=1, keepdims=True) - radius) > _ABOVE * radius
    return SurfaceCurve(np.where(above, points, radius * normals), normals)


def draw_grid(sheet: Canvas, path: FloatArray, diameter: float) -> float:
    """A square grid on the plane that fades with the distance from the path."""
    near = path[:: max(1, len(path) // 150), :2]
    extent = float(np.max(np.ptp(near, axis=0)))
    fade = max(0.85 * diameter, 0.13 * extent)
    low, high = near.min(axis=0) - fade, near.max(axis=0) + fade
    spacing = _round_number(max(0.5 * diameter, float(np.max(high - low)) / 32))
    levels = 7
    strokes: list[list[FloatArray]] = [[] for _ in range(levels)]
    for across in (0, 1):
        along = 1 - across
        steps = int(np.ceil((high[along] - low[along]) / (spacing / 5)))
        run = np.linspace(low[along], high[along], steps + 1)
        for line in np.arange(np.ceil(low[across] / spacing), high[across] / spacing) * spacing:
            points = np.zeros((len(run), 3))
            points[:, across] = line
            points[:, along] = run
            middles = (points[1:, :2] + points[:-1, :2]) / 2
            distance = np.min(np.linalg.norm(middles[:, None] - near[None], axis=-1), axis=1)
            ease = np.clip(1.0 - distance / fade, 0.0, 1.0)
            level = np.round((ease * ease * (3.0 - 2.0 * ease)) * levels).astype(int)
            for strength in range(1, levels + 1):
                strokes[strength - 1] += [points[run_] for run_ in runs(level == strength)]
    full = np.array(to_rgb("#aab6c2"))
    for strength, curves in enumerate(strokes, start=1):
        share = strength / levels
        colour = to_hex(tuple(share * full + (1.0 - share)))
        sheet.strokes(curves, colour, 0.5)
    return spacing


def _round_number(size: float) -> float:
    """The largest number 1, 2 or 5 times a power of ten below `size`."""
    power = 10.0 ** np.floor(np.log10(size))
    return float(max(step for step in (1.0, 2.0, 5.0) if step * power <= size * (1 + 1e-9)) * power)


def cap_opening(path: FloatArray, pole: float, room: float, widest: float) -> float:
    """Angle from the pole to the rim of a cap around the path; π for a whole sphere."""
    farthest = float(np.max(np.arccos(np.clip(pole * unit(path)[:, 2], -1.0, 1.0))))
    return farthest + room if farthest + room < widest else np.pi


def draw_outside(sheet: Canvas, radius: float, opening: float) -> None:
    """A sphere, or a cap of it around the top, seen from outside."""
    border = _cap_border(sheet.view, radius, 1.0, opening)
    sheet.sphere(radius, 1.0, border)
    lines = [
        piece
        for curve in _graticule(radius, 1.0, opening)
        for piece in visible_pieces(curve, sheet.view, 1.0)
    ]
    sheet.strokes(lines, LINES, 0.3)
    sheet.outline(border, "#8796a4", 0.6)


def draw_far_wall(sheet: Canvas, radius: float, opening: float) -> None:
    """The inside of the far wall of a bowl."""
    sheet.sphere(radius, -1.0, _cap_border(sheet.view, radius, -1.0, opening))
    lines = [
        piece
        for curve in _graticule(radius, -1.0, opening)
        for piece in visible_pieces(curve, sheet.view, -1.0)
    ]
    sheet.strokes(lines, LINES, 0.3)


def draw_near_wall(sheet: Canvas, radius: float, opening: float) -> None:
    """The translucent near wall of a bowl, and its rim."""
    if opening < np.pi:
        bowl = sphere_cap(radius, -1.0, opening, 20, 64)
        sheet.glass(bowl.select(bowl.faces_reader(sheet.view)), "#8fa6bb", 0.2)
        sheet.strokes([_rim(radius, -1.0, opening).points], "#73838f", 0.7)
    sheet.outline(_cap_border(sheet.view, radius, -1.0, opening), "#8796a4", 0.6)


def _cap_border(view: View, radius: float, pole: float, opening: float) -> FloatArray:
    """The border on paper of a cap seen from its rim, or of a whole sphere."""
    cap = sphere_cap(radius, pole, opening, 24, 90)
    whole = _limb(view, radius) if opening == np.pi else cap.polygons.reshape(-1, 3)
    return convex_hull(view.project(whole))


def _limb(view: View, radius: float) -> FloatArray:
    """The border of a whole sphere."""
    angle = np.linspace(0.0, 2 * np.pi, 181)[:, None]
    return radius * (np.cos(angle) * view.right + np.sin(angle) * view.up)


def _rim(radius: float, pole: float, opening: float) -> SurfaceCurve:
    around = np.linspace(0.0, 2 * np.pi, 181)
    normals = _sphere_points(np.full_like(around, opening), around, pole)
    return SurfaceCurve(radius * normals, normals)


def _graticule(radius: float, pole: float, opening: float) -> list[SurfaceCurve]:
    """Parallels and meridians of a cap."""
    step = np.radians(15.0 if opening > 0.8 else 5.0)
    polar = np.arange(step, opening - 1e-6, step)
    curves = []
    around = np.linspace(0.0, 2 * np.pi, 145)
    for angle in polar:
        curves.append(_sphere_points(np.full_like(around, angle), around, pole))
    # Meridians end short of the pole, where they would be too dense.
    along = np.linspace(step, opening if opening < np.pi else np.pi - step, 73)
    for azimuth in np.arange(24) * np.pi / 12:
        curves.append(_sphere_points(along, np.full_like(along, azimuth), pole))
    return [SurfaceCurve(radius * normals, normals) for normals in curves]


def _sphere_points(polar: FloatArray, azimuth: FloatArray, pole: float) -> FloatArray:
    return np.stack(
        [np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), pole * np.cos(polar)],
        axis=-1,
    )
