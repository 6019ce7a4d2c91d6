"""The Chaplygin ball at any area constant: Chaplygin's reduction and its way back."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import mpmath
import pytest
import sympy as sp

from closed_form.along import at, follows, located, slips, states
from closed_form.separations.chaplygin_reduction import chart, chart_at_level
from flowlanes.system.laws import Identity
from flowlanes.system.vectors import to_components
from lawproof.proof.prover import prove
from nonholonomic.closed_form.genus_two.separation import nuprime
from nonholonomic.closed_form.separations.chaplygin_ball import chaplygin_ball
from nonholonomic.closed_form.separations.chaplygin_ball_area_constant import (
    EVEN,
    M,
    chaplygin_area,
    gamma,
)

SEPARABLE = chaplygin_area()
ON_CHART = ("energy", "square", "momentum", "levels", "time")
AT_LEVEL = ("constants", "normal", "state", "curve", "time_rescaling")
SLIPS = ("leading", "root", "weight", "speed", "time_rescaling", "state", "fixed")
the_chart, the_level = cache(chart), cache(chart_at_level)


@cache
def planted():
    """The laws with slips, by their names."""
    return dict(slips(replace(SEPARABLE, fixed=(M, gamma))))


def named(system, name):
    """A law of a system."""
    (law,) = (law for law in system.laws if law.name == name)
    return law


PARAMETERS = {"m": "1.3", "I_1": "2.1", "I_2": "1", "I_3": "1.5", "R": "0.7"}
#: M and γ with an area constant of either sign, small, and near the largest one.
STARTS = {
    "positive": ("0.8", "-0.6", "1.28", "0.48", "-0.64", "0.6"),
    "negative": ("-0.8", "0.6", "-2.28", "0.48", "-0.64", "0.6"),
    "small": ("0.8", "-0.6", "-1.2799", "0.48", "-0.64", "0.6"),
    "large": ("0.96", "-1.28", "1.25", "0.48", "-0.64", "0.6"),
}


@pytest.mark.parametrize("law", SEPARABLE.laws, ids=lambda law: law.name)
def test_proven_of_the_ball(law):
    assert prove(SEPARABLE.system, law).decision == "proven"


def test_nothing_else_is_stated():
    assert tuple(law.name for law in the_chart().laws) == ON_CHART
    assert tuple(law.name for law in the_level().laws) == AT_LEVEL
    assert tuple(planted()) == SLIPS


@pytest.mark.parametrize("name", ON_CHART)
def test_proven_on_the_chart(name):
    assert prove(the_chart(), name).decision == "proven"


@pytest.mark.parametrize("name", AT_LEVEL)
def test_proven_at_a_level(name):
    assert prove(the_level(), name).decision == "proven"


@pytest.mark.parametrize("name", ON_CHART[2:])
def test_a_slip_on_the_chart_is_refuted(name):
    law = named(the_chart(), name)
    (symbol,) = the_chart().laws[0].value.free_symbols
    values = list(sp.flatten([to_components(sp.sympify(law.value))]))
    wrong = Identity(law.name, (*values[:-1], values[-1] + symbol))
    assert prove(the_chart(), wrong).decision == "refuted"


@pytest.mark.parametrize("name", AT_LEVEL)
def test_a_slip_at_a_level_is_refuted(name):
    law = named(the_level(), name)
    (place,) = (i for i, (name, _) in enumerate(law.quantities) if str(name) == "sigma")
    symbol, value = law.quantities[place]
    quantities = (*law.quantities[:place], (symbol, 2 * value), *law.quantities[place + 1 :])
    wrong = Identity(law.name, law.value, quantities=quantities)
    assert prove(the_level(), wrong).decision == "refuted"


@pytest.mark.parametrize("slip", SLIPS)
def test_a_slip_is_refuted(slip):
    assert prove(SEPARABLE.system, planted()[slip]).decision == "refuted"


def test_both_forms_are_diagonal():
    """(M′, γ′) = 0, |γ′| = 1, and diag(2h, 1/D) becomes diag(2h′, 1/D′), for every σ."""
    h, g, sigma, D = sp.symbols("h g sigma D", positive=True)
    # σ² − (f − 2hD)σ − 2hDg² = 0, solved for f
    f = sigma + 2 * h * D - 2 * h * D * g**2 / sigma
    beta = -g / sigma
    e = 1 + 2 * h * D * beta**2
    square = (1 - g**2 / sigma) * e
    turn = sp.Matrix([[1, beta], [-2 * h * D * beta, 1]]) * sp.diag(1, 1 / sp.sqrt(square))
    gram = turn.T * sp.Matrix([[f, g], [g, 1]]) * turn
    form = turn.T * sp.diag(2 * h, 1 / D) * turn
    assert gram[1, 1].cancel() == 1
    assert sp.simplify(gram[0, 1]) == sp.simplify(form[0, 1]) == 0
    assert sp.cancel(gram[0, 0] - 2 * e * h * (D + sigma / (2 * h))) == 0
    assert sp.cancel(form[0, 0] - 2 * e * h) == 0
    assert sp.cancel(1 / form[1, 1] - D + D * g**2 / sigma) == 0


@pytest.mark.parametrize("name", STARTS)
def test_along_a_motion(name):
    follows(SEPARABLE, STARTS[name], PARAMETERS, 1e-25)


def test_even_part_of_the_clock():
    (values, *_) = states(SEPARABLE.system, STARTS["positive"], PARAMETERS)
    with mpmath.workdps(34):
        known = located(SEPARABLE, values)
        back = known | {s: -known[s] for s in nuprime.symbols}
        mean = (at(SEPARABLE.time_rescaling, known) + at(SEPARABLE.time_rescaling, back)) / 2
        assert abs(mean - at(EVEN, known)) < 1e-30


def test_zero_area_constant_is_the_special_case():
    start = ("0.8", "-0.6", "-1.28", "0.48", "-0.64", "0.6")
    special = replace(chaplygin_ball(), system=SEPARABLE.system)
    (values, *_) = states(SEPARABLE.system, start, PARAMETERS)
    with mpmath.workdps(34):
        here, there = located(SEPARABLE, values), located(special, values)
        for one, other in (
            (SEPARABLE.time_rescaling, special.time_rescaling),
            (SEPARABLE.leading, special.leading),
            *zip(SEPARABLE.roots, special.roots, strict=True),
            *zip(SEPARABLE.weights, special.weights, strict=True),
        ):
            assert abs(at(one, here) - at(other, there)) < 1e-30
