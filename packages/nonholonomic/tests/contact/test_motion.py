"""Motions with friction: against independent computations, closed forms and balances."""

from __future__ import annotations

import math
import re
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import flowlanes
import nonholonomic
from contact.reference import placed, simulate
from contact.situations import CASES, rules, situation, start
from nonholonomic.contact import (
    MODE_NAMES,
    CompiledContact,
    ContensouErismann,
    ContourResistance,
    Coulomb,
    EventRules,
    FrictionalContact,
    RollingResistance,
    UserFriction,
    contact_motion,
)
from nonholonomic.contact.starts import state_in_contact, state_in_space

G = 9.81
GRAVITY = nonholonomic.Forces(gravity=G)

#: Names of events that the reference calls otherwise.
OUR_NAMES = {"turn stop": "rolling stop", "turn start": "rolling start"}

#: Motions that are prepared and followed in about a second; the others run among the slow tests.
QUICK = ("loaded ball, viscous", "loaded ball, viscous in N", "billiard ball")


def motion_of(case: dict[str, Any], samples: int = 2) -> Any:
    contact = situation(case)
    times = np.linspace(0, case["until"], samples)
    return contact_motion(contact, start(case, contact), times, rules(case))


def assert_agrees(case: dict[str, Any]) -> None:
    motion = motion_of(case)
    assert motion.reason == ""
    expected = case["events"]
    # a spin that passes through zero is no event of the reference
    events = [e for e in motion.events if e.kind != "spin reversal"]
    kinds = [e["kind"] for e in expected]
    assert [e.kind for e in events] == [OUR_NAMES.get(kind, kind) for kind in kinds]
    for event, reference in zip(events, expected, strict=True):
        assert event.time == pytest.approx(reference["time"], abs=1e-10)
        assert_same_state(event.after, reference)
    assert_same_state(motion.end_state, case["final"])
    assert np.all(np.diff(motion.times) > 0)


def assert_same_state(state: np.ndarray, reference: dict[str, Any]) -> None:
    attitude = state[:4] * np.sign(state[:4] @ reference["attitude"])
    turn = Rotation.from_quat(state[:4], scalar_first=True)
    for ours, name in (
        (attitude, "attitude"),
        (state[4:7], "position"),
        (turn.apply(state[7:10].copy()), "velocity"),
        (state[10:13], "omega"),
    ):
        np.testing.assert_allclose(ours, reference[name], rtol=1e-9, atol=1e-9, err_msg=name)


@pytest.mark.parametrize("name", QUICK)
def test_motion_agrees_with_the_reference(name: str) -> None:
    assert_agrees(CASES[name])


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in CASES if name not in QUICK])
def test_motion_agrees_with_the_reference_slowly(name: str) -> None:
    assert_agrees(CASES[name])


@pytest.fixture(scope="module")
def loaded() -> CompiledContact:
    """An asymmetric ball with its centre of mass off its centre, on ground with μ = 0.3."""
    body = nonholonomic.Body(1.0, (0.2, 0.25, 0.3), nonholonomic.Ball(1.0, centre=(0.1, 0.05, 0.3)))
    return CompiledContact(FrictionalContact(body, laws=(Coulomb(0.3),), field=GRAVITY))


def drop(height: float, velocity: Any, omega: Any, attitude: Any = (1, 0, 0, 0)) -> list[float]:
    turn = Rotation.from_quat(attitude, scalar_first=True)
    quaternion = turn.as_quat(scalar_first=True)
    vertical = turn.inv().apply([0, 0, 1])
    return [*quaternion, 0, 0, height, *turn.inv().apply(velocity), *omega, *vertical]


