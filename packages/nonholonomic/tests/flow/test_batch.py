"""Lanes: right where the motion is known, the same to the bit in whatever company."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st
from scipy.optimize import brentq
from scipy.special import ellipj

from flow.small import (
    BODIES,
    KEPLER,
    OSCILLATOR,
    TOP,
    TURNING,
    body,
    exactly_on_the_sphere,
    p,
    starts,
    u,
    x,
    y,
)
from flowlanes.errors import InputError
from flowlanes.flow.batch import BatchIntegrator, batch_integrator
from flowlanes.flow.devices.threads import THREADS, available_threads
from flowlanes.flow.integrator import integrate
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.machine_code.double_double_conversion import from_pairs
from flowlanes.formulas.array_evaluation import values
from flowlanes.system.system import Parameter, System

#: Of the rattleback, whose fast rocking has a period of 0.06 s, less is asked.
UNTIL = {"chaplygin-ball": 10.0, "unbalanced-ball": 10.0, "rattleback": 0.5}


def scaled(found: Any, right: Any) -> float:
    """The largest error, relative to the size of each component along the motion."""
    return float(np.max(np.abs(found - right) / np.abs(right).max(axis=0)))


# --- closed forms -----------------------------------------------------------------------------


def test_an_oscillator_with_its_own_frequency_in_each_lane() -> None:
    squares = np.linspace(0.5, 9, 21)
    times = np.linspace(0, 20, 11)
    found = batch_integrator(OSCILLATOR).propagate([[1.0, 0.0]] * 21, times, {"p": squares})
    angles = np.sqrt(squares)[:, None] * times
    np.testing.assert_allclose(found.states[..., 0], np.cos(angles), atol=3e-11)
    assert found.states[:, 0].tolist() == [[1.0, 0.0]] * 21
    assert not found.outcome.any()
    assert found.end_times.tolist() == [20.0] * 21


def test_a_planet() -> None:
    """Kepler's equation, two turns of an orbit with eccentricity 0.6."""
    e, times = 0.6, np.linspace(0.5, 4 * np.pi, 9)
    angles = np.array([brentq(lambda E, t=t: E - e * np.sin(E) - t, 0, 20) for t in times])
    right = np.stack([np.cos(angles) - e, np.sqrt(1 - e * e) * np.sin(angles)], axis=1)
    start = [1 - e, 0, 0, np.sqrt((1 + e) / (1 - e))]
    found = batch_integrator(KEPLER).propagate([start], times)
    np.testing.assert_allclose(found.states[0, :, :2], right, atol=2e-11)
    laws = values(KEPLER, ["energy", "area"], found.states[0])
    assert np.ptp(laws, axis=0).max() < 1e-11


def test_a_free_body() -> None:
    """Euler's elliptic functions; a direction fixed in space keeps its length and (M, γ)."""
    first, second, third = 1.0, 2.0, 4.0
    a, c = 0.7, 1.3
    b = a * np.sqrt(first * (third - first) / (second * (third - second)))
    rate = c * np.sqrt((third - first) * (third - second) / (first * second))
    modulus = (second - first) * a * b / (third * c * rate)
    times = np.linspace(0.5, 30, 13)
    sn, cn, dn, _ = ellipj(rate * times, modulus)
    right = np.stack([first * a * cn, second * b * sn, third * c * dn], axis=1)
    found = batch_integrator(TOP).propagate([[first * a, 0, third * c, 0.6, 0, 0.8]], times)
    np.testing.assert_allclose(found.states[0, :, :3], right, atol=3e-11)
    momentum, direction = found.states[0, :, :3], found.states[0, :, 3:]
    assert np.abs(np.linalg.norm(direction, axis=1) - 1).max() < 1e-11
    area = np.einsum("ti,ti->t", momentum, direction)
    assert np.abs(area - (0.6 * a + 0.8 * third * c)).max() < 1e-11


# --- bodies, against the reference ------------------------------------------------------------


