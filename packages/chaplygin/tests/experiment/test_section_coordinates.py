"""The coordinates by which a section is looked at where nobody has chosen any."""

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import catalogue_experiment, parse_experiment
from chaplygin.experiment.poincare import coordinates_of
from chaplygin.experiment.section_coordinates import is_angle, usual, within_a_turn
from chaplygin.experiment.single_system import without_reconstruction
from chaplygin.experiment.study import Study
from flowlanes.formulas.array_evaluation import values
from nonholonomic.catalogue import entry

PENDULUM = """
[equations]
state = ["phi", "p", "s"]
rates = { phi = "p", p = "-sin(phi) - s", s = "-s" }
[start]
phi = 1
p = 0
s = 0.5
"""


@pytest.mark.parametrize(
    ("name", "on", "expected"),
    [
        ("unbalanced-ball", "gamma_3", "andoyer-ratio: l, L/G"),
        ("unbalanced-ball", "M_3", "andoyer-ratio: l, g"),
        ("veselova", "gamma_3", "phi = atan2(gamma_2, gamma_1), omega_3"),
        ("veselova", "omega_3", "phi = atan2(gamma_2, gamma_1), gamma_3"),
    ],
)
def test_bodies(name, on, expected):
    assert usual(entry(name).system({}), on) == expected


def test_three_where_a_level_has_no_further_integral():
    system = without_reconstruction(Study.from_experiment(catalogue_experiment("rattleback")))
    assert usual(system, "gamma_1") == "andoyer-ratio: l, L/G, H"


def test_angles_are_those_whose_whole_turns_count_for_nothing():
    system = Study.from_experiment(parse_experiment(PENDULUM)).system
    assert [str(s) for s in system.symbols if is_angle(system, s)] == ["phi"]
    names, quantities, _ = coordinates_of(system, "", condition="s")
    assert names == ("phi_in_turn", "p")
    (angle,) = quantities
    assert (angle.label, angle.unit) == ("phi", "rad")
    states = np.array([[300.0, 0.0, 0.1], [-4.0, 0.0, 0.1], [1.0, 0.0, 0.1]])
    found = values(system, [angle.formula], states)[:, 0]
    assert np.allclose(found, (states[:, 0] + np.pi) % (2 * np.pi) - np.pi)


def test_a_place_that_enters_nothing_is_no_angle():
    system = without_reconstruction(Study.from_experiment(catalogue_experiment("chaplygin-sleigh")))
    assert [str(s) for s in system.symbols if is_angle(system, s)] == ["phi"]
    assert within_a_turn(system.symbols[2]).meaning == "phi, within a turn"