def test_bounces_end_and_the_energy_balance_holds(loaded: CompiledContact) -> None:
    state = drop(1.5, (1.0, 0.5, 0.0), (3.0, -2.0, 1.0))
    times = np.linspace(0, 3, 61)
    motion = contact_motion(loaded, state, times, EventRules(restitution=0.5))
    kinds = [e.kind for e in motion.events]
    assert kinds == ["landing"] * len(kinds) and len(kinds) > 10
    assert motion.events[-1].mode == "rolling"
    values = motion
    balance = values["energy"] + motion.states[:, 16:].sum(axis=1)
    assert np.ptp(balance) <= 1e-13 * values["energy"][0]
    assert values["gap"].min() >= -1e-13
    flying = motion.modes == MODE_NAMES.index("flight")
    assert values["gap"][flying].min() > 0 and abs(values["gap"][~flying]).max() < 1e-13
    assert np.all(values["normal_force"][~flying] > 0) and not values["normal_force"][flying].any()


@pytest.mark.parametrize("restitution", [0.5, 0.9])
def test_a_ball_bounces_at_the_known_times(restitution: float) -> None:
    """Landings at √(2h/g)(1 + 2e + 2e² + ...), with their end at √(2h/g)(1 + e)/(1 − e)."""
    ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    ground = FrictionalContact(ball, laws=(Coulomb(0.3),), field=GRAVITY)
    height, end = 0.5, math.sqrt(1.0 / G) * (1 + restitution) / (1 - restitution)
    given = EventRules(restitution=restitution)
    motion = contact_motion(ground, drop(1 + height, (0, 0, 0), (0, 0, 1)), [0.0, end + 1], given)
    *landings, rest = motion.events
    powers = restitution ** np.arange(1, len(landings))
    expected = math.sqrt(2 * height / G) * np.cumsum([1.0, *(2 * powers)])
    np.testing.assert_allclose([e.time for e in landings], expected, rtol=0, atol=1e-12)
    assert [e.mode for e in landings] == ["flight"] * len(landings)
    assert rest.mode != "flight"
    assert rest.time == pytest.approx(end, abs=1e-12)


def test_intervals_cover_the_time(loaded: CompiledContact) -> None:
    state = drop(1.5, (1.0, 0.5, 0.0), (3.0, -2.0, 1.0))
    motion = contact_motion(loaded, state, [0.0, 2.0], EventRules(restitution=0.3))
    assert motion.intervals[0].begin == 0 and motion.intervals[-1].end == 2
    for one, other in zip(motion.intervals, motion.intervals[1:], strict=False):
        assert one.end == other.begin and one.mode != other.mode


def test_samples_do_not_change_the_motion(loaded: CompiledContact) -> None:
    state = drop(1.2, (1.0, 0.5, 0.0), (3.0, -2.0, 1.0))
    few = contact_motion(loaded, state, [0.0, 2.0], EventRules(restitution=0.3))
    many = contact_motion(loaded, state, np.linspace(0, 2, 301), EventRules(restitution=0.3))
    np.testing.assert_allclose(few.end_state, many.end_state, rtol=0, atol=1e-12)
    assert [e.kind for e in few.events] == [e.kind for e in many.events]


def test_work_of_friction_is_the_integral_of_its_power(loaded: CompiledContact) -> None:
    state = drop(0.7, (1.0, 0.5, 0.0), (3.0, -2.0, 1.0))
    state[9] = -float(np.cross(state[10:13], [0.1, 0.05, -0.7])[2])
    times = np.linspace(0, 0.3, 2001)
    motion = contact_motion(loaded, state, times)
    power = motion["power_lost"]
    steps = np.diff(times)
    lost = float(((power[1:] + power[:-1]) * steps).sum() / 2)
    assert motion.end_state[17] == pytest.approx(lost, rel=1e-6)


def test_lift_off_can_end_the_motion(loaded: CompiledContact) -> None:
    case = CASES["rising egg"]
    contact = situation(case)
    motion = contact_motion(
        contact, start(case, contact), [0.0, case["until"]], EventRules(on_liftoff="stop")
    )
    assert motion.reason == "the body leaves the support"
    first = next(e for e in case["events"] if e["kind"] == "lift-off")
    assert motion.end_time == pytest.approx(first["time"], abs=1e-10)
    assert motion.times[-1] == motion.end_time


