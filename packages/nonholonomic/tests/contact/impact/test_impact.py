"""Impact: against Newton and Euler step by step, closed forms, and what holds for every body."""

from __future__ import annotations

import dataclasses

import mpmath
import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.linalg import expm

from contact.colliding_bodies import (
    Collision,
    after,
    cartesian_slide,
    collision,
    implicit_steps,
    kinetic_energy,
    rotation,
)
from flowlanes.errors import InputError
from nonholonomic.contact.friction.symbols import slip_speed
from nonholonomic.contact.impact.friction_response import response_with_spin_at_rest
from nonholonomic.contact.impact.impact import impact, normal_response
from nonholonomic.contact.impact.impact_slide import (
    Ends,
    Linear,
    SlidingFriction,
    slide,
    slide_integrator,
)
from nonholonomic.contact.impact.mobility import Mobility, mobility

BALL = mobility(1.0, [0.4, 0.4, 0.4], [0, 0, -1], [0, 0, 1])
LAWS = ("stronge", "poisson", "newton")


def random_friction(rng: np.random.Generator) -> dict[str, float]:
    return {
        "mu": float(rng.choice([0.0, 0.2, 0.6, 1.5])),
        "spin_arm": float(rng.choice([0.0, 0.05, 0.3])),
        "restitution": float(rng.choice([0.0, 0.5, 0.9, 1.0])),
    }


def velocity_error(c: Collision, m: Mobility, friction: dict[str, float]) -> float:
    """How far an impact is from the slide integrated with Newton's and Euler's equations."""
    result = impact(m, c.contact_velocity, c.spin, **friction)
    v, omega = cartesian_slide(c, friction["mu"], friction["spin_arm"], result.normal_impulse)
    found = np.append(*after(c, result))
    return float(np.abs(found - np.append(v, omega)).max() / np.abs(found).max())


# --- against other integrations ---------------------------------------------------------------


def sliding_collisions(count: int) -> list[tuple[Collision, dict[str, float]]]:
    rng, cases = np.random.default_rng(5), []
    while len(cases) < count:
        c = collision(rng)
        friction = {"mu": rng.uniform(0.05, 0.8), "spin_arm": rng.choice([0.0, 0.1])}
        friction |= {"restitution": rng.uniform(0, 1)}
        result = impact(c.mobility, c.contact_velocity, c.spin, **friction)
        if [phase.mode for phase in result.phases] == ["sliding"] and result.spin * c.spin > 0:
            cases.append((c, friction))
    return cases


def test_sliding_that_turns_is_newtons_and_eulers() -> None:
    for c, friction in sliding_collisions(12):
        assert velocity_error(c, c.mobility, friction) < 5e-13


@pytest.mark.parametrize("name", ["A", "spin_force", "spin"])
def test_a_mistake_in_the_mobility_is_seen(name: str) -> None:
    c, friction = next(case for case in sliding_collisions(12) if case[1]["spin_arm"] > 0)
    wrong = dataclasses.replace(c.mobility, **{name: 1.01 * getattr(c.mobility, name)})
    assert velocity_error(c, c.mobility, friction) < 1e-12
    result = impact(wrong, c.contact_velocity, c.spin, **friction)
    right = impact(c.mobility, c.contact_velocity, c.spin, **friction)
    wrong_by = np.append(result.impulse - right.impulse, result.spin - right.spin)
    assert np.abs(wrong_by).max() > 1e-6


@pytest.mark.parametrize("seed", range(14))
def test_every_change_of_phase_is_that_of_implicit_steps(seed: int) -> None:
    rng = np.random.default_rng(seed)
    c = collision(rng)
    mu, arm = float(rng.choice([0.4, 0.9, 2.0])), float(rng.choice([0.0, 0.1, 0.4]))
    result = impact(c.mobility, c.contact_velocity, c.spin, mu=mu, spin_arm=arm, restitution=0.8)
    args = (c.mobility, c.contact_velocity, c.spin, mu, arm, result.normal_impulse)
    errors = []
    for steps in (40, 160):
        u, spin = implicit_steps(*args, steps)
        errors.append(max(np.abs(u - result.contact_velocity).max(), abs(spin - result.spin)))
    scale = np.abs(c.contact_velocity).max()
    assert errors[1] < 0.01 * scale
    assert errors[1] < 0.5 * errors[0] + 1e-9


