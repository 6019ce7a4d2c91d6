"""The tangent plane of a contact with friction: forces relative to their limit, and the slip."""

from __future__ import annotations

from itertools import pairwise

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

from flowlanes.system.arrays import FloatArray

from ...experiment.contact.mode_intervals import sample_modes
from ..drawing.contact_values import (
    FrictionLimits,
    relative_couple,
    relative_friction,
    relative_impulses,
    tangential,
)
from ..drawing.dataset_access import NOTHING, require_all, title_of, unit_of, with_unit
from ..drawing.modes import MODE_STYLES, mode_runs, present_modes
from ..drawing.style import FAINT, INK, QUIET, STYLE, WIDTH
from .contact_mode_bar import key

_VARIABLES = ("mode", "event_time", "attitude", "gamma")
#: Turning (rad) between two samples of sliding above which no straight chord is drawn.
_TURN = 0.05
#: Colour of the admissible region, behind the curves.
_WITHIN = "#ccd3da"


def friction_cone(dataset: xr.Dataset, limits: FrictionLimits) -> Figure:
    """Friction force relative to its limit, as the friction cone seen from above.

    The force at each sample is a point of the tangent plane of the contact; dry friction allows the
    unit disk.  If a couple about the normal has a limit too, a second plot shows force and couple
    together.  Impulses of impacts are separate points.

    Parameters
    ----------
    dataset : xarray.Dataset
        The dataset of a motion with friction.
    limits : FrictionLimits

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks a variable.
    """
    require_all(dataset, "friction_cone", (*_VARIABLES, "friction_force", "friction_couple"))
    force, struck = relative_friction(dataset, limits), relative_impulses(dataset, limits)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH if limits.arm else 4.2, 3.5), layout="constrained")
        figure.set_label(f"Friction force against its limit: {title_of(dataset)}")
        panels = np.ravel(figure.subplots(1, 2 if limits.arm else 1, squeeze=False))
        _from_above(panels[0], dataset, force, struck, limits)
        if limits.arm:
            _force_and_couple(panels[1], dataset, force, limits)
        touching = [mode for mode in present_modes(dataset) if mode != "flight"]
        if touching:
            key(figure, touching)
    return figure


def _from_above(
    axes: Axes, dataset: xr.Dataset, force: FloatArray, impulses: FloatArray, limits: FrictionLimits
) -> None:
    axes.set_aspect("equal")
    _cross(axes)
    shown = np.concatenate([force[np.isfinite(force).all(axis=1)], impulses])
    largest = float(np.max(np.linalg.norm(shown, axis=1), initial=0.0))
    under = "N"
    if limits.mu is not None:
        under = r"\mu N"
        axes.add_patch(Circle((0.0, 0.0), 1.0, facecolor=_WITHIN, alpha=0.3, linewidth=0.0))
        axes.add_patch(Circle((0.0, 0.0), 1.0, fill=False, edgecolor=INK, linewidth=0.7))
        largest = max(largest, 1.0)
    _runs(axes, dataset, force, 0.7, turning=True)
    if len(impulses):
        axes.plot(
            *impulses.T,
            "D",
            color=INK,
            markerfacecolor="#ffffff",
            markersize=3.6,
            markeredgewidth=0.7,
            label="impulse of an impact",
            zorder=5,
        )
        axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02))
    reach = 1.12 * largest if largest > NOTHING else 1.0
    axes.set_xlim(-reach, reach)
    axes.set_ylim(-reach, reach)
    axes.set_xlabel(rf"friction along $x$,  $f_x/{under}$")
    axes.set_ylabel(rf"friction along $y$,  $f_y/{under}$")


def _force_and_couple(
    axes: Axes, dataset: xr.Dataset, force: FloatArray, limits: FrictionLimits
) -> None:
    strength = np.linalg.norm(force, axis=1)
    both = np.stack([strength, relative_couple(dataset, limits)], axis=-1)
    bound = np.stack(limits.curve, axis=-1)
    good = both[np.isfinite(both).all(axis=1)]
    if limits.mu is not None:
        corners = np.concatenate([[[0.0, 0.0]], bound])
        axes.add_patch(Polygon(corners, facecolor=_WITHIN, alpha=0.3, linewidth=0.0))
        axes.plot(*bound.T, color=INK, linewidth=0.7)
        largest = np.fmax(bound.max(axis=0), good.max(axis=0, initial=0.0))
    else:
        axes.axhline(1.0, color=INK, linewidth=0.7)
        largest = np.fmax([NOTHING, 1.0], good.max(axis=0, initial=0.0))
    _runs(axes, dataset, both, 0.7)
    axes.set_xlim(0.0, 1.08 * largest[0])
    axes.set_ylim(0.0, 1.08 * largest[1])
    under = r"\mu N" if limits.mu is not None else "N"
    arm = rf"{under}a" if limits.coupled else r"\mu_s N"
    axes.set_xlabel(rf"friction force,  $|f|/{under}$")
    axes.set_ylabel(rf"friction couple,  $|\tau|/{arm}$")


