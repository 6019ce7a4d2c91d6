"""Events and the legend of modes in the scene of a body with friction."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from matplotlib.path import Path

from flowlanes.system.arrays import FloatArray

from ...experiment.contact.mode_intervals import event_times, mode_intervals
from ...geometry.mesh import BodyMesh
from ..drawing.canvas import Canvas
from ..drawing.curves import convex_hull
from ..drawing.dataset_access import unit_of
from ..drawing.modes import mode_key, present_modes
from ..drawing.shading import Ground, PlaneGround
from ..drawing.style import INK
from .ground import on_ground

#: Number of characters of mode names that fit into one line beside the note on the grid.
_LINE = 24
#: Height of a line of the legend in inches.
_HIGH = 0.2


def mark_events(
    sheet: Canvas,
    dataset: xr.Dataset,
    times: FloatArray,
    contact: FloatArray,
    ground: Ground,
    body: BodyMesh | None = None,
) -> None:
    """Mark the contact point at the events, except where ground or body hide it.

    Parameters
    ----------
    sheet : Canvas
    dataset : xarray.Dataset
    times : (n,) array
    contact : (n, 3) array
        Contact points, space axes.
    ground : PlaneGround or SphereGround
    body : BodyMesh, optional
        The body in its final position.
    """
    events = event_times(dataset)
    events = events[(events > times[0]) & (events < times[-1])]
    if not len(events):
        return
    places = np.stack([np.interp(events, times, column) for column in contact.T], axis=-1)
    if not isinstance(ground, PlaneGround):
        side = float(np.copysign(1.0, ground.radius))
        places = places[sheet.view.faces_reader(side * on_ground(places, ground).normals)]
    outline = None if body is None else Path(convex_hull(sheet.view.project(body.vertices)))
    for place in places:
        if outline is None or not outline.contains_points(sheet.view.project(place)[None])[0]:
            sheet.dot(place, "white", INK, 3.0)


def mode_scale(figure: Figure, axes: Axes, dataset: xr.Dataset, span: tuple[float, float]) -> None:
    """Draw the legend of the modes below the picture, with the time shown."""
    names = present_modes(dataset)
    shown = {i.mode for i in mode_intervals(dataset) if i.end > span[0] and i.begin < span[1]}
    names = [name for name in names if name in shown] or names
    units = unit_of(dataset, "time")
    handles = mode_key(names)
    if span[0] > dataset["time"].values[0]:
        handles.append(_legend_entry(f"from $t$ = {span[0]:.3g} {units}"))
    elif span[1] < dataset.attrs.get("end_time", span[1]):
        handles.append(_legend_entry(f"until $t$ = {span[1]:.3g} {units}"))
    labels = [str(handle.get_label()) for handle in handles]
    columns = len(labels) if sum(map(len, labels)) <= _LINE else 2
    rows = -(-len(labels) // columns)
    _extend(figure, axes, (rows - 1) * _HIGH)
    wide, high = figure.get_size_inches()
    figure.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(0.1 / wide, 0.06 / high),
        ncols=columns,
        handlelength=1.3,
        handleheight=0.6,
        columnspacing=1.2,
        labelspacing=0.3,
        borderpad=0.2,
        fontsize=9,
    )
    figure.set_label(f"{figure.get_label()}; t from {span[0]:.4g} to {span[1]:.4g} {units}".strip())


def _legend_entry(words: str) -> Patch:
    """A legend entry without a colour."""
    return Patch(facecolor="none", edgecolor="none", label=words)


def _extend(figure: Figure, axes: Axes, more: float) -> None:
    """Extend the foot of a figure by some inches."""
    wide, high = figure.get_size_inches()
    box = axes.get_position()
    figure.set_size_inches(wide, high + more)
    foot = (box.y0 * high + more) / (high + more)
    axes.set_position((box.x0, foot, box.width, box.height * high / (high + more)))
