"""What prints systems and formulas, registered by the packages that bring it.

Printed objects do not import their printers, which import them; they look them up here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

_SOURCES: list[Callable[[], object]] = []
_LETTERS: list[Callable[[], object]] = []


def use_printers(source: Callable[[], object]) -> None:
    """Register a function that imports the printers.

    It is called when something is first printed.
    """
    _SOURCES[:] = [source]


def printers() -> object:
    """The printers: an object whose attributes `system` and `formula` print these."""
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
