"""The files of the catalogue: each system has one, by which `list` knows it without SymPy.

A file ``NAME.toml`` is an experiment file with a table ``[catalogue]`` besides, which gives the
system its place in the catalogue.  It describes the system by equations, by a Lagrangian, or by a
body whose numbers are formulas in the parameters.  Where none of these will do (a family of
systems exists in every dimension, or laws have a proof of their own), ``catalogue.python`` names
the module whose ``ENTRIES`` make the equations, and the file has only the title, the parameters and
the start.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from pathlib import Path
from typing import Any

from flowlanes.errors import InputError

FOLDER = Path(__file__).parent

#: The first table of a file; before it stand the title and the place in the catalogue.
_TABLE = re.compile(r"^\[", re.MULTILINE)

#: Variables of a ball's state by the keys that give them at its start.
_BALL_STATE = {"contact": "x", "centre": "R"}


@dataclass(frozen=True)
class EntryFile:
    """A file of the catalogue.

    Attributes
    ----------
    path : Path
    name, title, summary, source : str
        As of an :class:`~nonholonomic.catalogue.Entry`.
    group : str
        The name of its group.
    integrable : bool
        Whether the system is proven integrable with the values of its parameters.
    python : str
        The module of the catalogue with the equations; empty if the file describes the system.
    laws : str
        ``"module:function"`` that states the laws of a body.
    general : str
        ``"module:function"`` that makes the system with unspecified functions.
    """

    path: Path
    name: str
    title: str
    summary: str
    source: str
    group: str
    integrable: bool
    python: str
    laws: str
    general: str

    @cached_property
    def text(self) -> str:
        """The whole text."""
        return self.path.read_text(encoding="utf-8")

    @cached_property
    def tables(self) -> Mapping[str, Any]:
        """All tables as TOML gives them."""
        return tomllib.loads(self.text)

    @property
    def complete(self) -> bool:
        """Whether the file contains the equations and all laws."""
        return not self.python and "body" not in self.tables

    @property
    def parameters(self) -> dict[str, float]:
        """The values of the parameters by symbol name; empty for a family."""
        values: dict[str, float] = {}
        for name, given in self.tables.get("parameters", {}).items():
            number = given["value"] if isinstance(given, dict) else given
            values[name] = float(number)
        return values

    @property
    def start(self) -> dict[str, float | tuple[float, ...]]:
        """The start by the names of its variables."""
        of_a_body = _BALL_STATE if "body" in self.tables else {}
        values: dict[str, float | tuple[float, ...]] = {}
        for name, value in self.tables.get("start", {}).items():
            number = tuple(map(float, value)) if isinstance(value, list) else float(value)
            values[of_a_body.get(name, name)] = number
        return values

    @property
    def until(self) -> float:
        """How long the motion is to be followed."""
        return float(self.tables["run"]["until"])

    @property
    def variables(self) -> dict[str, tuple[str, str]]:
        """Meaning and unit of variables of the state."""
        given = self.tables.get("variables", {})
        return {name: (notes["meaning"], notes.get("unit", "")) for name, notes in given.items()}

    @property
    def letters(self) -> dict[str, str]:
        """Meanings of letters in the equations."""
        return dict(self.tables.get("letters", {}))


def read_head(path: Path) -> EntryFile:
    """A file of the catalogue; only the keys before its first table are read.

    Raises
    ------
    InputError
        If they are not TOML, or the title or the place in the catalogue is missing.
    """
    text = path.read_text(encoding="utf-8")
    match = _TABLE.search(text)
    try:
        head = tomllib.loads(text[: match.start()] if match else text)
    except ValueError as error:
        raise InputError(f"not valid TOML: {error}", path.name) from None
    place = head.get("catalogue")
    if "title" not in head or not isinstance(place, dict) or "group" not in place:
        raise InputError(
            "title and catalogue.group must stand before the first table; the group is a key of "
            "nonholonomic.catalogue.groups",
            path.name,
        )
    return EntryFile(
        path,
        path.stem,
        head["title"],
        head.get("summary", ""),
        head.get("source", ""),
        place["group"],
        place.get("integrable", False),
        place.get("python", ""),
        place.get("laws", ""),
        place.get("general", ""),
    )


@cache
def paths() -> dict[str, Path]:
    """The paths of the files by the names of their systems."""
    return {path.stem: path for path in sorted(FOLDER.rglob("*.toml"))}


@cache
def entry_file(name: str) -> EntryFile:
    """The file of a system; KeyError if there is none of that name."""
    return read_head(paths()[name])


@cache
def entry_files() -> tuple[EntryFile, ...]:
    """All files, in the order of the paper."""
    return tuple(sorted(map(entry_file, paths()), key=lambda file: (_place(file), file.name)))


def _place(file: EntryFile) -> tuple[int, ...]:
    """Section and subsection of the paper in which a system occurs first."""
    match = re.search(r"§(\d+)(?:\.(\d+))?", file.source)
    return tuple(int(number or 0) for number in match.groups()) if match else (99,)
