"""What a report says of quantities that double precision cannot hold."""

from __future__ import annotations

import json
import warnings

import numpy as np
import pytest
import sympy as sp

from chaplygin.report.figures.integral_drift import drift as drift_figure
from chaplygin.report.summary import summary, summary_text
from flowlanes.flow.integrator import integrate
from flowlanes.flow.trajectory import NO_VALUE, TOO_LARGE
from flowlanes.system.laws import Integral
from flowlanes.system.system import Observable, System

x, v = sp.symbols("x v", real=True)


@pytest.fixture(scope="module")
def growing():
    """x = v = 10¹⁵⁰ eᵗ: their squares leave double precision at t = 9.55."""
    system = System(
        "growing",
        "Growing",
        {x: x, v: v},
        observables=(Observable("square", x**2, "square"), Observable("size", x, "size")),
        laws=(Integral("difference", x**2 - v**2, "difference"), Integral("ratio", v / x, "ratio")),
    )
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        yield integrate(system, [1e150, 1e150], np.linspace(0.0, 30.0, 11))


def test_overflow_has_no_drift(growing):
    facts = summary(growing)
    assert facts["drift"]["difference"] is None
    assert facts["drift"]["ratio"] < 1e-14
    assert facts["warnings"] == list(growing.warnings)
    assert json.loads(json.dumps(facts, allow_nan=False)) == facts
    text = summary_text(growing.system, growing, facts)
    assert f"difference: {TOO_LARGE}" in text
    assert f"warning: {growing.warnings[1]}" in text


def test_the_figure_of_the_drift_leaves_overflow_out(growing):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        figure = drift_figure(growing.to_dataset())
    lines = {line.get_label(): line.get_ydata() for line in figure.axes[0].get_lines()}
    assert np.isfinite(lines["difference"]).tolist() == [True] * 4 + [False] * 7


def test_a_quotient_at_rest_has_no_drift():
    at_rest = System("rest", "Rest", {x: 0 * x, v: 0 * v}, laws=(Integral("ratio", v / x, "r"),))
    motion = integrate(at_rest, [0.0, 0.0], [0.0, 1.0])
    assert summary(motion)["drift"]["ratio"] is None
    assert NO_VALUE in summary_text(at_rest, motion, summary(motion))
