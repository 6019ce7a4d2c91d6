"""The tables that describe a given System, and their text."""

from __future__ import annotations

import keyword
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import fields, replace
from functools import singledispatchmethod
from itertools import combinations
from types import MappingProxyType
from typing import Any

import sympy as sp

from flowlanes.errors import InputError
from flowlanes.parsing import NamedQuantity, formula_text
from flowlanes.system.isomorphism import Isomorphism, with_any_parameters
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Reduction,
    Separation,
    Symmetry,
    VanishingLaw,
)
from flowlanes.system.matrices import Column
from flowlanes.system.named_formulas import flat
from flowlanes.system.system import Observable, Parameter, System
from flowlanes.system.vector_operators import Gradient
from flowlanes.system.vectors import Diagonal, Symmetric, Vector, to_components

from ..mechanics.lagrangian.plan import Plan
from .conditions import condition_text
from .law_tables import BracketTable, HamiltonianTable, IsomorphismTable, LawsTable, MeasureTable
from .laws import Targets
from .sourced import identifier
from .toml import Inline, Key, Tables, dumps

#: The order of the tables of a file, as far as they have one.
_LAST = (
    "parameters", "components", "frame", "definitions", "lagrangian", "forces", "constraints",
    "equations", "reconstruction", "start_formulas", "laws", "observables", "guards", "variables",
    "letters", "plan", "start", "run",
)  # fmt: skip

#: Tables whose entries stand on one line each.  A definition may use those before it, so that their
#: order counts, which tables of their own below the others would change.
_OF_LINES = ("parameters", "definitions", "variables", "observables")
_LONGEST = 88


def no_catalogue(name: str, parameters: Mapping[str, Any]) -> System:
    """No system: targets of isomorphisms are written out."""
    raise InputError(f"no system {name!r} in the catalogue")


def tables_of(system: System, targets: Targets = no_catalogue) -> Tables:
    """The tables of a file that describes the same system, with all its laws.

    Parameters
    ----------
    system : System
    targets : callable
        A system of the catalogue by its name, for isomorphisms that lead to it.

    Raises
    ------
    InputError
        If no file can express it, for instance an unspecified function or a proof.
    """
    if system.theorems or system.printed_definitions:
        what = "laws with a proof of their own" if system.theorems else "equations in blocks"
        raise InputError(f"{system.name}: it has {what}, which have no form in a file")
    return _Writer(system, targets).tables()


def system_text(system: System, further: Mapping[str, Any], targets: Targets = no_catalogue) -> str:
    """The text of a file that describes the same system, with further tables such as the start.

    Raises
    ------
    InputError
        As :func:`tables_of`.
    """
    return file_text({**tables_of(system, targets), **further}, _positions(system))


def _positions(system: System) -> Callable[..., int]:
    """The places of laws among the laws of their system, by the keys of a file."""

    def line(*key: str) -> int:
        _, kind, name, *below = key
        place, law = next(
            (i, law) for i, law in enumerate(system.laws) if law.name == name and _kind(law) == kind
        )
        return (
            _positions(law.target)(*below[1:]) if isinstance(law, Isomorphism) and below else place
        )

    return line


def writable_laws(system: System) -> System:
    """The system with only the laws that a file can express, and without theorems."""
    plain = replace(system, theorems=(), printed_definitions=())
    laws = []
    for law in plain.laws:
        try:
            _Writer(replace(plain, laws=(law,)), no_catalogue).tables()
        except InputError:
            continue
        laws.append(law)
    return replace(plain, laws=tuple(laws))


def plan_table_of(plan: Plan) -> Tables:
    """The table [plan] of a file that draws the same."""
    tables = {
        field.name: [list(map(formula_text, part)) for part in getattr(plan, field.name)]
        for field in fields(plan)
        if field.name != "path"
    }
    return {"path": list(map(formula_text, plan.path)), **tables}


def file_text(tables: Mapping[str, Any], line: Callable[..., int] | None = None) -> str:
    """The text of a file with the tables of a system.

    Parameters
    ----------
    tables : mapping
        As of a model, or of :func:`tables_of`.
    line : callable, optional
        The lines of laws, ``line("laws", kind, name)``, by which these are ordered.
    """
    return "\n".join(_blocks(tables, (), line or (lambda *_: 0)))


