"""The picture of a homogeneous ball on an arbitrary surface."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from scipy.ndimage import gaussian_filter

from flowlanes.arguments import arguments_checked
from flowlanes.system.arrays import BoolArray, FloatArray

from ...geometry.ball_surface import SurfaceGround, frame_of
from ...geometry.mesh import BodyMesh
from ...geometry.view import View
from ..drawing.canvas import Canvas, blank_axes, fit_height, time_bar
from ..drawing.curves import runs, smooth_curve
from ..drawing.dataset_access import CURVE_POINTS, time_shares, title_of
from ..drawing.style import GROUND_DARK, GROUND_LIGHT, INK, LINES, QUIET, STYLE, WIDTH
from .implicit_surface import Crossings, crossings
from .rolling_body import Track, across, draw_body, track_of

_COLUMNS = 720
"""Width of the drawn surface in dots."""

_BORDER = 0.9
"""Width in dots over which a border is blurred, to avoid steps."""

_GLASS = np.array(to_rgb("#8fa6bb"))
_GLASS_SHARE = 0.2
"""Colour and opacity of walls seen from behind."""

_SHORTEST = CURVE_POINTS // 50
"""Smallest number of points of a hidden part of the path."""

_LINE_STEPS = (1.0, 2.0, 5.0)
"""Spacings of the lines on the surface, up to a power of ten."""


@arguments_checked
def ball_scene(dataset: xr.Dataset, outline: BodyMesh, ground: SurfaceGround) -> Figure:
    """The ball on its surface at the end, and the path of its contact point.

    Lines on the surface are its intersections with planes x, y, z = const.  Walls between the
    viewer and the ball are drawn translucent where their back is visible.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `contact`, `centre`, `attitude` and `gamma`.
    outline : BodyMesh
        The ball, body axes.
    ground : SurfaceGround

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks a variable or has no sample.
    """
    track = track_of(dataset, None)
    view, seen = surface_seen(track, outline, ground)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, WIDTH))
        figure.set_label(f"The ball and the path of its contact point: {title_of(dataset)}")
        sheet = Canvas(blank_axes(figure), view)
        paint_ball_scene(sheet, seen, track, outline)
        fit_height(figure, sheet.axes, WIDTH, 5.0)
        time_bar(figure, dataset, (track.times[0], track.times[-1]), (0.12, 0.16))
    return figure


def surface_seen(track: Track, outline: BodyMesh, ground: SurfaceGround) -> tuple[View, Crossings]:
    """The view of a ball on its surface, and the visible part of the surface around its path."""
    view = _view(track, ground.normals(track.contact))
    extent = float(np.max(np.ptp(track.contact, axis=0)))
    # No part of the ball may be cut off.
    around = np.concatenate([track.contact, track.centre[-1:]])
    margin = 0.75 * outline.diameter + extent * np.array([0.15, 0.15, 0.05])
    return view, crossings(ground, frame_of(around, margin, ground), view, _COLUMNS)


def _view(track: Track, normals: FloatArray) -> View:
    """The view from the side of the surface normal at the ball."""
    facing = normals[-1] + 0.4 * normals.mean(axis=0)
    if np.hypot(facing[0], facing[1]) < 0.35:
        return View(across(track.contact) + 0.3, 0.5)
    return View(float(np.arctan2(facing[1], facing[0])) + 0.4, 0.42)


def paint_ball_scene(sheet: Canvas, layers: Crossings, track: Track, outline: BodyMesh) -> None:
    """Paint surface, path and ball, from the farthest to the nearest."""
    body = outline.in_space(track.rotation[-1], track.centre[-1])
    times, path = smooth_curve(track.times, track.contact, CURVE_POINTS)
    fractions = time_shares(times)
    ball = float(sheet.view.depth(track.centre[-1]))
    radius = outline.diameter / 2
    behind, before = layers.depth <= ball, layers.depth > ball
    hidden = _hidden_points(sheet.view, layers, path, 0.12 * radius)
    near = sheet.view.depth(path) > ball
    colours = _colours(layers, sheet.view, track.centre[-1], radius)
    # Opaque parts are painted twice, so that no seam is visible where both parts meet.
    _image(sheet, layers, colours, behind | _opaque(layers, sheet.view))
    _strokes(sheet, path, fractions, ~hidden & ~near, 2.0, 1.0)
    if not near[0]:
        _mark_start(sheet, path[0], bool(hidden[0]))
    draw_body(sheet, body, track)
    _image(sheet, layers, colours, before)
    _strokes(sheet, path, fractions, ~hidden & near, 2.0, 1.0)
    _strokes(sheet, path, fractions, hidden, 0.9, 0.45)
    if near[0]:
        _mark_start(sheet, path[0], bool(hidden[0]))


def _mark_start(sheet: Canvas, place: FloatArray, is_hidden: bool) -> None:
    """A ring, pale where the surface hides it."""
    sheet.dot(place, "none" if is_hidden else "white", QUIET if is_hidden else INK, 4.5)


def _strokes(
    sheet: Canvas,
    path: FloatArray,
    fractions: FloatArray,
    mask: BoolArray,
    width: float,
    alpha: float,
) -> None:
    for run in runs(mask[1:] | mask[:-1]):
        sheet.time_coloured(path[run], fractions[run], width, alpha)


def _hidden_points(view: View, layers: Crossings, path: FloatArray, slack: float) -> BoolArray:
    """Whether the opaque surface hides each point of a curve (n, 3) on it."""
    left, right, bottom, top = layers.extent
    rows, columns = layers.depth.shape[1:]
    x, y = view.project(path).T
    column = np.clip(((x - left) / (right - left) * columns).astype(int), 0, columns - 1)
    row = np.clip(((y - bottom) / (top - bottom) * rows).astype(int), 0, rows - 1)
    opaque = _opaque(layers, view)[:, row, column]
    nearer = layers.depth[:, row, column] > view.depth(path) + slack
    return _without_short_runs(np.any(opaque & nearer, axis=0))


def _without_short_runs(mask: BoolArray) -> BoolArray:
    """The marks without short runs, which are raster artefacts at a border."""
    long = np.zeros_like(mask)
    for run in runs(mask[1:] & mask[:-1]):
        long[run] = run.stop - run.start > _SHORTEST
    return long


def _opaque(layers: Crossings, view: View) -> BoolArray:
    """The crossings that show the side on which the ball rolls."""
    return np.asarray(layers.is_hit & view.faces_reader(layers.normals), dtype=np.bool_)


def _colours(layers: Crossings, view: View, centre: FloatArray, radius: float) -> FloatArray:
    """Colours of the ball's side at every crossing, with shadow and lines."""
    shape = layers.depth.shape
    light = 0.5 + 0.5 * np.clip(layers.normals @ view.light, -1.0, 1.0)
    colours = GROUND_DARK + light[..., None] ** 0.8 * (GROUND_LIGHT - GROUND_DARK)
    lines = _lines(layers)[..., None]
    colours = (1.0 - 0.75 * lines) * colours + 0.75 * lines * np.array(to_rgb(LINES))
    away = centre - np.nan_to_num(layers.points)
    lamp = view.light + np.array([0.0, 0.0, 0.9])
    lamp = lamp / np.linalg.norm(lamp)
    along = away @ lamp
    aside = np.sqrt(np.clip(np.sum(away**2, axis=-1) - along**2, 0.0, None))
    soft = np.clip((1.15 * radius - aside) / (0.45 * radius), 0.0, 1.0)
    soft = soft * np.clip(1.0 - along / (6.0 * radius), 0.0, 1.0)
    shade = np.where(along > 0.0, soft, 0.0).reshape(shape)
    return np.asarray(colours * (1.0 - 0.35 * shade[..., None]), dtype=np.float64)


