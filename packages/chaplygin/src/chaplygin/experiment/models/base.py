"""The base of all experiments: a title, the source text and places in it."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from pydantic import Field, PrivateAttr

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError

from ..file.source import Source
from ..file.table import Table
from ..file.toml import Key, dumps


class ExperimentBase(Table):
    """The base of all experiments.

    Two experiments are equal when their tables are, wherever they were read from.
    """

    title: str | None = Field(default=None, description="a text in quotes", min_length=1)
    """The title in reports and figures."""

    _source: Source = PrivateAttr(Source("<experiment>", ""))

    def toml(self) -> str:
        """A complete TOML text, defaults included, that reads back to an equal experiment."""
        return dumps(self.model_dump(exclude_none=True))

    def complete_tables(self) -> dict[str, Any]:
        """All tables, with what the catalogue adds to them."""
        return self.model_dump()

    @property
    def text(self) -> str:
        """The text of its file before overrides, or its own TOML if it has no file."""
        return self._source.text or self.toml()

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

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.__dict__ == other.__dict__

    def __hash__(self) -> int:
        return hash(self.toml())


def identifier(title: str) -> str:
    """A title as the name of a system, ``chaplygin-sleigh``."""
    return "-".join(re.findall(r"\w+", title.lower())) or "untitled-system"
