"""Quantities against time: angular velocity, normal force, drift of what is conserved."""

from __future__ import annotations

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...core.arrays import FloatArray
from ...errors import InputError
from ..drawing.dataset_access import (
    NOTHING,
    readable,
    require,
    times_of,
    title_of,
    unit_of,
    values_of,
    with_unit,
)
from ..drawing.geometry import rotation_matrices
from ..drawing.style import ALARM, COMPONENTS, FAINT, INK, QUIET, SERIES, STYLE, WIDTH

_MOST = 0.995
"""Share of the instants whose ratio of friction to normal force is within the picture."""

_DOTS = 400
"""Dots with which a drift is drawn, about."""


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
    require(dataset, "angular_velocity")
    times, omega = times_of(dataset), values_of(dataset, "omega")
    with mpl.rc_context(STYLE):
        figure, axes = _chart(dataset, 2.9, "Angular velocity in body axes")
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
    require(dataset, "normal_force")
    times, force = times_of(dataset), values_of(dataset, "normal_force")
    with mpl.rc_context(STYLE):
        figure, axes = _chart(dataset, 2.6, "Normal force")
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
        _legend_above(axes, 3)
    return figure


def friction_ratio(dataset: xr.Dataset) -> Figure:
    """How large a coefficient of friction rolling needs: friction over normal force.

    Instants at which the surface does not press have no ratio and are left out.

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
    """
    require(dataset, "friction_ratio")
    times, ratio = times_of(dataset), needed_friction(dataset)
    if not np.isfinite(ratio).any():
        raise InputError(
            f"the figure friction_ratio needs a normal force that presses, and that of "
            f"{title_of(dataset)} never does"
        )
    with mpl.rc_context(STYLE):
        figure, axes = _chart(dataset, 2.2, "Friction over normal force")
        axes.plot(times, ratio, color=COMPONENTS[0], marker=marker(times), zorder=3)
        # where the surface hardly presses the ratio has no bound
        top = 1.1 * float(np.nanquantile(ratio, _MOST))
        axes.set_ylim(0.0, top if top > NOTHING else 1.0)
        axes.set_ylabel("friction over normal force")
    return figure


def presses(dataset: xr.Dataset) -> bool:
    """Whether there is any normal force: none acts on a balanced ball without weight."""
    force = values_of(dataset, "normal_force")
    return bool(np.max(np.abs(force), initial=0.0, where=np.isfinite(force)) > NOTHING)


def needed_friction(dataset: xr.Dataset) -> FloatArray:
    """|friction force| / normal force, (n,); not-a-number where the surface does not press."""
    normal = values_of(dataset, "normal_force")
    friction = np.linalg.norm(values_of(dataset, "friction_force"), axis=1)
    pressing = normal > NOTHING
    return np.where(pressing, friction / np.where(pressing, normal, 1.0), np.nan)


def attitude(dataset: xr.Dataset) -> Figure:
    """Three angles of the body's axes against space.

    Euler's angles ψ, θ, φ, or yaw, pitch and roll: those that are farther from where they are not
    defined.  Whole turns are counted on.

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
    """
    require(dataset, "attitude")
    times = times_of(dataset)
    names, angles = turning_angles(values_of(dataset, "attitude"))
    with mpl.rc_context(STYLE):
        figure, axes = _chart(dataset, 2.6, "Angles of the body in space")
        for label, values, colour in zip(names, angles, COMPONENTS, strict=True):
            axes.plot(times, values, color=colour, marker=marker(times), label=label)
        axes.axhline(0.0, color=QUIET, linewidth=0.6, zorder=1)
        axes.set_ylabel(with_unit("angle", "rad"))
        widen(axes, np.concatenate(angles))
        _legend_above(axes, 3)
    return figure


def turning_angles(quaternions: FloatArray) -> tuple[tuple[str, str, str], list[FloatArray]]:
    """Labels and values of three angles that belong to quaternions (n, 4), body to space."""
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
    return names, [_unwound(first), middle, _unwound(last)]


def _unwound(angle: FloatArray) -> FloatArray:
    """An angle that does not jump by whole turns, not-a-number where it was."""
    good = np.isfinite(angle)
    found = angle.copy()
    found[good] = np.unwrap(angle[good])
    return found


