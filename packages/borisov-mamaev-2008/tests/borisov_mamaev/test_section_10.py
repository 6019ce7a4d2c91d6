"""§10 by Newton and Euler with numbers: the integrals, the direction of a, the missing measure."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from borisov_mamaev_2008.methods.measure_theorems import has_no_measure
from borisov_mamaev_2008.obstructions.limit_cycle import (
    ABOVE,
    BELOW,
    CASE,
    displacement,
    limit_cycle,
)
from lawproof.proof.verdict import Verdict
from nonholonomic.catalogue import CATALOGUE

MASS, RADIUS = 1.3, 0.75
INERTIA = np.array([1.0, 1.5, 2.1])
#: From the centre of mass to the geometric centre.
CENTRE = np.array([0.1, -0.2, 0.3])


def hat(vector):
    x, y, z = vector
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rate(k, rubber):
    """ω̇, γ̇ from the balance of momentum and angular momentum with the reactions N and λγ.

    Unknowns: ω̇, N, λ.  The centre of mass moves by v = r×ω, and r = centre − Rγ.
    """

    def right(_, state):
        omega, gamma = state[:3], state[3:]
        turned = k * np.cross(gamma, omega)
        r, r_rate = CENTRE - RADIUS * gamma, -RADIUS * turned
        velocity = np.cross(r, omega)
        matrix, known = np.zeros((7, 7)), np.zeros(7)
        # m (ṙ×ω + r×ω̇ + ω×v) = N
        matrix[:3, :3], matrix[:3, 3:6] = MASS * hat(r), -np.eye(3)
        known[:3] = -MASS * (np.cross(r_rate, omega) + np.cross(omega, velocity))
        # I ω̇ + ω×Iω = r×N + λγ
        matrix[3:6, :3], matrix[3:6, 3:6] = np.diag(INERTIA), -hat(r)
        matrix[3:6, 6] = -gamma
        known[3:6] = np.cross(INERTIA * omega, omega)
        # (ω, γ) stays, or there is no λ
        if rubber:
            matrix[6, :3], known[6] = gamma, -omega @ turned
        else:
            matrix[6, 6] = 1
        return np.concatenate([np.linalg.solve(matrix, known)[:3], turned])

    return right


def follow(k, rubber):
    gamma = np.array([2.0, -3.0, 6.0]) / 7
    omega = np.array([0.9, -0.5, 1.1])
    if rubber:
        omega -= (omega @ gamma) * gamma
    start = np.concatenate([omega, gamma])
    found = solve_ivp(rate(k, rubber), (0, 20), start, "DOP853", rtol=1e-12, atol=1e-13)
    return found.y[:3].T, found.y[3:].T


def momentum(omega, gamma):
    r = CENTRE - RADIUS * gamma
    return INERTIA * omega + MASS * np.cross(r, np.cross(omega, r)), r


def spread(values):
    return np.ptp(values) / np.abs(values).max()


def dot(a, b):
    return np.sum(a * b, axis=1)


@pytest.mark.parametrize("k", [1.0, 0.7, 1.4, -1.0])
def test_the_marble_integral_on_planes_and_spheres(k):
    omega, gamma = follow(k, rubber=False)
    M, r = momentum(omega, gamma)
    assert spread(dot(M, omega)) < 1e-9
    assert spread(dot(M, M) - MASS * dot(r, r) * dot(M, omega)) < 1e-9
    assert spread(dot(M, M)) > 1e-2


def test_the_rubber_integral_needs_a_towards_the_centre_of_mass():
    omega, gamma = follow(1.0, rubber=True)
    M, _ = momentum(omega, gamma)
    across, energy = np.cross(M, gamma), dot(M, omega)

    def quadratic(a):
        return dot(across, across) - 2 * RADIUS * MASS * (gamma @ a) * energy

    assert spread(energy) < 1e-9
    assert spread(quadratic(-CENTRE)) < 1e-9
    assert spread(quadratic(CENTRE)) > 1e-2


def test_the_rubber_integral_does_not_hold_on_a_sphere():
    omega, gamma = follow(0.7, rubber=True)
    M, r = momentum(omega, gamma)
    across = np.cross(M, gamma)
    assert spread(dot(across, across) - MASS * dot(r, r) * dot(M, omega)) > 1e-3


def test_only_balls_off_their_axis_have_no_measure():
    """There is none for a general centre; the balanced ball has (7.3)."""
    balanced = CATALOGUE["chaplygin-ball"].rolling()
    general = CATALOGUE["unbalanced-ball"].rolling()
    assert has_no_measure(balanced, "balanced").decision == "undecided"
    assert has_no_measure(general, "general").decision == "proven"


# --- the limit cycle -----------------------------------------------------------------------

TENSOR = np.array([float(x) for x in CASE[0]])
KAPPA = np.array([float(x) for x in CASE[1]])
LEVEL = float(CASE[2])


def test_the_ball_with_limit_cycles_exists():
    """Its centre is inside, and its tensor about the centre of mass is that of a body."""
    mass, radius = 1.0, 0.5
    centre = KAPPA / (2 * mass * radius)
    about_centre = mass * (centre @ centre * np.eye(3) - np.outer(centre, centre))
    tensor = np.diag(TENSOR) - mass * radius**2 * np.eye(3) - about_centre
    assert np.linalg.norm(centre) < radius
    assert np.linalg.eigvalsh(np.trace(tensor) / 2 * np.eye(3) - tensor)[0] > 0


def spin_rate(omega, gamma):
    """ω̇ from K ω̇ = Jω×ω + ½(κ, γ×ω)ω + λγ."""
    K = TENSOR - KAPPA @ gamma
    free = np.cross(TENSOR * omega, omega) + KAPPA @ np.cross(gamma, omega) * omega / 2
    along = -(gamma / K) @ free / ((gamma / K) @ gamma)
    return (free + along * gamma) / K


def with_volume(_, state):
    """(10.4) with the divergence of its field; ω̇ is quadratic, so differences are exact."""
    omega, gamma = state[:3], state[3:6]
    divergence = sum(
        (spin_rate(omega + e, gamma)[i] - spin_rate(omega - e, gamma)[i]) / 2
        for i, e in enumerate(np.eye(3))
    )
    return np.concatenate([spin_rate(omega, gamma), np.cross(gamma, omega), [divergence]])


def on_the_level(angle):
    """ω, γ with 2H = 1 and F/2H = λ, at a place of the normal given by an angle."""
    gamma = np.array([0.2, np.cos(angle), np.sin(angle)])
    gamma /= np.linalg.norm(gamma)
    first = np.cross(gamma, [1.0, 0.0, 0.0])
    first /= np.linalg.norm(first)
    second = np.cross(gamma, first)
    s = KAPPA @ gamma

    def both(turn):
        omega = np.cos(turn) * first + np.sin(turn) * second
        M = (TENSOR - s) * omega
        across = np.cross(M, gamma)
        return (across @ across + s * (M @ omega)) / (M @ omega) - LEVEL, M @ omega, omega

    turns = np.linspace(0, np.pi, 200)
    values = [both(turn)[0] for turn in turns]
    i = next(i for i in range(199) if values[i] * values[i + 1] < 0)
    turn = brentq(lambda x: both(x)[0], turns[i], turns[i + 1], xtol=1e-14)
    _, square, omega = both(turn)
    return np.concatenate([omega / np.sqrt(square), gamma, [0.0]])


@pytest.mark.slow
@pytest.mark.parametrize("angle", [0.4, 2.5])
def test_volume_shrinks_along_motions_of_the_torus(angle):
    """Along every quasi-periodic motion with an invariant density it would stay bounded."""
    start = on_the_level(angle)
    found = solve_ivp(with_volume, (0, 120), start, "DOP853", (60, 120), rtol=1e-8, atol=1e-10)
    assert found.y[6, 1] < found.y[6, 0] - 0.5


def test_bounds_of_the_map_enclose_each_other():
    for start in (BELOW, ABOVE):
        lower, upper = displacement(start, False), displacement(start, True)
        closer = displacement(start, False, steps=6000), displacement(start, True, steps=6000)
        assert lower < closer[0] < closer[1] < upper


def test_the_limit_cycle_is_not_claimed_without_its_reduction():
    assert limit_cycle().decision == "proven"
    assert limit_cycle([Verdict("reduction", "undecided")]).decision == "undecided"


def test_a_balanced_ball_is_not_said_to_have_limit_cycles():
    """For κ = 0 the map keeps a density: no two displacements have different signs."""
    balanced = (CASE[0], ("0", "0", "0"), CASE[2])
    assert displacement(BELOW, upwards=True, case=balanced) < 0
    assert displacement(ABOVE, upwards=True, case=balanced) < 0


@pytest.mark.parametrize("level", [0.8, 1.6, 2.6, 2.77])
def test_levels_between_the_outer_moments_are_tori(level):
    """Roots ξ, η on a motion keep to the ranges of `tori`, and reach both ends of both."""
    moments = TENSOR
    low = (moments[0], min(level, moments[1]))
    high = (max(level, moments[1]), moments[2])
    gamma = None
    for angle in np.linspace(0.1, 3.0, 30):
        try:
            start = on_the_level_of(level, angle)
        except StopIteration:
            continue
        gamma = start[3:]
        break
    assert gamma is not None
    times = np.linspace(0, 60, 600)
    found = solve_ivp(rolling, (0, 60), start, "DOP853", times, rtol=1e-8, atol=1e-10)
    roots = np.array([np.sort(quadratic_roots(column[3:])) for column in found.y.T])
    for values, (first, last) in zip(roots.T, (low, high), strict=True):
        room = last - first
        assert first - 1e-6 < values.min() < first + 0.05 * room
        assert last - 0.05 * room < values.max() < last + 1e-6


def rolling(_, state):
    """(10.4)."""
    omega, gamma = state[:3], state[3:]
    return np.concatenate([spin_rate(omega, gamma), np.cross(gamma, omega)])


def quadratic_roots(gamma):
    """The roots of Σ γᵢ²/(Jᵢ − z)."""
    total = np.zeros(3)
    for i, g in enumerate(gamma):
        others = [j for n, j in enumerate(TENSOR) if n != i]
        total += g**2 * np.poly(others)
    return np.roots(total)


def on_the_level_of(level, angle):
    """ω, γ with 2H = 1 and F/2H = `level`."""
    gamma = np.array([0.3, np.cos(angle), np.sin(angle)])
    gamma /= np.linalg.norm(gamma)
    first = np.cross(gamma, [1.0, 0.0, 0.0])
    first /= np.linalg.norm(first)
    second = np.cross(gamma, first)
    s = KAPPA @ gamma

    def excess(turn):
        omega = np.cos(turn) * first + np.sin(turn) * second
        M = (TENSOR - s) * omega
        across = np.cross(M, gamma)
        return (across @ across + s * (M @ omega)) / (M @ omega) - level

    turns = np.linspace(0, np.pi, 200)
    values = [excess(turn) for turn in turns]
    i = next(i for i in range(199) if values[i] * values[i + 1] < 0)
    turn = brentq(excess, turns[i], turns[i + 1], xtol=1e-14)
    omega = np.cos(turn) * first + np.sin(turn) * second
    return np.concatenate([omega / np.sqrt((TENSOR - s) * omega @ omega), gamma])
