"""Numbers at the ticks of axes: text for the numbers, a formula for their power of ten."""

from __future__ import annotations

import matplotlib as mpl
from matplotlib.figure import Figure
from matplotlib.ticker import NullFormatter, ScalarFormatter

from chaplygin.report.drawing.style import STYLE
from chaplygin.report.drawing.ticks import PlainTicks, set_plain_ticks


def test_numbers_are_text_and_their_power_of_ten_is_a_formula() -> None:
    with mpl.rc_context(STYLE):
        figure = Figure()
        axes = figure.subplots()
        axes.plot([0, 1], [0, -1e-15])
        figure.draw_without_rendering()
        before = [label.get_text() for label in axes.get_yticklabels()]
        assert any("mathdefault" in text for text in before)
        set_plain_ticks(figure)
        figure.draw_without_rendering()
        after = [label.get_text() for label in axes.get_yticklabels()]
        assert after == [text.removeprefix(r"$\mathdefault{").removesuffix("}$") for text in before]
        assert r"\mathdefault{10^{−15}}" in axes.yaxis.get_major_formatter().get_offset()


def test_other_numbers_stay_as_they_are() -> None:
    figure = Figure()
    axes = figure.add_subplot(projection="3d")
    axes.yaxis.set_major_formatter(NullFormatter())
    set_plain_ticks(figure)
    kinds = [type(axis.get_major_formatter()) for axis in (axes.xaxis, axes.yaxis, axes.zaxis)]
    assert kinds == [PlainTicks, NullFormatter, PlainTicks]
    assert issubclass(PlainTicks, ScalarFormatter)
