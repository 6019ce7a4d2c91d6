"""The picture of a rolling body on its ground."""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ...geometry.mesh import BodyMesh, SurfaceCurve
from ...geometry.view import View, rotation_matrices, unit
from ..drawing.canvas import (
    Canvas,
    blank_axes,
    fit_height,
    mark_start,
    time_bar,
    timed_on_surface,
    visible_pieces,
)
from ..drawing.curves import convex_hull, cut_by_plane, smooth_curve
from ..drawing.dataset_access import (
    CURVE_POINTS,
    require,
    time_shares,
    times_of,
    title_of,
    unit_of,
    values_of,
)
from ..drawing.modes import ModeColours
from ..drawing.shading import Ground, PlaneGround, SphereGround, cast_shadow
from ..drawing.style import BODY_TONES, QUIET, SHELL_TONES, STYLE, WIDTH
from .contact_marks import mark_events, mode_scale
from .ground import cap_opening, draw_far_wall, draw_grid, draw_near_wall, draw_outside, on_ground

_WHOLE = 10.0
"""Extent in diameters of the body up to which a path is drawn as a whole."""

_REACH = 6.0
"""Extent in diameters of the body of the drawn last part of a longer path."""

_TRACE = 6.3
"""Length in diameters of the body of the path traced on it: twice around a ball."""


@arguments_checked
def scene(
    dataset: xr.Dataset, outline: BodyMesh, surface: Ground, until: float | None = None
) -> Figure:
    """The body on its surface, with the paths of the contact point on both.

    The body is drawn in its final position, the path in the colours of time, or in those of the
    modes of a contact with friction. A path too long for the picture is cut to its last part; the
    colour bar, or the legend of the modes, shows which.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `contact`, `centre`, `attitude` and `gamma`.
    outline : BodyMesh
        Shape of the body, body axes.
    surface : PlaneGround or SphereGround
    until : float, optional
        Time at which the body is drawn, in units of `time`; by default the last.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks a variable, or has no sample up to `until`.
    """
    track = track_of(dataset, until)
    if isinstance(surface, PlaneGround):
        track = track.last_part(outline.diameter)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, WIDTH))
        figure.set_label(f"The body and the path of its contact point: {title_of(dataset)}")
        first, last = track.times[0], track.times[-1]
        colours = ModeColours(dataset, first, last) if "mode" in dataset else None
        sheet = Canvas(blank_axes(figure), scene_view(track, surface), colours)
        spacing = draw_scene(sheet, track, outline, surface)
        note = f"grid {spacing:g} {unit_of(dataset, 'contact')}".rstrip() if spacing else ""
        if colours is not None:
            body = outline.in_space(track.rotation[-1], track.centre[-1])
            mark_events(sheet, dataset, track.times, track.contact, surface, body)
        fit_height(figure, sheet.axes, WIDTH, 5.0)
        if colours is None:
            time_bar(figure, dataset, (first, last), (0.12, 0.16))
        else:
            mode_scale(figure, sheet.axes, dataset, (first, last))
        figure.text(
            1.0 - 0.1 / WIDTH,
            0.19 / figure.get_figheight(),
            note,
            ha="right",
            va="center",
            color=QUIET,
            fontsize=9,
        )
    return figure


def draw_scene(
    sheet: Canvas, track: Track, outline: BodyMesh, surface: Ground, whole: Track | None = None
) -> float:
    """Draw the body at the end of a track, its surface and the paths of the contact.

    Parameters
    ----------
    sheet : Canvas
    track : Track
    outline : BodyMesh
    surface : PlaneGround or SphereGround
    whole : Track, optional
        The complete track, around which the surface is drawn, if it shall stay fixed in a film; the
        body is then not drawn at earlier positions.

    Returns
    -------
    float
        The spacing of the grid on a plane; 0 without a grid.
    """
    body = outline.in_space(track.rotation[-1], track.centre[-1])
    if isinstance(surface, PlaneGround):
        return _scene_on_plane(sheet, track, outline, body, whole)
    if body.hollow:
        _scene_around_sphere(sheet, track, body, surface)
    elif surface.radius > 0.0:
        _scene_on_sphere(sheet, track, body, surface, whole or track)
    else:
        _scene_in_bowl(sheet, track, body, surface, whole or track)
    return 0.0


