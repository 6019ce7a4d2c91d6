"""Euler and Jacobi without a variable on which nothing else depends."""

from __future__ import annotations

import sympy as sp

from flowlanes.system.laws import Integral, Measure, Symmetry
from flowlanes.system.system import System
from nonholonomic.classification import classify

u, v, w, x = sp.symbols("u v w x", real=True)
SHIFT = Symmetry("shift", {x: sp.S.One}, "shift of x")
VOLUME = Measure("volume", {sp.S.One: sp.S.One})


def top(integral, measure=VOLUME):
    """Three variables that turn, and a fourth that counts."""
    laws = (Integral("circle", integral), measure, SHIFT)
    return System("top", "Top", {u: v * w, v: -u * w, w: 0, x: 0}, laws=laws)


def names(system):
    return [kind.name for kind in classify(system).kinds]


def test_one_integral_and_a_measure_are_enough_in_three_dimensions():
    system = top(u**2 + v**2)
    (kind,) = classify(system).kinds
    assert kind.name == "euler-jacobi"
    assert "one integral in 3 dimensions" in kind.text
    assert any("No chaos" in statement.text for statement in classify(system).dynamics)


def test_an_integral_or_a_density_that_depends_on_it_is_none_of_the_others():
    assert names(top(u**2 + v**2 + x)) == ["none known"]
    assert names(top(u**2 + v**2, Measure("volume", {1 + x**2: sp.S.One}))) == ["none known"]
