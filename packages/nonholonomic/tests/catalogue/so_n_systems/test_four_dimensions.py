"""Balls and bodies of four-dimensional space against their equations with all reactions."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from nonholonomic.catalogue import entry

PAIRS = tuple(combinations(range(4), 2))
STEP = 1e-5


def skew(six: Any) -> Any:
    """A skew matrix from its entries above the diagonal."""
    made = np.zeros((4, 4))
    for value, (i, j) in zip(six, PAIRS, strict=True):
        made[i, j], made[j, i] = value, -value
    return made


def above(matrix: Any) -> Any:
    """The entries above the diagonal."""
    return np.array([matrix[i, j] for i, j in PAIRS])


def inertia(name: str) -> Any:
    """I_ij as a symmetric matrix."""
    return np.abs(skew([entry(name).defaults[f"I_{i + 1}{j + 1}"] for i, j in PAIRS]))


def function(system: System, formulas: list[Any]) -> Any:
    """Formulas of a system as a function of its flat state, at the default parameters."""
    numbers = system.defaults
    steps = [(s, v.xreplace(numbers)) for s, v in system.required_definitions(formulas)]
    plain = [sp.sympify(f).xreplace(numbers) for f in formulas]
    made = sp.lambdify(list(system.symbols), plain, "numpy", cse=lambda e: (steps, e))
    return lambda state: np.array(made(*state), dtype=float)


def slope(system: System, formulas: list[Any], state: Any) -> Any:
    """Rates of formulas along the field."""
    rates, values = function(system, list(system.rates)), function(system, formulas)
    step = STEP * rates(state)
    return (values(state + step) - values(state - step)) / (2 * STEP)


def free(spin: Any, moments: Any, change: Any) -> Any:
    """I ω̇ − [Iω, ω], what reactions have to make, in body axes."""
    momentum = moments * spin
    return moments * change - (momentum @ spin - spin @ momentum)


def test_the_contact_force_alone_turns_the_ball() -> None:
    item = entry("chaplygin-ball-4d")
    system, moments = item.system(), inertia(item.name)
    mass, radius = item.defaults["m"], item.defaults["R"]
    generator = np.random.default_rng(4)
    for _ in range(5):
        normal = generator.normal(size=4)
        normal /= np.linalg.norm(normal)
        spin = skew(generator.normal(size=6))
        # unknown: ω̇ and the force; the centre is accelerated by R d(ω γ)/dt in space, γ fixed
        matrix, right = np.zeros((10, 10)), np.zeros(10)
        for column in range(10):
            change = skew(np.eye(10)[column][:6])
            force = np.eye(10)[column][6:]
            torque = -radius * (np.outer(force, normal) - np.outer(normal, force))
            matrix[:6, column] = above(moments * change - torque)
            matrix[6:, column] = mass * radius * change @ normal - force
        right[:6] = -above(free(spin, moments, np.zeros((4, 4))))
        found = np.linalg.solve(matrix, right)[:6]
        around = np.outer(normal, normal)
        momentum = moments * spin + mass * radius**2 * (spin @ around + around @ spin)
        state = np.concatenate([above(momentum), normal])
        names = [sp.Symbol(f"omega_{i + 1}{j + 1}", real=True) for i, j in PAIRS]
        assert function(system, names)(state) == pytest.approx(above(spin), abs=1e-12)
        assert slope(system, names, state) == pytest.approx(found, abs=1e-8)


def test_reactions_of_the_veselova_system_lie_across_the_direction() -> None:
    """I ω̇ − [Iω, ω] has no part in planes through γ, and ω̇ keeps the constraint."""
    item = entry("veselova-4d")
    system, moments = item.system(), inertia(item.name)
    generator = np.random.default_rng(5)
    u = [sp.Symbol(f"u_{i}", real=True) for i in range(1, 5)]
    gamma = [sp.Symbol(f"gamma_{i}", real=True) for i in range(1, 5)]
    turning = [u[i] * gamma[j] - gamma[i] * u[j] for i, j in PAIRS]
    for _ in range(5):
        normal = generator.normal(size=4)
        normal /= np.linalg.norm(normal)
        velocity = generator.normal(size=4)
        velocity -= (velocity @ normal) * normal
        spin = np.outer(velocity, normal) - np.outer(normal, velocity)
        state = np.concatenate([(moments * spin) @ normal, normal])
        assert function(system, turning)(state) == pytest.approx(above(spin), abs=1e-12)
        assert function(system, list(system.rates[4:]))(state) == pytest.approx(
            -spin @ normal, abs=1e-12
        )
        change = skew(slope(system, turning, state))
        assert free(spin, moments, change) @ normal == pytest.approx(0.0, abs=1e-8)


@pytest.mark.parametrize("name", ["chaplygin-ball-4d", "veselova-4d"])
def test_integrals_stay(name: str) -> None:
    made = built.example(name)
    motion = integrate(made.system, made.start, np.linspace(0.0, 20.0, 41))
    for law in made.system.integrals:
        values = motion[f"law_{law.name}"]
        assert np.abs(values - values[0]).max() < 1e-13 * (1 + abs(values[0]))
    assert np.ptp(motion["gamma_1"]) > 0.3