def test_billiard_ball_slides_for_the_known_time() -> None:
    ball = nonholonomic.Body(0.2, (2e-4,) * 3, nonholonomic.Ball(0.05))
    table = FrictionalContact(ball, laws=(Coulomb(0.2),), field=GRAVITY)
    for slip in (1.4, 0.3):
        state = drop(0.05, (slip, 0, 0), (0, 0, 0))
        motion = contact_motion(table, state, [0.0, 1.0])
        assert motion.events[0].time == pytest.approx(2 * slip / (7 * 0.2 * G), rel=1e-13)


def test_sliding_and_spinning_end_at_one_instant() -> None:
    ball = nonholonomic.Body(0.2, (2e-4,) * 3, nonholonomic.Ball(0.05))
    for patch in (0.03, 0.04):
        table = FrictionalContact(ball, laws=(ContensouErismann(0.2, patch),), field=GRAVITY)
        motion = contact_motion(table, drop(0.05, (0.7, 0, 0), (3, 5, 20)), [0.0, 3.0])
        assert [e.kind for e in motion.events] == ["stick"]
        assert motion.events[0].mode == "rolling without spin"
        after = motion
        assert abs(after["spin"][-1]) < 1e-13 and np.abs(after["slip"][-1]).max() < 1e-13


def test_a_ball_that_never_slips_rolls_with_the_law_of_marble(loaded: CompiledContact) -> None:
    body = loaded.situation.body
    ideal = FrictionalContact(
        body, laws=(Coulomb(math.inf),), field=nonholonomic.Forces(gravity=3.0)
    )
    omega = np.array([0.4, -0.3, 0.5])
    r = np.array([0.1, 0.05, -0.7])
    state = drop(0.7, -np.cross(omega, r), omega)
    motion = contact_motion(ideal, state, [0.0, 1.0])
    rolling = nonholonomic.rolling_system(body, field=nonholonomic.Forces(gravity=3.0))
    marble = flowlanes.integrate(
        rolling, nonholonomic.initial_state(rolling, omega, (0.0, 0.0, 1.0)), [0.0, 1.0]
    )
    values = motion
    np.testing.assert_allclose(motion.end_state[10:13], marble.records["omega"][-1], atol=1e-12)
    np.testing.assert_allclose(values["gamma"][-1], marble.states[-1, 3:6], atol=1e-12)
    assert not motion.events
    with pytest.raises(flowlanes.InputError, match="mu = inf the contact cannot slip"):
        contact_motion(ideal, drop(0.7, -np.cross(omega, r) + [0.1, 0, 0], omega), [0.0, 1.0])


@pytest.mark.slow
def test_a_ball_that_never_slips_leaves_a_dome_where_the_closed_form_says() -> None:
    ball = nonholonomic.Body(0.2, (2e-4,) * 3, nonholonomic.Ball(0.05))
    dome = FrictionalContact(
        ball, nonholonomic.Sphere(1.0), laws=(Coulomb(math.inf),), field=GRAVITY
    )
    tilt = 0.05
    up = np.array([math.sin(tilt), 0.0, math.cos(tilt)])
    state = [1, 0, 0, 0, *(1.05 * up), 0, 0, 0, 0, 0, 0, *up]
    motion = contact_motion(dome, state, [0.0, 1.5])
    assert [e.kind for e in motion.events][:1] == ["lift-off"]
    height = motion.events[0].after[6] / 1.05
    assert height == pytest.approx(10 / 17 * math.cos(tilt), abs=1e-10)