@dataclass(frozen=True, eq=False)
class Track:
    """The drawn part of a rolling body's track.

    Attributes
    ----------
    times : (n,) array
    contact, centre : (n, 3) arrays
        Space axes.
    rotation : (n, 3, 3) array
        Body to space.
    normal : (n, 3) array
        Outward normal of the supporting surface at the contact, body axes.
    """

    times: FloatArray
    contact: FloatArray
    centre: FloatArray
    rotation: FloatArray
    normal: FloatArray

    def last_part(self, diameter: float) -> Track:
        """The last part of the track that fits beside a body of this diameter."""
        low = np.minimum.accumulate(self.contact[::-1], axis=0)
        high = np.maximum.accumulate(self.contact[::-1], axis=0)
        extent = np.max(high - low, axis=1)
        if extent[-1] <= _WHOLE * diameter:
            return self
        last = slice(-int(np.sum(extent <= _REACH * diameter)), None)
        return Track(
            self.times[last],
            self.contact[last],
            self.centre[last],
            self.rotation[last],
            self.normal[last],
        )

    def path(self, ground: Ground) -> tuple[FloatArray, SurfaceCurve]:
        """Times, and the path of the contact on the ground, smoothed."""
        times, points = smooth_curve(self.times, self.contact, CURVE_POINTS)
        return times, on_ground(points, ground)

    def trace(self, hollow: bool, longest: float) -> tuple[FloatArray, SurfaceCurve]:
        """Times, and the path of the contact on the body in its final position, smoothed.

        Only its last part is given, up to the length `longest`.
        """
        body = np.einsum("nji,nj->ni", self.rotation, self.contact - self.centre)
        outward = self.normal if hollow else -self.normal
        times, both = smooth_curve(self.times, np.hstack([body, outward]), CURVE_POINTS)
        lengths = np.linalg.norm(np.diff(both[:, :3], axis=0), axis=1)
        recent = np.append(np.cumsum(lengths[::-1])[::-1], 0.0) <= longest
        times, both = times[recent], both[recent]
        turn = self.rotation[-1].T
        return times, SurfaceCurve(both[:, :3] @ turn + self.centre[-1], unit(both[:, 3:]) @ turn)


def track_of(dataset: xr.Dataset, until: float | None) -> Track:
    """All finite samples up to a time."""
    require(dataset, "scene")
    times = times_of(dataset)
    contact, attitude = values_of(dataset, "contact"), values_of(dataset, "attitude")
    good = np.isfinite(contact).all(axis=1) & np.isfinite(attitude).all(axis=1)
    if until is not None:
        good &= times <= until
    if not np.any(good):
        raise InputError(f"the figure scene has no sample to show of {title_of(dataset)}")
    return Track(
        times[good],
        contact[good],
        values_of(dataset, "centre")[good],
        rotation_matrices(attitude[good]),
        values_of(dataset, "gamma")[good],
    )


def scene_view(track: Track, ground: Ground) -> View:
    """The view in which the path runs from left to right."""
    end = track.contact[-1]
    if isinstance(ground, PlaneGround):
        return _plane_view(track.contact)
    middle = unit(unit(track.contact).mean(axis=0) + 0.8 * unit(end))
    height = float(np.arcsin(np.clip(middle[2], -1.0, 1.0)))
    near_pole = np.hypot(middle[0], middle[1]) < 0.35
    azimuth = across(track.contact) if near_pole else float(np.arctan2(middle[1], middle[0])) + 0.35
    if ground.radius > 0.0:
        return View(azimuth, float(np.clip(0.6 * height, -0.25, 0.6)))
    return View(azimuth + (0.0 if near_pole else np.pi), 0.62 if height < -0.3 else 0.35)


