"""What is told of a system of the user's own besides its equations."""

from __future__ import annotations

from ..core.system import Observable, System
from ..core.vectors import real_symbol
from ..errors import InputError
from ..experiment.file.models import OwnExperiment
from ..experiment.study import Study
from ..mechanics.constraints.integrability import nonholonomy
from ..mechanics.lagrangian.mechanism import TIME
from ..printing.formula import text

__all__ = ["derivation_notes", "is_described", "recorded_of", "variables_of"]


def is_described(study: Study) -> bool:
    """Whether the user's file describes the mechanics itself."""
    return isinstance(study.experiment, OwnExperiment)


def derivation_notes(study: Study) -> tuple[str, ...]:
    """Sentences on what is recorded besides the state, and on the constraints.

    The verdict on the constraints, holonomic or not, is that of
    :func:`chaplygin.mechanics.constraints.integrability.nonholonomy`.
    """
    if not is_described(study):
        return ()
    return tuple(filter(None, (_recorded(study), _constraints(study))))


def variables_of(study: Study) -> list[str]:
    """The variables that a figure of the state shows, the lift of a described system among them."""
    system = study.system
    whole = system.lifted() if system.motion and is_described(study) else system
    return [str(name) for name in whole.state if name != TIME]


def recorded_of(study: Study) -> list[str]:
    """What a described system records besides."""
    return [item.name for item in _observables(study.system)] if is_described(study) else []


def _observables(system: System) -> tuple[Observable, ...]:
    return (*system.observables, *(system.motion.observables if system.motion else ()))


def _recorded(study: Study) -> str:
    listed = [
        text(real_symbol(item.name))
        if item.meaning in ("", item.name)
        else f"{text(real_symbol(item.name))} ({item.meaning})"
        for item in _observables(study.system)
    ]
    return f"Also recorded: {'; '.join(listed)}." if listed else ""


def _constraints(study: Study) -> str:
    mechanism = study.mechanism
    if mechanism is None or not mechanism.f:
        return ""
    try:
        return str(nonholonomy(mechanism))
    except InputError as problem:
        reason = problem.message.removeprefix(f"{mechanism.name}: ")
        return f"Whether the constraints are holonomic is undecided: {reason}."
