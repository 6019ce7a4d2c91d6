"""Figures as files, and as text for web pages."""

from __future__ import annotations

import hashlib
import io
import re
from pathlib import Path as FilePath
from xml.sax.saxutils import quoteattr

import matplotlib as mpl
from matplotlib.figure import Figure

from ...errors import InputError
from ..files import completed
from .style import STYLE

FORMATS: dict[str, dict[str, None]] = {
    ".png": {"Software": None},
    ".svg": {"Date": None, "Creator": None, "Format": None, "Type": None},
    ".pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""Kinds of file `save` writes, each with the notes on time and program it leaves out."""

_PROLOG = '<?xml version="1.0" encoding="utf-8"?>\n'


def save(figure: Figure, path: str | FilePath) -> FilePath:
    """Write a figure to a file, in the format its name ends with; the same bits every time.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
    path : str or Path
        Name ending in .png, .svg or .pdf.

    Returns
    -------
    pathlib.Path
        The file.

    Raises
    ------
    InputError
        If the ending is another one, or the file cannot be written.
    """
    target = FilePath(path)
    suffix = target.suffix.lower()
    if suffix not in FORMATS:
        raise InputError(
            f"{target}: a figure is written as {', '.join(FORMATS)}; the file name must end so"
        )
    with completed(target) as place:
        if suffix == ".svg":
            place.write_text(f"{_PROLOG}{svg_text(figure)}\n", encoding="utf-8")
        else:
            with mpl.rc_context(STYLE):
                figure.savefig(place, format=suffix[1:], dpi=220, metadata=FORMATS[suffix])
    return target


def svg_text(figure: Figure) -> str:
    """A figure as an SVG element to be put into an HTML page.

    No prolog, no style sheet that would reach the rest of the page, text as shapes, and ids that
    belong to this figure alone; the same text every time.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Its label becomes the description for those who cannot see it.
    """
    stream = io.StringIO()
    with mpl.rc_context(STYLE):
        figure.savefig(stream, format="svg", metadata=FORMATS[".svg"])
    text = stream.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>|<!--.*?-->", "", text, flags=re.S)
    description = str(figure.get_label())
    text = text.replace(
        "<svg ",
        f'<svg role="img" aria-label={quoteattr(description)} '
        'style="stroke-linejoin: round; stroke-linecap: butt" ',
        1,
    )
    text = re.sub(r' d="[^"]*"', _rounded, text)
    return _own_ids(re.sub(r"\n\s*", "\n", text.strip()))


def _rounded(path: re.Match[str]) -> str:
    """Coordinates of a path to a hundredth of a point, finer than any paper."""
    return re.sub(
        r"-?\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}", path[0].replace("\n", "")
    )


def _own_ids(svg: str) -> str:
    """Drop ids nothing refers to, and prefix the others with a mark of the whole text."""
    mark = "f" + hashlib.sha256(svg.encode()).hexdigest()[:10]
    used = set(re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', svg))
    names = {first or second for first, second in used}

    def renamed(found: re.Match[str]) -> str:
        return f' id="{mark}-{found[1]}"' if found[1] in names else ""

    svg = re.sub(r' id="([^"]*)"', renamed, svg)
    return re.sub(r'(href="#|url\(#)', rf"\1{mark}-", svg)
