"""The system of a study without its motion in space."""

from __future__ import annotations

from dataclasses import replace

from ..core.system import System
from .study import Study


def without_reconstruction(study: Study) -> System:
    """The system without its lift, and without lift-off guards if they only warn."""
    guards = study.system.guards
    if study.experiment.run.on_liftoff == "warn":
        guards = tuple(guard for guard in guards if not guard.lift_off)
    return replace(study.system, reconstruction=None, guards=guards)
