"""Experiment files with friction: what is read, the motion, and its dataset."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

import chaplygin as ch
from chaplygin.experiment import write_dataset
from chaplygin.experiment.contact.trajectory import ContactTrajectory
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.experiment.subjects.contact_subject import ContactSubject
from contact.case_files import CASES, experiment_text
from nonholonomic.contact.friction.dry_friction import ContensouErismann, Coulomb, SpinFriction
from nonholonomic.contact.friction.modes import MODE_NAMES
from nonholonomic.contact.friction.viscous_friction import Viscous

BALL = """\
[body]
mass = 1.0
inertia = [0.4, 0.4, 0.4]
[body.shape]
kind = "ball"
radius = 1.0
[contact]
model = "friction"
"""
BILLIARD = (
    BALL
    + """\
mu = 0.2
[start]
gamma = [0, 0, 1]
omega = [0, 0, 3]
slip = [2.0, 0, 0]
[run]
until = 0.5
samples = 26
"""
)


def study_of(text: str, *options: str) -> Study:
    return ch.Study.from_experiment(ch.parse_experiment(text, overrides=options))


def subject_of(text: str) -> ContactSubject:
    subject = study_of(text).subject
    assert isinstance(subject, ContactSubject)
    return subject


def run(text: str, *options: str) -> tuple[ContactTrajectory, xr.Dataset]:
    study = study_of(text, *options)
    trajectory = study.trajectory()
    assert isinstance(trajectory, ContactTrajectory)
    return trajectory, dataset_of(study, trajectory)


@pytest.fixture(scope="module")
def billiard() -> tuple[ContactTrajectory, xr.Dataset]:
    return run(BILLIARD)


@pytest.mark.parametrize(
    ("keys", "laws"),
    [
        ("", ()),
        ("mu = 0", ()),
        ("mu = 0.3", (Coulomb(0.3),)),
        ("mu = inf", (Coulomb(np.inf),)),
        ('mu = "inf"', (Coulomb(np.inf),)),
        ("mu = 0.3\npatch = 0.01", (ContensouErismann(0.3, 0.01),)),
        ("mu = 0.3\nspin_arm = 0.01", (Coulomb(0.3), SpinFriction(0.01))),
        ("spin_viscous = 2.0", (Viscous(0.0, 2.0),)),
    ],
)
def test_keys_are_laws(keys: str, laws: tuple[Any, ...]) -> None:
    text = f"{BALL}{keys}\n[start]\ngamma = [0, 0, 1]\nomega = [0, 0, 1]\n"
    assert subject_of(text).contact.laws == laws


def test_surface_and_rules_are_read() -> None:
    subject = subject_of(
        BILLIARD.replace("mu = 0.2", 'mu = 0.2\nrestitution = 0.5\nimpact_law = "newton"')
        + 'on_liftoff = "stop"\n[surface]\nkind = "sphere"\nradius = 3.0\nside = "inside"\n'
        "turntable = 2.0\n"
    )
    assert subject.contact.surface == ch.Sphere(3.0, "inside", 2.0)
    rules = subject.rules
    assert (rules.restitution, rules.impact_law) == (0.5, "newton")
    assert (rules.on_liftoff, rules.on_paradox) == ("stop", "stop")


@pytest.mark.parametrize("text", [BILLIARD, experiment_text(CASES["ball on a turntable"])])
def test_a_complete_file_reads_back(text: str) -> None:
    experiment = ch.parse_experiment(text)
    assert ch.parse_experiment(experiment.toml()) == experiment
    study = ch.Study.from_experiment(experiment)
    again = study_of(study.complete_toml())
    np.testing.assert_array_equal(again.start, study.start)


def test_an_unlimited_coefficient_reads_back() -> None:
    experiment = ch.parse_experiment(BILLIARD, overrides=["contact.mu=inf", "start.slip=[0, 0, 0]"])
    assert ch.parse_experiment(experiment.toml()) == experiment


def test_a_billiard_ball_rolls_when_it_must(
    billiard: tuple[ContactTrajectory, xr.Dataset],
) -> None:
    """Sliding ends at 2|u|/(7μg), and the direction of the slip does not change."""
    trajectory, dataset = billiard
    assert [event.kind for event in trajectory.changes] == ["stick"]
    moment = 2 * 2.0 / (7 * 0.2 * 9.81)
    assert abs(float(dataset["event_time"][0]) - moment) < 1e-14
    slides = dataset["time"].values < moment
    speed = np.where(slides, 2.0 - 3.5 * 0.2 * 9.81 * dataset["time"].values, 0.0)
    np.testing.assert_allclose(np.linalg.norm(dataset["slip"], axis=1), speed, atol=1e-13)
    np.testing.assert_array_equal(
        np.array(MODE_NAMES)[dataset["mode"]], np.where(slides, "sliding", "rolling")
    )


def test_the_work_is_what_the_energy_lacks(
    billiard: tuple[ContactTrajectory, xr.Dataset],
) -> None:
    _, dataset = billiard
    work = dataset["work_coulomb"].values
    assert work[-1] == pytest.approx(dataset["energy"].values[0] - dataset["energy"].values[-1])
    np.testing.assert_allclose(dataset["law_energy_balance"], dataset["energy"] + work, rtol=1e-15)
    assert dataset.attrs["energy_balance_drift"] < 1e-14
    # ½ (2/7) m u² is lost
    assert work[-1] == pytest.approx(2.0**2 / 7, rel=1e-14)


NAMES = """
omega gamma centre contact attitude velocity slip spin normal_force friction_force friction_couple
power_lost gap energy mode law_energy_balance work_impact work_coulomb event_time event_kind
event_mode event_state_before event_state_after event_impulse event_couple_impulse event_unique
"""


def test_the_dataset_has_the_names_that_are_documented(
    billiard: tuple[ContactTrajectory, xr.Dataset],
) -> None:
    _, dataset = billiard
    assert set(map(str, dataset.data_vars)) == set(NAMES.split())
    for name, item in dataset.variables.items():
        assert item.attrs.keys() >= {"long_name", "units", "source"}, name
    page = (Path(__file__).parents[4] / "packages/chaplygin/docs/experiment-file.md").read_text()
    assert all(f"`{name}`" in page for name in NAMES.split() if name != "work_coulomb")


def test_the_mode_is_a_flag_by_the_conventions(
    billiard: tuple[ContactTrajectory, xr.Dataset],
) -> None:
    for name in ("mode", "event_mode"):
        item = billiard[1][name]
        meanings = item.attrs["flag_meanings"].split()
        assert item.dtype == np.int8 == item.attrs["flag_values"].dtype
        assert meanings == [mode.replace(" ", "_") for mode in MODE_NAMES]
        assert len(item.attrs["flag_values"]) == len(meanings)


def test_states_at_an_event_join_the_motion(
    billiard: tuple[ContactTrajectory, xr.Dataset],
) -> None:
    trajectory, dataset = billiard
    columns = list(dataset["state"].values)
    assert columns == [str(symbol) for symbol in trajectory.system.symbols]
    after = dataset["event_state_after"].sel(state=["omega_1", "omega_2", "omega_3"])[0]
    np.testing.assert_allclose(after, dataset["omega"][-1], atol=1e-13)


@pytest.mark.parametrize("ending", ["nc", "zarr"])
def test_what_is_written_is_read(
    billiard: tuple[ContactTrajectory, xr.Dataset], tmp_path: Path, ending: str
) -> None:
    _, dataset = billiard
    read = ch.open_dataset(write_dataset(dataset, tmp_path / f"a.{ending}"))
    for name in dataset.variables:
        np.testing.assert_array_equal(read[name], dataset[name])
    assert read["mode"].dtype == np.int8
    assert read.attrs["events"] == dataset.attrs["events"]
    done = billiard[0].statistics
    words = f"Taylor series, pieces joined by events, of order {done.order}, {done.steps} steps"
    assert read.attrs["integrator"] == words


def test_a_motion_without_events_is_written(
    billiard: tuple[ContactTrajectory, xr.Dataset], tmp_path: Path
) -> None:
    still = replace(billiard[0], changes=())
    dataset = still.to_dataset()
    assert dataset.sizes["event"] == 0
    for ending in ("nc", "zarr"):
        assert ch.open_dataset(write_dataset(dataset, tmp_path / f"a.{ending}")).sizes["event"] == 0


def test_the_dataset_of_a_motion_is_that_of_its_run(
    billiard: tuple[ContactTrajectory, xr.Dataset],
) -> None:
    trajectory, written = billiard
    again = trajectory.to_dataset(
        {name: written.attrs[name] for name in ("experiment", "complete")}
    )
    xr.testing.assert_identical(again, written)


def test_a_table_has_the_samples_alone(
    billiard: tuple[ContactTrajectory, xr.Dataset], tmp_path: Path
) -> None:
    text = write_dataset(billiard[1], tmp_path / "a.csv").read_text()
    rows = [line for line in text.splitlines() if not line.startswith("#")]
    assert len(rows) == 1 + 26
    assert "mode" in rows[0].split(",")
    assert "event" not in rows[0]


def test_thinning_keeps_the_modes(billiard: tuple[ContactTrajectory, xr.Dataset]) -> None:
    trajectory, _ = billiard
    thin = trajectory.subsample(5)
    np.testing.assert_array_equal(thin.times, trajectory.times[::5])
    np.testing.assert_array_equal(thin.modes, trajectory.modes[::5])
    assert thin.changes == trajectory.changes


@pytest.mark.slow
def test_a_run_that_stops_at_lift_off_says_so() -> None:
    case = CASES["ball leaves a dome"]
    trajectory, dataset = run(experiment_text(case), "run.on_liftoff=stop")
    assert [event.kind for event in trajectory.changes] == [e["kind"] for e in case["events"]][:2]
    assert trajectory.reason == dataset.attrs["end_reason"] != ""
    assert trajectory.times[-1] == trajectory.changes[-1].time == dataset.attrs["end_time"]
    assert trajectory.times[-1] == pytest.approx(case["events"][1]["time"], abs=1e-10)
    assert "the run ends there" in dataset.attrs["events"]


def test_a_body_that_touches_and_moves_down_begins_with_an_impact() -> None:
    text = BALL + (
        "mu = 0.2\nrestitution = 0.5\n[start]\nposition = [0, 0, 1]\nattitude = [2, 0, 0, 0]\n"
        "velocity = [0, 0, -3]\nomega = [0, 0, 0]\n[run]\nuntil = 0.1\nsamples = 3\n"
    )
    study = study_of(text)
    assert study.remarks[0].startswith("start.attitude has length 2; it was normalised")
    assert "moves into it with 3 m/s; the motion begins with an impact" in study.remarks[1]
    dataset = dataset_of(study, study.trajectory())
    assert list(dataset["event_kind"].values) == ["landing"]
    np.testing.assert_allclose(dataset["event_impulse"][0], [0, 0, 4.5], atol=1e-14)
    assert dataset["velocity"][0, 2] == pytest.approx(1.5, abs=1e-14)
    assert dataset["work_impact"][-1] == pytest.approx(4.5 - 1.125, abs=1e-13)


def test_a_start_without_a_motion_is_refused_with_advice() -> None:
    """Painlevé's paradox: a slender spheroid whose tip is pushed along the ground."""
    case = """\
[body]
mass = 1.0
inertia = [5.2, 5.2, 0.4]
[body.shape]
kind = "ellipsoid"
axes = [1.0, 1.0, 5.0]
[contact]
model = "friction"
mu = 1.9
[start]
gamma = [0, 0.3967532, 0.9179257]
omega = [0, 0, 0]
slip = [0, 0.9179257, -0.3967532]
[run]
until = 1.0
"""
    study = study_of(case)
    with pytest.raises(ch.InputError, match=r'Painlevé.* on_paradox = "impact"') as error:
        study.trajectory()
    # time, place and the determinant, by the formula of a point that slides
    gamma = np.array([0, 0.3967532, 0.9179257])
    arm = -np.array([1, 1, 25]) * gamma / np.sqrt(np.array([1, 1, 25]) @ gamma**2)
    turn = np.diag([1 / 5.2, 1 / 5.2, 1 / 0.4])
    force = gamma - 1.9 * np.array([0, gamma[2], -gamma[1]])
    determinant = gamma @ (force + np.cross(turn @ np.cross(arm, force), arm))
    assert determinant < 0
    assert (
        "no motion in contact is possible at t = 0 s with the contact at (0, 0, 0) m (Painlevé's "
        "paradox: the normal acceleration of the contact for each unit of normal force, "
        f"B = {determinant:.6g} /kg, is not positive, so that"
    ) in str(error.value)


