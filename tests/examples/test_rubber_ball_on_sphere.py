"""The example of the rubber ball on a sphere."""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib
import numpy as np
import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    matplotlib.use("agg")
    sys.path.insert(0, str(EXAMPLES))
    try:
        import rubber_ball_on_sphere

        yield rubber_ball_on_sphere
    finally:
        sys.path.remove(str(EXAMPLES))


def test_starts_have_their_angles_and_energy(example):
    theta, psi = np.array([0.3, -1.2]), np.array([0.4, 2.0])
    for k in (1.0, -0.5):
        states = example.starts(k, theta, psi)
        assert example.angles(states) == (pytest.approx(theta), pytest.approx(psi))
        energy = (example.J * states[:, :3] ** 2).sum(axis=1) / 2
        assert energy == pytest.approx([0.5, 0.5])


@pytest.mark.slow
def test_resonant_curves_are_neutral_where_there_is_an_integral(example):
    orbits = example.closed_orbits(1.0, (3,), 4)
    assert orbits
    assert max(abs(example.residue(orbit)) for orbit in orbits) < 1e-10


@pytest.mark.slow
@pytest.mark.parametrize("k", [0.5, -0.5])
def test_resonances_are_broken_for_one_half(example, k):
    orbits = example.closed_orbits(k, (3,), 12)
    assert min(abs(example.residue(orbit)) for orbit in orbits) > 0.1


def test_which_quadratic_integral_holds(example):
    found = {}
    for k in (1.0, -1.0, 0.5):
        made = example.returns(k)
        starts = example.starts(k, np.array([0.7, 1.1]), np.array([1.0, 1.5]))
        found[k] = example.drifts(made, made.crossings(starts, 60).states)
    assert found[1.0]["for k = 1"] < 1e-10 < 1e-2 < found[1.0]["for k = −1"]
    assert found[-1.0]["for k = −1"] < 1e-10 < 1e-2 < found[-1.0]["for k = 1"]
    assert min(found[0.5]["for k = 1"], found[0.5]["for k = −1"]) > 1e-2


@pytest.mark.slow
def test_figure(example, tmp_path):
    found = {"k = 1": 1.0, "k = −1": -1.0, "k = ½": 0.5, "k = −½": -0.5}
    made = {name: example.measure(k, 8, 200, 2000.0) for name, k in found.items()}
    example.report(made)
    example.figure(made).savefig(tmp_path / "figure.png")
    assert (tmp_path / "figure.png").stat().st_size > 10_000
