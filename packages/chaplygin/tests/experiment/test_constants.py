"""π, other constants and huge numbers in files of the user's own."""

from __future__ import annotations

import math
import re

import pytest
import sympy as sp

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from lawproof.search import integrals, search_space
from nonholonomic import nonholonomy
from nonholonomic.invariant_measures.existence import invariant_measure
from nonholonomic.mechanics.reduction.chaplygin import chaplygin_form

OSCILLATOR = """
[parameters]
k = {value}
[equations]
state = ["x", "v"]
[equations.rates]
x = "v"
v = "-{formula}*x"
[start]
x = {start}
v = 0.0
"""
KNIFE = """
[parameters]
{name} = 2.0
[frame]
coordinates = ["x", "y", "phi"]
[lagrangian]
kinetic = "(xdot**2 + ydot**2)/2 + phidot**2/2*{formula}"
[constraints]
velocity = ["ydot*cos(phi) - xdot*sin(phi)*{formula}"]
[start]
x = 1.0
y = 0.0
phi = 0.0
xdot = 1.0
ydot = 0.0
phidot = 1.0
"""


def oscillator(formula="k", value="1.0", start="1.0"):
    text = OSCILLATOR.format(formula=formula, value=value, start=start)
    return Study.from_experiment(parse_experiment(text)).system


def knife(formula, name="m"):
    return Study.from_experiment(
        parse_experiment(KNIFE.format(formula=formula, name=name))
    ).subject.model


@pytest.mark.parametrize("formula", ["pi", "pi**2", "exp(1)", "sqrt(pi)", "pi**0.25", "sin(pi/7)"])
def test_constants_are_searched_with(formula):
    system = oscillator(formula)
    assert system.rates[1].subs(system.symbols[0], -1).evalf() == pytest.approx(
        eval(formula, {"pi": math.pi, "exp": math.exp, "sqrt": math.sqrt, "sin": math.sin})
    )
    found = list(integrals(search_space(system, parameter_degree=0)))
    # seen modulo primes; no rational number times x² makes an integral of it
    assert all(not finding.proven for finding in found)
    assert found


@pytest.mark.parametrize("formula", ["pi", "sin(pi/7)", "exp(1)", "pi**pi", "sqrt(pi)", "log(2)"])
def test_constraints_with_constants(formula):
    assert nonholonomy(knife(formula)).growth == (2, 3)


@pytest.mark.parametrize("formula", ["pi", "exp(1)"])
def test_a_reduction_says_what_to_write_instead(formula):
    decimal = f"{float(sp.sympify(formula)):.16g}"
    with pytest.raises(InputError, match=f"as a parameter with the value {re.escape(decimal)}"):
        chaplygin_form(knife(formula))


def test_roots_of_numbers_are_refused_by_the_search():
    with pytest.raises(InputError, match="give the root of a number a name, as a parameter"):
        search_space(oscillator("sqrt(3)"))
    with pytest.raises(InputError, match=re.escape("2**(1/3) is not one")):
        search_space(oscillator("2**(1/3)"))


@pytest.mark.parametrize(
    ("name", "hint"),
    [
        ("E", "Euler's number is written exp(1)"),
        ("Pi", "the half turn is written pi"),
        ("oo", "only finite numbers stand in formulas"),
        ("nan", "only finite numbers stand in formulas"),
        ("zoo", "only finite numbers stand in formulas"),
        ("I", "allowed: t, k, x, v"),
        ("S", "allowed: t, k, x, v"),
        ("lambda", "allowed: t, k, x, v"),
        ("gamma", "allowed: t, k, x, v"),
    ],
)
def test_names_of_sympy_have_no_meaning(name, hint):
    with pytest.raises(InputError) as error:
        oscillator(name)
    assert f"equations.rates.v: unknown name '{name}'" in str(error.value)
    assert hint in str(error.value)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["E", "I", "S", "N", "gamma", "beta", "zeta", "Q", "O", "oo", "re"]
)
def test_names_of_sympy_are_names_like_others(name):
    mechanism = knife(name, name)
    assert mechanism.parameters[0].symbol == sp.Symbol(name, real=True)
    assert invariant_measure(mechanism).decision == "exists"


@pytest.mark.parametrize("key", ["value", "start"])
@pytest.mark.parametrize(
    ("written", "message"),
    [
        ('"pi"', 'not the text "pi"; write 3.141592653589793'),
        ('"-pi/2"', 'not the text "-pi/2"; write -1.5707963267948966'),
        ('"E"', 'not the text "E"'),
        ("nan", "not nan"),
        ("inf", "not inf"),
        ("9" * 400, "not a number too large"),
        ("[1.0, " + "9" * 400 + ", 1.0]", "must be a finite number, or finite numbers in brackets"),
    ],
)
def test_values_are_finite_decimals(key, written, message):
    with pytest.raises(InputError) as error:
        oscillator(**{key: written})
    place = "parameters.k" if key == "value" else "start.x"
    assert place in str(error.value)
    assert message in str(error.value)


@pytest.mark.slow
def test_names_that_sines_need_are_refused_where_they_matter():
    with pytest.raises(InputError, match="the name sin_phi is needed for a sine or cosine"):
        chaplygin_form(knife("sin_phi", "sin_phi"))
    assert invariant_measure(knife("z_sigma", "z_sigma")).decision == "exists"
