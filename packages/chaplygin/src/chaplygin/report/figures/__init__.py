"""Figures of a trajectory: body, paths, time series, conserved quantities.

Every figure is a function of a trajectory's dataset (and, for the drawn body, of its outline and
support) and returns a `matplotlib.figure.Figure`; no global state is changed.  Missing variables
raise an `InputError`; `all_figures` omits such figures.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import xarray as xr
from matplotlib.figure import Figure

from flowlanes.arguments import arguments_checked

from ...geometry.ball_surface import SurfaceGround
from ...geometry.mesh import BodyMesh
from ..drawing.dataset_access import VARIABLES, title_of
from ..drawing.files import FORMATS, page_svg, page_svgs, save, svg_file, svg_text
from ..drawing.shading import Ground
from ..drawing.style import STYLE
from ..scenes.ball import ball_scene
from ..scenes.planar_mechanism import plan_view
from ..scenes.rolling_body import scene
from .bifurcation import draw_bifurcation_diagram as bifurcation_diagram
from .bifurcation_revolution import draw_revolution_diagram as revolution_diagram
from .closed_form import closed_form
from .integral_drift import drift, drifts, relative_drift
from .paths import contact_path, normal_on_sphere
from .state import state
from .time_series import (
    angular_velocity,
    attitude,
    friction_ratio,
    needed_friction,
    normal_force,
    presses,
)

__all__ = [
    "FORMATS",
    "STYLE",
    "all_figures",
    "angular_velocity",
    "attitude",
    "ball_figures",
    "ball_scene",
    "bifurcation_diagram",
    "closed_form",
    "contact_path",
    "drift",
    "friction_ratio",
    "normal_force",
    "normal_on_sphere",
    "page_svg",
    "page_svgs",
    "plan_view",
    "relative_drift",
    "revolution_diagram",
    "save",
    "scene",
    "state",
    "state_figures",
    "svg_file",
    "svg_text",
]


@arguments_checked
def all_figures(
    dataset: xr.Dataset,
    bodies: tuple[BodyMesh, Ground] | tuple[BodyMesh, SurfaceGround] | None = None,
    weight: float | None = None,
) -> dict[str, Figure]:
    """Every figure for which the trajectory has the variables.

    Parameters
    ----------
    dataset : xarray.Dataset
    bodies : tuple of BodyMesh and ground, optional
        Shape of the body and what it rolls on, a PlaneGround, a SphereGround or a SurfaceGround;
        without them there is neither scene nor path of the contact point, and on the last no path
        besides that of the scene.
    weight : float, optional
        Weight of the body, for comparison with the normal force.

    Returns
    -------
    dict
        Figures by the names of the functions that make them: `scene`, `contact_path`,
        `normal_on_sphere`, `attitude`, `angular_velocity`, `normal_force`, `friction_ratio`,
        `drift`, in this order.  There is no normal force where the surface never presses or pulls,
        and no friction ratio without a weight.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> sorted(report.figures.all_figures(dataset))
    ['angular_velocity', 'attitude', 'drift', 'normal_force', 'normal_on_sphere']
    """
    possible = {
        name for name, needed in VARIABLES.items() if all(item in dataset for item in needed)
    }
    figures: dict[str, Figure] = {}
    if bodies is not None:
        outline, ground = bodies
        figures |= _pictures(dataset, outline, ground, possible)
    if "normal_on_sphere" in possible:
        figures["normal_on_sphere"] = normal_on_sphere(dataset)
    if "attitude" in possible:
        figures["attitude"] = attitude(dataset)
    if "angular_velocity" in possible:
        figures["angular_velocity"] = angular_velocity(dataset)
    figures |= _forces(dataset, weight)
    if drifts(dataset):
        figures["drift"] = drift(dataset)
    return figures


def _forces(dataset: xr.Dataset, weight: float | None) -> dict[str, Figure]:
    """The figures of the contact forces, if there are any."""
    figures: dict[str, Figure] = {}
    if "normal_force" in dataset and presses(dataset):
        figures["normal_force"] = normal_force(dataset, weight)
        if weight and "friction_force" in dataset and np.isfinite(needed_friction(dataset)).any():
            figures["friction_ratio"] = friction_ratio(dataset)
    return figures


@arguments_checked
def state_figures(
    dataset: xr.Dataset, names: Sequence[str], records: Sequence[str] = ()
) -> dict[str, Figure]:
    """The figures of a system without ω and γ: its state over time, and the drift.

    Parameters
    ----------
    dataset : xarray.Dataset
    names : sequence of str
        The variables of the state.
    records : sequence of str, optional
        Further variables, for a figure of their own.

    Returns
    -------
    dict
        Figures by the names of the functions that make them: `state`, `drift`, in this order;
        between them `records`, if there is anything to draw in it.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> sorted(report.figures.state_figures(dataset, ["M", "gamma"]))
    ['drift', 'state']
    """
    figures = {"state": state(dataset, names)}
    if records:
        figures["recorded"] = state(dataset, records)
        figures["recorded"].set_label(f"Recorded against time: {title_of(dataset)}")
    if drifts(dataset):
        figures["drift"] = drift(dataset)
    return figures


def _pictures(
    dataset: xr.Dataset, outline: BodyMesh, ground: Ground | SurfaceGround, possible: set[str]
) -> dict[str, Figure]:
    """The body on its surface, and the path of its contact point on a plane or a sphere."""
    figures: dict[str, Figure] = {}
    if isinstance(ground, SurfaceGround):
        return {"scene": ball_scene(dataset, outline, ground)} if "scene" in possible else {}
    if "scene" in possible:
        figures["scene"] = scene(dataset, outline, ground)
    if "contact_path" in possible:
        figures["contact_path"] = contact_path(dataset, ground)
    return figures


@arguments_checked
def ball_figures(
    dataset: xr.Dataset,
    outline: BodyMesh,
    ground: SurfaceGround,
    names: Sequence[str],
    weight: float | None = None,
) -> dict[str, Figure]:
    """The figures of a homogeneous ball on a surface.

    Parameters
    ----------
    dataset : xarray.Dataset
    outline : BodyMesh
        The ball.
    ground : SurfaceGround
        What carries it.
    names : sequence of str
        The variables of the state.
    weight : float, optional
        Weight of the ball, for comparison with the normal force.

    Returns
    -------
    dict
        Figures by name: the picture is `scene`; the others are named after the functions that make
        them, such as `attitude`, `normal_force` and `drift`.

    Raises
    ------
    InputError
        If an argument is of another type.
    """
    return {
        "scene": ball_scene(dataset, outline, ground),
        "attitude": attitude(dataset),
        **_forces(dataset, weight),
        **state_figures(dataset, names),
    }
