"""The page model of a study, including its motion."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np
import xarray as xr

from flowlanes.errors import InputError, RunError
from lawproof.proof.verdict import Verdict

from ..experiment.study import Study, dataset_of
from .bifurcation_model import bifurcation_model
from .page_model import MOST_SAMPLES, live_page_model, page_model
from .page_systems import reduced_system
from .scene_model import Json


def study_model(
    study: Study,
    dataset: xr.Dataset,
    verdicts: Mapping[str, Verdict] | None = None,
    diagram: Callable[[], Json] | None = None,
) -> dict[str, Json]:
    """The model of a page that shows a motion: computed by the page, or as recorded.

    Parameters
    ----------
    study : Study
    dataset : xarray.Dataset
        The motion, as returned by :func:`chaplygin.experiment.study.dataset_of`; a long one is
        subsampled.
    verdicts : mapping of str to Verdict, optional
        On the laws, by name.
    diagram : callable, optional
        Returns the bifurcation diagram, if it is computed elsewhere.
    """
    shown = sample_for_page(dataset)
    try:
        model = live_page_model(study, shown, verdicts)
    except InputError:
        return page_model(study, shown, verdicts)
    computed = diagram or partial(bifurcation_model, study, reduced_system(study))
    return {**model, "recorded": None, "bifurcation": computed()}


def laboratory_model(study: Study, subject: Mapping[str, Json]) -> dict[str, Json]:
    """The model of a page of a running laboratory.

    Parameters
    ----------
    study : Study
    subject : mapping
        The subject to be named in requests of the page.

    Raises
    ------
    InputError
        If the start is not admissible.
    RunError
        If the motion ends before its first sample.
    """
    try:
        trajectory, complete = study.trajectory(), True
    except RunError as error:
        if error.partial is None:
            raise
        trajectory, complete = error.partial, False
    model = study_model(study, dataset_of(study, trajectory, complete))
    return {**model, "lab": dict(subject)}


def sample_for_page(dataset: xr.Dataset) -> xr.Dataset:
    """A motion with at most `MOST_SAMPLES` samples, including its ends."""
    count = dataset.sizes["time"]
    if count <= MOST_SAMPLES:
        return dataset
    chosen = np.unique(np.round(np.linspace(0, count - 1, MOST_SAMPLES)).astype(int))
    return dataset.isel(time=chosen)
