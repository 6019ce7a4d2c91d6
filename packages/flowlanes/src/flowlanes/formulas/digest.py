"""Digest of everything that determines a computation, the same in every process."""

from __future__ import annotations

import functools
import hashlib
import pickle
from collections.abc import Iterable, Mapping, Sequence, Set
from dataclasses import fields, is_dataclass
from functools import lru_cache
from typing import Any

import numpy as np
import sympy as sp

from ..errors import InputError
from ..system.formula_text import exact_text
from ..system.system import System

#: The attributes of a System that determine its motions.
_OF_A_SYSTEM = ("name", "field", "definitions", "parameters", "relations", "guards", "conventions")


def digest(value: object) -> str:
    """Short name for `value`: equal values have equal names, on every machine.

    Parameters
    ----------
    value
        Numbers, texts, arrays, formulas, Systems, dataclasses, containers of these, functions of a
        module, and :func:`functools.partial` of such functions.

    Raises
    ------
    InputError
        If a part of it has no name of its own, such as a lambda.
    """
    return hashlib.sha256(_text(value)).hexdigest()[:32]


def field_digests(work: object) -> dict[str, str]:
    """Digests of the parts of a work, by name.

    Parameters
    ----------
    work : callable
        Function of a module, a partial of such a function, or a frozen dataclass with
        ``__call__``.

    Returns
    -------
    dict of str to str
        ``"function"`` and every argument or field, so that a difference can be reported by name.
    """
    if isinstance(work, functools.partial):
        digests = {"function": digest(work.func)}
        digests |= {f"argument {n}": digest(value) for n, value in enumerate(work.args, 1)}
        return digests | {name: digest(value) for name, value in work.keywords.items()}
    if is_dataclass(work) and not isinstance(work, type):
        return {"function": digest(type(work))} | {
            item.name: digest(getattr(work, item.name)) for item in fields(work)
        }
    return {"function": digest(work)}


@lru_cache(maxsize=64)
def canonical(system: System) -> System:
    """Equal system whose formulas do not change when it is sent to a worker.

    SymPy writes some of its own products, such as −(a + b), differently after unpickling;
    identical bits require identical formulas in all processes.
    """
    copy: System = pickle.loads(pickle.dumps(system))
    return copy


def _text(value: object) -> bytes:
    """Unambiguous text of type and content of a value."""
    kind, content = _content(value)
    return f"{kind}:{len(content)}:".encode() + content


def _concatenated_digests(values: Sequence[bytes]) -> bytes:
    return b"".join(hashlib.sha256(value).digest() for value in values)


def _content(value: object) -> tuple[str, bytes]:
    match value:
        case None | bool() | int() | float() | complex() | str() | np.generic():
            return _plain(value)
        case bytes():
            return "bytes", value
        case np.ndarray() if value.dtype.hasobject:
            return "objects", _concatenated_digests(
                [_text(value.shape), *map(_text, value.ravel().tolist())]
            )
        case np.ndarray():
            shape = f"{value.dtype.str}{value.shape}".encode()
            return "array", shape + np.ascontiguousarray(value).tobytes()
        case sp.Basic() | sp.MatrixBase():
            return "formula", exact_text(value).encode()
        case functools.partial():
            return "partial", _concatenated_digests([_text(field_digests(value))])
        case System():
            return "System", _concatenated_digests([_text(item) for item in _of_a_system(value)])
        case Mapping():
            pairs = sorted((_text(key), _text(item)) for key, item in value.items())
            return "mapping", _concatenated_digests([part for pair in pairs for part in pair])
        case Set():
            return "set", _concatenated_digests(sorted(map(_text, value)))
        case Sequence():
            return "sequence", _concatenated_digests([_text(item) for item in value])
        case _:
            return _instance_or_name(value)


def _of_a_system(system: System) -> list[Any]:
    """Everything in a System that determines its motions and recorded quantities, without texts."""
    seen = [(item.name, item.value) for item in system.observables]
    laws = [(law.name, law.level, formula) for law in system.laws for formula in law.computed]
    return [*(getattr(system, name) for name in _OF_A_SYSTEM), seen, laws]


def _plain(value: Any) -> tuple[str, bytes]:
    plain = value.item() if isinstance(value, np.generic) else value
    return type(plain).__name__, repr(plain).encode()


def _instance_or_name(value: Any) -> tuple[str, bytes]:
    """Type and fields of a dataclass, or qualified name of a function or a type."""
    if is_dataclass(value) and not isinstance(value, type):
        contents: Iterable[Any] = (getattr(value, item.name) for item in fields(value))
        return "instance", _concatenated_digests([_text(type(value)), *map(_text, contents)])
    name = getattr(value, "__qualname__", "<")
    if "<" in name:
        raise InputError(
            f"{value!r} cannot take part in a computation that is to be resumed: what it is must "
            "show by a name (use functions of a module, dataclasses, numbers, arrays and formulas)"
        )
    return "named", f"{value.__module__}.{name}".encode()
