"""Quantities of a contact with friction for figures, from a motion's dataset."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import xarray as xr

from flowlanes.system.arrays import BoolArray, FloatArray
from nonholonomic.contact.equations.situation import FrictionalContact
from nonholonomic.contact.pressure.pressure import Hertz

from ...experiment.contact.mode_intervals import event_times
from ...geometry.view import rotation_matrices, unit
from .dataset_access import times_of, values_of

#: Fraction of the largest normal force below which it counts as zero.
_NO_FORCE = 1e-9

#: Relative size below which the component of an impulse across the normal counts as rounding.
_ROUNDING = 1e-13


@dataclass(frozen=True)
class FrictionLimits:
    """Limits of dry friction proportional to the normal force.

    Attributes
    ----------
    mu : float or None
        Largest force over normal force; None if no law of dry friction limits it.
    arm : float
        Length (m) by which the couple about the normal is divided: the radius of the patch of
        contact, with a further division by μ, or the arm of a spin couple; 0 without either.
    coupled : bool
        Whether force and couple have a common limit.

    Examples
    --------
    >>> from chaplygin.report.drawing.contact_values import FrictionLimits
    >>> FrictionLimits(0.3, 5e-4, coupled=True).couple_unit
    0.00015
    """

    mu: float | None = None
    arm: float = 0.0
    coupled: bool = False

    @property
    def force_unit(self) -> float:
        """The force over normal force that is drawn with unit length."""
        return self.mu or 1.0

    @property
    def couple_unit(self) -> float:
        """The couple over normal force (m) that is drawn with unit length."""
        return self.force_unit * self.arm if self.coupled else self.arm

    @property
    def curve(self) -> tuple[FloatArray, FloatArray]:
        """Force and couple at their limit, in these units."""
        if not self.coupled:
            return np.array([0.0, 1.0, 1.0]), np.array([1.0, 1.0, 0.0])
        k = np.concatenate([np.linspace(0.0, 2.0, 201), 2.0 / np.linspace(1.0, 0.0, 100)[1:-1]])
        k = np.append(k, math.inf)
        return Hertz().force(k), Hertz().couple(k)


def friction_limits(contact: FrictionalContact) -> FrictionLimits:
    """The limits of dry friction of a contact."""
    for law in contact.laws:
        if law.patch_radius:
            return FrictionLimits(law.static_mu, law.patch_radius, coupled=True)
    known = [law.static_mu for law in contact.laws if law.static_mu]
    mu = min(known, default=math.inf)
    arm = sum(law.spin_arm for law in contact.laws)
    return FrictionLimits(mu if math.isfinite(mu) else None, arm)


def presses(dataset: xr.Dataset) -> BoolArray:
    """Whether the support presses on the body, at each sample."""
    force = values_of(dataset, "normal_force")
    return np.asarray(force > _NO_FORCE * np.nanmax(np.abs(force), initial=0.0))


def tangential(dataset: xr.Dataset, name: str) -> FloatArray:
    """Components (n, 2) of a vector of the body in the tangent plane of the contact.

    Along the axes x and y of space; if the tangent plane is not horizontal, along these rotated
    into it by the shortest rotation.

    Parameters
    ----------
    dataset : xarray.Dataset
        Needs the vector, `gamma` and `attitude`.
    name : str
        A variable with components along the body axes.
    """
    attitude = values_of(dataset, "attitude")
    return in_tangent_plane(values_of(dataset, name), values_of(dataset, "gamma"), attitude)


def in_tangent_plane(vectors: FloatArray, gamma: FloatArray, attitude: FloatArray) -> FloatArray:
    """Components (n, 2) of body vectors (n, 3) perpendicular to the normals `gamma` (n, 3)."""
    rotation = rotation_matrices(attitude)
    space = np.einsum("nij,nj->ni", rotation, vectors)
    x, y, z = unit(np.einsum("nij,nj->ni", rotation, gamma)).T
    # Rotate the vertical onto the normal, or onto its opposite if that is nearer throughout.
    side = 1.0 if np.min(z, initial=1.0) > -0.9 else -1.0
    share = 1.0 / np.maximum(1.0 + side * z, 1e-12)
    first = np.stack([1.0 - share * x * x, -share * x * y, -side * x], axis=-1)
    second = np.stack([-share * x * y, 1.0 - share * y * y, -side * y], axis=-1)
    return np.stack([np.sum(first * space, axis=-1), np.sum(second * space, axis=-1)], axis=-1)


def relative_friction(dataset: xr.Dataset, limits: FrictionLimits) -> FloatArray:
    """Components (n, 2) of the friction force over its largest value; NaN without normal force."""
    return _over_normal_force(dataset, tangential(dataset, "friction_force")) / limits.force_unit


def relative_couple(dataset: xr.Dataset, limits: FrictionLimits) -> FloatArray:
    """The couple about the normal over its unit, (n,); NaN without normal force."""
    couple, gamma = values_of(dataset, "friction_couple"), values_of(dataset, "gamma")
    about = np.abs(np.sum(couple * unit(gamma), axis=1))
    return _over_normal_force(dataset, about[:, None])[:, 0] / limits.couple_unit


def _over_normal_force(dataset: xr.Dataset, values: FloatArray) -> FloatArray:
    pressing = presses(dataset)
    force = np.where(pressing, values_of(dataset, "normal_force"), 1.0)
    return np.where(pressing[:, None], values / force[:, None], np.nan)


def event_impulses(dataset: xr.Dataset) -> tuple[FloatArray, FloatArray]:
    """The impulse of the support at each event: along the normal (m,) and across it (m, 2).

    The components across the normal are those of :func:`tangential` (N s).
    """
    impulses = np.asarray(dataset["event_impulse"].values, dtype=np.float64).reshape(-1, 3)
    states = dataset["event_state_before"].values
    columns = [str(name) for name in dataset["state"].values]
    attitude = states[:, [columns.index(f"attitude_{part}") for part in "wxyz"]]
    gamma = _event_normals(dataset, states, columns)
    across = in_tangent_plane(impulses, gamma, attitude)
    lengths = np.linalg.norm(impulses, axis=1)
    across[np.linalg.norm(across, axis=1) <= _ROUNDING * lengths] = 0.0
    return np.sum(impulses * gamma, axis=1), across


def relative_impulses(dataset: xr.Dataset, limits: FrictionLimits) -> FloatArray:
    """Components (k, 2) of the tangential impulses of impacts, over the normal ones.

    In the units of the force; events without impulse are omitted.
    """
    normal, across = event_impulses(dataset)
    pressing = normal > 0.0
    return across[pressing] / normal[pressing, None] / limits.force_unit


def _event_normals(dataset: xr.Dataset, states: FloatArray, columns: list[str]) -> FloatArray:
    """Unit normals (m, 3) at events, body axes."""
    names = [f"gamma_{axis}" for axis in (1, 2, 3)]
    if all(name in columns for name in names):
        return unit(states[:, [columns.index(name) for name in names]])
    # Bodies of other shapes have their contact point as state.
    times, samples = event_times(dataset), times_of(dataset)
    gamma = values_of(dataset, "gamma")
    return unit(np.stack([np.interp(times, samples, column) for column in gamma.T], axis=-1))
