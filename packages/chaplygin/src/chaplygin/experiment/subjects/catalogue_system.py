"""A system of the catalogue, from its name and parameters."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import cast

import mpmath

from flowlanes.errors import InputError
from flowlanes.system.system import System
from nonholonomic.catalogue import Entry, entry, known_laws_of
from nonholonomic.catalogue.catalogue_entry import Family
from nonholonomic.catalogue.fixed_point.fluid_filled_bodies import with_fluid
from nonholonomic.catalogue.so_n.start import (
    ATTITUDE,
    GAMMA,
    OMEGA,
    state_of,
    take_attitude,
    take_contact,
    take_spin,
)
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.fluid import fluids_of_cavities
from nonholonomic.mechanics.rolling.initial_state import DIGITS

from ..models.catalogue_models import CatalogueExperiment, StateExperiment, SystemExperiment
from .initial_state import StartValues, initial_state_from_values
from .rolling_subject import letters_with_fluid
from .subject import BallSubject, BodySubject, Subject


@dataclass(frozen=True, kw_only=True)
class NDimensionalSubject(Subject):
    """An n-dimensional body, whose start gives attitude and ω, or γ and ω, or its state.

    Attributes
    ----------
    dimension : int
        n.
    family : Family
        The system in every dimension, with its constraint.
    """

    dimension: int
    family: Family

    @property
    def directions(self) -> set[str]:
        """γ alone."""
        return {GAMMA}

    @property
    def recorded_names(self) -> list[str]:
        """The angular velocity."""
        return [OMEGA]

    def initial_state(self) -> tuple[mpmath.mpf, ...]:
        """The state that follows from attitude and ω, on the phase space.

        Raises
        ------
        InputError
            If a shape is wrong, the attitude is no rotation, or ω breaks the constraint; the
            message then names the nearest admissible ω.
        """
        values, n = dict(self.start_values), self.dimension
        with mpmath.workdps(DIGITS):
            attitude, gamma = take_attitude(values, n, self.family)
            lift = self.system.lifted().symbols[len(self.system.symbols) + n * n :]
            contact = take_contact(values, n) if lift else []
            spin = take_spin(values, gamma, self.family)
            if spin is None:
                reduced = replace(self.system, reconstruction=None)
                whole = {**values, GAMMA: [float(x) for x in gamma]}
                state = list(initial_state_from_values(reduced, whole))
            elif values:
                name = next(iter(values))
                raise InputError(f"{name}: follows from omega; give one of them")
            else:
                state = state_of(self.system, spin, gamma)
            return (*state, *(x for row in attitude for x in row), *contact)


def _with_defaults(item: Entry, start: StartValues) -> StartValues:
    """A start of an n-dimensional body, completed from the catalogue."""
    values = dict(item.start.values)
    if OMEGA in start:
        values = {GAMMA: values[GAMMA]}
    if ATTITUDE in start:
        values.pop(GAMMA)
    return {**values, **start}


def body_of_catalogue(experiment: SystemExperiment) -> BodySubject:
    """A body of the catalogue, whose start gives ω and γ.

    Raises
    ------
    InputError
        If there is no such system, or a parameter is not admissible.
    """
    item = _entry(experiment)
    with experiment.placing_errors("system", "parameters"):
        system = item.system(experiment.system.parameters)
        rolling = item.rolling(experiment.system.parameters)
    start, cavities = experiment.start, experiment.cavities
    with experiment.placing_errors("body"):
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
        rolling=rolling,
        heading=start.heading,
        normal=start.normal,
        letters={
            **item.letters,
            **letters_with_fluid(fluids_of_cavities(cavities), rolls=rolling is not None),
        },
    )


def system_of_catalogue(experiment: StateExperiment) -> Subject:
    """A system of the catalogue whose start gives its state.

    Raises
    ------
    InputError
        If there is no such system, or a parameter is not admissible.
    """
    item = _entry(experiment)
    with experiment.placing_errors("system", "parameters"):
        item = item.member(experiment.system.parameters)
        system = item.system(experiment.system.parameters)
        ball = item.rolling_ball(experiment.system.parameters)
    system, until = _with_title(system, experiment), experiment.run.until or item.start.until
    # Rows of an attitude are sequences like the others.
    start = cast(StartValues, experiment.start)
    values: StartValues = {**item.start.values, **start}
    if item.family is not None:
        return NDimensionalSubject(
            system=system,
            start_values=_with_defaults(item, start),
            until=until,
            variables=item.variables,
            dimension=item.dimension or 0,
            family=item.family,
        )
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
