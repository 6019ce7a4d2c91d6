"""Registered printers of systems and formulas.

Printers import the printed classes, so these cannot import the printers and look them up here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

_SOURCES: list[Callable[[], object]] = []
_LETTERS: list[Callable[[], object]] = []


def use_printers(source: Callable[[], object]) -> None:
    """Register a function that imports the printers.

    The function is called when something is first printed.
    """
    _SOURCES[:] = [source]


def printers() -> object:
    """Printers: an object with the attributes `system` and `formula`."""
    (source,) = _SOURCES
    return source()


def use_letters(source: Callable[[], object]) -> None:
    """Register a function that imports letters of quantities whose names are words.

    A package with such names calls this once, when it is imported; the function returns a
    :class:`~flowlanes.printing.symbol_names.WordLetters`, and is called when something is printed.
    """
    _LETTERS.append(source)


def letters() -> Iterator[object]:
    """The letters that packages have registered."""
    return (source() for source in _LETTERS)