@pytest.mark.slow
def test_rocking_ends_where_rolling_resistance_holds_the_body() -> None:
    """In the plane, rolling that ends begins again; on a sphere both laws are one."""
    body = nonholonomic.Body(1.0, (0.2, 0.25, 0.3), nonholonomic.Ball(1.0, centre=(0.0, 0.0, 0.3)))
    ends = []
    for law in (RollingResistance(0.01), ContourResistance(0.01)):
        contact = FrictionalContact(body, laws=(Coulomb(0.8), law), field=GRAVITY)
        turn = (1.0, 0.2, 0.0, 0.0)
        leaning = (1 - 0.2**2) / (1 + 0.2**2)
        start = state_in_space(contact, (0, 0, 1 - 0.3 * leaning), turn, (0, 0, 0), (0, 0, 0))
        motion = contact_motion(contact, start, np.linspace(0, 12, 25))
        kinds = [e.kind for e in motion.events]
        assert kinds == ["rolling reversal"] * (len(kinds) - 1) + ["rest"] and len(kinds) > 4
        values = motion
        balance = values["energy"] + motion.states[:, 16:].sum(axis=1)
        assert np.ptp(balance) < 1e-13 * values["energy"][0]
        # at rest the weight acts within the arm of the couple
        assert abs(0.3 * motion.end_state[14]) < 0.01
        ends.append(motion.events[-1].time)
    assert ends[0] == pytest.approx(ends[1], abs=1e-10)


@pytest.mark.parametrize(
    ("times", "state", "sentence"),
    [
        ([1.0, 0.0], None, "times: they must be finite numbers that increase"),
        ([0.0, 1.0], [0.0] * 5, "state: (5,) numbers; a state has 16, or 18 with the works lost"),
        ([0.0, 1.0], drop(0.5, (0, 0, 0), (0, 0, 0)), "0.2 m inside the support"),
        ([0.0, 1.0], drop(math.inf, (0, 0, 0), (0, 0, 0)), "must be finite"),
    ],
)
def test_mistakes(
    loaded: CompiledContact, times: list[float], state: list[float] | None, sentence: str
) -> None:
    with pytest.raises(flowlanes.InputError) as error:
        contact_motion(loaded, state or drop(1.5, (0, 0, 0), (0, 0, 0)), times)
    assert sentence in str(error.value)


def test_a_coarse_tolerance_is_refused(loaded: CompiledContact) -> None:
    with pytest.raises(
        flowlanes.InputError, match="tolerance 1e-08: with friction it must be at most"
    ):
        CompiledContact(loaded.situation, tolerance=1e-8)


def test_rules_are_checked() -> None:
    with pytest.raises(
        flowlanes.InputError, match=r"restitution 2\.0: it must lie between 0 and 1"
    ):
        EventRules(restitution=2.0)

    with pytest.raises(flowlanes.InputError, match="most_steps 0: it must be at least 1"):
        EventRules(most_steps=0)


@pytest.mark.parametrize(
    ("rules", "ending", "words"),
    [
        (EventRules(0.5, most_steps=1000), "many steps", "took 2,000 steps up to t = "),
        (
            EventRules(0.5, most_steps=100_000),
            "many steps",
            "took 2,000 steps, of about 5e+05 in all, up",
        ),
        (EventRules(0.5, most_events=3), "many events", "took 4 events up to t = "),
    ],
)
def test_a_motion_has_a_budget(
    rules: EventRules, ending: str, words: str, loaded: CompiledContact
) -> None:
    """Euler's disk with ω = 10⁶ was followed for minutes."""
    fast = 1e5 if ending == "many steps" else 1.0
    motion = contact_motion(loaded, drop(1.5, (1.0, 0.5, 0.0), (fast, 0, 0)), [0.0, 9.0], rules)
    assert motion.ending == ending
    assert words in motion.reason and "start it more slowly, follow it for a" in motion.reason
    assert f"t = {motion.end_time:.9g}, where the body turns with" in motion.reason
    assert motion.times[-1] == motion.end_time < 9.0


def random_drops(count: int, seed: int) -> list[tuple[list[float], EventRules]]:
    rng = np.random.default_rng(seed)
    drops = []
    for _ in range(count):
        velocity, omega = 2 * rng.normal(size=3), 3 * rng.normal(size=3)
        height = 1.4 + rng.exponential(0.5)
        law = ("stronge", "poisson")[rng.integers(2)]
        state = drop(height, velocity, omega, rng.normal(size=4))
        drops.append((state, EventRules(restitution=float(rng.uniform(0, 0.9)), impact_law=law)))
    return drops


