"""Ensembles and charts of motions with friction."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

import chaplygin as ch
from chaplygin.experiment.friction_studies.chart import contact_chart, contact_chart_task
from chaplygin.experiment.friction_studies.ensemble import contact_ensemble_task
from chaplygin.experiment.friction_studies.event_numbers import motion_number
from chaplygin.experiment.friction_studies.file_numbers import FileNumbers
from chaplygin.experiment.friction_studies.random_starts import random_numbers
from chaplygin.experiment.study import Study
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.computation import compute
from flowlanes.flow.ensembles.members import from_lists, grid
from flowlanes.scans.grid import NO_NUMBER, NO_STATE, axis

#: A billiard ball that slides at first: it rolls from 2u/(7μg) on.
BILLIARD = """
[body]
mass = 0.2
inertia = [2.0e-4, 2.0e-4, 2.0e-4]
shape = {kind = "ball", radius = 0.05}
[contact]
model = "friction"
mu = 0.2
restitution = 0.5
[field]
gravity = 9.81
[start]
gamma = [0.0, 0.0, 1.0]
omega = [0.0, 0.0, 0.0]
slip = [1.4, 0.0, 0.0]
[run]
until = 1.0
samples = 11
"""


def sticking(slip: float, mu: float) -> float:
    """The time at which a billiard ball begins to roll."""
    return 2 * slip / (7 * mu * 9.81)


@pytest.fixture(scope="module")
def billiard() -> Study:
    return ch.Study.from_experiment(ch.parse_experiment(BILLIARD))


def test_an_ensemble_over_coefficients_and_starts(billiard: Study) -> None:
    members = from_lists(slip_1=[1.0, 2.0]) * grid(mu=[0.2, 0.3, 0.4])
    data = compute(contact_ensemble_task(billiard, members, record=["energy", "slip"]))
    assert data.sizes["run"] == 6
    expected = [sticking(u, mu) for u in (1.0, 2.0) for mu in (0.2, 0.3, 0.4)]
    np.testing.assert_allclose(data.first_stick, expected, rtol=1e-11)
    # 2/7 of the energy of slip is lost
    np.testing.assert_allclose(data.energy_lost[:3], 0.1 * 2 / 7, rtol=1e-11)
    assert list(data.events) == [1] * 6
    assert list(data.outcome) == [0] * 6
    meanings = data.final_mode.attrs["flag_meanings"].split()
    assert {meanings[int(code)] for code in data.final_mode} == {"rolling"}
    np.testing.assert_allclose(data.velocity[0, -1, 0], 5 / 7, rtol=1e-11)
    assert data.mode.dims == ("run", "time")
    assert data.mu.values.tolist() == [0.2, 0.3, 0.4] * 2


def test_blocks_do_not_matter(billiard: Study) -> None:
    """Members computed one by one, or in parts as for a cluster, are the same to the bit."""
    members = random_numbers(3, {"slip_1": (0.5, 2.0), "mu": (0.1, 0.4)}, seed=3)
    whole = contact_ensemble_task(billiard, members)
    single = replace(whole, block=1)
    assert compute(whole).equals(compute(single))
    part = whole.work.part(2, 3)(2, 3)  # type: ignore[attr-defined]
    np.testing.assert_array_equal(part["omega"], compute(whole).omega[2:])


def test_a_motion_of_an_ensemble_is_that_of_a_run(billiard: Study) -> None:
    alone = ch.Study.from_experiment(
        ch.parse_experiment(BILLIARD, overrides=["contact.mu=0.35", "run.tolerance=1e-13"])
    )
    data = compute(contact_ensemble_task(billiard, grid(mu=[0.35])))
    trajectory = alone.trajectory()
    np.testing.assert_array_equal(data.omega[0], trajectory["omega"])
    np.testing.assert_array_equal(data.mode[0], trajectory.modes)  # type: ignore[attr-defined]


def test_members_that_cannot_start_are_told_from_the_others(billiard: Study) -> None:
    fall = ch.Study.from_experiment(
        ch.parse_experiment(
            BILLIARD.replace("gamma = [0.0, 0.0, 1.0]", "attitude = [1, 0, 0, 0]").replace(
                "slip = [1.4, 0.0, 0.0]", "position = [0, 0, 1]\nvelocity = [0, 0, 0]"
            )
        )
    )
    data = compute(contact_ensemble_task(fall, grid(position_3=[0.01, 0.25])))
    assert data.outcome.values.tolist() == [NO_STATE, 0]
    assert np.isnan(data.energy_lost[0])
    assert data.mode.values[0].tolist() == [-1] * 11
    flags = data.outcome.attrs["flag_values"]
    assert data.outcome.attrs["reasons"][flags.index(NO_STATE)] == "the start cannot be used"
    assert data.lowest_gap[1] >= -1e-14


def test_random_numbers() -> None:
    """Uniform, and each member the same however many there are."""
    members = random_numbers(4000, {"mu": (0.1, 0.5), "attitude": None}, seed=5)
    rows, _ = members.rows(0, 4000)
    few, _ = random_numbers(7, {"mu": (0.1, 0.5), "attitude": None}, seed=5).rows(0, 7)
    np.testing.assert_array_equal(few["attitude"], rows["attitude"][:7])
    assert rows["mu"].min() > 0.1 and rows["mu"].max() < 0.5
    assert rows["mu"].mean() == pytest.approx(0.3, abs=0.01)
    directions = rows["attitude"] / np.linalg.norm(rows["attitude"], axis=1)[:, None]
    np.testing.assert_allclose(directions.T @ directions / 4000, np.eye(4) / 4, atol=0.02)
    assert str(members) == "4,000 with mu from 0.1 to 0.5 and any attitude (seed 5)"


def test_a_chart_over_a_coefficient_and_a_start(billiard: Study) -> None:
    chart = contact_chart(
        billiard,
        "first:stick",
        axis("mu=0.05:0.4:3"),
        axis("u=0.7:1.4:2"),
        formulas={"slip_1": "0.6*u", "slip_2": "0.8*u"},
    )
    data = compute(contact_chart_task(chart, "billiard"))
    assert data["first"].dims == ("u", "mu")
    for u in (0.7, 1.4):
        for mu in (0.05, 0.225, 0.4):
            cell = data.sel(u=u, mu=mu, method="nearest")
            wanted = sticking(u, mu)
            if wanted < 1:
                assert float(cell["first"]) == pytest.approx(wanted, rel=1e-11)
            else:
                # it still slides at the end
                assert int(cell.outcome) == NO_NUMBER and np.isnan(cell["first"])
    assert data.mu.attrs["long_name"] == "contact.mu"


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("events", 1.0),
        ("count:stick", 1.0),
        ("count:spin-stop", 0.0),
        ("duration", 1.0),
        ("final:velocity_1", 1.0),
        ("lowest:power_lost", 0.0),
        ("highest:velocity_1**2/2", 0.98),
        ("late_mean:velocity_1", 1.0),
    ],
)
def test_numbers_of_a_motion(billiard: Study, text: str, value: float) -> None:
    chart = contact_chart(billiard, text, axis("mu=0.2:0.2:1"), axis("mass=0.2:0.2:1"))
    data = compute(contact_chart_task(chart, "billiard"))
    assert float(data[chart.of.word].item()) == pytest.approx(value, abs=1e-12)


MISTAKES = {
    "mue": "mue: the experiment has no number of this name, did you mean 'mu'",
    "normal_1": "normal_1: the experiment has no number of this name",
    "model": "model: the experiment has no number of this name",
}


@pytest.mark.parametrize("name", MISTAKES)
def test_names_that_no_number_has(billiard: Study, name: str) -> None:
    with pytest.raises(InputError, match=re.escape(MISTAKES[name])):
        contact_ensemble_task(billiard, grid(**{name: [1.0, 2.0]}))


def test_other_mistakes(billiard: Study) -> None:
    dome = ch.parse_experiment(
        BILLIARD.replace("[field]", '[surface]\nkind = "sphere"\nradius = 2.0\n[field]')
    )
    numbers = FileNumbers(dome)
    with pytest.raises(InputError, match=r"write body\.shape\.radius or surface\.radius"):
        numbers.path("radius")
    assert numbers.value("surface.radius") == 2.0
    with pytest.raises(InputError, match="mass must be a positive finite number, not -1"):
        contact_ensemble_task(billiard, grid(mass=[-1.0, 1.0]))
    with pytest.raises(InputError, match="no spinn to be recorded"):
        contact_ensemble_task(billiard, grid(mu=[0.1]), record=["spinn"])
    with pytest.raises(InputError, match="mu: 2 to 1 is no range"):
        random_numbers(2, {"mu": (2.0, 1.0)})
    with pytest.raises(InputError, match="mu: it needs a range"):
        random_numbers(2, {"mu": None})
    system = billiard.system
    for text, sentence in {
        "sticks": "no number of a motion with friction has this name",
        "first": "first: this number is written first:EVENT",
        "first:stic": "no event is called stic, did you mean 'stick'",
        "events:x": "this number is written events",
        "mean": "written mean:FORMULA",
        "mean:gama_3": "unknown name 'gama_3', did you mean 'gamma_3'",
    }.items():
        with pytest.raises(InputError, match=sentence):
            motion_number(text, system)
    mu, mass = axis("mu=0.1:0.2:2"), axis("mass=1:2:2")
    with pytest.raises(InputError, match="two axes need names that differ"):
        contact_chart(billiard, "events", mu, mu)
    with pytest.raises(InputError, match="no number of this name, and no formula uses it"):
        contact_chart(billiard, "events", axis("mue=0:1:2"), mass)
    with pytest.raises(InputError, match="it is an axis and cannot be given by a formula"):
        contact_chart(billiard, "events", mu, mass, formulas={"mu": "0.1*mass"})
    rolling = ch.Study.from_experiment(ch.parse_experiment('system = {name = "veselova"}'))
    with pytest.raises(InputError, match="has no friction"):
        contact_ensemble_task(rolling, grid(mu=[0.1]))


@pytest.mark.campaign
@pytest.mark.parametrize("law", ["stronge", "poisson"])
def test_ten_thousand_bouncing_balls(law: str) -> None:
    """None hangs, falls through the ground, gains energy or ends without a reason."""
    study = ch.Study.from_experiment(
        ch.load_experiment("examples/bouncing_ball.toml", overrides=[f"contact.impact_law={law}"])
    )
    ranges: dict[str, tuple[float, float] | None] = {"attitude": None, "position_3": (1.4, 4.0)}
    ranges |= {f"velocity_{i}": (-4.0, 4.0) for i in (1, 2, 3)}
    ranges |= {f"omega_{i}": (-6.0, 6.0) for i in (1, 2, 3)}
    ranges |= {"restitution": (0.0, 0.9), "mu": (0.05, 0.8)}
    members = random_numbers(5000, ranges, seed=1)
    record = ["energy", "energy_balance", "gap"]
    data = compute(contact_ensemble_task(study, members, record=record, tolerance=1e-16))
    assert not data.outcome.any()
    size = data.energy[:, 0]
    assert float(data.lowest_gap.min()) >= -1e-12
    assert float((data.energy.diff("time") / size).max()) <= 1e-12
    balance = data.energy_balance
    assert float(((balance.max("time") - balance.min("time")) / size).max()) <= 1e-12


#: A ball with two laws of friction, and one with the second alone.
TWO_LAWS = BILLIARD.replace("mu = 0.2", "mu = 0.2\nviscous = 0.1")
ONE_LAW = BILLIARD.replace("mu = 0.2", "viscous = 0.1")


def test_a_coefficient_of_zero_is_no_law_and_its_work_is_zero() -> None:
    """The works stood in the columns of other laws, or there was no such column."""
    members = from_lists(mu=[0.2, 0.0])
    wanted = contact_ensemble_task(
        ch.Study.from_experiment(ch.parse_experiment(TWO_LAWS)),
        members,
        record=["energy", "energy_balance"],
    )
    data = compute(wanted)
    coulomb, viscous = data["work_coulomb"].values, data["work_viscous"].values
    assert coulomb[0, -1] > 0.01 and not coulomb[1].any()
    assert viscous[0, -1] > 1e-3 and viscous[1, -1] > 1e-2
    lost = data["energy"].values[:, 0] - data["energy"].values[:, -1]
    np.testing.assert_allclose(data["energy_lost"].values, lost, rtol=1e-12)
    assert np.ptp(data["energy_balance"].values, axis=1).max() < 1e-12


def test_a_law_that_the_file_lacks_counts_in_the_balance() -> None:
    """Its work was left out."""
    study = ch.Study.from_experiment(ch.parse_experiment(ONE_LAW))
    members = from_lists(mu=[0.0, 0.2])
    data = compute(contact_ensemble_task(study, members, record=["energy", "energy_balance"]))
    lost = data["energy"].values[:, 0] - data["energy"].values[:, -1]
    np.testing.assert_allclose(data["energy_lost"].values, lost, rtol=1e-12)
    assert lost[1] > lost[0] + 0.001
    assert np.ptp(data["energy_balance"].values, axis=1).max() < 1e-12


def test_a_chart_down_to_no_friction() -> None:
    """It ended in a traceback."""
    study = ch.Study.from_experiment(ch.parse_experiment(TWO_LAWS))
    chart = contact_chart(study, "mean:work_coulomb", axis("mu=0:0.2:2"), axis("mass=0.2:0.3:2"))
    data = compute(contact_chart_task(chart, "ball"))
    assert not data["mean"].values[:, 0].any()
    assert (data["mean"].values[:, 1] > 0.01).all()
