"""What is said of a motion that has no closed form."""

from __future__ import annotations

import re

import pytest

from closed_form.problems import catalogue_problem
from flowlanes.errors import InputError
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.solvable_cases import solution_of
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Plane, Sphere
from nonholonomic.starts import initial_state

GAMMA = (0.36, -0.48, 0.8)


def refused(problem: Problem) -> str:
    """The sentence with which a motion is refused."""
    with pytest.raises(NoClosedFormError) as refusal:
        solution_of(problem)
    assert isinstance(refusal.value, InputError)
    return str(refusal.value)


def refused_body(centre: tuple[float, float, float], surface: Plane | Sphere, field: Forces) -> str:
    """The sentence for a ball that rolls."""
    body = Body(1.0, (1.0, 1.5, 2.1), Ball(0.8, centre=centre))
    rolling = RollingBody(body, surface, field=field)
    system = rolling.system()
    start = initial_state(system, (0.8, -0.4, -0.6), GAMMA)
    return refused(Problem(system, system.defaults, start, rolling))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "parts"),
    [
        ("ball-on-sphere", ["k = 0.666666666666667", "known are energy", "measure", "k = −1"]),
        ("rubber-ball-on-sphere", ["k = 0.6666", "rubber contact", "solvable are k = 1"]),
        ("ball-around-sphere", ["this motion", "linear integral of the case k = −1 vanishes"]),
        ("rubber-ball-of-ratio", ["solvable are k = 1 and k = −1"]),
        ("unbalanced-ball", ["the unbalanced ball on a plane", "quadratic integral"]),
        ("rattleback", ["the ellipsoid on a plane under gravity", "known is energy"]),
        ("chaplygin-ball-gyrostat", ["rotors", "area integral", "the same ball without rotors"]),
        ("chaplygin-ball-bruns", ["this motion of the Chaplygin ball", "(M, γ) = 0"]),
        ("clebsch", ["this motion of the Clebsch case", "on which (M, Γ) = 0"]),
        ("chaplygin-sleigh", ["the Chaplygin sleigh is not solved in closed form here"]),
        ("veselova-spinning", ["this motion of the generalised Veselova", "on which (ω, γ) = 0"]),
        ("marble-ball", ["the homogeneous marble ball is not solved in closed form here"]),
    ],
)
def test_one_sentence_says_what_is_known(name: str, parts: list[str]) -> None:
    parameters = {"k": 1.5} if name == "rubber-ball-of-ratio" else {}
    sentence = refused(catalogue_problem(name, **parameters))
    for part in parts:
        assert part in sentence
    assert len(re.findall(r"\. |\n", sentence)) == 0


@pytest.mark.slow
def test_rolling_balls() -> None:
    heavy, middle = Forces(9.81), (0.0, 0.0, 0.0)
    sentence = refused_body((0.1, 0.0, 0.0), Plane(), heavy)
    assert sentence.startswith("the unbalanced ball on a plane under gravity, marble contact, is")
    assert refused_body(middle, Sphere(3.0), heavy).startswith("the ball on a sphere under gravity")
    potential = real_symbol("gamma_1") ** 3
    assert "in this potential" in refused_body(middle, Plane(), Forces(9.81, potential))


def test_curves_that_are_not_solved() -> None:
    sentence = refused(catalogue_problem("neumann", I_2=1.0, I_3=1.6))
    assert "roots of its curve coincide, as they do for equal moments: known are" in sentence


def test_a_system_of_the_users_own() -> None:
    x, v = real_symbol("x"), real_symbol("v")
    own = System("own", "Own", {x: v, v: -(x**3)})
    sentence = refused(Problem(own, own.defaults, (1.0, 0.0)))
    assert "is not solved in closed form here: nothing but its equations is known" in sentence
