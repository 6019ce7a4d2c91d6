"""Degenerate motions of every system that separates, against integration with 34 digits."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from importlib import import_module
from typing import Any

import mpmath
import numpy as np
import pytest
from flint import arb, ctx

from flowlanes.flow.integrator import integrate
from flowlanes.formulas.balls import ball_values, exact
from flowlanes.system.named_formulas import flat_pairs
from nonholonomic.closed_form.degenerate import DegenerateSolution, solve_degenerate
from nonholonomic.closed_form.degenerate.theta_motion import Asymptotic, Periodic
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem, nu, nuprime
from nonholonomic.closed_form.separable import SEPARABLE

TIMES = [0.0, 0.5, 4.0]


def reduced(made: SeparatedSystem) -> SeparatedSystem:
    """Without the motion in space, on the level of the state alone."""
    system = replace(made.system, reconstruction=None)
    moving = set(system.symbols)
    level = tuple(formula for formula in made.level if formula.free_symbols & moving)
    return replace(made, system=system, level=level)


NAMES = [f"{place.module}.{place.function}" for place in SEPARABLE]


@cache
def system_of(name: str) -> SeparatedSystem:
    """The separated system that a function of `nonholonomic.closed_form.separations` makes."""
    module, _, function = name.partition(".")
    found = import_module(f"nonholonomic.closed_form.separations.{module}")
    return reduced(getattr(found, function)())


#: All but those whose state is a formula of more than ν, ν′ and the parameters.
PLAIN = [name for name in NAMES if name != "chaplygin_ball_area_constant.chaplygin_area"]


@pytest.mark.slow
def test_plain_systems_are_those_without_constants_in_their_state() -> None:
    found = []
    for name in NAMES:
        made = system_of(name)
        occurring = {s for _, f in flat_pairs(made.state) for s in f.free_symbols}
        if not {s for s, _ in made.constants} & occurring:
            found.append(name)
    assert found == PLAIN


def slip(made: SeparatedSystem, start: Any, kind: type) -> float:
    system = made.system
    numbers = {symbol: exact(value) for symbol, value in system.defaults.items()}
    found = solve_degenerate(made, numbers, start)
    assert isinstance(found, DegenerateSolution)
    assert type(found.motion) is kind
    run = integrate(system, start, TIMES, precision="quad")
    return float(np.abs(found.states(np.array(TIMES)) - run.states.astype(float)).max())


@pytest.mark.slow
@pytest.mark.parametrize("axis", [0, 1, 2])
@pytest.mark.parametrize("name", NAMES)
def test_one_component_vanishes(name: str, axis: int) -> None:
    # the first vector along a principal axis, the unit vector across it
    start = np.zeros(6)
    start[axis] = 0.7
    start[3 + (axis + 1) % 3], start[3 + (axis + 2) % 3] = 0.6, 0.8
    assert slip(system_of(name), start.tolist(), Periodic) < 1e-13


@pytest.mark.slow
@pytest.mark.parametrize("name", PLAIN)
def test_separatrix_through_a_focal_point(name: str) -> None:
    made = system_of(name)
    with ctx.workprec(300):
        start = focal(made, (0.3, 0.7, -0.4))
    assert slip(made, start, Asymptotic) < 1e-13


def test_error_bounds_contain_the_integrated_state() -> None:
    made = system_of("neumann.neumann_system")
    numbers = {symbol: exact(value) for symbol, value in made.system.defaults.items()}
    with ctx.workprec(300):
        start = focal(made, (0.3, 0.7, -0.4))
    found = solve_degenerate(made, numbers, start)
    assert isinstance(found, DegenerateSolution)
    run = integrate(made.system, start, [0.0, 3.0], precision="quad")
    with ctx.workprec(150):
        for ball, wanted in zip(found.rigorous(3.0, 12), run.states[1], strict=True):
            assert ball.rad() < 1e-20
            assert abs(ball - arb(str(wanted))) < 1e-20


def focal(made: SeparatedSystem, push: tuple[float, float, float]) -> list[Any]:
    """A state where both variables are at the middle pole: it is on a separatrix whatever ν′ is."""
    system = made.system
    known: dict[Any, Any] = {s: arb(repr(float(x))) for s, x in system.defaults.items()}
    poles = ball_values(made.poles, known)
    weights = ball_values(made.weights, known)
    low, middle, high = sorted(range(3), key=lambda i: float(poles[i]))
    n = [arb(0)] * 3
    for i in (low, high):
        n[i] = abs(weights[i]).sqrt() * (poles[i] - poles[middle])
    length = (n[low] * n[low] + n[high] * n[high]).sqrt()
    n = [x / length for x in n]
    along = sum((arb(p) * x for p, x in zip(push, n, strict=True)), arb(0))
    rate = [p - along * x for p, x in zip(push, n, strict=True)]
    known |= dict(zip(nu.symbols, n, strict=True)) | dict(zip(nuprime.symbols, rate, strict=True))
    moving = set(system.symbols)
    for symbol, formula in system.scalar_definitions:
        if not formula.free_symbols & moving:
            (known[symbol],) = ball_values([formula], known)
        else:
            moving.add(symbol)
    state = dict(flat_pairs(made.state))
    found = ball_values([state[s] for s in system.symbols], known)
    with mpmath.workdps(50):
        return [mpmath.mpf(x.mid().str(48, radius=False)) for x in found]