def _lines(layers: Crossings) -> FloatArray:
    """Strength from 0 to 1 of the intersections with planes x, y, z = const at every crossing."""
    strengths = np.zeros(layers.depth.shape)
    if not np.any(layers.is_hit):
        return strengths
    sizes = np.ptp(layers.points[layers.is_hit], axis=0)
    spacing = _round_step(float(np.max(sizes)) / 12.0)
    for axis in range(3):
        place = layers.points[..., axis] / spacing
        with np.errstate(invalid="ignore"):
            width = np.maximum(*(np.abs(np.gradient(place, axis=a)) for a in (1, 2)))
            off = np.abs(place - np.round(place))
            line = np.clip(1.2 - off / np.clip(width, 1e-9, 0.5), 0.0, 1.0)
            line = np.where(width < 0.4, line, 0.0)
        # Where the surface is nearly parallel to such a plane the line would be a blot.
        slant = np.clip((0.98 - np.abs(layers.normals[..., axis])) / 0.1, 0.0, 1.0)
        strengths = np.maximum(strengths, np.nan_to_num(line) * slant)
    return strengths


def _round_step(size: float) -> float:
    power = 10.0 ** np.floor(np.log10(size))
    return float(min(s for s in (*_LINE_STEPS, 10.0) if s * power >= size * (1 - 1e-9)) * power)


def _image(sheet: Canvas, layers: Crossings, colours: FloatArray, mask: BoolArray) -> None:
    """Paint the chosen crossings, from the farthest to the nearest."""
    rows, columns = layers.depth.shape[1:]
    paint, cover = np.zeros((rows, columns, 3)), np.zeros((rows, columns, 1))
    opaque = _opaque(layers, sheet.view)
    for layer in reversed(range(len(layers.depth))):
        share = np.where(opaque[layer], 1.0, _GLASS_SHARE) * (mask[layer] & layers.is_hit[layer])
        share = share[..., None]
        colour = np.where(opaque[layer][..., None], colours[layer], _GLASS)
        total = share + cover * (1.0 - share)
        mixed = share * colour + (1.0 - share) * cover * paint
        # In empty pixels the colour matters for the soft border of neighbouring ones.
        paint = np.where(total > 0.0, mixed / np.where(total > 0.0, total, 1.0), GROUND_LIGHT)
        cover = total
    sheet.image(_with_soft_borders(paint, cover), layers.extent)


def _with_soft_borders(paint: FloatArray, cover: FloatArray) -> FloatArray:
    """Colours and opacity (rows, columns, 4) without steps where the opacity changes."""
    sharp = np.concatenate([paint * cover, cover], axis=-1)
    soft = gaussian_filter(sharp, (_BORDER, _BORDER, 0.0))
    border = np.abs(soft - sharp)[..., 3:] > 0.005
    opacity = np.where(border, soft[..., 3:], cover)
    colours = np.where(border, soft[..., :3] / np.clip(soft[..., 3:], 1e-6, None), paint)
    return np.concatenate([np.clip(colours, 0.0, 1.0), opacity], axis=-1)
