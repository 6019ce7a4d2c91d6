"""A Mechanism from a file with a Lagrangian, or a System from one with equations."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import TypeAlias

import sympy as sp
from sympy.matrices.expressions import MatrixExpr

from flowlanes.errors import InputError
from flowlanes.parsing import Formula, NamedQuantity, nearest
from flowlanes.system.laws import Integral, Law, Measure, Symmetry
from flowlanes.system.system import Guard, Observable, Parameter, System, flat
from flowlanes.system.vectors import Diagonal, Vector, to_components
from nonholonomic.mechanics.lagrangian.mechanism import TIME, Frame, Mechanism, euclidean, rotations
from nonholonomic.mechanics.lagrangian.structure_functions import check_structure

from ..file.mechanism_tables import NumberTable
from ..models.base import identifier
from ..models.described_models import EquationsExperiment, MechanismExperiment, OwnExperiment
from ..models.names import Names

DEFAULT_TITLE = "Untitled system"

#: The commutators of pairs of fields of a frame, by coefficients of the fields.
Commutators: TypeAlias = dict[tuple[sp.Symbol, sp.Symbol], dict[sp.Symbol, sp.Expr]]

_GROUP = re.compile(r"\s*(\w+)\s*\(\s*(\w+)\s*(?:,\s*(\w+)\s*)?\)\s*")


def mechanism_of(experiment: MechanismExperiment) -> Mechanism:
    """The Lagrangian, frame, forces and constraints of a file.

    Raises
    ------
    InputError
        If a formula cannot be read, or a name is unknown, has two meanings or the wrong kind;
        the message names file, line and key.
    """
    names = Names(experiment)
    parameters = _parameters(names)
    frame = _frame(names, experiment)
    definitions = _definitions(names)
    table = experiment.lagrangian
    if table.L is not None:
        lagrangian = names.scalar(table.L, "lagrangian", "L")
    else:
        lagrangian = names.scalar(table.kinetic or "0", "lagrangian", "kinetic")
        lagrangian -= names.scalar(table.potential or "0", "lagrangian", "potential")
    constraints = experiment.constraints
    mechanism = Mechanism(
        name=identifier(experiment.title or DEFAULT_TITLE),
        frame=frame,
        lagrangian=lagrangian,
        constraints=names.formulas(constraints.velocity, "constraints", "velocity"),
        positions=_positions(names, constraints.position, frame, definitions),
        forces=_forces(names, experiment, frame),
        definitions=definitions,
        parameters=parameters,
        observables=_observables(names),
        guards=_guards(names),
        laws=_integrals(names),
        title=experiment.title or DEFAULT_TITLE,
        summary=experiment.summary,
    )
    _check_overrides(experiment, mechanism)
    return mechanism


def _check_overrides(experiment: MechanismExperiment, mechanism: Mechanism) -> None:
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


def system_of(experiment: EquationsExperiment) -> System:
    """The equations of a file.

    Raises
    ------
    InputError
        As for `mechanism_of`.
    """
    names = Names(experiment)
    parameters = _parameters(names)
    table = experiment.equations
    state = [names.declare(text, "equations", "state") for text in table.state]
    definitions = _definitions(names)
    field = _rates(names, state, table.rates, "equations", "rates")
    relations = names.formulas(table.relations, "equations", "relations")
    observables, guards, laws = _observables(names), _guards(names), _integrals(names)
    timed = _depend_on_time(
        *(value for _, value in (*field, *definitions)),
        *relations,
        *(item.value for item in observables),
        *(item.value for item in guards),
        *(item.value for item in laws),
    )
    system = System(
        name=identifier(experiment.title or DEFAULT_TITLE),
        title=experiment.title or DEFAULT_TITLE,
        field=field + (((TIME, sp.S.One),) if timed else ()),
        parameters=parameters,
        definitions=definitions,
        relations=relations,
        laws=laws,
        observables=observables,
        guards=guards,
        summary=experiment.summary,
    )
    return with_claims(experiment, system)


def with_claims(experiment: OwnExperiment, system: System) -> System:
    """A system with the measures and symmetries that its file claims.

    Raises
    ------
    InputError
        If a formula cannot be read, or a symmetry moves what does not belong to the state.
    """
    names = Names(experiment, _names_of(system))
    table = experiment.laws
    laws: list[Law] = []
    for name, law in table.measures.items():
        key = ("laws", "measures", name)
        density = names.scalar(law.value, *key)
        on = names.formulas(law.on, *key, "on")
        powers = _powers(density, set(system.symbols), [s for s, _ in system.scalar_definitions])
        if density == 0:
            raise names.error("the density of a measure must not be zero", *key)
        laws.append(Measure(name, powers, law.meaning, on=on))
    for name, moved in table.symmetries.items():
        key = ("laws", "symmetries", name)
        field = {}
        for variable, text in moved.items():
            named = names.get(variable, system.state, *key, variable)
            field[named] = names.like(named, text, *key, variable)
        laws.append(Symmetry(name, field))
    return system.with_laws(*laws)


# --- names and numbers ---------------------------------------------------------------------


def _parameters(names: Names) -> tuple[Parameter, ...]:
    parameters: list[Parameter] = []
    for name, table in names.experiment.parameters.items():
        key = ("parameters", name)
        if table.diagonal is not None:
            named = names.add(Diagonal(name), *key)
        else:
            size = f"[{len(table.value)}]" if isinstance(table.value, tuple) else ""
            named = names.declare(f"{name}{size}", *key)
        parameters += _components(named, table)
    return tuple(parameters)


def _components(quantity: NamedQuantity, table: NumberTable) -> list[Parameter]:
    values = table.value if table.diagonal is None else table.diagonal
    listed = values if isinstance(values, tuple) else (values,)
    return [
        Parameter(symbol, table.meaning, float(value or 0.0), table.unit)
        for symbol, value in zip(flat([quantity]), listed, strict=True)
    ]


def _definitions(names: Names) -> tuple[tuple[NamedQuantity, Formula], ...]:
    definitions: list[tuple[NamedQuantity, Formula]] = []
    for name, text in names.experiment.definitions.items():
        key = ("definitions", name)
        value = names.formula(text, *key)
        size = f"[{value.shape[0]}]" if isinstance(value, MatrixExpr | sp.MatrixBase) else ""
        definitions.append((names.declare(f"{name}{size}", *key), value))
    return tuple(definitions)


def _names_of(system: System) -> dict[str, NamedQuantity]:
    """Every name of a finished system."""
    everything = [
        TIME,
        *(p.symbol for p in system.parameters),
        *system.state,
        *(name for name, _ in system.definitions),
    ]
    return {str(named): named for named in everything}


# --- the frame -----------------------------------------------------------------------------


def _frame(names: Names, experiment: MechanismExperiment) -> Frame:
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
    names: Names, experiment: MechanismExperiment, velocities: Sequence[NamedQuantity]
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
    names: Names, experiment: MechanismExperiment, frame: Frame
) -> tuple[tuple[NamedQuantity, Formula], ...]:
    forces = []
    for name, text in experiment.forces.items():
        named = names.get(name, frame.velocities, "forces", name)
        forces.append((named, names.like(named, text, "forces", name)))
    return tuple(forces)


# --- laws and what is recorded -------------------------------------------------------------


def _integrals(names: Names) -> tuple[Integral, ...]:
    integrals = []
    for name, law in names.experiment.laws.integrals.items():
        key = ("laws", "integrals", name)
        value = names.scalar(law.value, *key)
        on = names.formulas(law.on, *key, "on")
        integrals.append(Integral(name, value, law.meaning or name, law.unit, on=on))
    return tuple(integrals)


def _observables(names: Names) -> tuple[Observable, ...]:
    observables = []
    for name, table in names.experiment.observables.items():
        value = names.formula(table.value, "observables", name)
        vector = isinstance(value, MatrixExpr | sp.MatrixBase)
        frame = f"{name}_component" if vector else ""
        observables.append(Observable(name, value, table.meaning or name, table.unit, frame))
    return tuple(observables)


def _guards(names: Names) -> tuple[Guard, ...]:
    return tuple(
        Guard(name, to_components(names.scalar(table.value, "guards", name)), table.message)
        for name, table in names.experiment.guards.items()
    )


def _powers(
    density: sp.Expr, moving: set[sp.Symbol], symbols: Iterable[sp.Symbol]
) -> dict[sp.Expr, sp.Expr]:
    """A density as powers whose exponents are constant."""
    moving = moving | set(symbols)
    powers = {sp.sympify(b): sp.sympify(e) for b, e in density.as_powers_dict().items()}
    if any(to_components(e).free_symbols & moving for e in powers.values()):
        return {density: sp.S.One}
    return powers


def _depend_on_time(*formulas: Formula) -> bool:
    return any(to_components(formula).has(TIME) for formula in formulas)
