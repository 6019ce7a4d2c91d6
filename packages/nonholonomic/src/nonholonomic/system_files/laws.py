"""The laws that the tables of a file claim of a system."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from types import MappingProxyType
from typing import Any, TypeAlias

import sympy as sp

from flowlanes.errors import InputError, nearest
from flowlanes.parsing import Formula, NamedQuantity
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
    vanishing_kinds,
)
from flowlanes.system.named_formulas import by_dependence, flat
from flowlanes.system.parameters import Condition
from flowlanes.system.system import Name, System
from flowlanes.system.vectors import to_components

from .conditions import read_condition
from .law_tables import (
    BracketTable,
    HamiltonianTable,
    IdentityTable,
    IntegralTable,
    IsomorphismTable,
    LawsTable,
    LawTable,
    MeasureTable,
    OtherLawTable,
    ReductionTable,
    SymmetryTable,
)
from .names import Names

#: A System of the catalogue by its name, with some parameters given.
Targets: TypeAlias = Callable[[str, Mapping[str, Any]], System]


#: Name and table of an isomorphism and the names below it ↦ its target.
SystemReader: TypeAlias = Callable[[str, IsomorphismTable, Names], System]


@dataclass(frozen=True)
class LawReader:
    """Reads the laws of one system.

    Parameters
    ----------
    names : Names
        All names of the system.
    state : tuple of Vector or Symbol
    moving : frozenset of Symbol
        The variables of the state and what depends on them, by components.
    target : callable
        The target of an isomorphism.
    brackets : mapping of str to PoissonStructure
        The brackets among the laws, by name.
    """

    names: Names
    state: tuple[Name, ...]
    moving: frozenset[sp.Symbol]
    target: SystemReader
    brackets: Mapping[str, PoissonStructure]

    def law(self, kind: str, name: str, table: LawTable) -> Law:
        """The law of a table, with the form in which its source prints it."""
        key = ("laws", kind, name)
        common = {"level": self.names.formulas(table.level, *key, "level"), "source": table.source}
        law: Law = _READERS[kind](self, name, table, common, key)
        printed = table.printed
        if printed is None:
            return law
        as_printed = replace(self, names=self.names).law(kind, name, printed)
        return replace(law, as_printed=as_printed, misprint=table.misprint)

    def powers(self, density: sp.Expr) -> dict[sp.Expr, sp.Expr]:
        """A density as powers whose exponents are constant."""
        # a product of powers is kept apart: its logarithmic derivative needs no root
        powers = {sp.sympify(b): sp.sympify(e) for b, e in density.as_powers_dict().items()}
        if any(to_components(e).free_symbols & self.moving for e in powers.values()):
            return {density: sp.S.One}
        return powers

    def bracket(
        self, name: str, table: BracketTable, common: dict[str, Any], key: tuple[str, ...]
    ) -> PoissonStructure:
        """A matrix by its entries that are not zero."""
        if table.matrix is not None:
            rows = [self.names.formulas(row, *key, "matrix") for row in table.matrix]
            matrix = self._matrix(rows, *key, "matrix")
        else:
            matrix = self._skew(table.brackets or {}, *key, "brackets")
        casimirs = self.names.formulas(table.casimirs, *key, "casimirs")
        return PoissonStructure(name, matrix, casimirs, table.rank, table.meaning, **common)

    def _matrix(self, rows: Sequence[Sequence[Formula]], *key: str) -> sp.ImmutableDenseMatrix:
        """The matrix of a bracket by its rows."""
        size = len(flat(self.state))
        if len(rows) != size or any(len(row) != size for row in rows):
            raise self.names.error(f"must be {size} rows of {size} formulas", *key)
        return sp.ImmutableDenseMatrix(rows)

    def _skew(self, texts: Mapping[str, str], *key: str) -> sp.ImmutableDenseMatrix:
        """The matrix of a bracket by the entries that are not zero."""
        # {y, x} = −{x, y}, so that a pair in both orders could only contradict itself
        scalars = flat(self.state)
        matrix = sp.zeros(len(scalars), len(scalars))
        given: set[frozenset[sp.Symbol]] = set()
        for pair, text in texts.items():
            words = [word.strip() for word in pair.split(",")]
            if len(words) != 2:
                raise self.names.error('a bracket has two variables, as in "x, p"', *key, pair)
            x, y = (self.names.get(word, scalars, *key, pair) for word in words)
            if x == y or frozenset((x, y)) in given:
                raise self.names.error("each pair of two variables stands once", *key, pair)
            given.add(frozenset((x, y)))
            value = self.names.scalar(text, *key, pair)
            i, j = scalars.index(x), scalars.index(y)
            matrix[i, j], matrix[j, i] = value, -value
        return sp.ImmutableDenseMatrix(matrix)

    def with_quantities(
        self, texts: Mapping[str, str], key: tuple[str, ...]
    ) -> tuple[Names, dict[NamedQuantity, sp.Basic]]:
        """The names of a law with its own quantities, and their formulas."""
        names = self.names.copy()
        quantities = {}
        for name, text in texts.items():
            value = names.formula(text, *key, "quantities", name)
            quantities[names.define(name, value, *key, "quantities", name)] = value
        return names, quantities


_Reading: TypeAlias = Callable[[LawReader, str, Any, dict[str, Any], tuple[str, ...]], Law]


def _integral(r: LawReader, name: str, t: IntegralTable, common: Any, key: Any) -> Law:
    value = r.names.scalar(t.value, *key)
    return Integral(name, value, t.meaning or name, t.unit, **common)


def _measure(r: LawReader, name: str, t: MeasureTable, common: Any, key: Any) -> Law:
    if t.density is not None:
        powers = {
            r.names.scalar(base, *key, "density"): r.names.scalar(text, *key, "density", base)
            for base, text in t.density.items()
        }
        if any(to_components(e).free_symbols & r.moving for e in powers.values()):
            raise r.names.error("an exponent must not depend on the state", *key, "density")
    else:
        powers = r.powers(r.names.scalar(t.value or "1", *key))
    if sp.S.Zero in powers:
        raise r.names.error("the density of a measure must not be zero", *key)
    return Measure(name, powers, t.meaning, **common)


def _symmetry(r: LawReader, name: str, t: SymmetryTable, common: Any, key: Any) -> Law:
    field = {}
    for variable, text in t.field.items():
        named = r.names.get(variable, r.state, *key, variable)
        field[named] = r.names.like(named, text, *key, variable)
    return Symmetry(name, field, t.meaning, **common)


def _bracket(r: LawReader, name: str, t: BracketTable, common: Any, key: Any) -> Law:
    return r.bracket(name, t, common, key)


def _hamiltonian(r: LawReader, name: str, t: HamiltonianTable, common: Any, key: Any) -> Law:
    if t.structure is not None:
        below = {"source": t.structure.source}
        structure = r.bracket(
            t.structure.name or "bracket", t.structure, below, (*key, "structure")
        )
    elif t.bracket is not None and t.bracket in r.brackets:
        structure = r.brackets[t.bracket]
    else:
        known = ", ".join(r.brackets) or "none"
        raise r.names.error(f"no bracket '{t.bracket}' among the laws; there are {known}", *key)
    multiplier = r.names.scalar(t.multiplier, *key, "multiplier")
    hamiltonian = r.names.scalar(t.hamiltonian, *key, "hamiltonian")
    return ConformallyHamiltonian(name, multiplier, structure, hamiltonian, t.meaning, **common)


def _reduction(r: LawReader, name: str, t: ReductionTable, common: Any, key: Any) -> Law:
    kind = Separation if key[1] == "separations" else Reduction
    names, quantities = r.with_quantities(t.quantities, key)
    equations = tuple(names.law_formula(text, *key, "equations") for text in t.equations)
    return kind(name, quantities, equations, t.meaning, **common)


def _identity(r: LawReader, name: str, t: IdentityTable, common: Any, key: Any) -> Law:
    names, quantities = r.with_quantities(t.quantities, key)
    value: object
    if isinstance(t.value, tuple):
        value = tuple(names.law_formula(text, *key) for text in t.value)
    else:
        value = names.law_formula(t.value, *key)
    return Identity(name, value, t.meaning, quantities, **common)


def _isomorphism(r: LawReader, name: str, t: IsomorphismTable, common: Any, key: Any) -> Law:
    target = r.target(name, t, r.names.below(*key, "system"))
    if t.without_conditions:
        target = with_any_parameters(target)
    mapped, constants = {}, {}
    for variable, text in t.map.items():
        named = r.names.get(variable, target.state, *key, "map", variable)
        mapped[named] = r.names.like(named, text, *key, "map", variable)
    for parameter, text in t.constants.items():
        symbol = r.names.get(parameter, target.defaults, *key, "constants", parameter)
        constants[symbol] = r.names.scalar(text, *key, "constants", parameter)
    # `onto` is written in the variables of the target; where both systems have a name, it is the
    # target's, and what else of this system occurs must be constant there
    onto = r.names.copy()
    there = {str(n): n for n in (*target.state, *target.defaults, *dict(target.definitions))}
    onto.by_name.update(there)
    for other in list(onto.whole):
        if other in there:
            del onto.whole[other]
    return Isomorphism(
        name,
        target,
        mapped,
        r.names.scalar(t.time, *key, "time"),
        constants,
        t.meaning,
        onto.formulas(t.onto, *key, "onto"),
        **common,
    )


def _other(r: LawReader, name: str, t: OtherLawTable, common: Any, key: Any) -> Law:
    kinds = vanishing_kinds()
    if t.kind not in kinds:
        known = f"; known are {', '.join(sorted(kinds))}" if kinds else "; none is known"
        raise r.names.error(f"there is no kind of law '{t.kind}'{known}", *key, "kind")
    kind = kinds[t.kind]
    own = [f.name for f in fields(kind) if f.name not in {g.name for g in fields(Law)}]
    for part in t.formulas:
        if part not in own:
            raise r.names.error(f"a {t.kind} has no '{part}'{nearest(part, own)}", *key, part)

    def read(value: object, part: str) -> object:
        if isinstance(value, str):
            return r.names.formula(value, *key, part)
        return tuple(read(entry, part) for entry in value) if isinstance(value, tuple) else value

    parts: dict[str, Any] = {part: read(value, part) for part, value in t.formulas.items()}
    if t.meaning:
        parts["meaning"] = t.meaning
    try:
        return kind(name, **parts, **common)
    except TypeError:
        missing = [part for part in own if part not in parts]
        raise r.names.error(f"a {t.kind} needs {', '.join(missing)}", *key) from None


_READERS: Mapping[str, _Reading] = MappingProxyType(
    {
        "integrals": _integral,
        "measures": _measure,
        "symmetries": _symmetry,
        "brackets": _bracket,
        "hamiltonian": _hamiltonian,
        "reductions": _reduction,
        "separations": _reduction,
        "identities": _identity,
        "isomorphisms": _isomorphism,
        "others": _other,
    }
)

#: A law, and the conditions on the parameters under which it is claimed.
Claim: TypeAlias = tuple[Law, tuple[Condition, ...]]


def read_laws(
    names: Names,
    tables: LawsTable,
    system: System,
    target: SystemReader,
    line: Callable[..., int],
) -> tuple[Claim, ...]:
    """The laws of a table in the order of the file, each with its conditions.

    Raises
    ------
    InputError
        If a formula cannot be read, a symmetry moves what does not belong to the state, or a
        name is unknown.
    """
    # a definition without the state is a constant, and may be an exponent of a density
    _, moved = by_dependence(system.scalar_definitions, system.symbols)
    moving = frozenset({*system.symbols, *(symbol for symbol, _ in moved)})
    reader = LawReader(names, system.state, moving, target, {})
    # brackets first, since the Hamiltonian forms refer to them by name
    brackets = {name: reader.law("brackets", name, t) for name, t in tables.brackets.items()}
    reader = replace(reader, brackets=brackets)  # type: ignore[arg-type]
    claims: list[tuple[int, Claim]] = []
    for kind in LawsTable.model_fields:
        for name, table in getattr(tables, kind).items():
            key = ("laws", kind, name)
            law = brackets[name] if kind == "brackets" else reader.law(kind, name, table)
            where = tuple(read_condition(names, text, *key, "where") for text in table.where)
            claims.append((line(*key), (law, where)))
    return tuple(claim for _, claim in sorted(claims, key=lambda pair: pair[0]))


def catalogue_target(targets: Targets, table: IsomorphismTable, where: str) -> System:
    """The target that a table names in the catalogue.

    Raises
    ------
    InputError
        If there is no such system, or it has no such parameter.
    """
    try:
        return targets(table.target or "", table.parameters)
    except InputError as error:
        raise InputError(error.message, where) from None
