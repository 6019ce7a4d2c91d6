"""Ensembles: the same motions as one by one, told by their names, in any blocks."""

from __future__ import annotations

import pickle
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
import xarray as xr

from flowlanes.errors import InputError
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.ensembles.members import from_lists, grid, random_starts, single
from flowlanes.flow.ensembles.run import ensemble, ensemble_task
from flowlanes.flow.ensembles.task import Divisible
from flowlanes.flow.integrator import integrate
from flowlanes.flow.sampling.level_sampler import sample_level
from flowlanes.system.system import Guard
from nonholonomic.catalogue import from_catalogue
from nonholonomic.starts import initial_state

BALL = from_catalogue("chaplygin-ball")
TIMES = np.linspace(0, 5, 6)
LEVEL = {"energy": 1.0}
SPUN = single(omega=(0.7, 0.4, 1.1), gamma=(0.2, -0.3, 0.93))


def bits(data: xr.Dataset) -> dict[str, bytes]:
    return {str(name): data[name].to_numpy().tobytes() for name in data.variables}


def test_it_agrees_with_heyoka() -> None:
    data = ensemble(BALL, SPUN * grid(m=[1.0, 2.0]), TIMES, {"R": 1.2}, record=("omega", "energy"))
    for run, mass in enumerate((1.0, 2.0)):
        given = {"m": mass, "R": 1.2}
        known = {s: given.get(str(s), v) for s, v in BALL.defaults.items()}
        start = initial_state(BALL, (0.7, 0.4, 1.1), (0.2, -0.3, 0.93), parameters=known)
        path = integrate(BALL, start, TIMES, parameters=known)
        for name in ("M", "gamma", "omega"):
            assert np.allclose(data[name][run], np.float64(path[name]), rtol=0, atol=1e-11)
        assert np.allclose(data.law_energy[run], np.float64(path["law_energy"]), rtol=1e-12)


def test_the_conventions_of_datasets() -> None:
    data = ensemble(
        BALL, random_starts(4, LEVEL, seed=5) * grid(m=[1, 2, 3]), TIMES, record=("omega",)
    )
    assert data.sizes == {"run": 12, "time": 6, "axis": 3}
    assert set(data.coords) == {"time", "axis", "m", "start"}
    assert data.m.dims == data.start.dims == ("run",)
    assert data.M.dims == ("run", "time", "axis")
    for name in data.variables:
        assert set(data[name].attrs) >= {"long_name", "units", "source"}, name
    assert data.gamma.attrs["frame"] == data.omega.attrs["frame"] == "body axes"
    assert data.attrs["system_name"] == "chaplygin-ball"
    assert data.attrs["seed"] == 5
    assert data.attrs["tolerance"] == 1e-13
    assert data.attrs["parameters"] == "I_1 = 1.0; I_2 = 1.5; I_3 = 2.1; R = 1.0"
    assert data.attrs["members"] == "4 drawn on energy = 1.0 (seed 5) × 3 of m"
    assert "(7.3)" in data.attrs["measure"]
    # products come apart again
    table = data.set_index(run=("start", "m")).unstack("run")
    assert np.array_equal(table.M.sel(start=2, m=3.0), data.M[8])


def test_motion_in_space() -> None:
    lifted = BALL.lifted()
    start = np.float64(initial_state(BALL, (0.7, 0.4, 1.1), (0.2, -0.3, 0.93)))
    data = ensemble(lifted, start[np.newaxis], TIMES, record=("centre",))
    assert data.attitude.dims == ("run", "time", "quaternion")
    assert data.centre.dims == ("run", "time", "space")
    assert data["space"].to_numpy().tolist() == ["x", "y", "z"]
    path = integrate(BALL, start, TIMES)
    assert np.allclose(data.centre[0], np.float64(path["centre"]), rtol=0, atol=1e-11)


EVERYONE = {
    "drawn": random_starts(23, LEVEL, seed=1),
    "drawn by grid": random_starts(8, LEVEL, seed=1) * grid(m=[1.0, 2.0, 3.0]),
    "grid by drawn": grid(m=[1.0, 2.0, 3.0]) * random_starts(8, LEVEL, seed=1),
    "spun": SPUN * grid(m=np.linspace(1, 2, 5), R=np.linspace(1, 2, 5)),
    "listed": from_lists(
        M=np.linspace(-1, 1, 69).reshape(23, 3), gamma=[[0, 0.6, 0.8]] * 23, m=np.linspace(1, 2, 23)
    ),
}


