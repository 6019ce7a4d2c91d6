"""Limit directions of sliding: all of them, what attracts, what holds, and how a slip stops."""

from __future__ import annotations

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from contact.colliding_bodies import collision
from flowlanes.errors import InputError, RunError
from flowlanes.system.arrays import FloatArray
from nonholonomic.contact.impact.friction_response import least_motion
from nonholonomic.contact.impact.mobility import Mobility, mobility
from nonholonomic.contact.impact.painleve import least_painleve_friction
from nonholonomic.contact.slip.frozen_slip import (
    CoupledSlip,
    PointSlip,
    growth_and_turning,
    point_slip,
    point_slip_with_spin_at_rest,
)
from nonholonomic.contact.slip.limit_directions import (
    limit_directions,
    limit_directions_of_coupled_slip,
    rest_of_patch,
    rest_of_point,
)
from nonholonomic.contact.slip.stopping import finish_stop

BALL = mobility(1.0, [0.4, 0.4, 0.4], [0, 0, -1], [0, 0, 1])
#: A body that slides from an open set of directions into rest, and leaves at once another way.
RESTARTING = mobility(1.0, [0.5, 0.3, 0.2], [0.3, -2.0, -1.7], [0, 0, 1])


def ring_force(k: float) -> float:
    """A law like the coupled ones: derivative of √(1 + k²)."""
    return 1.0 if np.isinf(k) else float(k / np.hypot(1, k))


def ring_couple(k: float) -> float:
    return 0.0 if np.isinf(k) else float(1 / np.hypot(1, k))


def inside_ring(force: float, couple: float) -> bool:
    return np.hypot(force, couple) <= 1


def point_slips(seed: int, count: int) -> list[tuple[Mobility, FloatArray, float, PointSlip]]:
    rng, slips = np.random.default_rng(seed), []
    while len(slips) < count:
        m, mu = collision(rng).mobility, rng.uniform(0.05, 1.5)
        b = 2 * rng.normal(size=3)
        b -= (b @ m.gamma + 5 * abs(rng.normal())) * m.gamma
        if mu < least_painleve_friction(m):
            slips.append((m, b, mu, point_slip(m, b, mu)))
    return slips


def circle_rate(slip: PointSlip, angle: float) -> float:
    """The turning G of the slip, across its direction."""
    n = np.array([np.cos(angle), np.sin(angle)])
    _, turning = growth_and_turning(slip, n)
    return float(n[0] * turning[1] - n[1] * turning[0])


# --- Coulomb friction at a point --------------------------------------------------------------


def test_the_rates_are_those_of_the_contact() -> None:
    """The normal acceleration vanishes, and the rest follows from A."""
    for m, b, mu, slip in point_slips(1, 10):
        n = np.array([0.6, -0.8])
        N, f, couple = slip.force(n)
        np.testing.assert_allclose(f, -mu * N * n)
        acceleration = b + m.A @ (N * m.gamma + f @ m.tangents) + couple * m.spin_force
        scale = N * np.abs(m.A).max()
        assert abs(m.gamma @ acceleration) < 1e-14 * scale
        np.testing.assert_allclose(m.tangents @ acceleration, slip.rate(n), atol=1e-13 * scale)


def test_the_rates_with_the_spin_at_rest() -> None:
    m, b, mu, _ = point_slips(2, 1)[0]
    slip = point_slip_with_spin_at_rest(m, b, 0.7, mu)
    n = np.array([0.28, 0.96])
    N, f, couple = slip.force(n)
    force = N * m.gamma + f @ m.tangents
    acceleration = b + m.A @ force + couple * m.spin_force
    assert abs(0.7 + m.spin_force @ force + couple * m.spin) < 1e-12
    assert abs(m.gamma @ acceleration) < 1e-12
    np.testing.assert_allclose(m.tangents @ acceleration, slip.rate(n), atol=1e-12)