@pytest.mark.parametrize("name", BODIES)
def test_bodies_against_the_reference(name: str) -> None:
    """Another integrator at its best; integrals and relations stay; going back undoes it."""
    system, states, end = body(name), starts(name, 2), UNTIL[name]
    times = np.linspace(end / 4, end, 4)
    found = batch_integrator(system, tolerance=1e-15).propagate(states, times)
    for k in range(2):
        motion = integrate(system, states[k], [0.0, *times], tolerance=1e-15)
        assert scaled(found.states[k], motion.states[1:]) < 2e-12
    laws = [law.value for law in system.integrals]
    kept = values(system, [*laws, *system.relations], np.insert(found.states, 0, states, axis=1))
    assert np.abs(kept - kept[:, :1]).max() < 1e-12 * (1 + np.abs(kept).max())
    back = batch_integrator(system, tolerance=1e-15, backward=True).propagate(
        found.states[:, -1], [-end]
    )
    assert back.end_times.tolist() == [-end] * 2
    assert scaled(back.states[:, 0], states) < 5e-12


@pytest.mark.parametrize(
    "name", ["chaplygin-ball", pytest.param("unbalanced-ball", marks=pytest.mark.slow)]
)
def test_thirty_digits(name: str) -> None:
    """Against 34 digits of the reference, where 16 would leave 1e-16."""
    system, exact = body(name), exactly_on_the_sphere(starts(name, 2))
    with mpmath.workdps(40):
        decimals = {s: mpmath.mpf(repr(value)) for s, value in system.defaults.items()}
    found = batch_integrator(system, tolerance=1e-27, precision="quad").propagate(
        exact, [0.5], decimals
    )
    states = from_pairs(found.states[:, 0], found.rest[:, 0])
    for start, state in zip(exact, states, strict=True):
        motion = integrate(system, start, [0.0, 0.5], precision="quad")
        with mpmath.workdps(40):
            right = [mpmath.mpf(str(c)) for c in motion.states[-1]]
            assert max(abs(c - r) for c, r in zip(state, right, strict=True)) < 1e-25


# --- deviations -------------------------------------------------------------------------------


