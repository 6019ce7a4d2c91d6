"""Figures of a trajectory: the rolling body, its paths, its motion in time, its conserved laws.

Every figure is a function of a trajectory's dataset (and, for the drawn body, of its outline and
of what it rolls on) and returns a `matplotlib.figure.Figure`; nothing global is touched. Needed
variables that the dataset lacks are an `InputError`; `all_figures` leaves such figures out.
"""

from __future__ import annotations

import hashlib
import io
import re
from collections.abc import Iterable
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path as FilePath
from typing import TYPE_CHECKING, Any
from xml.sax.saxutils import quoteattr

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import LinearSegmentedColormap, to_hex, to_rgb
from matplotlib.figure import Figure
from matplotlib.mathtext import MathTextParser
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from ..errors import InputError
from .drawing import (
    BoolArray,
    Facets,
    FloatArray,
    Ground,
    Outline,
    PlaneGround,
    SphereGround,
    SurfaceCurve,
    View,
    cast_shadow,
    convex_hull,
    cut_by_plane,
    rotation_matrices,
    runs,
    shaded,
    smooth_curve,
    sphere_cap,
    sphere_shades,
    unit,
)

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

__all__ = [
    "FORMATS",
    "STYLE",
    "all_figures",
    "angular_velocity",
    "contact_path",
    "drift",
    "normal_force",
    "normal_on_sphere",
    "relative_drift",
    "save",
    "scene",
    "svg_text",
]

INK = "#1f2730"
QUIET = "#7b8792"
FAINT = "#ccd3da"
LINES = "#a9b6c2"
ALARM = "#bb5566"

# Paul Tol's high-contrast colours: apart for every kind of colour vision, and in grey print.
COMPONENTS = ("#004488", "#bb5566", "#d9a521")
# Paul Tol's muted colours, darkest and most different first.
SERIES = ("#332288", "#cc6677", "#117733", "#ddaa33", "#88ccee", "#aa4499", "#999933", "#44aa99")

TIME_COLOURS = LinearSegmentedColormap.from_list(
    "chaplygin-time", ["#f6c667", "#ec8f4d", "#cf4f5b", "#8a2a75", "#3b1a68"]
)
BODY_TONES = np.array([to_rgb("#f4f1ea"), to_rgb("#5b86ad")])
SHELL_TONES = np.array([to_rgb("#f0ece2"), to_rgb("#a9bfd3")])
GROUND_LIGHT = np.array(to_rgb("#f4f7fa"))
GROUND_DARK = np.array(to_rgb("#b3bfcb"))

STYLE: dict[RcKeyType, Any] = {
    "font.family": "STIXGeneral",
    "font.size": 9.5,
    "mathtext.fontset": "stix",
    "text.color": INK,
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.6,
    "axes.labelsize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.useoffset": False,
    "axes.formatter.use_mathtext": True,
    "axes.unicode_minus": True,
    "xtick.color": QUIET,
    "ytick.color": QUIET,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "xtick.direction": "out",
    "ytick.direction": "out",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3,
    "ytick.major.size": 3,
    "lines.linewidth": 1.1,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "legend.frameon": False,
    "legend.fontsize": 9.5,
    "legend.handlelength": 1.8,
    "legend.columnspacing": 1.8,
    "legend.handletextpad": 0.6,
    "legend.borderaxespad": 0.0,
    "figure.facecolor": "white",
    "axes.facecolor": "white",
    "savefig.facecolor": "white",
    "svg.fonttype": "path",
    "svg.hashsalt": "chaplygin",
    "pdf.fonttype": 42,
}
"""How every figure looks; put in force while a figure is made and while it is written."""

WIDTH = 6.3
"""Width of a figure in inches: the text of an A4 page."""

