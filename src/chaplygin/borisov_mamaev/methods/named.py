"""Laws of a System by their names."""

from __future__ import annotations

from ...core.laws import Law
from ...core.system import System

__all__ = ["named"]


def named(system: System, name: str) -> Law:
    """The law of that name.

    Raises
    ------
    KeyError
        If the system has no such law.
    """
    for law in system.laws:
        if getattr(law, "name", "") == name:
            return law
    raise KeyError(f"{system.name} has no law {name!r}")
