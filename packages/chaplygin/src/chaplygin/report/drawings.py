"""The figures and the closed form of a study: written to its folder, and for its page."""

from __future__ import annotations

from pathlib import Path

import xarray as xr
from matplotlib.figure import Figure

from flowlanes.flow.trajectory import Trajectory
from nonholonomic.closed_form.base.solution import Solution

from ..experiment.closed_form import closed_form_section, diagram_if_known, known_solution
from ..experiment.files import atomic_file
from ..experiment.study import Study
from ..experiment.subjects.plan import PlanMotion
from ..page.bifurcation_model import bifurcation_model
from ..page.page_systems import reduced_system
from . import figures
from .drawing.layout import layout_done
from .illustrations import Illustrations
from .subject_figures import subject_figures


def illustrations(
    study: Study, smooth: xr.Dataset, trajectory: Trajectory, plan: PlanMotion | None, folder: Path
) -> Illustrations:
    """Draw everything, and write it to the folder of figures.

    Parameters
    ----------
    study : Study
    smooth : xarray.Dataset
        The motion, sampled finely enough for curves.
    trajectory : Trajectory
        The same motion with the samples of the study.
    plan : PlanMotion or None
        The motion of a mechanism in the plane.
    folder : Path
        The folder of the figures.
    """
    solution = known_solution(study)
    pictures = _figures(study, smooth, plan, solution)
    svgs = {}
    for name, figure in pictures.items():
        with layout_done(figure):
            svgs[name] = figures.svg_text(figure)
            figures.save(figure, folder / f"{name}.png")
        with atomic_file(folder / f"{name}.svg") as place:
            place.write_text(figures.svg_file(svgs[name]), encoding="utf-8")
    pairs, letters = figures.page_svgs(pictures, svgs)
    closed = None if solution is None else closed_form_section(solution, trajectory)
    return Illustrations(pairs, letters, closed, bifurcation_model(study, reduced_system(study)))


def _figures(
    study: Study, smooth: xr.Dataset, plan: PlanMotion | None, solution: Solution | None
) -> dict[str, Figure]:
    """The figures of a study, by name."""
    pictures = subject_figures(study.subject, smooth, plan)
    if solution is not None and solution.form.ovals:
        pictures["closed_form"] = figures.closed_form(study.system.title, solution.form)
        placed = diagram_if_known(study)
        if placed is not None:
            pictures["bifurcation"] = figures.bifurcation_diagram(*placed)
    return pictures
