"""What is said of a motion that has no closed form."""

from __future__ import annotations

import re

import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.solvable_cases import solution_of


def refused(text: str, *overrides: str) -> str:
    """The sentence with which a motion is refused."""
    study = Study.from_experiment(parse_experiment(text, "x.toml", list(overrides)))
    with pytest.raises(NoClosedFormError) as refusal:
        solution_of(Problem(study.system, study.system.defaults, study.start, study.rolling))
    assert isinstance(refusal.value, InputError)
    return str(refusal.value)


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
    parameters = ["system.parameters.k=1.5"] if name == "rubber-ball-of-ratio" else []
    sentence = refused(f'[system]\nname = "{name}"\n', *parameters)
    for part in parts:
        assert part in sentence
    assert len(re.findall(r"\. |\n", sentence)) == 0


HEAVY = """
[body]
mass = 1.0
inertia = [1.0, 1.5, 2.1]
[body.shape]
kind = "ball"
radius = 0.8
centre = [0.1, 0.0, 0.0]
[field]
gravity = 9.81
[start]
gamma = [0.36, -0.48, 0.8]
omega = [0.8, -0.4, -0.6]
"""


@pytest.mark.slow
def test_bodies_from_a_file() -> None:
    sentence = refused(HEAVY)
    assert sentence.startswith("the unbalanced ball on a plane under gravity, marble contact, is")
    sphere = ["body.shape.centre=[0,0,0]", "surface.kind=sphere", "surface.radius=3.0"]
    assert refused(HEAVY, *sphere).startswith("the ball on a sphere under gravity")
    potential = ["body.shape.centre=[0,0,0]", "field.potential=gamma_1**3"]
    assert "in this potential" in refused(HEAVY, *potential)


def test_curves_that_are_not_solved() -> None:
    moments = ["system.parameters.I_2=1.0", "system.parameters.I_3=1.6"]
    sentence = refused('[system]\nname = "neumann"\n', *moments)
    assert "roots of its curve coincide, as they do for equal moments: known are" in sentence


OWN = """
[equations]
state = ["x", "v"]
rates = { x = "v", v = "-x**3" }
[start]
x = 1.0
v = 0.0
[run]
until = 5.0
"""


def test_a_system_of_the_users_own() -> None:
    sentence = refused(OWN)
    assert "is not solved in closed form here: nothing but its equations is known" in sentence
