"""A motion is recognised by what it is, whatever it is called."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
import sympy as sp
from flint import arb

from closed_form.problems import catalogue_problem
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.formulas.balls import exact
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol, vectors
from nonholonomic.catalogue import from_catalogue
from nonholonomic.closed_form import solve
from nonholonomic.closed_form.base.problem import Problem, same_field
from nonholonomic.closed_form.recover_body import rolling_of
from nonholonomic.closed_form.solvable_cases import find_match, solution_of
from nonholonomic.mechanics.rolling.body import Body
from nonholonomic.mechanics.rolling.equations import Forces, RollingBody
from nonholonomic.mechanics.shapes.shapes import Ball
from nonholonomic.mechanics.shapes.surfaces import Sphere
from nonholonomic.starts import initial_state

GAMMA = (0.36, -0.48, 0.8)
NO_SPIN = (0.8, -0.4, -0.6)
MOMENTS = (1.0, 1.5, 2.1)
FULL = ((1.0, 0.1, 0.05), (0.1, 1.5, -0.2), (0.05, -0.2, 2.1))


def problem_of(rolling: RollingBody, omega: Any = NO_SPIN, words: bool = True) -> Problem:
    """A rolling body with a start; `told` whether what rolls on what is known."""
    system = rolling.system()
    start = initial_state(system, omega, GAMMA)
    return Problem(system, system.defaults, start, rolling if words else None)


BALL = RollingBody(Body(1.3, MOMENTS, Ball(0.9)))


@pytest.mark.parametrize(
    ("rolling", "name"),
    [
        (BALL, "chaplygin-ball-area"),
        (replace(BALL, field=Forces(9.81)), "chaplygin-ball-area"),
        (replace(BALL, contact="rubber"), "rubber-chaplygin-ball"),
        (replace(BALL, contact="rubber", field=Forces(9.81)), "rubber-chaplygin-ball"),
        (
            RollingBody(Body(1.3, MOMENTS, Ball(0.9, hollow=True)), Sphere(0.45), "rubber"),
            "rubber-ball-around-sphere",
        ),
    ],
    ids=["ball", "heavy ball", "rubber ball", "heavy rubber ball", "around a sphere, k = −1"],
)
def test_rolling_bodies(rolling: RollingBody, name: str) -> None:
    found = find_match(problem_of(rolling))
    assert found is not None
    assert (found.known_system.name, found.level) == (name, ())
    assert set(found.own.leading.free_symbols) <= {
        *rolling.system().defaults,
        *(symbol for symbol, _ in found.own.constants),
    }


@pytest.mark.parametrize(
    ("name", "parameters", "separation"),
    [
        ("veselova", {}, "veselova"),
        ("neumann", {}, "neumann"),
        ("veselova-bruns", {}, "veselova-bruns"),
        ("rubber-chaplygin-ball-bruns", {}, "rubber-chaplygin-ball-bruns"),
        ("rubber-ball-of-ratio", {"k": -1.0}, "rubber-ball-of-ratio"),
    ],
)
def test_systems_of_the_catalogue(name: str, parameters: dict[str, float], separation: str) -> None:
    found = find_match(catalogue_problem(name, **parameters))
    assert found is not None
    assert (found.known_system.name, found.level) == (separation, ())


@pytest.mark.slow
def test_a_relation_of_the_known_system_is_a_condition_on_the_start() -> None:
    system = from_catalogue("veselova-spinning")
    start = initial_state(system, NO_SPIN, GAMMA)
    found = find_match(Problem(system, system.defaults, start))
    assert found is not None
    assert (found.known_system.name, found.level) == ("veselova", ())
    trajectory = integrate(system, start, np.linspace(0.0, 5.0, 3))
    assert np.abs(solve(system, start).states(trajectory.times) - trajectory.states).max() < 1e-12


def test_the_area_constant_chooses_the_separation() -> None:
    # (Iω, γ) = 0.36·2 − 0.72·1
    found = find_match(problem_of(BALL, (2.0, 1.0, 0.0)))
    assert found is not None
    assert found.known_system.name == "chaplygin-ball"
    # the doubles nearest to 2 and 3/14 leave 10⁻¹⁷: a motion of its own
    for omega in ((math.nextafter(2.0, 3.0), 1.0, 0.0), (1.0, 1.0, 3 / 14)):
        found = find_match(problem_of(BALL, omega))
        assert found is not None
        assert found.known_system.name == "chaplygin-ball-area"


@pytest.mark.parametrize("radius", [0.45, 0.4500001])
def test_the_ratio_of_radii_is_taken_exactly(radius: float) -> None:
    ball = RollingBody(
        Body(1.3, MOMENTS, Ball(0.9, hollow=True)), Sphere.of_signed_radius(radius), "rubber"
    )
    found = find_match(problem_of(ball))
    assert found is not None
    assert (not found.level) == (radius == 0.45)


def own_system() -> System:
    """The Veselova system as somebody else would write it: other letters, no lift, no laws."""
    from flowlanes.system.vectors import cross, dot

    w, n, A, B, C = *vectors("w n"), *(real_symbol(s) for s in "ABC")
    momentum = [a * x for a, x in zip((A, B, C), w.symbols, strict=True)]
    x, y, z = w.symbols
    p, q, r = momentum
    torque = (q * z - r * y, r * x - p * z, p * y - q * x)
    pull = sum(t * s / a for t, s, a in zip(torque, n.symbols, (A, B, C), strict=True))
    size = sum(s**2 / a for s, a in zip(n.symbols, (A, B, C), strict=True))
    rates = [
        (t - pull / size * s) / a for t, s, a in zip(torque, n.symbols, (A, B, C), strict=True)
    ]
    return System(
        name="mine",
        title="My own",
        field=[*zip(w.symbols, rates, strict=True), (n, cross(n, w))],
        parameters=tuple(
            Parameter(s, "moment", value)
            for s, value in zip((C, A, B), (2.1, 1.0, 1.5), strict=True)
        ),
        relations=(dot(n, n) - 1, dot(w, n)),
    )


@pytest.mark.slow
def test_a_system_in_other_letters() -> None:
    system = own_system()
    start = (0.8, -0.4, -0.6, *GAMMA)
    found = find_match(Problem(system, system.defaults, start))
    assert found is not None
    assert found.known_system.name == "veselova"
    assert found.own.poles == tuple(real_symbol(s) for s in "ABC")
    solution = solution_of(Problem(system, system.defaults, start))
    trajectory = integrate(system, start, np.linspace(0.0, 20.0, 5))
    assert np.abs(solution.states(trajectory.times) - trajectory.states).max() < 1e-12


@pytest.mark.slow
@pytest.mark.parametrize(
    "ball",
    [
        # its parameter g is gravity, and the constant g of the separation is another one
        replace(BALL, field=Forces(9.81)),
        RollingBody(Body(1.3, FULL, Ball(0.9)), contact="rubber", field=Forces(9.81)),
        RollingBody(Body(1.3, (1.0, 1.5, 1.5), Ball(0.9)), contact="rubber"),
        RollingBody(Body(1.3, (1.5, 1.0, 1.5), Ball(0.9)), contact="rubber"),
    ],
    ids=["heavy", "full tensor", "symmetric about axis 1", "symmetric about axis 2"],
)
def test_solutions_are_told_in_the_axes_of_the_body(ball: RollingBody) -> None:
    problem = problem_of(ball)
    solution = solution_of(problem)
    trajectory = integrate(problem.system, problem.start, np.linspace(0.0, 20.0, 5))
    assert solution.system.symbols == trajectory.system.symbols
    assert np.abs(solution.states(trajectory.times) - trajectory.states).max() < 1e-12


@pytest.mark.parametrize(
    "rolling",
    [
        BALL,
        replace(BALL, contact="rubber", field=Forces(9.81)),
        RollingBody(Body(1.3, FULL, Ball(0.9)), contact="rubber"),
        RollingBody(Body(1.3, MOMENTS, Ball(0.9, hollow=True)), Sphere(0.45)),
        RollingBody(Body(1.3, MOMENTS, Ball(0.9, centre=(0.1, 0.2, 0.3)))),
    ],
    ids=["ball", "heavy rubber ball", "full tensor", "around a sphere", "displaced"],
)
def test_bodies_are_found_in_their_equations(rolling: RollingBody) -> None:
    system = rolling.system()
    found = rolling_of(system, system.defaults)
    assert found is not None
    assert found.system().field == system.field
    assert found.body.inertia == rolling.body.inertia


def test_axes_that_a_tensor_does_not_determine() -> None:
    tensor = ((1.5, 0.5, 0.0), (0.5, 1.5, 0.0), (0.0, 0.0, 1.0))
    with pytest.raises(InputError, match="give the body in principal axes"):
        solution_of(problem_of(RollingBody(Body(1.3, tensor, Ball(0.9)), contact="rubber")))


def veselova_start() -> tuple[System, tuple[Any, ...]]:
    system = from_catalogue("veselova")
    return system, initial_state(system, omega=NO_SPIN, gamma=GAMMA)


@pytest.mark.slow
def test_a_reduced_start_gives_the_reduced_motion() -> None:
    system, start = veselova_start()
    whole, reduced = solve(system, start), solve(system, start[:6])
    assert len(reduced.system.symbols) == 6
    assert np.abs(whole.states([3.0])[:, :6] - reduced.states([3.0])).max() < 1e-14


@pytest.mark.slow
def test_parameters_may_be_given_by_name() -> None:
    system, start = veselova_start()
    other = from_catalogue("veselova", I_2=1.4)
    assert np.array_equal(
        solve(system, start, {"I_2": 1.4}).states([3.0]), solve(other, start).states([3.0])
    )


@pytest.mark.parametrize(
    ("change", "parameters", "sentence"),
    [
        (lambda start: start[:5], {}, "start has 5 numbers: 10 are needed"),
        (lambda start: [float("nan"), *start[1:]], {}, "omega_1 = nan: it must be a finite number"),
        (lambda start: [1.0] * 10, {}, "it misses the constraints"),
        (lambda start: start, {"q": 1.0}, "veselova: no parameter q; it has I_1, I_2, I_3"),
        (lambda start: start, {"I_1": float("inf")}, "I_1 = inf: it must be a finite number"),
        (lambda start: start, {"I_1": -1.0}, "I_1 = -1.0 is not admissible; I_1 > 0 must hold"),
    ],
    ids=["short", "nan", "off", "unknown", "infinite", "negative"],
)
def test_mistakes(change: Any, parameters: dict[str, float], sentence: str) -> None:
    system, start = veselova_start()
    with pytest.raises(InputError, match=re.escape(sentence)):
        solve(system, change(start), parameters)


def test_no_body_is_found_where_none_rolls() -> None:
    system = from_catalogue("veselova")
    assert rolling_of(system, system.defaults) is None


def test_fields_are_compared_exactly() -> None:
    system = from_catalogue("veselova")
    numbers = {s: exact(x) for s, x in system.defaults.items()}
    assert same_field(system, numbers, system, numbers)
    (first, *_) = numbers
    near = numbers | {first: numbers[first] + Fraction(1, 10**40)}
    assert not same_field(system, near, system, numbers)


def test_fields_with_functions_are_none_of_the_known() -> None:
    known = from_catalogue("veselova")
    numbers = {s: exact(x) for s, x in known.defaults.items()}
    other = replace(
        known,
        field=tuple((name, sp.sin(1) * rate) for name, rate in known.field),
        reconstruction=None,
    )
    assert not same_field(other, numbers, known, numbers)


@pytest.mark.parametrize(
    ("number", "value"),
    [
        (0.1, Fraction(1, 10)),
        ("1/3", Fraction(1, 3)),
        (7, Fraction(7)),
        (sp.Rational(2, 3), Fraction(2, 3)),
        (mpmath.mpf(-0.5), Fraction(-1, 2)),
        (arb(0.25), Fraction(1, 4)),
        (np.float64(0.3), Fraction(3, 10)),
    ],
    ids=str,
)
def test_numbers_are_taken_at_their_word(number: Any, value: Fraction) -> None:
    assert exact(number) == value
