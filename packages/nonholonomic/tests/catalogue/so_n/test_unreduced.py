"""Motions of the catalogue in n dimensions against unreduced ones with all reactions."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import special_ortho_group

from catalogue.so_n import unreduced
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue

MASS, RADIUS = 1.3, 0.8
NAMES = ("suslov-nd", "veselova-nd", "chaplygin-ball-nd", "rubber-chaplygin-ball-nd")


def settings(n, kind, rng):
    """Moments or a mass tensor that is not diagonal, with the operator on pairs."""
    if kind == "moments":
        moments = rng.uniform(0.5, 2.5, n * (n - 1) // 2)
        return {"moments": moments.tolist()}, unreduced.operator_of_moments(moments, n)
    axes = special_ortho_group.rvs(n, random_state=rng)
    tensor = axes @ np.diag(rng.uniform(0.3, 1.5, n)) @ axes.T
    tensor = (tensor + tensor.T) / 2
    return {"mass_tensor": tensor.tolist()}, unreduced.operator_of_mass_tensor(tensor)


def body(name, n, inertia):
    match name:
        case "suslov-nd":
            return unreduced.suslov(n, inertia)
        case "veselova-nd":
            return unreduced.veselova(n, inertia)
        case "chaplygin-ball-nd":
            return unreduced.marble_ball(n, inertia, MASS, RADIUS)
    return unreduced.rubber_ball(n, inertia, MASS, RADIUS)


def admissible(name, omega, gamma):
    """The part of ω that the constraint admits."""
    n = len(gamma)
    if name == "suslov-nd":
        omega = omega.copy()
        omega[: n - 1, : n - 1] = 0.0
    elif name != "chaplygin-ball-nd":
        u = omega @ gamma
        omega = np.outer(u, gamma) - np.outer(gamma, u)
    return omega


CASES = [
    pytest.param(name, n, kind, marks=() if n == 3 else pytest.mark.slow)
    for name in NAMES
    for n in (3, 4, 5, 6)
    for kind in ("moments", "mass_tensor")
]


@pytest.mark.parametrize(("name", "n", "kind"), CASES)
def test_the_motion_is_that_of_the_body_with_all_reactions(name, n, kind):
    rng = np.random.default_rng(NAMES.index(name) + 10 * n)
    given, inertia = settings(n, kind, rng)
    g = special_ortho_group.rvs(n, random_state=rng)
    omega = admissible(name, unreduced.skew(rng.normal(size=n * (n - 1) // 2), n), g[-1])
    rolls = "ball" in name
    velocity = RADIUS * (g @ omega @ g[-1]) if rolls else np.zeros(n)
    times = np.linspace(0.0, 10.0, 3)
    attitude, spin, centre = body(name, n, inertia).motion(
        g, unreduced.above(omega), velocity, times
    )
    size = {"mass": MASS, "radius": RADIUS} if rolls else {}
    system = from_catalogue(name, dimension=n, **given, **size)
    start = {"attitude": g, "omega": unreduced.above(omega)}
    motion = integrate(system, start, times).to_dataset()
    assert np.abs(motion["attitude"].values - attitude).max() < 1e-10
    assert np.abs(motion["omega"].values - spin).max() < 1e-10
    assert np.ptp(motion["gamma"].values, axis=0).max() > 0.1
    if rolls:
        assert np.abs(motion["contact"].values - centre[:, : n - 1]).max() < 1e-10
        assert np.abs(centre[:, n - 1]).max() < 1e-12
        assert np.abs(centre).max() > 0.1