def test_a_stop_that_turns_without_coupling_of_the_normal() -> None:
    """A_tn = 0: in logarithmic time both components decay exponentially; P by quadrature."""
    m = mobility(1.0, [0.2, 0.5, 0.9], [0, 0, -1], [0, 0, 1])
    a1, a2, u1, u2, mu = 1 + 1 / 0.5, 1 + 1 / 0.2, 0.7, 1.1, 0.3
    with mpmath.workdps(30):
        stop = mpmath.quad(
            lambda t: mpmath.sqrt(
                (u1 * mpmath.exp(-2 * t * a1 * mu / 2)) ** 2 + (u2 * mpmath.exp(-t * a2 * mu)) ** 2
            ),
            [0, 1, 3, 10, 30, 100],
        )
    result = impact(m, [u1, u2, -5.0], mu=mu, restitution=1.0)
    assert [phase.mode for phase in result.phases] == ["sliding", "sticking"]
    assert result.phases[0].end == pytest.approx(float(stop), rel=1e-14)
    np.testing.assert_allclose(result.impulse, [-u1 / a1, -u2 / a2, 10], rtol=2e-15)
    assert result.contact_velocity.tolist()[:2] == [0, 0]


def test_a_stop_that_turns_with_coupling_of_the_normal() -> None:
    """The linear equation u′ = β|u| − μ A u in logarithmic time, with many digits."""
    m = mobility(1.0, [0.3, 0.5, 0.7], [0.3, -0.2, -1], [0, 0, 1])
    t, mu = m.tangents, 1.4
    beta, A = t @ m.A @ m.gamma, t @ m.A @ t.T
    u0 = np.array([0.3, 0.2])
    with mpmath.workdps(20):
        solution = mpmath.odefun(
            lambda _, y: [
                *(
                    beta[i] * mpmath.hypot(y[0], y[1]) - mu * (A[i, 0] * y[0] + A[i, 1] * y[1])
                    for i in (0, 1)
                ),
                mpmath.hypot(y[0], y[1]),
            ],
            0,
            [*u0.tolist(), 0],
            tol=1e-17,
        )
        y = solution(9)
        size = mpmath.hypot(y[0], y[1])
        assert size < 1e-9
        n = np.array([float(y[0] / size), float(y[1] / size)])
        stop = y[2] + size / -float(n @ (beta - mu * A @ n))
    result = impact(m, u0 @ t - 3 * m.gamma, mu=mu)
    assert result.phases[0].end == pytest.approx(float(stop), rel=3e-15)


def test_a_body_that_is_compressed_twice() -> None:
    """The sliding turns to where it presses: part e² of both compressions' work is given back."""
    c = collision(np.random.default_rng(1213))
    approach = c.gamma @ c.contact_velocity
    c = dataclasses.replace(c, velocity=c.velocity - 0.8 * approach * c.gamma)
    m, mu, e = c.mobility, 4.0, 0.9
    result = impact(m, c.contact_velocity, c.spin, mu=mu, restitution=e)
    assert [phase.mode for phase in result.phases] == ["sliding", "sticking"]

    stop = result.phases[0].end
    t, gamma = m.tangents, m.gamma

    def rates(_: float, u: np.ndarray) -> np.ndarray:
        slip = u - (u @ gamma) * gamma
        return m.A @ (gamma - mu * slip / np.linalg.norm(slip))

    impulses = np.linspace(0, 0.9999 * stop, 4001)
    u = solve_ivp(
        rates,
        (0, impulses[-1]),
        c.contact_velocity,
        t_eval=impulses,
        rtol=1e-11,
        atol=1e-13,
        method="DOP853",
    ).y
    assert np.linalg.norm(t @ u[:, -1]) < 1e-3 * np.linalg.norm(t @ u[:, 0])
    normal = gamma @ u
    signs = np.sign(normal)
    assert signs[np.append(0, np.flatnonzero(np.diff(signs)) + 1)].tolist() == [-1, 1, -1]

    def work(sign: int) -> float:
        return float(np.trapezoid(sign * np.maximum(sign * normal, 0), impulses))

    rate = 1 / (gamma @ np.linalg.solve(m.A, gamma))
    compression = work(-1) - normal[-1] ** 2 / (2 * rate)
    after = gamma @ result.contact_velocity
    assert work(1) + after**2 / (2 * rate) == pytest.approx(-(e**2) * compression, rel=1e-3)
    assert result.energy_lost > 0


