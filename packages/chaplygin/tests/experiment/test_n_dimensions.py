"""Dimension, inertia and start of the systems of n dimensions, as a user gives them."""

from __future__ import annotations

import json
import re
import tomllib

import numpy as np
import pytest
import sympy as sp

from chaplygin.experiment.formats import csv_text
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study, dataset_of
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.formulas.array_evaluation import values
from lawproof.search.ansatz import default_momenta
from lawproof.search.input_formulas import quantities
from nonholonomic.catalogue import entry, from_catalogue

FAMILIES = ("suslov-nd", "veselova-nd", "chaplygin-ball-nd", "rubber-chaplygin-ball-nd")
TURN = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.6, 0.8], [0.0, 0.0, -0.8, 0.6]]


@pytest.mark.parametrize("name", FAMILIES)
@pytest.mark.parametrize("dimension", [3, 5])
def test_every_dimension_has_its_system(name, dimension):
    system = from_catalogue(name, dimension=dimension)
    gamma = next(v for v in system.state if str(v) == "gamma")
    assert len(gamma.symbols) == dimension
    assert len(system.lifted().symbols) >= len(system.symbols) + dimension**2


@pytest.mark.parametrize(
    ("name", "number"),
    [
        ("suslov-nd", 'J_44": 1.3'),
        ("special-chaplygin-ball-nd", 'a_2": 0.45'),
        ("special-rubber-ball-nd", 'a_3": 1.7'),
        ("veselova-nd", 'p": [1.0, 0.7, 0.2, 0.2]'),
    ],
)
def test_examples_are_decimals_of_few_digits(name, number):
    study = Study.from_experiment(parse_experiment(f'system = {{name = "{name}"}}'))
    tables = tomllib.loads(study.complete_toml())
    assert number in json.dumps({**tables["system"]["parameters"], **tables["start"]})
    assert not re.search(r"\d\.\d{7,}", study.complete_toml())


def test_the_generic_moments_are_those_of_four_dimensions_by_default():
    numbers = entry("veselova-nd").numbers()
    assert list(numbers.values()) == [0.5, 1.1, 1.6, 2.3, 0.9, 1.4]
    assert list(numbers) == ["I_12", "I_13", "I_14", "I_23", "I_24", "I_34"]


def test_moments_and_mass_tensors_are_read_in_order():
    ball = from_catalogue("chaplygin-ball-nd", moments=range(1, 11), mass=2.0, radius=0.5)
    numbers = {str(s): value for s, value in ball.defaults.items()}
    assert (numbers["I_12"], numbers["I_15"], numbers["I_23"], numbers["I_45"]) == (1, 4, 5, 10)
    assert (numbers["m"], numbers["R"]) == (2.0, 0.5)
    body = from_catalogue("suslov-nd", mass_tensor=np.diag([1.0, 2.0, 3.0]).tolist())
    numbers = {str(s): value for s, value in body.defaults.items()}
    assert (numbers["J_11"], numbers["J_23"], numbers["J_33"]) == (1.0, 0.0, 3.0)


@pytest.mark.parametrize("name", FAMILIES[1:])
def test_a_diagonal_mass_tensor_is_moments_of_sums(name):
    """J_i + J_j = I_ij: the same rates, of two derivations."""
    masses = [0.4, 0.6, 0.9, 1.2]
    tensor = from_catalogue(name, mass_tensor=np.diag(masses).tolist())
    sums = [masses[i] + masses[j] for i in range(4) for j in range(i + 1, 4)]
    moments = from_catalogue(name, moments=sums)
    start = [x for value in entry(name).start.values.values() for x in value]
    point = np.array([start])
    one = values(tensor, list(tensor.rates), point)
    other = values(moments, list(moments.rates), point)
    assert one == pytest.approx(other, abs=1e-14)