def slip_hodograph(dataset: xr.Dataset) -> Figure:
    """The hodograph of the slip velocity in the tangent plane.

    A ring marks the start and a dot the end; dashed lines are jumps in impacts.

    Parameters
    ----------
    dataset : xarray.Dataset
        The dataset of a motion with friction.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks a variable.
    """
    require_all(dataset, "slip_hodograph", (*_VARIABLES, "slip", "event_impulse"))
    slip = tangential(dataset, "slip")
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(4.6, 3.6), layout="constrained")
        figure.set_label(f"Hodograph of the slip velocity: {title_of(dataset)}")
        axes = figure.add_subplot()
        axes.set_aspect("equal", adjustable="datalim")
        _cross(axes)
        _runs(axes, dataset, slip, 0.0)
        _joints(axes, dataset, slip)
        last = MODE_STYLES[sample_modes(dataset)[-1]].colour
        axes.plot(*slip[0], "o", markersize=5, color=INK, markerfacecolor="#ffffff", zorder=5)
        axes.plot(*slip[-1], "o", markersize=4, color=last, zorder=6)
        units = unit_of(dataset, "slip")
        axes.set_xlabel(with_unit("slip along $x$", units))
        axes.set_ylabel(with_unit("slip along $y$", units))
        key(figure, present_modes(dataset))
    return figure


def _cross(axes: Axes) -> None:
    """Lines through the origin."""
    axes.axhline(0.0, color=FAINT, linewidth=0.6, zorder=0)
    axes.axvline(0.0, color=FAINT, linewidth=0.6, zorder=0)


def _runs(
    axes: Axes, dataset: xr.Dataset, points: FloatArray, wider: float, turning: bool = False
) -> None:
    """Draw points (n, 2) as curves in the styles of the modes; a single point as a dot.

    If `turning` is set and vectors turn fast between samples, the curve follows their direction
    instead of a chord.
    """
    for mode, run in mode_runs(dataset):
        part = points[run]
        if turning and mode.startswith("sliding"):
            part = turned_steps(part)
        good = np.isfinite(part).all(axis=1)
        if not good.any():
            continue
        style = MODE_STYLES[mode]
        # A point that does not move is not a line.
        if float(np.max(np.ptp(part[good], axis=0))) <= NOTHING:
            size = style.width if good.sum() == 1 else 3.5
            axes.plot(
                *part[good][0],
                "o",
                color=style.colour,
                markersize=size + wider,
                markeredgewidth=0.0,
                zorder=4,
            )
        else:
            axes.plot(
                *part.T,
                color=style.colour,
                linestyle=style.dashes,
                linewidth=style.width + wider,
                zorder=3,
            )


def turned_steps(vectors: FloatArray) -> FloatArray:
    """Vectors (n, 2) with interpolated ones between those that turn by more than a few degrees.

    Direction and length change linearly between two samples.

    Examples
    --------
    >>> import numpy as np
    >>> from chaplygin.report.figures.contact_plane import turned_steps
    >>> points = turned_steps(np.array([[1.0, 0.0], [0.0, 1.0]]))
    >>> bool(np.allclose(np.hypot(*points.T), 1.0))
    True
    """
    if len(vectors) < 2 or not np.isfinite(vectors).all():
        return vectors
    length = np.linalg.norm(vectors, axis=1)
    angle = np.unwrap(np.arctan2(vectors[:, 1], vectors[:, 0]))
    parts = np.maximum(1, np.ceil(np.abs(np.diff(angle)) / _TURN)).astype(int)
    places = np.concatenate([[0.0], np.cumsum(1.0 / np.repeat(parts, parts))])
    samples = np.arange(len(vectors))
    angle, length = np.interp(places, samples, angle), np.interp(places, samples, length)
    return np.stack([length * np.cos(angle), length * np.sin(angle)], axis=-1)


def _joints(axes: Axes, dataset: xr.Dataset, points: FloatArray) -> None:
    """Join the curves before and after events: in impacts, by thin dashed lines."""
    times = np.asarray(dataset["event_time"].values)
    struck = times[np.any(dataset["event_impulse"].values != 0.0, axis=1)]
    samples = np.asarray(dataset["time"].values)
    for (mode, before), (following, after) in pairwise(mode_runs(dataset)):
        ends = points[[before.stop - 1, after.start]]
        begin, end = samples[before.stop - 1], samples[after.start]
        if np.any((struck > begin) & (struck <= end)):
            axes.plot(*ends.T, color=QUIET, linewidth=0.6, linestyle=(0, (4, 2)), zorder=2)
        else:
            moving = mode if mode.startswith("sliding") else following
            style = MODE_STYLES[moving]
            axes.plot(*ends.T, color=style.colour, linewidth=style.width, zorder=3)