# --- closed forms -----------------------------------------------------------------------------


def test_the_ball_that_grips() -> None:
    """Garwin's superball: the friction impulse −(2/7) m u wherever the grip suffices."""
    for e, law in zip((0.0, 0.6, 1.0), LAWS, strict=True):
        result = impact(BALL, [0.5, -0.2, -2.0], 1.0, mu=0.4, restitution=e, law=law)
        np.testing.assert_allclose(
            result.impulse, [-1 / 7, 0.4 / 7, 2 * (1 + e)], rtol=2e-15, atol=1e-16
        )
        assert result.phases[0].end == pytest.approx(np.hypot(0.5, 0.2) / (3.5 * 0.4), rel=1e-15)
        assert result.spin == 1.0


def test_the_ball_that_slides_all_the_time() -> None:
    result = impact(BALL, [3.0, 4.0, -1.0], mu=0.1, restitution=0.5)
    np.testing.assert_allclose(result.impulse, [-0.09, -0.12, 1.5], rtol=2e-15)
    np.testing.assert_allclose(result.angular_velocity_jump, [-0.3, 0.225, 0], rtol=4e-15)
    slip, friction = 5 - 3.5 * 0.15 / 2, 0.15
    assert result.energy_lost == pytest.approx(friction * slip + 0.5 * (1 - 0.25), rel=1e-14)


def test_a_ball_whose_spin_stops() -> None:
    """Couple μ_s P against the spin, moment 2/5: held from P = 2 Ω/(5 μ_s) on."""
    result = impact(BALL, [1e-3, 0.0, -1.0], 0.3, mu=0.5, spin_arm=0.2, restitution=0.5)
    assert [phase.mode for phase in result.phases][-1] == "sticking, spin held"
    assert result.phases[-2].end == pytest.approx(0.4 * 0.3 / 0.2, rel=1e-14)
    assert result.spin == 0.0
    assert result.couple_impulse == pytest.approx(-0.12, rel=1e-14)


def test_without_friction() -> None:
    rng = np.random.default_rng(2)
    for _ in range(20):
        c, e = collision(rng), rng.uniform(0, 1)
        for law in LAWS:
            result = impact(c.mobility, c.contact_velocity, c.spin, mu=0, restitution=e, law=law)
            pressure = -(1 + e) * (c.gamma @ c.contact_velocity)
            pressure /= c.gamma @ c.mobility.A @ c.gamma
            np.testing.assert_allclose(result.impulse, pressure * c.gamma, atol=3e-15 * pressure)


def test_infinite_friction_sticks_or_lifts() -> None:
    rng, stuck = np.random.default_rng(3), 0
    for _ in range(40):
        c = collision(rng)
        m, u = c.mobility, c.contact_velocity
        result = impact(m, u, c.spin, mu=np.inf)
        whole = -np.linalg.solve(m.A, u)
        t = m.tangents
        stopping = -np.linalg.solve(t @ m.A @ t.T, t @ u)
        approach = m.gamma @ u + (m.gamma @ m.A @ t.T) @ stopping
        if result.phases[-1].mode == "sticking":
            stuck += 1
            assert approach < 0
            np.testing.assert_allclose(result.impulse, whole, rtol=1e-11, atol=1e-13)
        else:
            assert result.normal_impulse == 0
            assert approach > 0
            assert abs(m.gamma @ result.contact_velocity) < 1e-14
    assert 20 < stuck < 40


def test_infinite_friction_is_the_limit_of_a_large_one() -> None:
    rng = np.random.default_rng(4)
    for number in range(12):
        c, law = collision(rng), LAWS[number % 3]
        limit, *large = (
            impact(c.mobility, c.contact_velocity, c.spin, mu=mu, restitution=0.5, law=law).impulse
            for mu in (np.inf, 1e6, 1e8)
        )
        errors = [np.abs(one - limit).max() for one in large]
        assert errors[1] < 1e-6
        assert errors[1] < 0.05 * errors[0] + 1e-14


# --- what holds for every body ----------------------------------------------------------------