def assert_sound(contact: CompiledContact, state: list[float], given: EventRules) -> None:
    times = np.linspace(0, 4, 41)
    motion = contact_motion(contact, state, times, given)
    assert motion.reason == "", motion.reason
    values = motion
    size = values["energy"][0]
    assert values["gap"].min() >= -1e-12
    assert np.diff(values["energy"]).max() <= 1e-12 * size
    balance = values["energy"] + motion.states[:, 16:].sum(axis=1)
    assert np.ptp(balance) <= 1e-12 * size


def test_random_starts_neither_hang_nor_fall_nor_gain_energy(loaded: CompiledContact) -> None:
    for state, given in random_drops(6, seed=1):
        assert_sound(loaded, state, given)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(10, 20))
def test_many_random_starts(loaded: CompiledContact, seed: int) -> None:
    for state, given in random_drops(60, seed):
        assert_sound(loaded, state, given)


@pytest.mark.parametrize(
    ("state", "times", "words"),
    [
        ("x", [0, 1], "state"),
        ({"omega": (0, 0, 1)}, [0, 1], "state"),
        ([1, 0, 0, 0, 0, 0, 1, *[0] * 8, 1], "x", "times"),
        ([0] * 7 + [1] * 9, [0, 1], "state: its first four numbers, the attitude, are zero"),
    ],
)
def test_states_and_times_that_are_none(
    loaded: CompiledContact, state: Any, times: Any, words: str
) -> None:
    with pytest.raises(flowlanes.InputError, match=f"^(contact_motion: )?{words}"):
        contact_motion(loaded, state, times)


def test_a_spinning_ball_stays_where_its_rolling_ends() -> None:
    """Resistance to rolling ends the rolling after 7v/(5gδ/R); nothing resists the spin."""
    ball = nonholonomic.Body(1.0, (0.004, 0.004, 0.004), nonholonomic.Ball(0.1))
    laws = (Coulomb(0.3), RollingResistance(0.002))
    contact = FrictionalContact(ball, laws=laws, field=GRAVITY)
    state = [1, 0, 0, 0, 0, 0, 0.1, 0.2, 0, 0, 0, 2.0, 5.0, 0, 0, 1]
    motion = contact_motion(contact, state, [0.0, 3.0])
    assert [(e.kind, e.mode) for e in motion.events] == [("rolling stop", "spinning")]
    assert motion.events[0].time == pytest.approx(0.2 * 1.4 * 0.1 / (G * 0.002), abs=1e-14)
    vertical = motion.end_state[13:16]
    np.testing.assert_allclose(motion.end_state[10:13], 5 * vertical, atol=1e-14)
    np.testing.assert_allclose(motion.end_state[7:10], 0, atol=1e-14)
    balance = motion["energy"] + motion.states[:, 16:].sum(axis=1)
    assert abs(balance[1] - balance[0]) < 1e-14


def test_a_ball_slides_without_rolling_where_its_resistance_is_stronger() -> None:
    """The moment μNR of friction is less than δN: the ball slides like a block, and rests."""
    ball = nonholonomic.Body(1.0, (0.004, 0.004, 0.004), nonholonomic.Ball(0.1))
    contact = FrictionalContact(ball, laws=(Coulomb(0.1), RollingResistance(0.011)), field=GRAVITY)
    state = [1, 0, 0, 0, 0, 0, 0.1, 1.0, 0, 0, 0, 0, 0, 0, 0, 1]
    motion = contact_motion(contact, state, [0.0, 0.5, 2.0])
    assert motion.intervals[0].mode == "sliding without rolling"
    assert [(e.kind, e.mode) for e in motion.events] == [("rest", "rest")]
    assert motion.events[0].time == pytest.approx(1 / (0.1 * G), abs=1e-13)
    assert motion.states[1, 7] == pytest.approx(1 - 0.05 * G, abs=1e-14)
    assert motion.end_state[4] == pytest.approx(1 / (0.2 * G), abs=1e-13)
    assert not motion.end_state[10:13].any()