def _plane_view(contact: FloatArray) -> View:
    """A view slightly along the path, perpendicular to its last steps."""
    azimuth = across(contact)
    back = np.linalg.norm(contact - contact[-1], axis=1)
    last = contact[-1] - contact[np.argmax(back <= 0.15 * np.max(back))]
    views = [View(azimuth + turn, 0.5) for turn in (0.42, -0.42)]
    # With the body on the near side, unless that shows the end of the path head-on.
    return min(views, key=lambda view: abs(view.depth(unit(last))) - 0.1 * view.depth(unit(last)))


def across(points: FloatArray) -> float:
    """Azimuth from which points (n, 3) extend most from left to right."""
    flat = points[:, :2] - points[:, :2].mean(axis=0)
    along = np.linalg.svd(flat, full_matrices=False)[2][0] if np.any(flat) else np.array([0.0, 1.0])
    if along @ (points[-1, :2] - points[0, :2]) < 0.0:
        along = -along
    return float(np.arctan2(-along[0], along[1]))


def _lamp(view: View) -> FloatArray:
    """Direction of the light that casts shadows: that of the view, but steeper."""
    return unit(0.45 * view.light + np.array([0.0, 0.0, 1.0]))


def _draw_shadow(sheet: Canvas, body: BodyMesh, ground: Ground) -> None:
    """Draw a shadow with soft borders."""
    lamp = _lamp(sheet.view)
    lamps = 40
    for number in range(lamps):
        angle, distance = 2.399963 * number, 0.22 * np.sqrt((number + 0.5) / lamps)
        offset = distance * (np.cos(angle) * sheet.view.right + np.sin(angle) * sheet.view.up)
        shadow = cast_shadow(body.vertices, ground, unit(lamp + offset))
        if isinstance(ground, SphereGround) and len(shadow):
            shadow = cut_by_plane(shadow, np.copysign(1.0, ground.radius) * sheet.view.toward)
        sheet.fill(sheet.view.project(shadow), "#1b2a3a", 0.0105)


def draw_body(sheet: Canvas, body: BodyMesh, track: Track) -> None:
    """The near side of the body with its seams, its border and the path traced on it."""
    facets = body.facets
    sheet.facets(facets.select(facets.faces_reader(sheet.view)), BODY_TONES, 1.0, 0.5)
    seams = [piece for seam in body.seams for piece in visible_pieces(seam, sheet.view, 1.0)]
    sheet.strokes(seams, "#3d5a76", 0.45)
    times, trace = track.trace(body.hollow, _TRACE * body.diameter)
    timed_on_surface(sheet, trace, time_shares(times, track.times[0]), 1.0, 1.4, 1.0)
    _draw_border(sheet, body, "#2c3e50", 0.6)


def _draw_border(sheet: Canvas, body: BodyMesh, colour: str, width: float) -> None:
    sheet.outline(convex_hull(sheet.view.project(body.vertices)), colour, width)


def _draw_ghosts(sheet: Canvas, track: Track, outline: BodyMesh) -> None:
    """Draw pale bodies at earlier positions that do not overlap others."""
    extent = float(np.max(np.ptp(track.contact, axis=0)))
    apart = max(1.25 * outline.diameter, 0.2 * extent)
    places = [len(track.times) - 1]
    middle = track.centre + track.rotation @ outline.vertices.mean(axis=0)
    flat = sheet.view.project(middle)
    for index in range(len(track.times) - 1, -1, -1):
        if np.min(np.linalg.norm(flat[places] - flat[index], axis=1)) > apart:
            places.append(index)
        if len(places) == 5:
            break
    for index in sorted(places[1:], key=lambda i: float(sheet.view.depth(middle[i]))):
        ghost = outline.in_space(track.rotation[index], track.centre[index])
        border = convex_hull(sheet.view.project(ghost.vertices))
        sheet.fill(border, "#eef2f6", 0.85)
        seams = [piece for seam in ghost.seams for piece in visible_pieces(seam, sheet.view, 1.0)]
        sheet.strokes(seams, "#cfd9e3", 0.5)
        sheet.outline(border, "#b5c2cf", 0.6)