@pytest.mark.parametrize("law", LAWS)
def test_balances(law: str) -> None:
    rng = np.random.default_rng(LAWS.index(law))
    for _ in range(40):
        c, friction = collision(rng), random_friction(rng)
        m = c.mobility
        result = impact(m, c.contact_velocity, c.spin, law=law, **friction)
        v, omega = after(c, result)
        scale = np.abs(result.impulse).max() * (1 + np.abs(c.r).max())
        # Momentum about the contact: changed by the couple alone.
        jump = c.inertia @ result.angular_velocity_jump
        jump = jump - c.mass * np.cross(c.r, result.velocity_jump)
        assert np.abs(jump - result.couple_impulse * c.gamma).max() < 1e-14 * scale
        u = v + np.cross(omega, c.r)
        speed = np.abs(c.contact_velocity).max() + scale * np.abs(m.A).max()
        assert np.abs(u - result.contact_velocity).max() < 4e-15 * speed
        assert abs(omega @ c.gamma - result.spin) < 4e-15 * speed
        before, later = kinetic_energy(c, c.velocity, c.omega), kinetic_energy(c, v, omega)
        assert result.energy_lost == pytest.approx(before - later, abs=1e-13 * (before + later))
        friction_impulse = result.impulse - result.normal_impulse * c.gamma
        limit = friction["mu"] * result.normal_impulse
        assert np.linalg.norm(friction_impulse) <= limit + 1e-14 * scale
        assert abs(result.couple_impulse) <= friction["spin_arm"] * result.normal_impulse + 1e-15
        e = friction["restitution"]
        if law == "newton":
            normal = -e * (c.gamma @ c.contact_velocity)
            assert c.gamma @ u == pytest.approx(normal, abs=1e-13)
        elif law == "poisson":
            assert result.normal_impulse == pytest.approx(
                (1 + e) * result.compression_impulse, rel=1e-13
            )
        else:
            assert not result.energy_grew
            assert result.energy_lost >= -1e-13 * before


def test_newtons_law_may_gain_energy_and_says_so() -> None:
    rng, grew = np.random.default_rng(0), 0
    for _ in range(30):
        c = collision(rng)
        result = impact(
            c.mobility, c.contact_velocity, c.spin, mu=1.0, restitution=1.0, law="newton"
        )
        v, omega = after(c, result)
        gain = kinetic_energy(c, v, omega) - kinetic_energy(c, c.velocity, c.omega)
        assert result.energy_grew == (gain > 1e-12)
        grew += result.energy_grew
    assert grew > 0


def test_mirror_and_turned_bodies() -> None:
    rng = np.random.default_rng(7)
    for _ in range(10):
        c, friction = collision(rng), random_friction(rng)
        one = impact(c.mobility, c.contact_velocity, c.spin, **friction)
        q = rotation(rng)
        for Q, sign in ((q, 1), (-q, -1)):
            # A mirror image: an axial number, the spin, changes its sign.
            m = mobility(c.mass, Q @ c.inertia @ Q.T, Q @ c.r, Q @ c.gamma)
            two = impact(m, Q @ c.contact_velocity, sign * c.spin, **friction)
            scale = np.abs(one.impulse).max()
            np.testing.assert_allclose(two.impulse, Q @ one.impulse, atol=1e-12 * scale)
            assert two.couple_impulse == pytest.approx(sign * one.couple_impulse, abs=1e-12 * scale)
            assert [p.mode for p in two.phases] == [p.mode for p in one.phases]


def test_sliding_in_a_plane_of_symmetry_reverses() -> None:
    """A leaning rod with little friction: it stops and slides back, each phase straight."""
    lean = np.arctan(2)
    gamma = np.array([np.cos(lean), 0, np.sin(lean)])
    rod = mobility(1.0, [1 / 3, 1 / 3, 1e-3], [0, 0, -1], gamma)
    t = np.array([np.sin(lean), 0, -np.cos(lean)])
    mu, e, s, w = 0.3, 0.5, 0.2, 1.0
    Att, Atn, Ann = t @ rod.A @ t, t @ rod.A @ gamma, gamma @ rod.A @ gamma
    sign = 1.0 if Atn < 0 else -1.0
    result = impact(rod, sign * s * t - w * gamma, mu=mu, restitution=e)
    assert [p.mode for p in result.phases] == ["sliding", "sliding"]
    stop = s / (abs(Atn) + mu * Att)
    assert result.phases[0].end == pytest.approx(stop, rel=3e-15)
    before, back = Ann + mu * abs(Atn), Ann - mu * abs(Atn)
    rest = w - before * stop
    work = -(w + rest) / 2 * stop - rest**2 / (2 * back)
    total = stop + rest / back + e * np.sqrt(-2 * work / back)
    assert result.normal_impulse == pytest.approx(total, rel=1e-14)
    assert result.impulse @ t == pytest.approx(sign * mu * (total - 2 * stop), rel=1e-14)


