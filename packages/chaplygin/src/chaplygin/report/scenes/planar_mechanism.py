"""The plan view of a mechanism: its path, and the positions of links, wheels and blades."""

from __future__ import annotations

from collections.abc import Iterable

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ...experiment.subjects.plan import PlanMotion
from ...geometry.view import View
from ..drawing.canvas import Canvas, time_bar
from ..drawing.curves import smooth_curve
from ..drawing.dataset_access import (
    CURVE_POINTS,
    NOTHING,
    time_shares,
    times_of,
    title_of,
    unit_of,
    with_unit,
)
from ..drawing.style import FAINT, INK, STYLE, TIME_COLOURS, WIDTH

#: Number of earlier positions that are drawn.
EARLIER = 5
#: Length of a drawn wheel or blade: relative to the mechanism's size, and at least relative to the
#: picture.
OF_MECHANISM = 0.2
OF_PICTURE = 0.022
#: A mechanism smaller than this fraction of its path is drawn again enlarged.
_SMALL = 0.16
_PALE = "#b7c3ce"
#: Margins around the map in inches.
_LEFT, _RIGHT, _BOTTOM, _TOP = 0.76, 0.12, 0.86, 0.12


@arguments_checked
def plan_view(dataset: xr.Dataset, motion: PlanMotion) -> Figure:
    """The path of a mechanism in the plane, with the mechanism at some times.

    The path is in the colours of time; the mechanism is dark at the end and pale before.  A
    mechanism that is small compared with its path is also shown enlarged in a corner.

    Parameters
    ----------
    dataset : xarray.Dataset
        Dataset with times, units and title.
    motion : PlanMotion
        Motion at the times of the dataset.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If no instant has a place.
    """
    good = np.isfinite(motion.path).all(axis=1)
    if not good.any():
        raise InputError(f"the figure plan_view has no sample to show of {title_of(dataset)}")
    instants = times_of(dataset)[good]
    times, path = smooth_curve(instants, motion.path[good], CURVE_POINTS)
    numbers = np.flatnonzero(good)
    poses = [Pose(motion, number) for number in _spread(motion.path, numbers)]
    last = poses[-1]
    corners = np.concatenate([path, *(pose.corners for pose in poses)])
    low, high = corners.min(axis=0), corners.max(axis=0)
    extent = float(np.max(high - low))
    # Wheels extend beyond their centres.
    room = max(OF_MECHANISM * last.size, OF_PICTURE * extent) / 2 if last.shapes else 0.0
    low, high = low - room, high + room
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 4.0))
        figure.set_label(f"Path in the plane: {title_of(dataset)}")
        enlarged = NOTHING < last.size < _SMALL * extent
        wide = WIDTH - _LEFT - _RIGHT - (1.9 if enlarged else 0.0)
        size = np.maximum(high - low, 0.05 * extent) if extent > NOTHING else np.array([2.0, 1.0])
        tall = float(np.clip(wide * size[1] / size[0], 2.0, 4.4))
        figure.set_size_inches(WIDTH, tall + _BOTTOM + _TOP)
        height = figure.get_figheight()
        axes = figure.add_axes((_LEFT / WIDTH, _BOTTOM / height, wide / WIDTH, tall / height))
        half = 1.12 / 2 * max(size[0], size[1] * wide / tall)
        middle = (low + high) / 2
        _limits(axes, middle, half, tall / wide)
        axes.grid(color=FAINT, linewidth=0.4)
        axes.set_axisbelow(True)
        units = unit_of(dataset, "x") if "x" in dataset else ""
        axes.set_xlabel(with_unit("$x$", units))
        axes.set_ylabel(with_unit("$y$", units))
        sheet = Canvas(axes, View(-np.pi / 2, np.pi / 2))
        flat = np.column_stack([path, np.zeros(len(path))])
        sheet.time_coloured(flat, time_shares(times), 1.6, 1.0)
        marks = max(OF_MECHANISM * last.size, OF_PICTURE * 2 * half)
        for pose in poses[:-1]:
            pose.draw(axes, marks, _PALE, 50)
        last.draw(axes, marks, INK, 60)
        sheet.dot(flat[0], "white", INK, 4.5)
        if not last.shapes:
            end = mpl.colors.to_hex(TIME_COLOURS(1.0))
            sheet.dot(flat[-1], end, end, 4.5)
        if enlarged:
            _draw_enlarged(figure, sheet, flat, time_shares(times), last, wide)
        time_bar(figure, dataset, (instants[0], instants[-1]), (_LEFT, 0.16))
    return figure


