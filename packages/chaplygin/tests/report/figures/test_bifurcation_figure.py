"""The figure of a bifurcation diagram: it shows what the diagram says and cuts nothing off."""

from __future__ import annotations

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import to_hex
from matplotlib.text import Text

from chaplygin.report.drawing.style import COMPONENTS
from chaplygin.report.figures import save
from chaplygin.report.figures.bifurcation import draw_bifurcation_diagram
from flowlanes.errors import InputError
from nonholonomic.closed_form.bifurcation import bifurcation_diagram
from nonholonomic.closed_form.bifurcation.layout import window

NAMES = ("veselova", "neumann", "chaplygin-ball-area", "chaplygin-ball-fedorov")
#: A motion in a region of tori.
MOTIONS = {
    "veselova": (0.4, 1.1),
    "neumann": (1.1, -0.1),
    "chaplygin-ball-area": (0.3, 0.7),
    "chaplygin-ball-fedorov": (-0.2, 2.0),
}


@pytest.fixture(scope="module")
def diagrams():
    return {name: bifurcation_diagram(name) for name in NAMES}


def texts(figure):
    found = [text for text in figure.findobj(Text) if text.get_text() and text.get_visible()]
    return {text.get_text(): text for text in found}


@pytest.mark.parametrize("name", NAMES)
def test_regions_and_boundaries_are_named(diagrams, name):
    diagram = diagrams[name]
    shown = texts(draw_bifurcation_diagram(diagram))
    for region in diagram.regions:
        if region.tori:
            assert f"{region.number}: {region.tori} tori" in shown
    assert "no motion" in shown
    key = [text for text in shown if ", stable" in text or ", unstable" in text]
    assert len(key) == len({(b.words, b.circles, b.stable) for b in diagram.boundaries})


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_nothing_is_cut_off_or_written_over(diagrams, name):
    figure = draw_bifurcation_diagram(diagrams[name], MOTIONS[name])
    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    drawn = figure.get_tightbbox(renderer)
    assert drawn.x0 >= 0
    assert drawn.y0 >= 0
    assert drawn.x1 <= figure.get_figwidth()
    assert drawn.y1 <= figure.get_figheight()
    ticks = {*figure.axes[0].get_xticklabels(), *figure.axes[0].get_yticklabels()}
    written = [text for text in texts(figure).values() if text not in ticks]
    boxes = [Text.get_window_extent(text, renderer) for text in written]
    crossings = [
        (a, b) for n, a in enumerate(boxes) for b in boxes[:n] if a.shrunk(0.9, 0.9).overlaps(b)
    ]
    assert not crossings


@pytest.mark.parametrize("name", NAMES)
def test_labels_stand_in_their_regions(diagrams, name):
    diagram = diagrams[name]
    frame = window(diagram, None)
    for region in diagram.regions:
        text = texts(draw_bifurcation_diagram(diagram)).get(f"{region.number}: {region.tori} tori")
        if text is None:
            continue
        # the tip of a leader where there is one
        x, y = text.xy if hasattr(text, "xy") else text.get_position()
        height = y + float(frame.slope) * x + float(frame.offset)
        assert diagram.region(x, height) is region


@pytest.mark.parametrize("name", NAMES)
def test_boundaries_lie_on_their_curves(diagrams, name):
    diagram = diagrams[name]
    frame = window(diagram, None)
    (axes,) = draw_bifurcation_diagram(diagram).axes
    symbols = [axis.symbol for axis in diagram.axes]
    lines = [line for line in axes.lines if len(line.get_xdata()) > 2]
    assert {to_hex(line.get_color()) for line in lines} >= set(COMPONENTS)
    for line in lines:
        xs, ys = (np.asarray(data)[::7] for data in line.get_data())
        heights = ys + float(frame.slope) * xs + float(frame.offset)
        off = [
            max(abs(float(b.curve.subs(dict(zip(symbols, at, strict=True))))) for at in points)
            for b in diagram.boundaries
            for points in [list(zip(xs, heights, strict=True))]
        ]
        assert min(off) < 1e-6


def test_the_given_motion_is_marked(diagrams):
    diagram = diagrams["neumann"]
    mark = MOTIONS["neumann"]
    figure = draw_bifurcation_diagram(diagram, mark)
    assert "the given motion" in texts(figure)
    (star,) = (line for line in figure.axes[0].lines if line.get_marker() == "*")
    assert tuple(star.get_xydata()[0]) == window(diagram, mark).drawn_position(mark)
    assert "the given motion" not in texts(draw_bifurcation_diagram(diagram))


@pytest.mark.parametrize("mark", [(0.5, -4.0), (9.0, 9.0)])
def test_the_window_holds_every_mark(diagrams, mark):
    frame = window(diagrams["veselova"], mark)
    assert frame.across[0] < mark[0] < frame.across[1]
    assert frame.upward[0] < mark[1] < frame.upward[1]


def test_a_mark_that_is_no_point_is_refused(diagrams):
    with pytest.raises(InputError, match="pair of finite numbers"):
        draw_bifurcation_diagram(diagrams["veselova"], (np.nan, 1.0))


def test_written_twice_it_is_the_same(diagrams, tmp_path):
    first, second = (
        save(
            draw_bifurcation_diagram(diagrams["veselova"], (0.4, 1.1)), tmp_path / name
        ).read_bytes()
        for name in ("first.png", "second.png")
    )
    assert first == second