def test_a_normal_velocity_of_rounding() -> None:
    """What touches without approaching gets an impulse of that order, whatever the friction."""
    rng = np.random.default_rng(13)
    for number in range(60):
        c = collision(rng)
        m, mu = c.mobility, (1e-9, 0.2, 0.6)[number % 3]
        slip = c.contact_velocity - (c.gamma @ c.contact_velocity) * c.gamma
        if normal_response(m, slip, mu) < 0.1 * (c.gamma @ m.A @ c.gamma):
            continue
        result = impact(m, slip - 1e-17 * c.gamma, c.spin, mu=mu, restitution=0.9)
        assert result.normal_impulse < 1e-14


def test_continuity_at_small_slips() -> None:
    """A slip that is only rounding does what no slip does."""
    rng = np.random.default_rng(8)
    for _ in range(10):
        c = collision(rng)
        u = (c.gamma @ c.contact_velocity) * c.gamma
        noise = 1e-17 * rng.normal(size=3)
        noise -= (noise @ c.gamma) * c.gamma
        one, two = (
            impact(c.mobility, start, 0.0, mu=0.1, spin_arm=0.01, restitution=0.5)
            for start in (u, u + noise)
        )
        np.testing.assert_allclose(one.impulse, two.impulse, atol=1e-13)


# --- the end of bouncing ----------------------------------------------------------------------


def test_the_spin_at_rest_stays() -> None:
    c = collision(np.random.default_rng(11))
    m, response = c.mobility, response_with_spin_at_rest(c.mobility)
    f = np.array([0.3, -0.7])
    force, couple = m.gamma + f @ m.tangents, response.couple[0] + response.couple[1] @ f
    assert abs(m.spin_force @ force + m.spin * couple) < 1e-14
    change = m.A @ force + couple * m.spin_force
    beta, A = response.tangential
    np.testing.assert_allclose(m.tangents @ change, beta + A @ f, rtol=1e-12)
    assert m.gamma @ change == pytest.approx(response.normal[0] + response.normal[1] @ f)


# --- refusals ---------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "word"),
    [
        ({"mu": -0.1}, "mu"),
        ({"mu": np.nan}, "mu"),
        ({"spin_arm": -1.0}, "spin_arm"),
        ({"restitution": 1.1}, "restitution"),
        ({"law": "hooke"}, "stronge, poisson, newton"),
        ({"velocity": [0.0, 0.0, 1.0]}, "recedes"),
        ({"velocity": [0.0, 1.0]}, "three finite numbers"),
    ],
)
def test_mistaken_impacts(change: dict[str, object], word: str) -> None:
    arguments = {"velocity": [1.0, 0.0, -1.0], "mu": 0.3} | change
    with pytest.raises(InputError, match=word):
        impact(BALL, **arguments)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    "arguments",
    [
        (0.0, [1, 1, 1], [0, 0, -1], [0, 0, 1]),
        (1.0, [1, -1, 1], [0, 0, -1], [0, 0, 1]),
        (1.0, [1, 1], [0, 0, -1], [0, 0, 1]),
        (1.0, [1, 1, 1], [0, 0, -1], [0, 0, 2]),
        (1.0, [1, 1, 1], [0, 0, np.inf], [0, 0, 1]),
    ],
)
def test_mistaken_bodies(arguments: tuple[object, ...]) -> None:
    with pytest.raises(InputError):
        mobility(*arguments)  # type: ignore[arg-type]


def test_normal_response_of_a_ball_is_its_mass() -> None:
    assert normal_response(BALL, [1, 0, 0], 0.7) == pytest.approx(1)
    assert normal_response(BALL, None, 0.7) == pytest.approx(1)


def test_a_restitution_below_rounding_ends_the_impact() -> None:
    """Found among 6,000 bouncing balls: e = 0.0006 on the last of many bounces."""
    beta, A = np.array([0.34753579, 1.39846356]), np.array([[4.26178, -0.0547], [-0.0547, 5.46108]])
    normal = Linear(0.0, 1.47917328, beta)
    ends = Ends(False, 1.0, 0.0, 0.0, -6.955714613867327e-19, None, None)
    slip = np.array([-0.91422412, 8.71702432])
    law = SlidingFriction(0.08582)
    result = slide(slide_integrator(law), beta, A, law, slip, normal, ends)
    assert result.event == "returned"
    assert abs(result.clock) < 1e-8


