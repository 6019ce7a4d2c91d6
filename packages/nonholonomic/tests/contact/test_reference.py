"""The reference for bodies in contact, against closed forms and against itself."""

from __future__ import annotations

import json
import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

import contact.reference_bodies as reference_bodies
import contact.reference_motion as reference_motion
from contact.reference import placed, readable_state, reference_course, simulate
from contact.reference_bodies import cross, dot, length, rotation, times
from contact.reference_cases import (
    BALL,
    FILE,
    LOADED,
    PEBBLE,
    PLANE,
    TIPPE_TOP,
    cases,
    difference,
    loaded_ball,
    tilted,
    with_results,
)
from contact.reference_forces import Direction, Mode, Problem, patch_friction
from contact.reference_integration import run
from contact.reference_motion import Dying, Motion

ASKEW = [1.0, 0.2, 0.3, -0.4]
TABLE = {case["name"]: case for case in json.loads(FILE.read_text())}
G = 9.81


def test_billiard_ball_slides_on_a_parabola_until_it_rolls() -> None:
    slip = np.array([0.7, 0.2, 0.0])
    start = placed(BALL, PLANE, ASKEW, [3.0, -2.0, 5.0], slip.tolist())
    events, _ = simulate(BALL, PLANE, {"mu": 0.2}, start, 0.2)
    speed = float(np.linalg.norm(slip))
    end = 2.0 * speed / (7.0 * 0.2 * G)
    assert [e["kind"] for e in events] == ["stick"]
    assert abs(events[0]["time"] - end) < 1e-14
    drag = -0.2 * G * slip / speed
    where = np.array(start["position"]) + end * np.array(start["velocity"]) + drag * end**2 / 2
    assert np.abs(np.array(events[0]["position"]) - where).max() < 1e-14


def test_rolling_resistance_stops_the_ball() -> None:
    start = placed(BALL, PLANE, [1.0, 0.0, 0.0, 0.0], [0.0, 12.0, 0.0])
    events, final = simulate(BALL, PLANE, {"mu": 0.2, "rolling": 0.02}, start, 2.0)
    slowing = 5.0 / 7.0 * 0.02 * G / 0.1
    assert [e["kind"] for e in events] == ["rest"]
    assert abs(events[0]["time"] - 1.2 / slowing) < 1e-13
    assert abs(final["position"][0] - 1.2**2 / (2.0 * slowing)) < 1e-13


@pytest.mark.parametrize(
    ("name", "mu"), [("ball leaves a dome", 0.4), ("ball leaves a smoother dome", 0.1)]
)
def test_ball_on_a_dome_slides_and_leaves_where_it_must(name: str, mu: float) -> None:
    slip, leaving = TABLE[name]["events"]
    assert (slip["kind"], leaving["kind"]) == ("slip", "lift-off")
    # rolling from rest at the top: N = mg (17 cos - 10)/7, friction (2/7) mg sin
    begin = brentq(lambda a: 2 * math.sin(a) - mu * (17 * math.cos(a) - 10), 0.0, 0.9)
    # sliding: w = v^2/(g (R + r)), w' = 2 sin - 2 mu (cos - w), leaves at w = cos
    d = 1.0 + 4.0 * mu * mu
    a, b = (4.0 * mu * mu - 2.0) / d, -6.0 * mu / d
    rest = 10.0 / 7.0 * (1 - math.cos(begin)) - a * math.cos(begin) - b * math.sin(begin)

    def lightness(t: float) -> float:
        w = a * math.cos(t) + b * math.sin(t) + rest * math.exp(2 * mu * (t - begin))
        return w - math.cos(t)

    end = brentq(lightness, begin, 1.2)
    for event, angle in ((slip, begin), (leaving, end)):
        x, _, z = event["position"]
        assert abs(math.atan2(x, z) - angle) < 2e-12


def test_ball_rolls_on_circles_at_two_sevenths_of_the_turntable() -> None:
    table = TABLE["ball on a turntable"]
    stick, final = table["events"][0], table["final"]
    angle = 2.0 / 7.0 * 2.0 * (final["time"] - stick["time"])
    before = complex(*stick["velocity"][:2]) * complex(math.cos(angle), math.sin(angle))
    assert abs(before - complex(*final["velocity"][:2])) < 1e-12


