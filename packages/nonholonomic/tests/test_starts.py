"""One function gives the start of every model."""

from __future__ import annotations

from typing import Any

import mpmath
import numpy as np
import pytest

import flowlanes
import nonholonomic
from flowlanes.errors import InputError
from nonholonomic.contact import Coulomb, FrictionalContact, contact_motion
from nonholonomic.control import Rotor, SphericalRobot, driven_system
from nonholonomic.mechanics.ball import SphericalSurface
from nonholonomic.starts import initial_state

BODY = nonholonomic.Body(1.0, (0.4, 0.5, 0.6), nonholonomic.Ball(1.0))
ROLLING = nonholonomic.RollingBody(BODY)
SLIDING = FrictionalContact(BODY, laws=(Coulomb(0.2),))
CARRIED = nonholonomic.RollingBall(
    mass=1.0, inertia=0.1, radius=0.5, surface=SphericalSurface(2.0), contact="marble"
)
DRIVEN = driven_system(
    SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, (Rotor((0, 0, 1), 0.1),)), {"u_1": "2*cos(t)"}
)
SUSLOV = nonholonomic.CATALOGUE["suslov-nd"].system({"dimension": 4})
PLACED = {"position": (0, 0, 3), "attitude": (1, 0, 0, 0), "velocity": (1, 0, 0)}

#: Models, what is known of their starts, and the first numbers of the states.
KNOWN: dict[str, tuple[Any, dict[str, Any], list[float]]] = {
    "a rolling body": (ROLLING, {"omega": (1, 0, 2), "gamma": (0, 0, 3)}, [1.4, 0.0, 1.2, 0.0]),
    "its system": (
        ROLLING.system(),
        {"omega": (1, 0, 2), "gamma": (0, 0, 3), "heading": 0.5},
        [1.4, 0.0, 1.2, 0.0],
    ),
    "by name": (
        ROLLING.system(),
        {"M": (1.4, 0, 1.2), "gamma": (0, 0, 1)},
        [1.4, 0.0, 1.2, 0.0, 0.0, 1.0, 1.0, 0.0],
    ),
    "a homogeneous ball": (
        CARRIED,
        {"omega": (1, 0, 0), "place": (0, 0, 2)},
        [0.0, 0.0, 2.5, 1.0],
    ),
    "a ball that slips": (
        SLIDING,
        {"omega": (0, 1, 0), "gamma": (0, 0, 1), "slip": (2, 0, 0)},
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 3.0],
    ),
    "a ball in the air": (
        SLIDING,
        {**PLACED, "omega": (0, 0, 2)},
        [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.0, 1.0],
    ),
    "a driven ball": (DRIVEN, {"omega": (1, 0, 3), "gamma": (0, 0, 1)}, [1.4, 0.0, 2.0, 0.0]),
    "a mechanism": (
        nonholonomic.from_catalogue("chaplygin-sleigh"),
        dict(nonholonomic.CATALOGUE["chaplygin-sleigh"].start.values),
        list(nonholonomic.CATALOGUE["chaplygin-sleigh"].start.values.values())[:1],
    ),
    "a body in four dimensions": (
        SUSLOV,
        {"omega": (0, 0, 1, 0, 2, 3), "gamma": (0, 0, 0, 1)},
        [1.0, 2.0, 3.0],
    ),
}


@pytest.mark.parametrize("name", KNOWN)
def test_every_model_gives_a_state_of_one_kind(name: str) -> None:
    model, known, first = KNOWN[name]
    state = initial_state(model, **known)
    assert isinstance(state, tuple)
    assert all(isinstance(number, mpmath.mpf) for number in state)
    assert np.allclose(np.array(state[: len(first)], dtype=float), first, rtol=0, atol=1e-12)


@pytest.mark.parametrize("name", KNOWN)
def test_a_motion_begins_there(name: str) -> None:
    model, known, _ = KNOWN[name]
    state = initial_state(model, **known)
    if model is SLIDING:
        motion = contact_motion(model, state, [0.0, 0.01])
        assert np.array_equal(motion.states[0, : len(state)], np.array(state, dtype=float))
        return
    system = model if isinstance(model, flowlanes.System) else model.system()
    motion = flowlanes.integrate(system, state, [0.0, 0.01])
    assert np.array_equal(
        motion.states[0][: len(system.symbols)], np.float64(state)[: len(system.symbols)]
    )


def test_a_start_by_name_is_that_of_integrate() -> None:
    system = ROLLING.system()
    given = {"M": (0.3, -0.2, 1.1), "gamma": (0.0, 0.6, 0.8)}
    one = flowlanes.integrate(system, initial_state(system, **given), [0.0, 1.0])
    assert np.array_equal(one.states, flowlanes.integrate(system, given, [0.0, 1.0]).states)


def test_parameters_replace_those_of_a_system() -> None:
    heavy = initial_state(ROLLING, (1, 0, 0), (0, 0, 1), parameters={"m": 3.0})
    assert float(heavy[0]) == 3.4


@pytest.mark.parametrize(
    ("model", "known", "sentence"),
    [
        (SLIDING, {"omega": (0, 0, 1)}, "the start gives no gamma"),
        (SLIDING, PLACED, "the start gives no omega"),
        (SLIDING, {"omega": (0, 0, 1), "gamma": (0, 0, 1), "slipp": (0, 0, 0)}, "slipp: .*slip"),
        (CARRIED, {"omega": (0, 0, 1)}, "the start gives no place"),
        (CARRIED, {"omega": (0, 0, 1), "place": (0, 0, 2), "gamma": (0, 0, 1)}, "gamma: unknown"),
        (SLIDING, {"omega": (0, 0, 1), "gamma": (0, 0, 1), "parameters": {"m": 2.0}}, "parameters"),
        (ROLLING, {"omega": (0, 0, 1)}, "omega is given, but gamma is not"),
        (ROLLING, {"gamma": (0, 0, 1)}, "the start does not tell M_1, M_2, M_3"),
        (ROLLING, {}, "the start does not tell"),
        (ROLLING, {"M": (0, 0, 1), "gamma": (0, 0, 1), "spin": 2.0}, "there is no spin"),
        (DRIVEN, {"omega": (0, 0, 1), "gamma": (0, 0, 1), "theta": 2.0}, "there is no joint theta"),
    ],
)
def test_what_is_missing_or_unknown_is_told(
    model: Any, known: dict[str, Any], sentence: str
) -> None:
    with pytest.raises(InputError, match=sentence):
        initial_state(model, **known)
