"""Registered printers of systems and formulas.

Printers import the printed classes, so these cannot import the printers and look them up here.
"""

from __future__ import annotations

from collections.abc import Callable

_SOURCES: list[Callable[[], object]] = []


def use_printers(source: Callable[[], object]) -> None:
    """Register a function that imports the printers.

    The function is called when something is first printed.
    """
    _SOURCES[:] = [source]


def printers() -> object:
    """Printers: an object with the attributes `system` and `formula`."""
    (source,) = _SOURCES
    return source()
