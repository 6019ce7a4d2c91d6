"""The same states in every system of units, and starts of special kinds."""

from __future__ import annotations

import random
from collections import Counter
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from closed_form.units import FAST, LARGE, SI, SLOW, SMALL, SYSTEMS, Motion, Units, motion
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from nonholonomic import solve
from nonholonomic.catalogue import entry, from_catalogue
from nonholonomic.starts import initial_state

#: Motions of every system in the campaign.
MOTIONS = 24


def drawn(kind: str, number: int) -> Motion:
    return motion(kind, random.Random(f"{kind} {number}"))


@pytest.mark.slow
def test_a_ball_of_a_millimetre_has_an_area_constant() -> None:
    # (M, γ) is 2·10⁻¹³ kg m²/s: no less a part of |M| than in other units
    moments = {"I_1": 3e-13, "I_2": 4.5e-13, "I_3": 6.3e-13}
    system = from_catalogue("chaplygin-ball", m=1e-6, R=1e-3, **moments)
    start = initial_state(system, (1.0, 2.0, -0.5), (0.6, 0.0, 0.8))
    solution = solve(system, start)
    assert solution.form.title == "Chaplygin ball"
    run = integrate(system.lifted(), start, [0.0, 100.0], precision="quad")
    found, other = solution.states(np.array([100.0]))[0], np.array(run.states[-1], dtype=float)
    for part in (slice(0, 3), slice(3, 6), slice(6, 10), slice(10, 12)):
        size = np.linalg.norm(other[part])
        assert np.linalg.norm(found[part] - other[part]) < 1e-13 * size


@pytest.mark.slow
def test_balls_are_as_narrow_in_other_units() -> None:
    whole = drawn("veselova", 0)
    system, size = whole.system, len(whole.system.symbols)
    radii = []
    for units in (SI, FAST, SLOW):
        start, parameters = whole.told(units)
        balls = solve(system, start[:size], parameters).rigorous(5 * units.time, 20)
        with ctx.workprec(200):
            factors = [arb(f.numerator) / f.denominator for f in whole.factors(units)]
            told = [x / f for x, f in zip(balls, factors, strict=False)]
            radii.append(max(float(x.rad()) for x in told))
            with mpmath.workdps(40):
                exact = whole.integrated([5.0])[0]
            for ball, x in zip(told, exact, strict=False):
                assert abs(ball.mid() - arb(str(x))) - ball.rad() < 1e-25
    assert max(radii) < 1e-19


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["chaplygin-ball equal moments", "veselova equal moments"])
@pytest.mark.parametrize("units", [SI, SMALL, LARGE], ids=lambda units: units.name)
def test_moments_are_known_to_all_digits(kind: str, units: Units) -> None:
    case = drawn(kind, 0)
    balls = case.solved(units).rigorous(5 * units.time, 28)
    with ctx.workprec(200):
        assert all(float(x.rad()) <= 1e-28 * max(1, abs(float(x.mid()))) for x in balls)


def same(kind: str, number: int, units: tuple[Units, ...], until: float) -> Motion:
    """Assert that a motion has the same states in some systems of units."""
    case = drawn(kind, number)
    first, *others = (case.states(each, [0.0, until]) for each in units)
    assert case.apart(first[:1], np.array([[float(x) for x in case.start]])) < 1e-12
    for other in others:
        assert case.apart(other, first) < 1e-11
    return case


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["chaplygin-ball", "veselova equal moments", "lagrange-top"])
def test_the_same_states_in_other_units(kind: str) -> None:
    case = same(kind, 1, (SI, SMALL, LARGE, FAST, SLOW), 10.0)
    assert case.apart(case.states(SMALL, [10.0]), case.integrated([10.0])) < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize("kind", SYSTEMS)
def test_every_system_in_other_units(kind: str) -> None:
    same(kind, 2, (SI, SMALL, LARGE, FAST, SLOW), 10.0)


@pytest.mark.campaign
@pytest.mark.parametrize("kind", SYSTEMS)
def test_random_motions_in_three_systems_of_units(kind: str) -> None:
    count: Counter[str] = Counter()
    for number in range(1, MOTIONS + 1):
        case = drawn(kind, number)
        exact = case.integrated([100.0])
        for units in (SI, SMALL, LARGE):
            try:
                found = case.states(units, [100.0])
            except InputError as error:
                # said, not skipped: what a motion is refused for is counted
                count[str(error)] += 1
                continue
            count["compared"] += 1
            assert case.apart(found, exact) < 1e-10, (number, units.name)
    print(kind, dict(count))
    assert count.total() == 3 * MOTIONS
    assert count["compared"] >= 0.9 * count.total()


@pytest.mark.slow
@pytest.mark.parametrize("omega", [(1.0, -1.0, 0.5), (0.5, -0.5, 1.0), (-1.0, 1.0, 0.25)], ids=str)
def test_a_component_that_vanishes_at_the_far_end_of_its_oval(
    omega: tuple[float, float, float],
) -> None:
    system = from_catalogue("veselova")
    start = initial_state(system, omega, (1.0, 1.0, 0.0))
    run = integrate(system.lifted(), start, [0.0, 20.0], precision="quad")
    found = solve(system, start).states(np.array([0.0, 20.0]))
    assert np.abs(found - np.array(run.states, dtype=float)).max() < 1e-13


@pytest.mark.parametrize("name", ["rubber-disk", "rubber-routh-sphere"])
def test_bodies_of_revolution_are_known_by_their_equations(name: str) -> None:
    system = from_catalogue(name)
    own = entry(name).start
    solution = solve(system, initial_state(system, own.omega, own.gamma))
    assert solution.form.title == "Rubber body of revolution on a plane"


@pytest.mark.slow
def test_starts_may_be_fractions_of_any_size() -> None:
    system = from_catalogue("clebsch")
    for size in (Fraction(1, 10**9), Fraction(1), Fraction(10**9)):
        parameters = {"c": Fraction(4, 5) * size**2, "beta": Fraction(7, 10)}
        level = (4 * size, 3 * size, size, Fraction(3, 5), Fraction(-4, 5), Fraction(0))
        assert solve(system, level, parameters).form.title
        off = (4 * size, 3 * size + size / 10**9, *level[2:])
        with pytest.raises(InputError, match=r"on which \(M, Γ\) = 0"):
            solve(system, off, parameters)


@pytest.mark.parametrize("name", ["neumann", "clebsch", "veselova-bruns"])
@pytest.mark.parametrize("axis", range(3))
def test_equilibria_of_the_reduced_state_rest(name: str, axis: int) -> None:
    system = from_catalogue(name)
    start = [Fraction(0)] * 3 + [Fraction(int(i == axis)) for i in range(3)]
    solution = solve(system, start)
    assert solution.form.motion == "rest"
    assert np.array_equal(solution.states(np.array([0.0, 1e3])), [[float(x) for x in start]] * 2)
    balls = solution.rigorous(1000, 20)
    assert all(abs(x - int(y)) < 1e-30 for x, y in zip(balls, start, strict=True))