def test_all_directions_by_changes_of_sign() -> None:
    for _, _, _, slip in point_slips(3, 40):
        angles = np.linspace(-np.pi, np.pi, 721)
        rates = [circle_rate(slip, angle) for angle in angles]
        roots = [
            brentq(lambda a, slip=slip: circle_rate(slip, a), a, b, xtol=1e-15)
            for a, b, f, g in zip(angles[:-1], angles[1:], rates[:-1], rates[1:], strict=True)
            if f * g < 0
        ]
        found = limit_directions(slip)
        assert len(found) == len(roots)
        for direction, root in zip(found, roots, strict=True):
            n = np.array([np.cos(root), np.sin(root)])
            assert np.abs(direction.direction - n).max() < 1e-11
            ahead, behind = (circle_rate(slip, root + d) for d in (1e-4, -1e-4))
            assert direction.attracts == (ahead < behind)
            assert direction.growth == pytest.approx(growth_and_turning(slip, n)[0], rel=1e-9)


def test_held_or_one_exit_that_attracts() -> None:
    held = 0
    for m, b, mu, slip in point_slips(4, 80):
        rest = rest_of_point(slip)
        force = -np.linalg.solve(m.A, b)
        N = force @ m.gamma
        friction = np.linalg.norm(force - N * m.gamma)
        assert rest.holds == (N > 0 and friction <= mu * N)
        assert rest.normal_force == pytest.approx(N, rel=1e-9)
        assert rest.unique
        if rest.holds:
            assert rest.exit is None
            held += 1
        else:
            assert rest.exit is not None
            assert rest.exit.attracts
    assert 10 < held < 70


def test_with_a_constant_normal_force_the_exit_moves_least() -> None:
    """A_nt = 0: the exit is the minimiser of a convex function, found quite another way."""
    m = mobility(1.0, [0.2, 0.5, 0.9], [0, 0, -1], [0, 0, 1])
    b = np.array([7.0, -4.0, -10.0])
    exit = rest_of_point(point_slip(m, b, 0.2)).exit
    assert exit is not None
    axes = np.linspace(0, 2 * np.pi, 200_001)
    A, t = m.tangents @ m.A @ m.tangents.T, m.tangents
    forces = 2.0 * np.array([np.cos(axes), np.sin(axes)])
    motion = (t @ b)[:, None] + A @ forces
    least = np.argmin(np.einsum("ik,ik->k", motion, np.linalg.solve(A, motion)))
    assert np.abs(motion[:, least] / np.hypot(*motion[:, least]) - exit.direction).max() < 1e-4


def test_every_direction_of_a_ball_without_forces() -> None:
    slip = point_slip(BALL, np.array([0.0, 0.0, -9.81]), 0.3)
    with pytest.raises(InputError, match="every direction"):
        limit_directions(slip)
    rest = rest_of_point(slip)
    assert rest.holds
    assert rest.unique


def test_a_ball_on_a_slope() -> None:
    """Held up to tan α = (7/2) μ; beyond, it slides down with g sin α − (7/2) μ g cos α."""
    for slope, holds in ((1.04, True), (1.06, False)):
        g = np.array([0.0, slope, -1.0])
        rest = rest_of_point(point_slip(BALL, g, 0.3))
        assert rest.holds == holds
        if not holds:
            assert rest.exit is not None
            np.testing.assert_allclose(rest.exit.direction @ BALL.tangents, [0, 1, 0], atol=1e-15)
            assert rest.exit.growth == pytest.approx(slope - 1.05)


def test_an_open_set_stops_and_leaves_at_once() -> None:
    m, mu, b = RESTARTING, 0.7, np.array([-1.0, -4.0, -10.0])
    slip = point_slip(m, b, mu)
    rest = rest_of_point(slip)
    assert not rest.holds
    assert rest.unique
    assert rest.exit is not None
    entry = next(d for d in limit_directions(slip) if d.growth < 0 and d.attracts)
    angle = np.arctan2(*entry.direction[::-1])
    for turn in (-1.0, -0.3, 0.1, 0.2):
        start = np.array([np.cos(angle + turn), np.sin(angle + turn)])
        stop = finish_stop(slip, start, 1.0)
        # Whatever the start in this range, the slip nears the entry (slowly, like s^0.1) and
        # ends in a finite time ...
        assert np.abs(stop.direction - entry.direction).max() < 0.1 * abs(turn)

        def size(_: float, x: FloatArray) -> float:
            return float(np.hypot(*x)) - 1e-6

        size.terminal = True  # type: ignore[attr-defined]
        # ... also if followed in time.
        found = solve_ivp(
            lambda _, x: slip.rate(x / np.hypot(*x)),
            (0, 9),
            start,
            events=size,
            rtol=1e-9,
            atol=1e-12,
        )
        assert found.t[-1] == pytest.approx(stop.duration, abs=1e-5)
    # It leaves another way.
    assert rest.exit.direction @ entry.direction < 0.5
    assert rest.exit.growth > 1


