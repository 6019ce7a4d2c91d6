"""Closed forms of genus two against integration with 34 digits: random bodies, random starts.

Every case is drawn, solved and compared; none is left out.  A motion so close to a separatrix that
its error bounds would take minutes says so by an InputError; such cases are counted.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from importlib import import_module
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb, ctx

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from flowlanes.system.vectors import to_components
from nonholonomic.closed_form.genus_two.separation import SeparatedSystem
from nonholonomic.closed_form.genus_two_solution import GenusTwo, solve_on_torus
from nonholonomic.closed_form.rigorous import rigorous_motion
from nonholonomic.closed_form.separable import SEPARABLE

#: Digits after the point asked of the error bounds, and what 34-digit integration may be off by.
DIGITS, SLACK = 20, 1e-25


#: Where the systems of genus two are told of.
PLACES = [(place.module, place.function) for place in SEPARABLE]


@dataclass(frozen=True)
class Outcome:
    """What one case came to.

    Attributes
    ----------
    fast : float
        Largest error of the evaluation in doubles, in units of the state's size.
    missed : float
        Largest distance from the integrated state to the balls, beyond their radii.
    radius : float
        Of the largest ball; not a number where there are none.
    """

    fast: float
    missed: float
    radius: float


def bare(separable: SeparatedSystem) -> SeparatedSystem:
    """The separation without the lift to space."""
    system = replace(separable.system, reconstruction=None, observables=(), guards=())
    return replace(separable, system=system)


@cache
def told(module: str, function: str) -> SeparatedSystem:
    """A separation by the place where it is told of."""
    return bare(
        getattr(import_module(f"nonholonomic.closed_form.separations.{module}"), function)()
    )


def body(separable: SeparatedSystem, generator: random.Random) -> dict[sp.Symbol, Fraction]:
    """Parameters that doubles hold exactly: different moments of a real body, the level's ratio."""
    moments = [Fraction(m, 32) for m in sorted(generator.sample(range(32, 62), 3))]
    half = (sum(moments) + Fraction(1, 2)) / 2
    named = dict(zip(("I_1", "I_2", "I_3"), moments, strict=True))
    named |= dict(zip(("J_1", "J_2", "J_3"), moments, strict=True))
    named |= {f"A_{i}": half - m for i, m in enumerate(moments, 1)} | {"d": Fraction(1, 2)}
    named["a"] = Fraction(generator.randint(16, 32), 32)
    names = {str(p.symbol): p for p in separable.system.parameters}
    values = {}
    for name, parameter in names.items():
        if name == "R" and "a" in names:
            value = 2 * named["a"]
        elif name == "k":
            value = Fraction(int(parameter.default))
        else:
            drawn = Fraction(round(parameter.default * generator.randint(20, 40)), 32)
            value = named.get(name) or drawn or Fraction(1, 2)
        values[parameter.symbol] = value
    return values


def beginning(
    separable: SeparatedSystem, values: dict[sp.Symbol, Fraction], generator: random.Random
) -> list[float]:
    """A random state on the phase space and the level, to rounding."""
    size = 2.0 ** generator.uniform(-1.5, 1.5)
    state = np.array([generator.gauss(0, 1) for _ in separable.system.symbols])
    state[:3] *= size
    state[3:] /= np.linalg.norm(state[3:])
    conditions = [*separable.system.relations, *separable.level]
    put_in = [_plain(separable.system, condition).xreplace(values) for condition in conditions]
    moving = [f for f in put_in if f.free_symbols]
    gradient = [[sp.diff(f, x) for x in separable.system.symbols] for f in moving]
    function = sp.lambdify(separable.system.symbols, [moving, gradient], "numpy")
    for _ in range(30):
        miss, slopes = function(*state)
        state -= np.linalg.lstsq(np.array(slopes, float), np.array(miss, float), rcond=None)[0]
    return [float(x) for x in state]


def _plain(system: System, formula: Any) -> sp.Expr:
    value = to_components(sp.sympify(formula))
    for name, meaning in reversed(system.required_definitions([value])):
        value = value.xreplace({name: meaning})
    return value


def integrated(
    solution: GenusTwo, values: dict[sp.Symbol, Fraction], until: float
) -> Sequence[Any]:
    """The state with 34 digits, from the same start."""
    with mpmath.workdps(40):
        start = [mpmath.mpf(x.str(40, radius=False)) for x in solution.separated_motion.state]
        parameters = {symbol: float(value) for symbol, value in values.items()}
        run = integrate(solution.system, start, [0, until], parameters=parameters, precision="quad")
        return list(run.states[-1])


def case(separable: SeparatedSystem, seed: str, until: float, bounds: bool) -> Outcome:
    """Draw a motion, solve it and compare."""
    generator = random.Random(f"{separable.name} {seed}")
    values = body(separable, generator)
    solution = solve_on_torus(separable, values, beginning(separable, values, generator))
    exact = integrated(solution, values, until)
    scale = max(1.0, *(abs(float(x)) for x in exact))
    found = solution.states(np.array([until]))[0]
    fast = max(abs(float(a - b)) for a, b in zip(exact, found, strict=True)) / scale
    if not bounds:
        return Outcome(fast, 0.0, float("nan"))
    balls = rigorous_motion(solution, DIGITS, until).state(until)
    with ctx.workprec(200):
        gaps = [abs(ball.mid() - arb(str(x))) for ball, x in zip(balls, exact, strict=True)]
        beyond = [float(gap - ball.rad()) for gap, ball in zip(gaps, balls, strict=True)]
        return Outcome(fast, max(0.0, *beyond), max(float(ball.rad()) for ball in balls))


@pytest.mark.slow
@pytest.mark.parametrize("place", PLACES, ids="-".join)
def test_fast_evaluation_agrees_with_integration(place: tuple[str, str]) -> None:
    outcome = case(told(*place), "quick", 5.0, bounds=False)
    assert outcome.fast < 1e-13


@pytest.mark.slow
def test_balls_contain_the_integrated_state() -> None:
    outcome = case(told("veselova", "veselova"), "quick", 5.0, bounds=True)
    assert outcome.missed < SLACK
    assert outcome.radius < 1e-19


@pytest.mark.campaign
@pytest.mark.parametrize("place", PLACES, ids="-".join)
def test_two_hundred_motions(place: tuple[str, str]) -> None:
    count: Counter[str] = Counter()
    for number in range(200):
        try:
            outcome = case(told(*place), str(number), 1000.0, bounds=True)
        except InputError as error:
            # said, not skipped: what the case is refused for is counted
            count[str(error)] += 1
            continue
        count["compared"] += 1
        assert outcome.fast < 1e-12, number
        assert outcome.missed < SLACK, number
    print(place, dict(count))
    assert count.total() == 200
    assert count["compared"] >= 190