def _scene_on_plane(
    sheet: Canvas, track: Track, outline: BodyMesh, body: BodyMesh, whole: Track | None
) -> float:
    """Draw grid, shadow, paths and body; return the spacing of the grid."""
    times, path = track.path(PlaneGround())
    around = path if whole is None else whole.path(PlaneGround())[1]
    spacing = draw_grid(sheet, around.points, outline.diameter)
    if whole is None:
        _draw_ghosts(sheet, track, outline)
    sheet.time_coloured(path.points, time_shares(times), 2.0, 1.0)
    mark_start(sheet, path, 1.0)
    _draw_shadow(sheet, body, PlaneGround())
    draw_body(sheet, body, track)
    return spacing


def _scene_on_sphere(
    sheet: Canvas, track: Track, body: BodyMesh, ground: SphereGround, whole: Track
) -> None:
    times, path = track.path(ground)
    fractions = time_shares(times)
    room = max(0.12, 0.75 * body.diameter / ground.radius)
    in_front = bool(sheet.view.faces_reader(path.normals[-1]))
    # The contact plane separates body and sphere: the one on the viewer's side hides the other.
    if not in_front:
        draw_body(sheet, body, track)
    draw_outside(sheet, ground.radius, cap_opening(whole.path(ground)[1].points, 1.0, room, 1.2))
    timed_on_surface(sheet, path, fractions, -1.0, 1.0, 0.35)
    timed_on_surface(sheet, path, fractions, 1.0, 2.0, 1.0)
    mark_start(sheet, path, 1.0)
    if in_front:
        _draw_shadow(sheet, body, ground)
        draw_body(sheet, body, track)
    else:
        _draw_border(sheet, body, "#b5c2cf", 0.6)


def _scene_in_bowl(
    sheet: Canvas, track: Track, body: BodyMesh, ground: SphereGround, whole: Track
) -> None:
    radius = abs(ground.radius)
    times, path = track.path(ground)
    fractions = time_shares(times)
    opening = cap_opening(whole.path(ground)[1].points, -1.0, 0.3, 1.75)
    draw_far_wall(sheet, radius, opening)
    timed_on_surface(sheet, path, fractions, -1.0, 2.0, 1.0)
    _draw_shadow(sheet, body, ground)
    draw_body(sheet, body, track)
    draw_near_wall(sheet, radius, opening)
    timed_on_surface(sheet, path, fractions, 1.0, 1.2, 0.55)
    mark_start(sheet, path, -1.0)


def _scene_around_sphere(sheet: Canvas, track: Track, body: BodyMesh, ground: SphereGround) -> None:
    """Draw a shell around a sphere: its far half, the sphere, its near half."""
    times, path = track.path(ground)
    fractions = time_shares(times)
    facets = body.facets
    near = facets.faces_reader(sheet.view)
    sheet.facets(facets.select(~near), SHELL_TONES, -1.0, 0.3)
    seams = [piece for seam in body.seams for piece in visible_pieces(seam, sheet.view, -1.0)]
    sheet.strokes(seams, "#8496a8", 0.45)
    instants, trace = track.trace(body.hollow, _TRACE * body.diameter)
    timed_on_surface(sheet, trace, time_shares(instants, track.times[0]), -1.0, 1.3, 0.8)
    draw_outside(sheet, abs(ground.radius), np.pi)
    timed_on_surface(sheet, path, fractions, -1.0, 1.0, 0.35)
    timed_on_surface(sheet, path, fractions, 1.0, 2.0, 1.0)
    mark_start(sheet, path, 1.0)
    sheet.glass(facets.select(near), "#8fa6bb", 0.12)
    seams = [piece for seam in body.seams for piece in visible_pieces(seam, sheet.view, 1.0)]
    sheet.strokes(seams, "#8496a8", 0.6)
    _draw_border(sheet, body, "#2c3e50", 0.7)
