"""Problems whose closed form is looked for."""

from __future__ import annotations

from catalogue.built import example_of
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.closed_form.base.problem import Problem


def catalogue_problem(name: str, **parameters: float) -> Problem:
    """A system of the catalogue with its start."""
    entry = CATALOGUE[name]
    made = example_of(entry, entry.system(parameters), entry.start.values)
    return Problem(made.system, made.system.defaults, made.start, entry.rolling(parameters))