def test_deviations_of_a_linear_system_are_its_motions() -> None:
    frame = np.broadcast_to(np.eye(2), (5, 2, 2))
    moving = batch_integrator(OSCILLATOR, deviations=2)
    found = moving.propagate(np.ones((5, 2)), [0.7, 3.0], deviations=frame)
    for k, t in enumerate((0.7, 3.0)):
        turned = [[np.cos(t), -np.sin(t)], [np.sin(t), np.cos(t)]]
        np.testing.assert_allclose(found.deviations[:, k], [turned] * 5, atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_deviations_are_derivatives(name: str) -> None:
    """Central differences, whose error falls with the square of the distance."""
    system = replace(body(name), relations=(), laws=())
    state = starts(name, 1)[0]
    direction = np.random.default_rng(3).normal(size=6) * np.linalg.norm(state) / 10
    if name == "rattleback":
        direction[:3] *= 1e-3
    times = [UNTIL[name] / 5]
    tangent = batch_integrator(system, tolerance=1e-15, deviations=1).propagate(
        [state], times, deviations=[[direction]]
    )
    plain = batch_integrator(system, tolerance=1e-15)
    errors = []
    for distance in (2e-2, 1e-2):
        both = plain.propagate([state + distance * direction, state - distance * direction], times)
        difference = (both.states[0, 0] - both.states[1, 0]) / (2 * distance)
        errors.append(difference - tangent.deviations[0, 0, 0])
    assert np.abs(errors[1]).max() < 1e-2 * np.abs(tangent.deviations).max()
    ratio = np.linalg.norm(errors[0]) / np.linalg.norm(errors[1])
    assert ratio == pytest.approx(4, rel=0.05)


def test_deviations_leave_the_motion_alone() -> None:
    system, states = body("unbalanced-ball"), starts("unbalanced-ball", 5)
    alone = batch_integrator(system).propagate(states, [5.0])
    along = batch_integrator(system, deviations=1).propagate(
        states, [5.0], deviations=np.ones((5, 1, 6))
    )
    np.testing.assert_allclose(along.states, alone.states, atol=1e-11)


# --- the same to the bit ----------------------------------------------------------------------

BALL = body("chaplygin-ball")
STATES = starts("chaplygin-ball", 40, seed=1)
MASSES = np.random.default_rng(2).uniform(0.5, 2, 40)
COMPANY = st.lists(st.integers(0, 39), min_size=1, max_size=150)
DRAWN = settings(max_examples=15)


@pytest.fixture(scope="module")
def flow() -> BatchIntegrator:
    return batch_integrator(BALL)


@pytest.fixture(scope="module")
def crossing() -> BatchIntegrator:
    return batch_integrator(BALL, section=poincare_section(BALL, "gamma_3", direction=0))


def _bytes(found: Any, chosen: Any = slice(None)) -> list[bytes]:
    """All that was found, to the bit."""
    arrays = (a for a in vars(found).values() if a is not None)
    return [np.ascontiguousarray(a[chosen]).tobytes() for a in arrays]


@DRAWN
@given(chosen=COMPANY, threads=st.sampled_from([1, 2, 5]))
def test_bits_do_not_depend_on_the_company(
    flow: BatchIntegrator, chosen: list[int], threads: int
) -> None:
    """Nor on order, number, or threads."""
    whole = flow.propagate(STATES, [1.0, 4.0], {"m": MASSES}, threads=1)
    part = flow.propagate(STATES[chosen], [1.0, 4.0], {"m": MASSES[chosen]}, threads=threads)
    assert _bytes(part) == _bytes(whole, chosen)


@DRAWN
@given(chosen=COMPANY, threads=st.sampled_from([1, 2, 5]))
def test_bits_of_crossings(crossing: BatchIntegrator, chosen: list[int], threads: int) -> None:
    whole = crossing.crossings(STATES, 4, {"m": MASSES}, t_end=30.0, threads=1)
    part = crossing.crossings(STATES[chosen], 4, {"m": MASSES[chosen]}, t_end=30.0, threads=threads)
    assert _bytes(part) == _bytes(whole, chosen)


def test_bits_of_deviations_and_of_thirty_digits() -> None:
    turns = [7, 3, 3, 39, 0, *range(39, -1, -1)] * 2
    tangent = np.random.default_rng(4).normal(size=(40, 1, 6))
    moving, fine = (
        batch_integrator(BALL, deviations=1),
        batch_integrator(BALL, tolerance=1e-16, precision="quad"),
    )
    whole = moving.propagate(STATES, [2.0], deviations=tangent, threads=1)
    part = moving.propagate(STATES[turns], [2.0], deviations=tangent[turns], threads=3)
    assert _bytes(part) == _bytes(whole, turns)
    whole, part = fine.propagate(STATES, [0.3], threads=1), fine.propagate(STATES[turns], [0.3])
    assert _bytes(part) == _bytes(whole, turns)


def test_one_value_for_all_is_the_same_as_one_for_each(flow: BatchIntegrator) -> None:
    one = flow.propagate(STATES, [2.0], {"m": 1.7})
    each = flow.propagate(STATES, [2.0], {sp.Symbol("m"): np.full(40, 1.7)})
    assert _bytes(one) == _bytes(each)
    assert _bytes(flow.propagate(STATES, [2.0], BALL.defaults)) == _bytes(
        flow.propagate(STATES, [2.0])
    )


def test_every_start_is_held_against_the_size_of_its_relations(flow: BatchIntegrator) -> None:
    """A fast motion excuses nothing; what is no number but stands in no relation ends a lane."""
    near = [[1e6, 0, 0, 0, 0, 1 + 1e-10], [0, 0, 1, 0, 0, 1 - 1e-10]]
    assert not flow.propagate(near, [1e-9]).outcome.any()
    away = np.array([[0, 0, 1, 0, 0, 1], [1e6, 0, 0, 0, 0, 1 + 1e-8]])
    with pytest.raises(InputError, match="start 1 misses the phase space"):
        flow.propagate(away, [1e-9])
    found = flow.propagate([[np.nan, 0, 0, 0, 0, 1], [0, 0, 1, 0, 0, 1]], [1.0])
    assert found.outcome.tolist() == [2, 0]


def test_no_motions_are_no_error(flow: BatchIntegrator, crossing: BatchIntegrator) -> None:
    assert flow.propagate(np.zeros((0, 6)), [1.0, 2.0]).states.shape == (0, 2, 6)
    assert crossing.crossings(np.zeros((0, 6)), 3).times.shape == (0, 3)


def test_threads_are_limited_by_who_runs_several_parts() -> None:
    usual = available_threads()
    assert usual >= 1
    token = THREADS.set(1)
    try:
        assert available_threads() == 1
    finally:
        THREADS.reset(token)
    assert available_threads() == usual


# --- mistakes ---------------------------------------------------------------------------------

UNKNOWN = System(name="unknown", title="Unknown", field={x: sp.gamma(x)})
PIECES = System(name="pieces", title="Pieces", field={x: sp.Piecewise((x, x > 0), (-x, True))})
STILL = System(name="still", title="Still", field={}, parameters=(Parameter(p, "p", 1.0),))
OFF = [[0, 0, 1, 0, 0, 1.0], [0, 0, 1, 0, 0.1, 1]]


def free(**options: Any) -> BatchIntegrator:
    return batch_integrator(OSCILLATOR, **options)


def cut() -> BatchIntegrator:
    return batch_integrator(OSCILLATOR, section=poincare_section(OSCILLATOR, x))


MISTAKES: dict[str, tuple[Any, str]] = {
    "shape of starts": (
        lambda: free().propagate([[1, 2, 3]], [1.0]),
        "oscillator: starts have the shape (1, 3); (motions, 2) is needed, in the order x, y",
    ),
    "one start without its row": (
        lambda: free().propagate([1, 2], [1.0]),
        "oscillator: starts have the shape (2,); (motions, 2) is needed, in the order x, y",
    ),
    "rows of two lengths": (
        lambda: free().propagate([[1, 2], [1]], [1.0]),
        "BatchIntegrator.propagate: starts must be numbers in an array or in nested sequences, not "
        "[[1, 2], [1]]",
    ),
    "words": (
        lambda: free(precision="quad").propagate([["1", "east"]], [1.0]),
        "BatchIntegrator.propagate: starts must be numbers in an array or in nested sequences, not "
        "[['1', 'east']]",
    ),
    "off the phase space": (
        lambda: batch_integrator(BALL).propagate(OFF, [1.0]),
        "chaplygin-ball: start 1 misses the phase space; Dot(gamma, gamma) - 1 is 0.01 there and "
        "must vanish",
    ),
    "a start that is no number": (
        lambda: batch_integrator(BALL).propagate([OFF[0], [np.nan] * 6], [1.0]),
        "chaplygin-ball: start 1 has M_1 = nan, which must be finite",
    ),
    "unknown parameter": (
        lambda: free().propagate([[1, 2]], [1.0], {"k": 1}),
        "oscillator: no parameter k; it has p",
    ),
    "parameter of one lane": (
        lambda: free().propagate([[1, 2]] * 3, [1.0], {"p": [1.0, 2.0, -2.5]}),
        "oscillator: p = -2.5 is not admissible; p > 0 must hold",
    ),
    "too few parameters": (
        lambda: free().propagate([[1, 2]] * 3, [1.0], {p: [1.0, 2.0]}),
        "oscillator: p has the shape (2,); it must be one number or 3, one for each motion",
    ),
    "parameter that is no number": (
        lambda: free().propagate([[1, 2]], [1.0], {p: np.nan}),
        "oscillator: p must be finite numbers",
    ),
    "parameter that is a word": (
        lambda: free().propagate([[1, 2]], [1.0], {p: "much"}),
        "BatchIntegrator.propagate: parameters must be a mapping of parameters to numbers, not "
        "{p: 'much'}",
    ),
    "times that fall": (
        lambda: free().propagate([[1, 2]], [1.0, 0.5]),
        "times: they must increase from 0, where the motion begins",
    ),
    "times before the start": (
        lambda: free().propagate([[1, 2]], [-1.0]),
        "times: they must increase from 0, where the motion begins",
    ),
    "times that rise backward": (
        lambda: free(backward=True).propagate([[1, 2]], [1.0]),
        "times: they must decrease from 0, where the motion begins",
    ),
    "times that are no numbers": (
        lambda: free().propagate([[1, 2]], [1.0, np.nan]),
        "times: there must be a row of at least one, and all finite numbers",
    ),
    "no times": (
        lambda: free().propagate([[1, 2]], []),
        "times: there must be a row of at least one, and all finite numbers",
    ),
    "tolerance too small": (
        lambda: free(tolerance=1e-17),
        "tolerance 1e-17: it must lie between 1e-16 and 0.1",
    ),
    "tolerance too large": (
        lambda: free(tolerance=0.5),
        "tolerance 0.5: it must lie between 1e-16 and 0.1",
    ),
    "tolerance of thirty digits": (
        lambda: free(tolerance=1e-31, precision="quad"),
        "tolerance 1e-31: it must lie between 1e-30 and 0.1",
    ),
    "tolerance that is no number": (
        lambda: free(tolerance=float("nan")),
        "tolerance nan: it must lie between 1e-16 and 0.1",
    ),
    "precision": (
        lambda: free(precision="half"),
        "batch_integrator: precision must be 'double' or 'quad', not the text 'half'",
    ),
    "section to thirty digits": (
        lambda: free(precision="quad", section=poincare_section(OSCILLATOR, x)),
        "oscillator: a section is found in double precision; leave 'precision' at that",
    ),
    "fewer than no deviations": (
        lambda: free(deviations=-1),
        "deviations = -1: there cannot be fewer than none",
    ),
    "deviations that are not carried": (
        lambda: free().propagate([[1, 2]], [1.0], deviations=[[[1, 2]]]),
        "this integrator carries no deviations; pass deviations=… to batch_integrator",
    ),
    "shape of deviations": (
        lambda: free(deviations=1).propagate([[1, 2]], [1.0], deviations=[[1, 2]]),
        "deviations have the shape (1, 2); (1, 1, 2) is needed",
    ),
    "returns without a section": (
        lambda: free().crossings([[1, 2]], 1),
        "this integrator was built without a section; pass section=… to batch_integrator",
    ),
    "times with a section": (
        lambda: cut().propagate([[1, 2]], [1.0]),
        "this integrator was built for a section: call crossings instead of propagate",
    ),
    "no crossing": (
        lambda: cut().crossings([[1, 2]], 0),
        "count = 0: it must be a whole number, at least 1",
    ),
    "until before the start": (
        lambda: cut().crossings([[1, 2]], 1, t_end=-1.0),
        "t_end = -1.0: it must lie ahead of the start, at time 0",
    ),
    "unknown function": (
        lambda: batch_integrator(UNKNOWN),
        "gamma(x): the machine code has no function gamma",
    ),
    "choice": (
        lambda: batch_integrator(PIECES),
        "Piecewise((x, x > 0), (-x, True)): the machine code has no function Piecewise",
    ),
    "system without state": (
        lambda: batch_integrator(STILL),
        "still: a system without state has no motion",
    ),
    "section of a foreign symbol": (
        lambda: poincare_section(OSCILLATOR, u - y),
        "u: neither a state variable, a definition nor a parameter",
    ),
    "section at no number": (
        lambda: poincare_section(TURNING, x, float("nan")),
        "value = nan: it must be a finite number",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_give_one_sentence(name: str) -> None:
    attempt, sentence = MISTAKES[name]
    with pytest.raises(InputError) as caught:
        attempt()
    assert str(caught.value) == sentence


def test_deviations_are_needed_where_they_are_carried() -> None:
    with pytest.raises(InputError, match="deviations"):
        free(deviations=1).propagate([[1, 2]], [1.0])
