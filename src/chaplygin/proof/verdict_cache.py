"""A cache of verdicts on disk, each under a digest of all that it depends on.

A verdict depends on the system, the law, the program text and the versions of the exact
arithmetic; whatever changes one of them makes another digest, so that nothing stale is read.  A
verdict counts as a proof, so it is only ever read as :mod:`chaplygin.core.private_files` reads.
"""

from __future__ import annotations

import hashlib
import json
import platform
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import sympy as sp

from ..core import private_files
from ..core.laws import Law
from ..core.source_digest import core
from ..core.system import Guard, Parameter, System
from .verdict import Verdict

__all__ = ["digest", "fingerprint", "load_verdict", "store_verdict"]


FOR_THE_READER = frozenset({"as_printed", "meaning", "misprint", "source", "unit"})
"""What of a law no proof depends on."""


def folder() -> Path:
    """The folder of the verdicts; the variable CHAPLYGIN_CACHE overrides it."""
    return private_files.home() / "verdicts"


def digest(*parts: str) -> str:
    """A name for a verdict that depends on `parts` and on the versions of the arithmetic."""
    names = ("chaplygin", "mpmath", "python-flint", "sympy")
    versions = (f"{name} {version(name)}" for name in names)
    return hashlib.sha256(
        "\x00".join((*parts, platform.python_version(), *versions)).encode()
    ).hexdigest()


def fingerprint(system: System, law: Law) -> str:
    """A name for the verdict on a law of a system."""
    return digest(_text_of(system), _text_of(law), core())


def _text_of(value: object) -> str:
    """Everything that a value is made of and a proof may depend on, as text."""
    if isinstance(value, sp.Basic | sp.MatrixBase):
        return str(sp.srepr(value))
    if isinstance(value, System):
        shape = (value.field, value.definitions, value.relations, value.parameters, value.guards)
        return f"System{_text_of(shape)}"
    if isinstance(value, Parameter):
        # meaning and unit are for the reader
        return f"Parameter{_text_of((value.symbol, value.default, value.admissible))}"
    if isinstance(value, Guard):
        return f"Guard{_text_of((value.value, value.lift_off))}"
    if isinstance(value, tuple | list):
        return f"({', '.join(map(_text_of, value))})"
    if isinstance(value, Law):
        parts = {name: v for name, v in vars(value).items() if name not in FOR_THE_READER}
        return f"{type(value).__name__}{ {n: _text_of(v) for n, v in parts.items()} }"
    if isinstance(value, Mapping):
        return f"{{{', '.join(sorted(f'{_text_of(k)}: {_text_of(v)}' for k, v in value.items()))}}}"
    if is_dataclass(value) and not isinstance(value, type):
        parts = {field.name: getattr(value, field.name) for field in fields(value)}
        return f"{type(value).__name__}{_text_of(parts)}"
    return repr(value)


def load_verdict(name: str, effort: int | None = None) -> Verdict | None:
    """The verdict kept under a name, if there is one that can be read.

    Parameters
    ----------
    effort : int, optional
        Term operations allowed.  The verdict is what they lead to by themselves: one that took
        fewer, or one for which just as many were spent; whatever else is kept does not count.
    """
    stored = _read(name)
    if effort is None or (stored is not None and stored.effort < effort):
        return stored
    return _read(_name_at_effort(name, effort))


def store_verdict(name: str, verdict: Verdict, effort: int | None = None) -> None:
    """Keep a verdict; where the disk does not allow it, it is computed again next time.

    Parameters
    ----------
    effort : int, optional
        Term operations that were allowed.  Where all of them were spent, the verdict is kept for
        this effort alone, since more may lead further and fewer not so far.
    """
    if effort is not None and verdict.effort >= effort:
        name = _name_at_effort(name, effort)
    content = {n: v for n, v in vars(verdict).items() if n not in ("certificate", "uncertified")}
    private_files.write_private(_file(name), json.dumps(content).encode())


def _name_at_effort(name: str, effort: int) -> str:
    """The name of what all of an effort led to."""
    return f"{name}-{effort}"


def _file(name: str) -> Path:
    return folder() / f"{name}.json"


def _read(name: str) -> Verdict | None:
    stored = private_files.read_private(_file(name))
    if stored is None:
        return None
    try:
        content: dict[str, Any] = json.loads(stored)
        for listed in ("conditions", "formulas"):
            content[listed] = tuple(content.get(listed, ()))
        return Verdict(**content)
    except (ValueError, TypeError, AttributeError, RecursionError):
        return None
