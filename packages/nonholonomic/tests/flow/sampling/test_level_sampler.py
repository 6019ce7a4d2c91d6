"""Starts on a level: their distribution, its invariance, their bits, and what is refused."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import sympy as sp
from scipy import integrate as quadrature, special, stats

from flowlanes.errors import InputError
from flowlanes.flow.batch import batch_integrator
from flowlanes.flow.integrator import integrate
from flowlanes.flow.sampling.level_sampler import LevelSampler, level_sampler, sample_level
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.laws import Integral, Law, Measure
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import Diagonal, cross, dot, norm_squared, vectors
from nonholonomic.catalogue import CATALOGUE, from_catalogue
from spread import spread

(M,) = vectors("M")
A = Diagonal("A")
RATES = (0.4, 1.0, 2.5)
#: Below this a distribution is refused; the seeds are fixed, so that no test fails by chance.
LEAST = 1e-3


def free_body(*laws: Law) -> System:
    """The Euler top with the reciprocal moments A."""
    return System(
        name="free-body",
        title="Free body",
        field={M: cross(M, A * M)},
        parameters=tuple(
            Parameter(s, "reciprocal moment", a) for s, a in zip(A.symbols, RATES, strict=True)
        ),
        laws=(
            Integral("energy", dot(M, A * M) / 2),
            Integral("square", norm_squared(M)),
            *laws,
        ),
    )


VOLUME = Measure("volume", {sp.S.One: 1}, "volume")


def uniform(numbers: Any) -> float:
    return float(stats.kstest(numbers, "uniform").pvalue)


def test_uniform_on_a_sphere() -> None:
    directions = sample_level(free_body(), 20_000, {"square": 1.0}, seed=1)
    assert np.abs((directions**2).sum(axis=1) - 1).max() < 1e-15
    for column in directions.T:
        assert uniform((column + 1) / 2) > LEAST
    assert uniform(np.arctan2(directions[:, 1], directions[:, 0]) / (2 * np.pi) + 0.5) > LEAST


EDGES = np.linspace(-1, 1, 13)


def bands(axes: Any) -> Any:
    """Shares of the area of an ellipsoid between the heights EDGES, in units of its last axis."""
    a, b, c = axes

    def band(z: float) -> float:
        r = np.sqrt(1 - z**2)

        def element(t: float) -> float:
            x, y = r * np.cos(t), r * np.sin(t)
            return float(a * b * c * np.sqrt((x / a) ** 2 + (y / b) ** 2 + (z / c) ** 2))

        return float(quadrature.quad(element, 0, 2 * np.pi, epsrel=1e-7)[0])

    areas = [quadrature.quad(band, *ends, epsrel=1e-6)[0] for ends in pairwise(EDGES)]
    return np.array(areas) / sum(areas)


def test_area_of_an_ellipsoid() -> None:
    found = sample_level(free_body(), 20_000, {"energy": 1.0}, seed=2)
    axes = np.sqrt(2 / np.array(RATES))
    counts = np.histogram(found[:, 2] / axes[2], EDGES)[0]
    assert stats.chisquare(counts, bands(axes) * len(found)).pvalue > LEAST
    # the same directions stretched from a sphere are another distribution
    assert stats.chisquare(counts).pvalue < 1e-9


def test_invariant_volume_on_an_ellipsoid() -> None:
    level = level_sampler(free_body(VOLUME), {"energy": 1.0})
    assert level.invariant and level.measure == "invariant measure: volume"
    found = level.draw(20_000, seed=3)
    for column, rate in zip(found.T, RATES, strict=True):
        assert uniform(0.5 + column / np.sqrt(8 / rate)) > LEAST


@pytest.mark.slow
def test_time_is_uniform_on_a_level_of_the_euler_top() -> None:
    # M₂ = p sin φ, M₃ = q cos φ, and the elliptic integral F(φ, k) grows like time
    first, middle, last = RATES
    below, above = 2.0 - first * 2.2, last * 2.2 - 2.0
    p, q = np.sqrt(below / (middle - first)), np.sqrt(below / (last - first))
    modulus = (last - middle) * below / ((middle - first) * above)
    found = sample_level(free_body(VOLUME), 500, {"energy": 1.0, "square": 2.2}, seed=4)
    time = special.ellipkinc(np.arctan2(found[:, 1] / p, found[:, 2] / q), modulus)
    assert uniform(0.5 + time / (4 * special.ellipk(modulus))) > LEAST
    assert stats.binomtest(int((found[:, 0] > 0).sum()), 500).pvalue > LEAST


def test_the_fibres_of_the_veselova_system_are_of_one_size() -> None:
    # the density √(γ, I⁻¹γ) cancels what the ellipses weigh: γ is uniform on its sphere
    found = sample_level(from_catalogue("veselova"), 20_000, {"energy": 1.0}, seed=5)
    for column in found[:, 3:].T:
        assert uniform((column + 1) / 2) > LEAST


LEVELS: Mapping[str, tuple[str, dict[str, float], int]] = {
    "ball": ("chaplygin-ball", {"energy": 1.0, "area": 0.3}, 20_000),
    "ball, a torus": ("chaplygin-ball", {"energy": 1.0, "area": 0.3, "momentum": 5.0}, 200),
    "veselova": ("veselova", {"energy": 1.0}, 20_000),
    "veselova, a torus": ("veselova", {"energy": 1.0, "momentum": 2.6}, 300),
    "top": ("lagrange-top", {"energy": 1.0, "area": 0.3, "spin": 0.5}, 300),
}


@cache
def known(name: str) -> LevelSampler:
    """A level, prepared once for all tests."""
    system, level, _ = LEVELS[name]
    return level_sampler(from_catalogue(system), level)


def mixed(system: System, states: Any, others: Any) -> float:
    """The least of the probabilities that both have the same distribution, by each variable."""
    tests = (stats.ks_2samp(x, y).pvalue for x, y in zip(states.T, others.T, strict=True))
    return float(min(tests)) * len(system.symbols)


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(LEVELS, every=3))
def test_the_motion_keeps_the_distribution(name: str) -> None:
    chosen, count = known(name), LEVELS[name][2]
    made = chosen.system
    assert chosen.invariant
    begin, later = chosen.draw(count, seed=6), chosen.draw(count, seed=7)
    end = batch_integrator(made, tolerance=1e-9).propagate(begin, [3.0]).states[:, -1]
    assert mixed(made, end, later) > LEAST


@pytest.mark.slow
def test_a_wrong_measure_is_not_kept() -> None:
    level = {"energy": 1.0, "area": 0.3}
    made = from_catalogue("lagrange-top")
    bare = replace(made, laws=tuple(law for law in made.laws if not isinstance(law, Measure)))
    chosen = level_sampler(bare, level)
    assert not chosen.invariant
    assert chosen.measure == "surface measure"
    begin, later = chosen.draw(20_000, seed=6), chosen.draw(20_000, seed=7)
    end = batch_integrator(made, tolerance=1e-9).propagate(begin, [3.0]).states[:, -1]
    assert mixed(made, begin, later) > LEAST
    assert mixed(made, end, later) < 1e-6


def test_the_place_of_a_ball_on_an_ellipsoid_is_uniform_by_area() -> None:
    # the fibres are alike without a field, and the density is that of the area
    system, still = from_catalogue("marble-ball-on-ellipsoid"), {"kappa": 0.0}
    chosen = level_sampler(system, {"energy": 1.0}, still)
    assert chosen.invariant
    axes = np.array([system.defaults[s] for s in sp.symbols("a_1:4", real=True)])
    places = chosen.draw(20_000, seed=11)[:, :3] / axes
    assert np.abs((places**2).sum(axis=1) - 1).max() < 1e-15
    counts = np.histogram(places[:, 2], EDGES)[0]
    assert stats.chisquare(counts, bands(axes) * len(places)).pvalue > LEAST
    assert stats.chisquare(counts).pvalue < 1e-3


def test_a_density_of_both_signs_is_no_measure() -> None:
    # rho = 1/(I_13 omega_1 + I_23 omega_2)
    level = level_sampler(from_catalogue("suslov"), {"energy": 1.0})
    assert level.measure == "surface measure"
    straight = level_sampler(from_catalogue("suslov"), {"energy": 1.0}, {"I_13": 0.0, "I_23": 0.0})
    assert straight.measure.startswith("invariant measure")


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ball", "ball, a torus"])
def test_a_point_depends_on_its_number_alone(name: str) -> None:
    chosen = known(name)
    whole = chosen.draw(40, seed=8)
    parts = [chosen.draw(n, seed=8, first=k) for k, n in ((0, 1), (1, 7), (8, 30), (38, 2))]
    assert (np.concatenate(parts) == whole).all()
    assert not (chosen.draw(40, seed=9) == whole).all(axis=1).any()


@pytest.mark.slow
@pytest.mark.parametrize("name", LEVELS)
def test_points_lie_on_the_level(name: str) -> None:
    made, level = known(name).system, known(name).values
    states = known(name).draw(50, seed=10)
    assert np.abs(values(made, made.relations, states)).max() < 2e-15
    held = values(made, list(level), states)
    wanted = np.array(list(level.values()))
    assert (np.abs(held - wanted) / (1 + np.abs(wanted))).max() < 2e-15


def test_other_parameters() -> None:
    made = from_catalogue("chaplygin-ball")
    states = sample_level(made, 10, {"energy": 1.0}, {"I_1": 3.0}, seed=1)
    assert np.abs(values(made, ["energy"], states, {"I_1": 3.0}) - 1).max() < 2e-15


@pytest.mark.parametrize(
    ("name", "level", "said"),
    [
        ("chaplygin-ball", {"energy": -1.0}, "is empty: energy is at least 0"),
        (
            "chaplygin-ball",
            {"energy": 1e300},
            r"energy = 1e\+300 is too far from 1 to compute with",
        ),
        ("rattleback", {"energy": 1e308}, r"energy = 1e\+308 is too far from 1 to compute with"),
        (
            "chaplygin-ball",
            {"energy": 1.0, "area": 100.0},
            "is empty: with area = 100 energy is at least 2380.95",
        ),
        (
            "veselova",
            {"energy": 1.0, "momentum": 9.0},
            "is empty: with energy = 1 momentum lies between 2 and 4.2",
        ),
        ("chaplygin-ball", {"area": 1.0}, "is not bounded .* quadratic and definite in M_1"),
        ("chaplygin-ball", {}, "the level of no integral is not bounded"),
        ("chaplygin-ball", {"spin": 1.0}, "no integral 'spin'; it has energy, area, momentum"),
        ("chaplygin-ball", {"energy": float("nan")}, "energy = nan: a finite number is needed"),
        ("ball-on-sphere", {"energy": 1.0, "linear": 0.1}, "no integral 'linear'"),
        (
            "clebsch",
            {"energy": 1.0, "area": 0.1, "neumann": 1.0, "bruns": 1.0},
            "neumann and bruns cannot both be held besides energy",
        ),
    ],
)
def test_refusals(name: str, level: dict[str, float], said: str) -> None:
    with pytest.raises(InputError, match=said):
        sample_level(from_catalogue(name), 1, level)


def test_conditions_on_quantities_that_are_defined_by_parameters() -> None:
    # k = a/(a − R) is −1 for R = 2a alone
    hollow = from_catalogue("ball-around-sphere")
    level = {"energy": 1.0, "linear": 0.1}
    for state in sample_level(hollow, 3, level, seed=4):
        motion = integrate(hollow, state, [0.0, 1.0])
        np.testing.assert_allclose(motion["law_linear"], 0.1, rtol=1e-12)
    with pytest.raises(InputError, match=r"linear is an integral only where k \+ 1 = 0"):
        sample_level(hollow, 1, level, parameters={"R": 2.5})


#: What no exact method here reaches, and why.
REFUSED = {
    "angles or places that the energy does not know": (
        "roller-racer snakeboard trailers vertical-rolling-disk suslov-bracket lagrange-top-angles "
        "chaplygin-sleigh chaplygin-ball-unreduced chaplygin-ball-angles chaplygin-ball-reduced "
        "rubber-ball-sphero-conical rubber-ball-separated marble-ball veselova-spinning "
        "straight-line-ball straight-line-ball-momenta"
    ),
    "surfaces that are no ellipsoids": (
        "marble-ball-on-surface marble-ball-in-basin rubber-ball-in-basin marble-ball-on-cone "
        "rubber-ball-on-cone marble-ball-on-cylinder marble-ball-on-paraboloid "
        "marble-ball-on-round-paraboloid marble-ball-on-torus rubber-ball-on-torus "
        "rubber-ball-on-surface"
    ),
}


#: Friction takes the energy by which a level would be bounded.
SLIDING = ("sliding-ball", "sliding-top")


@pytest.mark.slow
@pytest.mark.parametrize("name", spread([name for name in CATALOGUE if name not in SLIDING]))
def test_the_catalogue(name: str) -> None:
    system = from_catalogue(name)
    (bound,) = (law.name for law in system.integrals if law.name in ("energy", "hamiltonian"))
    level = {bound: 40.0}
    if name in " ".join(REFUSED.values()).split():
        with pytest.raises(InputError, match="is not bounded in a way that can be seen"):
            sample_level(system, 1, level)
        return
    states = sample_level(system, 20, level, seed=1)
    assert np.abs(values(system, [bound], states) - 40.0).max() < 1e-11
    if system.relations:
        assert np.abs(values(system, system.relations, states)).max() < 1e-14