#: Cases that are quick to compile.
QUICK = ("billiard ball", "loaded ball, viscous")


@pytest.mark.parametrize(
    "name",
    [
        *QUICK,
        *(pytest.param(name, marks=pytest.mark.slow) for name in CASES if name not in QUICK),
    ],
)
def test_a_reference_case_from_its_file(name: str) -> None:
    case = CASES[name]
    _, dataset = run(experiment_text(case))
    last, final = dataset.isel(time=-1), case["final"]
    np.testing.assert_allclose(last["centre"], final["position"], rtol=0, atol=1e-9)
    np.testing.assert_allclose(last["velocity"], final["velocity"], rtol=0, atol=1e-9)
    np.testing.assert_allclose(last["omega"], final["omega"], rtol=0, atol=1e-9)
    attitude = last["attitude"].values
    sign = np.sign(attitude @ np.array(final["attitude"]))
    np.testing.assert_allclose(sign * attitude, final["attitude"], rtol=0, atol=1e-9)
    # the reference does not record a spin that passes through zero
    kept = dataset["event_kind"].values != "spin reversal"
    assert list(dataset["event_kind"].values[kept]) == [e["kind"] for e in case["events"]]
    times = [event["time"] for event in case["events"]]
    np.testing.assert_allclose(dataset["event_time"].values[kept], times, rtol=0, atol=1e-10)
    assert dataset.attrs["energy_balance_drift"] < 1e-12


