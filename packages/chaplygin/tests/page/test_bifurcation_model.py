"""Bifurcation diagrams of pages, against the polynomials of their boundaries."""

from __future__ import annotations

import numpy as np
import sympy as sp

import chaplygin as ch
from chaplygin.experiment.closed_form import diagram_if_known
from chaplygin.page.bifurcation_model import bifurcation_model
from chaplygin.page.page_systems import reduced_system


def test_curves_are_the_boundaries_in_values_of_the_integrals():
    study = ch.Study.from_experiment(ch.parse_experiment('system = {name = "neumann"}'))
    model = bifurcation_model(study, reduced_system(study))
    names = [law.name for law in study.system.integrals]
    assert model["x"] in names and model["y"] in names and model["x"] != model["y"]
    diagram, _ = diagram_if_known(study)
    symbols = [axis.symbol for axis in diagram.axes]
    values = {s: sp.Rational(v) for s, v in diagram.parameters.items()}
    curves = [sp.lambdify(symbols, b.curve.subs(values)) for b in diagram.boundaries]
    assert model["curves"]
    for curve in model["curves"]:
        x, y = np.array(curve["x"]), np.array(curve["y"])
        misses = [np.abs(f(x, y)).max() / (1 + np.abs(x).max() + np.abs(y).max()) for f in curves]
        assert min(misses) < 1e-6


def test_a_system_without_a_diagram_has_none():
    study = ch.Study.from_experiment(ch.parse_experiment('system = {name = "rattleback"}'))
    assert bifurcation_model(study, reduced_system(study)) is None
