"""The systems used by the computations of a page."""

from __future__ import annotations

from dataclasses import replace

from flowlanes.system.system import System

from ..experiment.study import Study


def reduced_system(study: Study) -> System:
    """The system without its motion in space, with the integrals that hold at the start.

    Guards that only warn are omitted, as :func:`chaplygin.integrate` continues there.
    """
    return replace(page_system(study), reconstruction=None)


def page_system(study: Study) -> System:
    """The system with its motion in space, and the guards that end a motion."""
    system = study.system if study.subject.changes_equations else study.system_on_level
    return replace(system, guards=study.guards)
