"""The single system of equations of a study, with or without its reconstruction in space."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.errors import InputError
from flowlanes.system.system import System

from .study import Study


def single_system(study: Study) -> System:
    """The system whose equations hold along the whole motion.

    Raises
    ------
    InputError
        If the equations change at events, as those of a contact with friction do.
    """
    if study.subject.changes_equations:
        raise InputError(
            "with friction the equations of motion change at events, and only show, prove, run, "
            "study, ensemble, chart and section take such a file",
            study.experiment.where("contact", "model"),
        )
    return study.system


def without_reconstruction(study: Study) -> System:
    """The system without its reconstruction, and without lift-off guards that only warn.

    Raises
    ------
    InputError
        If the equations change at events.
    """
    return replace(single_system(study), reconstruction=None, guards=study.guards)
