"""A System from tables of equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import sympy as sp

from flowlanes.parsing import Formula, NamedQuantity
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Law
from flowlanes.system.parameters import Condition
from flowlanes.system.system import Reconstruction, System
from flowlanes.system.vectors import Vector, to_components

from ..mechanics.conventions import BodyConventions
from ..mechanics.lagrangian.mechanism import TIME
from .conditions import fulfilled, require_fulfilled
from .described import EquationsFile
from .law_tables import EquationsTables, IsomorphismTable
from .laws import Claim, SystemReader, Targets, catalogue_target, read_laws
from .names import Names
from .parts import (
    DEFAULT_TITLE,
    conditions_of,
    definitions_of,
    guards_of,
    name_of,
    observables_of,
    parameters_of,
    rates_of,
)


@dataclass(frozen=True)
class ClaimedSystem:
    """A system without laws, and the laws that are claimed of it under conditions.

    Attributes
    ----------
    system : System
    claims : tuple of (Law, conditions)
    conditions : tuple of conditions
        What the parameters must fulfil together.
    """

    system: System
    claims: tuple[Claim, ...]
    conditions: tuple[Condition, ...] = ()

    @property
    def unclaimed(self) -> System:
        """The system with only the laws that are not claimed for the values of the file."""
        values = self.system.defaults
        laws = tuple(law for law, where in self.claims if not fulfilled(where, values))
        return replace(self.system, laws=laws)

    def with_numbers(self, numbers: Mapping[str, float]) -> System:
        """The system with values of its parameters, and the laws that are claimed for these.

        Raises
        ------
        InputError
            If the values are not admissible.
        """
        parameters = tuple(
            replace(p, default=numbers.get(str(p.symbol), p.default))
            for p in self.system.parameters
        )
        require_fulfilled(self.system.name, parameters, self.conditions)
        values = {p.symbol: p.default for p in parameters}
        laws = tuple(
            _following(law, self.system.defaults, values)
            for law, where in self.claims
            if fulfilled(where, values)
        )
        return replace(self.system, parameters=parameters, laws=laws)


def _following(
    law: Law, usual: Mapping[sp.Symbol, float], values: Mapping[sp.Symbol, float]
) -> Law:
    """An isomorphism whose target has the values of parameters that are the same by default."""
    # a body and the system that it is equivalent to have moments of inertia of the same name: new
    # values of them belong to both, unless the law says what the target's parameters are
    if not isinstance(law, Isomorphism):
        return law
    kept = values.keys() - {symbol for symbol, _ in law.constants}
    changed = [
        p for p in law.target.parameters if p.symbol in kept and p.default == usual[p.symbol]
    ]
    if law.as_printed is not None:
        law = replace(law, as_printed=_following(law.as_printed, usual, values))
    if all(p.default == values[p.symbol] for p in changed):
        return law
    parameters = tuple(
        replace(p, default=values[p.symbol]) if p in changed else p for p in law.target.parameters
    )
    return replace(law, target=replace(law.target, parameters=parameters))


def system_of(experiment: EquationsFile, targets: Targets) -> System:
    """The equations of a file with the laws that it claims.

    Parameters
    ----------
    experiment : EquationsFile
    targets : callable
        A system of the catalogue by its name, for isomorphisms.

    Raises
    ------
    InputError
        As for `mechanism_of`.
    """
    return equations_of(experiment, targets).with_numbers({})


def equations_of(experiment: EquationsFile, targets: Targets) -> ClaimedSystem:
    """The equations of a file, and the laws that it claims under conditions.

    Raises
    ------
    InputError
        As for `mechanism_of`.
    """
    return _described(Names(experiment.where), experiment, targets, experiment.line)


def target_reader(targets: Targets, line: Any) -> SystemReader:
    """A reader of targets of isomorphisms: a name of the catalogue, or tables below the law."""

    def target(name: str, table: IsomorphismTable, below: Names) -> System:
        if table.system is None:
            return catalogue_target(targets, table, below.where())
        key = ("laws", "isomorphisms", name, "system")
        of_target = _described(below, table.system, targets, lambda *k: line(*key, *k))
        return of_target.with_numbers({})

    return target


def _described(names: Names, tables: EquationsTables, targets: Targets, line: Any) -> ClaimedSystem:
    """The system of the tables of a file, or of tables below a law."""
    parameters = parameters_of(names, tables)
    state = [names.declare(text, "equations", "state") for text in tables.equations.state]
    definitions = definitions_of(names, tables)
    names.require_components()
    field = rates_of(names, state, tables.equations.rates, "equations", "rates")
    relations = names.formulas(tables.equations.relations, "equations", "relations")
    observables = observables_of(names, tables.observables, "observables")
    guards = guards_of(names, tables)

    system = System(
        name=name_of(tables),
        title=tables.title or DEFAULT_TITLE,
        field=field,
        parameters=parameters,
        definitions=definitions,
        relations=relations,
        observables=observables,
        guards=guards,
        reconstruction=_reconstruction(names, tables),
        source=tables.source,
        summary=tables.summary,
    )
    conventions = BodyConventions(_start_formulas(names, tables, system))
    system = replace(system, conventions=conventions)
    claims = read_laws(names, tables.laws, system, target_reader(targets, line), line)
    integrals = [law.value for law, _ in claims if isinstance(law, Integral)]
    timed = _depend_on_time(
        *(value for _, value in (*system.field, *system.definitions)),
        *relations,
        *(item.value for item in observables),
        *(item.value for item in guards),
        *integrals,
    )
    # an equation in which t occurs is made autonomous by one more variable, with the rate 1
    if timed:
        system = replace(system, field=(*system.field, (TIME, sp.S.One)))
    return ClaimedSystem(system, claims, conditions_of(names, tables))


def _reconstruction(names: Names, experiment: EquationsTables) -> Reconstruction | None:
    table = experiment.reconstruction
    if table is None:
        return None
    key, above = "reconstruction", names.copy()
    state = [above.declare(text, key, "state") for text in table.state]
    return Reconstruction(
        rates_of(above, state, table.rates, key, "rates"),
        above.formulas(table.relations, key, "relations"),
        observables_of(above, table.observables, key, "observables"),
    )


def _start_formulas(
    names: Names, experiment: EquationsTables, system: System
) -> tuple[tuple[NamedQuantity, Formula], ...]:
    """Variables of the state by ω and γ, whether or not these belong to it."""
    given = names.copy()
    for name in ("omega", "gamma"):
        if name not in given.by_name | given.whole:
            given.whole[name] = Vector(name)
    formulas = []
    for name, text in experiment.start_formulas.items():
        named = given.get(name, system.state, "start_formulas", name)
        formulas.append((named, given.like(named, text, "start_formulas", name)))
    return tuple(formulas)


def _depend_on_time(*formulas: Formula) -> bool:
    return any(to_components(formula).has(TIME) for formula in formulas)
