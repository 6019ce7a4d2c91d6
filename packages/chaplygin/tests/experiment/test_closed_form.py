"""A study in closed form: what it records, what the report and the figure say of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp
from flint import arb

from chaplygin import solve
from chaplygin.experiment.closed_form import (
    ball,
    closed_form_section,
    closed_form_trajectory,
    dataset,
    diagram_if_known,
    equation,
    known_solution,
    letters,
    number,
    solution_of_study,
    units,
)
from chaplygin.experiment.dataset import open_dataset, write_dataset
from chaplygin.experiment.models.experiment import parse_experiment
from chaplygin.experiment.study import Study
from chaplygin.report.figures import closed_form, svg_text
from chaplygin.report.study_output import write_study
from flowlanes.errors import InputError
from flowlanes.system.system import System
from nonholonomic.closed_form.base.problem import Problem
from nonholonomic.closed_form.base.solution import ClosedForm, NamedConstant, Solution

FORM = ClosedForm(
    title="A turning ball",
    motion="periodic",
    equations=((sp.Symbol("y") ** 2, sp.Symbol("z") - 1),),
    constants=(
        NamedConstant("e_1", arb(1), "root of the curve"),
        NamedConstant("e_2", arb(2, 1e-20), "root of the curve"),
        NamedConstant("Omega_1", arb(0.25), "frequency of z_1", "1/s"),
        NamedConstant("V_1/V_2", arb(1) / 3, "rotation number"),
    ),
    ovals=((1.0, 2.0),),
    source="§7",
)


@dataclass(frozen=True)
class Spinning(Solution):
    """A ball that spins about the vertical on the spot, body axis 3 upward."""

    system: System
    parameters: Mapping[sp.Symbol, Any]
    momentum: float
    rate: float

    @property
    def form(self) -> ClosedForm:
        return FORM

    @property
    def phase_rate(self) -> float:
        return self.rate

    def states(self, times: Any) -> Any:
        half = self.rate * np.asarray(times) / 2
        rest = np.zeros_like(half)
        up = np.ones_like(half)
        momentum = (rest, rest, self.momentum * up)
        return np.array(
            [*momentum, rest, rest, up, np.cos(half), rest, rest, np.sin(half), rest, rest]
        ).T

    def rigorous(self, time: Any, digits: int = 30) -> tuple[Any, ...]:
        return tuple(arb(float(x)) for x in self.states([float(time)])[0])


def spinning() -> tuple[Study, Solution]:
    study = Study.from_experiment(
        parse_experiment(
            '[system]\nname = "chaplygin-ball"\n[start]\nomega = [0, 0, 1.1]\ngamma = [0, 0, 1]\n'
            "[run]\nuntil = 20.0\nsamples = 9\n"
        )
    )
    system = study.system.lifted()
    return study, Spinning(system, system.defaults, 2.1 * 1.1, 1.1)


def test_what_is_recorded_is_what_a_run_records() -> None:
    study, solution = spinning()
    run, found = study.trajectory(), closed_form_trajectory(study, solution, study.times)
    assert list(found.records) == list(run.records)
    for name, values in run.records.items():
        assert found.records[name].shape == values.shape
        assert np.abs(found.records[name] - values).max() < 1e-12
    made = dataset(study, found, solution)
    assert set(made.data_vars) == set(dataset(study, run, solution).data_vars)
    assert "M_3 = 2.31" in made.attrs["start"]
    assert made.attrs["motion"] == "periodic"
    assert units(study, solution)[sp.Symbol("place_x", real=True)] == "m"


def test_a_file_says_that_a_closed_form_is_no_integration(tmp_path: Path) -> None:
    study, solution = spinning()
    made = dataset(study, closed_form_trajectory(study, solution, study.times), solution)
    assert open_dataset(write_dataset(made, tmp_path / "a.nc")).attrs["integrator"] == (
        "none: closed form, A turning ball"
    )


def test_the_start_is_recorded_whatever_the_times() -> None:
    study, solution = spinning()
    made = dataset(study, closed_form_trajectory(study, solution, [7.0, 8.0]), solution)
    assert "attitude_w = 1.0" in made.attrs["start"]


def test_numbers_with_error_bars() -> None:
    assert ball(arb(1) / 4, 15) == ("0.250000000000000", "0")
    assert ball(arb(0, 1e-20), 15)[0] == "0"
    assert number(FORM.constants[1]).startswith("2.0000000000000")
    assert number(FORM.constants[2]) == "0.25000000000000000000 1/s"
    value, radius = ball(arb(2).sqrt(), 10)
    assert arb(value, radius).contains(arb(2).sqrt())


def test_letters_and_equations() -> None:
    assert letters("turns of z_1 per unit of tau") == "turns of z₁ per unit of τ"
    assert letters("mean dt/dtau") == "mean dt/dτ"
    assert letters("<phi'>") == "<φ'>"
    assert letters("theta_min") == "θₘᵢₙ"
    dtau, dz = sp.symbols("dtau dz_1")
    angle = sp.Function("varphi")(sp.Symbol("t"))
    assert equation(angle, dtau).startswith(r"\varphi\left(t\right) = ")
    assert equation(dz, dtau) == r"\mathrm{d}z_{1} = \mathrm{d}\tau"
    # a differential stands last: z₁ dz₁ / y₁
    z, y = sp.symbols("z_1 y_1")
    assert equation(z * dz / y, 0).startswith(r"\frac{z_{1} \, \mathrm{d}z_{1}}{y_{1}}")


def test_the_section() -> None:
    study, solution = spinning()
    made = closed_form_section(solution, study.trajectory())
    plain = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")
    assert float(made.difference.replace(" × 10", "e").translate(plain)) < 1e-12
    assert made.ovals == ("[1, 2]",)
    assert [meaning for _, _, meaning in made.rows][2] == "frequency of z₁"
    assert made.rows[3][0] == "V₁/V₂"


@pytest.mark.parametrize(
    "figures", [FORM.constants, (*FORM.constants, NamedConstant("Omega_2", arb(-0.6), "frequency"))]
)
def test_the_figure(figures: tuple[NamedConstant, ...]) -> None:
    form = ClosedForm("t", "m", (), figures, FORM.ovals)
    drawn = closed_form("A turning ball", form)
    assert len(drawn.axes) == (2 if len(figures) > 4 else 1)
    assert "The curve of the closed form: A turning ball" in svg_text(drawn)


def test_a_motion_of_one_variable_can_be_drawn() -> None:
    form = ClosedForm("t", "m", (), (), ((0.2, 0.7),))
    assert closed_form("x", form).axes[0].get_xlabel() == "$u$"


def test_a_motion_without_ovals_has_no_figure() -> None:
    with pytest.raises(InputError, match="no curve to draw of this motion: uniform rotation"):
        closed_form("x", ClosedForm("t", "uniform rotation", (), ()))


@pytest.mark.slow
def test_the_report_has_the_section(tmp_path: Path) -> None:
    study = Study.from_experiment(
        parse_experiment('[system]\nname = "neumann"\n[run]\nuntil = 5.0\nsamples = 11\n')
    )
    (tmp_path / "figures").mkdir()
    write_study(study, tmp_path, force=False, total_budget=0)
    page = (tmp_path / "report.html").read_text()
    assert '<h2 id="closed-form">Closed form</h2>' in page
    assert "two-frequency motion on a torus" in page
    assert (tmp_path / "figures" / "closed_form.png").exists()


@pytest.mark.slow
def test_no_closed_form_no_section() -> None:
    study = Study.from_experiment(parse_experiment('[system]\nname = "unbalanced-ball"\n'))
    assert known_solution(study) is None


@pytest.mark.slow
def test_a_study_is_solved_as_its_system_is() -> None:
    study = Study.from_experiment(parse_experiment('[system]\nname = "neumann"\n'))
    solution = solution_of_study(study)
    direct = solve(study.system, study.start)
    assert solution.states([3.0]).tolist() == direct.states([3.0]).tolist()


@pytest.mark.slow
def test_the_diagram_of_a_ball_and_none_of_a_symmetric_one():
    ball_ = Study.from_experiment(parse_experiment('[system]\nname = "chaplygin-ball"\n'))
    placed = diagram_if_known(ball_)
    assert placed is not None
    diagram, (h, g) = placed
    energy, area = (law.value for law in ball_.system.integrals[:2])
    assert (h, g) == pytest.approx([float(x) for x in values(ball_, energy, area)], rel=1e-12)
    assert diagram.region(h, g).tori == 2
    symmetric = Study.from_experiment(
        parse_experiment(
            '[system]\nname = "chaplygin-ball"\n[system.parameters]\nI_1 = 1.5\nI_2 = 1.5\n'
        )
    )
    assert diagram_if_known(symmetric) is None


def values(study, *formulas):
    return Problem(study.system, study.system.defaults, study.start).values(formulas)
