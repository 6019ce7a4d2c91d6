"""The file of a system of the catalogue: its equations, laws, start and run."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Law
from flowlanes.system.system import System, VariablesByName
from nonholonomic.catalogue import entry
from nonholonomic.catalogue.entry_files import entry_file, paths
from nonholonomic.catalogue.systems import catalogue_system
from nonholonomic.system_files.write import plan_table_of, system_text

from .models.catalogue_models import StateExperiment, SystemExperiment
from .models.experiment import parse_experiment
from .study import Study


def catalogue_text(study: Study) -> str:
    """An experiment file that brings the same system, start and run without naming the catalogue.

    Parameters
    ----------
    study : Study
        A study of a system of the catalogue.

    Raises
    ------
    InputError
        If the system has what no file can say, such as a matrix of n dimensions or a proof.
    """
    experiment = study.experiment
    if not isinstance(experiment, SystemExperiment | StateExperiment):
        return study.complete_toml()
    name = experiment.system.name
    if not experiment.overrides and name in paths() and entry_file(name).complete:
        return entry_file(name).text
    # the printed text reads back to the same system
    try:
        text = system_text(study.system, _further(study, name), catalogue_system)
        if not same_equations(Study.from_experiment(parse_experiment(text)).system, study.system):
            raise InputError("it does not read back to the same system")
        return text
    except InputError as error:
        reason = error.message.removeprefix(f"{name}: ")
        raise InputError(
            f"--as toml: {name} cannot be written as a file of equations, since {reason}; a file "
            f'with system = {{ name = "{name}" }} names it'
        ) from None


def same_equations(one: System, other: System) -> bool:
    """True if two systems differ in their conventions for starts and metadata at most.

    A file says nothing of these: the conventions follow from the kind of experiment.
    """
    return _plain(one) == _plain(other)


def _plain(system: System) -> System:
    """A system, and those onto which its laws lead, with the conventions of any system."""
    return replace(system, conventions=VariablesByName(), laws=tuple(map(_plain_law, system.laws)))


def _plain_law(law: Law) -> Law:
    if not isinstance(law, Isomorphism):
        return law
    printed = None if law.as_printed is None else _plain_law(law.as_printed)
    return replace(law, target=_plain(law.target), as_printed=printed)


def _further(study: Study, name: str) -> dict[str, Any]:
    """The parts of a file other than the system."""
    whole = study.system.lifted() if study.system.reconstruction else study.system
    state = {str(variable) for variable in whole.state}
    variables = {
        key: {"meaning": meaning, "unit": unit} if unit else {"meaning": meaning}
        for key, (meaning, unit) in study.variables.items()
        if key in state
    }
    run = study.experiment.run.model_dump(exclude_unset=True) | {"until": study.until}
    further: dict[str, Any] = {"variables": variables, "letters": dict(entry(name).letters)}
    if study.subject.plan is not None:
        further["plan"] = plan_table_of(study.subject.plan)
    return further | {"start": _start(study, whole), "run": run}


def _start(study: Study, whole: System) -> dict[str, Any]:
    """The start as given, or the resulting state if the equations need it."""
    given = {
        key: list(value) if isinstance(value, tuple | list) else value
        for key, value in study.start_values.items()
    }
    variables = [str(variable) for variable in whole.state]
    if study.subject.starts_by_velocity or given.keys() <= set(variables):
        return given
    numbers = [float(x) for x in study.start]
    return {
        str(variable): numbers[place.start] if isinstance(variable, sp.Symbol) else numbers[place]
        for variable, place in whole.slices
    }
