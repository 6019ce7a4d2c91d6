"""Balls of n dimensions on a sphere: against Newton's equations with multipliers, and laws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.laws import Measure
from lawproof.proof.prover import prove, prove_all
from nonholonomic.catalogue import entry, from_catalogue

MARBLE, RUBBER = "chaplygin-ball-on-sphere-nd", "rubber-ball-on-sphere-nd"
MASS, RADIUS, UNTIL = 1.3, 0.9, 10.0
Array = np.ndarray


def skew(entries: Array, n: int) -> Array:
    matrix = np.zeros((n, n))
    matrix[np.triu_indices(n, 1)] = entries
    return matrix - matrix.T


def rates(n: int, inertia: Array, a: float, rubber: bool) -> Callable[[float, Array], Array]:
    """Attitude, centre, ω and velocity in space, with the contact force as an unknown."""
    N, place = n * (n - 1) // 2, np.triu_indices(n, 1)
    basis = [skew(row, n) for row in np.eye(N)]

    def rate(_: float, y: Array) -> Array:
        G, X = y[: n * n].reshape(n, n), y[n * n : n * n + n]
        omega, v = y[n * n + n : n * n + n + N], y[n * n + n + N :]
        W, M = skew(omega, n), skew(inertia @ omega, n)
        gamma = G.T @ X / (a + RADIUS)
        turning = G.T @ v / (a + RADIUS) - W @ gamma
        # the velocity of the centre is R G ω γ
        rows = [np.column_stack([*(-RADIUS * G @ (B @ gamma) for B in basis), np.eye(n)])]
        right = [RADIUS * (G @ (W @ W @ gamma + W @ turning))]
        if rubber:
            # ω = u∧γ has no part in planes across γ, and its rate there is that of u∧γ̇
            Q = np.linalg.svd(gamma[None, :])[2][1:]
            across = list(combinations(range(n - 1), 2))
            u = W @ gamma
            moved = Q @ (np.outer(u, turning) - np.outer(turning, u)) @ Q.T
            turned = [Q @ B @ Q.T for B in basis]
            block = np.array([[*(Z[i] for Z in turned), *np.zeros(n)] for i in across])
            rows.append(block.reshape(len(across), N + n))
            right.append(np.array([moved[i] for i in across]))
        A = np.vstack(rows)
        size = N + n + len(A)
        K = np.zeros((size, size))
        K[:N, :N], K[N : N + n, N : N + n] = inertia, MASS * np.eye(n)
        K[: N + n, N + n :], K[N + n :, : N + n] = A.T, A
        free = (M @ W - W @ M)[place]
        x = np.linalg.solve(K, np.concatenate([free, np.zeros(n), *right]))
        return np.concatenate([(G @ W).ravel(), v, x[: N + n]])

    return rate


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["moments", "mass_tensor"])
@pytest.mark.parametrize("a", [2.0, -3.1, -0.6])
@pytest.mark.parametrize("n", [3, 4, 5, 6])
@pytest.mark.parametrize("name", [MARBLE, RUBBER])
def test_the_motion_is_that_of_the_unreduced_equations(name, n, a, kind):
    rng = np.random.default_rng(n)
    N, place = n * (n - 1) // 2, np.triu_indices(n, 1)
    half = rng.normal(size=(n, n))
    J = half @ half.T / n + 0.2 * np.eye(n)
    moments = rng.uniform(0.5, 2.0, N)
    units = [skew(row, n) for row in np.eye(N)]
    inertia = np.array([(J @ B + B @ J)[place] for B in units])
    if kind == "moments":
        inertia = np.diag(moments)
    G = np.linalg.qr(rng.normal(size=(n, n)))[0]
    G[0] *= np.linalg.det(G)
    normal = rng.normal(size=n)
    normal /= np.linalg.norm(normal)
    gamma = G.T @ normal
    W = skew(0.7 * rng.normal(size=N), n)
    if name == RUBBER:
        W = np.outer(W @ gamma, gamma) - np.outer(gamma, W @ gamma)
    given = {kind: moments if kind == "moments" else J}
    ball = from_catalogue(name, mass=MASS, radius=RADIUS, a=a, **given)
    run = integrate(ball, {"attitude": G, "gamma": gamma, "omega": W[place]}, [0.0, UNTIL])
    centre = (a + RADIUS) * normal
    start = np.concatenate([G.ravel(), centre, W[place], RADIUS * G @ W @ gamma])
    function = rates(n, inertia, a, name == RUBBER)
    end = solve_ivp(function, (0.0, UNTIL), start, "DOP853", rtol=3e-14, atol=1e-14).y[:, -1]
    X = end[n * n : n * n + n] / (a + RADIUS)
    assert run["attitude"][-1] == pytest.approx(end[: n * n], abs=1e-10)
    assert run["omega"][-1] == pytest.approx(end[n * n + n : n * n + n + N], abs=1e-10)
    assert run["contact"][-1] == pytest.approx(a * X, abs=1e-10)
    assert run["gamma"][-1] == pytest.approx(end[: n * n].reshape(n, n).T @ X, abs=1e-10)


@pytest.mark.parametrize("name", [MARBLE, RUBBER])
def test_three_dimensions_are_the_balls_of_the_catalogue(name):
    moments = (1.0, 1.5, 2.1)
    there = from_catalogue({MARBLE: "ball-on-sphere", RUBBER: "rubber-ball-on-sphere"}[name])
    ball = from_catalogue(name, moments=moments[::-1], a=2.0)
    gamma = np.array([0.2, -0.3, 0.93]) / np.linalg.norm([0.2, -0.3, 0.93])
    omega = np.array([0.9, -0.5, 0.4])
    if name == RUBBER:
        omega -= omega @ gamma * gamma
    pair = (-omega[2], omega[1], -omega[0])
    ours = integrate(ball, {"omega": pair, "gamma": gamma}, [0.0, 5.0])
    theirs = integrate(
        there,
        {"omega": omega, "gamma": gamma},
        [0.0, 5.0],
        parameters={"a": 2.0, "R": 1.0, "m": 1.0, "I_1": 1.0, "I_2": 1.5, "I_3": 2.1},
    )
    assert ours["gamma"][-1] == pytest.approx(theirs["gamma"][-1], abs=1e-13)


@pytest.mark.parametrize("name", [MARBLE, RUBBER])
def test_a_dataset_has_the_contact_point_by_as_many_coordinates_as_the_space(name):
    ball = from_catalogue(name, dimension=4)
    start = entry(name).member({"dimension": 4}).start.values
    contact = integrate(ball, start, [0.0, 1.0]).to_dataset()["contact"]
    assert contact.dims == ("time", "space_axis")
    assert contact.shape[1] == 4


@pytest.mark.parametrize(
    ("name", "n"),
    [
        (MARBLE, 3),
        pytest.param(MARBLE, 4, marks=pytest.mark.slow),
        pytest.param(RUBBER, 3, marks=pytest.mark.slow),
        pytest.param(RUBBER, 4, marks=pytest.mark.slow),
    ],
)
def test_laws_are_proven_and_another_measure_is_refuted(name, n):
    ball = from_catalogue(name, dimension=n, a=-3.0)
    assert {v.decision for v in prove_all(ball)} == {"proven"}
    slips = tuple(
        replace(law, density=tuple((b, e + sp.Rational(1, 2)) for b, e in law.density))
        for law in ball.laws
        if isinstance(law, Measure)
    )
    assert prove(replace(ball, laws=slips), "measure").decision == "refuted"


def test_on_a_sphere_of_its_own_radius_the_rubber_ball_is_hamiltonian():
    ball = from_catalogue(RUBBER, dimension=4, a=1.0)
    form = next(law for law in ball.laws if law.name == "hamiltonian")
    assert prove(ball, form).decision == "proven"
    # for other radii it is not, with or without the theorem
    for system in (ball, replace(ball, theorems=())):
        assert prove(system, replace(form, level=())).decision == "refuted"


@pytest.mark.slow
def test_its_form_in_three_dimensions_is_proven_without_the_theorem():
    ball = replace(from_catalogue(RUBBER, dimension=3), theorems=())
    assert prove(ball, "hamiltonian").decision == "proven"


@pytest.mark.parametrize("a", [0.0, -1.0, float("nan")])
def test_a_sphere_that_cannot_be_is_refused(a):
    with pytest.raises(InputError) as caught:
        from_catalogue(MARBLE, a=a)
    assert "radius of the sphere" in str(caught.value)
