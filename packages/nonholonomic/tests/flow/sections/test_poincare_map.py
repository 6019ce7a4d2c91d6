"""A section as a map: against Taylor integration, its derivative, its inverse, slabs."""

from __future__ import annotations

import pickle
from functools import cache
from typing import Any

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.batch_results import BatchCrossings
from flowlanes.flow.kernel.equations import Section, poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap, slab
from flowlanes.formulas.array_formulas import Formulas
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import to_components
from needs import optional
from nonholonomic.catalogue import entry
from nonholonomic.starts import initial_state

BODIES = ("chaplygin-ball", "unbalanced-ball", "rattleback")

x, v = sp.symbols("x v", real=True)
omega = sp.Symbol("omega", positive=True)


@cache
def body(name: str) -> System:
    return entry(name).system({})


@cache
def starts(name: str) -> Any:
    """Three states on the phase space of a body, on no level in particular."""
    random = np.random.default_rng(7)
    system, found = body(name), []
    for _ in range(3):
        gamma = random.normal(size=3)
        gamma /= np.linalg.norm(gamma)
        state = initial_state(system, random.normal(size=3), gamma)
        found.append([float(value) for value in state[: len(system.symbols)]])
    return np.array(found)


def map_of(name: str, **options: Any) -> PoincareMap:
    return PoincareMap(body(name), poincare_section(body(name), "gamma_3"), **options)


def test_a_pendulum_returns_after_its_period() -> None:
    oscillator = System(
        name="oscillator",
        title="Oscillator",
        field={x: v, v: -(omega**2) * x},
        parameters=(Parameter(omega, "frequency", 1.0),),
    )
    back = PoincareMap(oscillator, Section(x), {"omega": np.array([1.0, 2.0, 3.0])})
    points = np.array([[0.0, 1.0], [0.0, 0.3], [0.0, 5.0]])
    crossed = back.crossings(points, 3)
    assert np.abs(crossed.times - np.outer(2 * np.pi / np.arange(1, 4), [1, 2, 3])).max() < 1e-11
    assert np.abs(crossed.states - points[:, None]).max() < 1e-11
    assert np.abs(PoincareMap(oscillator, Section(x, 0))(points[0]) + points[0]).max() < 1e-11
    angle = poincare_section(oscillator, sp.atan2(x, v), 0.5, angle=True)
    (turned,) = PoincareMap(oscillator, angle)(np.array([[0.0, 1.0]]))
    assert np.allclose(turned, [np.sin(0.5), np.cos(0.5)], atol=1e-12)


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_points_are_those_of_taylor_integration(name: str) -> None:
    back = map_of(name, tolerance=1e-15)
    points = back.crossings(starts(name), 6)
    assert (points.counts == 6).all()
    # errors grow along a motion as its derivative does
    growth = np.abs(back.derivative(starts(name), 6).matrices).max(axis=(1, 2))
    for i, start in enumerate(starts(name)):
        expected, moments = crossings(name, start, 6)
        assert np.abs(points.states[i] - expected).max() < 3e-14 * max(1.0, growth[i])
        assert np.abs(points.times[i] - moments).max() < 3e-14 * max(1.0, growth[i]) * moments[-1]
    assert np.abs(back.residual(points.states)).max() < 1e-20


@cache
def integrator(name: str) -> tuple[Any, list[Any]]:
    """Taylor integration with an event where γ₃ rises through zero."""
    hy = optional("heyoka")
    from flowlanes.flow.taylor.heyoka_expressions import Translator

    system = body(name)
    translate, found = Translator(system), []

    def note(adaptive: Any, time: float, _: int) -> None:
        adaptive.update_d_output(time)
        found.append((time, adaptive.d_output.copy()))

    (value,) = translate.all([to_components(poincare_section(system, "gamma_3").value)])
    event = hy.nt_event(value, note, direction=hy.event_direction.positive)
    rates = list(zip(translate.variables, translate.all(system.rates), strict=True))
    numbers = [float(n) for n in system.defaults.values()]
    made = hy.taylor_adaptive(
        rates, [1.0] * 6, pars=numbers, nt_events=[event], tol=1e-15, compact_mode=True
    )
    return made, found


def crossings(name: str, start: Any, count: int) -> tuple[Any, Any]:
    adaptive, found = integrator(name)
    found.clear()
    adaptive.time = 0.0
    adaptive.state[:] = start
    while len(found) < count:
        adaptive.propagate_for(1.0)
    times, states = zip(*found[:count], strict=True)
    return np.array(states), np.array(times)


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_the_inverse_leads_back(name: str) -> None:
    back = map_of(name)
    first = back(starts(name))
    third = back.iterate(first, 3)
    assert np.abs(third - back(back(back(first)))).max() < 1e-11 * _growth(back, first, 3)
    growth = _growth(back.inverse, third, 3)
    assert np.abs(back.inverse(back.inverse(back.inverse(third))) - first).max() < 1e-11 * growth
    assert np.abs(back.iterate(third, -3) - first).max() < 1e-11 * growth
    assert np.array_equal(back.iterate(first, 0), first)
    assert (back.inverse.crossings(first, 2).times < 0).all()


