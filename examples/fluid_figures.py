"""The direction of the circulation vector in space, for three cavities of a rolling ball.

Run with::

    python examples/fluid_figures.py          # writes docs/pictures/ball_with_fluid.png

In a spherical cavity the vorticity of the fluid is fixed in space, whatever the ball does.  In an
ellipsoid the wall turns it: in a nearly spherical one it wanders slowly, in a flat one all over.
"""

from __future__ import annotations

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from scipy.spatial.transform import Rotation

from chaplygin import Study, load_experiment
from chaplygin.report.drawing.style import FAINT, INK, QUIET, STYLE

EXAMPLES = Path(__file__).parent
PICTURE = EXAMPLES.parent / "docs" / "pictures" / "ball_with_fluid.png"

CAVITIES = {
    "sphere": (0.65, 0.65, 0.65),
    "nearly a sphere": (0.67, 0.65, 0.63),
    "flat ellipsoid": (0.9, 0.7, 0.35),
}
UNTIL = 120.0


def directions(axes: tuple[float, float, float]) -> np.ndarray:
    """N/|N| in space axes along the motion, (n, 3), for a cavity with these semi-axes."""
    options = [f"body.cavity.axes={list(axes)}", f"run.until={UNTIL}", "run.samples=4801"]
    run = Study.from_experiment(
        load_experiment(EXAMPLES / "ball_with_fluid.toml", options)
    ).trajectory()
    turn = Rotation.from_quat(run.records["attitude"], scalar_first=True)
    circulation = np.array(run["N"])
    directed: np.ndarray = turn.apply(circulation / np.linalg.norm(circulation, axis=1)[:, None])
    return directed


def figure() -> Figure:
    """A sphere of directions for each cavity, seen from the side of the first direction."""
    with plt.rc_context(STYLE):
        picture, panels = plt.subplots(1, 3, figsize=(9.0, 3.6), layout="constrained")
        for panel, (name, axes) in zip(panels, CAVITIES.items(), strict=True):
            path = directions(axes)
            _draw(panel, path)
            chords = np.linalg.norm(path - path[0], axis=1)
            wandering = np.degrees(2 * np.arcsin(np.minimum(chords / 2, 1)).max())
            sizes = " × ".join(f"{b:g}" for b in axes)
            panel.set_title(f"{name}, {sizes} m")
            panel.text(0, -1.2, f"it turns by {_angle(wandering)}", ha="center", color=QUIET)
        return picture


def _angle(degrees: float) -> str:
    """The largest angle in words; what is rounding by its power of ten."""
    if degrees > 1e-6:
        return f"up to {degrees:.3g}°"
    return rf"less than $10^{{{np.ceil(np.log10(degrees)):.0f}}}$ degrees"


def _draw(panel: plt.Axes, path: np.ndarray) -> None:
    """Directions on a sphere, the first one in the middle of its visible half."""
    ahead = path[0]
    right = np.cross([0.0, 0.0, 1.0], ahead)
    right /= np.linalg.norm(right)
    up = np.cross(ahead, right)
    x, y, depth = path @ right, path @ up, path @ ahead
    panel.add_patch(plt.Circle((0, 0), 1, color=FAINT, alpha=0.5, lw=0))
    seen, hidden = np.where(depth >= 0, 1.0, np.nan), np.where(depth < 0, 1.0, np.nan)
    panel.plot(x * hidden, y * hidden, color=QUIET, lw=0.4, alpha=0.6)
    panel.plot(x * seen, y * seen, color=INK, lw=0.7)
    panel.plot(x[0], y[0], "o", color="C3", ms=5, zorder=3)
    panel.set(xlim=(-1.1, 1.1), ylim=(-1.3, 1.1), aspect="equal")
    panel.axis("off")


def main() -> None:
    """Write the picture."""
    figure().savefig(PICTURE, dpi=160)
    print(PICTURE)


if __name__ == "__main__":
    main()
