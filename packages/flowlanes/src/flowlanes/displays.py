"""The printers of systems and formulas, registered by the package.

Printed objects do not import their printers, which import them; they look them up here.
"""

from __future__ import annotations

from collections.abc import Callable

_SOURCES: list[Callable[[], object]] = []


def use_printers(source: Callable[[], object]) -> None:
    """Register a function that imports the printers.

    It is called when something is first printed.
    """
    _SOURCES[:] = [source]


def printers() -> object:
    """The printers: an object whose attributes `system` and `formula` print these."""
    (source,) = _SOURCES
    return source()
