"""Kinds of tables that other modules may add to: shapes, surfaces, laws of friction.

The tables of this package stand in its modules.  A class with a `kind` of its own, a dataclass of
numbers, texts and truth values, is known as soon as its module is imported, and its table is made
of its fields.  Modules that are named as entry points of the group ``nonholonomic.kinds`` are
imported when a file names a kind that nobody knows yet.
"""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Callable
from functools import cache, reduce
from importlib.metadata import entry_points
from operator import or_
from types import UnionType
from typing import (
    TYPE_CHECKING,
    Annotated,
    Any,
    ClassVar,
    Literal,
    TypeAlias,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

from pydantic import (
    Field,
    GetCoreSchemaHandler,
    GetJsonSchemaHandler,
    StrictBool,
    StrictInt,
    TypeAdapter,
    ValidationInfo,
    create_model,
)
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, core_schema

from flowlanes.errors import InputError

from .table import Number, Table

if TYPE_CHECKING:
    from ..mechanics.shapes.kinds import Registered

#: Modules that add kinds are entry points of this group.
GROUP = "nonholonomic.kinds"
#: The module of `Registered`, which takes long to import.
_BASE_OF_KINDS = "nonholonomic.mechanics.shapes.kinds"

Register: TypeAlias = "Callable[[], type[Registered]]"


class KindTable(Table):
    """A table that describes an object of one kind."""

    described: ClassVar[Any] = None
    """The class of the object, where the table is made of its fields."""

    def made(self) -> Any:
        """The object that it describes; its fields have the names of the keys.

        Raises
        ------
        InputError
            If a number is not admissible.
        """
        return self.described(**self.model_dump(exclude={"kind", "parameters"}))


class _Open:
    """An annotation of a field whose tables are found when it is read."""

    def __init__(
        self, base: type[KindTable], register: Register, own_words: frozenset[str]
    ) -> None:
        self._base, self._register, self._own_words = base, register, own_words

    def _adapter(self, kind: str | None) -> TypeAdapter[Any]:
        raise NotImplementedError

    def _validate(self, value: object, info: ValidationInfo) -> object:
        raise NotImplementedError

    def added(self) -> dict[str, type[KindTable]]:
        """The tables of kinds that other modules have added, by their words."""
        # nobody has added any where the base of all of them is not imported
        if _BASE_OF_KINDS not in sys.modules:
            return {}
        return {
            word: table_of(kind, self._base)  # type: ignore[arg-type]  # a class has a hash
            for word, kind in self._register().kinds().items()
            if word not in self._own_words
        }

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.with_info_plain_validator_function(self._validate)

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return handler(self._adapter(None).core_schema)


class OpenKinds(_Open):
    """A table with the key ``kind``, which may be one of this package or an added one.

    Parameters
    ----------
    base : type of KindTable
        What all these tables have in common.
    own : tuple of types
        The tables of this package.
    register : callable
        () ↦ the base of the classes that are described.
    """

    def __init__(
        self, base: type[KindTable], own: tuple[type[KindTable], ...], register: Register
    ) -> None:
        self._own = {table.model_fields["kind"].default: table for table in own}
        super().__init__(base, register, frozenset(self._own))

    def knows(self, kind: str) -> bool:
        """Whether there is a table of that kind."""
        return any(table.model_fields["kind"].default == kind for table in self.tables(kind))

    def tables(self, kind: object = None) -> tuple[type[KindTable], ...]:
        """All tables, or those of this package alone if one of them has that kind."""
        if isinstance(kind, str) and kind in self._own:
            return tuple(self._own.values())
        # plug-ins take time to import, and most files name a kind of this package
        tables = {**self.added(), **self._own}
        if isinstance(kind, str) and kind not in tables:
            import_entry_points()
            tables = {**self.added(), **self._own}
        return (*self._own.values(), *(t for t in tables.values() if t not in self._own.values()))

    def _adapter(self, kind: object) -> TypeAdapter[Any]:
        return _union(self.tables(kind))

    def _validate(self, value: object, info: ValidationInfo) -> object:
        kind = value.get("kind") if isinstance(value, dict) else getattr(value, "kind", None)
        return self._adapter(kind).validate_python(value, context=info.context)


class OpenTable(_Open):
    """A table whose keys are the words of added kinds, each with a table of its own.

    Parameters
    ----------
    base, register
        As of `OpenKinds`.
    own_words : frozenset of str
        The kinds of this package, which are described in another way.
    """

    def table(self) -> type[Table]:
        """The table as it is now."""
        return _table_of_kinds(tuple(self.added().items()))

    def _adapter(self, kind: object) -> TypeAdapter[Any]:
        return TypeAdapter(self.table())

    def _validate(self, value: object, info: ValidationInfo) -> object:
        if value is None:
            return None
        if isinstance(value, dict) and value.keys() - self.added().keys():
            import_entry_points()
        if isinstance(value, Table):
            value = value.model_dump(exclude_none=True)
        return self._adapter(None).validate_python(value, context=info.context)


def choices_of(field: FieldInfo) -> object:
    """The tables of a field as an annotation: a union of kinds, or a table; else its own."""
    for note in field.metadata:
        if isinstance(note, OpenKinds):
            return reduce(or_, note.tables())
        if isinstance(note, OpenTable):
            return note.table()
    return field.annotation


@cache
def _union(tables: tuple[type[KindTable], ...]) -> TypeAdapter[Any]:
    choice: Any = Annotated[reduce(or_, tables), Field(discriminator="kind")]
    return TypeAdapter(choice)


@cache
def _table_of_kinds(tables: tuple[tuple[str, type[KindTable]], ...]) -> type[Table]:
    fields: dict[str, Any] = {
        word: (table | None, Field(default=None, description="a table")) for word, table in tables
    }
    return create_model("AddedLawsTable", __base__=Table, **fields)


@cache
def table_of(kind: type[Registered], base: type[KindTable]) -> type[KindTable]:
    """The table of a kind, made of its fields.

    The metadata ``description`` of a field completes the sentence "KEY must be".

    Raises
    ------
    InputError
        If a field is no number, text, truth value or tuple of numbers.

    Examples
    --------
    >>> import nonholonomic
    >>> from nonholonomic.system_files.open_kinds import KindTable, table_of
    >>> list(table_of(nonholonomic.Disk, KindTable).model_fields)
    ['centre', 'radius']
    """
    hints = get_type_hints(kind)
    fields: dict[str, Any] = {}
    for field in dataclasses.fields(kind):  # type: ignore[arg-type]  # of dataclasses alone
        if field.name in base.model_fields or not field.init:
            continue
        allowed, words = _allowed(hints[field.name], f"{kind.__name__}.{field.name}")
        given = {} if field.default is dataclasses.MISSING else {"default": field.default}
        description = field.metadata.get("description", words)
        fields[field.name] = (allowed, Field(description=description, **given))
    if "kind" in base.model_fields:
        fields = {"kind": (Literal[kind.kind], kind.kind), **fields}
    doc = (kind.__doc__ or "").partition("\n")[0]
    table = create_model(f"{kind.__name__}Table", __base__=base, __doc__=doc, **fields)
    table.described = kind
    return table


_NUMBERS = {2: "2 finite numbers", 3: "3 finite numbers", 4: "4 finite numbers"}


def _allowed(hint: Any, where: str) -> tuple[Any, str]:
    """The type of a key for a field, and its description in words."""
    plain = {
        float: (Number, "a finite number"),
        int: (StrictInt, "a whole number"),
        bool: (StrictBool, "true or false"),
        str: (str, "a text in quotes"),
    }
    if hint in plain:
        return plain[hint]
    inner = get_args(hint)
    if get_origin(hint) is Literal:
        return hint, " or ".join(f'"{word}"' for word in inner)
    if get_origin(hint) is tuple and set(inner) == {float} and len(inner) in _NUMBERS:
        return tuple[(Number,) * len(inner)], _NUMBERS[len(inner)]  # type: ignore[misc]
    if get_origin(hint) in (Union, UnionType) and len(inner) == 2 and type(None) in inner:
        allowed, words = _allowed(next(x for x in inner if x is not type(None)), where)
        return allowed | None, words
    raise InputError(
        f"{where}: a file can give numbers, texts, truth values and tuples of numbers alone"
    )


@cache
def import_entry_points() -> None:
    """Import the modules that are entry points of the group ``nonholonomic.kinds``.

    Raises
    ------
    InputError
        If one cannot be imported.
    """
    for point in entry_points(group=GROUP):
        try:
            point.load()
        except Exception as error:
            message = f"the plug-in {point.name} = {point.value} of {GROUP} fails: {error}"
            raise InputError(message) from error
