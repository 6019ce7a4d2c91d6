"""A Mechanism from the tables of a Lagrangian, a System from those of equations."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, TypeAlias

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.parsing import Formula, NamedQuantity, nearest
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Integral, Law
from flowlanes.system.named_formulas import flat
from flowlanes.system.parameters import Condition
from flowlanes.system.system import Guard, Observable, Parameter, Reconstruction, System
from flowlanes.system.vectors import Diagonal, Vector, to_components

from ..mechanics.lagrangian.mechanism import TIME, Frame, Mechanism, euclidean, rotations
from ..mechanics.lagrangian.plan import Plan
from ..mechanics.lagrangian.structure_functions import check_structure
from .conditions import fulfilled, read_condition, require_fulfilled
from .described import DescribedFile, EquationsFile, MechanismFile
from .law_tables import EquationsTables, IsomorphismTable, SystemTables
from .laws import Claim, Targets, catalogue_target, read_laws
from .names import Names
from .sourced import identifier
from .tables import NumberTable, ObservableTable, PlanTable

DEFAULT_TITLE = "Untitled system"

#: The commutators of pairs of fields of a frame, by coefficients of the fields.
Commutators: TypeAlias = dict[tuple[sp.Symbol, sp.Symbol], dict[sp.Symbol, sp.Expr]]

_GROUP = re.compile(r"\s*(\w+)\s*\(\s*(\w+)\s*(?:,\s*(\w+)\s*)?\)\s*")


def mechanism_of(experiment: MechanismFile) -> Mechanism:
    """The Lagrangian, frame, forces and constraints of a file.

    Raises
    ------
    InputError
        If a formula cannot be read, or a name is unknown, has two meanings or the wrong kind;
        the message names file, line and key.
    """
    names = Names(experiment.where)
    parameters = _parameters(names, experiment)
    frame = _frame(names, experiment)
    definitions = _definitions(names, experiment)
    names.require_components()
    table = experiment.lagrangian
    if table.L is not None:
        lagrangian = names.scalar(table.L, "lagrangian", "L")
    else:
        lagrangian = names.scalar(table.kinetic or "0", "lagrangian", "kinetic")
        lagrangian -= names.scalar(table.potential or "0", "lagrangian", "potential")
    constraints = experiment.constraints
    require_fulfilled(name_of(experiment), parameters, _conditions(names, experiment))
    mechanism = Mechanism(
        name=name_of(experiment),
        frame=frame,
        lagrangian=lagrangian,
        constraints=names.formulas(constraints.velocity, "constraints", "velocity"),
        positions=_positions(names, constraints.position, frame, definitions),
        forces=_forces(names, experiment, frame),
        definitions=definitions,
        parameters=parameters,
        observables=_observables(names, experiment.observables, "observables"),
        guards=_guards(names, experiment),
        laws=_integrals(names, experiment, parameters),
        title=experiment.title or DEFAULT_TITLE,
        summary=experiment.summary,
        source=experiment.source,
    )
    _check_overrides(experiment, mechanism)
    return mechanism


def _check_overrides(experiment: MechanismFile, mechanism: Mechanism) -> None:
    """Refuse an option that sets a parameter which no formula uses."""
    formulas = [
        mechanism.L,
        *mechanism.f,
        *mechanism.F,
        *mechanism.Q.values(),
        *mechanism.frame.qdot,
    ]
    formulas += [*mechanism.frame.relations, *(value for _, value in mechanism.steps)]
    formulas += [to_components(o.value) for o in mechanism.observables]
    formulas += [to_components(law.value) for law in mechanism.laws if isinstance(law, Integral)]
    used = {str(s) for formula in formulas for s in formula.free_symbols}
    for option in experiment.overrides:
        path = experiment.path(option)
        if path[0] == "parameters" and len(path) > 1:
            name = path[1]
            if not any(s == name or s.startswith(f"{name}_") for s in used):
                known = sorted({str(p.symbol) for p in mechanism.parameters} & used)
                raise InputError(
                    f"no formula uses the parameter {name}; the file's are {', '.join(known)}",
                    experiment.where(*path),
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
        """The system with those laws alone that are not claimed for the values of the file."""
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


def _described(names: Names, tables: EquationsTables, targets: Targets, line: Any) -> ClaimedSystem:
    """The system of tables that stand in a file or below a law."""
    parameters = _parameters(names, tables)
    state = [names.declare(text, "equations", "state") for text in tables.equations.state]
    definitions = _definitions(names, tables)
    names.require_components()
    field = _rates(names, state, tables.equations.rates, "equations", "rates")
    relations = names.formulas(tables.equations.relations, "equations", "relations")
    observables = _observables(names, tables.observables, "observables")
    guards = _guards(names, tables)

    def target(name: str, table: IsomorphismTable, below: Names) -> System:
        if table.system is None:
            return catalogue_target(targets, table, below.where())
        key = ("laws", "isomorphisms", name, "system")
        of_target = _described(below, table.system, targets, lambda *k: line(*key, *k))
        return of_target.with_numbers({})

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
    system = replace(system, start=_start_formulas(names, tables, system))
    claims = read_laws(names, tables.laws, system, target, line)
    integrals = [law.value for law, _ in claims if isinstance(law, Integral)]
    timed = _depend_on_time(
        *(value for _, value in (*system.field, *system.definitions)),
        *relations,
        *(item.value for item in observables),
        *(item.value for item in guards),
        *integrals,
    )
    if timed:
        system = replace(system, field=(*system.field, (TIME, sp.S.One)))
    return ClaimedSystem(system, claims, _conditions(names, tables))


def _conditions(names: Names, tables: SystemTables) -> tuple[Condition, ...]:
    """What the parameters must fulfil together."""
    return tuple(read_condition(names, text, "conditions") for text in tables.conditions)


def _reconstruction(names: Names, experiment: EquationsTables) -> Reconstruction | None:
    table = experiment.reconstruction
    if table is None:
        return None
    key, above = "reconstruction", names.copy()
    state = [above.declare(text, key, "state") for text in table.state]
    return Reconstruction(
        _rates(above, state, table.rates, key, "rates"),
        above.formulas(table.relations, key, "relations"),
        _observables(above, table.observables, key, "observables"),
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


def with_claims(experiment: MechanismFile, system: System, targets: Targets) -> System:
    """The system of a mechanism with the laws besides integrals that its file claims.

    Raises
    ------
    InputError
        If a formula cannot be read, or a symmetry moves what does not belong to the state.
    """
    names = Names(experiment.where, names_of(system))
    others = experiment.laws.model_copy(update={"integrals": {}})

    def target(name: str, table: IsomorphismTable, below: Names) -> System:
        if table.system is None:
            return catalogue_target(targets, table, below.where())
        key = ("laws", "isomorphisms", name, "system")
        of_target = _described(below, table.system, targets, lambda *k: experiment.line(*key, *k))
        return of_target.with_numbers({})

    claims = read_laws(names, others, system, target, experiment.line)
    laws = (law for law, where in claims if fulfilled(where, system.defaults))
    return system.with_laws(*laws)


def described_plan(experiment: DescribedFile, system: System) -> Plan | None:
    """The drawing of the table [plan]; None without one.

    Raises
    ------
    InputError
        If a formula cannot be read; the message names its place.
    """
    table = experiment.plan
    if table is None:
        return None
    whole = system.lifted() if system.reconstruction else system
    names = Names(experiment.where, names_of(whole))

    def read(key: str) -> tuple[tuple[sp.Expr, ...], ...]:
        return tuple(
            tuple(names.scalar(text, "plan", key) for text in texts)
            for texts in getattr(table, key)
        )

    x, y = (names.scalar(text, "plan", "path") for text in table.path)
    others = {key: read(key) for key in PlanTable.model_fields if key != "path"}
    return Plan((x, y), **others)


# --- names and numbers ---------------------------------------------------------------------


def name_of(tables: SystemTables) -> str:
    """The identifier of a system: its name, or else its title."""
    return tables.name or identifier(tables.title or DEFAULT_TITLE)


def _parameters(names: Names, tables: SystemTables) -> tuple[Parameter, ...]:
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
    """A parameter with its conditions; of a vector each component has those that speak of it."""
    name = str(parameter.symbol)
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


def _definitions(names: Names, tables: SystemTables) -> tuple[tuple[NamedQuantity, Formula], ...]:
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


# --- the frame -----------------------------------------------------------------------------


def _frame(names: Names, experiment: MechanismFile) -> Frame:
    table = experiment.frame
    coordinates = [names.declare(text, "frame", "coordinates") for text in table.coordinates]
    relations = names.formulas(table.relations, "frame", "relations")
    if not table.velocities:
        velocities = [_rate_of(names, q) for q in coordinates]
        rates = tuple(zip(coordinates, velocities, strict=True))
    else:
        velocities = [names.declare(text, "frame", "velocities") for text in table.velocities]
        rates = _rates(names, coordinates, table.rates, "frame", "rates")
    structure = _structure(names, experiment, velocities)
    try:
        frame = Frame(rates, tuple(velocities), relations, structure)
    except InputError as error:
        match = re.match(r"frame: the rate of (\w+?)(_\w)?,", error.message)
        place = ("frame", "rates", match[1]) if match else ("frame",)
        raise names.error(error.message.removeprefix("frame: "), *place) from None
    if structure is not None:
        try:
            check_structure(frame)
        except InputError as error:
            kind = "structure" if table.structure is not None else "commutators"
            raise names.error(error.message.removeprefix("frame: "), "frame", kind) from None
    return frame


def _positions(
    names: Names,
    texts: Sequence[str],
    frame: Frame,
    definitions: Iterable[tuple[NamedQuantity, Formula]],
) -> tuple[Formula, ...]:
    """Position constraints, into which no velocity enters, even by a definition."""
    key = ("constraints", "position")
    moving = set(frame.w)
    for named, value in definitions:
        if to_components(value).free_symbols & moving:
            moving |= set(flat([named]))
    positions = names.formulas(texts, *key)
    for text, value in zip(texts, positions, strict=True):
        wrong = sorted(map(str, to_components(value).free_symbols & moving))
        if wrong:
            raise names.error(
                f"'{text}' contains the velocity {wrong[0]}; it belongs to constraints.velocity",
                *key,
            )
    return positions


def _rate_of(names: Names, coordinate: NamedQuantity) -> NamedQuantity:
    """The velocity of a coordinate in its own frame, xdot of x."""
    size = f"[{len(flat([coordinate]))}]" if isinstance(coordinate, Vector) else ""
    return names.declare(f"{coordinate}dot{size}", "frame", "coordinates")


def _rates(
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


def _structure(
    names: Names, experiment: MechanismFile, velocities: Sequence[NamedQuantity]
) -> Commutators | None:
    """The commutators of the frame's fields that the file gives."""
    table = experiment.frame
    if table.structure is not None:
        return _group(names, table.structure, velocities)
    if not table.commutators:
        return None
    commutators: Commutators = {}
    key = ("frame", "commutators")
    scalars = flat(velocities)
    for pair, text in table.commutators.items():
        words = [word.strip() for word in pair.split(",")]
        if len(words) != 2:
            raise names.error('a commutator has two velocities, as in "u, v"', *key, pair)
        u, v = (names.get(word, scalars, *key, pair) for word in words)
        value = to_components(names.scalar(text, *key, pair))
        row = {w: sp.diff(value, w) for w in scalars if value.has(w)}
        if sp.expand(value - sp.Add(*(w * c for w, c in row.items()))) != 0:
            raise names.error("must be linear and homogeneous in the velocities", *key, pair)
        commutators[u, v] = row
    return commutators


