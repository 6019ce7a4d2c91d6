"""The systems of §12 against Newton's and Euler's laws with all reactions, and the rattleback."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp

from catalogue import built
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from lawproof.proof.fields.budget import EFFORT
from nonholonomic.catalogue import entry
from nonholonomic.classification.classifier import classify_laws
from nonholonomic.classification.facts import ProofBudget

UP = np.array([0.0, 0.0, 1.0])
STEP = 1e-5


def hat(u: Any) -> Any:
    """The matrix of u×."""
    return np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])


def values(system: System, formulas: list[Any], state: dict[str, Any]) -> Any:
    """Formulas of a system at a state given by name, parameters at their defaults."""
    known = dict(system.defaults)
    for name in system.state:
        symbols = (name,) if isinstance(name, sp.Symbol) else name.symbols
        known |= dict(zip(symbols, np.atleast_1d(state[str(name)]), strict=True))
    steps = list(system.required_definitions(formulas))
    function = sp.lambdify(list(known), formulas, "numpy", cse=lambda e: (steps, e))
    return np.array(function(*known.values()), dtype=float)


def rows(attitude: Any) -> Any:
    """The axes of space in body axes, row by row, for a unit quaternion."""
    w, *v = attitude
    v = np.array(v)
    return (2 * w * w - 1) * np.eye(3) + 2 * np.outer(v, v) + 2 * w * hat(v)


def test_the_guide_holds_the_ball_on_its_line() -> None:
    """Contact force and guide force, found from the constraints, give the same ω̇."""
    item = entry("straight-line-ball")
    numbers, system = item.defaults, item.system()
    generator = np.random.default_rng(12)
    mass, radius = numbers["m"], numbers["R"]
    moments = np.array([numbers[f"I_{i}"] for i in (1, 2, 3)])
    for _ in range(5):
        attitude = generator.normal(size=4)
        attitude /= np.linalg.norm(attitude)
        turn = rows(attitude)
        spin = turn.T @ np.array([0.0, *generator.normal(size=2)])  # (ω, α) = 0
        # space axes from here: unknown are v̇, ω̇, the contact force and the guide force along y
        omega, inertia = turn @ spin, turn @ np.diag(moments) @ turn.T
        arm, side = -radius * UP, np.array([0.0, 1.0, 0.0])
        matrix, right = np.zeros((10, 10)), np.zeros(10)
        matrix[:3, :3], matrix[:3, 6:9], matrix[:3, 9] = mass * np.eye(3), -np.eye(3), -side
        right[:3] = -mass * 9.81 * UP
        matrix[3:6, 3:6], matrix[3:6, 6:9] = inertia, -hat(arm)
        right[3:6] = -np.cross(omega, inertia @ omega)
        # d(v + ω×r)/dt = 0 with r = −R γ fixed in space, and d(v, β)/dt = 0
        matrix[6:9, :3], matrix[6:9, 3:6] = np.eye(3), -hat(arm)
        matrix[9, :3] = side
        found = turn.T @ np.linalg.solve(matrix, right)[3:6]
        state = {"omega": spin, "attitude": attitude, "x": 0.0}
        assert values(system, list(system.rates[:3]), state) == pytest.approx(found, abs=1e-12)


def test_the_ball_stays_on_its_line() -> None:
    made = built.example("straight-line-ball")
    motion = integrate(made.system, made.start, np.linspace(0.0, 20.0, 201))
    turned = np.array(
        [rows(q) @ w for q, w in zip(motion["attitude"], motion["omega"], strict=True)]
    )
    velocity = np.cross(turned, UP)
    assert np.abs(velocity[:, 1]).max() < 1e-13
    assert np.ptp(velocity[:, 0]) > 0.1
    assert velocity[:, 0] == pytest.approx(motion["speed"], abs=1e-13)


def test_momenta_and_angular_velocity_describe_one_motion() -> None:
    one, other = (entry(f"straight-line-ball{name}") for name in ("", "-momenta"))
    first = built.example(one.name)
    second = built.example(other.name)
    times = np.linspace(0.0, 10.0, 11)
    a, b = (integrate(made.system, made.start, times) for made in (first, second))
    assert a["attitude"] == pytest.approx(b["attitude"], abs=1e-11)
    assert a["omega"] == pytest.approx(b["omega"], abs=1e-11)
    assert a["x"] == pytest.approx(b["x"], abs=1e-11)


def test_supporting_balls_turn_with_the_ball() -> None:
    """Three balls of different size, each with its friction force, against the momentum M."""
    item = entry("ball-bearing")
    generator = np.random.default_rng(3)
    radius, sizes, inertias = 1.3, np.array([0.4, 0.7, 0.2]), np.array([0.11, 0.3, 0.02])
    weights = inertias * radius**2 / sizes**2
    numbers = {f"D_{i}": w for i, w in enumerate(weights, 1)}
    system = item.system(numbers)
    moments = np.array([item.defaults[f"I_{i}"] for i in (1, 2, 3)])
    for _ in range(5):
        turn = np.linalg.qr(generator.normal(size=(3, 3)))[0]
        turn *= np.linalg.det(turn)
        normals = generator.normal(size=(3, 3))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        omega = generator.normal(size=3)
        inertia = turn @ np.diag(moments) @ turn.T
        # unknown, in space axes: ω̇, the three ω̇′ and the three forces on the ball
        matrix, right = np.zeros((21, 21)), np.zeros(21)
        matrix[:3, :3] = inertia
        right[:3] = -np.cross(omega, inertia @ omega)
        for i, (n, size, moment) in enumerate(zip(normals, sizes, inertias, strict=True)):
            turning, force = slice(3 + 3 * i, 6 + 3 * i), slice(12 + 3 * i, 15 + 3 * i)
            matrix[:3, force] = -radius * hat(n)
            matrix[turning, turning] = moment * np.eye(3)
            matrix[turning, force] = -size * hat(n)
            # R ω×n + ρ ω′×n = 0 has two components; the force has none along n
            matrix[force, :3] = -radius * hat(n)
            matrix[force, turning] = -size * hat(n)
            matrix[force, force] = np.outer(n, n)
        found = np.linalg.solve(matrix, right)[:3]
        tensor = inertia + weights.sum() * np.eye(3) - (normals.T * weights) @ normals
        state = {"M": turn.T @ tensor @ omega}
        state |= dict(zip(("alpha", "beta", "gamma"), normals @ turn, strict=True))
        spin = list(entry_spin(system))
        assert turn @ values(system, spin, state) == pytest.approx(omega, abs=1e-12)
        rates = values(system, list(system.rates), state)
        near = [values(system, spin, moved(system, state, step * rates)) for step in (STEP, -STEP)]
        assert turn @ (near[0] - near[1]) / (2 * STEP) == pytest.approx(found, abs=1e-8)


def entry_spin(system: System) -> Any:
    """The components of ω."""
    return next(o.value for o in system.observables if o.name == "omega").symbols


def moved(system: System, state: dict[str, Any], change: Any) -> dict[str, Any]:
    """A state of vectors, moved."""
    return {
        str(name): state[str(name)] + change[3 * i : 3 * i + 3]
        for i, name in enumerate(system.state)
    }


# --- the rattleback ------------------------------------------------------------------------


def divergence(turn: float) -> float:
    """Trace of the equations of the rattleback at a steady spin of unit momentum."""
    system = entry("rattleback").system({"delta": turn})
    state = {"M": np.array([0.0, 0.0, 1e-3]), "gamma": UP}
    flat = np.concatenate([state["M"], state["gamma"]])
    assert np.abs(values(system, list(system.rates), state)).max() < 1e-18
    total = 0.0
    for i in range(6):
        step = 1e-7 * (1e-3 if i < 3 else 1.0)
        ends = []
        for sign in (1, -1):
            point = flat.copy()
            point[i] += sign * step
            named = {"M": point[:3], "gamma": point[3:]}
            ends.append(values(system, list(system.rates), named)[i])
        total += (ends[0] - ends[1]) / (2 * step)
    return float(total)


@pytest.mark.slow
def test_a_steady_spin_of_the_rattleback_admits_no_smooth_measure() -> None:
    """A smooth density would make the divergence vanish at fixed points; turned axes forbid it."""
    straight = divergence(0.0)
    assert abs(straight) < 1e-9
    one, other = divergence(0.1), divergence(-0.1)
    assert one == pytest.approx(-other, rel=1e-5)
    assert abs(one) > 1e-4


def test_the_densities_of_bearing_and_line_are_positive() -> None:
    """The identities behind the signs: a positive form, and a determinant as a positive sum."""
    a, x, g = (sp.Matrix(sp.symbols(f"{n}_1:4", real=True)) for n in "axg")
    moments = sp.diag(*sp.symbols("I_1:4", positive=True))
    D = sp.Symbol("D", positive=True)
    form = x.dot(x) * a.dot(a) - x.dot(a) ** 2
    assert sp.expand(form - a.cross(x).dot(a.cross(x))) == 0
    # β, γ as any two vectors, α = β×γ; γ² stands beside D, where it is one
    first = a.dot(moments * a) + D
    across = first * g.dot(moments * g) - a.dot(moments * g) ** 2
    normal = a.cross(g)
    inverse = moments.det() * moments.inv()
    assert sp.expand(across - normal.dot(inverse * normal) - D * g.dot(moments * g)) == 0


@pytest.mark.slow
@pytest.mark.parametrize("name", ["ball-bearing", "straight-line-ball"])
def test_their_measures_are_positive_everywhere(name: str) -> None:
    system = entry(name).system()
    patience = ProofBudget(EFFORT)
    place = classify_laws(system, patience.verdicts(system), patience)
    assert [density.sign for density in place.measures] == ["kept"]
    kinds = {kind.name for kind in place.kinds}
    assert ("euler-jacobi" in kinds) == (name == "ball-bearing")
