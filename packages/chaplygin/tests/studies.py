"""Studies of systems of the catalogue, each made once for all tests."""

from __future__ import annotations

from functools import cache

from chaplygin.experiment.models.experiment import catalogue_experiment
from chaplygin.experiment.study import Study


@cache
def catalogue_study(name: str) -> Study:
    """The example of the catalogue, ready to be followed."""
    return Study.from_experiment(catalogue_experiment(name))
