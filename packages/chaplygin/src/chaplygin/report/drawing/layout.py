"""The positions of the axes of a figure, computed without drawing it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import matplotlib as mpl
from matplotlib.backend_bases import FigureCanvasBase
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

from .style import STYLE
from .ticks import set_plain_ticks

Canvas = type[FigureCanvasBase]


def lay_out(figure: Figure, canvas: Canvas = FigureCanvasSVG, dpi: float = 72) -> None:
    """Place the axes of a figure as its layout engine would on a canvas."""
    engine = figure.get_layout_engine()
    if engine is None:
        return
    own_canvas, own_dpi = figure.canvas, figure.dpi
    canvas(figure)
    figure.dpi = dpi
    try:
        with mpl.rc_context(STYLE):
            set_plain_ticks(figure)
            engine.execute(figure)
    finally:
        figure.dpi = own_dpi
        figure.set_canvas(own_canvas)


@contextmanager
def layout_done(
    figure: Figure, canvas: Canvas = FigureCanvasSVG, dpi: float = 72
) -> Iterator[None]:
    """Compute the layout once for all files written inside.

    Otherwise `savefig` draws a figure twice.
    """
    lay_out(figure, canvas, dpi)
    engine = figure.get_layout_engine()
    with mpl.rc_context({"figure.autolayout": False, "figure.constrained_layout.use": False}):
        figure.set_layout_engine(None)
    try:
        yield
    finally:
        figure.set_layout_engine(engine)
