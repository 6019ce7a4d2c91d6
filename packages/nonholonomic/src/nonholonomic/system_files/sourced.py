"""Tables that were read from a file, and the places of their keys in it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Self, TypeVar

from pydantic import PrivateAttr, ValidationError

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError

from .source import Source
from .table import Table
from .toml import Key, Tables, dumps
from .validation import validation_messages

FileTables = TypeVar("FileTables", bound="SourcedTables")


class SourcedTables(Table):
    """The tables of a file, with the text that they were read from."""

    _source: Source = PrivateAttr(Source("<experiment>", ""))

    # tables of named values are dictionaries, which have no hash of their own
    def __hash__(self) -> int:
        return hash(dumps(self.model_dump(exclude_none=True)))

    @classmethod
    def of_tables(cls, tables: Tables) -> Self:
        """The model of the tables of a file.

        Raises
        ------
        pydantic.ValidationError
            If something is wrong in them.
        """
        return cls.model_validate(tables)

    @property
    def overrides(self) -> tuple[str, ...]:
        """The options ``KEY=VALUE`` that were applied to the text."""
        return self._source.overrides

    @arguments_checked
    def has(self, *key: str) -> bool:
        """Whether a key such as ``has("body", "mass")`` is given or has a default."""
        table: object = self.model_dump()
        for part in key:
            if not isinstance(table, Mapping) or part not in table:
                return False
            table = table[part]
        return True

    @arguments_checked
    def path(self, option: str) -> Key:
        """The key that an option sets."""
        return self._source.path(option)

    @arguments_checked
    def where(self, *key: str) -> str:
        """The place of a key in the file, such as ``where("body", "mass")``."""
        return self._source.where(key)

    def line(self, *key: str) -> int:
        """The line of a key in the file; 0 where there is no text."""
        return self._source.line(key)

    @contextmanager
    def placing_errors(self, *key: str) -> Iterator[None]:
        """Give a mistake that only mechanics could see its place in the file."""
        try:
            yield
        except InputError as error:
            if error.where:
                raise
            subject, colon, sentence = error.message.partition(": ")
            if colon and subject == key[-1]:
                raise InputError(sentence, self.where(*key)) from None
            if colon and self.has(*key, subject):
                raise InputError(sentence, self.where(*key, subject)) from None
            # "radius -1.0 of the ball: ...", and a component of a vector
            for name in (subject.partition(" ")[0], subject.rpartition("_")[0]) if colon else ():
                if name and self.has(*key, name):
                    raise InputError(error.message, self.where(*key, name)) from None
            raise InputError(error.message, self.where(*key)) from None


def validated(model: type[FileTables], tables: Tables, source: Source) -> FileTables:
    """Validate the tables of a file against a model.

    Raises
    ------
    InputError
        For all that is wrong in them: one line for each mistake with file, line, key and what is
        allowed.
    """
    try:
        made = model.of_tables(tables)
    except ValidationError as error:
        raise mistakes(validation_messages(error, model, tables), source) from None
    made._source = source
    return made


def mistakes(wrong: Mapping[Key, str], source: Source) -> InputError:
    """The error that lists mistakes by their keys, in the order of the file."""
    in_order = sorted(wrong, key=lambda key: source.line(key) or math.inf)
    return InputError("\n".join(f"{source.where(key)}: {wrong[key]}" for key in in_order))


def identifier(title: str) -> str:
    """A title as the name of a system, ``chaplygin-sleigh``."""
    return "-".join(re.findall(r"\w+", title.lower())) or "untitled-system"
