import numpy as np
import pytest
from flint import arb

from nonholonomic.closed_form.genus_two.quadrature import quadrature, series
from nonholonomic.closed_form.genus_two.third_frequency import turning

V_0 = np.array([0.3, -0.4])


def smooth(v: np.ndarray) -> list[np.ndarray]:
    """An analytic function of period 2."""
    return [1 / (1.7 + np.cos(np.pi * v[:, 0]) * np.sin(np.pi * (v[:, 1] - v[:, 0])))]


def by_trapezoids(rate: object, V: np.ndarray, until: float) -> float:
    """∫ of a function of v along the flow, by Gauss's rule in many pieces."""
    nodes, weights = np.polynomial.legendre.leggauss(20)
    pieces = 400
    edges = np.linspace(0, until, pieces + 1)
    tau = ((edges[1:] + edges[:-1])[:, None] / 2 + np.diff(edges)[:, None] / 2 * nodes).ravel()
    weight = (np.diff(edges)[:, None] / 2 * weights).ravel()
    return float(np.sum(weight * rate(V_0 + np.outer(tau, V), tau)))


@pytest.mark.parametrize("second", [0.62, 0.5, 0.5 + 1e-9], ids=["generic", "resonant", "near"])
def test_integrals_along_the_flow(second: float) -> None:
    V = np.array([1.0, second])
    (function,) = series(smooth)
    made = quadrature(function, (arb(1), arb(second)), V_0)
    tau = np.array([0.0, 3.7, 40.0])
    value, rate = made.quasi(V_0 + np.outer(tau, V), tau)
    for t, found in zip(tau, made.mean * tau + value, strict=True):
        assert found == pytest.approx(by_trapezoids(lambda v, _: smooth(v)[0], V, t), abs=1e-12)
    assert made.mean + rate == pytest.approx(smooth(V_0 + np.outer(tau, V))[0], abs=1e-13)


def test_slow_terms_are_kept_apart() -> None:
    (function,) = series(smooth)
    assert len(quadrature(function, (arb(1), arb(0.62)), V_0).slow) == 0
    assert len(quadrature(function, (arb(1), arb(0.5 + 1e-9)), V_0).slow) > 0


def test_a_series_takes_the_grid_it_needs() -> None:
    wide, narrow = (
        series(lambda v, q=q: [1 / (1 + q * np.cos(np.pi * v[:, 1]))])[0] for q in (0.1, 0.9)
    )
    assert wide.grid == (32, 32)
    assert narrow.grid[0] == 32 < narrow.grid[1]
    v = np.random.default_rng(1).uniform(0, 2, (9, 2))
    assert narrow(v) == pytest.approx(1 / (1 + 0.9 * np.cos(np.pi * v[:, 1])), abs=1e-14)


@pytest.mark.parametrize("omega", [0.77, -0.5 * np.pi], ids=["generic", "resonant"])
def test_a_third_frequency(omega: float) -> None:
    V = np.array([1.0, 0.5])

    def parts(v: np.ndarray) -> list[np.ndarray]:
        return [smooth(v)[0], np.sin(np.pi * v[:, 0])]

    real, imaginary = series(parts)
    made = turning(real, imaginary, (arb(1), arb(0.5)), V_0, omega, 0.2)
    for t in (2.1, 30.0):

        def rate(v: np.ndarray, tau: np.ndarray) -> np.ndarray:
            one, other = parts(v)
            return ((one + 1j * other) * np.exp(1j * (omega * tau + 0.2))).real

        found = made.values(V_0 + np.outer([t], V), np.array([t]))[0]
        assert found == pytest.approx(by_trapezoids(rate, V, t), abs=1e-12)


def test_a_function_that_vanishes_beside_one_that_does_not() -> None:
    _, nothing = series(lambda v: [smooth(v)[0], 1e-18 * np.sin(np.pi * v[:, 0])])
    made = quadrature(nothing, (arb(1), arb(0.62)), V_0)
    value, rate = made.quasi(V_0[None, :], np.array([3.0]))
    assert (made.mean, value[0], rate[0]) == (0.0, 0.0, 0.0)
