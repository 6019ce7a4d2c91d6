"""The layout of a bifurcation diagram: window, lines, positions of labels."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from itertools import pairwise
from typing import TypeAlias

import numpy as np
from flint import fmpq

from flowlanes.system.arrays import BoolArray, FloatArray

from . import Diagram, Region
from .arrangement import rational

#: Maps abscissae (n,) in a column to the heights of its arcs there (n, arcs).
Heights: TypeAlias = tuple[FloatArray, FloatArray]
DrawnPoint: TypeAlias = tuple[float, float]

#: Number of points of a line in each column, and size of the grid for labels.
POINTS, GRID = 33, (180, 126)
#: Half the width and half the height of a label, relative to the window.
LABEL = (0.055, 0.026)


@dataclass(frozen=True)
class Window:
    """The drawn part of the plane, with the line from which ordinates are measured.

    Attributes
    ----------
    across, upward : (float, float)
        Limits.
    slope, offset : Fraction
        Drawn upward is y less slope·x + offset.
    """

    across: tuple[float, float]
    upward: tuple[float, float]
    slope: Fraction
    offset: Fraction

    def drawn_position(self, place: Sequence[Fraction | float]) -> DrawnPoint:
        """The position of a point of the plane in the drawing."""
        x, y = map(float, place)
        return x, y - float(self.slope) * x - float(self.offset)


def _base(diagram: Diagram) -> tuple[Fraction, Fraction]:
    """Slope and offset of the line of the middle axis.

    In a field the boundaries are close together along this line.  Without a field they are rays,
    and no line is needed.
    """
    terms = diagram.cofactor.subs({"z": diagram.poles[1]}).to_dict()
    if not diagram.equilibria or terms.get((0, 1, 0), 0) == 0:
        return Fraction(0), Fraction(0)
    slope, offset = (-terms.get(p, fmpq(0)) / terms[0, 1, 0] for p in ((1, 0, 0), (0, 0, 0)))
    return Fraction(int(slope.p), int(slope.q)), Fraction(int(offset.p), int(offset.q))


def window(diagram: Diagram, mark: tuple[float, float] | None) -> Window:
    """A window that contains all corners of the diagram and a marked point."""
    base = _base(diagram)
    orders: dict[int, list[tuple[int, int]]] = {}
    for number, boundary in enumerate(diagram.boundaries):
        for column, rank in boundary.arcs:
            orders.setdefault(column, []).append((rank, number))
    ends = [float(a) for a in diagram.arrangement.abscissae]
    stacks = [[n for _, n in sorted(orders.get(c, []))] for c in range(len(ends) + 1)]
    corners = [x for x, (left, right) in zip(ends, pairwise(stacks), strict=True) if left != right]
    closed = not stacks[-1]
    if mark is not None:
        corners.append(mark[0])
    left, right = min(corners), max(corners)
    room = (right - left) or abs(left) or 1.0
    across = (left - 0.12 * room, right + (0.12 if closed else 0.4) * room)
    shown = [
        ys[:, rank]
        for column, (_, ys) in _levels(diagram, across, base).items()
        for rank in range(ys.shape[1])
        if rank in [place for place, _ in orders.get(column, [])]
    ]
    bare = Window(across, (0.0, 0.0), *base)
    values = np.concatenate([*shown, [] if mark is None else [bare.drawn_position(mark)[1]]])
    low, high = float(values.min()), float(values.max())
    tall = (high - low) or 1.0
    return replace(bare, upward=(low - 0.1 * tall, high + 0.1 * tall))


def heights(diagram: Diagram, frame: Window) -> Mapping[int, Heights]:
    """The arcs over every visible column, in drawing coordinates."""
    return _levels(diagram, frame.across, (frame.slope, frame.offset))


def _levels(
    diagram: Diagram, across: tuple[float, float], base: tuple[Fraction, Fraction]
) -> dict[int, Heights]:
    slope, offset = map(float, base)
    ends = [-np.inf, *(float(a) for a in diagram.arrangement.abscissae), np.inf]
    levels: dict[int, Heights] = {}
    for column, (start, end) in enumerate(pairwise(ends)):
        low, high = max(start, across[0]), min(end, across[1])
        if high <= low:
            continue
        # Denser at the ends, where arcs may be steep.
        turns = np.linspace(1e-4, np.pi - 1e-4, POINTS)
        xs = low + (high - low) * (1 - np.cos(turns)) / 2
        rows = [diagram.arrangement.ordinates(column, rational(Fraction(float(x)))) for x in xs]
        ys = np.array([[float(y) for y in row] for row in rows])
        levels[column] = (xs, ys - (slope * xs + offset)[:, np.newaxis])
    return levels


class Grid:
    """A raster of the window that records the region of each of its points.

    Attributes
    ----------
    members : array (columns, rows) of int
        Place of the region in the diagram's list; −1 where something else is drawn.
    """

    def __init__(
        self,
        diagram: Diagram,
        frame: Window,
        lines: Mapping[int, Heights],
        occupied_places: Sequence[DrawnPoint] = (),
    ) -> None:
        wide, tall = GRID
        self.frame = frame
        self.xs = np.linspace(*frame.across, wide)
        self.ys = np.linspace(*frame.upward, tall)
        self.regions = diagram.regions
        numbers = {cell: n for n, region in enumerate(diagram.regions) for cell in region.cells}
        ends = np.array([float(a) for a in diagram.arrangement.abscissae])
        self.members = np.full(GRID, -1)
        for i, x in enumerate(self.xs):
            column = int(np.searchsorted(ends, x))
            if column not in lines:
                continue
            grid, levels = lines[column]
            stack = [np.interp(x, grid, level) for level in levels.T]
            ranks = np.searchsorted(np.sort(stack), self.ys)
            self.members[i] = [numbers[column, int(rank)] for rank in ranks]
        for x, y in occupied_places:
            wide, tall = (
                abs(steps - place) < part / 2 * (steps[-1] - steps[0])
                for steps, place, part in zip((self.xs, self.ys), (x, y), LABEL, strict=True)
            )
            self.members[np.outer(wide, tall)] = -1

    def in_regions(self, regions: Sequence[Region]) -> BoolArray:
        """The raster points in some regions."""
        wanted = [n for n, region in enumerate(self.regions) if region in regions]
        return np.asarray(np.isin(self.members, wanted))

    def label_scale(self, inside: BoolArray) -> FloatArray:
        """Size of the label that fits at each point; 1 fits exactly."""
        from scipy.ndimage import distance_transform_edt

        framed = np.pad(inside, 1)
        # in units of half a label
        steps = (1 / (GRID[0] * LABEL[0]), 1 / (GRID[1] * LABEL[1]))
        return np.asarray(distance_transform_edt(framed, sampling=steps)[1:-1, 1:-1])

    def place(self, index: tuple[int, int]) -> DrawnPoint:
        """The point of the plane at a raster point."""
        return float(self.xs[index[0]]), float(self.ys[index[1]])


def label_positions(
    grid: Grid, text: Sequence[Region], empty: Sequence[Region]
) -> dict[int, tuple[DrawnPoint, DrawnPoint | None]]:
    """A point inside each region and, if that is too narrow, one for its label.

    Keys are the numbers of the regions; 0 is the one for the regions without motions.
    """
    free = grid.in_regions(empty)
    positions: dict[int, tuple[DrawnPoint, DrawnPoint | None]] = {}
    for region in text:
        room = grid.label_scale(grid.in_regions([region]))
        if room.max() <= 0:
            continue
        inside = _largest(room)
        if room[inside] >= 1.25:
            positions[region.number] = (grid.place(inside), None)
            continue
        outside = _nearest(grid.label_scale(free) >= 1.5, inside)
        if outside is None:
            positions[region.number] = (grid.place(inside), None)
            continue
        positions[region.number] = (grid.place(inside), grid.place(outside))
        reach = (int(3 * LABEL[0] * GRID[0]), int(3 * LABEL[1] * GRID[1]))
        free[
            max(outside[0] - reach[0], 0) : outside[0] + reach[0],
            max(outside[1] - reach[1], 0) : outside[1] + reach[1],
        ] = False
    room = grid.label_scale(free)
    if room.max() >= 1.5:
        positions[0] = (grid.place(_largest(room)), None)
    return positions


def _largest(room: FloatArray) -> tuple[int, int]:
    first, second = np.unravel_index(int(np.argmax(room)), room.shape)
    return int(first), int(second)


def _nearest(mask: BoolArray, point: tuple[int, int]) -> tuple[int, int] | None:
    candidates = np.argwhere(mask)
    if not len(candidates):
        return None
    distances = np.hypot(*((candidates - point) / np.array(GRID)).T)
    first, second = candidates[int(np.argmin(distances))]
    return int(first), int(second)
