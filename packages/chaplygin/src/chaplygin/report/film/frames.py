"""The frames of a film: the scene at successive times, from a fixed viewpoint.

A path that fits beside the body is shown as a whole; for a longer one the film follows the body.
"""

from __future__ import annotations

import io
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace

import matplotlib as mpl
import numpy as np
import numpy.typing as npt
import xarray as xr
from matplotlib.figure import Figure

from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ...experiment.subjects.plan import PlanMotion
from ...experiment.subjects.subject import Subject
from ...geometry.view import View
from ..drawing.canvas import Canvas, blank_axes
from ..drawing.dataset_access import times_of, unit_of
from ..drawing.modes import ModeColours
from ..drawing.shading import PlaneGround
from ..drawing.style import INK, QUIET, STYLE
from ..scenes.ball import paint_ball_scene, surface_seen
from ..scenes.planar_mechanism import OF_MECHANISM, OF_PICTURE, Pose
from ..scenes.rolling_body import Track, draw_scene, scene_view, track_of
from ..scenes.scene import scene_of, surface_scene_of

#: Width and height of a frame in pixels.
Size = tuple[int, int]
#: A frame, (height, width, 3), of bytes.
Picture = npt.NDArray[np.uint8]

#: Dots per inch of the drawing.
_DOTS = 144
#: Extent of a path, in diameters of the body, up to which it is shown as a whole.
_WHOLE = 7.0
#: Fraction of the picture left free around the moving parts.
_ROOM = 1.12


@dataclass(frozen=True)
class _Window:
    """The visible part of the plane: its centre at each time, and half its width and height."""

    middles: FloatArray
    half: FloatArray


def require_scene(subject: Subject) -> None:
    """Reject subjects without anything to show, before anything is integrated.

    Raises
    ------
    InputError
        If it has no body and no drawing.
    """
    on_surface = subject.surface is not None and subject.outline is not None
    if subject.ball is None and subject.plan is None and not on_surface:
        raise _nothing_to_show(subject)


def _nothing_to_show(subject: Subject) -> InputError:
    return InputError(
        f"{subject.system.title} has no body that could be shown: a film needs a body, or a "
        "drawing of a mechanism (the table [plan])"
    )


def frames(
    subject: Subject, dataset: xr.Dataset, plan: PlanMotion | None, every: int, size: Size
) -> tuple[int, Iterator[Picture]]:
    """The number of frames of a motion, and an iterator over the frames.

    Parameters
    ----------
    subject : Subject
    dataset : xarray.Dataset
        The motion, sampled finely enough for smooth paths.
    plan : PlanMotion or None
        The drawing of a mechanism in the plane, at the same instants.
    every : int
        Number of samples per frame.
    size : (int, int)
        Width and height in pixels.

    Raises
    ------
    InputError
        If the motion has no body and no drawing.
    """
    on_surface = surface_scene_of(subject)
    if on_surface is not None:
        outline, ground = on_surface
        track = track_of(dataset, None)
        view, seen = surface_seen(track, outline, ground)

        def draw(sheet: Canvas, until: int) -> None:
            paint_ball_scene(sheet, seen, _part(track, until), outline)

        window = _largest_window(draw, view, len(track.times), size)
        return _films(dataset, track.times, window, view, draw, every, size)
    if plan is not None:
        return _plan_frames(dataset, plan, every, size)
    scene = scene_of(subject)
    if scene is None:
        raise _nothing_to_show(subject)
    body, surface = scene
    track = track_of(dataset, None)
    view = scene_view(track, surface)
    extent = float(np.max(np.ptp(track.contact, axis=0)))
    follows = isinstance(surface, PlaneGround) and extent > _WHOLE * body.diameter
    colours = ModeColours(dataset, track.times[0], track.times[-1]) if "mode" in dataset else None

    def draw_body(sheet: Canvas, until: int) -> None:
        if colours is not None:
            sheet.colours = colours
        part = _part(track, until)
        draw_scene(sheet, part.last_part(body.diameter) if follows else part, body, surface, track)

    if follows:
        half = _fit(np.full(2, _WHOLE * body.diameter / 2), size)
        window = _Window(view.project(track.centre), half)
    else:
        window = _largest_window(draw_body, view, len(track.times), size)
    return _films(dataset, track.times, window, view, draw_body, every, size)


