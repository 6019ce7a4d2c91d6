"""A planted integration method is used by its name, everywhere."""

import numpy as np
import pytest

import chaplygin as ch
from flowlanes.errors import InputError
from flowlanes.flow import methods
from planted_kinds.midpoint_method import ImplicitMidpoint

START = {"omega": (1.0, 0.0, 2.0), "gamma": (0.0, 0.0, 1.0)}
TIMES = np.linspace(0.0, 1.0, 6)


@pytest.fixture(autouse=True)
def _planted(monkeypatch):
    monkeypatch.setattr(methods, "_METHODS", dict(methods.methods()))
    methods.register(ImplicitMidpoint())


def test_it_integrates_and_keeps_what_is_quadratic():
    ball = ch.from_catalogue("chaplygin-ball")
    there = ch.integrate(ball, START, TIMES)
    here = ch.integrate(ball, START, TIMES, method="midpoint")
    assert np.allclose(here["gamma"], there["gamma"], atol=1e-4)
    length = (here["gamma"] ** 2).sum(axis=1)
    assert np.abs(length - 1.0).max() < 1e-13


def test_its_dataset_says_how_it_was_computed():
    ball = ch.from_catalogue("chaplygin-ball")
    dataset = ch.integrate(ball, START, TIMES, method="midpoint").to_dataset()
    assert dataset.attrs["integrator"].startswith("implicit midpoint rule")
    assert "320 steps" in dataset.attrs["integrator"]


def test_options_that_it_does_not_have_are_refused():
    ball = ch.from_catalogue("chaplygin-ball")
    with pytest.raises(InputError, match="tolerance: method 'midpoint' has none; use method"):
        ch.integrate(ball, START, TIMES, method="midpoint", tolerance=1e-9)


def test_an_unknown_method_is_refused_with_all_that_there_are():
    ball = ch.from_catalogue("chaplygin-ball")
    with pytest.raises(InputError, match="'taylor' or 'gauss' or 'midpoint'"):
        ch.integrate(ball, START, TIMES, method="euler")


def test_an_experiment_file_asks_for_it():
    text = """
system.name = "chaplygin-ball"
start.omega = [1.0, 0.0, 2.0]
start.gamma = [0.0, 0.0, 1.0]
run.until = 1.0
run.samples = 6
run.method = "midpoint"
"""
    motion = ch.Study.from_experiment(ch.parse_experiment(text)).trajectory()
    assert motion.statistics.method == "implicit midpoint rule"