@pytest.mark.parametrize("name", EVERYONE)
def test_bits_do_not_depend_on_blocks(name: str, tmp_path: Path) -> None:
    def made(block: int | None, where: Path | None = None) -> dict[str, bytes]:
        return bits(
            ensemble(
                BALL, EVERYONE[name], TIMES, record=("omega", "area"), block=block, store=where
            )
        )

    whole = made(None)
    assert whole == made(5) == made(7, tmp_path / "a.zarr")


@pytest.mark.slow
def test_starts_are_those_of_the_level_at_their_own_parameters() -> None:
    data = ensemble(
        BALL, random_starts(3, LEVEL, seed=9) * grid(R=[1.0, 1.5]), [0.0], record=("energy",)
    )
    assert np.allclose(data.law_energy, 1.0, rtol=0, atol=1e-13)
    for run in range(6):
        number, radius = divmod(run, 2)
        state = sample_level(BALL, 1, LEVEL, {"R": (1.0, 1.5)[radius]}, seed=9, first=number)[0]
        assert np.array_equal(data.M[run, 0], state[:3])
        assert np.array_equal(data.gamma[run, 0], state[3:])


def test_why_motions_ended() -> None:
    # a boundary that some motions reach
    upright = Guard("upright", sp.Symbol("gamma_3", real=True) + sp.Rational(1, 2), "it lies down")
    guarded = replace(BALL, guards=(upright,))
    starts = sample_level(BALL, 40, LEVEL, seed=2)
    starts = starts[starts[:, 5] > -0.5]
    data = ensemble(guarded, starts, TIMES)
    flags = data.outcome.attrs
    assert flags["reasons"][0] == "the last time was reached"
    assert flags["reasons"][-1] == "it lies down"
    assert flags["flag_values"] == list(range(len(flags["reasons"])))
    assert len(flags["flag_meanings"].split()) == len(flags["reasons"])
    reasons = {flags["reasons"][code] for code in data.outcome.to_numpy()}
    assert reasons == {"the last time was reached", "it lies down"}
    # neighbours of a motion that ended go on to the bit
    free = ensemble(BALL, starts, TIMES)
    whole = data.outcome.to_numpy() == 0
    assert np.array_equal(free.M[whole], data.M[whole])
    fallen = ~whole
    assert np.all(data.ended[fallen] < TIMES[-1])
    assert np.isnan(data.M[fallen, -1]).all()


def test_lanes_do_the_work() -> None:
    starts = sample_level(BALL, 5, LEVEL)
    data = ensemble(BALL, starts, TIMES, tolerance=1e-9)
    marched = batch_integrator(BALL, tolerance=1e-9).propagate(starts, TIMES)
    assert np.array_equal(data.M, marched.states[:, :, :3])
    assert np.array_equal(data.steps, marched.steps)


def test_there_and_back() -> None:
    there = ensemble(BALL, sample_level(BALL, 5, LEVEL), TIMES)
    last = np.concatenate([there.M[:, -1], there.gamma[:, -1]], axis=1)
    back = ensemble(BALL, last, -TIMES)
    assert np.allclose(back.M[:, -1], there.M[:, 0], rtol=0, atol=1e-11)
    assert np.array_equal(back.ended, [-TIMES[-1]] * 5)


def test_a_block_is_bounded_whatever_the_size() -> None:
    small = ensemble_task(BALL, random_starts(10**9, LEVEL), TIMES)
    assert small.size == 10**9
    assert small.block == 4096
    long = ensemble_task(BALL, random_starts(10**9, LEVEL), np.linspace(0, 1, 10**4))
    assert long.block * 10**4 * 6 <= 1 << 22


@pytest.mark.parametrize(("size", "blocks"), [(100, 7), (10**4, 64), (10**6, 245)])
def test_workers_find_something_to_do(size: int, blocks: int) -> None:
    assert ensemble_task(BALL, random_starts(size, LEVEL), TIMES, shares=64).blocks == blocks


