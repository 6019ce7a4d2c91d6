"""The printers of systems and formulas, which the package as a whole names.

What is printed does not import what prints it, which imports it: it asks here.
"""

from __future__ import annotations

from collections.abc import Callable

_SOURCES: list[Callable[[], object]] = []


def use_printers(source: Callable[[], object]) -> None:
    """Name a function that imports the printers; it is called when something is first printed."""
    _SOURCES[:] = [source]


def printers() -> object:
    """The printers: an object whose attributes `system` and `formula` print these."""
    (source,) = _SOURCES
    return source()