@pytest.mark.parametrize("k", [0.0, 0.2, 0.7, 0.999, 1.3, 1.9, 2.1, 10.0])
def test_friction_of_a_patch_is_the_integral_over_it(k: float) -> None:
    force, couple = patch_friction((k, 0.0, 0.0), 1.0)

    def ring(rho: float, weight: int) -> float:
        def entry(angle: float) -> float:
            x, y = k - rho * math.sin(angle), rho * math.cos(angle)
            size = math.hypot(x, y)
            if size < 1e-14:
                return 0.0
            return (x if weight == 0 else rho * (y * math.cos(angle) - x * math.sin(angle))) / size

        split = [math.pi / 2] if abs(rho - k) < 0.3 else None
        value: float = quad(entry, -math.pi / 2, 3 * math.pi / 2, points=split, limit=200)[0]
        return value

    def whole(weight: int) -> float:
        # rho = sin(s): pressure 3/(2 pi) cos(s)
        def strip(s: float) -> float:
            return 1.5 / math.pi * math.cos(s) ** 2 * math.sin(s) * ring(math.sin(s), weight)

        split = [math.asin(k)] if 0.0 < k < 1.0 else None
        value: float = quad(strip, 0.0, math.pi / 2, points=split, epsabs=1e-10)[0]
        return value

    assert abs(force[0] + whole(0)) < 2e-8
    assert abs(couple + whole(1)) < 2e-8


def test_patch_friction_joins_smoothly_where_its_formulas_change() -> None:
    for k in (1.0, 2.0):
        below = patch_friction((k * (1 - 1e-13), 0.0, 0.0), 1.0)
        above = patch_friction((k * (1 + 1e-13), 0.0, 0.0), 1.0)
        assert abs(below[0][0] - above[0][0]) < 1e-12
        assert abs(below[1] - above[1]) < 1e-12


@pytest.mark.parametrize("slip", [0.3, 8.0])
@pytest.mark.parametrize("law", ["stronge", "poisson", "newton"])
def test_ball_that_lands_aslant(slip: float, law: str) -> None:
    """Short of 7/2 mu (1 + e) times the normal speed the sliding ends in the impact."""
    start = placed(BALL, PLANE, [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 3.0], [slip, 0.0, 0.0], height=0.2)
    contact = {"mu": 0.2, "restitution": 0.5, "impact_law": law}
    events, _ = simulate(BALL, PLANE, contact, start, 0.21)
    fall = math.sqrt(2 * G * 0.2)
    change = min(2.0 / 7.0 * slip, 0.2 * 1.5 * fall)
    assert abs(events[0]["time"] - fall / G) < 1e-14
    assert abs(events[0]["velocity"][0] - (slip - change)) < 1e-13
    assert abs(events[0]["velocity"][2] - 0.5 * fall) < 1e-13


@pytest.mark.parametrize("law", ["stronge", "poisson", "newton"])
@pytest.mark.parametrize("mu", [0.1, 0.9])
def test_impact_against_smoothed_friction(law: str, mu: float) -> None:
    """Impulses added up with friction that is smooth near rest, in which nothing is told apart."""
    start = placed(PEBBLE, PLANE, ASKEW, [3.0, -2.0, 5.0], [0.7, 0.2, 0.0], height=0.2)
    contact = {"mu": mu, "restitution": 0.6, "impact_law": law}
    event = reference_course(PEBBLE, PLANE, contact, start, 0.15).events[0]
    assert event.kind == "landing"
    problem = Problem(PEBBLE, PLANE, contact, G)
    turn, n, _, arm, omega = (np.array(x) for x in problem.geometry(event.before))
    mobility = turn @ np.linalg.inv(problem.body.inertia) @ turn.T
    velocity = np.array(event.before[7:10])

    def particle(v: Any, w: Any) -> Any:
        return v + np.cross(w, arm)

    def rate(p: float, z: Any) -> Any:
        u = particle(z[:3], z[3:6])
        slip = u - (u @ n) * n
        force = n - mu * slip / math.sqrt(slip @ slip + 1e-14)
        return [*(force / problem.body.mass), *(mobility @ np.cross(arm, force)), u @ n]

    def through(z: Any, until: Any) -> Any:
        until.terminal = True
        return solve_ivp(rate, (0.0, 50.0), z, "LSODA", rtol=1e-10, atol=1e-12, events=until)

    first = through([*velocity, *omega, 0.0], lambda p, z: particle(z[:3], z[3:6]) @ n + 1e-300)
    middle = first.y_events[0][0]
    begun = float(particle(velocity, omega) @ n)
    ends = {
        "stronge": lambda p, z: z[6] - middle[6] * (1.0 - 0.6**2),
        "poisson": lambda p, z: p - 0.6 * first.t_events[0][0],
        "newton": lambda p, z: particle(z[:3], z[3:6]) @ n + 0.6 * begun,
    }
    last = through(middle, ends[law]).y_events[0][0]
    state = readable_state(problem, event.after)
    assert np.abs(last[:3] - state["velocity"]).max() < 1e-6
    assert np.abs(turn.T @ last[3:6] - state["omega"]).max() < 1e-6