def _group(names: Names, text: str, velocities: Sequence[NamedQuantity]) -> Commutators:
    key = ("frame", "structure")
    match = _GROUP.fullmatch(text)
    group = match[1] if match else ""
    arguments = [name for name in match.groups()[1:] if name] if match else []
    if len(arguments) != {"rotations": 1, "euclidean": 2}.get(group):
        raise names.error(
            f'must be "rotations(omega)" or "euclidean(omega, v)", not "{text}"', *key
        )
    vectors = [n for n in velocities if isinstance(n, Vector) and len(n.symbols) == 3]
    chosen = [names.get(name, vectors, *key) for name in arguments]
    if not all(isinstance(named, Vector) for named in chosen):
        raise names.error("needs whole vectors of velocities", *key)
    structure: Commutators = (rotations if group == "rotations" else euclidean)(*chosen)
    return structure


def _forces(
    names: Names, experiment: MechanismFile, frame: Frame
) -> tuple[tuple[NamedQuantity, Formula], ...]:
    forces = []
    for name, text in experiment.forces.items():
        named = names.get(name, frame.velocities, "forces", name)
        forces.append((named, names.like(named, text, "forces", name)))
    return tuple(forces)


# --- laws and what is recorded -------------------------------------------------------------


def _integrals(
    names: Names, experiment: MechanismFile, parameters: Sequence[Parameter]
) -> tuple[Integral, ...]:
    """The integrals that a file claims of a mechanism."""
    values = {p.symbol: p.default for p in parameters}
    found = []
    for name, table in experiment.laws.integrals.items():
        key = ("laws", "integrals", name)
        level = names.formulas(table.level, *key, "level")
        where = [read_condition(names, text, *key, "where") for text in table.where]
        if fulfilled(where, values):
            value = names.scalar(table.value, *key)
            law = Integral(name, value, table.meaning or name, table.unit, level=level)
            found.append(replace(law, source=table.source))
    return tuple(found)


def _observables(
    names: Names, tables: Mapping[str, ObservableTable], *key: str
) -> tuple[Observable, ...]:
    observables = []
    for name, table in tables.items():
        value = names.formula(table.value, *key, name)
        vector = isinstance(value, MatrixExpr | sp.MatrixBase)
        frame = table.frame or (f"{name}_component" if vector else "")
        meaning = table.meaning or name
        observables.append(Observable(name, value, meaning, table.unit, frame, table.source))
    return tuple(observables)


def _guards(names: Names, experiment: SystemTables) -> tuple[Guard, ...]:
    return tuple(
        Guard(
            table.name or name,
            names.scalar(table.value, "guards", name),
            table.message,
            table.lift_off,
        )
        for name, table in experiment.guards.items()
    )


def _depend_on_time(*formulas: Formula) -> bool:
    return any(to_components(formula).has(TIME) for formula in formulas)
