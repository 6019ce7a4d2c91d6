"""All motions have one grammar, whoever computed them."""

from __future__ import annotations

import pickle
from collections.abc import Callable

import numpy as np
import pytest

import chaplygin as ch
import nonholonomic
from flowlanes.flow import Motion
from nonholonomic.contact import Coulomb, FrictionalContact, contact_motion
from nonholonomic.control import (
    Rotor,
    SphericalRobot,
    driven_system,
    figure_of_eight,
    motion_along,
)

TIMES = [0.0, 0.5, 1.0]
TURN = {"omega": (1, 0, 2), "gamma": (0, 0, 1)}


def _integrated(**options: object) -> Motion:
    return ch.integrate(ch.from_catalogue("chaplygin-ball"), TURN, TIMES, **options)  # type: ignore[arg-type]


def _closed() -> Motion:
    disk = nonholonomic.CATALOGUE["rubber-disk"]
    return ch.solve(ch.from_catalogue("rubber-disk"), disk.start.values)(TIMES)


def _with_friction() -> Motion:
    ball = ch.Body(0.2, (2e-4, 2e-4, 2e-4), ch.Ball(0.05))
    table = FrictionalContact(ball, laws=(Coulomb(0.2),), field=ch.Forces(gravity=9.81))
    start = [1, 0, 0, 0, 0, 0, 0.05, 1.4, 0, 0, 0, 0, 0, 0, 0, 1]
    return contact_motion(table, start, TIMES)


def _experiment_with_friction() -> Motion:
    text = """
    body = {mass = 0.2, inertia = [2e-4, 2e-4, 2e-4], shape = {kind = "ball", radius = 0.05}}
    contact = {model = "friction", mu = 0.2}
    field = {gravity = 9.81}
    run = {until = 1.0, samples = 3}
    [start]
    position = [0, 0, 0.05]
    attitude = [1, 0, 0, 0]
    velocity = [1, 0, 0]
    omega = [0, 0, 0]
    """
    return ch.Study.from_experiment(ch.parse_experiment(text)).trajectory()


def _driven() -> Motion:
    robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((0, 0, 1), 0.1),))
    system = driven_system(robot, {"u_1": "2*cos(t)"})
    return ch.integrate(system, ch.initial_state(system, (1, 0, 3), (0, 0, 1)), TIMES)


def _planned() -> Motion:
    rotors = Rotor((1, 0, 0), 0.1), Rotor((0, 1, 0), 0.1)
    robot = SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, rotors)
    eight = figure_of_eight(0.8, 0.4, 8.0)
    return motion_along(robot, eight, intervals=8, stages=3, iterations=1)


def _mechanism() -> Motion:
    sleigh = ch.from_catalogue("chaplygin-sleigh")
    return ch.integrate(sleigh, nonholonomic.CATALOGUE["chaplygin-sleigh"].start.values, TIMES)


#: How to compute a motion of each kind, and a quantity that it has.
KINDS: dict[str, tuple[Callable[[], Motion], str]] = {
    "taylor": (_integrated, "omega"),
    "taylor, dense": (lambda: _integrated(dense=True), "omega"),
    "gauss": (lambda: _integrated(method="gauss"), "omega"),
    "closed form": (_closed, "omega"),
    "friction": (_with_friction, "omega"),
    "experiment with friction": (_experiment_with_friction, "omega"),
    "driven ball": (_driven, "M"),
    "plan": (_planned, "centre"),
    "mechanism": (_mechanism, "Omega"),
}
CONTINUOUS = ("taylor, dense", "closed form")


@pytest.mark.parametrize("kind", KINDS)
def test_a_motion_has_the_grammar_of_all_motions(kind: str) -> None:
    compute, quantity = KINDS[kind]
    motion = compute()
    assert isinstance(motion, Motion)
    n = len(motion.times)
    assert motion.states.ndim == 2
    assert len(motion.states) == n > 2
    names = list(motion)
    assert len(set(names)) == len(names)
    for name in names:
        assert len(motion[name]) == n
        assert name in motion
        with pytest.raises(ValueError, match="read-only"):
            motion[name][0] = 0.0
    for array in (motion.times, motion.states):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 0.0
    assert quantity in names
    assert "speed of light" not in motion
    with pytest.raises(ch.InputError, match="no quantity 'speed of light'"):
        motion["speed of light"]
    dataset = motion.to_dataset()
    assert dataset.sizes["time"] == n
    np.testing.assert_array_equal(dataset[quantity].values, motion[quantity])
    text = repr(motion)
    assert len(text.splitlines()) <= 24
    assert max(map(len, text.splitlines())) <= 80


@pytest.mark.parametrize("kind", KINDS)
def test_a_motion_is_called_with_times_where_it_is_continuous(kind: str) -> None:
    compute, quantity = KINDS[kind]
    motion = compute()
    if kind not in CONTINUOUS:
        with pytest.raises(ch.InputError, match="known at its samples alone"):
            motion(0.25)
        return
    between = motion(motion.times)
    assert isinstance(between, Motion)
    np.testing.assert_allclose(between.states, motion.states, atol=1e-13)
    np.testing.assert_allclose(between[quantity], motion[quantity], atol=1e-13)
    assert between(0.25)[quantity].shape[0] == 1


@pytest.mark.parametrize("kind", sorted({*KINDS} - {"closed form"}))
def test_a_motion_can_be_pickled(kind: str) -> None:
    motion = KINDS[kind][0]()
    again = pickle.loads(pickle.dumps(motion))
    assert list(again) == list(motion)
    for name in motion:
        np.testing.assert_array_equal(again[name], motion[name])
        assert not again[name].flags.writeable
    assert again.to_dataset().identical(motion.to_dataset())


def test_a_closed_form_says_how_to_keep_it() -> None:
    with pytest.raises(TypeError, match="to_dataset"):
        pickle.dumps(_closed())
