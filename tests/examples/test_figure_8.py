"""The example of the three-dimensional section."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from flowlanes.flow.sampling.level_sampler import sample_level

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture(scope="module")
def example():
    sys.path.insert(0, str(EXAMPLES))
    try:
        import figure_8

        yield figure_8
    finally:
        sys.path.remove(str(EXAMPLES))


@pytest.fixture(scope="module")
def paths(example):
    crossed = example.RETURN.crossings(
        sample_level(example.SYSTEM, 24, example.LEVEL, seed=2), 1501
    )
    return crossed.states[crossed.counts == 1501]


@pytest.fixture(scope="module")
def cycle(example, paths):
    return next(cycle for cycle in example.cycles(paths) if cycle.period == 3)


def test_the_body_could_be_built(example):
    body = example.BODY
    moments = sorted(body[f"I_{i}"] for i in (1, 2, 3))
    assert moments[2] < moments[0] + moments[1]
    away = sum(body[f"c_{i}"] ** 2 for i in (1, 2, 3))
    assert sum(moments) / 2 <= body["m"] * (body["R"] ** 2 - away)


@pytest.mark.slow
def test_a_cycle_attracts_and_its_reverse_repels(example, cycle):
    assert 0.2 < cycle.share < 1.0
    assert cycle.multiplier < 0.75
    assert np.abs(example.RETURN.iterate(cycle.points[-1], 3) - cycle.points[-1]).max() < 1e-9
    origin = example.reversed_of(cycle.points[-1])
    assert np.abs(example.RETURN.iterate(origin, 3) - origin).max() < 1e-9
    repelling = np.stack([example.RETURN.iterate(origin, k) for k in range(3)])
    assert example.multiplier(repelling) > 1.25
    # the one is below, the other above
    assert (example.PLACES(cycle.points)[:, 2] < 0).all()
    assert (example.PLACES(repelling)[:, 2] > 0).all()


@pytest.mark.slow
def test_points_lie_on_a_surface(example, paths):
    level = example.KEPT(paths.reshape(-1, 6))
    assert np.abs(level - [0.0, *example.LEVEL.values()]).max() < 1e-8
    random = np.random.default_rng(1)
    u, v, w = random.uniform(size=(3, 20_000))
    assert example.thickness(np.stack([u, v, u * v], axis=1)) < 0.05
    assert example.thickness(np.stack([u, v, w], axis=1)) > 0.5
    assert example.thickness(example.in_space(paths[:, ::5].reshape(-1, 6))) < 0.1


@pytest.mark.slow
def test_departures_stay_on_the_level(example, cycle):
    start = example.departure(example.reversed_of(cycle.points[-1]), 4)
    assert np.abs(example.KEPT(start[None]) - [0.0, *example.LEVEL.values()]).max() < 1e-12


def test_when_a_motion_has_arrived(example):
    assert example.last_beyond(np.array([3.0, 0.1, 2.0, 0.1]), 1.0) == 3
    assert example.last_beyond(np.array([0.1, np.nan]), 1.0) == 2
    assert example.last_beyond(np.array([0.1]), 1.0) == 0


@pytest.mark.slow
def test_pictures_and_what_is_said(example, tmp_path, capsys, monkeypatch):
    monkeypatch.setattr(example, "STARTS", 40)
    example.main(tmp_path)
    said = capsys.readouterr().out
    assert "come to a cycle of 3 points" in said
    assert "The quickest of those that come to the cycle starts at" in said
    assert {path.name for path in tmp_path.iterdir()} == {"figure_8.png", "figure_8_many.png"}
