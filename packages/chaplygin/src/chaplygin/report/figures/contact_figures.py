"""All figures of a motion with friction."""

from __future__ import annotations

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from nonholonomic.mechanics.rolling.body import Body

from ...geometry.mesh import BodyMesh
from ..drawing.contact_values import FrictionLimits, presses
from ..drawing.dataset_access import NOTHING, values_of
from ..drawing.shading import Ground, PlaneGround
from ..scenes.rolling_body import scene
from .contact_mode_bar import add_mode_bars
from .contact_plane import friction_cone, slip_hodograph
from .contact_time import energy_stack, friction_share, slip_and_spin
from .integral_drift import drift, drifts
from .paths import contact_path, normal_on_sphere
from .time_series import angular_velocity, attitude, normal_force


def contact_figures(
    dataset: xr.Dataset,
    bodies: tuple[BodyMesh, Ground],
    body: Body,
    limits: FrictionLimits,
    weight: float | None = None,
) -> dict[str, Figure]:
    """The figures of a motion with friction.

    Parameters
    ----------
    dataset : xarray.Dataset
    bodies : tuple of BodyMesh and PlaneGround or SphereGround
        Mesh of the body, and its support.
    body : Body
        The body, whose mass and inertia determine the parts of the energy.
    limits : FrictionLimits
        Limits of dry friction.
    weight : float, optional
        Weight of the body, for comparison with the normal force.

    Returns
    -------
    dict
        Figures by the names of the functions that draw them; all plots against time have a bar of
        the modes. Figures of slip or friction are omitted if there is none.
    """
    pressing = bool(presses(dataset).any())
    rubs = limits.mu is not None or bool(values_of(dataset, "friction_force").any())
    near = near_support(dataset, bodies)
    charts = {
        "slip_and_spin": slip_and_spin(dataset),
        "energy_stack": energy_stack(dataset, body),
        "attitude": attitude(dataset),
        "angular_velocity": angular_velocity(dataset),
    }
    if pressing:
        charts["normal_force"] = normal_force(dataset, weight)
    if pressing and rubs:
        charts["friction_share"] = friction_share(dataset, limits)
    if drifts(dataset):
        charts["drift"] = drift(dataset)
    for figure in charts.values():
        add_mode_bars(figure, dataset)
    figures = {
        "scene": scene(near, *bodies),
        "contact_path": contact_path(near, bodies[1]),
        "normal_on_sphere": normal_on_sphere(dataset),
    }
    if np.nanmax(np.abs(values_of(dataset, "slip")), initial=0.0) > NOTHING:
        figures["slip_hodograph"] = slip_hodograph(dataset)
    if rubs and (pressing or dataset["event_impulse"].values.any()):
        figures["friction_cone"] = friction_cone(dataset, limits)
    return figures | charts


def near_support(dataset: xr.Dataset, bodies: tuple[BodyMesh, Ground]) -> xr.Dataset:
    """The part of a motion until the body has left a sphere by its own diameter.

    Above a plane it is the whole motion.
    """
    outline, ground = bodies
    away = values_of(dataset, "gap") > outline.diameter
    if isinstance(ground, PlaneGround) or not away.any():
        return dataset
    return dataset.isel(time=slice(0, max(int(np.argmax(away)), 2)))