def _blocks(tables: Mapping[str, Any], path: Key, line: Callable[..., int]) -> Iterator[str]:
    """The text of the tables of a system below a path."""
    whole = {key: value for key, value in tables.items() if key not in _LAST}
    whole |= {key: tables[key] for key in _LAST if key in tables and tables[key] not in ({}, None)}
    for name in _OF_LINES:
        if name in whole:
            whole[name] = {key: _inline(value) for key, value in whole[name].items()}
    laws = whole.pop("laws", {})
    after = {key: whole.pop(key) for key in _LAST[_LAST.index("laws") :] if key in whole}
    yield _below(path, whole)
    keys = [(kind, name) for kind, of_kind in laws.items() for name in of_kind]
    for kind, name in sorted(keys, key=lambda key: line(*path, "laws", *key)):
        law = laws[kind][name]
        table = _law_layout(law) if isinstance(law, Mapping) else {"value": law}
        target = table.pop("system", None)
        here = (*path, "laws", kind, name)
        yield _below(here, table)
        if isinstance(target, Mapping):
            yield from _blocks(target, (*here, "system"), line)
    if after:
        yield _below(path, after)


def _below(path: Key, table: Mapping[str, object]) -> str:
    """The text of a table below a path."""
    for part in reversed(path):
        table = {part: table}
    return dumps(table)


def _inline(value: object) -> object:
    return Inline(value) if isinstance(value, Mapping) else value


def _law_layout(law: Mapping[str, Any]) -> Tables:
    """A law with its short tables on one line."""
    table: Tables = {}
    for key, value in law.items():
        short = isinstance(value, Mapping) and len(dumps({key: Inline(value)})) <= _LONGEST
        table[key] = Inline(value) if short and key != "system" else value
    return table


def _kind(law: Law) -> str:
    """The kind of a law, as a file calls it."""
    return next((kind for kind, of in _KINDS.items() if type(law) is of), "others")


_KINDS: Mapping[str, type[Law]] = MappingProxyType(
    {
        "integrals": Integral,
        "measures": Measure,
        "symmetries": Symmetry,
        "brackets": PoissonStructure,
        "hamiltonian": ConformallyHamiltonian,
        "reductions": Reduction,
        "separations": Separation,
        "identities": Identity,
        "isomorphisms": Isomorphism,
    }
)


