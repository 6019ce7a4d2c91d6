"""A contact with friction over time: slip, friction relative to its limit, energy."""

from __future__ import annotations

from dataclasses import dataclass

import matplotlib as mpl
import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from flowlanes.system.arrays import FloatArray
from nonholonomic.mechanics.rolling.body import Body

from ..drawing.contact_values import FrictionLimits, relative_couple, relative_friction, tangential
from ..drawing.dataset_access import (
    NOTHING,
    require_all,
    times_of,
    title_of,
    unit_of,
    values_of,
    with_unit,
)
from ..drawing.modes import MODE_STYLES, mode_runs
from ..drawing.style import COMPONENTS, FAINT, INK, QUIET, STYLE, WIDTH
from .time_axis import legend_above, marker, time_chart, time_label, widen

#: Colours of stored energy, and of dissipated energy, whose areas are hatched.
_STORE_COLOURS = ("#004488", "#ddaa33")
_LOSS_COLOURS = ("#cc6677", "#999933", "#117733", "#aa4499", "#44aa99", "#88ccee")

#: Dissipation mechanisms, by the suffixes of variable names.
LOSSES = {
    "coulomb": "dry friction",
    "contensou": "dry friction over the patch",
    "spin": "friction against spin",
    "viscous": "viscous friction",
    "slip": "friction in proportion to slip",
    "power": "friction by a power of slip",
    "user": "friction by formulas",
    "rolling": "resistance to rolling",
    "viscous_rolling": "viscous resistance to rolling",
    "contour": "resistance along the contour",
    "impact": "impacts",
    "support": "the moving support",
}


@dataclass(frozen=True)
class EnergyPart:
    """A form of energy along a motion.

    Attributes
    ----------
    words : str
    values : array (n,)
        Values in J.
    is_loss : bool
        Whether the body has lost it.
    """

    words: str
    values: FloatArray
    is_loss: bool


def energy_parts(dataset: xr.Dataset, body: Body) -> list[EnergyPart]:
    """The energy balance: kinetic, potential above its minimum, work dissipated by each law.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `energy`, `velocity`, `omega` and the work lost, `work_<law>`.
    body : Body
    """
    require_all(dataset, "energy_stack", ("energy", "velocity", "omega"))
    velocity, omega = values_of(dataset, "velocity"), values_of(dataset, "omega")
    inertia = np.array(body.inertia, dtype=np.float64)
    inertia = np.diag(inertia) if inertia.ndim == 1 else inertia
    kinetic = 0.5 * body.mass * np.sum(velocity**2, axis=1)
    kinetic = kinetic + 0.5 * np.einsum("ni,ij,nj->n", omega, inertia, omega)
    potential = values_of(dataset, "energy") - kinetic
    parts = [
        EnergyPart("kinetic", kinetic, False),
        EnergyPart("potential, above its lowest", potential - np.nanmin(potential), False),
    ]
    for name in map(str, dataset.data_vars):
        if not name.startswith("work_"):
            continue
        law = name.removeprefix("work_")
        values = values_of(dataset, name)
        if law == "impact" and not values.any():
            continue
        meaning = str(dataset[name].attrs.get("long_name", law))
        words = LOSSES.get(law, meaning.removeprefix("work lost to ").partition(",")[0])
        parts.append(EnergyPart(f"lost to {words}", values, True))
    return parts


def energy_stack(dataset: xr.Dataset, body: Body) -> Figure:
    """The energy over time, as a stack of its forms.

    Energy supplied by a moving support is below zero; the height above it is the total, which is
    constant.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs `energy`, `velocity`, `omega` and the work lost.
    body : Body

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    InputError
        If the dataset lacks a variable.
    """
    parts = energy_parts(dataset, body)
    times = times_of(dataset)
    total = np.sum([part.values for part in parts], axis=0)
    size = float(np.nanmax(np.abs(total)))
    shown = [p for p in parts if np.nanmax(np.abs(p.values)) > NOTHING * size]
    with mpl.rc_context(STYLE):
        figure, axes = time_chart(dataset, 3.3, "What became of the energy")
        above, below = np.zeros_like(times), np.zeros_like(times)
        colours = {False: iter(_STORE_COLOURS), True: iter(_LOSS_COLOURS)}
        for part in shown:
            positive = float(np.nanmin(part.values)) >= -NOTHING * size
            up, down = np.fmax(part.values, 0.0), np.fmin(part.values, 0.0)
            colour = next(colours[part.is_loss])
            _area(axes, times, above, above + up, part, colour)
            if not positive:
                _area(axes, times, below, below + down, part, colour, with_label=False)
            above, below = above + up, below + down
        axes.plot(times, total, color=INK, linewidth=1.1, label="total")
        low, high = float(np.nanmin(below)), float(np.nanmax(above))
        axes.set_ylim(1.05 * low, 1.05 * high if high > 0.0 else 1.0)
        axes.set_ylabel(with_unit("energy", unit_of(dataset, "energy")))
        legend_above(axes, 2)
    return figure