def test_a_body_that_can_be_held_and_slide() -> None:
    """Near Painlevé's limit (B > 0 in every direction) both answers satisfy every condition."""
    m = mobility(1.0, [0.26, 0.15, 0.21], [1.5, -1.2, -0.7], [0, 0, 1])
    b, mu = np.array([12.68, 12.88, -2.35]), 2.51
    assert mu < least_painleve_friction(m)
    rest = rest_of_point(point_slip(m, b, mu))
    assert rest.holds
    assert not rest.unique
    assert rest.exit is None
    held = b + m.A @ (rest.normal_force * m.gamma + rest.sticking_force @ m.tangents)
    assert np.abs(held).max() < 1e-13
    assert 0 < np.hypot(*rest.sticking_force) < mu * rest.normal_force
    for exit in rest.exits:
        e = exit.direction @ m.tangents
        slides = b + m.A @ (exit.normal_force * (m.gamma - mu * e))
        assert exit.growth > 0
        assert exit.normal_force > 0
        np.testing.assert_allclose(slides, exit.growth * e, atol=1e-12)
    assert [exit.attracts for exit in rest.exits] == [True, False]


def test_the_size_of_a_law_of_friction_is_seen() -> None:
    """One hundredth more friction moves every direction that is not on an axis of symmetry."""
    m, b, mu, slip = point_slips(5, 1)[0]
    wrong = point_slip(m, b, 1.01 * mu)
    for right, other in zip(limit_directions(slip), limit_directions(wrong), strict=True):
        assert np.abs(right.direction - other.direction).max() > 1e-6


# --- coupled sliding and spinning -------------------------------------------------------------


def coupled_slips(seed: int, count: int) -> list[CoupledSlip]:
    rng, slips = np.random.default_rng(seed), []
    for m, b, mu, _ in point_slips(seed, count):
        patch, spin = rng.uniform(0.1, 0.8), 2 * rng.normal()
        slips.append(CoupledSlip(m, 0.6 * mu, patch, ring_force, ring_couple, b, spin))
    return slips


def test_coupled_rates_are_those_of_the_contact() -> None:
    for slip in coupled_slips(6, 5):
        m, n = slip.mobility, np.array([0.48, -0.6, 0.64])
        N, f, couple = slip.force(n)
        force = N * m.gamma + f @ m.tangents
        acceleration = slip.acceleration + m.A @ force + couple * m.spin_force
        spin = slip.spin_acceleration + m.spin_force @ force + m.spin * couple
        scale = N * np.abs(m.A).max()
        assert abs(m.gamma @ acceleration) < 1e-14 * scale
        expected = np.append(m.tangents @ acceleration, slip.patch * spin)
        np.testing.assert_allclose(slip.rate(n), expected, atol=1e-13 * scale)
        # For this law friction is −μN n.
        np.testing.assert_allclose(f, -slip.mu * N * n[:2], rtol=1e-13)
        assert couple == pytest.approx(-slip.mu * N * slip.patch * n[2])


