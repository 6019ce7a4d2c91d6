"""Two bicycles, one by Kane's method in SymPy and one by its Lagrangian, move alike."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import pytest
import sympy as sp

from flowlanes.flow.linearisation.linear_stability import linear_stability
from flowlanes.formulas.multiprecision import number, slopes
from flowlanes.system.system import System
from nonholonomic.mechanics.sympy_models.conversion import from_sympy

ROOT = Path(__file__).parents[4]
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def bicycle() -> Iterator[ModuleType]:
    paths = [str(ROOT / "examples"), str(ROOT / "benchmarks")]
    sys.path[:0] = paths
    try:
        import whipple_bicycle

        yield whipple_bicycle
    finally:
        for path in paths:
            sys.path.remove(path)


@pytest.fixture(scope="module")
def kane(bicycle: ModuleType) -> System:
    from kane_bicycle import kane_bicycle

    defaults = {name: float(value) for name, value in bicycle.VALUES.items()}
    return from_sympy(kane_bicycle()[0], defaults, name="kane-bicycle")


def test_the_same_eigenvalues(bicycle: ModuleType, kane: System):
    state: dict[str, Any] = dict.fromkeys(map(str, kane.symbols), 0)
    wheels = {"u3": -1 / bicycle.VALUES["R_R"], "u6": -1 / bicycle.VALUES["R_F"]}
    state |= {name: 5 * rate for name, rate in wheels.items()}
    found = linear_stability(kane, state, bicycle.VALUES, along=[wheels], digits=20).eigenvalues
    ours = bicycle.linearisation_near(5).eigenvalues
    assert len(found) == 4
    assert all(abs(a - b) < 1e-17 for a, b in zip(found, ours, strict=True))


@pytest.mark.slow
def test_equations_stay_small(kane: System):
    steps = kane.required_definitions(kane.rates)
    count = sum(sp.count_ops(e) for e in (*kane.rates, *(value for _, value in steps)))
    assert count < 3500


def values_at(system: System, formulas: Any, known: Mapping[sp.Symbol, Any]) -> list[Any]:
    return list(slopes(system, list(formulas), (), known)[0])


def admissible(kane: System, numbers: Mapping[str, Any]) -> dict[sp.Symbol, Any]:
    """A state far from upright: lean, steer and their rates chosen, the rest by the constraints."""
    by_name = {str(s): s for s in kane.symbols}
    chosen = {"q1": "0.4", "q2": "0.3", "q5": "-0.5", "u2": "0.7", "u5": "-1.1", "u3": "-9"}
    state = {s: mpmath.mpf(chosen.get(name, "0.01")) for name, s in by_name.items()}
    constants = {p.symbol: numbers[str(p.symbol)] for p in kane.parameters}
    loose = [by_name[name] for name in ("q4", "u1", "u4", "u6")]
    for _ in range(12):
        defect, rows = slopes(kane, list(kane.relations), loose, {**state, **constants})
        for s, change in zip(loose, mpmath.lu_solve(rows, defect), strict=True):
            state[s] -= change
    assert mpmath.norm(defect) < mpmath.mpf("1e-40")
    return {**state, **constants}


@mpmath.workdps(50)
def test_the_same_accelerations_far_from_upright(bicycle: ModuleType, kane: System):
    numbers = {name: number(value, name) for name, value in bicycle.VALUES.items()}
    state = admissible(kane, numbers)
    here = {str(s): x for s, x in state.items()}
    rates = dict(zip(map(str, kane.symbols), values_at(kane, kane.rates, state), strict=True))
    lean, slope = here["q2"], here["q4"] + numbers["lambda"]
    c, s = mpmath.cos(slope), mpmath.sin(slope)
    gamma = mpmath.matrix([s * mpmath.cos(lean), -mpmath.sin(lean), -c * mpmath.cos(lean)])
    forward, across = mpmath.matrix([c, 0, s]), mpmath.matrix([-s, 0, c])
    omega = here["u2"] * forward - here["u1"] * gamma + mpmath.matrix([0, here["u4"], 0])
    turning = mpmath.matrix(
        [
            gamma[1] * omega[2] - gamma[2] * omega[1],
            gamma[2] * omega[0] - gamma[0] * omega[2],
            gamma[0] * omega[1] - gamma[1] * omega[0],
        ]
    )
    expected = (
        rates["u2"] * forward
        + here["u2"] * here["u4"] * across
        - rates["u1"] * gamma
        - here["u1"] * turning
        + mpmath.matrix([0, rates["u4"], 0])
    )
    system = bicycle.model()
    ours = {f"gamma_{i + 1}": gamma[i] for i in range(3)}
    ours |= {f"omega_{i + 1}": omega[i] for i in range(3)}
    ours |= {"delta": here["q5"], "deltadot": here["u5"], "Omega_R": here["u3"]}
    known = {symbol: ours[str(symbol)] for symbol in system.symbols}
    known |= {p.symbol: numbers[str(p.symbol)] for p in system.parameters}
    assert max(map(abs, values_at(system, system.relations, known))) < mpmath.mpf("1e-40")
    found = dict(zip(map(str, system.symbols), values_at(system, system.rates, known), strict=True))
    tiny = mpmath.mpf("1e-40")
    assert all(abs(found[f"omega_{i + 1}"] - expected[i]) < tiny for i in range(3))
    assert abs(found["deltadot"] - rates["u5"]) < tiny
    assert abs(found["Omega_R"] - rates["u3"]) < tiny