def test_a_ball_that_drops_without_turning_rests_on_its_resistance() -> None:
    """No rolling is left to have a direction."""
    ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    contact = FrictionalContact(ball, laws=(Coulomb(0.3), RollingResistance(0.1)), field=GRAVITY)
    motion = contact_motion(contact, drop(1.5, (0, 0, 0), (0, 0, 0)), [0.0, 1.0])
    assert [(e.kind, e.mode) for e in motion.events] == [("landing", "rest")]
    assert motion.reason == ""


def test_a_body_at_rest_on_a_turntable_turns_with_it() -> None:
    ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    laws = (Coulomb(0.5), RollingResistance(0.3))
    contact = FrictionalContact(ball, nonholonomic.Plane(turntable=1.2), laws, GRAVITY)
    start_state = state_in_space(contact, (0.5, 0, 1), (1, 0, 0, 0), (0, 0.6, 0), (0, 0, 1.2))
    motion = contact_motion(contact, start_state, [0.0, 2.0])
    assert motion.intervals == (type(motion.intervals[0])("rest", 0.0, 2.0),)
    place = 0.5 * np.array([math.cos(2.4), math.sin(2.4)])
    np.testing.assert_allclose(motion.end_state[4:6], place, atol=1e-14)


def test_friction_without_the_normal_force_may_lift_a_body_that_cannot_fly() -> None:
    """A body leaves where it would rise without its support; the reference finds the same end."""
    body, slip = CASES["loaded ball"]["body"], [-5.0, 1.0, 0.0]
    begin = placed(body, {"kind": "plane"}, [1.0, 0.2, 0.3, -0.4], [3.0, -2.0, 5.0], slip)
    case = {**CASES["loaded ball"], "contact": {"viscous": 4.2}, "start": begin}
    motion = motion_of(case)
    assert (motion.ending, motion.events) == ("lifted", ())
    assert motion.end_time == pytest.approx(0.33553560703527, abs=1e-13)
    with pytest.raises(
        ArithmeticError, match=r"neither contact nor flight .* t = 0\.33553560703527"
    ):
        simulate(body, {"kind": "plane"}, {"viscous": 4.2}, begin, 1.0)


def jamming(rules: EventRules, times: Any) -> Any:
    """An ellipsoid on a sphere; as it slides, B falls to zero and the normal force grows."""
    inertia = [[0.1408, -0.0046, 0.0], [-0.0046, 0.1174, -0.0118], [0.0, -0.0118, 0.1474]]
    shape = nonholonomic.Ellipsoid(
        (0.612, 0.916, 0.859), turn=-0.198, centre=(-0.171, 0.176, -0.081)
    )
    field = nonholonomic.Forces(gravity=1.0)
    body = nonholonomic.Body(1.898, inertia, shape)
    contact = FrictionalContact(body, nonholonomic.Sphere(4.0), (Coulomb(0.654),), field)
    state = state_in_space(
        contact,
        (1.45549644098972, 1.3804334756152463, 4.5025878715455985),
        (-0.7940359575902549, -0.19309510786853926, 0.11910539363853824, -0.5639459926067152),
        (0.04562095153316903, -0.5970375016447813, -0.16872198149816142),
        (0.705, -2.075, 1.155),
    )
    return contact_motion(contact, state, times, rules)


