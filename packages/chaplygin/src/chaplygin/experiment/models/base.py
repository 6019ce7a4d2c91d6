"""The base class of all experiments: a title, the source text and positions in it."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from nonholonomic.system_files.sourced import SourcedTables
from nonholonomic.system_files.toml import dumps


class ExperimentBase(SourcedTables):
    """The base class of all experiments.

    Two experiments are equal if their tables are, wherever they were read from.
    """

    title: str | None = Field(default=None, description="a text in quotes", min_length=1)
    """The title in reports and figures."""

    def toml(self) -> str:
        """A complete TOML text, including defaults, that reads back to an equal experiment."""
        return dumps(self.model_dump(exclude_none=True))

    def complete_tables(self) -> dict[str, Any]:
        """All tables, including what the catalogue adds."""
        return self.model_dump()

    @property
    def text(self) -> str:
        """The text of its file before overrides, or its own TOML if it has no file."""
        return self._source.text or self.toml()

    def __eq__(self, other: object) -> bool:
        return type(self) is type(other) and self.__dict__ == other.__dict__

    __hash__ = SourcedTables.__hash__
