"""What drift and controls span, against linear algebra of commutators written out."""

from __future__ import annotations

import numpy as np
import pytest

from nonholonomic.control import MovingMass, Rotor, SphericalRobot, accessibility, pendulum
from nonholonomic.control.accessible import Accessibility
from nonholonomic.control.compiled_equations import CompiledEquations
from nonholonomic.control.equations import controlled_system

SLIDER = MovingMass(1.0, ("s", "0", "1/5"), ("s",), (0.0,))


def robot(contact: str = "marble", **changes: object) -> SphericalRobot:
    given = {"moving_mass": pendulum(1.0, 0.5), "gravity": 9.81, **changes}
    return SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, contact=contact, **given)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("contact", "growth", "dimension"),
    [("marble", (3, 5, 10, 12), 12), ("rubber", (3, 5, 9, 10, 11), 11)],
)
def test_a_pendulum_makes_a_shell_accessible(
    contact: str, growth: tuple[int, ...], dimension: int
) -> None:
    found = accessibility(robot(contact))
    assert (found.growth, found.dimension, found.exact) == (growth, dimension, True)
    assert found.accessible and "accessible from generic states, proven" in str(found)


@pytest.mark.slow
def test_a_balanced_ball_keeps_its_momentum() -> None:
    """Its three components in space are constant: as many dimensions are never spanned."""
    rotors = tuple(Rotor(e, 0.1) for e in ((1, 0, 0), (0, 1, 0)))
    found = accessibility(SphericalRobot(1.0, (0.4, 0.5, 0.6), 1.0, rotors))
    assert found.dimension == 10 and found.growth[-1] == 7
    assert not found.accessible and "not all" in str(found)


def test_the_second_dimensions_are_those_of_commutators_by_differences() -> None:
    """Drift, ∂/∂u and [∂/∂u, f] = ∂f/∂u at a state, by the exact slopes of the rates."""
    found = accessibility(robot(moving_mass=SLIDER))
    system = controlled_system(robot(moving_mass=SLIDER))
    equations = CompiledEquations(system)
    rng = np.random.default_rng(4)
    point = rng.normal(size=len(system.state) + 1)
    point[:4] /= np.linalg.norm(point[:4])
    drift = np.append(equations.rates(point[None])[0], 0.0)
    control = np.eye(len(point))[-1]
    bracket = np.append(equations.slopes(point[None])[0][:, -1], 0.0)
    rank = np.linalg.matrix_rank(np.array([drift, control, bracket]), tol=1e-9)
    assert found.growth[:2] == (2, 3) and rank == 3
    assert isinstance(found, Accessibility)
