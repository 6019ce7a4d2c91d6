"""One motion, advanced from call to call."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes import InputError, Integral, Parameter, RunError, System, batch_integrator
from flowlanes.flow.stepping import stepper

x, v, f, k = sp.symbols("x v f k", real=True)
OSCILLATOR = System(
    "oscillator",
    "Oscillator",
    {x: v, v: -k * x + f},
    parameters=(Parameter(k, "stiffness", 1.0), Parameter(f, "force", 0.0)),
)
CIRCLE = System("circle", "Circle", {x: -v, v: x}, relations=(x**2 + v**2 - 1,))
EXPLOSION = System("explosion", "Explosion", {x: x**2})


def test_it_is_the_batch_integrator_bit_for_bit() -> None:
    step = stepper(OSCILLATOR)
    motions = batch_integrator(OSCILLATOR).propagate([[0.3, -0.2]], [0.7])
    assert (step([0.3, -0.2], 0.7) == motions.states[0, 0]).all()


def test_inputs_act_during_their_call_alone() -> None:
    step = stepper(OSCILLATOR, inputs=["f"], parameters={"k": 4.0})
    state = step(step([0.0, 0.0], 0.5, [2.0]), 0.25, [0.0])
    w = 2.0
    pushed = np.array([0.5 * (1 - np.cos(w * 0.5)), 0.5 * w * np.sin(w * 0.5)])
    c, s = np.cos(w * 0.25), np.sin(w * 0.25)
    free = [pushed[0] * c + pushed[1] * s / w, -pushed[0] * w * s + pushed[1] * c]
    assert state == pytest.approx(free, abs=1e-12)


def test_back_to_the_start() -> None:
    step = stepper(OSCILLATOR)
    assert step(step([1.0, 0.5], 2.0), -2.0) == pytest.approx([1.0, 0.5], abs=1e-12)


def test_a_state_of_the_caller_is_checked() -> None:
    step = stepper(CIRCLE)
    state = step([1.0, 0.0], 0.1)
    assert step(state, 0.1) == pytest.approx([np.cos(0.2), np.sin(0.2)], abs=1e-12)
    with pytest.raises(InputError, match="misses the phase space"):
        step([2.0, 0.0], 0.1)
    with pytest.raises(ValueError, match="read-only"):
        state[0] = 2.0


def test_a_motion_that_ends_says_when_and_another_can_follow() -> None:
    step = stepper(EXPLOSION)
    with pytest.raises(RunError) as end:
        step([1.0], 2.0)
    assert end.value.time == pytest.approx(1.0, abs=1e-3)
    assert step([1.0], 0.5) == pytest.approx([2.0], abs=1e-11)


@pytest.mark.parametrize(
    ("inputs", "words"),
    [
        (["g"], "has no parameter 'g'; it has k, f"),
        (["f", "f"], "a name occurs twice"),
    ],
)
def test_inputs_are_parameters(inputs: list[str], words: str) -> None:
    with pytest.raises(InputError, match=words):
        stepper(OSCILLATOR, inputs=inputs)


def test_inputs_are_counted() -> None:
    with pytest.raises(InputError, match=r"1 are given, and the stepper has 2 \(k, f\)"):
        stepper(OSCILLATOR, inputs=["k", "f"])([0.0, 0.0], 0.1, [1.0])


def test_inputs_may_be_an_array() -> None:
    step = stepper(OSCILLATOR, inputs=["k", "f"])
    assert (step([0.1, 0.0], 0.1, np.array([2.0, 1.0])) == step([0.1, 0.0], 0.1, [2.0, 1.0])).all()


def test_a_duration_is_finite() -> None:
    with pytest.raises(InputError, match="duration = inf"):
        stepper(OSCILLATOR)([0.1, 0.0], float("inf"))


def test_states_of_another_size_are_refused() -> None:
    with pytest.raises(InputError):
        stepper(OSCILLATOR)([0.0], 0.1)


def test_an_invariant_survives_many_calls() -> None:
    energy = Integral("energy", v**2 / 2 + x**2 / 2)
    step = stepper(System("free", "Free", {x: v, v: -x}, laws=(energy,)))
    state = np.array([1.0, 0.0])
    for _ in range(1000):
        state = step(state, 1e-2)
    assert (state @ state) / 2 == pytest.approx(0.5, abs=1e-13)
