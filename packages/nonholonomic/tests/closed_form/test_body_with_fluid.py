"""Bodies with fluid that move as their equivalent rigid bodies, against integrated motions."""

from __future__ import annotations

import numpy as np
import pytest

import flowlanes
import nonholonomic
from nonholonomic.catalogue.fixed_point.fluid_filled_bodies import with_fluid
from nonholonomic.closed_form.base.no_closed_form import NoClosedFormError
from nonholonomic.mechanics.rolling.fluid import Fluid

TIMES = [0.0, 1.0, 20.0]
OMEGA, GAMMA = (0.7, -0.4, 1.1), (2 / 7, -3 / 7, 6 / 7)
#: Across γ.
ROLL = (0.7, -0.4, -(0.7 * 2 + 0.4 * 3) / 6)
SPHERE = nonholonomic.Cavity((0.5, 0.5, 0.5), mass=1.2)
OFF_CENTRE = nonholonomic.Cavity((0.2, 0.2, 0.2), mass=0.7, centre=(0.1, -0.2, 0.05))
TURNED = nonholonomic.Cavity((0.6, 0.4, 0.3), mass=1.5, turn=(1, 0.2, -0.3, 0.1))


def potential(cavity, omega):
    """ξ of a fluid in potential flow, −Cω."""
    return [-x for x in np.array(cavity.coupling, dtype=float) @ np.array(omega)]


def followed(system, omega, fluid, gamma=GAMMA):
    """The start, and how far the closed form is from an integration."""
    start = nonholonomic.initial_state(system, omega=omega, gamma=gamma, fluid=fluid)
    solution = nonholonomic.solve(system, start)
    motion = flowlanes.integrate(system, start, TIMES)
    assert solution.system.symbols == motion.system.symbols
    states = solution.states(TIMES)
    assert np.abs(states[-1] - states[0]).max() > 0.1
    return solution, np.abs(states - motion.states).max()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "cavities", "omega"),
    [
        ("free-body", [SPHERE], OMEGA),
        ("free-body", [OFF_CENTRE], OMEGA),
        ("free-body", [TURNED], OMEGA),
        ("free-body", [SPHERE, TURNED], OMEGA),
        ("veselova", [SPHERE], ROLL),
        ("veselova", [TURNED], ROLL),
    ],
)
def test_bodies_about_a_fixed_point(name, cavities, omega):
    fluid = [potential(c, omega) if c is TURNED else [0.5, -0.8, 1.2] for c in cavities]
    system = with_fluid(nonholonomic.from_catalogue(name), cavities)
    solution, difference = followed(system, omega, fluid if len(fluid) > 1 else fluid[0])
    assert difference < 1e-11
    state = solution.states([7.0])[0]
    assert state == pytest.approx([float(x) for x in solution.rigorous(7, 20)], abs=1e-13)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("contact", "cavity"), [("marble", SPHERE), ("rubber", SPHERE), ("rubber", TURNED)]
)
def test_balls(contact, cavity):
    ball = nonholonomic.Body(1.0, (0.3, 0.4, 0.5), nonholonomic.Ball(1.0), cavity=cavity)
    omega = OMEGA if contact == "marble" else ROLL
    fluid = potential(cavity, omega) if cavity is TURNED else [0.5, -0.8, 1.2]
    _, difference = followed(
        nonholonomic.rolling_system(ball, nonholonomic.Plane(), contact), omega, fluid
    )
    assert difference < 1e-11


def test_the_fluid_is_carried_without_attitude_too():
    system = with_fluid(nonholonomic.from_catalogue("free-body"), [SPHERE])
    start = nonholonomic.initial_state(system, omega=OMEGA, gamma=GAMMA, fluid=[0.5, -0.8, 1.2])
    whole, alone = nonholonomic.solve(system, start), nonholonomic.solve(system, start[:9])
    assert len(alone.system.symbols) == 9
    assert np.abs(whole.states(TIMES)[:, :9] - alone.states(TIMES)).max() < 1e-13


@pytest.mark.parametrize("turn", [(1, 0, 0, 0), (1, 0.2, -0.3, 0.1)])
def test_vorticity_in_an_ellipsoid_is_refused(turn):
    system = with_fluid(
        nonholonomic.from_catalogue("free-body"), [nonholonomic.Cavity((0.6, 0.4, 0.3), 1.5, turn)]
    )
    start = nonholonomic.initial_state(system, omega=OMEGA, gamma=GAMMA, fluid=[0.5, -0.8, 1.2])
    with pytest.raises(NoClosedFormError, match=r"no sphere .* potential flow"):
        nonholonomic.solve(system, start)


def test_a_system_with_another_law_of_circulation_is_not_mistaken(monkeypatch):
    """N fixed in the body: the letters are those of a fluid, the equations are not."""
    rate = Fluid.rate.fget
    monkeypatch.setattr(Fluid, "rate", property(lambda self: -rate(self)))
    system = with_fluid(nonholonomic.from_catalogue("free-body"), [SPHERE])
    start = nonholonomic.initial_state(system, omega=OMEGA, gamma=GAMMA, fluid=[0.5, -0.8, 1.2])
    with pytest.raises(NoClosedFormError):
        nonholonomic.solve(system, start)