def _growth(back: PoincareMap, points: Any, count: int) -> float:
    """By how much errors grow at most."""
    return float(np.abs(back.derivative(points, count).matrices).max())


@pytest.mark.slow
@pytest.mark.parametrize("name", BODIES)
def test_the_derivative_is_a_difference(name: str) -> None:
    system, back = body(name), map_of(name, tolerance=1e-15)
    # a long way to the section leaves differences few digits
    soon = back.crossings(starts(name), 1).times[:, 0] < 10.0
    assert soon.sum() >= 2
    points = starts(name)[soon]
    made = back.derivative(points)
    assert np.abs(made.images - back(points)).max() < 1e-12
    assert np.abs(made.times - back.crossings(points, 1).times[:, 0]).max() < 1e-12
    random = np.random.default_rng(3)
    step = 1e-7
    normal = points[:, 3:]
    for _ in range(3):
        # deviations that keep the length of gamma, to second order
        deviation = random.normal(size=points.shape)
        deviation[:, 3:] -= np.einsum("ni,ni->n", normal, deviation[:, 3:])[:, None] * normal
        ahead, behind = (_moved(back, points + h * deviation) for h in (step, -step))
        change = (ahead.states[:, 0] - behind.states[:, 0]) / (2 * step)
        delay = (ahead.times[:, 0] - behind.times[:, 0]) / (2 * step)
        expected = np.einsum("nij,nj->ni", made.matrices, deviation)
        assert np.abs(change - expected).max() < 1e-6 * np.abs(made.matrices).max()
        slope = np.einsum("nj,nj->n", made.time_slopes, deviation)
        assert np.abs(delay - slope).max() < 1e-6 * np.abs(made.time_slopes).max()
    # images stay on the section, the length of gamma is kept, and the flow is annulled
    kept = Formulas(system, (back.section.value, to_components(system.relations[0])))
    held = kept.slopes(points)
    held[:, 0] = 0.0
    size = np.abs(made.matrices).max()
    assert np.abs(kept.slopes(made.images) @ made.matrices - held).max() < 1e-12 * size
    rates = Formulas(system, system.rates)(points)
    assert np.abs(np.einsum("nij,nj->ni", made.matrices, rates)).max() < 1e-12 * size**2


def _moved(back: PoincareMap, points: Any) -> BatchCrossings:
    """The first returns of points that are put back on the phase space."""
    points[:, 3:] /= np.linalg.norm(points[:, 3:], axis=1, keepdims=True)
    return back.crossings(points, 1)


def test_the_dimension_counts_what_is_kept() -> None:
    back = map_of("unbalanced-ball")
    (point, *_) = back(starts("unbalanced-ball"))
    assert back.dimension(point) == 2
    assert back.dimension(point, integrals=False) == 4


def test_a_section_of_the_section() -> None:
    back = map_of("unbalanced-ball", t_end=1e4)
    (start, *_) = back(starts("unbalanced-ball"))
    first, second = to_components(back.system.state[1])[0], to_components(back.system.state[0])[1]
    thin = back.within(second, 0.2)
    every = back.crossings(start[None], 400).states[0]
    near = every[np.abs(every[:, 1]) < 0.2]
    assert 10 < len(near) < 100
    assert np.array_equal(thin.crossings(start[None], len(near)).states[0], near)
    thinner = thin.within(first, 0.5)
    both = near[np.abs(near[:, 3]) < 0.5]
    assert 1 < len(both) < len(near)
    assert np.array_equal(thinner.crossings(start[None], len(both)).states[0], both)
    with pytest.raises(InputError, match="must be positive"):
        slab(back.section, first, 0.0)


@pytest.mark.slow
def test_what_does_not_return_is_told() -> None:
    back = map_of("unbalanced-ball", t_end=1e-3)
    image = back(starts("unbalanced-ball"))
    assert np.isnan(image).all()
    crossed = back.crossings(starts("unbalanced-ball"), 1)
    assert {back.status_message(code) for code in crossed.outcome} == {"the time limit was reached"}
    assert np.isnan(back.derivative(starts("unbalanced-ball")).matrices).all()


def test_it_travels_to_other_processes() -> None:
    back = map_of("unbalanced-ball")
    image = back.derivative(starts("unbalanced-ball"))
    again = pickle.loads(pickle.dumps(back)).derivative(starts("unbalanced-ball"))
    assert np.array_equal(image.matrices, again.matrices)


@pytest.mark.parametrize(
    ("points", "sentence"),
    [(np.zeros((2, 5)), r"the shape \(2, 5\)"), (np.zeros(6), r"the shape \(6,\)")],
)
def test_points_of_a_wrong_shape_are_refused(points: Any, sentence: str) -> None:
    with pytest.raises(InputError, match=sentence):
        map_of("unbalanced-ball").crossings(points, 1)
    with pytest.raises(InputError, match="one at least"):
        map_of("unbalanced-ball").derivative(np.zeros((1, 6)), 0)
