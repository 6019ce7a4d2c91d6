"""Charts of experiments: where the start comes from, what axes are called."""

from __future__ import annotations

import numpy as np
import pytest

from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.scan import chart_of, plane_of
from chaplygin.experiment.study import Study
from flowlanes.formulas.array_evaluation import values
from flowlanes.scans.grid import axis


def study(text: str) -> Study:
    """The study of an experiment."""
    return Study.from_experiment(parse_experiment(text, "test.toml"))


def test_a_rolling_body_starts_by_its_angular_velocity() -> None:
    made = plane_of(
        study('[system]\nname = "chaplygin-ball"\n'), axis("I_3=1.8:2.4:3"), axis("omega_2=-1:1:3")
    )
    assert (made.x.meaning, made.x.unit) == ("moment of inertia about body axis 3", "kg m^2")
    assert (made.y.meaning, made.y.unit) == ("angular velocity, component 2", "rad/s")
    cells = made.cells(0, 3)
    omega = values(made.system, ["omega_1", "omega_2"], cells.starts, cells.parameters)
    assert np.ptp(omega[:, 0]) < 1e-15
    assert np.abs(omega[:, 1] - np.repeat([-1.0, 0.0, 1.0], 3)).max() < 1e-15
    assert made.system.reconstruction is None


def test_other_systems_start_by_their_state() -> None:
    made = plane_of(study('[system]\nname = "neumann"\n'), axis("M_1=0:1:2"), axis("c=1:2:2"))
    assert made.original_system is made.system
    assert not made.cells(0, 2).reasons.any()


@pytest.mark.parametrize("given", ["", "[start]\nfluid = [0.5, 0.0, 1.0]\n"])
def test_the_motion_of_a_fluid_is_an_axis(given: str) -> None:
    """The state with ω and γ did not have it, and every chart of a body with fluid failed."""
    cavity = "[body.cavity]\naxes = [0.9, 0.7, 0.35]\nmass = 1.8\n"
    text = f'[system]\nname = "veselova"\n{cavity}{given}'
    made = plane_of(study(text), axis("fluid_1=-1:1:3"), axis("I_1=1:1.2:2"))
    cells = made.cells(0, 6)
    assert not cells.reasons.any()
    # what is read back from the circulation N is the axis
    xi = values(made.system, ["xi_1", "xi_3"], cells.starts, cells.parameters)
    assert np.abs(xi[:, 0] - np.tile([-1.0, 0.0, 1.0], 2)).max() < 1e-14
    assert np.abs(xi[:, 1] - (1.0 if given else 0.0)).max() < 1e-14


def test_a_contact_that_is_to_hold_has_no_guard() -> None:
    text = '[system]\nname = "heavy-disk"\n[run]\nuntil = 2.0\n'
    axes = axis("omega_1=0:9:2"), axis("m=1:2:2")
    held = study(f'{text}on_liftoff = "warn"\n')
    free, kept = (chart_of(s, "duration", *axes) for s in (study(text), held))
    assert any(guard.lift_off for guard in free.rule.system.guards)
    assert not any(guard.lift_off for guard in kept.rule.system.guards)
    assert free.rule.t_end == 2.0
    assert np.nanmin(free(0, 2)["duration"]) < np.nanmin(kept(0, 2)["duration"]) == 2.0
