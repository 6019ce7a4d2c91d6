"""Systems as maps: what is kept, circles, many rotation numbers."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.kernel.equations import poincare_section
from flowlanes.flow.sections.poincare_map import PoincareMap
from flowlanes.orbits import return_map as module
from flowlanes.orbits.periodic import projection_to_domain
from flowlanes.orbits.return_map import Circle, ReturnMap, parameters_to_state, rotations
from nonholonomic.catalogue.ball_on_sphere import rubber_ball_ratio
from nonholonomic.catalogue.bodies.unbalanced_rubber_ball_centred import torus

SYSTEM = rubber_ball_ratio.rolling().with_laws(
    rubber_ball_ratio.ENERGY, rubber_ball_ratio.ON_PLANE, rubber_ball_ratio.AROUND
)


def returns(k):
    return ReturnMap(PoincareMap(SYSTEM, poincare_section(SYSTEM, "n_2"), {"k": k}))


@pytest.mark.parametrize(
    ("k", "names"),
    [(1.0, ("energy", "momentum")), (-1.0, ("energy", "quadratic")), (0.5, ("energy",))],
)
def test_integrals_are_those_that_hold(k, names):
    assert returns(k).integrals.names == names


@pytest.mark.slow
def test_slopes_keep_integrals_and_agree_with_differences():
    made = returns(1.0)
    point = np.array([[0.3, 0.0, 0.4, -0.8, 0.0, 0.6]])
    image = made.image(point, slopes=True)
    (slope,) = image.slopes
    kept = made.integrals.slopes(image.points)[0] @ slope
    # a direction along relations and section, across the flow
    first = made.integrals.slopes(point)[0]
    tangent = np.linalg.svd(made.domain.slopes(point)[0])[2][3:]
    assert kept @ tangent.T == pytest.approx(first @ tangent.T, abs=1e-10)
    for direction in tangent:
        step = 1e-5 * direction
        ends = [
            made.image(projection_to_domain(made, point + sign * step, made.sizes(point))).points
            for sign in (1, -1)
        ]
        assert slope @ direction == pytest.approx((ends[0] - ends[1])[0] / 2e-5, abs=1e-6)


def test_a_promoted_parameter_stays_what_it_is():
    system = parameters_to_state(SYSTEM, "k", "J_1")
    assert [str(s) for s in system.symbols[-2:]] == ["k", "J_1"]
    made = ReturnMap(PoincareMap(system, poincare_section(system, "n_2")))
    assert made.integrals.names[-2:] == ("k", "J_1")
    start = np.array([[0.3, 0.0, 0.4, -0.8, 0.0, 0.6, 1.0, 2.0]])
    plain = returns(1.0).image(start[:, :6])
    image = made.image(start)
    assert image.points[0, 6:].tolist() == [1.0, 2.0]
    assert image.points[0, :6] == pytest.approx(plain.points[0], abs=1e-11)


def test_rotation_numbers_do_not_depend_on_how_many_are_followed_at_once(monkeypatch):
    theta = np.linspace(0.2, 1.2, 6)
    zero = 0 * theta
    starts = np.stack(
        [np.cos(theta), zero, -np.sin(theta), np.sin(theta), zero, np.cos(theta)], axis=1
    )
    parameters = {"k": np.linspace(0.9, 1.0, 6)}
    made = PoincareMap(SYSTEM, poincare_section(SYSTEM, "n_2"), parameters)
    n = SYSTEM.symbols[3:]
    angle = sp.atan2(n[0], n[2])
    whole = rotations(made, starts, angle, 100)
    monkeypatch.setattr(module, "AT_ONCE", 2 * 100 * 6)
    parts = rotations(made, starts, angle, 100)
    assert whole.outcome.tolist() == parts.outcome.tolist() == [0] * 6
    assert (whole.values == parts.values).all()


def test_a_motion_that_does_not_return_is_marked():
    start = np.array([[0.0, 0.0, 0.5, 1.0, 0.0, 0.0], [0.5, 0.0, 0.0, 1.0, 0.0, 0.0]])
    start[1, :3] = 0.0
    made = PoincareMap(SYSTEM, poincare_section(SYSTEM, "n_2"), {"k": 1.0}, t_end=2000.0)
    found = rotations(made, start, sp.atan2(SYSTEM.symbols[3], SYSTEM.symbols[5]), 20)
    assert np.isfinite(found.values[0])
    assert np.isnan(found.values[1])
    assert found.outcome[1] > 0
    assert made.status_message(int(found.outcome[1]))


def test_mistakes_are_told():
    flow = torus()
    across = PoincareMap(flow, poincare_section(flow, "beta", angle=True))
    with pytest.raises(InputError, match="delta is not a state variable"):
        Circle(across, "delta", "lambda", {})
    with pytest.raises(InputError, match="no parameter mu; it has"):
        Circle(across, "alpha", "mu", {})
    with pytest.raises(InputError, match="angles: delta is not"):
        ReturnMap(across, {"delta": 1.0})
    with pytest.raises(InputError, match="one value of a parameter"):
        ReturnMap(PoincareMap(flow, across.section, {"J_1": np.ones(3)}))
