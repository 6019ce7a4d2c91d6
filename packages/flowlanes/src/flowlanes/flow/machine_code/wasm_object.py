"""Conversion of an LLVM object file for WebAssembly into a module that can be instantiated.

An object made from one module needs no linker: calls within it already contain the function
indices. It lacks a list of exports, whose names are in the symbol table of its section ``linking``;
that section and those of relocations, which only linkers use, are dropped.
https://github.com/WebAssembly/tool-conventions/blob/main/Linking.md
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

MAGIC = b"\0asm\1\0\0\0"

# Sections by number.
_CUSTOM, _IMPORT, _EXPORT, _START = 0, 2, 7, 8
#: Sections of a module without data, tables or variables of its own.
_SECTIONS = {_CUSTOM, 1, _IMPORT, 3, _EXPORT, 10}

_SYMBOL_TABLE = 8
#: Kinds of imports and exports.
_FUNCTION, _MEMORY = 0, 2
_UNDEFINED, _EXPLICIT_NAME = 0x10, 0x40

#: Kinds of relocations that refer to functions and types by final indices.
_FUNCTION_INDEX, _TYPE_INDEX = 0, 6


class NotSelfContainedError(ValueError):
    """Raised for an object that refers to external symbols, or to memory of its own."""


@dataclass
class _Reader:
    """Reader of bytes one after another."""

    data: bytes
    at: int = 0

    @property
    def over(self) -> bool:
        return self.at >= len(self.data)

    def byte(self) -> int:
        self.at += 1
        return self.data[self.at - 1]

    def number(self) -> int:
        """An unsigned integer, seven bits per byte (LEB128)."""
        value = shift = 0
        while True:
            byte = self.byte()
            value |= (byte & 0x7F) << shift
            shift += 7
            if byte < 0x80:
                return value

    def take(self, count: int) -> bytes:
        self.at += count
        return self.data[self.at - count : self.at]

    def name(self) -> str:
        return self.take(self.number()).decode()


def leb(value: int) -> bytes:
    """Encode an unsigned integer, seven bits per byte."""
    result = bytearray()
    while value >= 0x80:
        result.append(value & 0x7F | 0x80)
        value >>= 7
    return bytes([*result, value])


def sections(module: bytes) -> Iterator[tuple[int, bytes]]:
    """Number and contents of each section of a module or an object."""
    if module[:8] != MAGIC:
        raise NotSelfContainedError("this is no WebAssembly of version 1")
    reader = _Reader(module, 8)
    while not reader.over:
        kind = reader.byte()
        yield kind, reader.take(reader.number())


def module_of_object(code: bytes, exports: Sequence[str]) -> bytes:
    """Build a module from the functions in an object file.

    Parameters
    ----------
    code : bytes
        Object file from LLVM, of one module.
    exports : sequence of str
        Functions that can be called from outside.

    Returns
    -------
    bytes
        Module that imports only the memory ``env.memory``.

    Raises
    ------
    NotSelfContainedError
        If the object calls a function that it does not define, uses the stack or has data.
    """
    parts: list[tuple[int, bytes]] = []
    places: dict[str, int] = {}
    for kind, body in sections(code):
        if kind == _CUSTOM:
            reader = _Reader(body)
            title = reader.name()
            if title == "linking":
                places = _functions(reader)
            elif title.startswith("reloc."):
                _check_relocations(title, reader)
        elif kind == _IMPORT:
            parts.append((kind, _import_of_memory(body)))
        elif kind in _SECTIONS:
            parts.append((kind, body))
        else:
            raise NotSelfContainedError(f"the object has a section of kind {kind}")
    missing = [name for name in exports if name not in places]
    if missing:
        raise NotSelfContainedError(f"the object has no function {', '.join(missing)}")
    entries = [_name(name) + bytes([_FUNCTION]) + leb(places[name]) for name in exports]
    listed = (_EXPORT, leb(len(entries)) + b"".join(entries))
    before = [part for part in parts if part[0] < _EXPORT]
    after = [part for part in parts if part[0] > _EXPORT]
    return MAGIC + b"".join(
        bytes([kind]) + leb(len(body)) + body for kind, body in (*before, listed, *after)
    )


def _name(text: str) -> bytes:
    return leb(len(text.encode())) + text.encode()


def _import_of_memory(body: bytes) -> bytes:
    """The import section, which must import only the memory."""
    reader = _Reader(body)
    limits = b""
    for _ in range(reader.number()):
        reader.name()
        name, kind = reader.name(), reader.byte()
        if kind != _MEMORY:
            raise NotSelfContainedError(f"the object needs {name}")
        first = reader.at
        for _ in range(1 + reader.byte() % 2):
            reader.number()
        limits = reader.data[first : reader.at]
    return leb(1) + _name("env") + _name("memory") + bytes([_MEMORY]) + limits


def _functions(reader: _Reader) -> dict[str, int]:
    """Function indices by name, from the section ``linking``."""
    places: dict[str, int] = {}
    reader.number()
    while not reader.over:
        kind, size = reader.byte(), reader.number()
        table = _Reader(reader.take(size))
        if kind != _SYMBOL_TABLE:
            continue
        for _ in range(table.number()):
            sort, flags = table.byte(), table.number()
            if sort != _FUNCTION:
                raise NotSelfContainedError(f"the object has a symbol of kind {sort}")
            place = table.number()
            if flags & _UNDEFINED:
                name = table.name() if flags & _EXPLICIT_NAME else f"number {place}"
                raise NotSelfContainedError(f"the object calls a function {name} elsewhere")
            places[table.name()] = place
    return places


def _check_relocations(title: str, reader: _Reader) -> None:
    """Raise an error for relocations that would require a linker."""
    reader.number()
    for _ in range(reader.number()):
        kind = reader.number()
        if kind not in (_FUNCTION_INDEX, _TYPE_INDEX):
            raise NotSelfContainedError(f"{title}: a relocation of kind {kind}")
        reader.number()
        reader.number()
