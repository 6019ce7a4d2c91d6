"""Cavities with fluid in experiment files: one, several, and mistakes in them."""

from __future__ import annotations

import numpy as np
import pytest

from chaplygin.experiment.closed_form import solution_of_study
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from lawproof.proof.prover import prove

BODY = """
[body]
mass = 1.0
inertia = [0.4, 0.5, 0.6]
shape = {kind = "ball", radius = 1.0}
"""
START = """
[field]
gravity = 0.0
[start]
gamma = [0.0, 0.0, 1.0]
omega = [1.0, 0.0, 0.5]
"""
ONE = BODY + "[body.cavity]\naxes = [0.5, 0.4, 0.3]\nmass = 0.8\n" + START
TWO = (
    BODY
    + "[[body.cavity]]\naxes = [0.3, 0.3, 0.3]\nmass = 0.2\ncentre = [0.4, 0, 0]\n"
    + "[[body.cavity]]\naxes = [0.2, 0.3, 0.4]\nmass = 0.3\ncentre = [-0.4, 0, 0]\n"
    + START
)
TWO = TWO.replace("[0.4, 0, 0]", "[0.4, 0.0, 0.0]").replace("[-0.4, 0, 0]", "[-0.4, 0.0, 0.0]")


@pytest.mark.parametrize("text", [ONE, TWO], ids=["one", "two"])
def test_a_file_reads_back(text):
    experiment = parse_experiment(text)
    again = parse_experiment(experiment.toml())
    assert again == experiment
    header = "[body.cavity]" if text is ONE else "[[body.cavity]]"
    assert experiment.toml().count(header) == (1 if text is ONE else 2)
    assert "cavity" not in parse_experiment(BODY + START).toml()


def test_fluids_by_default_rest_in_the_body():
    start = Study.from_experiment(parse_experiment(TWO)).start_values
    assert start["fluid1"] == start["fluid2"] == (0.0, 0.0, 0.0)


def test_fluids_of_several_cavities():
    study = Study.from_experiment(
        parse_experiment(TWO + "fluid = [[0.1, 0.2, 0.3], [-1.0, 0.5, 0.0]]\n")
    )
    assert list(map(str, study.system.state)) == ["M", "gamma", "N1", "N2"]
    assert study.start_values["fluid2"] == (-1.0, 0.5, 0.0)
    assert "0.2 kg of ideal fluid" in study.subject.setting
    dataset = study.trajectory().to_dataset()
    for name in ("fluid1", "N1", "fluid2", "N2"):
        assert dataset[name].dims == ("time", "axis")
        assert dataset[name].attrs["frame"] == "body axes"
    assert np.allclose(dataset.fluid2[0], (-1.0, 0.5, 0.0), atol=1e-15)
    assert Study.from_experiment(parse_experiment(study.complete_toml())).start == study.start


@pytest.mark.parametrize("name", ["free-body", "veselova", "suslov", "rubber-chaplygin-ball"])
def test_a_file_with_several_cavities_is_written_out_in_full(name):
    cavities = """
[[body.cavity]]
axes = [0.2, 0.3, 0.25]
mass = 0.4
turn = [1.0, 0.5, 0.0, 0.2]
centre = [0.1, 0.0, 0.4]
[[body.cavity]]
axes = [0.1, 0.1, 0.1]
mass = 0.0
centre = [0.0, 0.0, -0.6]
[[body.cavity]]
axes = [0.3, 0.3, 0.2]
mass = 0.3
centre = [0.0, -0.4, -0.2]
"""
    fluid = "[[1.0, 2.0, 3.0], [0.0, 0.0, 0.0], [0.1, 0.0, 0.2]]"
    study = Study.from_experiment(
        parse_experiment(f'[system]\nname = "{name}"{cavities}[start]\nfluid = {fluid}\n')
    )
    again = Study.from_experiment(parse_experiment(study.complete_toml()))
    assert again.system == study.system
    assert again.start == study.start
    assert again.complete_toml() == study.complete_toml()
    assert study.start_values["fluid3"] == (0.1, 0.0, 0.2)


def test_an_empty_cavity_needs_no_fluid():
    dry = Study.from_experiment(parse_experiment(BODY + START)).system
    empty = parse_experiment(ONE + "fluid = [1.0, 0.0, 0.0]\n", overrides=["body.cavity.mass=0.0"])
    assert Study.from_experiment(empty).system == dry


