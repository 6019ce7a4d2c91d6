"""Overviews of values: a heading and a short table, as text and as HTML.

A trajectory of a million samples, printed, is to fit a screen.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from html import escape
from textwrap import TextWrapper

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
    >>> print(Overview("Chaplygin ball", (("state", "M, gamma"), ("notes", ""))).text())
    Chaplygin ball
        state  M, gamma
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
            lines += TextWrapper(COLUMNS, begin, indent).wrap(text)
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
