"""Angular velocity, attitude and contact forces over time."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.arrays import FloatArray

from ...geometry.view import rotation_matrices
from ..drawing.dataset_access import (
    NOTHING,
    require,
    times_of,
    title_of,
    unit_of,
    values_of,
    with_unit,
)
from ..drawing.style import ALARM, COMPONENTS, INK, QUIET, STYLE
from .time_axis import legend_above, marker, time_chart, time_charts, widen

_MOST = 0.995
"""Fraction of the times whose ratio of friction to normal force is within the picture."""

_TURNS = 4.0 * np.pi
"""Change of an angle above which it gets a separate plot."""


@arguments_checked
def angular_velocity(dataset: xr.Dataset) -> Figure:
    """Components of the angular velocity in body axes, and its magnitude, over time.

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

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.angular_velocity(dataset)
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['angular velocity  (rad/s)']
    """
    require(dataset, "angular_velocity")
    times, omega = times_of(dataset), values_of(dataset, "omega")
    with mpl.rc_context(STYLE):
        figure, axes = time_chart(dataset, 2.9, "Angular velocity in body axes")
        length = np.linalg.norm(omega, axis=1)
        for axis, colour in enumerate(COMPONENTS):
            axes.plot(
                times,
                omega[:, axis],
                color=colour,
                marker=marker(times),
                label=rf"$\omega_{axis + 1}$",
            )
        axes.plot(
            times,
            length,
            color=INK,
            linewidth=0.8,
            linestyle=(0, (4, 2)),
            marker=marker(times),
            label=r"$|\omega|$",
        )
        axes.axhline(0.0, color=QUIET, linewidth=0.6, zorder=1)
        axes.set_ylabel(with_unit("angular velocity", unit_of(dataset, "omega")))
        widen(axes, np.concatenate([omega.ravel(), length]))
        legend_above(axes, 4)
    return figure


@arguments_checked
def normal_force(dataset: xr.Dataset, weight: float | None = None) -> Figure:
    """The normal force of the surface on the body over time.

    Times at which it is negative, so that the body would leave the surface, are shaded.

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

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.normal_force(dataset, weight=9.81)
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['normal force  (N)']
    """
    require(dataset, "normal_force")
    times, force = times_of(dataset), values_of(dataset, "normal_force")
    with mpl.rc_context(STYLE):
        figure, axes = time_chart(dataset, 2.6, "Normal force")
        axes.plot(
            times,
            force,
            color=COMPONENTS[0],
            marker=marker(times),
            label="normal force  $N$",
            zorder=3,
        )
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
        widen(axes, np.concatenate([force, reference]))
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
                alpha=0.25,
                linewidth=0.0,
                zorder=2,
                label="contact would be lost",
            )
        else:
            axes.set_ylim(0.0, high)
        axes.set_ylabel(with_unit("normal force", unit_of(dataset, "normal_force")))
        legend_above(axes, 3)
    return figure


@arguments_checked
def friction_ratio(dataset: xr.Dataset) -> Figure:
    """The friction coefficient required for rolling, over time.

    Times without a positive normal force have no ratio and are omitted.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `normal_force` and `friction_force`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks one of them, or the surface presses at no instant.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.friction_ratio(dataset)
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['friction over normal force']
    """
    require(dataset, "friction_ratio")
    times, ratio = times_of(dataset), needed_friction(dataset)
    if not np.isfinite(ratio).any():
        raise InputError(
            f"the figure friction_ratio needs a normal force that presses, and that of "
            f"{title_of(dataset)} never does"
        )
    with mpl.rc_context(STYLE):
        figure, axes = time_chart(dataset, 2.2, "Friction over normal force")
        axes.plot(times, ratio, color=COMPONENTS[0], marker=marker(times), zorder=3)
        # the ratio is unbounded where the normal force is small
        top = 1.1 * float(np.nanquantile(ratio, _MOST))
        axes.set_ylim(0.0, top if top > NOTHING else 1.0)
        axes.set_ylabel("friction over normal force")
    return figure


def presses(dataset: xr.Dataset) -> bool:
    """Whether there is any normal force; none acts on a balanced ball without weight."""
    force = values_of(dataset, "normal_force")
    return bool(np.max(np.abs(force), initial=0.0, where=np.isfinite(force)) > NOTHING)


def needed_friction(dataset: xr.Dataset) -> FloatArray:
    """Friction over normal force, (n,); NaN without a positive normal force."""
    normal = values_of(dataset, "normal_force")
    friction = np.linalg.norm(values_of(dataset, "friction_force"), axis=1)
    pressing = normal > NOTHING
    return np.where(pressing, friction / np.where(pressing, normal, 1.0), np.nan)


@arguments_checked
def attitude(dataset: xr.Dataset) -> Figure:
    """Three angles between body axes and space axes.

    Either Euler's angles ψ, θ, φ, or yaw, pitch and roll: those that stay farther from their
    singularity.  Whole turns are counted; angles with several turns have a separate plot.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `attitude`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks the attitude.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figure = report.figures.attitude(dataset)
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['angle  (rad)']
    """
    require(dataset, "attitude")
    times = times_of(dataset)
    names, angles = turning_angles(values_of(dataset, "attitude"))
    curves = list(zip(names, angles, COMPONENTS, strict=False))
    # Beside an angle with many turns the others would look flat.
    turning = [curve for curve in curves if np.nanmax(curve[1]) - np.nanmin(curve[1]) > _TURNS]
    others = [curve for curve in curves if not any(curve is other for other in turning)]
    groups = [group for group in (turning, others) if group]
    with mpl.rc_context(STYLE):
        heights = [2.6] if len(groups) == 1 else [2.0, 2.0]
        figure, panels = time_charts(dataset, heights, "Angles of the body in space")
        for axes, group in zip(panels, groups, strict=True):
            for label, values, colour in group:
                axes.plot(times, values, color=colour, marker=marker(times), label=label)
            axes.axhline(0.0, color=QUIET, linewidth=0.6, zorder=1)
            axes.set_ylabel(with_unit("angle", "rad"))
            widen(axes, np.concatenate([values for _, values, _ in group]))
            legend_above(axes, 3)
    return figure


def turning_angles(quaternions: FloatArray) -> tuple[tuple[str, str, str], list[FloatArray]]:
    """Labels and values of three angles of quaternions (n, 4), body to space."""
    R = rotation_matrices(quaternions)
    tilt = np.arccos(np.clip(R[:, 2, 2], -1.0, 1.0))
    pitch = np.arcsin(np.clip(-R[:, 2, 0], -1.0, 1.0))
    if np.nanmin(np.sin(tilt)) >= np.nanmin(np.cos(pitch)):
        names = (r"precession $\psi$", r"nutation $\theta$", r"spin $\varphi$")
        first, last = np.arctan2(R[:, 0, 2], -R[:, 1, 2]), np.arctan2(R[:, 2, 0], R[:, 2, 1])
        middle = tilt
    else:
        names = ("yaw", "pitch", "roll")
        first, last = np.arctan2(R[:, 1, 0], R[:, 0, 0]), np.arctan2(R[:, 2, 1], R[:, 2, 2])
        middle = pitch
    return names, [_continuous_angle(first), middle, _continuous_angle(last)]


def _continuous_angle(angle: FloatArray) -> FloatArray:
    """An angle without jumps by whole turns; NaN where it was NaN."""
    good = np.isfinite(angle)
    angles = angle.copy()
    angles[good] = np.unwrap(angle[good])
    return angles
