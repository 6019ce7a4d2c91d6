"""A Mechanism from the tables of a Lagrangian, and its drawing."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TypeAlias

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import Formula, NamedQuantity
from flowlanes.system.laws import Integral
from flowlanes.system.named_formulas import flat
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Vector, to_components

from ..mechanics.lagrangian.mechanism import Frame, Mechanism, euclidean, rotations
from ..mechanics.lagrangian.structure_functions import check_structure
from .conditions import fulfilled, read_condition, require_fulfilled
from .described import MechanismFile
from .equations import target_reader
from .laws import Targets, read_laws
from .names import Names
from .parts import (
    DEFAULT_TITLE,
    conditions_of,
    definitions_of,
    guards_of,
    name_of,
    names_of,
    observables_of,
    parameters_of,
    rates_of,
)

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
    parameters = parameters_of(names, experiment)
    frame = _frame(names, experiment)
    definitions = definitions_of(names, experiment)
    names.require_components()
    table = experiment.lagrangian
    if table.L is not None:
        lagrangian = names.scalar(table.L, "lagrangian", "L")
    else:
        lagrangian = names.scalar(table.kinetic or "0", "lagrangian", "kinetic")
        lagrangian -= names.scalar(table.potential or "0", "lagrangian", "potential")
    constraints = experiment.constraints
    require_fulfilled(name_of(experiment), parameters, conditions_of(names, experiment))
    mechanism = Mechanism(
        name=name_of(experiment),
        frame=frame,
        lagrangian=lagrangian,
        constraints=names.formulas(constraints.velocity, "constraints", "velocity"),
        positions=_positions(names, constraints.position, frame, definitions),
        forces=_forces(names, experiment, frame),
        definitions=definitions,
        parameters=parameters,
        observables=observables_of(names, experiment.observables, "observables"),
        guards=guards_of(names, experiment),
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


def with_claims(experiment: MechanismFile, system: System, targets: Targets) -> System:
    """The system of a mechanism with the laws besides integrals that its file claims.

    Raises
    ------
    InputError
        If a formula cannot be read, or a symmetry moves what does not belong to the state.
    """
    # integrals are laws of the mechanism already, which takes part in deriving the equations
    names = Names(experiment.where, names_of(system))
    others = experiment.laws.model_copy(update={"integrals": {}})

    target = target_reader(targets, experiment.line)
    claims = read_laws(names, others, system, target, experiment.line)
    laws = (law for law, where in claims if fulfilled(where, system.defaults))
    return system.with_laws(*laws)


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
        rates = rates_of(names, coordinates, table.rates, "frame", "rates")
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
    # a velocity may also enter by a definition
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
        # the commutator of two fields of the frame is a combination of its fields
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