MISTAKES = {
    "negative mass": (
        ONE.replace("mass = 0.8", "mass = -0.8"),
        "<text>, line 8, body.cavity.mass: must be a finite number not below zero, not -0.8",
    ),
    "flat cavity": (
        ONE.replace("[0.5, 0.4, 0.3]", "[0.5, 0.0, 0.3]"),
        "<text>, line 7, body.cavity.axes: must be 3 positive semi-axes, not [0.5, 0.0, 0.3]",
    ),
    "no turn": (
        ONE.replace("mass = 0.8", "mass = 0.8\nturn = [0.0, 0.0, 0.0, 0.0]"),
        "<text>, line 9, body.cavity.turn: must not be zero, as only its direction counts",
    ),
    "unknown key": (
        ONE.replace("mass = 0.8", "mass = 0.8\ncenter = [0.0, 0.0, 0.0]"),
        "<text>, line 9, body.cavity.center: unknown key, did you mean 'centre'? allowed: axes, "
        "mass, turn, centre",
    ),
    "no mass": (
        ONE.replace("mass = 0.8\n", ""),
        "<text>, line 6, body.cavity.mass: missing; it must be a finite number not below zero",
    ),
    "no table": (
        BODY + "cavity = 3\n" + START,
        "<text>, line 6, body.cavity: must be a table with axes and mass, or one in double "
        "brackets for each of several, not 3",
    ),
    "the second of two": (
        TWO.replace("mass = 0.3", "mass = -0.3"),
        "<text>, line 12, body.cavity.2.mass: must be a finite number not below zero, not -0.3",
    ),
    "too large": (
        ONE.replace("[0.5, 0.4, 0.3]", "[1.5, 0.4, 0.3]"),
        "<text>, line 2, body: the cavity with the semi-axes 1.5, 0.4, 0.3 does not fit into the "
        "body; make it smaller, or move its centre",
    ),
    "fluid without a cavity": (
        BODY + START + "fluid = [1.0, 0.0, 0.0]\n",
        "<text>, line 9, start: fluid is given, but there is no cavity; add [body.cavity]",
    ),
    "one fluid for two cavities": (
        TWO + "fluid = [1.0, 0.0, 0.0]\n",
        "<text>, line 17, start: fluid must be 3 finite numbers for each cavity; there are 2 "
        "of these, and 1 in fluid",
    ),
    "two numbers": (
        ONE + "fluid = [1.0, 0.0]\n",
        "<text>, line 15, start.fluid: must be 3 finite numbers, or 3 for each of several "
        "cavities, not [1.0, 0.0]",
    ),
    "friction": (
        ONE + '[contact]\nmodel = "friction"\nmu = 0.3\n',
        "<text>, line 2, body: a cavity with fluid needs a contact without friction; write "
        'contact.model = "marble" or "rubber", or leave the cavity out',
    ),
}


@pytest.mark.parametrize("case", MISTAKES)
def test_a_mistake_is_one_sentence(case):
    text, sentence = MISTAKES[case]
    with pytest.raises(InputError) as caught:
        Study.from_experiment(parse_experiment(text))
    assert str(caught.value) == sentence


SYSTEM = 'system = {{name = "{}"}}\nbody = {{cavity = {{axes = [0.5, 0.4, 0.3], mass = 0.7}}}}\n'


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["veselova", "suslov", "chaplygin-ball", "rubber-chaplygin-ball", "ball-on-sphere"]
)
def test_a_body_of_the_catalogue_is_filled(name):
    study = Study.from_experiment(
        parse_experiment(SYSTEM.format(name) + "start = {fluid = [1.0, 2.0, 3.0]}\n")
    )
    assert study.system.title.endswith("with fluid")
    assert str(study.system.state[-1]) == "N"
    assert {"energy", "circulation"} <= {law.name for law in study.system.integrals}
    assert all(prove(study.system, law) for law in study.system.laws)
    assert Study.from_experiment(parse_experiment(study.complete_toml())).system == study.system


SYSTEM_MISTAKES = {
    "fluid without a cavity": (
        'system = {name = "veselova"}\nstart = {fluid = [1.0, 2.0, 3.0]}\n',
        "<text>, line 2, start: fluid is given, but there is no cavity; add [body.cavity]",
    ),
    "another body": (
        SYSTEM.format("suslov-quadratic"),
        "<text>, line 2, body.cavity: suslov-quadratic cannot hold fluid; a rolling body, "
        "free-body, veselova and suslov can",
    ),
    "no body": (
        SYSTEM.format("chaplygin-sleigh"),
        "<text>, line 2, body: chaplygin-sleigh cannot hold fluid; a rolling body, free-body, "
        "veselova and suslov can",
    ),
    "too large for the ball": (
        SYSTEM.format("chaplygin-ball").replace("0.5", "1.5"),
        "<text>, line 2, body: the cavity with the semi-axes 1.5, 0.4, 0.3 does not fit into the "
        "body; make it smaller, or move its centre",
    ),
    "another key of the body": (
        'system = {name = "veselova"}\nbody = {mass = 2.0}\n',
        "<text>, line 2, body: mass must be absent, as the table [system] decides the body; beside "
        "it [body] has cavities alone, and numbers stand in [system.parameters]",
    ),
    "a cavity of the system": (
        'system = {name = "veselova", cavity = {axes = [0.5, 0.4, 0.3], mass = 0.7}}\n',
        "<text>, line 1, system: a cavity belongs to the body; write [body.cavity]",
    ),
}


@pytest.mark.parametrize("case", SYSTEM_MISTAKES)
def test_a_mistake_with_the_catalogue_is_one_sentence(case):
    text, sentence = SYSTEM_MISTAKES[case]
    with pytest.raises(InputError) as caught:
        Study.from_experiment(parse_experiment(text))
    assert str(caught.value) == sentence


def test_a_body_with_a_sphere_of_fluid_is_solved_as_the_rigid_body():
    text = SYSTEM.format("rubber-body-of-revolution").replace("0.5, 0.4, 0.3", "0.1, 0.1, 0.1")
    study = Study.from_experiment(parse_experiment(text))
    solution = solution_of_study(study)
    motion = integrate(study.system, study.start, [0.0, 1.0, 10.0])
    assert solution.system.symbols == motion.system.symbols
    assert np.abs(solution.states(motion.times) - motion.states).max() < 1e-10


def test_no_closed_form_of_the_rigid_body_is_taken_for_a_body_with_vorticity():
    text = SYSTEM.format("rubber-body-of-revolution").replace("0.5, 0.4, 0.3", "0.1, 0.1, 0.11")
    with pytest.raises(InputError, match="fluid has vorticity in a cavity that is no sphere"):
        solution_of_study(Study.from_experiment(parse_experiment(text)))
