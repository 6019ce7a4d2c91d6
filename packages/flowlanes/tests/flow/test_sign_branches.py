"""Absolute values and signs along a motion: steps end where their arguments change sign."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes import Integral, Parameter, System, integrate
from flowlanes.errors import InputError, RunError
from flowlanes.system import real_symbol
from flowlanes.system.system import Guard

x, v, c = real_symbol("x"), real_symbol("v"), real_symbol("c")
ENERGY = {
    "constant force": (-sp.sign(x), v**2 / 2 + sp.Abs(x)),
    "force |x| x": (-x * sp.Abs(x), v**2 / 2 + sp.Abs(x) ** 3 / 3),
    "two springs": (-x - sp.Abs(x) / 2, v**2 / 2 + x**2 / 2 + x * sp.Abs(x) / 4),
    "a stop": (-x - sp.Max(0, x - c), (v**2 + x**2 + sp.Max(0, x - c) ** 2) / 2),
    "two stops": (
        -sp.sign(x) * sp.Max(0, sp.Abs(x) - c),
        (v**2 + sp.Max(0, sp.Abs(x) - c) ** 2) / 2,
    ),
}


def oscillator(force: sp.Expr, energy: sp.Expr, *guards: Guard) -> System:
    return System(
        "oscillator",
        "Oscillator",
        {x: v, v: force},
        parameters=(Parameter(c, "place of the stop", 0.25),),
        laws=(Integral("energy", energy, "energy"),),
        guards=guards,
    )


def test_a_constant_force_to_both_sides() -> None:
    """Parabolas: from x = 1/2 at rest the period is four times the second that a half takes."""
    system = oscillator(*ENERGY["constant force"])
    motion = integrate(system, {"x": 0.5, "v": 0.0}, np.linspace(0, 8, 33))
    quarter = np.mod(motion.times, 4)
    expected = np.where(quarter < 1, 0.5 - quarter**2 / 2, (quarter - 2) ** 2 / 2 - 0.5)
    expected = np.where(quarter > 3, 0.5 - (4 - quarter) ** 2 / 2, expected)
    np.testing.assert_allclose(motion["x"], expected, atol=1e-13)
    assert not motion.events


@pytest.mark.parametrize("name", ENERGY)
@pytest.mark.parametrize("until", [30.0, -30.0])
def test_the_energy_stays(name: str, until: float) -> None:
    motion = integrate(oscillator(*ENERGY[name]), {"x": 0.5, "v": 0.3}, [0.0, until / 2, until])
    energy = motion["law_energy"]
    np.testing.assert_allclose(energy, energy[0], rtol=1e-13)
    assert motion["x"][-1] != pytest.approx(0.5)


def test_a_motion_comes_back_through_corners() -> None:
    system = oscillator(*ENERGY["two stops"])
    there = integrate(system, {"x": 0.5, "v": 0.3}, [0.0, 20.0])
    back = integrate(system, list(there.states[-1]), [20.0, 0.0])
    np.testing.assert_allclose(back.states[-1], [0.5, 0.3], atol=1e-11)


def test_other_precision() -> None:
    system = oscillator(*ENERGY["two springs"])
    double = integrate(system, {"x": 0.5, "v": 0.3}, [0.0, 10.0])
    quad = integrate(system, {"x": 0.5, "v": 0.3}, [0.0, 10.0], precision="quad")
    np.testing.assert_allclose(double.states[-1], quad.states[-1].astype(float), atol=1e-13)


def test_a_guard_with_an_absolute_value() -> None:
    guard = Guard("wall", 1 - sp.Abs(x), "the wall is reached")
    system = oscillator(sp.S.Zero, v, guard)
    motion = integrate(system, {"x": 0.5, "v": -0.25}, [0.0, 10.0])
    (event,) = motion.events
    assert event.time == pytest.approx(6.0, rel=1e-13)


def test_rest_at_a_corner_is_an_error() -> None:
    """Dry friction stops a body in finite time: there is no solution with sign v beyond."""
    system = oscillator(-sp.sign(v), v)
    with pytest.raises(RunError, match="v is zero, without certainly changing its sign"):
        integrate(system, {"x": 0.0, "v": 1.0}, [0.0, 2.0])


def test_collocation_refuses_corners() -> None:
    with pytest.raises(InputError, match="collocation takes smooth equations alone"):
        integrate(
            oscillator(*ENERGY["constant force"]), {"x": 0.5, "v": 0.0}, [0.0, 1.0], method="gauss"
        )
