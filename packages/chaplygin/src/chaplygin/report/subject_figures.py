"""The figures of a study, by the kind of system."""

from __future__ import annotations

import xarray as xr
from matplotlib.figure import Figure

from ..experiment.subjects.contact_subject import ContactSubject
from ..experiment.subjects.plan import PlanMotion
from ..experiment.subjects.subject import BallSubject, BodySubject, Subject
from . import figures
from .drawing.contact_values import friction_limits
from .figures.contact_figures import contact_figures
from .scenes.scene import scene_of, surface_scene_of


def subject_figures(
    subject: Subject, dataset: xr.Dataset, plan: PlanMotion | None
) -> dict[str, Figure]:
    """The figures of a trajectory by name, in the order of the page.

    Parameters
    ----------
    subject : Subject
        The system that moves.
    dataset : xarray.Dataset
        Its trajectory.
    plan : PlanMotion or None
        The motion of a mechanism in the plane.
    """
    drawn, on_surface = scene_of(subject), surface_scene_of(subject)
    match subject:
        case BallSubject() if on_surface is not None:
            return figures.ball_figures(dataset, *on_surface, subject.state_names, subject.weight)
        case BodySubject():
            return figures.all_figures(dataset, drawn or on_surface, subject.weight)
        case ContactSubject(contact=contact, body=body) if drawn is not None:
            limits = friction_limits(contact)
            return contact_figures(dataset, drawn, body, limits, subject.weight)
        case _:
            pictures = {} if plan is None else {"plan_view": figures.plan_view(dataset, plan)}
            # A horizontal position is recorded as part of the centre.
            names = [name for name in subject.state_names if name in dataset]
            return pictures | figures.state_figures(dataset, names, subject.recorded_names)
