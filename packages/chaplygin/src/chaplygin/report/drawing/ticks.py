"""Numbers at the ticks of axes."""

from __future__ import annotations

from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter
from mpl_toolkits.mplot3d import Axes3D


class PlainTicks(ScalarFormatter):
    """Numbers as plain text, and a common power of ten as a formula.

    matplotlib sets both as formulas or both as text; a number looks the same either way, but is
    much slower to set as a formula.
    """

    def __init__(self) -> None:
        super().__init__(useMathText=False)

    def get_offset(self) -> str:
        """The common power of ten."""
        self.set_useMathText(True)
        try:
            return str(super().get_offset())
        finally:
            self.set_useMathText(False)


def set_plain_ticks(figure: Figure) -> None:
    """Use plain numbers on all axes of a figure that have matplotlib's default tick formatter."""
    for axes in figure.axes:
        depth = [axes.zaxis] if isinstance(axes, Axes3D) else []
        for axis in (axes.xaxis, axes.yaxis, *depth):
            if type(axis.get_major_formatter()) is ScalarFormatter:
                axis.set_major_formatter(PlainTicks())
