"""The text of an experiment file, its overriding options, and positions in both."""

from __future__ import annotations

import re
import tomllib
import unicodedata
from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, field
from functools import cached_property

from flowlanes.errors import INVISIBLE, InputError

from .toml import Key, Tables, dotted_key, key_lines

_POSITION = re.compile(r"(.*) \(at (?:line (\d+), column (\d+)|end of document)\)", re.DOTALL)


@dataclass(frozen=True)
class Source:
    """The file and the options from which an experiment was read.

    Attributes
    ----------
    name
        Name of the file, as the user gave it.
    text
        The TOML text as it stands in the file.
    overrides
        Options ``KEY=VALUE`` that replace or add keys, later ones winning.
    given
        Tables that stand in no text: those of a name of the catalogue.
    short
        Names that an option may write for a longer path, such as ``I_1``.
    """

    name: str
    text: str
    overrides: tuple[str, ...] = ()
    tables_given: Mapping[str, object] = field(default_factory=dict)
    short: Mapping[str, Key] = field(default_factory=dict)

    def tables(self) -> Tables:
        """The tables of the file with the overrides applied.

        Raises
        ------
        InputError
            If the text is not TOML, or an override does not have the form ``KEY=VALUE`` or
            leads through something that is no table.
        """
        try:
            tables = deepcopy(dict(self.tables_given)) | self._tables_of_text()
            for option in self.overrides:
                _apply_override(tables, option, self.short)
            self._require_print((), tables)
        except RecursionError:
            raise InputError("not valid TOML: too deeply nested", self.name) from None
        return tables

    def _tables_of_text(self) -> Tables:
        """The tables of the text, without overrides."""
        try:
            return tomllib.loads(self.text)
        except ValueError as error:
            raise self._syntax_error(str(error)) from None

    def _require_print(self, key: Key, value: object) -> None:
        """Raise an error for keys and texts with invisible characters."""
        match value:
            case dict():
                for part, inner in value.items():
                    self._require_print((*key, part), part)
                    self._require_print((*key, part), inner)
            case list():
                for inner in value:
                    self._require_print(key, inner)
            case str():
                control = INVISIBLE.search(value)
                if control:
                    raise InputError(
                        f"the control character U+{ord(control[0]):04X} stands in it, which cannot "
                        "be seen; of these only line breaks and tabs are allowed",
                        self.where(key),
                    )

    def path(self, option: str) -> Key:
        """The key that an option sets."""
        return _path(option.partition("=")[0].strip(), self.short)

    def where(self, key: Key) -> str:
        """The location of a key for an error message.

        Parameters
        ----------
        key
            Its dotted path, such as ``("body", "inertia")``.

        Returns
        -------
        str
            ``"rattleback.toml, line 12, body.inertia"``; the line of the table where the key
            itself is not in the file; the option where an override has set or made it, and all
            of them where several have made a table.
        """
        makers = []
        for option in reversed(self.overrides):
            setting = option.partition("=")[0].strip()
            path = self.path(option)
            if key == path:
                return f"--set {setting}"
            if key[: len(path)] == path:
                return f"--set {setting}, {dotted_key(key)}"
            if key and path[: len(key)] == key and key not in self._lines:
                makers.append(f"--set {setting}")
        if makers:
            return " ".join(dict.fromkeys(reversed(makers)))
        if key[:2] == ("system", "parameters") and key not in self._lines:
            # Parameters of n-dimensional systems may be in another table.
            places = (("system", *key[2:]), ("parameters", *key[2:]))
            key = next((place for place in places if place in self._lines), key)
        number = self.line(key)
        parts = [self.name, f"line {number}" if number else "", dotted_key(key)]
        return ", ".join(part for part in parts if part)

    def line(self, key: Key) -> int:
        """The line of a key in the text, or of its table; 0 if there is neither."""
        lines = (self._lines.get(key[:length], 0) for length in range(len(key), 0, -1))
        return next((line for line in lines if line), 0)

    @cached_property
    def _lines(self) -> dict[Key, int]:
        return key_lines(self.text)

    def _syntax_error(self, message: str) -> InputError:
        # tomllib prints a key as a tuple.
        message = _TUPLE.sub(lambda match: ".".join(re.findall(r"'([^']*)'", match[0])), message)
        match = _POSITION.fullmatch(message)
        if match is None:
            return InputError(f"not valid TOML: {message}", self.name)
        problem, line, column = match.groups()
        if line is None:
            return InputError(f"not valid TOML: {problem} (at the end)", self.name)
        text = "".join(self.text.splitlines()[int(line) - 1 : int(line)])
        sentence = f"not valid TOML: {problem} (column {column}){_hint(text, int(column))}"
        return InputError(sentence, f"{self.name}, line {line}")


def _hint(line: str, column: int) -> str:
    """A guess at the intended meaning of a line that is not TOML, as the end of a sentence."""
    if comma := _DECIMAL_COMMA.search(line):
        return f"; a decimal number has a point: {comma[1]}.{comma[2]}"
    if line.lstrip().startswith(("%", "//", ";", "--", "/*")):
        return "; a comment begins with #"
    character = line[column - 1 : column]
    if character and not character.isascii() and (character.isprintable() or character.isspace()):
        name = unicodedata.name(character, "character").lower()
        return f"; the {name} (U+{ord(character):04X}) is allowed in texts and comments alone"
    return ""


_DECIMAL_COMMA = re.compile(r"=\s*([-+]?\d+),(\d+)\s*(?:#.*)?$")
_TUPLE = re.compile(r"\(('[^']*',? ?)+\)")


def _path(setting: str, short: Mapping[str, Key]) -> Key:
    """The full path of a key given in an option."""
    return short.get(setting) or tuple(setting.split("."))


def _apply_override(tables: Tables, option: str, short: Mapping[str, Key]) -> None:
    """Apply one option ``KEY=VALUE`` to the tables."""
    key, equals, text = option.partition("=")
    key = key.strip()
    path = _path(key, short)
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


def _value(text: str, key: str) -> object:
    """The value of an override: TOML, or text without quotes."""
    try:
        read: Mapping[str, object] = tomllib.loads(f"value = {text}")
    except (ValueError, RecursionError):
        if text[:1] in {"[", "{", '"', "'", ""}:
            message = f"{text or 'nothing'} is not a value; write 2.5, [1, 2, 3], true or a word"
            raise InputError(message, f"--set {key}") from None
        return text
    if len(read) > 1:
        raise InputError("one option sets one key", f"--set {key}")
    return read["value"]
