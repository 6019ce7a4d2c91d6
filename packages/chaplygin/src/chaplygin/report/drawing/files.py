"""Figures as files, and as text for web pages."""

from __future__ import annotations

import hashlib
import io
import pickle
import re
from collections.abc import Mapping
from pathlib import Path as FilePath
from xml.sax.saxutils import quoteattr

import matplotlib as mpl
from matplotlib.backend_bases import FigureCanvasBase
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.backends.backend_pdf import FigureCanvasPdf
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError

from ...experiment.files import atomic_file
from .layout import layout_done
from .modes import MODE_STYLES
from .phone_layout import make_narrow
from .style import ALARM, COMPONENTS, FAINT, INK, QUIET, SERIES, STYLE
from .svg_paths import grouped_marks, short_path, with_shared_letters, with_shared_paths
from .ticks import set_plain_ticks

FORMATS: dict[str, dict[str, None]] = {
    ".png": {"Software": None},
    ".svg": {"Date": None, "Creator": None, "Format": None, "Type": None},
    ".pdf": {"CreationDate": None, "Creator": None, "Producer": None},
}
"""File types of `save`, each with the metadata on time and program that are omitted."""

PAGE_COLOURS = {
    "ink": INK,
    "quiet": QUIET,
    "faint": FAINT,
    "alarm": ALARM,
    "paper": "#ffffff",
    **{
        f"curve-{colour[1:]}": colour
        for colour in (*COMPONENTS, *SERIES, *(style.colour for style in MODE_STYLES.values()))
        if colour not in (ALARM, INK)
    },
}
"""Colours of figures that a page can change, by the names of its style sheet."""

_COLOUR_NAMES = {colour: name for name, colour in reversed(PAGE_COLOURS.items())}

_PAGE_COLOUR = re.compile(rf"(?<=[ :\"])(?:{'|'.join(_COLOUR_NAMES)})(?=[;\"])")

_DPI = 220
"""Dots per inch of a raster picture."""

_CANVASES: dict[str, tuple[type[FigureCanvasBase], int]] = {
    ".png": (FigureCanvasAgg, _DPI),
    ".pdf": (FigureCanvasPdf, 72),
}
"""Backend of matplotlib, and dots per inch of its layout."""

_FINE, _COARSE = 0.3, 0.75
"""Tolerance in points by which a curve is simplified, and the one for a telephone."""

_PROLOG = '<?xml version="1.0" encoding="utf-8"?>\n'


@arguments_checked
def save(figure: Figure, path: str | FilePath) -> FilePath:
    """Write a figure in the format of the file name, with reproducible bytes.

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

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     path = report.figures.save(report.figures.drift(dataset), Path(folder, "drift.png"))
    ...     print(path.name, path.stat().st_size > 1000)
    drift.png True
    """
    target = FilePath(path)
    suffix = target.suffix.lower()
    if suffix not in FORMATS:
        raise InputError(
            f"{target}: a figure is written as {', '.join(FORMATS)}; the file name must end so"
        )
    with atomic_file(target) as place:
        if suffix == ".svg":
            place.write_text(svg_file(svg_text(figure)), encoding="utf-8")
        else:
            with mpl.rc_context(STYLE):
                set_plain_ticks(figure)
                with layout_done(figure, *_CANVASES[suffix]):
                    figure.savefig(place, format=suffix[1:], dpi=_DPI, metadata=FORMATS[suffix])
    return target


@arguments_checked
def svg_file(text: str) -> str:
    """The content of an SVG file, from the element that :func:`svg_text` returns.

    Parameters
    ----------
    text : str
        The element ``<svg>``.

    Returns
    -------
    str
        The text of the file.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> "<svg" in report.figures.svg_file("<svg></svg>")
    True
    """
    return f"{_PROLOG}{text}\n"


@arguments_checked
def svg_text(figure: Figure) -> str:
    """A figure as an SVG element for an HTML page.

    It has no prolog and no style sheet that would affect the rest of the page, text as shapes, and
    ids unique to this figure; the result is reproducible.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Its label becomes the description for those who cannot see it.

    Returns
    -------
    str
        The element ``<svg>``.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import matplotlib.pyplot as plt
    >>> figure = plt.figure(label="an empty figure")
    >>> svg_text(figure)[:40]
    '<svg role="img" aria-label="an empty fig'
    >>> plt.close(figure)
    """
    stream = io.StringIO()
    # Curves with thousands of turns would be large files.
    tolerance = max(_FINE, mpl.rcParams["path.simplify_threshold"])
    with mpl.rc_context(STYLE | {"path.simplify_threshold": tolerance}):
        set_plain_ticks(figure)
        with layout_done(figure):
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
    text = re.sub(r' d="([^"]*)"', lambda path: f' d="{short_path(path[1])}"', text)
    return _unique_svg_ids(grouped_marks(re.sub(r"\n\s*", "\n", text.strip())))


