"""Verdicts cached on disk, each under a digest of everything it depends on.

A verdict depends on the system, the law, the program text and the versions of the exact
arithmetic; a change in any of them changes the digest, so that no stale verdict is read. Since a
verdict counts as a proof, it is read only through :mod:`flowlanes.files.private_files`.
"""

from __future__ import annotations

import json
import logging
from collections.abc import Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any

from flowlanes.files import private_files
from flowlanes.files.cache import entry_name, folder
from flowlanes.formulas.digest import digest
from flowlanes.system.laws import Law
from flowlanes.system.system import Guard, Parameter, System, Theorem

from .verdict import Verdict

_LOG = logging.getLogger(__name__)

FOR_THE_READER = frozenset({"as_printed", "meaning", "misprint", "source", "unit"})
"""Fields of a law that do not affect a proof."""


def fingerprint(system: System, law: Law, theorem: Theorem | None = None) -> str:
    """The cache name of the verdict on a law of a system, with an optional theorem."""
    parts = [digest(_statement(system)), digest(_statement(law))]
    if theorem is not None:
        parts.append(digest(_statement(theorem)))
    return entry_name("verdict", *parts)


def _statement(value: object) -> object:
    """A value without the names and texts that do not affect a proof."""
    match value:
        case System():
            shape = (value.field, value.definitions, value.relations)
            return ("System", *map(_statement, (*shape, value.parameters, value.guards)))
        case Parameter():
            return ("Parameter", value.symbol, value.default, value.admissible)
        case Guard():
            return ("Guard", value.value, value.lift_off)
        case Theorem():
            return tuple(_statement(v) for v in vars(value).values() if not callable(v))
        case Law():
            names = [f.name for f in fields(value) if f.name not in FOR_THE_READER]
            return (type(value), _statement({name: getattr(value, name) for name in names}))
        case Mapping():
            return {key: _statement(item) for key, item in value.items()}
        case tuple() | list():
            return tuple(map(_statement, value))
        case _:
            return value


def load_verdict(name: str, effort: int | None = None) -> Verdict | None:
    """The verdict stored under a name, or None.

    Parameters
    ----------
    effort : int, optional
        Term operations allowed. A stored verdict is returned only if this effort leads to it: it
        used less, or was stored for exactly this effort.
    """
    verdict = _read(name)
    if effort is None or (verdict is not None and verdict.effort < effort):
        return verdict
    return _read(_name_at_effort(name, effort))


def store_verdict(name: str, verdict: Verdict, effort: int | None = None) -> None:
    """Store a verdict; a failure to write is ignored.

    Parameters
    ----------
    effort : int, optional
        Term operations allowed. If all were used, the verdict is stored for this effort only,
        since a larger one may decide the law and a smaller one may stop earlier.
    """
    if effort is not None and verdict.effort >= effort:
        name = _name_at_effort(name, effort)
    left_out = ("certificate", "no_certificate", "identities")
    content = {n: v for n, v in vars(verdict).items() if n not in left_out}
    private_files.write_private(_file(name), json.dumps(content).encode())


def _name_at_effort(name: str, effort: int) -> str:
    """The cache name of a verdict that used up its whole effort."""
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
        verdict = Verdict(**content)
        _LOG.debug("verdict about %s read from %s", verdict.law, _file(name))
        return verdict
    except (ValueError, TypeError, AttributeError, RecursionError):
        return None