def _part(track: Track, until: int) -> Track:
    """The path up to a given time."""
    end = slice(0, until + 1)
    return replace(
        track,
        times=track.times[end],
        contact=track.contact[end],
        centre=track.centre[end],
        rotation=track.rotation[end],
        normal=track.normal[end],
    )


def _fit(half: FloatArray, size: Size) -> FloatArray:
    """Half the extent of a picture of this size that shows at least the given extent."""
    scale = float(np.max(half / np.array(size)))
    return np.array(size) * scale


def _largest_window(
    draw: Callable[[Canvas, int], None], view: View, count: int, size: Size
) -> _Window:
    """Everything drawn at the end, which must stay visible."""
    with mpl.rc_context(STYLE):
        sheet = Canvas(blank_axes(Figure(figsize=(4.0, 4.0))), view)
        draw(sheet, count - 1)
    box = sheet.axes.dataLim
    half = _fit(_ROOM * np.array([box.width, box.height]) / 2, size)
    return _Window(np.tile([(box.x0 + box.x1) / 2, (box.y0 + box.y1) / 2], (count, 1)), half)


def _films(
    dataset: xr.Dataset,
    times: FloatArray,
    window: _Window,
    view: View,
    draw: Callable[[Canvas, int], None],
    every: int,
    size: Size,
) -> tuple[int, Iterator[Picture]]:
    """Frames at regular sample intervals, including the last sample."""
    chosen = list(range(0, len(times), every))
    units = unit_of(dataset, "time")

    def draw_each() -> Iterator[Picture]:
        with mpl.rc_context(STYLE):
            for index in chosen:
                figure = Figure(figsize=(size[0] / _DOTS, size[1] / _DOTS), dpi=_DOTS)
                sheet = Canvas(blank_axes(figure), view)
                # A single point has no path yet.
                draw(sheet, max(index, 1))
                yield _pixels(figure, sheet, window, index, f"{times[index]:.2f} {units}")

    return len(chosen), draw_each()


def _pixels(figure: Figure, sheet: Canvas, window: _Window, index: int, words: str) -> Picture:
    """The pixels of a sheet seen through a window, with the time."""
    (x, y), (wide, high) = window.middles[index], window.half
    sheet.axes.set_aspect("auto")
    sheet.axes.set_xlim(x - wide, x + wide)
    sheet.axes.set_ylim(y - high, y + high)
    figure.text(0.02, 0.03, f"$t$ = {words}".strip(), color=QUIET, fontsize=9)
    content = io.BytesIO()
    figure.savefig(content, format="rgba", dpi=_DOTS)
    rows = round(figure.get_figheight() * _DOTS)
    pixels = np.frombuffer(content.getvalue(), dtype=np.uint8).reshape(rows, -1, 4)
    return pixels[..., :3].copy()


def _plan_frames(
    dataset: xr.Dataset, plan: PlanMotion, every: int, size: Size
) -> tuple[int, Iterator[Picture]]:
    """A mechanism in the plane on its path."""
    times = times_of(dataset)
    path = np.column_stack([plan.path, np.zeros(len(plan.path))])
    poses = [Pose(plan, index) for index in range(0, len(times), every)]
    corners = np.concatenate([plan.path, *(pose.corners for pose in poses)])
    low, high = corners.min(axis=0), corners.max(axis=0)
    largest = max(pose.size for pose in poses)
    half = _fit(_ROOM * np.maximum((high - low) / 2 + OF_MECHANISM * largest, 1e-9), size)
    mark = max(OF_MECHANISM * largest, OF_PICTURE * 2 * float(half[0]))
    window = _Window(np.tile((low + high) / 2, (len(times), 1)), half)
    shares = (times - times[0]) / ((times[-1] - times[0]) or 1.0)

    def draw(sheet: Canvas, until: int) -> None:
        sheet.time_coloured(path[: until + 1], shares[: until + 1], 1.6, 1.0)
        Pose(plan, until).draw(sheet.axes, mark, INK, 60)

    return _films(dataset, times, window, View(-np.pi / 2, np.pi / 2), draw, every, size)
