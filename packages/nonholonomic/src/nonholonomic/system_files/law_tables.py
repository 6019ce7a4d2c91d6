"""The tables of the laws of a system, one for each kind of law.

Formulas are kept as they are typed; :mod:`nonholonomic.system_files.laws` reads them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Annotated, Any, ClassVar, Self

from pydantic import ConfigDict, Field, Strict, ValidationError, model_serializer, model_validator

from .table import FORMULA, Table
from .tables import (
    CONDITIONS,
    FORMULAS,
    ComponentsTable,
    DefinitionTable,
    EquationsTable,
    Formulas,
    FormulaValue,
    GuardTable,
    NumberTable,
    NumberValue,
    ObservableTable,
    ReconstructionTable,
    Text,
    Texts,
    ValueWithNotes,
    formula_text,
)
from .toml import Tables
from .validation import validation_messages

TEXT = "a text in quotes"
NAMED = "a table of named formulas"
BRACKETS = 'a table of brackets, such as { "x, p" = "1" }'


class LawTable(Table):
    """The keys of every law."""

    choices: ClassVar[tuple[frozenset[str], ...]] = ()
    """Keys of which one stands in place of another."""
    other_words: ClassVar[Mapping[str, str]] = {"on": "level"}
    """Words that are used for a key, with the key."""

    meaning: Text = Field(default="", description=TEXT)
    level: Texts = Field(default=(), description=FORMULAS)
    """Formulas that must vanish for the law to hold."""
    where: Texts = Field(default=(), description=CONDITIONS)
    """Conditions on the parameters without which the law is not claimed."""
    source: Text = Field(default="", description=TEXT)
    as_printed: dict[str, Any] | None = Field(default=None, description="a table of keys")
    """What the source prints in place of the keys with these names."""
    misprint: Text = Field(default="", description=TEXT)
    """What is wrong with it."""

    @property
    def printed(self) -> Self | None:
        """The law as its source prints it, where that differs."""
        if self.as_printed is None:
            return None
        others = {"as_printed", "misprint", "where", *self.as_printed}
        for choice in self.choices:
            others |= choice if choice & self.as_printed.keys() else set()
        same = self.model_fields_set - others
        return type(self).model_validate({k: getattr(self, k) for k in same} | self.as_printed)

    @model_validator(mode="after")
    def _readable_as_printed(self) -> Self:
        try:
            _ = self.printed
        except ValidationError as error:
            wrong = validation_messages(error, type(self), self.as_printed)
            key, sentence = next(iter(wrong.items()))
            raise ValueError(": ".join(("as_printed", *key, sentence))) from None
        return self

    @model_serializer(mode="wrap")
    def _as_given(self, serialise: Callable[[Self], Tables]) -> object:
        # an empty table is a value where none would be no table, as for a measure of density 1
        tables = {name for name, field in type(self).model_fields.items() if field.default is None}
        return {
            key: value
            for key, value in serialise(self).items()
            if value not in (None, "", (), [], {}) or (value == {} and key in tables)
        }


class _ValueTable(LawTable, ValueWithNotes):
    """A law that may be given by its formula alone."""


class IntegralTable(_ValueTable):
    """A first integral."""

    value: FormulaValue = Field(description=FORMULA)
    unit: Text = Field(default="", description=TEXT)


class MeasureTable(_ValueTable):
    """An invariant measure, by its density or by the factors of this and their exponents."""

    choices = (frozenset({"value", "density"}),)

    value: FormulaValue | None = Field(default=None, description=FORMULA)
    density: Formulas | None = Field(default=None, description="a table of exponents by formula")
    """The exponents by their bases; empty for the density 1."""

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if (self.value is None) == (self.density is None):
            raise ValueError("must have either a value or a density")
        return self


class SymmetryTable(LawTable):
    """A symmetry field; the components that are not named are zero."""

    field: Formulas = Field(description=NAMED)

    @model_validator(mode="before")
    @classmethod
    def _field_alone(cls, table: object) -> object:
        if isinstance(table, dict) and not isinstance(table.get("field"), dict):
            return {"field": table}
        return table


class BracketTable(LawTable):
    """A Poisson structure, by the brackets that are not zero."""

    choices = (frozenset({"brackets", "matrix"}),)

    brackets: Formulas | None = Field(default=None, description=BRACKETS)
    """Of each pair of components of the state one order: ``"x, p" = "1"``."""
    matrix: tuple[Texts, ...] | None = Field(default=None, description="rows of formulas")
    """All brackets, in the order of the state."""
    casimirs: Texts = Field(default=(), description=FORMULAS)
    name: Text = Field(default="", description=TEXT)
    """The name of a bracket that is no law."""
    rank: Annotated[int, Strict()] | None = Field(default=None, description="an even whole number")

    @model_validator(mode="after")
    def _one_form(self) -> Self:
        if (self.brackets is None) == (self.matrix is None):
            raise ValueError("must have either brackets or a matrix")
        return self


class HamiltonianTable(LawTable):
    """A conformally Hamiltonian form."""

    choices = (frozenset({"bracket", "structure"}),)

    hamiltonian: FormulaValue = Field(description=FORMULA)
    multiplier: FormulaValue = Field(default="1", description=FORMULA)
    bracket: Text | None = Field(default=None, description="the name of a law among the brackets")
    structure: BracketTable | None = Field(default=None, description="a table with brackets")
    """The bracket itself, where it is none of the laws."""

    @model_validator(mode="after")
    def _one_structure(self) -> Self:
        if (self.bracket is None) == (self.structure is None):
            raise ValueError("must have either bracket, the name of one, or a structure")
        return self


class ReductionTable(LawTable):
    """Closed equations of some quantities."""

    quantities: Formulas = Field(default={}, description=NAMED)
    equations: Texts = Field(description=FORMULAS)
    """With ``Rate(x)`` for the rate of x."""


class IdentityTable(_ValueTable):
    """Formulas that vanish on the phase space."""

    value: FormulaValue | tuple[FormulaValue, ...] = Field(description=FORMULA)
    quantities: Formulas = Field(default={}, description=NAMED)


class IsomorphismTable(LawTable):
    """A change of variables and time onto another system."""

    choices = (frozenset({"target", "system", "parameters", "without_conditions"}),)

    target: Text | None = Field(default=None, description="the name of a system of the catalogue")
    parameters: dict[str, NumberValue] = Field(default={}, description="a table of named numbers")
    """Parameters of the target that differ from the defaults of the catalogue."""
    without_conditions: Annotated[bool, Strict()] = Field(
        default=False, description="true or false"
    )
    """Whether the target is its equations alone, whatever its parameters."""
    system: EquationsTables | None = Field(default=None, description="a table with equations")
    """The target itself, where it is no system of the catalogue."""
    map: Formulas = Field(description=NAMED)
    time: FormulaValue = Field(default="1", description=FORMULA)
    constants: Formulas = Field(default={}, description=NAMED)
    onto: Texts = Field(default=(), description=FORMULAS)

    @model_validator(mode="after")
    def _one_target(self) -> Self:
        if (self.target is None) == (self.system is None):
            raise ValueError("must have either target, a name of the catalogue, or a system")
        if self.system is not None and (self.parameters or self.without_conditions):
            raise ValueError("parameters and without_conditions belong to a target")
        return self


def _formulas_in(value: object) -> object:
    """A formula, a list of formulas, or a list of rows of them, as texts."""
    if isinstance(value, list | tuple):
        return tuple(_formulas_in(part) for part in value)
    return formula_text(value)


class OtherLawTable(LawTable):
    """A law of another kind: the name of its class, and its formulas by their names."""

    model_config = ConfigDict(frozen=True, extra="allow", defer_build=True)

    kind: Text = Field(description="the name of a class of laws, in quotes")

    @model_validator(mode="before")
    @classmethod
    def _texts(cls, value: object) -> object:
        if not isinstance(value, dict):
            return value
        own = cls.model_fields
        return {k: v if k in own else _formulas_in(v) for k, v in value.items()}

    @property
    def formulas(self) -> dict[str, Any]:
        """The formulas by name: each a text, or nested tuples of texts."""
        return dict(self.model_extra or {})


class LawsTable(Table):
    """The laws that are claimed of the system, to be proved or refuted."""

    integrals: dict[str, IntegralTable] = Field(default={}, description=NAMED)
    measures: dict[str, MeasureTable] = Field(default={}, description=NAMED)
    symmetries: dict[str, SymmetryTable] = Field(default={}, description="a table of named tables")
    brackets: dict[str, BracketTable] = Field(default={}, description="a table of named tables")
    hamiltonian: dict[str, HamiltonianTable] = Field(
        default={}, description="a table of named tables"
    )
    reductions: dict[str, ReductionTable] = Field(default={}, description="a table of named tables")
    separations: dict[str, ReductionTable] = Field(
        default={}, description="a table of named tables"
    )
    identities: dict[str, IdentityTable] = Field(default={}, description=NAMED)
    isomorphisms: dict[str, IsomorphismTable] = Field(
        default={}, description="a table of named tables"
    )
    others: dict[str, OtherLawTable] = Field(default={}, description="a table of named tables")
    """Laws of kinds that Python code brings; see :class:`flowlanes.system.laws.VanishingLaw`."""


class SystemTables(Table):
    """The tables common to all descriptions of a system."""

    name: Text | None = Field(default=None, description=TEXT, min_length=1)
    """The identifier; by default the title in small letters."""
    title: Text | None = Field(default=None, description=TEXT, min_length=1)
    """The title in reports and figures."""
    summary: Text = Field(default="", description=TEXT)
    """One or two sentences on what moves, for reports."""
    source: Text = Field(default="", description=TEXT)
    """Where the system is described."""
    parameters: dict[str, NumberTable] = Field(default={}, description="a table of numbers")
    conditions: Texts = Field(default=(), description=CONDITIONS)
    """What the parameters must fulfil together."""
    components: ComponentsTable = Field(
        default={}, description='"vector", "diagonal" or "symmetric"'
    )
    definitions: dict[str, DefinitionTable] = Field(default={}, description="a table of formulas")
    """Named quantities in order, each in terms of those before it."""
    laws: LawsTable = Field(
        default_factory=lambda: LawsTable(),  # noqa: PLW0108 (rebuilt below)
        description="a table",
    )
    observables: dict[str, ObservableTable] = Field(default={}, description="a table of formulas")
    guards: dict[str, GuardTable] = Field(default={}, description="a table of tables")


class EquationsTables(SystemTables):
    """A system by its equations alone."""

    equations: EquationsTable = Field(description="a table [equations] with state and rates")
    reconstruction: ReconstructionTable | None = Field(
        default=None, description="a table with state and rates"
    )
    start_formulas: Formulas = Field(default={}, description="a table of formulas")
    """How variables of the state follow from omega and gamma, in which a start may be given."""


IsomorphismTable.model_rebuild()
