"""What is followed of a study when only its motion counts."""

from __future__ import annotations

from dataclasses import replace

from ..core.system import System
from .study import Study

__all__ = ["without_reconstruction"]


def without_reconstruction(study: Study) -> System:
    """The system without its lift to space; a contact that is to hold on is not guarded."""
    guards = study.system.guards
    if study.experiment.run.on_liftoff == "warn":
        guards = tuple(guard for guard in guards if not guard.lift_off)
    return replace(study.system, motion=None, guards=guards)