@pytest.mark.parametrize("contact", [{"mu": 0.3}, {"slip": 0.3}, {"mu": 0.3, "patch": 1e-6}])
def test_jellett_integral_of_a_sliding_top(contact: dict[str, Any]) -> None:
    start = placed(TIPPE_TOP, PLANE, tilted(0.3), [20.0, -10.0, 150.0])
    start["velocity"][:2] = [0.05, 0.02]
    motion = reference_course(TIPPE_TOP, PLANE, contact, start, 0.02)
    others = reference_course(TIPPE_TOP, PLANE, contact, start, 0.0)

    def jellett(m: Motion) -> float:
        _, _, _, arm, _ = m.problem.geometry(m.y)
        return float(dot(m.y[10:13], arm))

    # a patch has a couple besides the force, here a very small one
    allowed = 1e-12 if "patch" not in contact else 1e-4
    assert abs(jellett(motion) / jellett(others) - 1.0) < allowed
    assert np.abs(np.array(motion.y) - others.y).max() > 1e-3


def held_energy_change() -> float:
    """Change of the energy of a rolling pebble, which should be none."""
    start = placed(PEBBLE, PLANE, ASKEW, [1.0, -1.5, 0.8])
    motion = reference_course(PEBBLE, PLANE, {"mu": 50.0}, start, 0.5)
    first = reference_course(PEBBLE, PLANE, {"mu": 50.0}, start, 0.0)
    return abs(motion.problem.energy(motion.y) - first.problem.energy(first.y))


def test_rolling_keeps_the_energy() -> None:
    assert held_energy_change() < 1e-12


