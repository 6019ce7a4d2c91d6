"""§5 by independent numbers: turning points, periods and volumes along computed motions."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from borisov_mamaev_2008.methods.marble_bodies_of_revolution import (
    curvatures,
    height,
    lens,
    linear_integral,
    slope,
)
from flowlanes import lambdify
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue import CATALOGUE
from nonholonomic.catalogue.angles import in_angles

MASS, GRAVITY, RADIUS, SHIFT = 1.3, 9.81, 0.9, 0.25
ACROSS, ALONG = 0.6, 0.9

#: B(θ), A²(θ) and U(θ) as §5 prints them, for a centre at −SHIFT on the axis.
DISK = (
    lambda t: ACROSS + MASS * (RADIUS**2 + SHIFT**2) + 0 * t,
    lambda t: (
        ACROSS * np.cos(t) ** 2
        + ALONG * np.sin(t) ** 2
        + MASS * (RADIUS * np.sin(t) + SHIFT * np.cos(t)) ** 2
    ),
    lambda t: MASS * GRAVITY * (RADIUS * np.sin(t) + SHIFT * np.cos(t)),
)
BALL = (
    lambda t: ACROSS + MASS * (RADIUS**2 + SHIFT**2 + 2 * RADIUS * SHIFT * np.cos(t)),
    lambda t: (
        ACROSS * np.cos(t) ** 2 + ALONG * np.sin(t) ** 2 + MASS * (RADIUS + SHIFT * np.cos(t)) ** 2
    ),
    lambda t: MASS * GRAVITY * (RADIUS + SHIFT * np.cos(t)),
)
PROFILES = {"rubber-disk": DISK, "rubber-routh-sphere": BALL}


def system(name):
    numbers = {
        "m": MASS,
        "g": GRAVITY,
        "R": RADIUS,
        "c_3": -SHIFT,
        "I_1": ACROSS,
        "I_3": ALONG,
    }
    return in_angles(CATALOGUE[name].system(numbers))


def motion(name, start, until, **options):
    field = lambdify(system(name))
    return solve_ivp(field, (0.0, until), start, rtol=1e-11, atol=1e-12, **options)


@pytest.mark.parametrize("name", PROFILES)
@pytest.mark.parametrize("spin", [4.0, -3.0])
def test_nutation_and_rotation_follow_from_the_quadratures(name, spin):
    B, square, U = PROFILES[name]
    theta, speed = 1.1, 0.3
    k = np.sqrt(square(theta)) * spin * np.sin(theta) ** 2
    h = B(theta) * speed**2 / 2 + k**2 / (2 * np.sin(theta) ** 2) + U(theta)

    def rest(t):
        return 2 * (h - U(t) - k**2 / (2 * np.sin(t) ** 2)) / B(t)

    fine = np.linspace(theta, np.pi - 1e-3, 2000)
    above = next(brentq(rest, a, b) for a, b in itertools.pairwise(fine) if rest(a) * rest(b) < 0)
    # θ = above − x² takes the root out of the integrand at the turning point
    reach = np.sqrt(above - theta)

    def time(x):
        t = above - x**2
        return 2 * x / np.sqrt(rest(t)) if x > 0 else 0.0

    duration = quad(time, 1e-9, reach, epsabs=1e-9)[0]
    turned = quad(
        lambda x: time(x) * k / (np.sqrt(square(above - x**2)) * np.sin(above - x**2) ** 2),
        1e-9,
        reach,
        epsabs=1e-9,
    )[0]

    def turning(_, state):
        return state[2]

    turning.terminal, turning.direction = True, -1
    found = motion(name, [theta, 0.0, speed, spin], 20.0, events=turning)
    assert found.t_events[0][0] == pytest.approx(duration, abs=1e-7)
    assert found.y[:2, -1] == pytest.approx([above, turned], abs=1e-7)
    assert np.sign(found.y[1, -1]) == np.sign(spin)


@pytest.mark.slow
@pytest.mark.parametrize("name", PROFILES)
def test_volumes_with_the_density_ba_are_kept(name):
    B, square, _ = PROFILES[name]

    def density(state):
        theta = state[0]
        # d³ω d³γ on the phase space is sin²θ dθ dφ dθ̇ dφ̇
        return B(theta) * np.sqrt(square(theta)) * np.sin(theta) ** 2

    start, step = np.array([1.1, 0.2, 0.4, 2.0]), 1e-5

    def end(state):
        return motion(name, state, 1.5).y[:, -1]

    slopes = [(end(start + step * e) - end(start - step * e)) / (2 * step) for e in np.eye(4)]
    volume = np.linalg.det(np.array(slopes))
    kept = volume * density(end(start)) / density(start)
    assert kept == pytest.approx(1.0, abs=1e-5)
    assert abs(volume - 1) > 1e-2


def profile(u, start, until):
    """p, p′ and both radii of curvature of a lens with I₃ = 0.2, m = 1, from γ₃ = u on."""
    symbols = (sp.Symbol("gamma_3", real=True), height, slope)
    numbers = {sp.Symbol("m", real=True): 1, sp.Symbol("I_3", real=True): sp.Rational(1, 5)}
    radii = sp.lambdify(symbols, [formula.xreplace(numbers) for formula in curvatures()])

    def rate(x, state):
        along, across = radii(x, *state)
        return [state[1], (along - across) / (1 - x**2)]

    found = solve_ivp(rate, (u, until), start, rtol=1e-11, atol=1e-12, dense_output=True)
    return found.sol, radii


def test_a_lens_is_convex_from_its_pole_outwards():
    sol, radii = profile(0.9999, (1.0, 0.0), 0.93)
    places = np.linspace(0.9999, 0.93, 100)
    along, across = np.array([radii(u, *sol(u)) for u in places]).T
    assert min(along.min(), across.min()) > 0
    assert along[0] == pytest.approx(across[0], rel=0.01)
    # far from a sphere at the rim
    assert along[-1] > 10 * across[-1]


def test_a_lens_keeps_its_linear_integral_along_a_motion():
    system = lens(sp.S.Zero)
    gamma = np.array([0.168, 0.224, 0.96])
    sol, _ = profile(0.9999, (1.0, 0.0), 0.93)
    start = np.concatenate([[0.3, -0.2, 0.5], gamma, sol(gamma[2])])
    found = solve_ivp(lambdify(system), (0.0, 0.2), start, rtol=1e-11, atol=1e-12)
    assert 0.93 < found.y[5].min() < found.y[5].max() < 0.9999
    symbols = (*system.symbols, *(p.symbol for p in system.parameters))
    value = to_components(linear_integral().value)
    for symbol, formula in reversed(system.scalar_definitions):
        value = value.xreplace({symbol: formula})
    numbers = [p.default for p in system.parameters]
    along = sp.lambdify(symbols, value)(*found.y, *numbers)
    assert np.ptp(along) < 1e-9 * abs(along[0])
    # the third momentum itself, the profile and the axis do change
    assert np.ptp(found.y[2]) > 1e-2
    # p and p′ stay those of one and the same body
    assert pytest.approx(np.array([sol(u) for u in found.y[5]]), abs=1e-7) == found.y[6:].T