def test_viscous_friction_in_proportion_to_the_normal_force() -> None:
    """A ball without dry friction: u′ = −(7/2m)ν u over the impulse of the normal force."""
    ball = mobility(1.0, [0.4, 0.4, 0.4], [0, 0, -1], [0, 0, 1])
    result = impact(ball, [0.6, 0.8, -2.0], mu=0.0, viscous=0.3, restitution=0.5)
    left = np.exp(-3.5 * 0.3 * 3.0) * np.array([0.6, 0.8])
    np.testing.assert_allclose(result.contact_velocity, [*left, 1.0], atol=1e-14)
    assert result.normal_impulse == pytest.approx(3.0, abs=1e-14)


@pytest.mark.parametrize(
    "formula", [None, 0.1 + 0.2 * sp.exp(-slip_speed / sp.Float(0.5)), 0.1 / (1 + slip_speed)]
)
@pytest.mark.parametrize("order", [0.5, 1.0, 2.0])
def test_dry_and_viscous_friction_in_an_impact(order: float, formula: sp.Expr | None) -> None:
    """Against steps of Runge and Kutta in the normal impulse."""
    body = mobility(1.3, [0.3, 0.5, 0.4], [0.3, -0.4, -0.8], [0, 0, 1])
    nu, slip = 0.4, np.array([1.5, -0.4])
    dry = sp.lambdify(slip_speed, sp.Float(0.1) if formula is None else formula)
    mu = float(dry(0.0))
    result = impact(body, [*slip, -1.0], mu=mu, viscous=nu, order=order, force=formula)

    def rate(P: float, u: np.ndarray) -> np.ndarray:
        s = np.hypot(u[0], u[1])
        force = -(dry(s) + nu * s**order) * u[:2] / s
        return body.A @ np.array([*force, 1.0])

    def compressed(P: float, u: np.ndarray) -> float:
        return float(u[2])

    compressed.terminal = True  # type: ignore[attr-defined]
    solved = solve_ivp(
        rate, (0, 10), [*slip, -1.0], events=compressed, rtol=1e-12, atol=1e-14, method="DOP853"
    )
    np.testing.assert_allclose(result.contact_velocity, solved.y[:, -1], atol=1e-11)
    assert result.normal_impulse == pytest.approx(solved.t[-1], rel=1e-11)


def test_sliding_that_begins_in_an_impact_against_viscous_friction() -> None:
    """From rest the slip of a body that is not symmetric tends to what the friction balances."""
    body = mobility(1.3, [0.3, 0.5, 0.4], [0.3, -0.4, -0.8], [0, 0, 1])
    result = impact(body, [0.0, 0.0, -1.0], mu=0.0, viscous=0.4)
    A, beta = body.A[:2, :2], body.A[:2, 2]
    P = result.normal_impulse
    slip = np.linalg.solve(0.4 * A, (np.eye(2) - expm(-0.4 * P * A)) @ beta)
    np.testing.assert_allclose(result.contact_velocity[:2], slip, atol=1e-13)


def test_a_slide_whose_speed_hardly_changes_goes_on() -> None:
    """Near a direction in which it neither grows nor shrinks it takes many steps, and does end."""
    A = np.array(
        [[4.734948084124503, 0.01829115035798747], [0.01829115035798747, 5.120561271834452]]
    )
    beta = np.array([0.1757963393107045, -1.2892459696679441])
    slip = np.array([-3.9712469941030858e-06, 1.6988250202034527e-05])
    normal = Linear(-0.022202056757275407, 1.412202837306653, beta)
    ends = Ends(True, 0.0, 0.0, 0.0, -1.0, None, None)
    friction = SlidingFriction(0.25473419904639666)
    clock, events = 0.0, []
    while "compressed" not in events and len(events) < 20:
        part = slide(slide_integrator(friction), beta, A, friction, slip, normal, ends)
        slip = part.speed * part.direction
        normal = Linear(normal.at(part.clock, part.friction), normal.normal, normal.friction)
        clock += part.clock
        events.append(part.event)
    assert len(events) > 1 and events[-1] == "compressed"
    assert normal.constant == pytest.approx(0, abs=1e-15)