#: An ellipsoid that bounces to rest against a bowl; a bounce of some 1e-5 m was missed.
BOUNCES = """\
[body]
mass = 0.65
inertia = [[0.2036, 0.0003, -0.0134], [0.0003, 0.2099, -0.0091], [-0.0134, -0.0091, 0.1989]]
[body.shape]
kind = "ellipsoid"
axes = [0.763, 0.988, 0.826]
turn = -0.859
centre = [0.018, -0.158, -0.182]
[surface]
kind = "sphere"
radius = 5.0
side = "inside"
turntable = -0.377
[contact]
model = "friction"
mu = 0.231
restitution = 0.6
impact_law = "poisson"
[field]
gravity = 9.81
[start]
position = [-0.30930257632025, 0.7881017999501824, -3.80286329063733]
attitude = [-0.2492311072004005, -0.5592814095026052, 0.7732118650005599, 0.16501991398251775]
velocity = [-1.8829738568847558, -1.8973484881819649, -0.4319208956592711]
omega = [-0.658, -0.615, 0.771]
[run]
until = 1.0
samples = 41
"""


@pytest.mark.slow
def test_no_bounce_is_missed() -> None:
    motion = ch.Study.from_experiment(ch.parse_experiment(BOUNCES, "f.toml")).trajectory()
    assert motion.records["gap"].min() > -1e-12
    assert len(motion.changes) > 15


#: A disk too fast to be held at first, under friction without bound.
THROWN = """\
[body]
mass = 1.845
inertia = [[0.2462, 0.0072, -0.0235], [0.0072, 0.3135, 0.0725], [-0.0235, 0.0725, 0.3026]]
[body.shape]
kind = "disk"
radius = 1.0
centre = [-0.079, -0.192, 0.137]
[surface]
kind = "plane"
turntable = 0.542
[contact]
model = "friction"
restitution = 0.3
mu = inf
[field]
gravity = 1.0
[start]
gamma = [1.548, 0.175, -0.538]
omega = [3.008, -4.013, -4.262]
[run]
until = 0.5
samples = 41
on_liftoff = "fly"
"""


@pytest.mark.slow
def test_friction_without_bound_lets_a_body_leave() -> None:
    motion = ch.Study.from_experiment(ch.parse_experiment(THROWN, "f.toml")).trajectory()
    first = motion.changes[0]
    assert (first.kind, first.time) == ("lift-off", 0.0)
    assert motion.drift < 1e-12