@pytest.mark.parametrize(
    ("name", "given", "message"),
    [
        ("veselova-nd", {"dimension": 2}, "dimension: must be a whole number from 3 to 9, not 2"),
        ("veselova-nd", {"dimension": 4.5}, "dimension: must be a whole number"),
        ("veselova-nd", {"dimension": 4, "moments": [1, 2, 3]}, "moments: 6 numbers are needed"),
        ("veselova-nd", {"moments": [1, 2, -3]}, "moments: I_23 = -3 must be positive"),
        ("veselova-nd", {"moments": [1, 2, 3, 4]}, "moments: 4 numbers belong to no dimension"),
        ("veselova-nd", {"mass_tensor": [[1, 0], [0, 1]]}, "mass_tensor: 2 rows belong to no"),
        ("veselova-nd", {"mass": 2.0}, "veselova-nd: no parameter mass"),
        (
            "veselova-nd",
            {"moments": [1, 2, 3], "mass_tensor": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
            "two ways to give the inertia",
        ),
        ("suslov-nd", {"mass_tensor": [[1, 2, 0], [0, 1, 0], [0, 0, 1]]}, "must be symmetric"),
        ("suslov-nd", {"mass_tensor": [[1, 0, 0], [0, -2, 0], [0, 0, 1]]}, "must be positive"),
        ("suslov-nd", {"dimension": 4, "mass_tensor": [[1, 0], [0, 1]]}, "4 rows of 4 numbers"),
        ("chaplygin-ball-nd", {"radius": 0.0}, "radius 0.0: it must be a positive finite number"),
        ("chaplygin-ball-nd", {"moment": 1.0}, "did you mean moments"),
        ("special-veselova-nd", {"factors": [1.0, 1.0, 2.0]}, "different from each other"),
        ("special-rubber-ball-nd", {"factors": [0.5, 1.0, 2.0]}, "greater than m R^2 = 1"),
        ("special-chaplygin-ball-nd", {"factors": [0.5, 1.0, 2.0]}, "less than m R^2 = 1"),
        ("veselova", {"I_1": [1.0, 2.0]}, "I_1: must be a number"),
    ],
)
def test_what_cannot_be_is_refused_in_a_sentence(name, given, message):
    with pytest.raises(InputError) as caught:
        from_catalogue(name, **given)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


def study(table, start):
    return Study.from_experiment(
        parse_experiment(f"[system]\n{table}\n[start]\n{start}\n[run]\nuntil = 1.0\n")
    )


def test_keys_stand_in_the_system_or_in_the_parameters():
    start = f"attitude = {TURN}\nomega = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]"
    keys = "dimension = 4\nmoments = [1, 2, 3, 4, 5, 6]\nmass = 2.0"
    name = 'name = "chaplygin-ball-nd"'
    above = study(f"{name}\n{keys}", start)
    below = Study.from_experiment(
        parse_experiment(f"[system]\n{name}\n[parameters]\n{keys}\n[start]\n{start}")
    )
    between = Study.from_experiment(
        parse_experiment(f"[system]\n{name}\n[system.parameters]\n{keys}\n[start]\n{start}")
    )
    assert above.start == below.start == between.start
    again = Study.from_experiment(parse_experiment(below.complete_toml()))
    assert again.start == below.start
    assert again.complete_toml() == below.complete_toml()


def test_a_start_is_the_last_row_of_the_attitude():
    made = study(
        'name = "chaplygin-ball-nd"', f"attitude = {TURN}\nomega = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]"
    )
    state = dict(zip(map(str, made.system.lifted().symbols), map(float, made.start), strict=True))
    assert (state["gamma_3"], state["gamma_4"]) == (-0.8, 0.6)
    assert state["attitude_34"] == 0.8
    # k = I(ω) + m R² (ωΓ + Γω), by hand for the pair 12, where Γ has no part
    assert state["k_12"] == pytest.approx(0.5 * 0.1)


def test_a_table_has_the_entries_of_the_attitude_by_row_and_column():
    made = study('name = "suslov-nd"\ndimension = 3', "")
    head = next(
        line
        for line in csv_text(dataset_of(made, made.trajectory())).splitlines()
        if not line.startswith("#")
    )
    names = head.split(",")
    assert names[:3] == ["time", "w_1", "w_2"]
    assert {"attitude_11", "attitude_13", "attitude_33", "omega_12", "gamma_3"} <= set(names)


def test_python_starts_by_omega_and_gamma():
    ball = from_catalogue("chaplygin-ball-nd", dimension=4)
    start = {"omega": [0.1, 0.2, 0.3, 0.4, 0.5, 0.6], "gamma": [0.0, 0.0, -0.8, 0.6]}
    motion = integrate(ball, start, [0.0, 1.0])
    assert motion["omega"][0] == pytest.approx(start["omega"], abs=1e-14)
    turn = motion["attitude"].reshape(-1, 4, 4)
    assert turn[:, -1] == pytest.approx(motion["gamma"], abs=1e-14)
    assert turn @ turn.transpose(0, 2, 1) == pytest.approx(np.array([np.eye(4)] * 2), abs=1e-14)
    assert np.linalg.det(turn) == pytest.approx([1.0, 1.0])


@pytest.mark.parametrize(
    ("name", "start", "message"),
    [
        ("chaplygin-ball-nd", "omega = [1, 2, 3]", "omega: must be 6 finite numbers (12, 13, 14"),
        ("chaplygin-ball-nd", "attitude = [[1, 0], [0, 1]]", "attitude: must be 4 rows of 4"),
        (
            "chaplygin-ball-nd",
            "attitude = [[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0.1, 1]]",
            "attitude: its rows must be orthonormal; the nearest rotation is [[1.0, 0.0",
        ),
        (
            "chaplygin-ball-nd",
            "attitude = [[-1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]",
            "a reflection",
        ),
        (
            "veselova-nd",
            "gamma = [0, 0, 0, 1]\nomega = [1, 2, 3, 4, 5, 6]",
            "the nearest admissible omega is [0.0, 0.0, 3.0, 0.0, 5.0, 6.0]",
        ),
        (
            "rubber-chaplygin-ball-nd",
            "gamma = [1, 0, 0, 0]\nomega = [1, 2, 3, 4, 5, 6]",
            "the nearest admissible omega is [1.0, 2.0, 3.0, 0.0, 0.0, 0.0]",
        ),
        (
            "suslov-nd",
            "omega = [1, 2, 3, 4, 5, 6]",
            "the nearest admissible omega is [0.0, 0.0, 3.0, 0.0, 5.0, 6.0]",
        ),
        ("veselova-nd", "p = [1, 0, 0, 0]\ngamma = [1, 0, 0, 0]", "the nearest admissible state"),
        ("special-chaplygin-ball-nd", "omega = [1, 2, 3, 4, 5, 6]", "give p"),
    ],
)
def test_a_start_that_cannot_be_is_refused_in_a_sentence(name, start, message):
    made = study(f'name = "{name}"', start)
    with pytest.raises(InputError) as caught:
        _ = made.start
    assert message in str(caught.value)


def test_arrays_are_taken_as_rows():
    tensor = np.diag([1.0, 2.0, 3.0])
    assert (
        from_catalogue("veselova-nd", mass_tensor=tensor).defaults[sp.Symbol("J_33", real=True)]
        == 3
    )
    assert len(from_catalogue("veselova-nd", moments=np.arange(1.0, 4.0)).symbols) == 6


def test_python_starts_by_omega_and_attitude():
    ball = from_catalogue("chaplygin-ball-nd", dimension=4)
    omega = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6]
    start = {"omega": omega, "attitude": np.array(TURN), "contact": [1.0, 2.0, 3.0]}
    motion = integrate(ball, start, [0.0, 1.0])
    assert motion["omega"][0] == pytest.approx(omega, abs=1e-14)
    assert motion["attitude"][0].reshape(4, 4) == pytest.approx(np.array(TURN), abs=1e-15)
    assert motion["contact"][0].tolist() == [1.0, 2.0, 3.0]
    by_file = study('name = "chaplygin-ball-nd"', f"attitude = {TURN}\nomega = {omega}").start
    assert motion["k"][0] == pytest.approx([float(x) for x in by_file[:6]], abs=1e-15)


