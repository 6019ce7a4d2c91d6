"""The style of all figures: colours, fonts, lines."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.colors import LinearSegmentedColormap, to_rgb

if TYPE_CHECKING:
    from matplotlib.typing import RcKeyType

INK = "#1f2730"
QUIET = "#7b8792"
FAINT = "#ccd3da"
LINES = "#a9b6c2"
ALARM = "#bb5566"


# Paul Tol's high-contrast colours: distinguishable with any colour vision, and in grey print.
COMPONENTS = ("#004488", "#bb5566", "#d9a521")


# Paul Tol's muted colours, darkest and most different first.
SERIES = ("#332288", "#cc6677", "#117733", "#ddaa33", "#88ccee", "#aa4499", "#999933", "#44aa99")
TIME_COLOURS = LinearSegmentedColormap.from_list(
    "chaplygin-time", ["#f6c667", "#ec8f4d", "#cf4f5b", "#8a2a75", "#3b1a68"]
)
BODY_TONES = np.array([to_rgb("#f4f1ea"), to_rgb("#5b86ad")])
SHELL_TONES = np.array([to_rgb("#f0ece2"), to_rgb("#a9bfd3")])
GROUND_LIGHT = np.array(to_rgb("#f4f7fa"))
GROUND_DARK = np.array(to_rgb("#b3bfcb"))
STYLE: dict[RcKeyType, Any] = {
    "font.family": "STIXGeneral",
    "font.size": 9.5,
    "mathtext.fontset": "stix",
    "text.color": INK,
    "axes.edgecolor": QUIET,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.6,
    "axes.labelsize": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.formatter.useoffset": False,
    "axes.formatter.use_mathtext": True,
    "axes.unicode_minus": True,
    "xtick.color": QUIET,
    "ytick.color": QUIET,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 9,
    "ytick.labelsize": 9,
    "xtick.direction": "out",
    "ytick.direction": "out",
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "xtick.major.size": 3,
    "ytick.major.size": 3,
    "lines.linewidth": 1.1,
    "lines.markersize": 3,
    "lines.solid_capstyle": "round",
    "lines.solid_joinstyle": "round",
    "legend.frameon": False,
    "legend.fontsize": 9.5,
    "legend.handlelength": 1.8,
    "legend.columnspacing": 1.8,
    "legend.handletextpad": 0.6,
    "legend.borderaxespad": 0.0,
    "figure.facecolor": "white",
    "axes.facecolor": "white",
    "savefig.facecolor": "white",
    "svg.fonttype": "path",
    "svg.hashsalt": "chaplygin",
    "pdf.fonttype": 42,
}
"""The style of all figures, applied while they are drawn and written."""
WIDTH = 6.3
"""Width of a figure in inches: the text of an A4 page."""
