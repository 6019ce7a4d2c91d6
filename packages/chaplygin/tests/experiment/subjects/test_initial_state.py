"""Starts by the names of the state: reading, refusing, running, recording, reporting."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import mpmath
import numpy as np
import pytest

from chaplygin.experiment.models.catalogue_models import StateExperiment
from chaplygin.experiment.models.experiment import catalogue_experiment, parse_experiment
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.experiment.subjects.initial_state import initial_state_from_values
from chaplygin.report.drawing.dataset_access import unit_of
from chaplygin.report.study_output import write_study
from flowlanes.errors import InputError
from flowlanes.system.system import Reconstruction, System
from flowlanes.system.vectors import Diagonal, dot
from named_states import ENTRIES, M, gamma, named_states
from nonholonomic.catalogue import Start
from nonholonomic.mechanics.rolling.attitude import (
    attitude,
    attitude_relations,
    quaternion_rate,
    unit_length,
)
from spread import spread

__all__ = ["named_states"]

pytestmark = pytest.mark.usefixtures("named_states")

SLEIGH, TOP = ENTRIES


def study(name: str, *overrides: str) -> Study:
    """A study of a system by name, with overrides."""
    return Study.from_experiment(
        parse_experiment(f'[system]\nname = "{name}"\n', "own.toml", overrides)
    )


def refused(name: str, *overrides: str) -> str:
    """What is said of a start that cannot be used."""
    with pytest.raises(InputError) as caught:
        _ = study(name, *overrides).start
    return str(caught.value)


def test_a_start_is_given_in_one_of_two_ways() -> None:
    for wrong in (
        {},
        {"omega": (0.0, 0.0, 1.0)},
        {"omega": (0.0, 0.0, 1.0), "gamma": (0.0, 0.0, 1.0), "state": {"u": 1.0}},
        {"gamma": (0.0, 0.0, 1.0), "state": {"u": 1.0}},
    ):
        with pytest.raises(InputError, match="either by both omega and gamma or by a state"):
            Start(until=1.0, **wrong)
    assert Start(until=1.0, state={"u": 2.0}).values == {"u": 2.0}


def test_a_name_is_enough_and_what_is_given_replaces_the_rest() -> None:
    made = study("trial-sleigh")
    assert [float(x) for x in made.start] == [-0.4, 1.5, 0.0, 0.0, 0.0]
    made = study("trial-sleigh", "start.u=0.25", "run.until=2")
    assert [float(x) for x in made.start] == [0.25, 1.5, 0.0, 0.0, 0.0]
    assert made.times[-1] == 2.0
    assert isinstance(catalogue_experiment("trial-top"), StateExperiment)


def test_the_complete_file_starts_the_same_motion() -> None:
    made = study("trial-top", "start.M=[1, 0, 2]")
    again = Study.from_experiment(parse_experiment(made.complete_toml()))
    assert again.start == made.start
    assert "M = [1.0, 0.0, 2.0]\ngamma = [0.0, 0.6, 0.8]" in made.complete_toml()


@pytest.mark.parametrize(
    ("name", "override", "said"),
    [
        ("trial-sleigh", "start.v=1", "--set start.v: unknown variable; allowed: u, omega"),
        ("trial-sleigh", "start.thet=1", "unknown variable, did you mean 'theta'?"),
        ("trial-sleigh", "start.u=[1, 2, 3]", "start.u: must be a finite number, not [1.0, 2.0"),
        ("trial-sleigh", "start.u=true", "start.u: must be a finite number, or finite numbers"),
        ("trial-sleigh", "start.u=inf", "start.u: must be a finite number, or finite numbers"),
        ("trial-top", "start.M=[1, 2]", "--set start.M: must be 3 finite numbers, not [1.0, 2.0]"),
        ("trial-top", "start.M=3", "--set start.M: must be 3 finite numbers, not 3.0"),
        ("trial-top", "start.gamma=[0, 0, 0]", "start.gamma: must not be zero"),
        ("trial-top", "start=4", "start: must be a table"),
        ("trial-top", "start.heading=1", "start.heading: unknown variable; allowed: M, gamma"),
    ],
)
def test_wrong_values_are_refused_in_one_sentence(name: str, override: str, said: str) -> None:
    message = refused(name, override)
    assert said in message
    assert "\n" not in message


def test_missing_variables_are_named() -> None:
    with pytest.raises(
        InputError, match=r"^start: theta, y missing; the state of trial-sleigh is "
    ):
        initial_state_from_values(SLEIGH.system(), {"u": 1.0, "omega": 0.0, "x": 0.0})


def test_unit_vectors_are_normalised_with_a_remark() -> None:
    made = study("trial-top", "start.gamma=[0, 3, 4]")
    assert [float(x) for x in made.start[3:]] == [0.0, 0.6, 0.8]
    assert made.remarks == (
        "start.gamma has length 5; it was normalised to [0, 0.59999999999999998, "
        "0.80000000000000004]",
    )
    assert study("trial-top").remarks == ()


def perpendicular() -> System:
    """The top on (M, γ) = 0, taken for a relation."""
    system = TOP.system()
    return replace(system, relations=(*system.relations, dot(M, gamma)))


def test_a_state_off_the_relations_is_refused_with_the_nearest_one() -> None:
    system = perpendicular()
    with pytest.raises(InputError) as caught:
        initial_state_from_values(system, {"M": (0.3, 0.1, 0.0), "gamma": (0.0, 0.6, 0.8)})
    said = str(caught.value)
    assert said.startswith("start: the relation (M, γ) = 0 is missed by 0.06; the nearest")
    values = said.partition("state is ")[2].replace("M = ", "").replace("gamma = ", "")
    nearest, direction = (
        [float(x) for x in part.strip("[], ").split(", ")] for part in values.split("], ")
    )
    assert np.dot(nearest, direction) == pytest.approx(0.0, abs=1e-15)
    assert np.abs(np.subtract(nearest, [0.3, 0.1, 0.0])).max() < 0.07
    accepted = initial_state_from_values(system, {"M": nearest, "gamma": direction})
    with mpmath.workdps(50):
        assert abs(sum(p * q for p, q in zip(accepted[:3], accepted[3:], strict=True))) < 1e-40


def test_the_lift_to_space_may_be_left_out() -> None:
    lift = Reconstruction(
        {attitude: quaternion_rate(Diagonal("A") * M)},
        (unit_length(), *attitude_relations(gamma)),
        (),
    )
    system = replace(TOP.system(), reconstruction=lift)
    for up in ((0.0, 0.6, 0.8), (0.0, 0.0, -1.0)):
        state = [
            float(v) for v in initial_state_from_values(system, {"M": (0.0, 0.1, 3.0), "gamma": up})
        ]
        w, x, y, z = state[6:]
        row = [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]
        assert row == pytest.approx(up, abs=1e-15)


def test_only_integrals_whose_level_holds_are_watched() -> None:
    turning, gliding = study("trial-sleigh"), study("trial-sleigh", "start.omega=0")
    assert [law.name for law in turning.system_on_level.laws] == ["energy"]
    assert [law.name for law in gliding.system_on_level.laws] == ["energy", "straight"]
    assert len(turning.system.laws) == 3


def test_the_sleigh_turns_until_it_glides_straight() -> None:
    made = study("trial-sleigh", "run.until=40")
    motion = made.trajectory()
    energy = 0.5 * 0.4**2 + 0.5 * 0.45 * 1.5**2
    assert motion["u"][-1] == pytest.approx(np.sqrt(2 * energy), rel=1e-12)
    assert motion["omega"][-1] == pytest.approx(0.0, abs=1e-9)


def test_datasets_tell_what_is_known_of_each_variable() -> None:
    made = study("trial-sleigh")
    data = dataset_of(made, made.trajectory())
    assert data["u"].dims == ("time",)
    assert data["u"].attrs["long_name"] == "velocity along the blade"
    assert data["u"].attrs["units"] == "m/s"
    assert data["theta"].attrs["long_name"] == "theta"
    assert data["theta"].attrs["units"] == "unknown"
    assert unit_of(data, "theta") == ""
    assert "source" in data["theta"].attrs
    made = study("trial-top")
    data = dataset_of(made, made.trajectory())
    assert data["M"].dims == ("time", "axis")
    assert data["M"].attrs["long_name"] == "angular momentum"
    assert Study.from_experiment(parse_experiment(data.attrs["experiment"])).start == made.start


@pytest.mark.slow
@pytest.mark.parametrize("name", spread(item.name for item in ENTRIES))
def test_the_report_shows_the_state_in_time_and_no_rolling_body(name: str, tmp_path: Path) -> None:
    made = study(name)
    (tmp_path / "figures").mkdir()
    write_study(made, tmp_path, force=True, total_budget=0)
    assert {path.stem for path in (tmp_path / "figures").iterdir()} == {"state", "drift"}
    page = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert 'id="state"' in page
    assert '<div class="chaplygin-still"></div>' in page
    assert "contact point" not in page
