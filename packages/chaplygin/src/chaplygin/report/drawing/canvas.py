"""A sheet on which space is drawn, stroke by stroke."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import Any, Protocol

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PathCollection, PolyCollection
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from flowlanes.system.arrays import BoolArray, FloatArray

from ...geometry.mesh import Facets, SurfaceCurve
from ...geometry.view import View
from .curves import runs
from .dataset_access import unit_of
from .shading import shaded_colours, sphere_shades
from .style import GROUND_DARK, GROUND_LIGHT, INK, QUIET, TIME_COLOURS

_SHADES = 160
"""Number of grey levels in the shading of a body."""

_TIME_STEPS = 96
"""Number of colours on a curve from its first to its last time."""


class PathColours(Protocol):
    """The colours of a path as a function of the fraction of elapsed time."""

    def __call__(self, shares: float | list[float]) -> Any:
        """The colour (4,) at a fraction, or colours (n, 4) at several."""

    def pieces(self, shares: FloatArray) -> FloatArray:
        """Indices of the first and last points of stretches with one colour."""


class _TimeColours:
    """The colours of time."""

    def __call__(self, shares: float | list[float]) -> Any:
        return TIME_COLOURS(shares)

    def pieces(self, shares: FloatArray) -> FloatArray:
        count = 2 + int(_TIME_STEPS * (shares[-1] - shares[0]))
        return np.unique(np.linspace(0, len(shares) - 1, min(len(shares), count)).astype(int))


class Canvas:
    """A sheet on which space is seen from `view`, with paths in `colours`."""

    def __init__(self, axes: Axes, view: View, colours: PathColours | None = None) -> None:
        self.axes = axes
        self.view = view
        self.colours: PathColours = colours or _TimeColours()
        self._layer = 0.0
        axes.set_aspect("equal")

    def _next(self) -> float:
        self._layer += 1.0
        return self._layer

    def strokes(self, curves: Iterable[FloatArray], colour: str, width: float) -> None:
        """Draw curves (n, 3) as one path."""
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
        """Fill the union of facets with an even, translucent colour."""
        path = _polygons(self.view.project(facets.polygons))
        self.axes.add_patch(
            PathPatch(path, facecolor=colour, alpha=alpha, linewidth=0.0, zorder=self._next())
        )

    def facets(self, facets: Facets, tones: FloatArray, side: float, contrast: float) -> None:
        """Paint facets that do not overlap, grouped by shade.

        `side` is 1 for their outer side, -1 for the inner.
        """
        colours = shaded_colours(tones[facets.tones], side * facets.normals, self.view, contrast)
        shades, members = np.unique(np.round(colours * _SHADES), axis=0, return_inverse=True)
        corners = self.view.project(facets.polygons)
        # A hairline in the facets' own colour covers the seams that anti-aliasing would leave.
        collection = PathCollection(
            [_polygons(corners[members == number]) for number in range(len(shades))],
            facecolors=shades / _SHADES,
            edgecolors=shades / _SHADES,
            linewidths=0.3,
            zorder=self._next(),
        )
        collection.set_transform(self.axes.transData)
        self.axes.add_collection(collection)

    def sphere(self, radius: float, side: float, border: FloatArray) -> None:
        """Shade a sphere: its near half from outside or its far half from inside.

        Only the part inside `border`, corners (k, 2) on paper, is painted.
        """
        cut = Path(np.concatenate([border, border[:1]]), closed=True)
        for polygon, brightness in sphere_shades(radius, self.view, side, 28):
            colour = brightness * GROUND_LIGHT + (1.0 - brightness) * GROUND_DARK
            patch = PathPatch(
                Path(polygon), facecolor=tuple(colour), linewidth=0.0, zorder=self._next()
            )
            # Not add_patch: clipped parts must not count as drawn.
            self.axes.add_artist(patch)
            patch.set_clip_path(cut, self.axes.transData)

    def time_coloured(
        self, points: FloatArray, fractions: FloatArray, width: float, alpha: float
    ) -> None:
        """Draw a curve (n, 3) in the colours of paths, at fractions (n,) of elapsed time."""
        if len(points) < 2:
            return
        flat = self.view.project(points)
        pairs = list(pairwise(self.colours.pieces(fractions)))
        colours = self.colours([(fractions[a] + fractions[b]) / 2 for a, b in pairs])
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

    def image(self, colours: FloatArray, extent: tuple[float, float, float, float]) -> None:
        """Draw an image (rows, columns, 4), its first row lowest."""
        rows, columns = (np.flatnonzero(colours[..., 3].any(axis=a)) for a in (1, 0))
        if not len(rows):
            return
        left, right, bottom, top = extent
        wide, high = (right - left) / colours.shape[1], (top - bottom) / colours.shape[0]
        part = (
            left + columns[0] * wide,
            left + (columns[-1] + 1) * wide,
            bottom + rows[0] * high,
            bottom + (rows[-1] + 1) * high,
        )
        cut = colours[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]
        self.axes.imshow(
            np.clip(cut, 0.0, 1.0),
            extent=part,
            origin="lower",
            interpolation="bilinear",
            zorder=self._next(),
        )

    def label(self, point: FloatArray, text: str, colour: str) -> None:
        """Write a short text around a point (3,); it counts as drawn, so that it is not cut off."""
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


def visible_pieces(curve: SurfaceCurve, view: View, side: float) -> list[FloatArray]:
    """Visible pieces of a curve on the outer (`side` 1) or inner (-1) side."""
    seen = view.faces_reader(side * curve.normals)
    return [curve.points[run] for run in runs(seen[1:] & seen[:-1])]


def timed_on_surface(
    sheet: Canvas,
    curve: SurfaceCurve,
    fractions: FloatArray,
    side: float,
    width: float,
    alpha: float,
) -> None:
    """Draw the visible part of a curve on a surface in the colours of time."""
    seen: BoolArray = sheet.view.faces_reader(side * curve.normals)
    for run in runs(seen[1:] | seen[:-1]):
        sheet.time_coloured(curve.points[run], fractions[run], width, alpha)


def mark_ends(sheet: Canvas, curve: SurfaceCurve, side: float) -> None:
    """Mark the ends of a curve by a ring and a dot, pale if they are hidden."""
    mark_start(sheet, curve, side)
    seen = sheet.view.faces_reader(side * curve.normals[-1])
    last = to_hex(sheet.colours(1.0)) if seen else "#b3aabd"
    sheet.dot(curve.points[-1], last, last, 4.5)


def mark_start(sheet: Canvas, curve: SurfaceCurve, side: float) -> None:
    """Mark the start of a curve on a surface by a ring, pale if it is hidden."""
    seen = sheet.view.faces_reader(side * curve.normals[0])
    sheet.dot(curve.points[0], "white" if seen else "none", INK if seen else QUIET, 4.5)


def time_bar(
    figure: Figure, dataset: xr.Dataset, span: tuple[float, float], place: tuple[float, float]
) -> None:
    """Draw the colour scale of time, at `place` in inches."""
    width, height = figure.get_size_inches()
    units = unit_of(dataset, "time")
    start, end = _instants(span)
    first, last = f"$t$ = {start}", f"{end} {units}".rstrip()
    left, bottom = place
    # Digits of the typeface are 0.06 inches wide.
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


def _instants(span: tuple[float, float]) -> tuple[str, str]:
    """Two times in decimals, with three digits of the larger one."""
    largest = max(map(abs, span))
    if not 1e-3 <= largest < 1e5:
        return f"{span[0]:.3g}", f"{span[1]:.3g}"
    decimals = max(0, 2 - int(np.floor(np.log10(largest))))
    start, end = (np.format_float_positional(round(t, decimals), trim="-") for t in span)
    return start, end


def blank_axes(figure: Figure) -> Axes:
    """Axes over the whole figure, without a frame."""
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    axes.set_axis_off()
    return axes


def fit_height(figure: Figure, axes: Axes, width: float, tallest: float) -> None:
    """Adjust the figure's height to its content, with a footer for the time scale."""
    box = axes.dataLim
    margin, footer = 0.1, 0.36
    scale = min((width - 2 * margin) / box.width, (tallest - 2 * margin) / box.height)
    height = box.height * scale + 2 * margin
    figure.set_size_inches(width, height + footer)
    axes.set_position((0.0, footer / (height + footer), 1.0, height / (height + footer)))
    middle = ((box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2)
    axes.set_xlim(middle[0] - width / scale / 2, middle[0] + width / scale / 2)
    axes.set_ylim(middle[1] - height / scale / 2, middle[1] + height / scale / 2)