def test_coupled_directions_of_a_linear_law() -> None:
    """With friction −μN n and constant N the directions are those of (B − H)n = X₀: a sextic."""
    m = mobility(1.0, [0.2, 0.5, 0.9], [0, 0, -1], [0, 0, 1])
    b, spin, mu, a = np.array([0.9, -0.4, -10.0]), 0.3, 0.3, 0.5
    slip = CoupledSlip(m, mu, a, ring_force, ring_couple, b, spin)
    t = m.tangents
    rates = -mu * 10 * np.diag([*np.diag(t @ m.A @ t.T), a * a * m.spin])
    free = np.append(t @ b, a * spin)
    found = limit_directions_of_coupled_slip(slip)
    # |(H − D)⁻¹ x₀| = 1 for D = rates, cleared of denominators.
    d = np.diag(rates)
    total = np.polynomial.Polynomial([1.0])
    for one in d:
        total *= np.polynomial.Polynomial([-one, 1]) ** 2
    for i in range(3):
        part = np.polynomial.Polynomial([free[i] ** 2])
        for j in range(3):
            if j != i:
                part *= np.polynomial.Polynomial([-d[j], 1]) ** 2
        total -= part
    roots = total.roots()
    real = np.sort(roots[np.abs(roots.imag) < 1e-9].real)
    np.testing.assert_allclose(np.sort([one.growth for one in found]), real, rtol=1e-9)
    for one in found:
        np.testing.assert_allclose(one.direction, free / (one.growth - d), rtol=1e-7, atol=1e-9)


def test_coupled_rest() -> None:
    held = 0
    for slip in coupled_slips(7, 6):
        rest = rest_of_patch(slip, inside_ring)
        assert rest.unique
        held += rest.holds
        if rest.exit is not None:
            assert rest.exit.attracts
            assert rest.exit.growth > 0
    assert 0 < held < 6


def test_a_ball_with_a_patch_is_held_without_forces() -> None:
    slip = CoupledSlip(BALL, 0.3, 0.1, ring_force, ring_couple, np.array([0, 0, -9.81]))
    rest = rest_of_patch(slip, inside_ring)
    assert rest.holds
    assert rest.unique
    with pytest.raises(InputError, match="not isolated"):
        limit_directions_of_coupled_slip(slip)


# --- the last moment --------------------------------------------------------------------------


def test_the_last_moment_without_coupling_of_the_normal() -> None:
    m = mobility(1.0, [0.2, 0.5, 0.9], [0, 0, -1], [0, 0, 1])
    mu, N = 0.3, 10.0
    slip = point_slip(m, np.array([0, 0, -N]), mu)
    t = m.tangents
    a = np.diag(t @ m.A @ t.T)
    with mpmath.workdps(25):
        time = (
            mpmath.quad(
                lambda s: mpmath.sqrt(
                    sum(
                        (v * mpmath.exp(-mu * c * s)) ** 2
                        for v, c in zip((0.6, 0.8), a.tolist(), strict=True)
                    )
                ),
                [0, 1, 3, 10, 30, 100],
            )
            / N
        )
    stop = finish_stop(slip, np.array([0.6, 0.8]), 1e-8)
    assert stop.duration == pytest.approx(1e-8 * float(time), rel=1e-12)
    # The impulse is what stops the slip; the normal force is constant.
    np.testing.assert_allclose(stop.friction_impulse, -1e-8 * np.array([0.6, 0.8]) / a, rtol=1e-11)
    assert stop.normal_impulse == pytest.approx(N * stop.duration, rel=1e-13)


def test_the_last_moment_brings_the_slip_to_zero() -> None:
    tested = 0
    for m, b, _, slip in point_slips(8, 12):
        entries = [d for d in limit_directions(slip) if d.growth < 0 and d.attracts]
        if not entries:
            continue
        n = entries[0].direction + 0.05 * np.array(
            [-entries[0].direction[1], entries[0].direction[0]]
        )
        n /= np.hypot(*n)
        stop = finish_stop(slip, n, 1e-6)
        force = stop.normal_impulse * m.gamma + stop.friction_impulse @ m.tangents
        change = b * stop.duration + m.A @ force
        np.testing.assert_allclose(m.tangents @ change, -1e-6 * n, atol=1e-16)
        assert abs(m.gamma @ change) < 1e-16
        tested += 1
    assert tested > 3


def test_the_last_moment_of_a_ball_on_a_patch() -> None:
    """Isotropic: s falls at H, and k obeys one equation; here both factors have one rate."""
    a = np.sqrt(3.5 / 2.5)
    slip = CoupledSlip(BALL, 0.3, a, ring_force, ring_couple, np.array([0, 0, -9.81]))
    stop = finish_stop(slip, np.array([0.36, 0.48, 0.8]), 1e-8)
    np.testing.assert_allclose(stop.direction, [0.36, 0.48, 0.8], atol=1e-12)
    assert stop.duration == pytest.approx(1e-8 / (3.5 * 0.3 * 9.81), rel=1e-13)


