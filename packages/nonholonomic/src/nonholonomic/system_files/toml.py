"""TOML as text: the line numbers of its keys, and readable output of tables."""

from __future__ import annotations

import re
import tomllib
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from typing import TypeAlias

import tomli_w

Key = tuple[str, ...]

#: Tables of a file: values, or further tables, by name.
Tables: TypeAlias = dict[str, object]

_TOKEN = re.compile(
    r'"""(?:\\.|[^\\])*?"{3,5}'
    r"|'''.*?'{3,5}"
    r'|"(?:\\.|[^"\\\n])*"'
    r"|'[^'\n]*'"
    r"|\#[^\n]*"
    r"|[\n\[\]{}=]"
    r"|[^\n\[\]{}=\"'\#]+"
    r"|.",
    re.DOTALL,
)

#: A dotted key with bare parts, which nearly all keys are.
_BARE = re.compile(r"[A-Za-z0-9_-]+(?:\.[A-Za-z0-9_-]+)*")


def key_lines(text: str) -> dict[Key, int]:
    """The line numbers of the tables and keys of a TOML text.

    Parameters
    ----------
    text
        A valid TOML text. Of an invalid one as much is read as can be.

    Returns
    -------
    dict
        Dotted path of a table or key ↦ number of its line, counted from 1. Keys within an inline
        table or an array are left out; their owner tells the line. Of several tables [[a]] the
        second has the path a.2, and so on.
    """
    lines: dict[Key, int] = {}
    table: Key = ()
    count: Counter[Key] = Counter()
    for number, statement in _statements(text):
        path = _path(statement)
        if statement.startswith("["):
            if statement.startswith("[["):
                count[path] += 1
                path = path if count[path] == 1 else (*path, str(count[path]))
            table = path
        else:
            path = table + path
        # A header [a.b] or a key a.b also creates the table a, unless it already exists.
        for length in range(1, len(path) + 1):
            lines.setdefault(path[:length], number)
    return lines


def _statements(text: str) -> Iterator[tuple[int, str]]:
    """Each table header and each key with its ``=``, with its line number."""
    line, begun, depth = 1, 1, 0
    head, in_value = "", False
    for match in _TOKEN.finditer(text):
        token = match.group()
        if token == "\n" and depth == 0:
            if head.startswith("["):
                yield begun, head
            head, in_value = "", False
        elif not token.startswith("#") and not in_value:
            begun = begun if head else line
            head = (head + token).lstrip()
            in_value = token == "="
            if in_value:
                yield begun, head
        elif token in ("[", "{"):
            depth += 1
        elif token in ("]", "}"):
            depth -= 1
        line += token.count("\n")
    if head.startswith("["):
        yield begun, head


def _path(statement: str) -> Key:
    """The dotted path of a header or of a key with its ``=``, parsed as TOML."""
    key = statement.strip().strip("[]= \t\r")
    if _BARE.fullmatch(key):
        return tuple(key.split("."))
    try:
        nested: object = tomllib.loads(f"{key} = 0")
    except ValueError:
        return ()
    path: list[str] = []
    while isinstance(nested, dict):
        name, nested = next(iter(nested.items()))
        path.append(name)
    return tuple(path)


class Inline(dict[str, object]):
    """A table that is written within one line, ``{ value = 1.0, unit = "kg" }``."""


def dumps(tables: Mapping[str, object]) -> str:
    """Write nested tables with numbers, booleans, texts, arrays of numbers and of tables as TOML.

    Parameters
    ----------
    tables
        What is to be written. Arrays (lists or tuples, also nested) hold numbers or texts; they
        stand on one line, as a vector or a matrix is best read. Empty tables are left out.

    Returns
    -------
    str
        A TOML text that reads back to the same values.
    """
    return "\n\n".join(_blocks((), tables)) + "\n"


def dotted_key(key: Key) -> str:
    """A path as written in a TOML file, with parts quoted where necessary."""
    return ".".join(tomli_w.dumps({part: 0}).removesuffix(" = 0\n") for part in key)


def _blocks(path: Key, table: Mapping[str, object]) -> Iterator[str]:
    """A table followed by its sub-tables, each with its header."""
    inner = {key: value for key, value in table.items() if _tables(value)}
    lines = [_assignment(key, value) for key, value in table.items() if key not in inner]
    if lines:
        header = [f"[{dotted_key(path)}]"] if path else []
        yield "\n".join(header + lines)
    for key, value in inner.items():
        for one in _tables(value):
            blocks = _blocks((*path, key), one)
            if isinstance(value, Mapping):
                yield from blocks
            else:
                yield from (block.replace("[", "[[", 1).replace("]", "]]", 1) for block in blocks)


def _tables(value: object) -> list[Mapping[str, object]]:
    """The tables in a value: itself, or the elements of an array; empty for other values."""
    if isinstance(value, Inline):
        return []
    if isinstance(value, Mapping):
        return [value]
    several = isinstance(value, list | tuple) and value and isinstance(value[0], Mapping)
    return list(value) if several else []  # type: ignore[call-overload]


def _assignment(key: str, value: object) -> str:
    if isinstance(value, list | tuple | Inline):
        return f"{dotted_key((key,))} = {_element(value)}"
    return tomli_w.dumps({key: value}).rstrip("\n")


def _array(values: Sequence[object]) -> str:
    return f"[{', '.join(map(_element, values))}]"


def _element(value: object) -> str:
    if isinstance(value, list | tuple):
        return _array(value)
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping):
        inside = ", ".join(f"{dotted_key((k,))} = {_element(v)}" for k, v in value.items())
        return f"{{ {inside} }}" if inside else "{}"
    return _text(value) if isinstance(value, str) else repr(value)


def _text(value: str) -> str:
    return tomli_w.dumps({"_": value}).removeprefix("_ = ").rstrip("\n")
