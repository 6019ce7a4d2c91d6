"""A study on disk: trajectory, experiment file, figures and report in one folder."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from ..errors import InputError, RunError
from ..flow.trajectory import Trajectory
from . import figures, report
from .closed_form import diagram_if_known, solved_if_known
from .dataset import write
from .derivation import recorded_of, variables_of
from .files import completed
from .plan import plan_motion
from .prepare import Study, dataset_of
from .scene import ball_scene_of, scene_of, weight_of

__all__ = ["check_folder", "write_study"]

#: Points through which curves are drawn, at least.
SMOOTH = 3000

FILES = ("report.html", "trajectory.nc", "experiment.toml", "figures")


def check_folder(folder: Path, force: bool = False) -> None:
    """Raise InputError unless a study may be written to `folder`."""
    if folder.exists() and not folder.is_dir():
        raise InputError(f"{folder} is a file: a study is written to a folder")
    present = [name for name in FILES if (folder / name).exists()]
    if present and not force:
        raise InputError(
            f"{folder} holds {', '.join(present)} already: choose another folder, or --force to "
            "replace them"
        )
    try:
        (folder / "figures").mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        raise InputError(f"{folder} cannot be written: {problem.strerror}") from problem


def write_study(
    study: Study, folder: Path, force: bool, progress: Callable[[float], None]
) -> tuple[Trajectory, RunError | None]:
    """Integrate and write everything; a failed run is written as far as it went.

    Returns
    -------
    Trajectory, RunError or None
        What was computed, and why it ended early if it failed.

    Raises
    ------
    InputError
        If the folder cannot be written.
    """
    failure: RunError | None = None
    # curves are drawn through more points than the file is to have
    pieces = -(-SMOOTH // (study.experiment.run.samples - 1))
    try:
        trajectory = study.trajectory(progress, pieces)
    except RunError as error:
        if not isinstance(error.partial, Trajectory):
            raise
        trajectory, failure = error.partial, error
    smooth = dataset_of(study, trajectory, complete=failure is None)
    plan = None if study.plan is None else plan_motion(study.plan, trajectory)
    trajectory = trajectory.thinned(pieces)
    dataset = dataset_of(study, trajectory, complete=failure is None)
    write(dataset, folder / "trajectory.nc", force)
    with completed(folder / "experiment.toml") as temporary:
        temporary.write_text(study.complete_toml(), encoding="utf-8")
    names = variables_of(study)
    if study.ball is not None:
        scene = ball_scene_of(study.ball)
        pictures = figures.ball_figures(smooth, *scene, names, weight_of(study))
    elif study.by_state:
        drawn = {} if plan is None else {"plan_view": figures.plan_view(smooth, plan)}
        pictures = drawn | figures.state_figures(smooth, names, recorded_of(study))
    else:
        pictures = figures.all_figures(smooth, scene_of(study), weight_of(study))
    solution = solved_if_known(study)
    if solution is not None and solution.form.ovals:
        pictures["closed_form"] = figures.closed_form(study.system.title, solution.form)
        placed = diagram_if_known(study)
        if placed is not None:
            pictures["bifurcation"] = figures.bifurcation_diagram(*placed)
    for name, figure in pictures.items():
        for suffix in ("svg", "png"):
            figures.save(figure, folder / "figures" / f"{name}.{suffix}")
    text = report.render(study, trajectory, dataset, pictures, failure, solution)
    with completed(folder / "report.html") as temporary:
        temporary.write_text(text, encoding="utf-8")
    return trajectory, failure