def test_a_mistake_in_the_motion_of_the_contact_point_changes_the_energy(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    right = reference_bodies.Body.arm_rate
    monkeypatch.setattr(
        reference_bodies.Body, "arm_rate", lambda self, g, rate: times(0.99, right(self, g, rate))
    )
    assert held_energy_change() > 1e-4


@pytest.mark.parametrize(
    "contact",
    [
        {"mu": 0.3},
        {"mu": 0.3, "spin_arm": 0.1},
        {"mu": 0.3, "patch": 0.2},
        {"viscous": 0.5, "spin_viscous": 0.2},
        {"slip": 0.5},
        {"mu": 0.3, "rolling": 0.05},
        {"rolling_viscous": 0.1},
        {"contour": 0.1},
    ],
)
@pytest.mark.parametrize(
    "surface",
    [
        PLANE,
        {"kind": "sphere", "radius": 3.0, "side": "outside"},
        {"kind": "sphere", "radius": 4.0, "side": "inside"},
    ],
)
def test_power_lost_is_what_the_law_says(contact: dict[str, Any], surface: dict[str, Any]) -> None:
    at = [0.1, 0.2, -1.0 if surface.get("side") == "inside" else 1.0]
    start = placed(PEBBLE, surface, ASKEW, [1.0, -1.5, 0.8], [0.6, -0.4, 0.1], at)
    problem = Problem(PEBBLE, surface, contact, G)
    momentum = problem.body.momentum(start["attitude"], start["omega"])
    y = np.array([*start["position"], *start["attitude"], *start["velocity"], *momentum])
    turn, n, _, _, omega = problem.geometry(y.tolist())
    mode = Mode(sign=math.copysign(1.0, dot(omega, n)))
    found = problem.response(y.tolist(), mode)
    rate = np.array(problem.rate(y.tolist(), mode))
    h = 1e-5
    power = (problem.energy(y + h * rate) - problem.energy(y - h * rate)) / (2 * h)
    speed, spin, over = length(found.slip), abs(found.spin), length(found.turn)
    law, weight = problem.law, found.normal
    lost = law.viscous * speed**2 + law.spin_viscous * spin**2
    lost += weight * (law.slip * speed**2 + law.spin_arm * spin + law.rolling * over)
    lost += weight * law.rolling_viscous * over**2
    if law.patch:
        force, couple = patch_friction(found.slip, law.patch * found.spin)
        lost -= weight * law.mu * (dot(force, found.slip) + law.patch * couple * found.spin)
    else:
        lost += weight * law.mu * speed
    if law.contour:
        gamma = np.array(turn).T @ n
        inner = np.array(turn).T @ omega
        h = 1e-6
        step = np.cross(gamma, inner) * h
        arms = [np.array(problem.body.arm((gamma + s * step).tolist())) for s in (1.0, -1.0)]
        lost += weight * law.contour * float(np.linalg.norm(arms[0] - arms[1])) / (2 * h)
    assert weight > 0.0
    assert abs(power + lost) < 1e-7 * (1.0 + lost)


def before_slip() -> tuple[Problem, list[float], float]:
    """Held loaded ball at the moment when friction reaches its limit."""
    slip = TABLE["loaded ball"]["events"][1]
    assert slip["kind"] == "slip"
    problem = Problem(LOADED, PLANE, {"mu": 0.3}, G)
    momentum = problem.body.momentum(slip["attitude"], slip["omega"])
    return problem, [*slip["position"], *slip["attitude"], *slip["velocity"], *momentum], 0.03


def slid(reach: float, terms: int, monkeypatch: pytest.MonkeyPatch) -> np.ndarray[Any, Any]:
    """State a little after sliding has begun by its Taylor series."""
    problem, y, later = before_slip()
    monkeypatch.setattr(reference_motion, "TERMS", terms)
    monkeypatch.setattr(Motion, "reach_factor", reach)
    motion = Motion(problem, y, later, 1e-13)
    motion.mode = Mode(True, True)
    motion.start_by_series("slide")
    motion.go()
    return np.array(motion.y)


@pytest.mark.slow
def test_start_of_sliding_does_not_depend_on_the_length_of_its_series(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    first = slid(1.0, 18, monkeypatch)
    for reach, terms in ((0.5, 18), (0.8, 12)):
        assert np.abs(slid(reach, terms, monkeypatch) - first).max() < 1e-13


@pytest.mark.slow
def test_start_of_sliding_against_crude_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Starts along the old force, for ever shorter times, converge to the series quadratically."""
    exact = slid(1.0, 18, monkeypatch)
    problem, y, later = before_slip()
    held = problem.response(y, Mode(True, True))
    e = times(-1.0 / length(held.friction), held.friction)
    errors = []
    for first in (4e-3, 2e-3, 1e-3):
        motion = Motion(problem, y, later, 1e-12)
        motion.mode = Mode(True)

        def rate(t: float, z: Any) -> Any:
            return np.array(problem.rate(z.tolist(), Mode(True), Direction(slip=e)))

        start = np.array(y)
        _, z, _ = run(rate, 0.0, start, first, lambda t, z: [1.0], 1e-12, motion.scales(y))
        motion.t, motion.y = first, z.tolist()
        x = np.array(problem.response(motion.y, Mode(True), Direction(slip=e)).slip)
        size = float(np.linalg.norm(x))
        motion.dying = Dying("slide", math.log(size), (x / size).tolist())
        motion.go()
        errors.append(np.array(motion.y) - exact)
    sizes = [float(np.abs(error).max()) for error in errors]
    assert 3.0 < sizes[0] / sizes[1] < 5.0
    assert 3.0 < sizes[1] / sizes[2] < 5.0
    extrapolated = (4.0 * errors[2] - errors[1]) / 3.0
    assert np.abs(extrapolated).max() < 0.05 * sizes[2]


@pytest.mark.slow
def test_direct_restart_is_the_limit_of_smoothed_friction(monkeypatch: pytest.MonkeyPatch) -> None:
    body, surface, contact, start = loaded_ball(115)
    motion = reference_course(body, surface, contact, start, 0.05)
    assert [e.kind for e in motion.events] == ["direct restart"]
    problem = motion.problem
    momentum = problem.body.momentum(start["attitude"], start["omega"])
    y = np.array([*start["position"], *start["attitude"], *start["velocity"], *momentum])
    errors = []
    for width in (1e-3, 1e-4):

        def smoothed(self: Problem, slip: Any, *others: Any, width: float = width) -> Any:
            size = math.sqrt(dot(slip, slip) + width * width)
            return times(-contact["mu"] / size, slip), [0.0, 0.0, 0.0]

        monkeypatch.setattr(Problem, "_per_normal_force", smoothed)
        solved = solve_ivp(
            lambda t, z: np.array(problem.rate(z.tolist(), Mode())),
            (0.0, 0.05),
            y,
            method="LSODA",
            rtol=1e-9,
            atol=1e-11,
        )
        errors.append(float(np.abs(solved.y[:, -1] - motion.y).max()))
    assert errors[1] < 5e-4
    assert errors[1] < 0.2 * errors[0]


def numbers_in(value: Any) -> tuple[list[float], Any]:
    """The numbers of nested lists and tables, in order, and what is left when each is a zero."""
    numbers: list[float] = []

    def note(text: str) -> float:
        numbers.append(float(text))
        return 0.0

    return numbers, json.loads(json.dumps(value), parse_float=note)


def test_table_is_of_the_cases() -> None:
    """To the last digit but one: from Python 3.12 on a sum of floats is rounded only once."""
    for case in cases():
        stored = TABLE[case["name"]]
        wanted, form = numbers_in({key: stored[key] for key in case})
        numbers, own_form = numbers_in(case)
        assert own_form == form
        assert numbers == pytest.approx(wanted, rel=1e-14, abs=1e-14)
    assert list(TABLE) == [case["name"] for case in cases()]


@pytest.mark.parametrize("name", list(TABLE))
def test_table_is_plausible(name: str) -> None:
    """Errors are small, nothing sinks into the support, energy never grows on a support at rest."""
    case = TABLE[name]
    assert case["error"] < 1e-10
    problem = Problem(case["body"], case["surface"], case["contact"], case["gravity"])
    energies = []
    for state in [case["start"], *case["events"], case["final"]]:
        momentum = problem.body.momentum(state["attitude"], state["omega"])
        y = [*state["position"], *state["attitude"], *state["velocity"], *momentum]
        assert problem.geometry(y)[2] > -1e-11
        energies.append(problem.energy(y))
    if not case["surface"].get("turntable") and case["contact"].get("impact_law") != "newton":
        assert np.all(np.diff(energies) < 1e-9 * max(1.0, abs(energies[0])))
    moments = [event["time"] for event in case["events"]]
    assert moments == sorted(moments)


QUICK = ["billiard ball", "bouncing pebble", "bouncing pebble, Newton"]
LONG = [
    *("pebble, coupled law", "pebble in a bowl, coupled law", "rising egg", "rattleback"),
    *(name for name in TABLE if "tippe top" in name),
    *("direct restart 12", "direct restart 144", "drawn 15"),
]


def marked(name: str) -> Any:
    """Case with the mark that its time of computation asks for."""
    if name in QUICK:
        return name
    return pytest.param(name, marks=pytest.mark.campaign if name in LONG else pytest.mark.slow)


@pytest.mark.parametrize("name", [marked(name) for name in TABLE])
def test_table_is_reproduced(name: str) -> None:
    case = next(c for c in cases() if c["name"] == name)
    again, stored = with_results(case), TABLE[name]
    assert [e["kind"] for e in again["events"]] == [e["kind"] for e in stored["events"]]
    pairs = zip(
        [*again["events"], again["final"]], [*stored["events"], stored["final"]], strict=True
    )
    assert max(difference(a, b) for a, b in pairs) <= 4.0 * stored["error"] + 1e-13


@pytest.mark.slow
def test_nineteen_digits_and_extrapolation_agree_with_sixteen() -> None:
    start = placed(LOADED, PLANE, ASKEW, [3.0, -2.0, 5.0], [0.2, 0.1, 0.0])
    one = simulate(LOADED, PLANE, {"mu": 0.3}, start, 0.05)
    other = simulate(LOADED, PLANE, {"mu": 0.3}, start, 0.05, G, 1e-15, np.longdouble)
    assert [e["kind"] for e in one[0]] == ["stick"]
    assert difference(one[0][0], other[0][0]) < 1e-13
    assert difference(one[1], other[1]) < 1e-13


def test_normal_and_gap_of_an_ellipsoid_in_a_bowl() -> None:
    """No point of the body is nearer to the support than the one found."""
    surface = {"kind": "sphere", "radius": 4.0, "side": "inside"}
    start = placed(PEBBLE, surface, ASKEW, [0.0, 0.0, 0.0], at=[0.3, 0.1, -1.0], height=0.2)
    problem = Problem(PEBBLE, surface, {}, G)
    turn = rotation(start["attitude"])
    n, gap = problem.surface.normal_and_gap(problem.body, start["position"], turn, None)
    assert abs(gap - 0.2) < 1e-13
    rng = np.random.default_rng(3)
    t1 = np.array(cross(n, [0.3, -0.5, 0.7]))
    for direction in [*rng.normal(size=(200, 3)), np.array(n) + 1e-3 * t1]:
        gamma = np.array(turn).T @ (direction / np.linalg.norm(direction))
        point = np.array(turn) @ problem.body.arm(gamma.tolist()) + start["position"]
        assert 4.0 - np.linalg.norm(point) >= 0.2 - 1e-12