class _Writer:
    """Writes one system."""

    def __init__(self, system: System, targets: Targets) -> None:
        self.system = system
        self.targets = targets
        self.formulas = {
            name: value for name, value in system.definitions if isinstance(name, sp.Symbol)
        }
        #: Formulas of which a gradient is taken under another name.
        self.shorthand: dict[sp.Symbol, sp.Basic] = {}
        #: Vectors and tensors that occur in formulas.
        self.whole: dict[str, NamedQuantity] = {}

    def text(self, formula: sp.Basic) -> str:
        """A formula, in which vectors and tensors are noted."""
        value = sp.sympify(formula)
        for part in sp.preorder_traversal(value):
            if isinstance(part, Column):
                raise InputError(f"{part} of {part.shape[0]} components has no form in a file")
            if isinstance(part, Vector | Diagonal | Symmetric):
                self.whole[str(part)] = part
            if isinstance(part, Gradient) and part.args[2] not in self.formulas:
                self.abbreviate(part.args[2], part.args[0])
        return formula_text(value, self.formulas | self.shorthand)

    def abbreviate(self, name: sp.Symbol, value: sp.Basic) -> None:
        """Note the name and the formula of a function whose gradient is taken."""
        if self.shorthand.setdefault(name, value) != value:
            raise InputError(f"two formulas are called {name}, which no file can say")

    def texts(self, formulas: Iterable[sp.Basic]) -> list[str]:
        """Several formulas."""
        return [self.text(formula) for formula in formulas]

    def named(self, pairs: Iterable[tuple[sp.Basic, sp.Basic]]) -> Tables:
        """Formulas by name."""
        return {str(name): self.text(value) for name, value in pairs}

    def tables(self) -> Tables:
        """All tables of the system."""
        system = self.system
        for name in (*system.state, *dict(system.definitions)):
            if keyword.iskeyword(str(name)):
                raise InputError(f"{system.name}: {name} is no name in a file")
        tables: Tables = {"title": system.title}
        if system.name != identifier(system.title):
            tables["name"] = system.name
        tables |= _given(summary=system.summary, source=system.source)
        tables["parameters"] = {str(p.symbol): _parameter(p) for p in system.parameters}
        definitions = [(str(name), self.text(value)) for name, value in system.definitions]
        equations = self.equations(system.field, system.relations)
        reconstruction = None
        if (motion := system.reconstruction) is not None:
            reconstruction = self.equations(motion.field, motion.relations)
            reconstruction["observables"] = {
                o.name: Inline(self.observable(o)) for o in motion.observables
            }
        start = self.named(system.conventions.start_formulas)
        laws = self.laws()
        observables = {o.name: self.observable(o) for o in system.observables}
        guards: Tables = {}
        for guard in system.guards:
            key = guard.name if guard.name not in guards else f"{guard.name}_{len(guards) + 1}"
            other = _given(name=guard.name if key != guard.name else "", lift_off=guard.lift_off)
            guards[key] = {"value": self.text(guard.value), "message": guard.message, **other}
        return tables | _given(
            components=self.components(),
            definitions=self.with_shorthand(definitions),
            equations=equations,
            reconstruction=reconstruction,
            start_formulas=start,
            laws=laws,
            observables=observables,
            guards=guards,
        )

    def equations(self, field: Any, relations: Iterable[sp.Basic]) -> Tables:
        """State, rates and relations."""
        return {
            "state": [_declaration(name) for name, _ in field],
            **_given(relations=self.texts(relations)),
            "rates": self.named(field),
        }

    def with_shorthand(self, definitions: list[tuple[str, str]]) -> Tables:
        """The definitions, and each shorthand after the last of them that it needs."""
        entries: list[tuple[str, object]] = list(definitions)
        for name, value in self.shorthand.items():
            used = to_components(value).free_symbols
            owners = (str(n) for n, _ in self.system.definitions if used & set(flat([n])))
            names = [key for key, _ in entries]
            place = max((names.index(owner) + 1 for owner in owners), default=0)
            entry = Inline(value=self.text(value), shorthand=True)
            entries.insert(place, (str(name), entry))
        return dict(entries)

    def components(self) -> Tables:
        """Kinds of the vectors and tensors that are declared by their components."""
        system = self.system
        motion = system.reconstruction.field if system.reconstruction else ()
        declared = {str(name) for name, _ in (*system.field, *system.definitions, *motion)}
        known = {
            *(p.symbol for p in system.parameters),
            *system.symbols,
            *(s for s, _ in system.scalar_definitions),
        }
        for name in self.whole:
            if name in set(map(str, known)):
                raise InputError(f"{name} is the name of a number and of a vector")
        return {
            name: type(quantity).__name__.lower()
            for name, quantity in sorted(self.whole.items())
            if name not in declared and set(flat([quantity])) <= known
        }

    def observable(self, item: Observable) -> Tables:
        """A quantity that is recorded."""
        frame = item.frame if item.frame in ("body", "space", "quaternion") else ""
        notes = _given(meaning=item.meaning, unit=item.unit, frame=frame, source=item.source)
        return {"value": self.text(item.value), **notes}

    # --- laws ------------------------------------------------------------------------------

    def laws(self) -> Tables:
        """The laws by kind and name, in order within the kinds."""
        tables: dict[str, Tables] = {}
        for law in self.system.laws:
            kind, table = _kind(law), self.law(law)
            if law.name in tables.setdefault(kind, {}):
                raise InputError(f"two {kind} have the name {law.name!r}, which no file can say")
            tables[kind][law.name] = table
        return {kind: tables[kind] for kind in LawsTable.model_fields if kind in tables}

    def law(self, law: Law) -> Tables:
        """The table of a law."""
        table = self.part(law)
        if law.as_printed is not None:
            printed = self.part(law.as_printed)
            if type(law.as_printed) is not type(law):
                raise InputError(f"{law.name}: it is printed as a law of another kind")
            other = {key: value for key, value in printed.items() if table.get(key) != value}
            gone = {key for key in table if key not in printed}
            for choice in _CHOICES:
                if choice & other.keys():
                    other |= {key: printed[key] for key in choice & printed.keys()}
                gone -= choice if choice & printed.keys() else set()
            other |= {key: _EMPTY[type(table[key])] for key in gone}
            table["as_printed"] = other
            table |= _given(misprint=law.misprint)
        return table

    def common(self, law: Any) -> Tables:
        """What laws of all kinds have."""
        return _given(meaning=law.meaning, level=self.texts(law.level), source=law.source)

    @singledispatchmethod
    def part(self, law: Law) -> Tables:
        """The table of a law without the printed form."""
        raise InputError(f"a law of the kind {type(law).__name__} has no form in a file")

    @part.register
    def _other(self, law: VanishingLaw) -> Tables:
        entry = {key: self._entry(value) for key, value in law.tabulated().items()}
        return entry | _given(source=law.source)

    def _entry(self, value: object) -> object:
        """A value of the table of a law: a text as it is, formulas as texts."""
        if isinstance(value, str):
            return value
        if isinstance(value, sp.MatrixBase) and value.shape[1] > 1:
            return [list(self.texts(row)) for row in value.tolist()]
        if isinstance(value, tuple):
            return list(self.texts(value))
        return self.text(value)

    @part.register
    def _integral(self, law: Integral) -> Tables:
        table = {"value": self.text(law.value), **_given(unit=law.unit)}
        return table | self.common(law)

    @part.register
    def _measure(self, law: Measure) -> Tables:
        powers = {self.text(base): self.text(exponent) for base, exponent in law.density}
        if len(powers) == 1 and set(powers.values()) == {"1"}:
            return {"value": next(iter(powers)), **self.common(law)}
        return {"density": powers, **self.common(law)}

    @part.register
    def _symmetry(self, law: Symmetry) -> Tables:
        return {"field": self.named(law.field), **self.common(law)}

    @part.register
    def _bracket(self, law: PoissonStructure) -> Tables:
        rest = _given(casimirs=self.texts(law.casimirs), rank=law.rank)
        return {**self.skew(law.matrix), **rest, **self.common(law)}

    def skew(self, matrix: sp.MatrixBase) -> Tables:
        """A skew matrix by the entries that are not zero, or by its rows."""
        symbols, brackets = self.system.symbols, {}
        for i, j in combinations(range(matrix.rows), 2):
            first, second = matrix[i, j], matrix[j, i]
            if first == second == 0:
                continue
            if -first == second:
                brackets[f"{symbols[i]}, {symbols[j]}"] = self.text(first)
            elif -second == first:
                brackets[f"{symbols[j]}, {symbols[i]}"] = self.text(second)
            else:
                brackets = {}
                break
        if not brackets:
            return {"matrix": [self.texts(matrix.row(k)) for k in range(matrix.rows)]}
        return {"brackets": brackets}

    @part.register
    def _hamiltonian(self, law: ConformallyHamiltonian) -> Tables:
        table: Tables = {"hamiltonian": self.text(law.hamiltonian)}
        if law.multiplier != 1:
            table["multiplier"] = self.text(law.multiplier)
        if law.structure in self.system.laws:
            table["bracket"] = law.structure.name
        else:
            name = law.structure.name if law.structure.name != "bracket" else ""
            table["structure"] = self.part(law.structure) | _given(name=name)
        return table | self.common(law)

    @part.register
    def _reduction(self, law: Reduction) -> Tables:
        table = _given(quantities=self.named(law.quantities))
        table |= {"equations": self.texts(law.equations), **self.common(law)}
        return table

    @part.register
    def _identity(self, law: Identity) -> Tables:
        several = isinstance(law.value, tuple)
        value = self.texts(law.value) if several else self.text(law.value)
        rest = _given(quantities=self.named(law.quantities))
        return {"value": value, **rest, **self.common(law)}

    @part.register
    def _isomorphism(self, law: Isomorphism) -> Tables:
        table: Tables = {"map": self.named(law.map)}
        if law.time != 1:
            table["time"] = self.text(law.time)
        target = _Writer(law.target, self.targets)
        onto = [target.text(formula) for formula in law.onto]
        table |= _given(constants=self.named(law.constants), onto=onto)
        table |= self.common(law)
        return table | (
            self.in_catalogue(law.target) or {"system": tables_of(law.target, self.targets)}
        )

    def in_catalogue(self, target: System) -> Tables | None:
        """The keys that name a target by its entry in the catalogue; None if it is not there."""
        numbers = {str(p.symbol): p.default for p in target.parameters}
        for given in ({}, numbers):
            try:
                entry = self.targets(target.name, given)
            except InputError:
                return None
            for bare in (False, True):
                if (with_any_parameters(entry) if bare else entry) == target:
                    return {"target": target.name} | _given(
                        parameters=given, without_conditions=bare
                    )
        return None


_CHOICES = tuple(
    choice
    for table in (MeasureTable, HamiltonianTable, BracketTable, IsomorphismTable)
    for choice in table.choices
)

#: What stands for a key that a printed form does not have.
_EMPTY: Mapping[type, object] = {str: "", list: [], dict: {}}


def _given(**values: Any) -> Tables:
    """Keys whose value is not empty."""
    return {
        k: v for k, v in values.items() if v is not None and v != "" and v not in ([], {}, False)
    }


def _parameter(parameter: Parameter) -> Tables:
    where = list(map(condition_text, parameter.admissible))
    notes = _given(unit=parameter.unit, meaning=parameter.meaning, where=where)
    return {"value": float(parameter.default), **notes}


def _declaration(name: NamedQuantity) -> str:
    return f"{name}[{len(name.symbols)}]" if isinstance(name, Vector) else str(name)
