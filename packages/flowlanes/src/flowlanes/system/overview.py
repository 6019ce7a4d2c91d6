"""Overviews of values: a heading and a short table, as text and as HTML.

The printed form of a trajectory of a million samples must fit on a screen.
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

#: Maximum line length.
COLUMNS = 80


@dataclass(frozen=True)
class Overview:
    """A heading with rows of a label and a text.

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
        """The overview as an HTML table."""
        rows = "".join(
            f'<tr><th style="text-align: left">{escape(label)}</th>'
            f'<td style="text-align: left">{escape(text)}</td></tr>'
            for label, text in self.rows
            if text
        )
        return f"<div><strong>{escape(self.heading)}</strong><table>{rows}</table></div>"


class WithOverview(ABC):
    """Mixin: a value is displayed by its overview.

    Dataclasses that derive from it are declared with ``repr=False``.
    """

    @abstractmethod
    def overview(self) -> Overview:
        """The overview of this value."""

    def __repr__(self) -> str:
        return self.overview().text()

    def _repr_html_(self) -> str:
        return self.overview().html()


class _ShortRepr(reprlib.Repr):
    """Representations without the middle of long values and the entries of arrays."""

    def __init__(self) -> None:
        super().__init__()
        self.maxother = self.maxstring = 120

    def repr_ndarray(self, array: FloatArray, _: int) -> str:
        """The shape of an array."""
        return f"array{array.shape}"


_SHORT_REPR = _ShortRepr()


class WithShortRepr:
    """Mixin: a dataclass is displayed with array shapes and abbreviated fields.

    Fields with default values are omitted. Such dataclasses are declared with ``repr=False``.
    """

    def __repr__(self: DataclassInstance) -> str:
        return f"{type(self).__name__}({', '.join(_fields(self))})"


def _fields(value: DataclassInstance) -> Iterator[str]:
    for item in fields(value):
        content = getattr(value, item.name)
        if item.repr and content is not item.default:
            yield f"{item.name}={' '.join(_SHORT_REPR.repr(content).split())}"
