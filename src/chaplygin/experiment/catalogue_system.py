"""From the name of a system of the catalogue, with its parameters, to the system."""

from __future__ import annotations

from dataclasses import replace

from ..catalogue import Entry, entry, known_laws_of
from ..catalogue.fixed_point.with_fluid import with_fluid
from ..core.system import System
from ..mechanics.rolling.body import Body
from ..mechanics.rolling.fluid import fluids_of_cavities
from .file.catalogue_models import CatalogueExperiment, StateExperiment, SystemExperiment
from .initial_state import StartValues
from .rolling import letters_with_fluid, rolling_setting
from .subject import BallSubject, BodySubject, Subject


def body_of_catalogue(experiment: SystemExperiment) -> BodySubject:
    """A body of the catalogue, whose start is given by ω and γ.

    Raises
    ------
    InputError
        If there is no such system, or a parameter is not admissible.
    """
    item = _entry(experiment)
    with experiment.placing_errors("system", "parameters"):
        system = item.system(experiment.system.parameters)
        rolling = item.rolling(experiment.system.parameters)
    start, cavities = experiment.start, experiment.system.cavities
    with experiment.placing_errors("system"):
        if rolling is None:
            system = with_fluid(system, cavities)
        elif cavities and isinstance(rolling.body, Body):
            rolling = replace(rolling, body=replace(rolling.body, cavity=cavities))
            system = rolling.system(system.name, f"{system.title} with fluid")
            system = system.with_laws(*known_laws_of(rolling, system))
    values = {"omega": start.omega, "gamma": start.gamma, **start.motion_of_fluids(cavities)}
    return BodySubject(
        system=_with_title(system, experiment),
        start_values=item.start.values | {n: v for n, v in values.items() if v is not None},
        until=experiment.run.until or item.start.until,
        variables=item.variables,
        plan=item.plan,
        setting="" if rolling is None else rolling_setting(rolling),
        rolling=rolling,
        heading=start.heading,
        normal=start.normal,
        letters={**item.letters, **letters_with_fluid(fluids_of_cavities(cavities))},
    )


def system_of_catalogue(experiment: StateExperiment) -> Subject:
    """A system of the catalogue whose start is given by its state.

    Raises
    ------
    InputError
        If there is no such system, or a parameter is not admissible.
    """
    item = _entry(experiment)
    with experiment.placing_errors("system", "parameters"):
        system = item.system(experiment.system.parameters)
        ball = item.rolling_ball(experiment.system.parameters)
    system, until = _with_title(system, experiment), experiment.run.until or item.start.until
    values: StartValues = item.start.values | experiment.start
    if ball is None:
        return Subject(
            system=system,
            start_values=values,
            until=until,
            variables=item.variables,
            plan=item.plan,
        )
    return BallSubject(
        system=system, start_values=values, until=until, variables=item.variables, ball=ball
    )


def _entry(experiment: CatalogueExperiment) -> Entry:
    with experiment.placing_errors("system", "name"):
        return entry(experiment.system.name)


def _with_title(system: System, experiment: CatalogueExperiment) -> System:
    return replace(system, title=experiment.title) if experiment.title else system