@pytest.mark.parametrize(
    ("members", "options", "sentence"),
    [
        (single(M=(1, 2, 3)), {}, "the start does not tell gamma_1, gamma_2, gamma_3"),
        (single(M=(1, 2, 3), gamma=(0, 0, 1), mass=1), {}, "there is no mass"),
        (single(M=(1, 2, 3), gamma=(0, 0, 1.1)), {}, "runs 0 to 0: chaplygin-ball: start 0 misses"),
        (
            random_starts(3, LEVEL) * grid(M_1=[1, 2]),
            {},
            "only parameters can be given besides, not M_1",
        ),
        (random_starts(3, {"anger": 1.0}), {}, "anger"),
        (SPUN * grid(m=[1, 2]), {"parameters": {"m": 1.0}}, "m is given twice"),
        (SPUN, {"parameters": {"mass": 1.0}}, "no parameter"),
        (SPUN, {"record": ("height",)}, "there is no height to be recorded; there are law_energy"),
        (np.zeros((3, 5)), {}, r"state has 5 numbers for each motion, not 6"),
        ("abc", {}, "^ensemble: members must be numbers in an array or in nested sequences"),
        (SPUN, {"block": 0}, "^the block is 0: a whole number, at least 1, is needed$"),
        (
            SPUN,
            {"parameters": {"m": "abc"}},
            "^ensemble: parameters must be a mapping of parameters to",
        ),
        (SPUN, {"parameters": {"m": [1, 2]}}, "m must be one number; what varies belongs to the"),
    ],
    ids=[
        "missing",
        "name",
        "level",
        "both",
        "integral",
        "twice",
        "unknown",
        "record",
        "shape",
        "text",
        "block",
        "word",
        "row",
    ],
)
def test_mistakes_are_told(members: Any, options: dict[str, Any], sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        ensemble(BALL, members, TIMES, **options)


@pytest.mark.parametrize("times", [[], [[]], [0, "later"], [1, 0.5], [-2, -1]], ids=str)
def test_times_are_refused_in_a_sentence(times: Any) -> None:
    with pytest.raises(InputError, match=r"^times: [^\n]*$"):
        ensemble_task(BALL, SPUN, times)


def test_the_same_numbers_are_the_same_experiment(tmp_path: Path) -> None:
    mass = BALL.parameters[0]
    same = [None, {}, {"m": mass.default}, {mass.symbol: int(mass.default)}]
    made = [ensemble(BALL, SPUN, [1.0], given, store=tmp_path / "a.zarr") for given in same]
    assert all(bits(made[0]) == bits(other) for other in made)
    with pytest.raises(InputError, match="another experiment: its parameters is"):
        ensemble(BALL, SPUN, [1.0], {"m": 2.0}, store=tmp_path / "a.zarr")


def test_no_store_is_begun_for_a_mistake_that_shows(tmp_path: Path) -> None:
    with pytest.raises(InputError):
        ensemble(BALL, single(M=(1, 2), gamma=(0, 0, 1)), TIMES, store=tmp_path / "a.zarr")
    assert not [*tmp_path.iterdir()]


def test_runs_with_a_mistake_are_named() -> None:
    with pytest.raises(InputError, match=r"^runs 2 to 3: chaplygin-ball: m = -1 is not"):
        ensemble(BALL, SPUN * grid(m=[1, 2, 3, -1]), TIMES, block=2)


@pytest.mark.parametrize("name", EVERYONE)
def test_a_share_gives_the_same(name: str) -> None:
    work = ensemble_task(BALL, EVERYONE[name], TIMES, record=("energy",)).work
    assert isinstance(work, Divisible)
    whole, share = work(6, 11), work.part(6, 11)(6, 11)
    assert list(whole) == list(share)
    assert all(whole[item].tobytes() == share[item].tobytes() for item in whole)


def test_a_share_is_small() -> None:
    many = from_lists(M=np.ones((10**5, 3)), gamma=[[0, 0, 1]] * 10**5)
    work = ensemble_task(BALL, many, TIMES).work
    assert isinstance(work, Divisible)
    assert len(pickle.dumps(work.part(50, 60))) < len(pickle.dumps(work)) / 100


def test_another_start_is_another_experiment(tmp_path: Path) -> None:
    ensemble(BALL, SPUN, TIMES, store=tmp_path / "a.zarr")
    other = single(omega=(0.7, 0.4, 1.2), gamma=(0.2, -0.3, 0.93))
    with pytest.raises(InputError, match="another experiment: its members of the work is another"):
        ensemble(BALL, other, TIMES, store=tmp_path / "a.zarr")
    with pytest.raises(InputError, match="another experiment: its tolerance is 1e-13, not 1e-12;"):
        ensemble(BALL, SPUN, TIMES, store=tmp_path / "a.zarr", tolerance=1e-12)


def test_another_formula_of_the_same_name_is_another_experiment(tmp_path: Path) -> None:
    (energy, *others) = BALL.laws
    ensemble(BALL, SPUN, TIMES, record=("energy",), store=tmp_path / "a.zarr")
    doubled = replace(BALL, laws=(replace(energy, value=2 * energy.value), *others))
    with pytest.raises(InputError, match="another experiment: its system of the work is another"):
        ensemble(doubled, SPUN, TIMES, record=("energy",), store=tmp_path / "a.zarr")
