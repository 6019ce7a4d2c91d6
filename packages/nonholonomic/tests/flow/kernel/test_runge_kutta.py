"""The loop over many motions: how lanes end, where they cross a section, at every width."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from inspect import unwrap
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st
from scipy.optimize import brentq

from flow.small import (
    FENCED,
    KEPLER,
    LOGARITHM,
    OSCILLATOR,
    RUNAWAY,
    TURNING,
    body,
    p,
    starts,
    x,
    y,
)
from flowlanes.flow import batch as lanes_module
from flowlanes.flow.batch import BatchIntegrator, batch_integrator
from flowlanes.flow.devices.processor import SIGNATURE, ProcessorLoop
from flowlanes.flow.integrator import integrate
from flowlanes.flow.kernel.equations import Section, equations_of, poincare_section
from flowlanes.flow.kernel.outcomes import COLLAPSED, NOT_A_NUMBER, OVER, STATUS_MESSAGES, STEPS
from flowlanes.flow.kernel.runge_kutta import runge_kutta_loop
from flowlanes.flow.kernel.tableaux import explicit
from flowlanes.flow.machine_code import jit as native
from flowlanes.flow.machine_code.arithmetic import Double, Pair
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.system import Guard, System
from nonholonomic.catalogue import from_catalogue

# --- how lanes end ----------------------------------------------------------------------------


def test_a_singularity_is_found_and_named() -> None:
    """x = x₀/(1 − x₀ t) ends at 1/x₀; lanes beside it go on."""
    first = np.array([1.0, 2.0, -1.0, 0.5, 8.0])
    flow = batch_integrator(RUNAWAY)
    found = flow.propagate(first[:, None], [0.1, 1.5])
    assert found.outcome.tolist() == [COLLAPSED, COLLAPSED, 0, 0, COLLAPSED]
    np.testing.assert_allclose(found.end_times, [1, 0.5, 1.5, 1.5, 0.125], atol=1e-11)
    np.testing.assert_allclose(found.states[:, 0, 0], first / (1 - 0.1 * first), rtol=1e-12)
    np.testing.assert_allclose(found.states[2:4, 1, 0], [-0.4, 2.0], rtol=1e-11)
    assert np.isnan(found.states[[0, 1, 4], 1]).all()
    assert flow.status_message(COLLAPSED) == STATUS_MESSAGES[COLLAPSED]
    assert flow.status_message(0) == ""


def test_a_state_that_is_no_number() -> None:
    """The logarithm of what has become negative, and starts that are none."""
    first = [[1.0, 0.0], [2.0, 0.0], [-1.0, 0.0], [np.nan, 0.0], [0.0, 0.0]]
    found = batch_integrator(LOGARITHM).propagate(first, [0.25, 1.5])
    assert found.outcome.tolist() == [NOT_A_NUMBER, 0, *[NOT_A_NUMBER] * 3]
    np.testing.assert_allclose(found.end_times, [1, 1.5, 0, 0, 0], atol=1e-11)
    assert np.isnan(found.states[2:]).all()
    right = 2 * np.log(2) - 2 - (0.5 * np.log(0.5) - 0.5)
    assert found.states[1, 1, 1] == pytest.approx(right, abs=1e-12)


def test_a_guard_ends_its_lane_at_its_moment() -> None:
    """The oscillator reaches a fence at a known time; which fence is told."""
    first = [[1.0, 0.0], [0.0, -1.0], [-1.0, 0.0], [0.2, 0.0], [0.0, 3.0], [0.0, 1.0]]
    fences = {"p": 0.5, "q": [9, 9, 9, 9, 2, 1.0001]}
    flow = batch_integrator(FENCED)
    found = flow.propagate(first, [0.2, 3.0], fences)
    left, right = len(STATUS_MESSAGES), len(STATUS_MESSAGES) + 1
    assert found.outcome.tolist() == [left, left, left, 0, right, 0]
    angle = np.arcsin(0.5)
    ends = [np.pi / 2 + angle, angle, 0.0, 3.0, np.arcsin(2 / 3), 3.0]
    np.testing.assert_allclose(found.end_times, ends, atol=1e-11)
    assert np.isfinite(found.states[[0, 1, 3, 4, 5], 0]).all()
    assert np.isnan(found.states[[0, 1, 2, 4], 1]).all()
    assert [flow.status_message(code) for code in (left, right)] == [
        "it went left",
        "it went right",
    ]


def test_a_body_that_leaves_the_plane() -> None:
    """Against the moment at which the reference sees the normal force change its sign."""
    system = replace(from_catalogue("rattleback"), reconstruction=None, observables=())
    states = starts("rattleback", 4) * [30, 30, 30, 1, 1, 1]
    flow = batch_integrator(system, tolerance=1e-14)
    found = flow.propagate(states, [1.0])
    assert {flow.status_message(int(code)) for code in found.outcome} == {system.guards[0].message}
    for start, ended in zip(states, found.end_times, strict=True):
        (message,) = integrate(system, start, [0.0, 1.0]).events
        assert message.guard == system.guards[0]
        assert ended == pytest.approx(message.time, rel=1e-9)


def test_the_largest_number_of_steps(monkeypatch: pytest.MonkeyPatch) -> None:
    """A lane that needs more is given up, at a time that it has reached."""
    flow, first = batch_integrator(OSCILLATOR), [[1.0, 0.0], [0.0, 0.0], [2.0, 1.0]]
    whole = flow.propagate(first, [0.5, 100.0])
    monkeypatch.setattr(lanes_module, "MOST_STEPS", 10)
    found = flow.propagate(first, [0.5, 100.0])
    assert found.outcome.tolist() == [STEPS, 0, STEPS]
    assert found.steps.tolist() == [10, whole.steps[1], 10]
    assert (found.end_times[[0, 2]] > 0.5).all()
    assert (found.end_times[[0, 2]] < 10).all()
    np.testing.assert_array_equal(found.states[:, 0], whole.states[:, 0])


FATES = st.lists(st.integers(0, 11), min_size=1, max_size=40)
EDGE = System(
    name="edge",
    title="All that can happen",
    field={x: y**2 * x**2 - 1 + y**2, y: sp.log(x + 3) - sp.log(x + 3)},
    guards=(Guard("far", 50 - x, "far"),),
)


@settings(max_examples=20)
@given(chosen=FATES)
def test_failing_lanes_do_not_disturb_their_neighbours(chosen: list[int]) -> None:
    """Guards, logarithms of nothing, not-a-number, in any company: the same bits."""
    first = np.array([[a, b] for a in (0.0, -2.9, 1.0, 60.0) for b in (0.0, 1.0, np.nan)])
    flow = batch_integrator(EDGE)
    whole = flow.propagate(first, [0.1, 2.0, 4.0])
    assert set(whole.outcome) == {0, NOT_A_NUMBER, len(STATUS_MESSAGES)}
    part = flow.propagate(first[chosen], [0.1, 2.0, 4.0])
    for mine, all_of_them in zip(vars(part).values(), vars(whole).values(), strict=True):
        if mine is not None:
            assert mine.tobytes() == all_of_them[chosen].tobytes()


# --- crossings of a section -------------------------------------------------------------------


def crossings(direction: int, **options: Any) -> BatchIntegrator:
    cut = Section(x - p / 2, direction)
    return batch_integrator(OSCILLATOR, section=cut, **options)


#: Of x = sin t with x = 1/2: it rises at 30° and falls at 150°.
RISE, FALL, TURN = np.pi / 6, 5 * np.pi / 6, 2 * np.pi


@pytest.mark.parametrize(
    ("direction", "right"),
    [
        (1, [RISE, RISE + TURN, RISE + 2 * TURN]),
        (-1, [FALL, FALL + TURN, FALL + 2 * TURN]),
        (0, [RISE, FALL, RISE + TURN]),
    ],
)
def test_directions(direction: int, right: list[float]) -> None:
    found = crossings(direction).crossings([[0.0, 1.0]], 3)
    np.testing.assert_allclose(found.times[0], right, atol=1e-11)
    assert np.abs(found.states[0, :, 0] - 0.5).max() < 1e-13
    assert found.counts.tolist() == [3]
    assert found.outcome.tolist() == [0]


@pytest.mark.parametrize("direction", [1, -1, 0])
def test_backward_the_same_crossings_come_in_the_other_order(direction: int) -> None:
    """A crossing keeps its direction, which is that of time."""
    ahead = crossings(direction).crossings([[0.0, 1.0]], 3)
    behind = crossings(direction, backward=True).crossings([[0.0, 1.0]], 3, t_end=-100.0)
    right = sorted([RISE - TURN * k for k in range(1, 4)] + [FALL - TURN * k for k in range(1, 4)])
    keep = {1: right[0::2], -1: right[1::2], 0: right}[direction]
    np.testing.assert_allclose(behind.times[0], keep[::-1][:3], atol=1e-11)
    assert (ahead.times > 0).all()
    back = crossings(direction, backward=True).crossings(ahead.states[:, -1], 2)
    np.testing.assert_allclose(back.states[0], ahead.states[0, 1::-1], atol=1e-11)
    np.testing.assert_allclose(back.times[0], ahead.times[0, 1::-1] - ahead.times[0, 2], atol=1e-11)


def test_a_start_on_the_section_is_not_a_crossing() -> None:
    cut = batch_integrator(OSCILLATOR, section=poincare_section(OSCILLATOR, x, direction=0))
    found = cut.crossings([[0.0, 1.0], [0.0, -2.0], [1e-17, 1.0], [-1e-17, 1.0]], 2)
    np.testing.assert_allclose(found.times, [[np.pi, 2 * np.pi]] * 4, atol=1e-11)


def test_crossings_that_count() -> None:
    """Only where y > 0 and the frequency of the lane says so."""
    cut = batch_integrator(OSCILLATOR, section=Section(x, 0, y))
    found = cut.crossings([[0.0, 1.0]] * 2, 2, {"p": [1.0, 4.0]})
    np.testing.assert_allclose(found.times, [[TURN, 2 * TURN], [np.pi, TURN]], atol=1e-11)
    assert (found.states[..., 1] > 0).all()


def test_angles_go_on_beyond_a_turn() -> None:
    """Each whole turn is a crossing, of an angle that is never reduced, both ways."""
    cut = batch_integrator(
        TURNING, section=poincare_section(TURNING, x - y, 1.0, direction=0, angle=True)
    )
    found = cut.crossings([[0.5, 0.5], [1.0, 0.0]], 7, {"p": [2.0, -2.0]})
    angle = found.states[..., 0] - found.states[..., 1] - 1
    turns = angle / TURN
    np.testing.assert_allclose(turns[0], np.arange(7), atol=1e-13)
    np.testing.assert_allclose(turns[1], -np.arange(1, 8), atol=1e-13)
    rising = batch_integrator(
        TURNING, section=poincare_section(TURNING, x, 1.0, direction=1, angle=True)
    )
    found = rising.crossings([[0.5, 0.5]], 2, {"p": -2.0}, t_end=20.0)
    assert found.counts.tolist() == [0]
    assert found.outcome.tolist() == [OVER]


def test_what_is_not_reached() -> None:
    """A section that is not crossed, or only touched, ends with the time."""
    cut = batch_integrator(OSCILLATOR, section=poincare_section(OSCILLATOR, x, 2.0))
    found = cut.crossings([[0.0, 1.0], [2.0, 0.0], [3.0, 0.0], [np.nan, 0.0]], 3, t_end=15.0)
    assert found.counts.tolist() == [0, 0, 2, 0]
    assert found.outcome.tolist() == [OVER, OVER, OVER, NOT_A_NUMBER]
    assert found.end_times.tolist() == [15.0, 15.0, 15.0, 0.0]
    rises = [TURN - np.arccos(2 / 3), 2 * TURN - np.arccos(2 / 3)]
    np.testing.assert_allclose(found.times[2, :2], rises, atol=1e-11)
    assert np.isnan(found.states[2, 2]).all()


def test_deviations_at_crossings() -> None:
    """Of the oscillator they turn with the motion."""
    cut = crossings(1, deviations=1)
    found = cut.crossings([[0.0, 1.0]], 2, deviations=[[[1.0, 0.0]]])
    right = np.stack([np.cos(found.times), -np.sin(found.times)], axis=-1)
    np.testing.assert_allclose(found.deviations[:, :, 0], right, atol=1e-11)


def test_a_pericentre() -> None:
    """The nearest points of a planet: (r, v) rises through zero once in a turn."""
    e = 0.6
    cut = batch_integrator(KEPLER, section=poincare_section(KEPLER, "x*u + y*v"))
    found = cut.crossings([[1 - e, 0, 0, np.sqrt((1 + e) / (1 - e))]], 3)
    np.testing.assert_allclose(found.times[0], TURN * np.arange(1, 4), atol=1e-10)
    assert np.abs(values(KEPLER, ["x*u + y*v"], found.states[0])).max() < 1e-13


@pytest.mark.parametrize("name", ["chaplygin-ball", "unbalanced-ball"])
def test_crossings_of_a_body_against_the_reference(name: str) -> None:
    """Where γ₃ falls through zero on the continuous motion of another integrator."""
    ball = body(name)
    states = starts(name, 12)
    cut = batch_integrator(
        ball, tolerance=1e-14, section=poincare_section(ball, "gamma_3", direction=-1)
    )
    found = cut.crossings(states, 3, t_end=40.0)
    crossed = np.flatnonzero(found.counts == 3)
    assert crossed.size >= 2
    for start, times, points in zip(
        states[crossed], found.times[crossed], found.states[crossed], strict=True
    ):
        assert np.abs(points[:, 5]).max() < 1e-13
        motion = integrate(ball, start, [0.0, times[-1] + 1.0], dense=True)
        np.testing.assert_allclose(times, _falls(motion.dense, times[-1] + 0.01), rtol=1e-12)
        np.testing.assert_allclose(points, motion.dense(times), atol=1e-12)


def _falls(motion: Any, until: float) -> list[float]:
    """Where γ₃ falls through zero."""
    grid = np.linspace(0, until, 2001)
    height = motion(grid)[:, 5]
    places = np.flatnonzero((height[:-1] > 0) & (height[1:] <= 0))
    return [brentq(lambda t: motion(t)[0, 5], grid[i], grid[i + 1], xtol=1e-14) for i in places]


@pytest.mark.parametrize("apart", [1e-2, 1e-3, 1e-4, 1e-5])
@pytest.mark.parametrize("side", [1, -1])
def test_no_pair_of_crossings_is_missed(apart: float, side: int) -> None:
    """Where an oscillation passes a level near its extremum, in turns of the oscillation."""
    turns, half = 5, np.pi * apart
    level = sp.Float(side * np.cos(half), 20)
    flow = batch_integrator(OSCILLATOR, section=Section(x - level, 0), tolerance=1e-11)
    phases = np.linspace(0.3, 5.9, 101) + (0.0 if side > 0 else np.pi)
    first = np.stack([np.cos(phases), np.sin(phases)], axis=1)
    found = flow.crossings(first, 4 * turns, t_end=2 * np.pi * turns)
    assert (found.counts == 2 * turns).all()
    times = found.times[:, : 2 * turns].reshape(101, turns, 2)
    np.testing.assert_allclose(np.diff(times, axis=2), 2 * half, rtol=0.05)


# --- widths, and mistakes in the table --------------------------------------------------------


@pytest.mark.parametrize(
    ("precision", "deviations"),
    [("double", 0), ("double", 1), ("quad", 0), pytest.param("quad", 1, marks=pytest.mark.slow)],
)
def test_bits_do_not_depend_on_the_width(
    monkeypatch: pytest.MonkeyPatch, precision: Any, deviations: int
) -> None:
    """Four, eight or sixteen lanes; with failures among them, at times and on a section."""
    first = np.random.default_rng(6).uniform(0.5, 1.0, (21, 4))
    first[4, 2:] *= 30
    tangent = np.ones((21, deviations, 4)) if deviations else None
    planet = replace(KEPLER, guards=(Guard("near", 10 - x, "it is far"),))
    options = {"tolerance": 1e-12, "precision": precision, "deviations": deviations}
    cut = poincare_section(planet, "x*u + y*v", direction=0)
    found = set()
    for width in (4, 8, 16):
        monkeypatch.setattr(native, "width", lambda width=width: width)
        # past the memory of what has been made
        made = unwrap(batch_integrator)(planet, **options)
        results: list[Any] = [made.propagate(first, [0.5, 1.0], deviations=tangent)]
        if precision == "double":
            crossed = unwrap(batch_integrator)(planet, section=cut, **options)
            results.append(crossed.crossings(first, 1, t_end=3.0, deviations=tangent))
        arrays = [a for result in results for a in vars(result).values() if a is not None]
        found.add(b"".join(a.tobytes() for a in arrays))
        assert set(results[0].outcome) == {0, len(STATUS_MESSAGES)}
    assert len(found) == 1


@pytest.mark.parametrize(("precision", "until"), [("double", 2.0), ("quad", 0.05)])
def test_bits_do_not_depend_on_the_instruction_sets(
    monkeypatch: pytest.MonkeyPatch, precision: Any, until: float
) -> None:
    """As on processors without AVX-512, and without fused operations and AVX."""
    ball, first = body("unbalanced-ball"), starts("unbalanced-ball", 11)
    found, used = set(), set()
    for left_out in ((), ("avx512",), ("avx", "f16c", "fma", "vaes", "vpclmul", "xop")):
        sets = native.instruction_sets(*left_out)
        monkeypatch.setattr(native, "host", lambda sets=sets: sets)
        flow = unwrap(batch_integrator)(ball, precision=precision, tolerance=1e-12)
        found.add(flow.propagate(first, [until]).states.tobytes())
        used.add(sets)
    assert len(found) == 1
    assert len(used) >= 2


def _errors(table: Any, tolerances: Any) -> tuple[Any, Any]:
    """Errors and numbers of steps of the oscillator, by machine code from a table."""
    equations = equations_of(OSCILLATOR, 0, None, False)
    text, room = runge_kutta_loop(Double, table, equations, 4)
    code = native.load_code(text, lambda: (text, room), {"march": SIGNATURE})
    flow = replace(batch_integrator(OSCILLATOR), loop=ProcessorLoop(code))
    found = [replace(flow, tolerance=t).propagate([[0.0, 1.0]], [100.0]) for t in tolerances]
    errors = [abs(f.states[0, 0, 0] - np.sin(100.0)) for f in found]
    return np.array(errors), np.array([f.steps[0] for f in found])


def _order(table: Any) -> float:
    errors, steps = _errors(table, 10.0 ** -np.arange(6, 13))
    return float(-np.polyfit(np.log(steps), np.log(errors), 1)[0])


def test_a_wrong_coefficient_is_noticed() -> None:
    """With one weight or one entry off by a millionth the order is gone."""
    table = explicit()
    assert _order(table) == pytest.approx(8, abs=0.4)
    off = 1 + Fraction(1, 10**6)
    weights = (*table.b[:5], table.b[5] * off, *table.b[6:])
    assert _order(replace(table, b=weights)) < 4
    row = (*table.a[7][:3], table.a[7][3] * off, *table.a[7][4:])
    assert _order(replace(table, a=(*table.a[:7], row, *table.a[8:]))) < 6


def test_text_and_room_grow_with_what_lanes_carry() -> None:
    """Pairs need twice the room of doubles; unused pieces are not written."""
    plain = equations_of(OSCILLATOR, 0, None, False)
    text, room = runge_kutta_loop(Double, explicit(), plain, 4)
    assert "@section" not in text
    assert "@guards" not in text
    fenced, _ = runge_kutta_loop(Double, explicit(), equations_of(FENCED, 0, None, False), 4)
    assert "@guards" in fenced
    _, wide = runge_kutta_loop(Double, explicit(), plain, 8)
    _, pairs = runge_kutta_loop(Pair, explicit(), plain, 4)
    assert wide == 2 * room
    assert room < pairs <= 2 * room


# --- the last digits --------------------------------------------------------------------------


def test_a_fine_tolerance_reaches_the_last_digits() -> None:
    """Beside thirty digits, from sixteen starts: Kepler's problem, whose errors grow."""
    first = np.array([[0.7, 0.1, -0.2, 1 + k / 100] for k in range(16)])
    right, fine, usual = (
        batch_integrator(KEPLER, **options).propagate(first, [40.0]).states[:, 0]
        for options in (
            {"tolerance": 1e-20, "precision": "quad"},
            {"tolerance": 2e-16},
            {"tolerance": 1e-15},
        )
    )
    error, other = (np.sqrt(np.mean((states - right) ** 2)) for states in (fine, usual))
    assert error < 0.1 * other
    assert error < 1e-13


t = sp.Symbol("t", real=True)
SHAKEN = System(name="shaken", title="Shaken", field={x: sp.cos(1000 * t), t: sp.Integer(1)})


def test_the_phase_of_a_clock_is_more_than_its_last_digit() -> None:
    """Its last digit turns the phase at t = 4000 by 4.5e-10."""
    start = np.array([[0.0, 4000.0]])
    found = batch_integrator(SHAKEN, tolerance=2e-16).propagate(start, [2.0, 2.5]).states[0]
    np.testing.assert_array_equal(found[:, 1], [4002.0, 4002.5])
    with mpmath.workdps(30):
        phases = [1000 * (4000 + time) for time in (0.0, 2.0, 2.5)]
        right = [float((mpmath.sin(a) - mpmath.sin(phases[0])) / 1000) for a in phases[1:]]
    np.testing.assert_allclose(found[:, 0], right, atol=2e-16)
