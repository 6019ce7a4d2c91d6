"""The figure of the bifurcation diagram of rubber bodies of revolution."""

from __future__ import annotations

from io import BytesIO

import pytest

from chaplygin.report.figures import revolution_diagram as draw
from flowlanes.errors import InputError
from nonholonomic.closed_form.revolution.diagram import revolution_diagram
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shapes import Disk

DISK = RollingBody(Body(1.0, (0.25, 0.25, 0.5), Disk(1.0)), contact="rubber", field=Forces(9.81))


def test_figure() -> None:
    figure = draw(revolution_diagram(DISK, (0.5, 1.0, 2.0, 3.0, 3.2, 4.0)), [(12.0, 1.0)])
    (axes,) = figure.axes
    assert axes.get_ylim()[0] < 9.81 < axes.get_ylim()[1]
    written = BytesIO()
    figure.savefig(written, format="svg")
    assert len(written.getvalue()) > 10_000


def test_one_column_is_no_figure() -> None:
    with pytest.raises(InputError, match="needs two or more"):
        draw(revolution_diagram(DISK, [1.0]))