FORMATS: dict[str, dict[str, None]] = {
    ".png": {"Software": None},
    ".svg": {"Date": None, "Creator": None, "Format": None, "Type": None},
    ".pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""Kinds of file `save` writes, each with the notes on time and program it leaves out."""

_NEEDED = {
    "scene": ("contact", "centre", "attitude", "gamma"),
    "contact_path": ("contact",),
    "normal_on_sphere": ("gamma",),
    "angular_velocity": ("omega",),
    "normal_force": ("normal_force",),
}

_SHADES = 72
"""Steps between black and white of the shades of a body."""

_REACH = 5.5
"""How many diameters of the body the path drawn in a scene may extend."""

_TRACE = 6.3
"""How many diameters of the body the path traced on it may be long: twice around a ball."""

_CURVE_POINTS = 1200
"""Points with which a smooth path is drawn."""

_DOTS = 400
"""Dots with which a drift is drawn, about."""

_NOTHING = 1e-9
"""What is smaller than this counts as zero, for want of a scale: it is not magnified."""


# --------------------------------------------------------------------------- common pieces


def _require(dataset: xr.Dataset, figure: str) -> None:
    missing = [name for name in _NEEDED[figure] if name not in dataset]
    if missing:
        raise InputError(
            f"the figure {figure} needs {', '.join(missing)}, which the trajectory of "
            f"{_title(dataset)} does not have"
        )


def _title(dataset: xr.Dataset) -> str:
    return str(dataset.attrs.get("system", "this system"))


def _values(dataset: xr.Dataset, name: str) -> FloatArray:
    """Values of a variable, time along the first axis."""
    return np.asarray(dataset[name].transpose("time", ...).values, dtype=np.float64)


def _times(dataset: xr.Dataset) -> FloatArray:
    return np.asarray(dataset["time"].values, dtype=np.float64)


def _readable(text: str) -> str:
    """The text itself if its formulas can be typeset, else the text with plain dollar signs."""
    try:
        MathTextParser("path").parse(text)
    except ValueError:
        return text.replace("$", r"\$")
    return text


def _unit_of(dataset: xr.Dataset, name: str) -> str:
    """Unit of a variable, exponents raised; empty for a pure number."""
    units = str(dataset[name].attrs.get("units", "")).strip()
    if units in ("", "1"):
        return ""
    return re.sub(r"(?:\*\*|\^)\{?(-?\d+)\}?", r"$^{\1}$", units).replace("*", r"$\,$")


def _with_unit(text: str, units: str) -> str:
    return f"{text}  ({units})" if units else text


def _time_label(dataset: xr.Dataset) -> str:
    return _with_unit("time  $t$", _unit_of(dataset, "time"))


def _chart(dataset: xr.Dataset, height: float, description: str) -> tuple[Figure, Axes]:
    """A figure with one plot against time."""
    figure = Figure(figsize=(WIDTH, height), layout="constrained")
    figure.set_label(f"{description}: {_title(dataset)}")
    axes = figure.add_subplot()
    axes.set_xlabel(_time_label(dataset))
    times = _times(dataset)
    if times[-1] > times[0]:
        axes.set_xlim(times[0], times[-1])
    axes.grid(axis="y", color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    return figure, axes


def _widen(axes: Axes, values: FloatArray) -> None:
    """Limits with room around the values, also around values that are alike but for rounding."""
    finite = values[np.isfinite(values)]
    if not len(finite):
        return
    low, high = float(finite.min()), float(finite.max())
    middle = max(abs(low), abs(high))
    room = max(0.06 * (high - low), 1e-3 * middle)
    if room < _NOTHING:
        room = 1.0
    axes.set_ylim(low - room, high + room)


def _legend_above(axes: Axes, columns: int) -> None:
    # On the right: the left end is where a power of ten common to the ticks is written.
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=columns)


# --------------------------------------------------------------------------- the sheet


class _Sheet:
    """A sheet of paper on which space is seen from `view`; later strokes cover earlier ones."""

    def __init__(self, axes: Axes, view: View) -> None:
        self.axes = axes
        self.view = view
        self._layer = 0.0
        axes.set_aspect("equal")

    def _next(self) -> float:
        self._layer += 1.0
        return self._layer

    def line(self, points: FloatArray, colour: str, width: float, style: str = "-") -> None:
        """Draw a curve through points (n, 3)."""
        x, y = self.view.project(points).T
        self.axes.plot(x, y, color=colour, linewidth=width, linestyle=style, zorder=self._next())

    def strokes(self, curves: Iterable[FloatArray], colour: str, width: float) -> None:
        """Draw many curves (n, 3) as one path."""
        flat = [self.view.project(curve) for curve in curves]
        if flat:
            path = Path.make_compound_path(*(Path(points) for points in flat))
            self.axes.add_patch(
                PathPatch(
                    path,
                    fill=False,
                    edgecolor=colour,
                    linewidth=width,
                    capstyle="round",
                    zorder=self._next(),
                )
            )

    def outline(self, corners: FloatArray, colour: str, width: float) -> None:
        """Draw a closed line through corners (k, 2) on paper."""
        self.axes.fill(
            *corners.T, fill=False, edgecolor=colour, linewidth=width, zorder=self._next()
        )

    def fill(self, corners: FloatArray, colour: str, alpha: float) -> None:
        """Fill a polygon with corners (k, 2) on paper, without an edge."""
        if len(corners) > 2:
            self.axes.fill(
                *corners.T, facecolor=colour, alpha=alpha, linewidth=0.0, zorder=self._next()
            )

    def glass(self, facets: Facets, colour: str, alpha: float) -> None:
        """Fill the union of facets evenly."""
        path = _polygons(self.view.project(facets.polygons))
        self.axes.add_patch(
            PathPatch(path, facecolor=colour, alpha=alpha, linewidth=0.0, zorder=self._next())
        )

    def facets(self, facets: Facets, tones: FloatArray, side: float, contrast: float) -> None:
        """Paint facets that do not cover each other, those of one shade together.

        `side` is 1 for their outer side, -1 for the inner.
        """
        colours = shaded(tones[facets.tones], side * facets.normals, self.view, contrast)
        shades, members = np.unique(np.round(colours * _SHADES), axis=0, return_inverse=True)
        corners = self.view.project(facets.polygons)
        layer = self._next()
        for number, shade in enumerate(shades / _SHADES):
            path = _polygons(corners[members == number])
            # A hairline of the facets' own colour covers the seams that smoothing would leave.
            self.axes.add_patch(
                PathPatch(
                    path,
                    facecolor=tuple(shade),
                    edgecolor=tuple(shade),
                    linewidth=0.3,
                    zorder=layer,
                )
            )

    def sphere(self, radius: float, side: float, border: FloatArray) -> None:
        """Shade a sphere, its near half from outside or its far half from inside.

        Only what lies inside `border`, corners (k, 2) on paper, is painted.
        """
        cut = Path(np.concatenate([border, border[:1]]), closed=True)
        for polygon, brightness in sphere_shades(radius, self.view, side, 28):
            colour = brightness * GROUND_LIGHT + (1.0 - brightness) * GROUND_DARK
            patch = PathPatch(
                Path(polygon), facecolor=tuple(colour), linewidth=0.0, zorder=self._next()
            )
            # Not add_patch: what is cut away must not count as drawn.
            self.axes.add_artist(patch)
            patch.set_clip_path(cut, self.axes.transData)

    def timed(self, points: FloatArray, fractions: FloatArray, width: float, alpha: float) -> None:
        """Draw a curve (n, 3) in the colours of time; fractions (n,) of the time gone by."""
        if len(points) < 2:
            return
        flat = self.view.project(points)
        pieces = np.unique(np.linspace(0, len(flat) - 1, min(len(flat), 97)).astype(int))
        pairs = list(pairwise(pieces))
        colours = TIME_COLOURS([(fractions[a] + fractions[b]) / 2 for a, b in pairs])
        paper = np.ones(4)
        self.axes.add_collection(
            LineCollection(
                [flat[a : b + 1] for a, b in pairs],
                colors=alpha * colours + (1.0 - alpha) * paper,
                linewidths=width,
                capstyle="round",
                zorder=self._next(),
            )
        )

    def label(self, point: FloatArray, text: str, colour: str) -> None:
        """Write a short text around a point (3,); it counts as drawn, lest it be cut off."""
        x, y = self.view.project(point)
        self.axes.text(
            x, y, text, ha="center", va="center", fontsize=11, color=colour, zorder=self._next()
        )
        self.axes.update_datalim([(x - 0.1, y - 0.1), (x + 0.1, y + 0.1)])

    def dot(self, point: FloatArray, face: str, edge: str, size: float) -> None:
        """Mark a point (3,)."""
        x, y = self.view.project(point)
        self.axes.plot(
            [x],
            [y],
            "o",
            markersize=size,
            markerfacecolor=face,
            markeredgecolor=edge,
            markeredgewidth=0.9,
            zorder=self._next(),
        )


def _polygons(corners: FloatArray) -> Path:
    """Polygons with corners (m, k, 2) as one path."""
    count, sides, _ = corners.shape
    closed = np.concatenate([corners, corners[:, :1]], axis=1)
    codes = np.full((count, sides + 1), Path.LINETO, dtype=np.uint8)
    codes[:, 0] = Path.MOVETO
    codes[:, -1] = Path.CLOSEPOLY
    return Path(closed.reshape(-1, 2), codes.ravel())


def _shown(curve: SurfaceCurve, view: View, side: float) -> list[FloatArray]:
    """Pieces of a curve on the outer (`side` 1) or inner (-1) side that the reader sees."""
    seen = view.faces_reader(side * curve.normals)
    return [curve.points[run] for run in runs(seen[1:] & seen[:-1])]


def _timed_on_surface(
    sheet: _Sheet,
    curve: SurfaceCurve,
    fractions: FloatArray,
    side: float,
    width: float,
    alpha: float,
) -> None:
    """Draw, in the colours of time, what the reader sees of a curve on one side of a surface."""
    seen: BoolArray = sheet.view.faces_reader(side * curve.normals)
    for run in runs(seen[1:] | seen[:-1]):
        sheet.timed(curve.points[run], fractions[run], width, alpha)


def _time_bar(
    figure: Figure, dataset: xr.Dataset, span: tuple[float, float], place: tuple[float, float]
) -> None:
    """The colours of time between its first and last instant; `place` in inches, lower left."""
    width, height = figure.get_size_inches()
    units = _unit_of(dataset, "time")
    first, last = f"$t$ = {span[0]:.3g}", f"{span[1]:.3g} {units}".rstrip()
    left, bottom = place
    # Figures of the type are 0.06 inches wide.
    left += 0.06 * len(first)
    axes = figure.add_axes((left / width, bottom / height, 1.5 / width, 0.055 / height))
    edges = np.linspace(0.0, 1.0, 49)
    colours = TIME_COLOURS((edges[:-1] + edges[1:]) / 2)
    axes.add_collection(
        PolyCollection(
            [[(a, 0.0), (b, 0.0), (b, 1.0), (a, 1.0)] for a, b in pairwise(edges)],
            facecolors=colours,
            edgecolors=colours,
            linewidths=0.2,
        )
    )
    axes.set_xlim(0.0, 1.0)
    axes.set_ylim(0.0, 1.0)
    axes.set_axis_off()
    note: dict[str, Any] = {
        "xycoords": "axes fraction",
        "textcoords": "offset points",
        "fontsize": 9,
        "va": "center",
    }
    axes.annotate(first, (0.0, 0.4), (-5, 0), ha="right", **note)
    axes.annotate(last, (1.0, 0.4), (5, 0), ha="left", **note)


def _mark_ends(sheet: _Sheet, curve: SurfaceCurve, side: float) -> None:
    """Mark the start of a curve by a ring and its end by a dot, pale where they are hidden."""
    start, end = (bool(seen) for seen in sheet.view.faces_reader(side * curve.normals[[0, -1]]))
    last = to_hex(TIME_COLOURS(1.0))
    sheet.dot(curve.points[0], "white" if start else "none", INK if start else QUIET, 4.5)
    sheet.dot(curve.points[-1], last if end else "#b3aabd", last if end else "#b3aabd", 4.5)


def _fractions(times: FloatArray, since: float | None = None) -> FloatArray:
    """Share of the time that has gone by at each instant, from `since` or the first to the last."""
    start = float(times[0]) if since is None else since
    span = float(times[-1]) - start
    return (times - start) / span if span > 0.0 else np.ones_like(times)


def _round_number(size: float) -> float:
    """The number 1, 2 or 5 times a power of ten that is next below `size`."""
    power = 10.0 ** np.floor(np.log10(size))
    return float(max(step for step in (1.0, 2.0, 5.0) if step * power <= size * (1 + 1e-9)) * power)


# --------------------------------------------------------------------------- scene


@dataclass(frozen=True, eq=False)
class _Track:
    """The last stretch of a rolling body's way that fits into a picture.

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

    def path(self, ground: Ground) -> tuple[FloatArray, SurfaceCurve]:
        """Times, and the path of the contact on the ground, smooth."""
        times, points = smooth_curve(self.times, self.contact, _CURVE_POINTS)
        return times, _on_ground(points, ground)

    def trace(self, hollow: bool, longest: float) -> tuple[FloatArray, SurfaceCurve]:
        """Times, and the path of the contact on the body as it lies at the end, smooth.

        Only its last part is given, of length `longest` at most.
        """
        body = np.einsum("nji,nj->ni", self.rotation, self.contact - self.centre)
        outward = self.normal if hollow else -self.normal
        times, both = smooth_curve(self.times, np.hstack([body, outward]), _CURVE_POINTS)
        lengths = np.linalg.norm(np.diff(both[:, :3], axis=0), axis=1)
        recent = np.append(np.cumsum(lengths[::-1])[::-1], 0.0) <= longest
        times, both = times[recent], both[recent]
        turn = self.rotation[-1].T
        return times, SurfaceCurve(both[:, :3] @ turn + self.centre[-1], unit(both[:, 3:]) @ turn)


def _on_ground(points: FloatArray, ground: Ground) -> SurfaceCurve:
    """A curve laid exactly on the ground."""
    if isinstance(ground, PlaneGround):
        return SurfaceCurve(points, np.tile([0.0, 0.0, 1.0], (len(points), 1)))
    normals = unit(points)
    return SurfaceCurve(abs(ground.radius) * normals, normals)


def _track(dataset: xr.Dataset, figure: str, reach: float, until: float | None) -> _Track:
    _require(dataset, figure)
    times = _times(dataset)
    contact = _values(dataset, "contact")
    attitude = _values(dataset, "attitude")
    good = np.isfinite(contact).all(axis=1) & np.isfinite(attitude).all(axis=1)
    if until is not None:
        good &= times <= until
    chosen = np.flatnonzero(good)
    if not len(chosen):
        raise InputError(f"the figure {figure} has no sample to show of {_title(dataset)}")
    backwards = contact[chosen[::-1]]
    low = np.minimum.accumulate(backwards, axis=0)
    high = np.maximum.accumulate(backwards, axis=0)
    within = int(np.sum(np.max(high - low, axis=1) <= reach))
    chosen = chosen[len(chosen) - max(within, 1) :]
    return _Track(
        times[chosen],
        contact[chosen],
        _values(dataset, "centre")[chosen],
        rotation_matrices(attitude[chosen]),
        _values(dataset, "gamma")[chosen],
    )


def scene(
    dataset: xr.Dataset, outline: Outline, surface: Ground, until: float | None = None
) -> Figure:
    """The body on the surface it rolls on, with the paths of the contact point on both.

    The body is drawn where it is at the end, the path in the colours of time. A path too long
    for the picture is cut to its last part; the bar tells which.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `contact`, `centre`, `attitude` and `gamma`.
    outline : Outline
        Shape of the body, body axes.
    surface : PlaneGround or SphereGround
    until : float, optional
        Instant at which the body is drawn, in units of `time`; by default the last.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks a variable, or has no sample up to `until`.
    """
    reach = _REACH * outline.diameter if isinstance(surface, PlaneGround) else np.inf
    track = _track(dataset, "scene", reach, until)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, WIDTH))
        figure.set_label(f"The body and the path of its contact point: {_title(dataset)}")
        sheet = _Sheet(_blank(figure), _scene_view(track, surface))
        body = outline.placed(track.rotation[-1], track.centre[-1])
        if isinstance(surface, PlaneGround):
            spacing = _scene_on_plane(sheet, track, outline, body)
            note = f"grid {spacing:g} {_unit_of(dataset, 'contact')}".rstrip()
        else:
            note = ""
            if body.hollow:
                _scene_around_sphere(sheet, track, body, surface)
            elif surface.radius > 0.0:
                _scene_on_sphere(sheet, track, body, surface)
            else:
                _scene_in_bowl(sheet, track, body, surface)
        _trim(figure, sheet.axes, WIDTH, 5.0)
        _time_bar(figure, dataset, (track.times[0], track.times[-1]), (0.12, 0.16))
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


def _blank(figure: Figure) -> Axes:
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    return axes


def _trim(figure: Figure, axes: Axes, width: float, tallest: float) -> None:
    """Fit the figure's height to what is drawn, with a footer for the bar of time."""
    box = axes.dataLim
    margin, footer = 0.1, 0.36
    scale = min((width - 2 * margin) / box.width, (tallest - 2 * margin) / box.height)
    height = box.height * scale + 2 * margin
    figure.set_size_inches(width, height + footer)
    axes.set_position((0.0, footer / (height + footer), 1.0, height / (height + footer)))
    middle = ((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)
    axes.set_xlim(middle[0] - width / scale / 2, middle[0] + width / scale / 2)
    axes.set_ylim(middle[1] - height / scale / 2, middle[1] + height / scale / 2)


def _scene_view(track: _Track, ground: Ground) -> View:
    """Where the reader stands: paths run from left to right, the body is on the near side."""
    end = track.contact[-1]
    if isinstance(ground, PlaneGround):
        return _plane_view(track.contact)
    middle = unit(unit(track.contact).mean(axis=0) + 0.8 * unit(end))
    height = float(np.arcsin(np.clip(middle[2], -1.0, 1.0)))
    near_pole = np.hypot(middle[0], middle[1]) < 0.35
    azimuth = (
        _across(track.contact) if near_pole else float(np.arctan2(middle[1], middle[0])) + 0.35
    )
    if ground.radius > 0.0:
        return View(azimuth, float(np.clip(0.6 * height, -0.25, 0.6)))
    return View(azimuth + (0.0 if near_pole else np.pi), 0.62 if height < -0.3 else 0.35)


def _plane_view(contact: FloatArray) -> View:
    """A view slightly along the path, such that the body's last steps go across the picture."""
    azimuth = _across(contact)
    back = np.linalg.norm(contact - contact[-1], axis=1)
    last = contact[-1] - contact[np.argmax(back <= 0.15 * np.max(back))]
    views = [View(azimuth + turn, 0.5) for turn in (0.42, -0.42)]
    # With the body on the near side, unless that shows the end of the path from its end.
    return min(views, key=lambda view: abs(view.depth(unit(last))) - 0.1 * view.depth(unit(last)))


def _across(points: FloatArray) -> float:
    """Azimuth from which points (n, 3) extend most from left to right, the last one right."""
    flat = points[:, :2] - points[:, :2].mean(axis=0)
    along = np.linalg.svd(flat, full_matrices=False)[2][0] if np.any(flat) else np.array([0.0, 1.0])
    if along @ (points[-1, :2] - points[0, :2]) < 0.0:
        along = -along
    return float(np.arctan2(-along[0], along[1]))


def _lamp(view: View) -> FloatArray:
    """Direction of the light that casts shadows: that of the view, but steep."""
    return unit(0.45 * view.light + np.array([0.0, 0.0, 1.0]))


def _draw_shadow(sheet: _Sheet, body: Outline, ground: Ground) -> None:
    """A shadow with soft borders: many lamps close to each other, each with a faint one."""
    lamp = _lamp(sheet.view)
    lamps = 40
    for number in range(lamps):
        angle, distance = 2.399963 * number, 0.22 * np.sqrt((number + 0.5) / lamps)
        offset = distance * (np.cos(angle) * sheet.view.right + np.sin(angle) * sheet.view.up)
        shadow = cast_shadow(body.vertices, ground, unit(lamp + offset))
        if isinstance(ground, SphereGround) and len(shadow):
            shadow = cut_by_plane(shadow, np.copysign(1.0, ground.radius) * sheet.view.toward)
        sheet.fill(sheet.view.project(shadow), "#1b2a3a", 0.0105)


def _draw_body(sheet: _Sheet, body: Outline, track: _Track) -> None:
    """The near side of the body with its seams, its border and the path traced on it."""
    facets = body.facets
    sheet.facets(facets.select(facets.faces_reader(sheet.view)), BODY_TONES, 1.0, 0.5)
    seams = [piece for seam in body.seams for piece in _shown(seam, sheet.view, 1.0)]
    sheet.strokes(seams, "#3d5a76", 0.45)
    times, trace = track.trace(body.hollow, _TRACE * body.diameter)
    _timed_on_surface(sheet, trace, _fractions(times, track.times[0]), 1.0, 1.4, 1.0)
    _draw_border(sheet, body, "#2c3e50", 0.6)


def _draw_border(sheet: _Sheet, body: Outline, colour: str, width: float) -> None:
    sheet.outline(convex_hull(sheet.view.project(body.vertices)), colour, width)


def _draw_ghosts(sheet: _Sheet, track: _Track, outline: Outline) -> None:
    """Pale bodies at earlier places, as far as they stand clear of each other and of the last."""
    apart = 1.25 * outline.diameter
    places = [len(track.times) - 1]
    middle = track.centre + track.rotation @ outline.vertices.mean(axis=0)
    flat = sheet.view.project(middle)
    for index in range(len(track.times) - 1, -1, -1):
        if np.min(np.linalg.norm(flat[places] - flat[index], axis=1)) > apart:
            places.append(index)
        if len(places) == 5:
            break
    for index in sorted(places[1:], key=lambda i: float(sheet.view.depth(middle[i]))):
        ghost = outline.placed(track.rotation[index], track.centre[index])
        border = convex_hull(sheet.view.project(ghost.vertices))
        sheet.fill(border, "#eef2f6", 0.85)
        seams = [piece for seam in ghost.seams for piece in _shown(seam, sheet.view, 1.0)]
        sheet.strokes(seams, "#cfd9e3", 0.5)
        sheet.outline(border, "#b5c2cf", 0.6)


def _scene_on_plane(sheet: _Sheet, track: _Track, outline: Outline, body: Outline) -> float:
    """Draw grid, shadow, paths and body; give the spacing of the grid."""
    times, path = track.path(PlaneGround())
    spacing = _draw_grid(sheet, path.points, outline.diameter)
    _draw_ghosts(sheet, track, outline)
    sheet.timed(path.points, _fractions(times), 2.0, 1.0)
    sheet.dot(path.points[0], "white", INK, 4.0)
    _draw_shadow(sheet, body, PlaneGround())
    _draw_body(sheet, body, track)
    return spacing


def _draw_grid(sheet: _Sheet, path: FloatArray, diameter: float) -> float:
    """A square grid on the plane that fades with the distance from the path."""
    near = path[:: max(1, len(path) // 150), :2]
    fade = 0.85 * diameter
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


def _opening(path: FloatArray, pole: float, room: float, widest: float) -> float:
    """Angle from the pole to the rim of a cap with room around the path; pi: whole sphere."""
    farthest = float(np.max(np.arccos(np.clip(pole * unit(path)[:, 2], -1.0, 1.0))))
    return farthest + room if farthest + room < widest else np.pi


def _graticule(radius: float, pole: float, opening: float) -> list[SurfaceCurve]:
    """Parallels and meridians of a cap."""
    step = np.radians(15.0 if opening > 0.8 else 5.0)
    polar = np.arange(step, opening - 1e-6, step)
    curves = []
    around = np.linspace(0.0, 2 * np.pi, 145)
    for angle in polar:
        curves.append(_sphere_points(np.full_like(around, angle), around, pole))
    # Meridians end short of the pole, where they would crowd.
    along = np.linspace(step, opening if opening < np.pi else np.pi - step, 73)
    for azimuth in np.arange(24) * np.pi / 12:
        curves.append(_sphere_points(along, np.full_like(along, azimuth), pole))
    return [SurfaceCurve(radius * normals, normals) for normals in curves]


def _sphere_points(polar: FloatArray, azimuth: FloatArray, pole: float) -> FloatArray:
    return np.stack(
        [np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), pole * np.cos(polar)],
        axis=-1,
    )


def _limb(view: View, radius: float) -> FloatArray:
    """The border of a whole sphere."""
    angle = np.linspace(0.0, 2 * np.pi, 181)[:, None]
    return radius * (np.cos(angle) * view.right + np.sin(angle) * view.up)


def _rim(radius: float, pole: float, opening: float) -> SurfaceCurve:
    around = np.linspace(0.0, 2 * np.pi, 181)
    normals = _sphere_points(np.full_like(around, opening), around, pole)
    return SurfaceCurve(radius * normals, normals)


def _cap_border(view: View, radius: float, pole: float, opening: float) -> FloatArray:
    """The border on paper of a cap seen from the side of its rim, or of a whole sphere."""
    cap = sphere_cap(radius, pole, opening, 24, 90)
    whole = _limb(view, radius) if opening == np.pi else cap.polygons.reshape(-1, 3)
    return convex_hull(view.project(whole))


def _draw_outside(sheet: _Sheet, radius: float, opening: float) -> None:
    """A sphere, or a cap of it around the top, seen from outside."""
    border = _cap_border(sheet.view, radius, 1.0, opening)
    sheet.sphere(radius, 1.0, border)
    lines = [
        piece
        for curve in _graticule(radius, 1.0, opening)
        for piece in _shown(curve, sheet.view, 1.0)
    ]
    sheet.strokes(lines, LINES, 0.3)
    sheet.outline(border, "#8796a4", 0.6)


def _scene_on_sphere(sheet: _Sheet, track: _Track, body: Outline, ground: SphereGround) -> None:
    times, path = track.path(ground)
    fractions = _fractions(times)
    room = max(0.12, 0.75 * body.diameter / ground.radius)
    in_front = bool(sheet.view.faces_reader(path.normals[-1]))
    # The plane of contact parts body and sphere: the reader's side of it hides the other.
    if not in_front:
        _draw_body(sheet, body, track)
    _draw_outside(sheet, ground.radius, _opening(path.points, 1.0, room, 1.2))
    _timed_on_surface(sheet, path, fractions, -1.0, 1.0, 0.35)
    _timed_on_surface(sheet, path, fractions, 1.0, 2.0, 1.0)
    sheet.dot(path.points[0], "white", INK, 4.0)
    if in_front:
        _draw_shadow(sheet, body, ground)
        _draw_body(sheet, body, track)
    else:
        _draw_border(sheet, body, "#b5c2cf", 0.6)


def _draw_far_wall(sheet: _Sheet, radius: float, opening: float) -> None:
    """The inside of the far wall of a bowl."""
    sheet.sphere(radius, -1.0, _cap_border(sheet.view, radius, -1.0, opening))
    lines = [
        piece
        for curve in _graticule(radius, -1.0, opening)
        for piece in _shown(curve, sheet.view, -1.0)
    ]
    sheet.strokes(lines, LINES, 0.3)


def _draw_near_wall(sheet: _Sheet, radius: float, opening: float) -> None:
    """The near wall of a bowl, as of glass, and its rim."""
    if opening < np.pi:
        bowl = sphere_cap(radius, -1.0, opening, 20, 64)
        sheet.glass(bowl.select(bowl.faces_reader(sheet.view)), "#8fa6bb", 0.2)
        sheet.strokes([_rim(radius, -1.0, opening).points], "#73838f", 0.7)
    sheet.outline(_cap_border(sheet.view, radius, -1.0, opening), "#8796a4", 0.6)


def _scene_in_bowl(sheet: _Sheet, track: _Track, body: Outline, ground: SphereGround) -> None:
    radius = abs(ground.radius)
    times, path = track.path(ground)
    fractions = _fractions(times)
    opening = _opening(path.points, -1.0, 0.3, 1.75)
    _draw_far_wall(sheet, radius, opening)
    _timed_on_surface(sheet, path, fractions, -1.0, 2.0, 1.0)
    _draw_shadow(sheet, body, ground)
    _draw_body(sheet, body, track)
    _draw_near_wall(sheet, radius, opening)
    _timed_on_surface(sheet, path, fractions, 1.0, 1.2, 0.55)
    sheet.dot(path.points[0], "white", INK, 4.0)


def _scene_around_sphere(sheet: _Sheet, track: _Track, body: Outline, ground: SphereGround) -> None:
    """A shell with the sphere inside: its far half, the sphere, and its near half of glass."""
    times, path = track.path(ground)
    fractions = _fractions(times)
    facets = body.facets
    near = facets.faces_reader(sheet.view)
    sheet.facets(facets.select(~near), SHELL_TONES, -1.0, 0.3)
    seams = [piece for seam in body.seams for piece in _shown(seam, sheet.view, -1.0)]
    sheet.strokes(seams, "#8496a8", 0.45)
    instants, trace = track.trace(body.hollow, _TRACE * body.diameter)
    _timed_on_surface(sheet, trace, _fractions(instants, track.times[0]), -1.0, 1.3, 0.8)
    _draw_outside(sheet, abs(ground.radius), np.pi)
    _timed_on_surface(sheet, path, fractions, -1.0, 1.0, 0.35)
    _timed_on_surface(sheet, path, fractions, 1.0, 2.0, 1.0)
    sheet.dot(path.points[0], "white", INK, 4.0)
    sheet.glass(facets.select(near), "#8fa6bb", 0.12)
    seams = [piece for seam in body.seams for piece in _shown(seam, sheet.view, 1.0)]
    sheet.strokes(seams, "#8496a8", 0.6)
    _draw_border(sheet, body, "#2c3e50", 0.7)


# --------------------------------------------------------------------------- paths


def contact_path(dataset: xr.Dataset, surface: Ground) -> Figure:
    """The path of the contact point on the surface, in the colours of time.

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
    """
    _require(dataset, "contact_path")
    contact = _values(dataset, "contact")
    good = np.isfinite(contact).all(axis=1)
    if not np.any(good):
        raise InputError(f"the figure contact_path has no sample to show of {_title(dataset)}")
    samples = _times(dataset)[good]
    times, points = smooth_curve(samples, contact[good], _CURVE_POINTS)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.0))
        figure.set_label(f"Path of the contact point: {_title(dataset)}")
        if isinstance(surface, PlaneGround):
            _path_on_plane(figure, dataset, times, points)
        else:
            _path_on_sphere(figure, times, points, surface)
        _time_bar(figure, dataset, (samples[0], samples[-1]), (0.62, 0.16))
    return figure


def _path_on_plane(
    figure: Figure, dataset: xr.Dataset, times: FloatArray, points: FloatArray
) -> None:
    low, high = points[:, :2].min(axis=0), points[:, :2].max(axis=0)
    extent = float(np.max(high - low))
    middle = (low + high) / 2
    left, right, bottom, top = 0.62, 0.12, 0.86, 0.12
    wide = WIDTH - left - right
    size = np.maximum(high - low, 0.05 * extent) if extent > _NOTHING else np.array([2.0, 1.0])
    tall = float(np.clip(wide * size[1] / size[0], 1.6, 4.4))
    figure.set_size_inches(WIDTH, tall + bottom + top)
    height = figure.get_figheight()
    axes = figure.add_axes((left / WIDTH, bottom / height, wide / WIDTH, tall / height))
    half = 1.12 / 2 * max(size[0], size[1] * wide / tall)
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half * tall / wide, middle[1] + half * tall / wide)
    axes.grid(color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    units = _unit_of(dataset, "contact")
    axes.set_xlabel(_with_unit("$x$", units))
    axes.set_ylabel(_with_unit("$y$", units))
    from_above = View(-np.pi / 2, np.pi / 2)
    sheet = _Sheet(axes, from_above)
    sheet.timed(points, _fractions(times), 1.6, 1.0)
    _mark_ends(sheet, _on_ground(points, PlaneGround()), 1.0)


def _path_on_sphere(
    figure: Figure, times: FloatArray, points: FloatArray, ground: SphereGround
) -> None:
    side = float(np.copysign(1.0, ground.radius))
    radius = abs(ground.radius)
    curve = _on_ground(points, ground)
    middle = unit(curve.normals.mean(axis=0))
    azimuth = float(np.arctan2(middle[1], middle[0])) + 0.35
    height = float(np.arcsin(np.clip(middle[2], -1.0, 1.0)))
    view = View(azimuth + (np.pi if side < 0 else 0.0), float(np.clip(side * height, 0.3, 1.0)))
    sheet = _Sheet(_blank(figure), view)
    fractions = _fractions(times)
    if side > 0:
        _draw_outside(sheet, radius, np.pi)
    else:
        _draw_far_wall(sheet, radius, np.pi)
        _draw_near_wall(sheet, radius, np.pi)
    _timed_on_surface(sheet, curve, fractions, -side, 1.0, 0.4)
    _timed_on_surface(sheet, curve, fractions, side, 1.8, 1.0)
    _mark_ends(sheet, curve, side)
    _trim(figure, sheet.axes, 4.2, 4.2)


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
    """
    _require(dataset, "normal_on_sphere")
    gamma = _values(dataset, "gamma")
    good = np.isfinite(gamma).all(axis=1)
    if not np.any(good):
        raise InputError(f"the figure normal_on_sphere has no sample to show of {_title(dataset)}")
    samples = _times(dataset)[good]
    times, points = smooth_curve(samples, gamma[good], _CURVE_POINTS)
    normals = unit(points)
    curve = SurfaceCurve(normals, normals)
    fractions = _fractions(times)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(4.2, 4.2))
        figure.set_label(f"Path of the surface normal in body axes: {_title(dataset)}")
        sheet = _Sheet(_blank(figure), _view_of_most(normals))
        _draw_axes(sheet, behind=True)
        _draw_outside(sheet, 1.0, np.pi)
        _timed_on_surface(sheet, curve, fractions, -1.0, 1.0, 0.4)
        _draw_axes(sheet, behind=False)
        _timed_on_surface(sheet, curve, fractions, 1.0, 1.8, 1.0)
        _mark_ends(sheet, curve, 1.0)
        _trim(figure, sheet.axes, 4.2, 4.4)
        _time_bar(figure, dataset, (samples[0], samples[-1]), (0.62, 0.16))
    return figure


def _view_of_most(normals: FloatArray) -> View:
    """Of eight views, one from the middle of each octant, that which shows most of a curve."""
    views = [
        View(np.radians(azimuth), elevation)
        for azimuth in (42.0, 132.0, 222.0, 312.0)
        for elevation in (0.38, -0.38)
    ]
    return max(views, key=lambda view: float(np.mean(normals @ view.toward)))


def _draw_axes(sheet: _Sheet, behind: bool) -> None:
    """The three body axes outside the unit sphere, those that point away or towards the reader."""
    for axis, direction in enumerate(np.eye(3)):
        if bool(sheet.view.depth(direction) < 0.0) == behind:
            colour = "#a3afba" if behind else "#56636f"
            sheet.line(np.stack([direction, 1.46 * direction]), colour, 0.8)
            sheet.label(1.6 * direction, rf"$\gamma_{axis + 1}$", QUIET if behind else INK)


# --------------------------------------------------------------------------- against time


def angular_velocity(dataset: xr.Dataset) -> Figure:
    """Components of the angular velocity in body axes, and its length, against time.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `omega`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks omega.
    """
    _require(dataset, "angular_velocity")
    times, omega = _times(dataset), _values(dataset, "omega")
    with mpl.rc_context(STYLE):
        figure, axes = _chart(dataset, 2.9, "Angular velocity in body axes")
        length = np.linalg.norm(omega, axis=1)
        for axis, colour in enumerate(COMPONENTS):
            axes.plot(times, omega[:, axis], color=colour, label=rf"$\omega_{axis + 1}$")
        axes.plot(
            times, length, color=INK, linewidth=0.8, linestyle=(0, (4, 2)), label=r"$|\omega|$"
        )
        axes.axhline(0.0, color=QUIET, linewidth=0.6, zorder=1)
        axes.set_ylabel(_with_unit("angular velocity", _unit_of(dataset, "omega")))
        _widen(axes, np.concatenate([omega.ravel(), length]))
        _legend_above(axes, 4)
    return figure


def normal_force(dataset: xr.Dataset, weight: float | None = None) -> Figure:
    """The pressure of the surface on the body against time.

    Where it is negative the surface would have to pull: the body would leave it. Such times are
    shaded.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `normal_force`.
    weight : float, optional
        Weight of the body, drawn for comparison, in the unit of the force.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks the normal force.
    """
    _require(dataset, "normal_force")
    times, force = _times(dataset), _values(dataset, "normal_force")
    with mpl.rc_context(STYLE):
        figure, axes = _chart(dataset, 2.6, "Normal force")
        axes.plot(times, force, color=COMPONENTS[0], label="normal force  $N$", zorder=3)
        reference = [0.0]
        if weight is not None:
            axes.axhline(
                weight,
                color=QUIET,
                linewidth=0.9,
                linestyle=(0, (5, 3)),
                label="weight  $mg$",
                zorder=2,
            )
            reference.append(weight)
        axes.axhline(0.0, color=INK, linewidth=0.8, zorder=2)
        _widen(axes, np.concatenate([force, reference]))
        low, high = axes.get_ylim()
        if np.nanmin(force, initial=0.0) < 0.0:
            axes.axhspan(low, 0.0, facecolor=ALARM, alpha=0.08, linewidth=0.0, zorder=0)
            axes.fill_between(
                times,
                force,
                0.0,
                where=list(force < 0.0),
                interpolate=True,
                facecolor=ALARM,
                alpha=0.35,
                linewidth=0.0,
                zorder=2,
                label="contact would be lost",
            )
        else:
            axes.set_ylim(0.0, high)
        axes.set_ylabel(_with_unit("normal force", _unit_of(dataset, "normal_force")))
        _legend_above(axes, 3)
    return figure


def relative_drift(dataset: xr.Dataset, name: str) -> FloatArray:
    """How far a conserved quantity has moved from its first value, relative to that value.

    A quantity that starts nearer to zero than 1e-9 has no scale of its own; its drift is given
    as it is. Trajectories of 34 digits count with all of them.

    Parameters
    ----------
    dataset : xarray.Dataset
    name : str
        Variable with the values of the quantity, and `<name>_low` with their low parts, if any.

    Returns
    -------
    (n,) array
        |F(t) - F(0)| / |F(0)|, or |F(t) - F(0)|.
    """
    values = _values(dataset, name)
    change = values - values[0]
    if f"{name}_low" in dataset:
        low = _values(dataset, f"{name}_low")
        change = change + (low - low[0])
    return np.asarray(np.abs(change) / _scale(values), dtype=np.float64)


def _scale(values: FloatArray) -> float:
    first = abs(float(values[0]))
    return first if first > _NOTHING else 1.0


def _conserved(dataset: xr.Dataset) -> list[str]:
    """Variables that ought to stay constant, energy first."""
    laws = sorted(
        str(name)
        for name in dataset.data_vars
        if str(name).startswith("law_") and not str(name).endswith("_low")
    )
    if "law_energy" in laws:
        laws.remove("law_energy")
        return ["law_energy", *laws]
    return ["energy", *laws] if "energy" in dataset else laws


def drift(dataset: xr.Dataset) -> Figure:
    """Relative drift of the energy and of each integral against time, on a logarithmic scale.

    Dots are samples (some hundreds of them), lines the largest drift so far. Samples that agree
    with the first one to the last bit lie on the line marked 0 at the foot.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `energy` or at least one variable `law_<name>`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset has nothing that is conserved.
    """
    names = _conserved(dataset)
    if not names:
        raise InputError(
            f"the figure drift needs energy or an integral, and the trajectory of "
            f"{_title(dataset)} has neither"
        )
    times = _times(dataset)
    drifts = {name: relative_drift(dataset, name) for name in names}
    positive = np.concatenate([values[values > 0.0] for values in drifts.values()])
    smallest = float(positive.min()) if len(positive) else 1e-16
    floor = 1e-17 if smallest > 1e-17 else 10.0 ** (np.floor(np.log10(smallest)) - 1.0)
    with mpl.rc_context(STYLE):
        labels = {name: _law_label(dataset, name) for name in names}
        columns = 2 if max(map(len, labels.values())) < 50 else 1
        rows = -(-len(names) // columns)
        figure, axes = _chart(dataset, 2.7 + 0.19 * rows, "Drift of the conserved quantities")
        axes.set_yscale("log")
        every = max(1, len(times) // _DOTS)
        for number, (name, values) in enumerate(drifts.items()):
            colour = SERIES[number % len(SERIES)]
            shown = np.where(values > 0.0, values, floor)
            axes.plot(
                times[::every],
                shown[::every],
                ".",
                color=colour,
                markersize=2.2,
                alpha=0.5,
                markeredgewidth=0.0,
                zorder=2,
            )
            axes.plot(
                times,
                np.fmax.accumulate(shown),
                color=colour,
                label=labels[name],
                linewidth=1.3,
                zorder=3,
            )
        largest = float(positive.max()) if len(positive) else floor
        axes.set_ylim(floor / 2.5, max(10.0 * largest, 100.0 * floor))
        axes.axhline(floor, color=QUIET, linewidth=0.6, zorder=1)
        _mark_floor(axes, floor)
        axes.set_ylabel("relative drift")
        _legend_above(axes, columns)
    return figure


def _law_label(dataset: xr.Dataset, name: str) -> str:
    meaning = str(dataset[name].attrs.get("long_name", "")) or name.removeprefix("law_")
    absolute = _scale(_values(dataset, name)) == 1.0 != abs(float(_values(dataset, name)[0]))
    return _readable(meaning) + ("  (absolute)" if absolute else "")


def _mark_floor(axes: Axes, floor: float) -> None:
    """Ticks at powers of ten above the floor, and a tick 0 at the floor."""
    low, high = np.log10(floor), np.log10(axes.get_ylim()[1])
    step = max(1, int(np.ceil((high - low) / 7)))
    powers = np.arange(np.ceil(low) + step, high + 1e-9, step)
    axes.set_yticks([floor, *10.0**powers], ["0", *(f"$10^{{{int(power)}}}$" for power in powers)])
    axes.set_yticks([], minor=True)


# --------------------------------------------------------------------------- all, and to files


def all_figures(
    dataset: xr.Dataset,
    drawn: tuple[Outline, Ground] | None = None,
    weight: float | None = None,
) -> dict[str, Figure]:
    """Every figure the trajectory has the variables for.

    Parameters
    ----------
    dataset : xarray.Dataset
    drawn : tuple of Outline and PlaneGround or SphereGround, optional
        Shape of the body and what it rolls on; without them there is neither scene nor path of
        the contact point.
    weight : float, optional
        Weight of the body, for comparison with the normal force.

    Returns
    -------
    dict
        Figures by the names of the functions that make them: `scene`, `contact_path`,
        `normal_on_sphere`, `angular_velocity`, `normal_force`, `drift`, in this order.
    """
    possible = {name for name, needed in _NEEDED.items() if all(item in dataset for item in needed)}
    figures: dict[str, Figure] = {}
    if "scene" in possible and drawn is not None:
        figures["scene"] = scene(dataset, *drawn)
    if "contact_path" in possible and drawn is not None:
        figures["contact_path"] = contact_path(dataset, drawn[1])
    if "normal_on_sphere" in possible:
        figures["normal_on_sphere"] = normal_on_sphere(dataset)
    if "angular_velocity" in possible:
        figures["angular_velocity"] = angular_velocity(dataset)
    if "normal_force" in possible:
        figures["normal_force"] = normal_force(dataset, weight)
    if _conserved(dataset):
        figures["drift"] = drift(dataset)
    return figures


def save(figure: Figure, path: str | FilePath) -> FilePath:
    """Write a figure to a file, in the format its name ends with; the same bits every time.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
    path : str or Path
        Name ending in .png, .svg or .pdf.

    Returns
    -------
    pathlib.Path
        The file.

    Raises
    ------
    InputError
        If the ending is another one, or the file cannot be written.
    """
    target = FilePath(path)
    suffix = target.suffix.lower()
    if suffix not in FORMATS:
        raise InputError(
            f"{target}: a figure is written as {', '.join(FORMATS)}; the file name must end so"
        )
    try:
        with mpl.rc_context(STYLE):
            figure.savefig(target, format=suffix[1:], dpi=220, metadata=FORMATS[suffix])
    except OSError as problem:
        raise InputError(f"{target} cannot be written: {problem.strerror or problem}") from problem
    return target


def svg_text(figure: Figure) -> str:
    """A figure as an SVG element to be put into an HTML page.

    No prolog, no style sheet that would reach the rest of the page, text as shapes, and ids that
    belong to this figure alone; the same text every time.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Its label becomes the description for those who cannot see it.
    """
    stream = io.StringIO()
    with mpl.rc_context(STYLE):
        figure.savefig(stream, format="svg", metadata=FORMATS[".svg"])
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>|<!--.*?-->", "", text, flags=re.S)
    description = str(figure.get_label())
    text = text.replace(
        "<svg ",
        f'<svg role="img" aria-label={quoteattr(description)} '
        'style="stroke-linejoin: round; stroke-linecap: butt" ',
        1,
    )
    text = re.sub(r' d="[^"]*"', _rounded, text)
    return _own_ids(re.sub(r"\n\s*", "\n", text))


def _rounded(path: re.Match[str]) -> str:
    """Coordinates of a path to a hundredth of a point, finer than any paper."""
    return re.sub(
        r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", path[0].replace("\n", "")
    )


def _own_ids(svg: str) -> str:
    """Drop ids nothing refers to, and prefix the others with a mark of the whole text."""
    mark = "f" + hashlib.sha256(svg.encode()).hexdigest()[:10]
    used = set(re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', svg))
    names = {first or second for first, second in used}

    def renamed(found: re.Match[str]) -> str:
        return f' id="{mark}-{found[1]}"' if found[1] in names else ""

    svg = re.sub(r' id="([^"]*)"', renamed, svg)
    return re.sub(r'(href="#|url\(#)', rf"\1{mark}-", svg)
