"""Paths of the contact point on the support, and of the normal on its sphere."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ...geometry.mesh import SurfaceCurve
from ...geometry.view import View, unit
from ..drawing.canvas import (
    Canvas,
    PathColours,
    blank_axes,
    fit_height,
    mark_ends,
    time_bar,
    timed_on_surface,
)
from ..drawing.curves import smooth_curve
from ..drawing.dataset_access import (
    CURVE_POINTS,
    NOTHING,
    require,
    time_shares,
    times_of,
    title_of,
    unit_of,
    values_of,
    with_unit,
)
from ..drawing.modes import ModeColours, changes_mode
from ..drawing.shading import Ground, PlaneGround, SphereGround
from ..drawing.style import FAINT, INK, QUIET, STYLE, WIDTH
from ..scenes.contact_marks import mark_events, mode_scale
from ..scenes.ground import draw_far_wall, draw_near_wall, draw_outside, on_ground

_LEFT = 0.76
"""Width in inches of the left margin of a map, for its tick labels."""


@arguments_checked
def contact_path(dataset: xr.Dataset, surface: Ground) -> Figure:
    """The path of the contact point on the surface, in the colours of time.

    If the contact mode changes, the colours are those of the modes.

    On a plane it is seen from above, to scale; on a sphere in space, with the part on the far
    side faded (of a bowl the inside of the far wall is seen).

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `contact`.
    surface : PlaneGround or SphereGround

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks the contact point, or has no finite sample of it.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> from chaplygin.report.drawing.shading import PlaneGround
    >>> figure = report.figures.contact_path(dataset, PlaneGround())
    >>> [axes.get_xlabel() for axes in figure.axes]
    ['$x$  (m)', '']
    """
    require(dataset, "contact_path")
    contact = values_of(dataset, "contact")
    good = np.isfinite(contact).all(axis=1)
    if not np.any(good):
        raise InputError(f"the figure contact_path has no sample to show of {title_of(dataset)}")
    samples = times_of(dataset)[good]
    times, points = smooth_curve(samples, contact[good], CURVE_POINTS)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.0))
        figure.set_label(f"Path of the contact point: {title_of(dataset)}")
        span = (samples[0], samples[-1])
        colours = ModeColours(dataset, *span) if changes_mode(dataset) else None
        if isinstance(surface, PlaneGround):
            sheet = _path_on_plane(figure, dataset, times, points, colours)
            left = _LEFT
        else:
            sheet = _path_on_sphere(figure, times, points, surface, colours)
            left = 0.12
        if colours is None:
            time_bar(figure, dataset, span, (left, 0.16))
        else:
            mark_events(sheet, dataset, times, points, surface)
            mode_scale(figure, sheet.axes, dataset, span)
    return figure


def _path_on_plane(
    figure: Figure,
    dataset: xr.Dataset,
    times: FloatArray,
    points: FloatArray,
    colours: PathColours | None,
) -> Canvas:
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    extent = float(np.max(high - low))
    middle = (low + high) / 2
    left, right, bottom, top = _LEFT, 0.12, 0.86, 0.12
    wide = WIDTH - left - right
    size = np.maximum(high - low, 0.05 * extent) if extent > NOTHING else np.array([2.0, 1.0])
    tall = float(np.clip(wide * size[1] / size[0], 1.6, 4.4))
    figure.set_size_inches(WIDTH, tall + bottom + top)
    height = figure.get_figheight()
    axes = figure.add_axes((left / WIDTH, bottom / height, wide / WIDTH, tall / height))
    half = 1.12 / 2 * max(size[0], size[1] * wide / tall)
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half * tall / wide, middle[1] + half * tall / wide)
    axes.grid(color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    units = unit_of(dataset, "contact")
    axes.set_xlabel(with_unit("$x$", units))
    axes.set_ylabel(with_unit("$y$", units))
    from_above = View(-np.pi / 2, np.pi / 2)
    sheet = Canvas(axes, from_above, colours)
    sheet.time_coloured(points, time_shares(times), 1.6, 1.0)
    mark_ends(sheet, on_ground(points, PlaneGround()), 1.0)
    return sheet


def _path_on_sphere(
    figure: Figure,
    times: FloatArray,
    points: FloatArray,
    ground: SphereGround,
    colours: PathColours | None,
) -> Canvas:
    side = float(np.copysign(1.0, ground.radius))
    radius = abs(ground.radius)
    curve = on_ground(points, ground)
    middle = unit(curve.normals.mean(axis=0))
    azimuth = float(np.arctan2(middle[1], middle[0])) + 0.35
    height = float(np.arcsin(np.clip(middle[2], -1.0, 1.0)))
    view = View(azimuth + (np.pi if side < 0 else 0.0), float(np.clip(side * height, 0.3, 1.0)))
    sheet = Canvas(blank_axes(figure), view, colours)
    fractions = time_shares(times)
    if side > 0:
        draw_outside(sheet, radius, np.pi)
    else:
        draw_far_wall(sheet, radius, np.pi)
        draw_near_wall(sheet, radius, np.pi)
    timed_on_surface(sheet, curve, fractions, -side, 1.0, 0.4)
    timed_on_surface(sheet, curve, fractions, side, 1.8, 1.0)
    mark_ends(sheet, curve, side)
    fit_height(figure, sheet.axes, 4.2, 4.2)
    return sheet


@arguments_checked
def normal_on_sphere(dataset: xr.Dataset) -> Figure:
    """The curve of the surface normal gamma on its unit sphere, in body axes.

    The far side is faded; a ring marks the start and a dot the end.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `gamma`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks gamma, or has no finite sample of it.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.normal_on_sphere(dataset)
    >>> len(figure.axes)
    2
    """
    require(dataset, "normal_on_sphere")
    gamma = values_of(dataset, "gamma")
    good = np.isfinite(gamma).all(axis=1)
    if not np.any(good):
        raise InputError(
            f"the figure normal_on_sphere has no sample to show of {title_of(dataset)}"
        )
    samples = times_of(dataset)[good]
    times, points = smooth_curve(samples, gamma[good], CURVE_POINTS)
    normals = unit(points)
    curve = SurfaceCurve(normals, normals)
    fractions = time_shares(times)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(4.2, 4.2))
        figure.set_label(f"Path of the surface normal in body axes: {title_of(dataset)}")
        sheet = Canvas(blank_axes(figure), _view_of_most(normals))
        _draw_axes(sheet, behind=True)
        draw_outside(sheet, 1.0, np.pi)
        timed_on_surface(sheet, curve, fractions, -1.0, 1.0, 0.4)
        _draw_axes(sheet, behind=False)
        timed_on_surface(sheet, curve, fractions, 1.0, 1.8, 1.0)
        mark_ends(sheet, curve, 1.0)
        fit_height(figure, sheet.axes, 4.2, 4.4)
        time_bar(figure, dataset, (samples[0], samples[-1]), (0.12, 0.16))
    return figure


def _view_of_most(normals: FloatArray) -> View:
    """The view from the centre of an octant that shows most of a curve."""
    views = [
        View(np.radians(azimuth), elevation)
        for azimuth in (42.0, 132.0, 222.0, 312.0)
        for elevation in (0.38, -0.38)
    ]
    return max(views, key=lambda view: float(np.mean(normals @ view.toward)))


def _draw_axes(sheet: Canvas, behind: bool) -> None:
    """Draw those body axes that point away from the viewer, or towards the viewer."""
    for axis, direction in enumerate(np.eye(3)):
        if bool(sheet.view.depth(direction) < 0.0) == behind:
            colour = "#a3afba" if behind else "#56636f"
            sheet.strokes([np.stack([direction, 1.46 * direction])], colour, 0.8)
            sheet.label(1.6 * direction, rf"$\gamma_{axis + 1}$", QUIET if behind else INK)
