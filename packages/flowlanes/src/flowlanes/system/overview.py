"""Overviews of values: a heading and a short table, as text and as HTML.

A trajectory of a million samples, printed, is to fit a screen.
"""

from __future__ import annotations

import reprlib
from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, fields
from html import escape
from textwrap import TextWrapper
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

    from .arrays import FloatArray

#: Columns of a screen.
COLUMNS = 80


@dataclass(frozen=True)
class Overview:
    """A heading, and below it rows of a label and a text.

    Parameters
    ----------
    heading : str
    rows : tuple of (str, str)
        Label and text; a row without text is left out.

    Examples
    --------
    >>> print(Overview("Pendulum", (("state", "x, v"), ("notes", ""))).text())
    Pendulum
        state  x, v
    """

    heading: str
    rows: tuple[tuple[str, str], ...] = ()

    def text(self) -> str:
        """The overview as lines of at most 80 characters."""
        shown = [(label, text) for label, text in self.rows if text]
        width = max((len(label) for label, _ in shown), default=0)
        lines = TextWrapper(COLUMNS).wrap(self.heading)
        for label, text in shown:
            begin = f"    {label:<{width}}  "
            indent = " " * len(begin)
            lines += TextWrapper(COLUMNS, begin, indent, break_on_hyphens=False).wrap(text)
        return "\n".join(lines)

    def html(self) -> str:
        """The overview as a table of HTML."""
        rows = "".join(
            f'<tr><th style="text-align: left">{escape(label)}</th>'
            f'<td style="text-align: left">{escape(text)}</td></tr>'
            for label, text in self.rows
            if text
        )
        return f"<div><strong>{escape(self.heading)}</strong><table>{rows}</table></div>"


class WithOverview(ABC):
    """A value that shows its overview in place of all that it holds.

    A dataclass below it is declared with ``repr=False``.
    """

    @abstractmethod
    def overview(self) -> Overview:
        """The overview of this value."""

    def __repr__(self) -> str:
        return self.overview().text()

    def _repr_html_(self) -> str:
        return self.overview().html()


class _ShortRepr(reprlib.Repr):
    """Representations that leave out the middle of what is long, and the numbers of arrays."""

    def __init__(self) -> None:
        super().__init__()
        self.maxother = self.maxstring = 120

    def repr_ndarray(self, array: FloatArray, _: int) -> str:
        """The shape of an array."""
        return f"array{array.shape}"


_SHORT_REPR = _ShortRepr()


class WithShortRepr:
    """A dataclass that shows the shapes of its arrays, and long fields in part.

    Fields at their defaults are left out.  It is declared with ``repr=False``.
    """

    def __repr__(self: DataclassInstance) -> str:
        return f"{type(self).__name__}({', '.join(_fields(self))})"


def _fields(value: DataclassInstance) -> Iterator[str]:
    for item in fields(value):
        content = getattr(value, item.name)
        if item.repr and content is not item.default:
            yield f"{item.name}={' '.join(_SHORT_REPR.repr(content).split())}"