@pytest.mark.parametrize(
    ("start", "message"),
    [
        ({"omega": [1.0, 2, 3, 4, 5, 6], "gamma": [0, 0, 0, 1.0]}, "does not admit this omega"),
        ({"omega": [0, 0, 1.0, 0, 1, 1], "attitude": np.eye(3)}, "attitude: must be 4 rows of 4"),
        ({"omega": [0, 0, 1.0, 0, 1, 1], "attitude": 2 * np.eye(4)}, "rows must be orthonormal"),
        ({"omega": [0, 0, 1.0, 0, 1, 1], "attitude": np.diag([1.0, 1, 1, -1])}, "a reflection"),
        (
            {"omega": [0, 0, 1.0, 0, 1, 1], "attitude": np.eye(4), "gamma": [1.0, 0, 0, 0]},
            "must be the last row of the attitude",
        ),
    ],
)
def test_what_python_cannot_start_from_is_refused(start, message):
    with pytest.raises(InputError) as caught:
        integrate(from_catalogue("veselova-nd", dimension=4), start, [0.0, 1.0])
    assert message in str(caught.value)


def test_the_momentum_of_a_ball_is_what_a_search_is_for():
    ball = from_catalogue("chaplygin-ball-nd", dimension=3)
    names = [[str(s) for s in family] for family in default_momenta(ball)]
    assert names == [["k_12", "k_13", "k_23"]]
    assert [str(s) for s in quantities("k", ball)] == names[0]


def test_a_file_may_give_attitude_and_normal():
    attitude = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
    text = (
        f'[system]\nname = "chaplygin-ball-on-sphere-nd"\ndimension = 3\na = -4.0\n[start]\n'
        f"attitude = {attitude}\ngamma = [1, 0, 0]\nomega = [0.1, 0.2, 0.3]\n[run]\nuntil = 0.5\n"
    )
    study = Study.from_experiment(parse_experiment(text))
    assert study.trajectory()["contact"][0] == pytest.approx([0.0, -4.0, 0.0], abs=1e-14)
    again = Study.from_experiment(parse_experiment(study.complete_toml()))
    assert again.start == study.start