@arguments_checked
def page_svg(figure: Figure, narrow: bool = False) -> str:
    """A figure as SVG for a page with light and dark colours; see :func:`svg_text`.

    The colours of paper, ink and curves can be set by the style sheet, as ``--ink``, ``--paper``
    and the other names of :data:`PAGE_COLOURS`; each defaults to its own value.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        The figure, which is not changed.
    narrow : bool
        Whether it is for the screen of a telephone: charts are laid out again at its width, and
        pictures get larger letters.

    Returns
    -------
    str
        The element ``<svg>``.

    Raises
    ------
    InputError
        If an argument is of another type.
    """
    shown: Figure = pickle.loads(pickle.dumps(figure)) if narrow else figure
    if narrow:
        make_narrow(shown)
    # On a telephone no more detail of a curve is visible.
    tolerance = _COARSE if narrow else _FINE
    with mpl.rc_context({"path.simplify_threshold": tolerance}):
        for line in shown.findobj(Line2D) if narrow else ():
            line.recache(always=True)
        return _with_page_colours(svg_text(shown))


def _with_page_colours(text: str) -> str:
    return _PAGE_COLOUR.sub(lambda match: f"var(--{_COLOUR_NAMES[match[0]]}, {match[0]})", text)


@arguments_checked
def page_svgs(
    figures: Mapping[str, Figure], svgs: Mapping[str, str]
) -> tuple[dict[str, tuple[str, str]], str]:
    """Figures of one page as SVG for wide and narrow screens; see :func:`page_svg`.

    Parameters
    ----------
    figures : mapping of str to matplotlib.figure.Figure
    svgs : mapping of str to str
        The result of :func:`svg_text` for each figure.

    Returns
    -------
    dict of str to (str, str)
        By name, the SVG for wide and for narrow screens. Common parts are only in the first, which
        may be hidden but must be in the page.
    str
        The shapes of all letters, which must be in the page too.

    Raises
    ------
    InputError
        If an argument is of another type.

    Examples
    --------
    >>> import chaplygin as ch
    >>> from chaplygin import report
    >>> study = ch.Study.from_experiment(
    ...     ch.parse_experiment('system = {name = "heavy-disk"}', overrides=["run.until=0.2"])
    ... )
    >>> dataset = study.trajectory().to_dataset()
    >>> figures = {"drift": report.figures.drift(dataset)}
    >>> svgs = {name: report.figures.svg_text(figure) for name, figure in figures.items()}
    >>> pairs, letters = report.figures.page_svgs(figures, svgs)
    >>> sorted(pairs), "<svg" in letters, "<svg" in report.figures.page_svg(figures["drift"])
    (['drift'], True, True)
    """
    texts: dict[str, str] = {}
    for name, figure in figures.items():
        wide, narrow = _with_page_colours(svgs[name]), page_svg(figure, narrow=True)
        mark = f"f{hashlib.sha256(wide.encode()).hexdigest()[:10]}"
        texts[f"{name} wide"], texts[f"{name} narrow"] = with_shared_paths(wide, narrow, mark)
    texts, letters = with_shared_letters(texts)
    return {name: (texts[f"{name} wide"], texts[f"{name} narrow"]) for name in figures}, letters


def _unique_svg_ids(svg: str) -> str:
    """Drop unused ids; the others are a digest of the whole text and a number."""
    mark = "f" + hashlib.sha256(svg.encode()).hexdigest()[:10]
    used = re.findall(r'href="#([^"]+)"|url\(#([^)]+)\)', svg)
    names = list(dict.fromkeys(first or second for first, second in used))
    short = {name: f"{mark}-{number}" for number, name in enumerate(names)}

    def short_id(match: re.Match[str]) -> str:
        return f' id="{short[match[1]]}"' if match[1] in short else ""

    svg = re.sub(r' id="([^"]*)"', short_id, svg)
    return re.sub(r'(href="#|url\(#)([^")]+)', lambda link: f"{link[1]}{short[link[2]]}", svg)