def drift(dataset: xr.Dataset) -> Figure:
    """Relative drift of each integral against time, on a logarithmic scale.

    Dots are samples (some hundreds of them), lines the largest drift so far. Samples that agree
    with the first one to the last bit lie on the line marked 0 at the foot.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs at least one variable `law_<name>`.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset has nothing that is conserved.
    """
    names = conserved(dataset)
    if not names:
        raise InputError(
            f"the figure drift needs an integral, and the trajectory of {title_of(dataset)} has "
            "none"
        )
    times = times_of(dataset)
    drifts = {name: relative_drift(dataset, name) for name in names}
    positive = np.concatenate([values[values > 0.0] for values in drifts.values()])
    smallest = float(positive.min()) if len(positive) else 1e-16
    floor = 1e-17 if smallest > 1e-17 else 10.0 ** (np.floor(np.log10(smallest)) - 1.0)
    with mpl.rc_context(STYLE):
        labels = {name: _law_label(dataset, name) for name in names}
        columns = 2 if max(map(len, labels.values())) < 50 else 1
        rows = -(-len(names) // columns)
        figure, axes = _chart(dataset, 2.7 + 0.19 * rows, "Drift of the first integrals")
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
                linestyle="-" if number < len(SERIES) else (0, (4, 1.5)),
                marker=marker(times),
                zorder=3,
            )
        largest = float(positive.max()) if len(positive) else floor
        axes.set_ylim(floor / 2.5, max(10.0 * largest, 100.0 * floor))
        axes.axhline(floor, color=QUIET, linewidth=0.6, zorder=1)
        _mark_floor(axes, floor)
        axes.set_ylabel("relative drift")
        _legend_above(axes, columns)
    return figure


def relative_drift(dataset: xr.Dataset, name: str) -> FloatArray:
    """How far a conserved quantity has moved from its first value, relative to that value.

    A quantity that starts at zero but for rounding has no scale of its own; its drift is given
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
    values = values_of(dataset, name)
    change = values - values[0]
    if f"{name}_low" in dataset:
        low = values_of(dataset, f"{name}_low")
        change = change + (low - low[0])
    scale = 1.0 if _starts_at_zero(values) else abs(float(values[0]))
    return np.asarray(np.abs(change) / scale, dtype=np.float64)


def _starts_at_zero(values: FloatArray) -> bool:
    """Whether the first value is zero but for rounding: tiny, and lost among the changes.

    Tiny alone would not do: the squared momentum of a coin is 1e-10 in SI units.
    """
    first = abs(float(values[0]))
    change = np.max(np.abs(values - values[0]), initial=0.0, where=np.isfinite(values))
    return first == 0.0 or bool(first < NOTHING and change > 1e-6 * first)


def conserved(dataset: xr.Dataset) -> list[str]:
    """Variables that ought to stay constant, that of the energy first.

    An energy that is recorded and is no integral is not among them.
    """
    laws = sorted(
        str(name)
        for name in dataset.data_vars
        if str(name).startswith("law_") and not str(name).endswith("_low")
    )
    return sorted(laws, key=lambda name: name != "law_energy")


def drifts(dataset: xr.Dataset) -> bool:
    """Whether anything that ought to stay constant changes by a bit or more."""
    return any(np.nanmax(relative_drift(dataset, name)) > 0.0 for name in conserved(dataset))


def _law_label(dataset: xr.Dataset, name: str) -> str:
    meaning = str(dataset[name].attrs.get("long_name", "")) or name.removeprefix("law_")
    absolute = _starts_at_zero(values_of(dataset, name))
    return readable(meaning) + ("  (absolute)" if absolute else "")


def _mark_floor(axes: Axes, floor: float) -> None:
    """Ticks at powers of ten above the floor, and a tick 0 at the floor."""
    low, high = np.log10(floor), np.log10(axes.get_ylim()[1])
    step = max(1, int(np.ceil((high - low) / 7)))
    powers = np.arange(np.ceil(low) + step, high + 1e-9, step)
    axes.set_yticks([floor, *10.0**powers], ["0", *(f"$10^{{{int(power)}}}$" for power in powers)])
    axes.set_yticks([], minor=True)


def time_label(dataset: xr.Dataset) -> str:
    """The label of an axis of time."""
    return with_unit("time  $t$", unit_of(dataset, "time"))


def _chart(dataset: xr.Dataset, height: float, description: str) -> tuple[Figure, Axes]:
    """A figure with one plot against time."""
    figure = Figure(figsize=(WIDTH, height), layout="constrained")
    figure.set_label(f"{description}: {title_of(dataset)}")
    axes = figure.add_subplot()
    axes.set_xlabel(time_label(dataset))
    times = times_of(dataset)
    if times[-1] > times[0]:
        axes.set_xlim(times[0], times[-1])
    axes.grid(axis="y", color=FAINT, linewidth=0.4)
    axes.set_axisbelow(True)
    return figure, axes


def widen(axes: Axes, values: FloatArray) -> None:
    """Limits with room around the values, also around values that are alike but for rounding."""
    finite = values[np.isfinite(values)]
    if not len(finite):
        return
    low, high = float(finite.min()), float(finite.max())
    middle = max(abs(low), abs(high))
    room = max(0.06 * (high - low), 1e-3 * middle)
    if room < NOTHING:
        room = 1.0
    axes.set_ylim(low - room, high + room)


def marker(times: FloatArray) -> str:
    """A single sample is no line: it is marked."""
    return "o" if len(times) == 1 else ""


def _legend_above(axes: Axes, columns: int) -> None:
    # On the right: the left end is where a power of ten common to the ticks is written.
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.02), ncols=columns)
