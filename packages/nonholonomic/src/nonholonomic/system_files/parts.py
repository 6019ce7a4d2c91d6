"""Parameters, definitions, observables and guards of a system, from the tables of any file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.parsing import Formula, NamedQuantity, nearest
from flowlanes.system.named_formulas import flat
from flowlanes.system.parameters import Condition
from flowlanes.system.system import Guard, Observable, Parameter, System
from flowlanes.system.vectors import Diagonal

from ..mechanics.lagrangian.mechanism import TIME
from .conditions import read_condition
from .law_tables import SystemTables
from .names import Names
from .sourced import identifier
from .tables import NumberTable, ObservableTable

DEFAULT_TITLE = "Untitled system"


def conditions_of(names: Names, tables: SystemTables) -> tuple[Condition, ...]:
    """The conditions on several parameters together."""
    return tuple(read_condition(names, text, "conditions") for text in tables.conditions)


def name_of(tables: SystemTables) -> str:
    """The identifier of a system: its name, or else its title."""
    return tables.name or identifier(tables.title or DEFAULT_TITLE)


def parameters_of(names: Names, tables: SystemTables) -> tuple[Parameter, ...]:
    """The parameters of a system, a number for each component."""
    parameters: list[Parameter] = []
    for name, table in tables.parameters.items():
        key = ("parameters", name)
        if table.diagonal is not None:
            named = names.add(Diagonal(name), *key)
        else:
            size = f"[{len(table.value)}]" if isinstance(table.value, tuple) else ""
            named = names.declare(f"{name}{size}", *key)
        parameters += _components(named, table)
    names.group(tables.components)
    return tuple(_with_conditions(names, p, tables) for p in parameters)


def _components(quantity: NamedQuantity, table: NumberTable) -> list[Parameter]:
    values = table.value if table.diagonal is None else table.diagonal
    listed = values if isinstance(values, tuple) else (values,)
    return [
        Parameter(symbol, table.meaning, float(value or 0.0), table.unit)
        for symbol, value in zip(flat([quantity]), listed, strict=True)
    ]


def _with_conditions(names: Names, parameter: Parameter, tables: SystemTables) -> Parameter:
    """A parameter with its conditions; a component of a vector has those that contain it."""
    name = str(parameter.symbol)
    # the conditions on a vector stand once for all its components, I_2 among those of I
    owner = name if name in tables.parameters else name.rpartition("_")[0]
    texts = tables.parameters[owner].where
    conditions: list[Condition] = []
    for text in texts:
        condition = read_condition(names, text, "parameters", owner, "where")
        if strange := condition.free_symbols - set(flat(names.by_name.values())):
            raise names.error(f"{min(map(str, strange))} is no parameter", "parameters", owner)
        if owner == name or parameter.symbol in condition.free_symbols:
            conditions.append(condition)
    return replace(parameter, admissible=tuple(conditions)) if conditions else parameter


def definitions_of(names: Names, tables: SystemTables) -> tuple[tuple[NamedQuantity, Formula], ...]:
    """The definitions of a system, without the abbreviations."""
    definitions: list[tuple[NamedQuantity, Formula]] = []
    for name, table in tables.definitions.items():
        key = ("definitions", name)
        if table.shorthand:
            names.abbreviate(name, names.scalar(table.value, *key), *key)
            continue
        value = names.formula(table.value, *key)
        definitions.append((names.define(name, value, *key), value))
    return tuple(definitions)


def names_of(system: System) -> dict[str, NamedQuantity]:
    """Every name of a finished system."""
    everything = [
        TIME,
        *(p.symbol for p in system.parameters),
        *system.state,
        *(name for name, _ in system.definitions),
    ]
    return {str(named): named for named in everything}


def rates_of(
    names: Names, variables: Sequence[NamedQuantity], texts: dict[str, str], *key: str
) -> tuple[tuple[NamedQuantity, Formula], ...]:
    """The rate of each variable, in the order of the variables."""
    by_name = {str(named): named for named in variables}
    for name in texts:
        if name not in by_name:
            raise names.error(f"unknown variable{nearest(name, by_name)}", *key, name)
    missing = [name for name in by_name if name not in texts]
    if missing:
        raise names.error(f"the rate of {', '.join(missing)} is missing", *key)
    return tuple(
        (named, names.like(named, texts[name], *key, name)) for name, named in by_name.items()
    )


def observables_of(
    names: Names, tables: Mapping[str, ObservableTable], *key: str
) -> tuple[Observable, ...]:
    """The quantities to record that a table describes."""
    observables = []
    for name, table in tables.items():
        value = names.formula(table.value, *key, name)
        vector = isinstance(value, MatrixExpr | sp.MatrixBase)
        frame = table.frame or (f"{name}_component" if vector else "")
        meaning = table.meaning or name
        observables.append(Observable(name, value, meaning, table.unit, frame, table.source))
    return tuple(observables)


def guards_of(names: Names, experiment: SystemTables) -> tuple[Guard, ...]:
    """The quantities that must stay positive."""
    return tuple(
        Guard(
            table.name or name,
            names.scalar(table.value, "guards", name),
            table.message,
            table.lift_off,
        )
        for name, table in experiment.guards.items()
    )