def _area(
    axes: Axes,
    times: FloatArray,
    low: FloatArray,
    high: FloatArray,
    part: EnergyPart,
    colour: str,
    with_label: bool = True,
) -> None:
    axes.fill_between(
        times,
        low,
        high,
        facecolor=colour,
        edgecolor="#ffffff",
        linewidth=0.0,
        hatch="////" if part.is_loss else "",
        label=part.words if with_label else "",
        zorder=2,
    )


def slip_and_spin(dataset: xr.Dataset) -> Figure:
    """Slip speed and spin of the contact over time, in the styles of the modes.

    In flight they are those of the body's point nearest to the support; its height is then a third
    plot.

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
    needed = ("mode", "event_time", "attitude", "gamma", "slip", "spin", "gap")
    require_all(dataset, "slip_and_spin", needed)
    speed = np.linalg.norm(tangential(dataset, "slip"), axis=1)
    curves = [("slip  $|u|$", "slip", speed), (r"spin  $\Omega$", "spin", None)]
    gap = values_of(dataset, "gap")
    times = times_of(dataset)
    if any(mode == "flight" for mode, _ in mode_runs(dataset)):
        curves.append(("height", "gap", np.fmax(gap, 0.0)))
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=(WIDTH, 0.5 + 1.45 * len(curves)), layout="constrained")
        figure.set_label(f"Slip and spin of the contact: {title_of(dataset)}")
        panels = np.ravel(figure.subplots(len(curves), 1, sharex=True))
        for axes, (words, name, given) in zip(panels, curves, strict=True):
            values = values_of(dataset, name) if given is None else given
            for mode, run in mode_runs(dataset):
                style = MODE_STYLES[mode]
                axes.plot(
                    times[run],
                    values[run],
                    color=style.colour,
                    linestyle=style.dashes,
                    linewidth=style.width,
                    marker=marker(times[run]),
                    markersize=1.5,
                )
            axes.axhline(0.0, color=QUIET, linewidth=0.6, zorder=1)
            axes.grid(axis="y", color=FAINT, linewidth=0.4)
            axes.set_axisbelow(True)
            axes.set_ylabel(with_unit(words, unit_of(dataset, name)))
            widen(axes, np.append(values, 0.0))
            if name != "spin":
                # Lengths are not negative.
                axes.set_ylim(bottom=min(0.0, -0.03 * axes.get_ylim()[1]))
        if times[-1] > times[0]:
            panels[-1].set_xlim(times[0], times[-1])
        panels[-1].set_xlabel(time_label(dataset))
        figure.align_ylabels(list(panels))
    return figure


def friction_share(dataset: xr.Dataset, limits: FrictionLimits) -> Figure:
    """Friction force, and couple about the normal, relative to their limits over time.

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
    needed = ("mode", "event_time", "attitude", "gamma", "friction_force", "friction_couple")
    require_all(dataset, "friction_share", needed)
    times = times_of(dataset)
    under = r"\mu N" if limits.mu is not None else "N"
    curves = [
        (rf"force  $|f|/{under}$", np.linalg.norm(relative_friction(dataset, limits), axis=1))
    ]
    if limits.arm:
        arm = rf"{under}a" if limits.coupled else r"\mu_s N"
        curves.append((rf"couple  $|\tau|/{arm}$", relative_couple(dataset, limits)))
    with mpl.rc_context(STYLE):
        figure, axes = time_chart(dataset, 2.4, "Friction over its limit")
        largest = 0.0
        for (label, values), colour in zip(curves, COMPONENTS, strict=False):
            # The ends of an interval without an event, so that a jump is not drawn as a line.
            for number, (_, run) in enumerate(mode_runs(dataset)):
                axes.plot(
                    times[run],
                    values[run],
                    color=colour,
                    marker=marker(times[run]),
                    markersize=1.5,
                    label="" if number else label,
                    zorder=3,
                )
            largest = max(largest, float(np.nanmax(values, initial=0.0)))
        if limits.mu is not None:
            axes.axhline(1.0, color=INK, linewidth=0.7, linestyle=(0, (5, 3)), label="limit")
            largest = max(largest, 1.0)
        axes.set_ylim(0.0, 1.1 * largest if largest > NOTHING else 1.0)
        axes.set_ylabel("share of the limit" if limits.mu is not None else "over normal force")
        legend_above(axes, 3)
    return figure
