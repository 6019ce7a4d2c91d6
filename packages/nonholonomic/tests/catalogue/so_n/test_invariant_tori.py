"""The flow on invariant tori against the equations of the Veselova top and the rubber ball."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.system import System
from lawproof.proof.prover import prove
from nonholonomic.catalogue.so_n.invariant_tori import torus_system


def across(J: np.ndarray, gamma: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Eigenvalues and eigenvectors of J across γ, without γ itself."""
    projector = np.eye(len(J)) - np.outer(gamma, gamma)
    values, vectors = np.linalg.eigh(projector @ J @ projector + 1e2 * np.outer(gamma, gamma))
    return values[:-1], vectors[:, :-1]


def rate(J: np.ndarray, D: float, p: np.ndarray, gamma: np.ndarray) -> tuple[np.ndarray, ...]:
    """ṗ = (u, p)γ and γ̇ = −u with B u = p, B e = ((I + D)(e ∧ γ))γ."""
    n = len(J)
    B = (
        (J + gamma @ J @ gamma * np.eye(n))
        - np.outer(J @ gamma, gamma)
        - np.outer(gamma, J @ gamma)
        + D * (np.eye(n) - np.outer(gamma, gamma))
        + np.outer(gamma, gamma)
    )
    u = np.linalg.solve(B, p)
    return (u @ p) * gamma, -u, u


def on_level(
    c: list[float], f: list[float], D: float, angles: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A state (p, γ) with 2E = 1 on the torus, and σ, at given angles in (0, π)."""
    n = len(c)
    roots = np.sort([*c, *f])
    low, high = roots[::2], roots[1::2]
    sigma = (low + high) / 2 - (high - low) / 2 * np.cos(angles)
    squares = [
        np.prod(c[i] - sigma) / np.prod([c[i] - c[j] for j in range(n) if j != i]) for i in range(n)
    ]
    gamma = np.sqrt(squares)
    values, vectors = across(np.diag(c), gamma)
    assert np.allclose(values, sigma)
    u = np.zeros(n)
    for k in range(n - 1):
        others = np.delete(sigma, k)
        beta = sum(c) + D - others.sum()
        square = np.prod(sigma[k] - np.array(f)) / (beta * np.prod(sigma[k] - others))
        e = vectors[:, k]
        # dσ_k/dt = 2 (u, e)(e, Jγ) is positive
        u += np.sign(e @ (np.array(c) * gamma)) * np.sqrt(square) * e
    J = np.diag(c)
    momentum = J @ np.outer(u, gamma) - J @ np.outer(gamma, u)
    momentum += np.outer(u, gamma) @ J - np.outer(gamma, u) @ J
    return momentum @ gamma + D * u, gamma, sigma


def angular_rates(system: System, angles: np.ndarray) -> np.ndarray:
    values = dict(zip(system.symbols, map(sp.Float, angles), strict=True))
    for symbol, formula in system.scalar_definitions:
        values[symbol] = formula.subs(values)
    return np.array([float(formula.subs(values)) for formula in system.rates])


@pytest.mark.parametrize("D", [0.0, 5.0])
@pytest.mark.parametrize(
    ("c", "f"),
    [
        ([1.0, 2.0, 4.0], [2.5]),
        ([1.0, 4.0, 13.0, 30.0], [7.0, 20.0]),
        ([1.0, 4.0, 13.0, 30.0], [2.0, 3.5]),
        ([1.0, 4.0, 13.0, 30.0], [7.0, 10.0]),
        ([1.0, 2.0, 4.0, 7.0, 8.0], [1.5, 3.0, 7.5]),
    ],
)
def test_the_rates_are_those_of_the_body(c: list[float], f: list[float], D: float) -> None:
    if f == [2.0, 3.5]:
        with pytest.raises(InputError, match="there is no motion"):
            torus_system(c, f, D)
        return
    n = len(c)
    angles = np.linspace(0.7, 2.2, n - 1)
    p, gamma, _ = on_level(c, f, D, angles)
    J = np.diag(c)
    _, gamma_dot, u = rate(J, D, p, gamma)
    assert abs(u @ p - 1) < 1e-12
    step = 1e-5
    forward, _ = across(J, gamma + step * gamma_dot)
    backward, _ = across(J, gamma - step * gamma_dot)
    sigma_dot = (forward - backward) / (2 * step)
    roots = np.sort([*c, *f])
    amplitude = (roots[1::2] - roots[::2]) / 2
    expected = sigma_dot / (amplitude * np.sin(angles))
    assert angular_rates(torus_system(c, f, D), angles) == pytest.approx(expected, rel=1e-6)


@pytest.mark.slow
def test_long_motions_agree() -> None:
    c, f, D = [1.0, 4.0, 13.0, 30.0], [7.0, 20.0], 5.0
    angles = np.array([0.7, 1.1, 1.9])
    p, gamma, _ = on_level(c, f, D, angles)
    J, time, step = np.diag(c), 0.0, 1e-3
    state = np.concatenate([p, gamma])

    def field(x: np.ndarray) -> np.ndarray:
        return np.concatenate(rate(J, D, x[:4], x[4:])[:2])

    while time < 20 - step / 2:
        a = field(state)
        b = field(state + step / 2 * a)
        d = field(state + step / 2 * b)
        e = field(state + step * d)
        state = state + step / 6 * (a + 2 * b + 2 * d + e)
        time += step
    last = integrate(torus_system(c, f, D), angles, [0.0, 20.0]).states[-1]
    roots = np.sort([*c, *f])
    sigma = roots[::2] + (roots[1::2] - roots[::2]) * (1 - np.cos(last)) / 2
    assert across(J, state[4:])[0] == pytest.approx(sigma, rel=1e-8)


def test_the_measure_is_proven_and_a_wrong_one_refuted() -> None:
    system = torus_system([1, 2, 4], [3])
    (measure,) = system.laws
    assert prove(system, measure).decision == "proven"
    (base, _), *others = measure.density
    wrong = type(measure)("wrong", {base: sp.Rational(1, 2), **dict(others)})
    assert prove(system, wrong).decision == "refuted"


@pytest.mark.parametrize(
    ("masses", "zeros", "words"),
    [
        ([1, 2], [], "n ≥ 3"),
        ([1, 2, 3], [1.5, 2.5], "n − 2"),
        ([1, 3, 2], [1.5], "masses: the numbers must be distinct"),
        ([1, 2, 3], [2], "differ from all masses"),
        ([1, 4, 13, 30], [20, 7], "zeros: the numbers must be distinct"),
    ],
)
def test_mistakes_are_one_sentence(masses: list[float], zeros: list[float], words: str) -> None:
    with pytest.raises(InputError, match=words):
        torus_system(masses, zeros)
