"""Claim of a certificate: a system and a law."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from .errors import CheckError
from .evaluate import Point
from .formulas import CONSTANTS, FUNCTIONS, Formula, names_in
from .functions import Functions
from .jets import Number
from .json_data import as_list, field, integer, items, mapping, only, text
from .parsing import parse, parse_alternatives

_NAME = re.compile(r"[^\W\d]\w*")

#: Names with another meaning in formulas, or with a misleading one.
_RESERVED_NAMES = {*CONSTANTS, *FUNCTIONS, "Derivative", "Subs", "Ne", "Eq", "oo", "zoo", "nan"}


@dataclass(frozen=True)
class ClaimedSystem:
    """A vector field on a phase space.

    Attributes
    ----------
    definitions : mapping of name to formula, in order
    relations : tuple of formulas
        Vanish on the phase space.
    guards : tuple of formulas
        Positive inside the domain.
    admissible : tuple of (formula, sign)
        Conditions on parameters: the formula is > 0, >= 0, = 0 or != 0.
    either : tuple of tuple of tuple of (formula, sign)
        Further conditions: alternatives, of which at least one holds.
    """

    state: tuple[str, ...]
    rates: tuple[Formula, ...]
    definitions: Mapping[str, Formula]
    parameters: tuple[str, ...]
    relations: tuple[Formula, ...]
    guards: tuple[Formula, ...]
    admissible: tuple[tuple[Formula, str], ...]
    either: tuple[tuple[tuple[tuple[Formula, str], ...], ...], ...] = ()

    @property
    def symbols(self) -> tuple[str, ...]:
        """State variables and parameters."""
        return (*self.state, *self.parameters)

    def reach(
        self, formulas: Iterable[Formula], more: Mapping[str, Formula] | None = None
    ) -> set[str]:
        """All names on which formulas depend, directly or through definitions."""
        definitions = {**self.definitions, **(more or {})}
        reached: set[str] = set()
        waiting = names_in(formulas)
        while waiting:
            word = waiting.pop()
            reached.add(word)
            if word in definitions:
                waiting |= names_in([definitions[word]]) - reached
        return reached

    def point(
        self,
        values: Mapping[str, Number],
        functions: Functions,
        parameter_formulas: Mapping[str, Formula] | None = None,
    ) -> Point:
        """Point with the given values, at which formulas of the system are evaluated."""
        rates = dict(zip(self.state, self.rates, strict=True))
        return Point(values, self.definitions, rates, functions, parameter_formulas)


@dataclass(frozen=True)
class Law:
    """A law: its kind, its level, and its statement.

    Attributes
    ----------
    pairs : mapping of field name to tuple of (name or formula, formula)
    matrix : tuple of tuple of formulas
        Matrix of a bracket.
    rank : int or None
        Rank of a bracket.
    target : System or None
    """

    kind: str
    on: tuple[Formula, ...]
    single: Mapping[str, Formula]
    several: Mapping[str, tuple[Formula, ...]]
    pairs: Mapping[str, tuple[tuple[Any, Formula], ...]]
    matrix: tuple[tuple[Formula, ...], ...] = ()
    rank: int | None = None
    target: ClaimedSystem | None = None

    def formulas(self) -> list[Formula]:
        """All formulas on the side of the system itself."""
        formulas = [*self.on, *self.single.values()]
        formulas += [f for name, group in self.several.items() if name != "onto" for f in group]
        for name, group in self.pairs.items():
            formulas += [value for _, value in group]
            if name == "density":
                formulas += [base for base, _ in group]
        return [*formulas, *(entry for row in self.matrix for entry in row)]

    @property
    def quantities(self) -> dict[str, Formula]:
        """Names that are defined in the law."""
        return dict(self.pairs.get("quantities", ()))


@dataclass(frozen=True)
class Claim:
    """A law of a system."""

    system: ClaimedSystem
    law: Law

    @property
    def conditions(self) -> tuple[Formula, ...]:
        """Formulas that vanish where the law is claimed."""
        return (*self.system.relations, *self.law.on)

    @property
    def formulas(self) -> list[Formula]:
        """All formulas of the system, the law and the target."""
        formulas = self.law.formulas()
        for system in (self.system, self.law.target):
            if system is not None:
                formulas += [*system.rates, *system.definitions.values(), *system.relations]
        return [*formulas, *self.law.several.get("onto", ())]

    @cached_property
    def moving(self) -> tuple[Formula, ...]:
        """Conditions that depend on the state."""
        state = set(self.system.state)
        return tuple(c for c in self.conditions if self.system.reach([c]) & state)


def _formulas(data: object, what: str) -> tuple[Formula, ...]:
    return tuple(parse(t, f"{what} {i}") for i, t in enumerate(as_list(data, what), 1))


def _name(data: object, what: str) -> str:
    word = text(data, what)
    if _NAME.fullmatch(word) is None:
        raise CheckError(f"{what} is {word!r}, which is not a name")
    if word in _RESERVED_NAMES:
        raise CheckError(f"{what} is {word!r}, a name that means something else in formulas")
    return word


def _names(data: object, what: str) -> tuple[str, ...]:
    return tuple(_name(word, what) for word in as_list(data, what))


def _pairs(data: object, what: str) -> tuple[tuple[str, Formula], ...]:
    pairs = []
    for pair in as_list(data, what):
        word, formula = items(pair, 2, what)
        pairs.append((_name(word, what), parse(formula, f"{what} {word}")))
    _distinct([word for word, _ in pairs], what)
    return tuple(pairs)


def _distinct(words: Iterable[str], what: str) -> None:
    seen: set[str] = set()
    for word in words:
        if word in seen:
            raise CheckError(f"{what}: {word} occurs twice")
        seen.add(word)


def _require(formulas: Iterable[Formula], names: set[str], what: str) -> None:
    strange = sorted(names_in(formulas) - names - {*CONSTANTS})
    if strange:
        raise CheckError(f"{what} uses {strange[0]}, which is unknown")


def read_system(data: object, what: str) -> ClaimedSystem:
    """System from its data; CheckError if they are malformed."""
    data = mapping(data, what)
    fields = ("name", "state", "rates", "definitions", "parameters", "relations", "guards")
    only(data, what, *fields, "admissible")
    text(field(data, "name", what), f"the name of {what}")
    state = _names(field(data, "state", what), f"the state of {what}")
    rates = _formulas(field(data, "rates", what), f"the rates of {what}")
    if len(rates) != len(state) or not state:
        raise CheckError(f"{what} has {len(state)} state variables and {len(rates)} rates")
    parameters = _names(field(data, "parameters", what), f"the parameters of {what}")
    definitions = _pairs(field(data, "definitions", what), f"the definitions of {what}")
    _distinct((*state, *parameters, *(word for word, _ in definitions)), what)
    # A definition may use only earlier ones, so definitions cannot be circular.
    known = {*state, *parameters}
    for word, formula in definitions:
        _require([formula], known, f"the definition of {word} in {what}")
        known.add(word)
    relations = _formulas(field(data, "relations", what), f"the relations of {what}")
    guards = _formulas(data.get("guards", []), f"the guards of {what}")
    conditions = [
        parse_alternatives(condition, f"what is admissible in {what}")
        for condition in as_list(data.get("admissible", []), what)
    ]
    # A condition with one alternative holds; the others are kept as alternatives.
    admissible = tuple(part for options in conditions if len(options) == 1 for part in options[0])
    either = tuple(tuple(map(tuple, options)) for options in conditions if len(options) > 1)
    _require([*rates, *relations, *guards], known, what)
    compared = [f for options in conditions for option in options for f, _ in option]
    _require(compared, set(parameters), f"what is admissible in {what}")
    return ClaimedSystem(
        state, rates, dict(definitions), parameters, relations, guards, admissible, either
    )


#: Fields of every kind of law: single formulas, lists of formulas, pairs of name and formula.
_KINDS: dict[str, tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]] = {
    "Integral": (("value",), (), ()),
    "Measure": ((), (), ()),
    "Symmetry": ((), (), ("field",)),
    "PoissonStructure": ((), ("casimirs",), ()),
    "ConformallyHamiltonian": (("multiplier", "hamiltonian"), (), ()),
    "Isomorphism": (("time",), ("onto",), ("map", "constants")),
    "Reduction": ((), ("equations",), ("quantities",)),
    "Separation": ((), ("equations",), ("quantities",)),
    "Identity": ((), ("value",), ("quantities",)),
}

#: Optional fields.
_OPTIONAL = {("Identity", "quantities"), ("Isomorphism", "onto")}


def read_claim(data: object, what: str) -> Claim:
    """Claim from its data; CheckError if they are malformed."""
    data = mapping(data, what)
    only(data, what, "system", "law")
    system = read_system(field(data, "system", what), f"the system of {what}")
    law = _law(mapping(field(data, "law", what), what), system, f"the law of {what}")
    known = {*system.symbols, *system.definitions}
    for word, formula in law.pairs.get("quantities", ()):
        if word in known:
            raise CheckError(f"the quantity {word} of {what} has a name that is already used")
        _require([formula], known, f"the quantity {word} of {what}")
        known.add(word)
    _require(law.on, {*system.symbols, *system.definitions}, f"the level of {what}")
    _require(law.formulas(), known, f"the law of {what}")
    return Claim(system, law)


def _law(data: Mapping[str, object], system: ClaimedSystem, what: str) -> Law:
    kind = field(data, "kind", what)
    if not isinstance(kind, str) or kind not in _KINDS:
        raise CheckError(f"{what} is of the kind {kind!r}, which is unknown")
    single, several, pairs = _KINDS[kind]
    extra = {
        "Measure": ("density",),
        "PoissonStructure": ("matrix", "rank"),
        "ConformallyHamiltonian": ("structure",),
        "Isomorphism": ("target",),
    }.get(kind, ())
    only(data, what, "kind", "name", "on", *single, *several, *pairs, *extra)
    text(field(data, "name", what), f"the name of {what}")
    filled = {**{word: [] for other, word in _OPTIONAL if other == kind}, **data}
    on = _formulas(field(data, "on", what), f"the level of {what}")
    formulas = {n: parse(field(data, n, what), f"{n} of {what}") for n in single}
    lists = {n: _formulas(field(filled, n, what), f"{n} of {what}") for n in several}
    named = {n: _pairs(field(filled, n, what), f"{n} of {what}") for n in pairs}
    law = Law(kind, on, formulas, lists, named)
    if kind == "Measure":
        density = _density(field(data, "density", what), system, what)
        law = replace(law, pairs={**named, "density": density})
    if kind == "PoissonStructure":
        law = _with_bracket(law, data, system, what)
    if kind == "ConformallyHamiltonian":
        structure = mapping(field(data, "structure", what), what)
        only(structure, f"the structure of {what}", "matrix", "casimirs", "rank", "name")
        casimirs = _formulas(field(structure, "casimirs", what), f"casimirs of {what}")
        law = replace(law, several={**lists, "casimirs": casimirs})
        law = _with_bracket(law, structure, system, what)
    if kind == "Symmetry":
        _require_names(named["field"], set(system.state), f"the field of {what}")
    if kind == "Isomorphism":
        target = read_system(data.get("target"), f"the target of {what}")
        _check_isomorphism(named, system, target, what)
        there = {*target.symbols, *target.definitions, *system.parameters}
        _require(lists["onto"], there, f"the image of {what}")
        law = replace(law, target=target)
    return law


def _require_names(pairs: Iterable[tuple[str, Formula]], names: set[str], what: str) -> None:
    for word, _ in pairs:
        if word not in names:
            raise CheckError(f"{what} names {word}, which is unknown there")


def _density(data: object, system: ClaimedSystem, what: str) -> tuple[tuple[Formula, Formula], ...]:
    factors = []
    for pair in as_list(data, what):
        base, exponent = items(pair, 2, f"the density of {what}")
        factor = parse(base, f"the density of {what}"), parse(exponent, f"the density of {what}")
        # A constant exponent keeps the logarithmic derivative of the density rational.
        if system.reach([factor[1]]) & set(system.state):
            raise CheckError(f"the density of {what} has an exponent that depends on the state")
        factors.append(factor)
    return tuple(factors)


def _with_bracket(law: Law, data: Mapping[str, object], system: ClaimedSystem, what: str) -> Law:
    """Law with the matrix of its bracket and its stated rank."""
    size = len(system.state)
    rows = items(field(data, "matrix", what), size, f"the matrix of {what}")
    matrix = tuple(
        tuple(parse(t, f"the matrix of {what}") for t in items(row, size, f"a row of {what}"))
        for row in rows
    )
    stated = field(data, "rank", what)
    rank = None if stated is None else integer(stated, f"the rank of {what}", 0, size)
    # A skew matrix has an even rank.
    if rank is not None and rank % 2:
        raise CheckError(f"the rank of {what} is odd")
    return replace(law, matrix=matrix, rank=rank)


def _check_isomorphism(
    pairs: Mapping[str, tuple[tuple[str, Formula], ...]],
    system: ClaimedSystem,
    target: ClaimedSystem,
    what: str,
) -> None:
    _require_names(pairs["map"], set(target.state), f"the map of {what}")
    _require_names(pairs["constants"], set(target.parameters), f"the constants of {what}")
    images = {word for word, _ in pairs["map"]}
    constants = {word for word, _ in pairs["constants"]}
    for word in target.state:
        if word not in images:
            raise CheckError(f"{what} does not define {word} of its target")
    for word in target.parameters:
        if word not in constants | set(system.parameters):
            raise CheckError(f"{what} does not define the parameter {word} of its target")
