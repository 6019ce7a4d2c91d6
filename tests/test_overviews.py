"""What results show of themselves, printed and in a notebook."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from html.parser import HTMLParser
from typing import Any

import numpy as np
import pytest

import chaplygin as ch
import flowlanes
import nonholonomic
from flowlanes.flow.ensembles.run import ensemble_task
from flowlanes.system.overview import Overview
from nonholonomic.closed_form import bifurcation_diagram

#: Lines and columns of a screen.
LINES, COLUMNS = 50, 80


@cache
def ball() -> tuple[ch.System, tuple[Any, ...]]:
    system = ch.from_catalogue("chaplygin-ball")
    return system, ch.initial_state(system, (1.0, 0.2, 0.1), (0.0, 0.6, 0.8))


def rolling() -> ch.RollingBody:
    return ch.RollingBody(
        ch.Body(1.0, (1.0, 2.0, 2.5), ch.Ball(1.0)), ch.Plane(), "marble", ch.Forces()
    )


SHOWN: Mapping[str, tuple[Callable[[], Any], str]] = {
    "system": (lambda: ball()[0], "<System chaplygin-ball: M, gamma; 5 parameters, 9 laws>"),
    "trajectory": (
        lambda: ch.integrate(*ball(), np.linspace(0.0, 1.0, 1001)),
        "Chaplygin ball: t = 0 to 1, 1,001 samples",
    ),
    "solution": (lambda: ch.solve(*ball()), "Chaplygin ball: two-frequency motion on a torus"),
    "closed form": (
        lambda: ch.solve(*ball()).form,
        "Chaplygin ball: two-frequency motion on a torus",
    ),
    "states": (
        lambda: ch.solve(*ball())(np.linspace(0.0, 1.0, 1001)),
        "Chaplygin ball: 1,001 times",
    ),
    "bracket": (
        lambda: next(law for law in ball()[0].laws if law.name == "bracket"),
        "PoissonStructure(name='bracket', source=",
    ),
    "catalogue": (lambda: nonholonomic.CATALOGUE, f"{len(nonholonomic.CATALOGUE)} systems"),
    "bifurcation diagram": (
        lambda: bifurcation_diagram("veselova"),
        "Bifurcation diagram of veselova in the plane of h and F",
    ),
    "task": (
        lambda: ensemble_task(ball()[0], [ball()[1][:6]] * 50, np.linspace(0.0, 1.0, 1001)),
        "Task(work=EnsembleWork(",
    ),
    "motions of a batch": (
        lambda: flowlanes.batch_integrator(ball()[0]).propagate([ball()[1][:6]] * 50, [1.0, 2.0]),
        "BatchTrajectories(states=array(50, 2, 6), deviations=None, outcome=array(50,), "
        "end_times=array(50,), steps=array(50,))",
    ),
    "spectrum": (
        lambda: ch.lyapunov_spectrum(*ball(), t_end=50.0),
        "Lyapunov exponents of Chaplygin ball, t = 10 to 50",
    ),
    "verdict": (lambda: ch.prove(ball()[0], ball()[0].integrals[0]), "energy: proven"),
    "classification": (
        lambda: ch.classify(ball()[0]),
        "Chaplygin ball: place in the hierarchy of dynamics",
    ),
    "study": (
        lambda: ch.Study.from_experiment(ch.parse_experiment('system = {name = "veselova"}')),
        "Veselova system",
    ),
    "nonholonomy": (
        lambda: nonholonomic.nonholonomy(nonholonomic.rolling_mechanism(rolling())),
        "3 constraints on 6 velocities leave 3; ",
    ),
    "batch integrator": (
        lambda: flowlanes.batch_integrator(ball()[0]),
        "BatchIntegrator(system=<System chaplygin-ball: M, gamma; 5 parameters, 9 laws>, "
        "tolerance=1e-13, deviations=0, section=None, backward=False, precision='double')",
    ),
}


@pytest.mark.parametrize("name", SHOWN)
def test_a_result_fits_a_screen(name: str) -> None:
    make, first = SHOWN[name]
    value = make()
    lines = repr(value).splitlines()
    assert lines[0].startswith(first)
    assert len(lines) <= LINES
    assert all(len(line) <= COLUMNS for line in lines[1:])
    if hasattr(value, "overview"):
        assert first in value._repr_html_()


def test_integrals_drift_by_what_was_recorded() -> None:
    motion = ch.integrate(*ball(), np.linspace(0.0, 1.0, 11))
    energy = motion.records["law_energy"]
    assert f"drift of energy    {np.max(np.abs(energy - energy[0])):.1e}" in repr(motion)


class Cells(HTMLParser):
    """The texts of a page."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.feed(page)

    def handle_data(self, data: str) -> None:
        self.texts.append(data)


def test_marks_of_html_in_texts_are_shown_as_they_stand() -> None:
    overview = Overview("a < b", (("x & y", "<script>"), ("nothing", "")))
    assert Cells(overview.html()).texts == ["a < b", "x & y", "<script>"]
    assert overview.text() == "a < b\n    x & y  <script>"
