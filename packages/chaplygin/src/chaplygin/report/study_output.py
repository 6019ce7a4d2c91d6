"""Write a study to disk: trajectory, experiment file, figures and report in one folder."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

import xarray as xr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InterruptionError, RunError
from flowlanes.flow.trajectory import Trajectory
from nonholonomic.classification.facts import ProofBudget

from ..experiment.dataset import write_dataset
from ..experiment.files import atomic_file
from ..experiment.study import Study, dataset_of
from ..experiment.subjects.plan import PlanMotion, plan_motion
from . import page
from .background_worker import beside
from .illustrations import Illustrations
from .page import EFFORT_PER_PROOF, TIMES
from .stored_trajectory import read_trajectory, store_trajectory, trajectory_digest
from .study_folder import TRAJECTORY, begin, being_written, end

#: Minimum number of points of a drawn curve.
SMOOTH = 3000


class StudyProgress(Protocol):
    """Receives progress: the current activity, and the completed fraction."""

    def __call__(self, share: float, /) -> None:
        """Report the completed fraction, from 0 to 1."""

    def say(self, what: str) -> None:
        """Report the current activity."""


class _Silent:
    def __call__(self, share: float, /) -> None:
        pass

    def say(self, what: str) -> None:
        pass


@arguments_checked
def write_study(
    study: Study,
    folder: Path,
    *,
    force: bool = False,
    effort: int = EFFORT_PER_PROOF,
    total_budget: int | None = TIMES * EFFORT_PER_PROOF,
    progress: StudyProgress | None = None,
) -> tuple[Trajectory, RunError | None]:
    """Integrate and write everything; if the run fails, the part before the failure.

    Parameters
    ----------
    study : Study
    folder : Path
        A new folder, or that of the same interrupted study.
    force : bool
        Whether files of another study may be replaced.
    effort : int
        Term operations for the proof of one law.
    total_budget : int, optional
        Term operations after which no further law is tried; with 0 none is.
    progress : StudyProgress, optional
        Called with the completed fraction; its method ``say`` with the current activity.

    Returns
    -------
    Trajectory, RunError or None
        The computed trajectory, and the error if it ended early.

    Raises
    ------
    InputError
        If the folder cannot be written, is being written, or holds another study.
    InterruptionError
        If the integration is interrupted.

    Examples
    --------
    >>> import tempfile
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "veselova"}', overrides=["run.until=1"])
    ... )
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     home = Path(folder, "veselova")
    ...     motion, failure = report.write_study(study, home, total_budget=0)
    ...     sorted(path.name for path in home.iterdir())
    ['experiment.toml', 'figures', 'report.html', 'trajectory.nc']
    """
    told = progress or _Silent()
    # A law of a single mode does not apply to a motion through several.
    allowed = 0 if study.subject.changes_equations else total_budget
    budget = ProofBudget(effort, allowed, lambda what: told.say(f"proving: {what}"))
    with being_written(folder):
        begin(folder, study.complete_toml(), force)
        outcome = _complete(study, folder, budget, told)
        end(folder)
    return outcome


def _complete(
    study: Study, folder: Path, budget: ProofBudget, progress: StudyProgress
) -> tuple[Trajectory, RunError | None]:
    failure: RunError | None = None
    # curves are drawn through more points than the file has
    pieces = -(-SMOOTH // (study.experiment.run.samples - 1))
    try:
        trajectory = _trajectory(study, folder / TRAJECTORY, pieces, progress)
    except RunError as error:
        if isinstance(error, InterruptionError) or not isinstance(error.partial, Trajectory):
            raise
        trajectory, failure = error.partial, error
    smooth = dataset_of(study, trajectory, complete=failure is None)
    plan = None if study.subject.plan is None else plan_motion(study.subject.plan, trajectory)
    trajectory = trajectory.subsample(pieces)
    dataset = dataset_of(study, trajectory, complete=failure is None)
    # Existing files belong to this study, or may be replaced.
    write_dataset(dataset, folder / "trajectory.nc", force=True)
    with atomic_file(folder / "experiment.toml") as temporary:
        temporary.write_text(study.complete_toml(), encoding="utf-8")
    progress.say("looking for a closed form and drawing")
    with beside(
        lambda: _illustrations(study, smooth, trajectory, plan, folder / "figures")
    ) as shown:
        text = page.render(study, trajectory, dataset, shown, budget, failure)
    with atomic_file(folder / "report.html") as temporary:
        temporary.write_text(text, encoding="utf-8")
    return trajectory, failure


def _trajectory(study: Study, path: Path, pieces: int, progress: StudyProgress) -> Trajectory:
    """The trajectory of the interrupted study, or otherwise of a new integration."""
    if study.subject.changes_equations:
        return study.trajectory(progress, pieces)
    key = trajectory_digest(study, pieces)
    stored = read_trajectory(path, key, study)
    if stored is not None:
        progress.say("resuming after the integration")
        return stored
    trajectory = study.trajectory(progress, pieces)
    store_trajectory(path, key, trajectory)
    return trajectory


def _illustrations(
    study: Study, smooth: xr.Dataset, trajectory: Trajectory, plan: PlanMotion | None, folder: Path
) -> Illustrations:
    # The process that proves does not need matplotlib.
    from .drawings import illustrations

    return illustrations(study, smooth, trajectory, plan, folder)
