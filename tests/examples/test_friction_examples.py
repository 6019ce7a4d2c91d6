"""The examples of motions with friction: what their pages say, against other derivations."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import matplotlib
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import chaplygin
from chaplygin.experiment.contact.trajectory import ContactTrajectory
from chaplygin.experiment.models.experiment import load_experiment
from contact.reference_bodies import rotation
from contact.reference_forces import Direction, Mode, Problem
from nonholonomic.contact import CompiledContact, Coulomb, contact_motion
from nonholonomic.contact.pressure.pressure import CoupledFriction, Ring, Uniform
from nonholonomic.starts import initial_state

ROOT = Path(__file__).parents[2]
PAGE = (ROOT / "packages/nonholonomic/docs/friction.md").read_text(encoding="utf-8")
NAMES = ("tippe_top", "sliding_disk", "eulers_disk", "friction_figures", "disk_on_ice")


@pytest.fixture(scope="module")
def examples() -> Iterator[dict[str, ModuleType]]:
    matplotlib.use("agg")
    sys.path.insert(0, str(ROOT / "examples"))
    try:
        yield {name: import_module(name) for name in NAMES}
    finally:
        sys.path.remove(str(ROOT / "examples"))


def said(number: str) -> str:
    """A number as the page prints it."""
    assert number in PAGE, f"nonholonomic/docs/friction.md does not say {number}"
    return number


# --- the page ------------------------------------------------------------------------------------


def test_every_file_and_picture_of_the_page_exists() -> None:
    named = re.findall(r"(?<!tests/)examples/\w+\.(?:toml|py)", PAGE)
    pictures = re.findall(r"\]\(([./]+docs/pictures/\w+\.png)\)", PAGE)
    assert len(set(named)) >= 14
    assert all((ROOT / name).exists() for name in named)
    assert len(pictures) >= 13
    assert all((ROOT / "packages/nonholonomic/docs" / name).exists() for name in pictures)


def test_every_test_of_the_page_exists() -> None:
    named = set(re.findall(r"`(test_\w+)`", PAGE))
    texts = "".join(
        path.read_text(encoding="utf-8")
        for folder in (ROOT / "tests", *ROOT.glob("packages/*/tests"))
        for path in folder.rglob("*.py")
    )
    assert len(named) >= 25
    assert [name for name in sorted(named) if f"def {name}(" not in texts] == []


@pytest.mark.parametrize("name", sorted(set(re.findall(r"examples/(\w+)\.toml", PAGE))))
def test_every_file_of_the_page_is_valid_and_has_friction(name: str) -> None:
    experiment = load_experiment(ROOT / "examples" / f"{name}.toml")
    assert experiment.contact.model == "friction"
    assert experiment.title


# --- a disk on its face --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("pressure", "beta", "published", "accuracy"),
    [
        pytest.param(Uniform(), 0.5, 0.653, 5e-4, id="Farkas and others"),
        pytest.param(Uniform(), 0.5, 0.6530017892, 1e-10, id="disk"),
        pytest.param(Uniform(), 0.3, 1.17678, 5e-6, id="light disk"),
        pytest.param(Ring(), 1.0, 1.0, 1e-12, id="hoop"),
    ],
)
def test_limiting_ratio_of_a_sliding_disk(
    examples: dict[str, ModuleType],
    pressure: CoupledFriction,
    beta: float,
    published: float,
    accuracy: float,
) -> None:
    found = examples["sliding_disk"].limiting_ratio(pressure, beta)
    assert found == pytest.approx(published, abs=accuracy)


def test_a_light_disk_ends_sliding_and_a_heavy_one_spinning(
    examples: dict[str, ModuleType],
) -> None:
    ratio = examples["sliding_disk"].limiting_ratio
    assert math.isinf(ratio(Uniform(), 0.249))
    assert 0 < ratio(Uniform(), 0.251) < math.inf
    assert ratio(Uniform(), 0.668) == 0
    assert ratio(Uniform(), 0.665) > 0


def test_the_force_of_the_sliding_disk_by_a_sum_over_its_face() -> None:
    rho = (np.arange(400) + 0.5) / 400
    angle = 2 * np.pi * (np.arange(400) + 0.5) / 400
    x, y = rho[:, None] * np.cos(angle), rho[:, None] * np.sin(angle)
    k = 0.6530017892
    along, across = k - y, x
    weights = rho[:, None] / rho.sum() / 400
    speed = np.hypot(along, across)
    assert float((weights * along / speed).sum()) == pytest.approx(float(Uniform().force(k)), 1e-4)
    couple = float((weights * (x * across - y * along) / speed).sum())
    assert couple == pytest.approx(float(Uniform().couple(k)), rel=1e-4)


def test_the_puck_of_the_page(examples: dict[str, ModuleType]) -> None:
    """The same motion in time, without logarithms, up to shortly before its end."""
    whole = examples["sliding_disk"].slide(1.0, 1.0, Uniform())
    assert whole.duration == pytest.approx(float(said("1.34029828")), abs=5e-9)
    assert whole.distance == pytest.approx(float(said("0.637397224")), abs=5e-10)

    def rates(_: float, state: np.ndarray) -> list[float]:
        k = state[0] / state[1]
        return [-float(Uniform().force(k)), -2 * float(Uniform().couple(k)), state[0]]

    run = solve_ivp(rates, (0.0, 1.34), [1.0, 1.0, 0.0], rtol=1e-9, atol=1e-12)
    v, spin, place = run.y[:, -1]
    left = whole.duration - 1.34
    slope = float(Uniform().force(v / spin))
    assert v == pytest.approx(slope * left, rel=1e-3)
    assert place == pytest.approx(whole.distance, abs=1e-6)


# --- the tippe top -------------------------------------------------------------------------------


def test_the_least_spin_of_the_tippe_top(examples: dict[str, ModuleType]) -> None:
    top = examples["tippe_top"]
    assert f"{top.least_spin(0.2):.3f}" == said("119.595")
    assert f"{top.least_spin(0.2, 0.1):.3f}" == said("119.234")
    assert math.isinf(top.least_spin(1 / 7 - 1e-9))
    near, nearer = (top.least_spin(1 / 7 + margin) for margin in (1e-4, 1e-6))
    assert nearer / near == pytest.approx(10.0, rel=1e-3)


def test_jelletts_integral_of_the_start(examples: dict[str, ModuleType]) -> None:
    """By the state itself: J = (Iω, Rγ − c e₃)."""
    top = examples["tippe_top"]
    state = top.start(top.top(top.CHART_LAW, 0.25), 150.0, 0.2)
    omega, gamma = np.array(state[10:16], dtype=float).reshape(2, 3)
    arm = top.RADIUS * gamma - np.array([0.0, 0.0, 0.25 * top.RADIUS])
    value = (np.array(top.MOMENTS) * omega) @ arm
    assert value == pytest.approx(top.jellett(150.0, 0.2, 0.25), rel=1e-13)


@pytest.mark.slow
def test_the_top_of_leine_and_glocker_under_every_law(examples: dict[str, ModuleType]) -> None:
    top = examples["tippe_top"]
    motions = top.inversions(2.5)
    passages = {
        words: f"{top.passage(contact, motion, 0.0):.9f}"
        for words, (contact, motion) in motions.items()
    }
    assert list(passages.values()) == [
        said("0.750627982"),
        said("0.761695077"),
        said("2.365282986"),
    ]
    contact, coulomb = motions["Coulomb, at a point"]
    (event,) = coulomb.events
    assert event.mode == "rolling"
    assert f"{event.time:.9f}" == said("1.105093661")
    assert f"{event.after[15]:.6f}".replace("-", "−") == said("−0.716637")
    rolled = contact_motion(contact, event.after, np.linspace(0.0, 5.0, 1001))
    assert not rolled.events
    assert rolled.states[:, 15].max() < -0.7155
    assert rolled.states[:, 15].min() > -0.7216


@pytest.mark.slow
def test_tops_turn_over_by_the_condition(examples: dict[str, ModuleType]) -> None:
    """Next to the threshold on both sides; a top with I₁/I₃ above 1 + α never does."""
    top = examples["tippe_top"]
    contact = CompiledContact(top.top(top.CHART_LAW, 0.3), 1e-12)
    least = top.least_spin(0.3, top.LEAN)
    assert top.end(contact, 1.06 * least) < -1 + top.ON_ITS_HEAD
    assert top.end(contact, 0.94 * least) > -0.98
    never = CompiledContact(top.top(top.CHART_LAW, 0.13), 1e-12)
    assert top.end(never, 400.0) > -1 + top.ON_ITS_HEAD


# --- motions of files ----------------------------------------------------------------------------


def motion(examples: dict[str, ModuleType], name: str, *overrides: str) -> ContactTrajectory:
    run = examples["friction_figures"].motion(name, *overrides)
    assert isinstance(run, ContactTrajectory)
    return run


@pytest.mark.slow
def test_the_billiard_ball(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "billiard_ball", "run.samples=101")
    slip = np.linalg.norm(run.records["slip"][0])
    assert run.changes[0].time == pytest.approx(2 * slip / (7 * 0.2 * 9.81), rel=1e-13)
    assert f"{run.changes[0].time:.13f}" == said("0.3380547514217")
    assert examples["friction_figures"].parabola_error(run) < 1e-14


@pytest.mark.slow
def test_the_dry_rattleback(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "dry_rattleback", "run.until=0.5", "run.samples=11")
    assert len(run.changes) == 26
    assert f"{run.changes[0].time:.9f}" == said("0.005734605")
    assert f"{run.changes[-1].time:.9f}" == said("0.494539258")
    assert [e.kind for e in run.changes] == ["slip", "stick"] * 13
    assert run.drift < 1e-13


@pytest.mark.slow
def test_samples_where_sliding_begins_have_observables(examples: dict[str, ModuleType]) -> None:
    """A sample within the first moments of a slip, whose equations have a further variable."""
    run = motion(examples, "dry_rattleback", "run.until=0.007", "run.samples=36")
    slip = np.linalg.norm(run.records["slip"], axis=1)
    just = (run.times > run.changes[0].time) & (run.times < run.changes[0].time + 5e-4)
    assert just.any()
    assert (slip[just] > 0).all()


@pytest.mark.slow
def test_the_egg_jumps(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "rising_egg", "run.until=1.03", "run.samples=104")
    assert [e.kind for e in run.changes] == ["lift-off", "landing"] * 2
    times = [f"{e.time:.9f}" for e in run.changes]
    assert times[:3] == [said("0.954852400"), said("0.965171808"), said("1.007389874")]


@pytest.mark.slow
def test_the_superball_comes_back(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "superball", "run.samples=9")
    first = run.changes[0]
    assert first.time == pytest.approx(math.sqrt(2 * 0.775 / 9.81), rel=1e-14)
    end = math.sqrt(2 * 0.775 / 9.81) * 19
    rest = next(e for e in run.changes if e.mode != "flight")
    assert rest.time == pytest.approx(end, abs=1e-12)
    assert f"{rest.time:.12f}" == said("7.552399352768")
    assert f"{len(run.changes) - 1} landings" == said("194 landings")
    assert run.records["velocity"][-1] == pytest.approx([-7.5 / 7, 0.0, 0.0], abs=1e-12)


@pytest.mark.slow
def test_sliding_and_spinning_end_together(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "contensou_ball", "run.samples=4001")
    (event,) = run.changes
    assert f"{event.time:.10f}" == said("0.3581173642")
    exponent = examples["friction_figures"].final_exponent(run)
    assert exponent == pytest.approx(14 / 5 / 0.6**2, abs=1e-3)


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.1, 0.2, 0.4, 1.0])
def test_the_ball_leaves_the_dome(examples: dict[str, ModuleType], mu: float) -> None:
    """Against the equation of w = v²/(g (R + a)) by the angle, integrated by itself."""
    run = motion(examples, "ball_on_a_dome", f"contact.mu={mu}", "run.samples=3")
    slips, leaves = (e for e in run.changes if e.kind in ("slip", "lift-off"))
    angle = examples["friction_figures"].angle_on_dome
    begin = brentq(lambda a: 2 * math.sin(a) - mu * (17 * math.cos(a) - 10), 0.0, 0.94)
    assert angle(slips.before) == pytest.approx(math.degrees(begin), abs=1e-9)

    def away(theta: float, w: np.ndarray) -> float:
        return float(math.cos(theta) - w[0])

    away.terminal = True  # type: ignore[attr-defined]
    slid = solve_ivp(
        lambda theta, w: [2 * math.sin(theta) - 2 * mu * (math.cos(theta) - w[0])],
        (begin, 1.5),
        [10 / 7 * (1 - math.cos(begin))],
        events=away,
        method="DOP853",
        rtol=1e-12,
        atol=1e-13,
    )
    end = math.degrees(slid.t_events[0][0])
    assert angle(leaves.before) == pytest.approx(end, abs=1e-9)
    said(f"{end:.4f}")


@pytest.mark.slow
def test_the_ball_on_the_turntable_circles(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "ball_on_a_turntable", "run.samples=401")
    rate = examples["friction_figures"].circling_rate(run)
    assert rate == pytest.approx(2 / 7 * 3.0, rel=1e-12)
    assert f"{run.changes[0].time:.9f}" == said("0.190661591")


# --- Painlevé ------------------------------------------------------------------------------------


def test_the_spheroid_that_no_force_carries(examples: dict[str, ModuleType]) -> None:
    figures = examples["friction_figures"]
    assert f"{figures.margin(1.1621, -1):.5f}".replace("-", "−") == said("−1.50341")
    assert f"{figures.margin(1.1621, 1):.5f}" == said("4.89256")
    impulses, sliding, normal = figures.without_collision()
    assert f"{impulses[-1]:.6f}" == said("0.291539")
    assert np.diff(impulses).min() > 0
    assert (sliding[-1], normal[1]) == (0, normal.min())


@pytest.mark.slow
def test_the_impact_without_collision(examples: dict[str, ModuleType]) -> None:
    run = motion(examples, "painleve", "run.until=0.01", "run.samples=3")
    event = run.changes[0]
    assert (event.time, event.kind, event.mode) == (0.0, "impact without collision", "rolling")
    assert float(np.linalg.norm(event.impulse)) == pytest.approx(
        math.hypot(float(said("0.293518")), 0.291539), abs=1e-6
    )
    assert run.records["energy"][0] + event.after[16] == pytest.approx(
        0.5 + 9.81 * math.sqrt(math.sin(1.1621) ** 2 + 0.04 * math.cos(1.1621) ** 2), rel=1e-12
    )


# --- Euler's disk --------------------------------------------------------------------------------


def test_the_start_of_eulers_disk_is_a_steady_motion(examples: dict[str, ModuleType]) -> None:
    experiment = load_experiment(examples["eulers_disk"].FILE)
    gamma, omega = np.array(experiment.start.gamma), np.array(experiment.start.omega)
    assert omega[0] ** 2 == pytest.approx(4 * 9.81 * gamma[0] / 0.0375, rel=1e-12)
    assert np.count_nonzero(omega) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("index", "exponent", "end"),
    [(0, 2 / 3, "4.90472"), (1, 2.0, "5.00156"), (2, 1 / 3, "104.84489")],
)
def test_exponents_of_eulers_disk(
    examples: dict[str, ModuleType], index: int, exponent: float, end: str
) -> None:
    example = examples["eulers_disk"]
    laws = (
        example.ContourResistance(example.CONTOUR),
        example.RollingResistance(example.ROLLING),
        example.AirFilm(example.AIR, 0.0375),
    )
    found = example.decay("", laws[index], exponent, samples=800)
    assert found.exponent == pytest.approx(exponent, rel=4e-3)
    assert found.end == pytest.approx(found.theory, rel=2e-3 if index < 2 else 6e-3)
    assert found.end == pytest.approx(float(said(end)), rel=4e-5)


# --- a planted mistake ---------------------------------------------------------------------------


@pytest.mark.slow
def test_a_wrong_coefficient_is_seen(examples: dict[str, ModuleType]) -> None:
    """With a tenth less friction the billiard ball rolls at another time."""
    figures = examples["friction_figures"]
    run = motion(examples, "billiard_ball", "run.samples=11")
    weaker = motion(examples, "billiard_ball", "run.samples=11", "contact.mu=0.18")
    assert weaker.changes[0].time == pytest.approx(run.changes[0].time / 0.9, rel=1e-12)
    assert figures.parabola_error(run) < 1e-14
    situation = run.contact
    assert situation.law(Coulomb) == Coulomb(0.2)
    state = initial_state(
        situation,
        (-60, -20, 10),
        position=(0, 0, 0.0285),
        attitude=(1, 0, 0, 0),
        velocity=(1, 0, 0),
    )
    assert np.allclose(np.array(state[:16], dtype=float), run.states[0][:16], rtol=0, atol=1e-15)


# --- a disk on ice -------------------------------------------------------------------------------


def test_an_edge_that_holds_always_is_the_disk_on_ice_of_the_catalogue(
    examples: dict[str, ModuleType],
) -> None:
    found = examples["disk_on_ice"].motion(1e3, 2.0, 3)
    system = chaplygin.from_catalogue("disk-on-ice")
    ideal = chaplygin.integrate(system, examples["disk_on_ice"].START, [0.0, 1.0, 2.0])
    assert not found.changes
    for name in ("omega", "gamma"):
        np.testing.assert_allclose(found.samples[name], ideal[name], rtol=0, atol=1e-12)
    np.testing.assert_allclose(found.samples["edge_force"], ideal["edge_force"], atol=1e-11)


def test_a_slipping_edge_against_newton_and_euler_in_space(
    examples: dict[str, ModuleType],
) -> None:
    ice = examples["disk_on_ice"]
    body = {
        "mass": 1.0,
        "inertia": [0.25, 0.25, 0.5],
        "shape": {"kind": "disk", "radius": 1.0},
    }
    problem = Problem(body, {"kind": "plane"}, {"mu": 0.4}, 9.81)
    start = ice.start()
    q = np.array([1 + start["gamma"][2], start["gamma"][1], -start["gamma"][0], 0.0])
    q /= np.linalg.norm(q)
    turn = np.array(rotation(q.tolist()))
    height = float(np.hypot(*start["gamma"][:2]))
    momentum = turn @ (np.array(body["inertia"]) * start["omega"])
    first = np.array([0.0, 0.0, height, *q, *(turn @ start["v"]), *momentum])

    def side(y: np.ndarray) -> np.ndarray:
        axis = np.array(rotation(y[3:7].tolist()))[:, 2]
        along = np.cross([0.0, 0.0, 1.0], axis)
        return np.cross(along / np.linalg.norm(along), [0.0, 0.0, 1.0])

    def rate(t: float, y: np.ndarray) -> list[float]:
        return problem.rate(y.tolist(), Mode(), Direction(slip=side(y).tolist()))

    def slip(t: float, y: Any) -> float:
        y = np.asarray(y)
        there = problem.response(y.tolist(), Mode(), Direction(slip=side(y).tolist()))
        return float(side(y) @ there.slip) + (1.0 if t < 0.01 else 0.0)

    slip.terminal = True
    run = solve_ivp(rate, (0, 1), first, "DOP853", events=slip, rtol=1e-13, atol=1e-13)
    found = ice.motion(0.4, 1.0)
    assert [what for _, what in found.changes[:2]] == ["holds", "slips"]
    assert found.changes[0][0] == pytest.approx(run.t[-1], abs=1e-10)
    assert f"{found.changes[0][0]:.9f} s" in PAGE
    total = found.samples["total"]
    assert np.ptp(total) < 1e-12 * total[0]