class Pose:
    """A mechanism at one time: rods, and positions with headings."""

    def __init__(self, motion: PlanMotion, number: int) -> None:
        self.place = motion.path[number]
        self.links = motion.links[number]
        self.wheels = motion.wheels[number]
        self.axles = motion.axles[number]
        self.blades = motion.blades[number]
        self.points = motion.points[number]

    @property
    def shapes(self) -> int:
        """The number of its parts."""
        parts = (self.links, self.wheels, self.axles, self.blades, self.points)
        return sum(map(len, parts))

    @property
    def corners(self) -> FloatArray:
        """Points that must be in the picture, (k, 2)."""
        ends = self.links.reshape(-1, 2)
        placed = [part[:, :2] for part in (self.wheels, self.axles, self.blades, self.points)]
        points = np.concatenate([self.place[None], ends, *placed])
        return np.asarray(points[np.isfinite(points).all(axis=1)], dtype=np.float64)

    @property
    def size(self) -> float:
        """The longest side of its bounding rectangle."""
        return float(np.max(np.ptp(self.corners, axis=0)))

    def draw(self, axes: Axes, mark: float, colour: str, layer: float) -> None:
        """Draw it with wheels and blades of the length `mark`."""
        rods = self.links.reshape(-1, 2, 2)
        axes.add_collection(LineCollection(list(rods), colors=colour, linewidths=1.3, zorder=layer))
        wheels = [_box(x, y, angle, mark, 0.34 * mark) for x, y, angle in self.wheels]
        across = []
        for x, y, angle in self.axles:
            side = 0.55 * mark * np.array([-np.sin(angle), np.cos(angle)])
            ends = [np.array([x, y]) + side, np.array([x, y]) - side]
            across.append(np.array(ends))
            wheels += [_box(a, b, angle, 0.75 * mark, 0.26 * mark) for a, b in ends]
        axes.add_collection(LineCollection(across, colors=colour, linewidths=1.1, zorder=layer + 1))
        wheels += [_box(x, y, angle, 1.3 * mark, 0.1 * mark) for x, y, angle in self.blades]
        axes.add_collection(
            PolyCollection(
                wheels, facecolors=colour, edgecolors=colour, linewidths=0.6, zorder=layer + 2
            )
        )
        axes.plot(
            *self.points.T,
            "o",
            markerfacecolor="white",
            markeredgecolor=colour,
            markersize=4.0,
            markeredgewidth=1.0,
            zorder=layer + 3,
        )


def _box(x: float, y: float, angle: float, length: float, width: float) -> FloatArray:
    """A rectangle about a point, with its longer side at an angle."""
    along = np.array([np.cos(angle), np.sin(angle)]) * length / 2
    side = np.array([-np.sin(angle), np.cos(angle)]) * width / 2
    corners = np.array([along + side, side - along, -along - side, along - side])
    return np.asarray(corners + np.array([x, y]), dtype=np.float64)


def _spread(path: FloatArray, numbers: Iterable[int]) -> list[int]:
    """Samples at roughly equal distances along a path, including both ends."""
    chosen = list(numbers)
    steps = np.linalg.norm(np.diff(path[chosen], axis=0), axis=1)
    way = np.concatenate([[0.0], np.cumsum(steps)])
    if way[-1] <= NOTHING:
        return [chosen[-1]]
    places = np.searchsorted(way, np.linspace(0.0, way[-1], EARLIER + 1))
    return [chosen[min(int(place), len(chosen) - 1)] for place in dict.fromkeys(places.tolist())]


def _limits(axes: Axes, middle: FloatArray, half: float, ratio: float) -> None:
    axes.set_xlim(middle[0] - half, middle[0] + half)
    axes.set_ylim(middle[1] - half * ratio, middle[1] + half * ratio)


def _draw_enlarged(
    figure: Figure,
    sheet: Canvas,
    path: FloatArray,
    fractions: FloatArray,
    pose: Pose,
    wide: float,
) -> None:
    """The mechanism alone, at the end, to the right of the map."""
    height = figure.get_figheight()
    left = (_LEFT + wide + 0.25) / WIDTH
    axes = figure.add_axes((left, 1.0 - (_TOP + 1.65) / height, 1.65 / WIDTH, 1.65 / height))
    corners = pose.corners
    middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
    near = Canvas(axes, sheet.view)
    near.time_coloured(path, fractions, 1.6, 1.0)
    pose.draw(axes, OF_MECHANISM * pose.size, INK, 60)
    _limits(axes, middle, 0.95 * pose.size, 1.0)
    axes.set_xticks([])
    axes.set_yticks([])
    axes.spines[["top", "right"]].set_visible(True)
    axes.set_xlabel("at the end, enlarged", fontsize=9)