@pytest.mark.slow
def test_a_dynamic_jam_ends_in_finite_time() -> None:
    """1/N² falls linearly to zero, and there the motion ends with a reason."""
    motion = jamming(EventRules(), [0.0, 0.0121, 0.01214, 0.0121431, 0.02])
    assert motion.ending == "paradox"
    inverse = motion["normal_force"][2:4] ** -2.0
    slope = (inverse[1] - inverse[0]) / (motion.times[3] - motion.times[2])
    assert motion.end_time == pytest.approx(motion.times[3] - inverse[1] / slope, abs=1e-9)
    # B, the determinant, vanishes with 1/N; the contact is where the last samples lead
    words = re.search(
        r"at t = (.*) s with the contact at \((.*)\) m .* B = (.*) /kg, has fallen to",
        motion.reason,
    )
    assert words is not None
    assert float(words[1]) == pytest.approx(motion.end_time, rel=1e-8)
    contact = motion["contact"]
    slowly = (motion.end_time - motion.times[3]) / (motion.times[3] - motion.times[2])
    leads = contact[3] + slowly * (contact[3] - contact[2])
    assert [float(x) for x in words[2].split(",")] == pytest.approx(leads, abs=1e-5)
    assert abs(float(words[3])) < 1e-6
    again = jamming(EventRules(on_paradox="impact"), [0.0, 0.02])
    assert again.events[0].kind == "impact without collision"
    assert again.events[0].time == pytest.approx(motion.end_time, abs=1e-11)
    assert np.linalg.norm(again.events[0].impulse) > 0
    energies = [motion["energy"][0], again["energy"][-1]]
    assert energies[1] < energies[0]
    for each in (motion, again):
        balance = each["energy"] + each.states[:, 16:].sum(axis=1)
        assert np.ptp(balance) < 1e-15 * energies[0]


def test_an_impact_without_collision_gives_back_what_it_stored() -> None:
    """A spheroid slides against the way in which it leans, and bounces from the paradox."""
    body = nonholonomic.Body(1.0, (0.208, 0.208, 0.016), nonholonomic.Ellipsoid((0.2, 0.2, 1.0)))
    contact = CompiledContact(FrictionalContact(body, laws=(Coulomb(1.9),), field=GRAVITY))
    lean = 1.1621
    slip = (0.0, math.sin(lean), -math.cos(lean))
    state = state_in_contact(
        contact.situation, (0, 0, 0), (0.0, math.cos(lean), math.sin(lean)), slip
    )
    given, impulses = (0.0, 0.5), []
    for part in given:
        chosen = EventRules(part, "poisson", on_paradox="impact")
        motion = contact_motion(contact, state, [0.0, 1e-4], chosen)
        event = motion.events[0]
        assert event.kind == "impact without collision"
        assert event.mode == ("flight" if part else "rolling")
        impulses.append(float(event.impulse @ event.after[13:16]))
        balance = motion["energy"] + motion.states[:, 16:].sum(axis=1)
        assert np.ptp(balance) < 1e-14 * balance[0]
    assert impulses[0] == pytest.approx(0.291526, abs=2e-5)
    assert impulses[1] == pytest.approx(1.5 * impulses[0], rel=1e-12)
    assert motion["gap"][-1] > 1e-6


@pytest.mark.parametrize(
    ("force", "couple", "variables"),
    [
        ("0.2 + 0.1*slip_speed*spin", "0", "force depends on spin"),
        ("0.2", "0.01 + 0.02*spin", "couple depends on spin"),
    ],
)
def test_an_impact_with_friction_that_has_no_meaning_in_it(
    force: str, couple: str, variables: str
) -> None:
    ball = nonholonomic.Body(1.0, (0.4, 0.4, 0.4), nonholonomic.Ball(1.0))
    contact = FrictionalContact(ball, laws=(UserFriction(force, couple),), field=GRAVITY)
    motion = contact_motion(contact, drop(1.5, (1, 0, 0), (0, 0, 1)), [0.0, 1.0])
    assert motion.ending == "impact"
    assert motion.reason == (
        f"the friction of an impact is not known: {variables}, and impacts follow formulas in "
        "slip_speed alone, with a constant couple"
    )
    assert motion.end_time == pytest.approx(math.sqrt(2 * 0.5 / G), rel=1e-12)
