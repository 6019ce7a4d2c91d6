"""The diagram of a given motion, whatever its system is called."""

from __future__ import annotations

import pytest

from flowlanes.errors import InputError
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.bifurcation.motion_diagram import diagram_of_motion


def problem(name, start, **parameters):
    system = from_catalogue(name, **parameters)
    return Problem(system, system.defaults, start).well_posed()


def test_veselova():
    start = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
    diagram, (h, F) = diagram_of_motion(problem("veselova", start))
    assert diagram.plane.name == "veselova"
    # 2h = (ω, Iω) with I = (1, 1.5, 2.1)
    assert 2 * h == pytest.approx(0.81 + 1.5 * 0.09 + 2.1 * 1.0816)
    assert diagram.region(h, F).tori == 2


@pytest.mark.parametrize(
    ("momentum", "name"),
    [(("0.6", "0", "0"), "chaplygin-ball"), (("1", "0.5", "2"), "chaplygin-ball-area")],
)
def test_chaplygin_ball(momentum, name):
    """With (M, γ) = 0 it has a plane of its own."""
    diagram, mark = diagram_of_motion(
        problem("chaplygin-ball", (*momentum, "0", "0.6", "0.8"), m=0.5)
    )
    assert diagram.plane.name == name
    assert diagram.region(*mark) is None or diagram.region(*mark).tori == 2
    if name == "chaplygin-ball-area":
        assert {str(s): float(v) for s, v in diagram.parameters.items()}["f"] == 5.25
        assert mark[1] == pytest.approx(1.9)


def test_a_permanent_rotation_lies_on_a_boundary():
    diagram, mark = diagram_of_motion(
        problem("chaplygin-ball", ("0.5", "0", "0", "0", "0.6", "0.8"))
    )
    (stable,) = (b for b in diagram.boundaries if b.pole == 1)
    symbols = [axis.symbol for axis in diagram.axes]
    assert stable.curve.subs(dict(zip(symbols, mark, strict=True))) == pytest.approx(0, abs=1e-15)


@pytest.mark.slow
def test_nothing_is_known():
    start = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
    assert diagram_of_motion(problem("ball-on-sphere", start)) is None


def test_equal_moments():
    start = ("0.9", "-0.3", "-1.04", "0.48", "-0.64", "0.6")
    with pytest.raises(InputError, match="three different numbers"):
        diagram_of_motion(problem("veselova", start, I_2=2.1))
