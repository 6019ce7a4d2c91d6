"""Recorded quantities that double precision cannot hold are told, and told from undefined ones."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
import sympy as sp

from flowlanes.flow.integrator import integrate
from flowlanes.flow.trajectory import NO_VALUE, TOO_LARGE
from flowlanes.formulas.array_evaluation import overflows
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


def test_overflow_is_told_with_its_first_moment(growing):
    assert not np.isfinite(growing.records["law_difference"][-1])
    assert set(growing.overflows) == {"square", "law_difference"}
    # ln(1.8e308 / 1e300) / 2 = 9.55; the samples are 3 s apart
    assert growing.overflows["square"].tolist() == [t > 9.55 for t in growing.times]
    assert growing.warnings == (
        "square is recorded as inf or nan at 7 of 11 samples, first at t = 12: a number in its "
        "formula is larger than 1.8e308, the largest in double precision",
        "difference is recorded as inf or nan at 7 of 11 samples, first at t = 12: a number in "
        "its formula is larger than 1.8e308, the largest in double precision",
    )
    assert growing.to_dataset().attrs["warnings"] == "\n".join(growing.warnings)
    assert TOO_LARGE in str(growing.overview())


def test_a_quotient_at_rest_is_undefined_and_no_overflow():
    at_rest = System("rest", "Rest", {x: 0 * x, v: 0 * v}, laws=(Integral("ratio", v / x, "r"),))
    motion = integrate(at_rest, [0.0, 0.0], [0.0, 1.0])
    assert np.isnan(motion.records["law_ratio"]).all()
    assert motion.warnings == ()
    assert NO_VALUE in str(motion.overview())


@pytest.mark.parametrize(
    ("formula", "state", "too_large"),
    [
        (x**2, (1e200, 0.0), True),
        (sp.exp(x), (1e3, 0.0), True),
        (sp.exp(-x), (1e3, 0.0), False),
        (1 / x, (1e-310, 0.0), True),
        (1 / x, (0.0, 0.0), False),
        (sp.log(x), (0.0, 0.0), False),
        (v / x, (0.0, 0.0), False),
        (x**2 - v**2, (1e200, 1e200), True),
        (x + v, (1e308, 1e308), True),
        (x + v, (1e200, 1e200), False),
    ],
)
def test_overflow_is_neither_a_pole_nor_undefined(formula, state, too_large):
    system = System("plane", "Plane", {x: v, v: -x})
    assert overflows(system, [formula], [state]).tolist() == [too_large]