def test_a_stiff_last_moment() -> None:
    """A small patch: the spin outlives the sliding by far, and the direction turns at once."""
    a, n = 0.02, np.array([0.6, 0.0, 0.8])
    slip = CoupledSlip(BALL, 0.3, a, ring_force, ring_couple, np.array([0, 0, -9.81]))
    stop = finish_stop(slip, n, 1e-8)
    np.testing.assert_allclose(np.abs(stop.direction), [0, 0, 1], atol=1e-9)
    # aΩ falls at the rate 2.5 μ a² N n₃, between none and that with n₃ = 1.
    assert stop.duration > 0.8e-8 / (2.5 * 0.3 * 9.81 * a * a)
    assert stop.duration == pytest.approx(0.8e-8 / (2.5 * 0.3 * 9.81 * a * a), rel=1e-3)


def test_a_slip_that_grows_does_not_stop() -> None:
    slip = point_slip(BALL, np.array([0.0, 9.0, -1.0]), 0.3)
    exit = rest_of_point(slip).exit
    assert exit is not None
    with pytest.raises(RunError, match="shrink"):
        finish_stop(slip, exit.direction, 1e-8)
    with pytest.raises(RunError, match="shrink"):
        finish_stop(slip, -exit.direction + [1e-3, 2e-3], 1e-2)
    with pytest.raises(InputError, match="size"):
        finish_stop(slip, exit.direction, 0.0)


def test_least_motion_is_least() -> None:
    """Both zero in an impact: no other force and couple within the limits moves less."""
    rng = np.random.default_rng(12)
    kinds = set()
    for _ in range(60):
        m = collision(rng).mobility
        mu, arm = rng.uniform(0.05, 1), rng.uniform(0.01, 0.3)
        force, couple = least_motion(m, mu, arm)
        assert np.hypot(*force) <= mu * (1 + 1e-12)
        assert abs(couple) <= arm
        kinds.add((bool(np.hypot(*force) < 0.999 * mu), bool(abs(couple) < 0.999 * arm)))

        axes = np.vstack([m.tangents, m.gamma])
        c = axes @ m.spin_force
        G = np.block([[axes @ m.A @ axes.T, c[:, None]], [c, np.array([m.spin])]])
        moving = [0, 1, 3]
        motion = G[moving] @ np.array([*force, 1.0, couple])
        # The condition of a minimum over the convex set, in random points of it.
        for _ in range(50):
            other = rng.normal(size=2)
            other *= mu * np.sqrt(rng.uniform()) / np.hypot(*other)
            change = np.append(other - force, rng.uniform(-arm, arm) - couple)
            assert motion @ change > -1e-12 * np.abs(G).max()
    assert len(kinds) == 4


def test_static_friction_may_hold_more_than_sliding_friction() -> None:
    # a block that is pulled along: it needs f = 0.35 N
    block = mobility(1.0, [1e6, 1e6, 1e6], [0, 0, -1], [0, 0, 1])
    slip = point_slip(block, np.array([3.5, 0.0, -10.0]), 0.3)
    assert not rest_of_point(slip).holds
    assert not rest_of_point(slip, 0.34).holds
    assert rest_of_point(slip, 0.36).holds
    assert rest_of_point(slip, 0.34).exits[0].growth == pytest.approx(3.5 - 3.0, abs=1e-5)


def test_the_last_moment_on_a_very_small_patch() -> None:
    """The spin outlives the slip by so much that explicit steps to its end would be millions."""
    a = 0.002
    slip = CoupledSlip(BALL, 0.3, a, ring_force, ring_couple, np.array([0, 0, -9.81]))
    stop = finish_stop(slip, np.array([0.6, 0.0, 0.8]), 1e-8)
    assert stop.duration == pytest.approx(0.8e-8 / (2.5 * 0.3 * 9.81 * a * a), rel=1e-3)
