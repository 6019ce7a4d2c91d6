"""The text of an experiment file, the options that override it, and places in both."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from ..errors import InputError
from .toml_text import Key, dotted, key_lines

__all__ = ["Source"]

_POSITION = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)

#: Control characters but for tabs and line breaks.
_CONTROL = re.compile(r"[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x9f]")


@dataclass(frozen=True)
class Source:
    """Where an experiment was read from.

    Attributes
    ----------
    name
        Name of the file, as the user gave it.
    text
        The TOML text as it stands in the file.
    overrides
        Options ``KEY=VALUE`` that replace or add keys, later ones winning.
    """

    name: str
    text: str
    overrides: tuple[str, ...] = ()

    def tables(self) -> dict[str, Any]:
        """The tables of the file with the overrides put in.

        Raises
        ------
        InputError
            If the text is not TOML, or an override does not have the form ``KEY=VALUE`` or
            leads through something that is no table.
        """
        try:
            tables = tomllib.loads(self.text)
        except RecursionError:
            raise InputError("not valid TOML: too deeply nested", self.name) from None
        except ValueError as error:
            raise self._syntax_error(str(error)) from None
        for option in self.overrides:
            _put(tables, option)
        self._require_print((), tables)
        return tables

    def _require_print(self, key: Key, value: Any) -> None:
        """Refuse keys and texts with characters that would command a terminal or end a text."""
        match value:
            case dict():
                for part, inner in value.items():
                    self._require_print((*key, part), part)
                    self._require_print((*key, part), inner)
            case list():
                for inner in value:
                    self._require_print(key, inner)
            case str():
                found = _CONTROL.search(value)
                if found:
                    raise InputError(
                        f"the control character U+{ord(found[0]):04X} stands in it; of these only "
                        "line breaks and tabs are allowed",
                        self.where(key),
                    )

    def where(self, key: Key) -> str:
        """Name the place of a key for an error message.

        Parameters
        ----------
        key
            Its dotted path, such as ``("body", "inertia")``.

        Returns
        -------
        str
            ``"rattleback.toml, line 12, body.inertia"``; the line of the table where the key
            itself is not in the file; the option where an override has set or made it.
        """
        for option in reversed(self.overrides):
            setting = option.partition("=")[0].strip()
            path = tuple(setting.split("."))
            made = key and path[: len(key)] == key and key not in self._lines
            if key == path or made:
                return f"--set {setting}"
            if key[: len(path)] == path:
                return f"--set {setting}, {dotted(key)}"
        number = self.line(key)
        parts = [self.name, f"line {number}" if number else "", dotted(key)]
        return ", ".join(part for part in parts if part)

    def line(self, key: Key) -> int:
        """The line of a key in the text, or of the table it belongs to; 0 if neither is there."""
        lines = (self._lines.get(key[:length], 0) for length in range(len(key), 0, -1))
        return next((line for line in lines if line), 0)

    @cached_property
    def _lines(self) -> dict[Key, int]:
        return key_lines(self.text)

    def _syntax_error(self, message: str) -> InputError:
        match = _POSITION.fullmatch(message)
        if match is None:
            return InputError(f"not valid TOML: {message}", self.name)
        problem, line, column = match.groups()
        if line is None:
            return InputError(f"not valid TOML: {problem} (at the end)", self.name)
        sentence = f"not valid TOML: {problem} (column {column})"
        return InputError(sentence, f"{self.name}, line {line}")


def _put(tables: dict[str, Any], option: str) -> None:
    """Put one option ``KEY=VALUE`` into the tables."""
    key, equals, text = option.partition("=")
    key = key.strip()
    path = key.split(".")
    if not equals or not all(re.fullmatch(r"[A-Za-z0-9_-]+", part) for part in path):
        message = "an override has the form KEY=VALUE, such as body.mass=2"
        raise InputError(message, f"--set {option}")
    table = tables
    for depth, part in enumerate(path[:-1], 1):
        inner = table.setdefault(part, {})
        if not isinstance(inner, dict):
            message = f"{'.'.join(path[:depth])} is a value, not a table that could hold keys"
            raise InputError(message, f"--set {key}")
        table = inner
    value, last = _value(text.strip(), key), table.get(path[-1])
    if isinstance(last, dict) and "value" in last and not isinstance(value, dict):
        last["value"] = value  # the notes beside a value stay
    else:
        table[path[-1]] = value


def _value(text: str, key: str) -> Any:
    """The value of an override: TOML, or a text without its quotes."""
    try:
        read: Mapping[str, Any] = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):
        if text[:1] in {"[", "{", '"', "'", ""}:
            message = f"{text or 'nothing'} is not a value; write 2.5, [1, 2, 3], true or a word"
            raise InputError(message, f"--set {key}") from None
        return text
    if len(read) > 1:
        raise InputError("one option sets one key", f"--set {key}")
    return read["value"]
