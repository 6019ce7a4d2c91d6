"""The bar of contact modes under time series, with the names of events."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.backend_bases import RendererBase
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Rectangle
from matplotlib.text import Text
from matplotlib.transforms import ScaledTranslation, Transform, blended_transform_factory

from flowlanes.system.arrays import FloatArray

from ...experiment.contact.mode_intervals import event_times, mode_intervals
from ..drawing.dataset_access import times_of
from ..drawing.modes import MODE_STYLES, event_kinds, mode_key, present_modes
from ..drawing.style import INK, QUIET, STYLE

_POINT = 1.0 / 72.0
#: Heights in points: between plot and bar, of the bar, and of the line with the names of events.
_SPACE, _BAR, _NAMES = 3.0, 7.0, 12.0
#: Font size of the names of events.
_SIZE = 8.0
#: Number of characters of the legend of modes per inch of the figure.
_LINE = 9.0
#: Maximum number of events marked by lines through the plot; more would hide the curves.
_LINES = 40
#: Events closer than this many points share a name in any case.
_NEAR = 4.0


def add_mode_bars(figure: Figure, dataset: xr.Dataset) -> None:
    """Add a bar of the modes under every time series in a figure, and their legend at its foot.

    The lowest plot of each column also has the names of the events.  Events so close that their
    names would touch share one.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        A figure with a layout engine; invisible axes are skipped.
    dataset : xarray.Dataset
        A dataset with `mode` and the events.
    """
    if len(times_of(dataset)) < 2:
        return
    panels = [axes for axes in figure.axes if axes.axison]
    with mpl.rc_context(STYLE):
        for axes in panels:
            _add_bar(axes, dataset, bool(axes.get_xlabel()))
        key(figure, present_modes(dataset))
    named = sum(1 for axes in panels if axes.get_xlabel())
    bars = len(panels) * (_SPACE + _BAR) + named * (_NAMES if len(event_times(dataset)) else 0.0)
    columns = max(named, 1)
    figure.set_figheight(figure.get_figheight() + bars * _POINT / columns + 0.26)


def key(figure: Figure, modes: list[str]) -> None:
    """Draw a legend of modes at the foot of a figure."""
    columns = len(modes) if sum(map(len, modes)) <= _LINE * figure.get_figwidth() else 2
    figure.legend(
        handles=mode_key(modes),
        loc="outside lower center",
        ncols=columns,
        handlelength=1.4,
        handleheight=0.6,
        columnspacing=1.4,
        labelspacing=0.3,
        fontsize=9,
    )


def _add_bar(axes: Axes, dataset: xr.Dataset, with_name: bool) -> None:
    """The bar under one plot, between it and its time axis."""
    events = event_times(dataset)
    names = with_name and len(events) > 0
    low, high = axes.get_xlim()
    across = _inches_below(axes)
    bottom, top = -(_SPACE + _BAR) * _POINT, -_SPACE * _POINT
    for interval in mode_intervals(dataset):
        style = MODE_STYLES[interval.mode]
        begin, end = np.clip([interval.begin, interval.end], low, high)
        axes.add_artist(
            Rectangle(
                (begin, bottom),
                end - begin,
                top - bottom,
                facecolor=style.colour,
                edgecolor="#ffffff",
                hatch=style.hatch,
                linewidth=0.0,
                transform=across,
                clip_on=False,
            )
        )
    for time in events:
        axes.add_artist(
            Line2D(
                [time, time],
                [bottom - 2 * _POINT, top],
                color=INK,
                linewidth=0.6,
                transform=across,
                clip_on=False,
            )
        )
        if len(events) <= _LINES:
            axes.axvline(time, color=QUIET, linewidth=0.4, linestyle=(0, (1, 2)), zorder=0.6)
    axes.spines["bottom"].set_position(("outward", _SPACE + _BAR + (_NAMES if names else 2.0)))
    if names:
        axes.add_artist(EventNames(events, event_kinds(dataset), across, bottom - 3 * _POINT))


def _inches_below(axes: Axes) -> Transform:
    """Coordinates: time horizontally, and inches up from the lower edge of a plot."""
    figure = axes.get_figure(root=True)
    assert figure is not None
    corner = ScaledTranslation(0.0, 0.0, axes.transAxes)  # type: ignore[arg-type]
    upward = figure.dpi_scale_trans + corner
    return blended_transform_factory(axes.transData, upward)


@dataclass(frozen=True)
class EventGroup:
    """Events with a common name.

    Attributes
    ----------
    first, last : float
        Horizontal positions in the plot.
    kinds : tuple of str
    """

    first: float
    last: float
    kinds: tuple[str, ...]

    @property
    def name(self) -> str:
        """The kind of a single event or of equal ones; otherwise the number of events."""
        count, different = len(self.kinds), set(self.kinds)
        if count == 1:
            return self.kinds[0]
        if len(different) == 1:
            return f"{count} × {self.kinds[0]}"
        if count == 2:
            return ", ".join(self.kinds)
        return f"{count} events"

    def __add__(self, other: EventGroup) -> EventGroup:
        return EventGroup(self.first, other.last, self.kinds + other.kinds)


@dataclass(frozen=True)
class PlacedName:
    """A group of events, and the left edge and width of its name."""

    group: EventGroup
    left: float
    width: float

    @property
    def right(self) -> float:
        """The right edge."""
        return self.left + self.width


class EventNames(Artist):
    """The names of events in one line; touching names are merged when drawn.

    Parameters
    ----------
    times : array (m,)
    kinds : list of str
    place : Transform
        Transformation from time and height to the paper.
    height : float
        Upper edge of the line.
    """

    def __init__(
        self, times: FloatArray, kinds: list[str], place: Transform, height: float
    ) -> None:
        super().__init__()
        self._times, self._kinds, self._place, self._height = times, kinds, place, height
        self.set_in_layout(False)
        self.set_clip_on(False)

    def drawn_names(self, renderer: RendererBase) -> list[PlacedName]:
        """The names as drawn, from left to right."""
        axes = self.axes
        assert axes is not None
        box = axes.get_window_extent()
        across = self._across()
        inside = [
            EventGroup(float(x), float(x), (kind,))
            for x, kind in zip(across, self._kinds, strict=True)
            if box.x0 - 1 <= x <= box.x1 + 1
        ]

        def width(name: str) -> float:
            return self._text(name).get_window_extent(renderer).width

        return label_positions(inside, width, (box.x0, box.x1), _NEAR * self._pixels)

    def draw(self, renderer: RendererBase) -> None:
        """Draw the names, and a line over those of several events."""
        top = self._top()
        for item in self.drawn_names(renderer):
            text = self._text(item.group.name)
            text.set_position((item.left, top - self._pixels))
            text.draw(renderer)
            if item.group.last > item.group.first:
                line = Line2D([item.group.first, item.group.last], [top, top], color=INK)
                line.set_linewidth(0.6)
                self._adopt(line)
                line.draw(renderer)
        self.stale = False

    @property
    def _pixels(self) -> float:
        """Size of a point in pixels."""
        figure = self.get_figure(root=True)
        assert figure is not None
        return float(figure.dpi) * _POINT

    def _across(self) -> FloatArray:
        points = np.stack([self._times, np.full(len(self._times), self._height)], axis=-1)
        return np.asarray(self._place.transform(points))[:, 0]

    def _top(self) -> float:
        return float(self._place.transform((float(self._times[0]), self._height))[1])

    def _text(self, name: str) -> Text:
        text = Text(0.0, 0.0, name, fontsize=_SIZE, color=INK, ha="left", va="top")
        self._adopt(text)
        return text

    def _adopt(self, artist: Artist) -> None:
        figure = self.get_figure(root=True)
        assert figure is not None
        artist.set_figure(figure)


def label_positions(
    groups: Sequence[EventGroup],
    width: Callable[[str], float],
    limits: tuple[float, float],
    near: float,
) -> list[PlacedName]:
    """Place the names of event groups on one line, and merge groups whose names would touch.

    Parameters
    ----------
    groups : sequence of EventGroup
        From left to right.
    width : callable
        Width of a name.
    limits : tuple of float
        Edges that no name crosses.
    near : float
        Distance up to which groups are merged in any case; also the smallest gap between names.
    """
    known: dict[str, float] = {}
    united: list[EventGroup] = []
    for group in groups:
        if united and group.first - united[-1].last <= near:
            united[-1] = united[-1] + group
        else:
            united.append(group)
    while True:
        names = []
        for group in united:
            wide = known.setdefault(group.name, -1.0)
            if wide < 0.0:
                wide = known[group.name] = width(group.name)
            middle = (group.first + group.last) / 2
            left = max(limits[0], min(middle - wide / 2, limits[1] - wide))
            names.append(PlacedName(group, left, wide))
        overlaps = [a.right + near - b.left for a, b in pairwise(names)]
        if not overlaps or max(overlaps) <= 0.0:
            return names
        worst = int(np.argmax(overlaps))
        united[worst : worst + 2] = [united[worst] + united[worst + 1]]
