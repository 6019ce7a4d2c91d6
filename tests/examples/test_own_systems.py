"""Every example that brings its own system: it runs, its laws are proven, its commands work."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

from chaplygin.cli import main
from chaplygin.experiment.dataset import open_dataset
from chaplygin.experiment.models.described_models import OwnExperiment
from chaplygin.experiment.models.experiment import load_experiment, parse_experiment
from chaplygin.experiment.python_file import load_python
from chaplygin.experiment.study import Study, dataset_of
from chaplygin.report.summary import drift
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue
from spread import spread

EXAMPLES = Path(__file__).parents[2] / "examples"
TABLES = ("[lagrangian]", "[equations]")
OWN = sorted(
    path
    for path in EXAMPLES.glob("*.toml")
    if any(table in path.read_text(encoding="utf-8") for table in TABLES)
)
BALL = EXAMPLES / "loaded_ball.py"


def study(path: Path, *overrides: str) -> Study:
    made = (
        load_python(path, overrides)
        if path.suffix == ".py"
        else Study.from_experiment(load_experiment(path, overrides))
    )
    assert isinstance(made.experiment, OwnExperiment)
    return made


def named(name: str, *overrides: str) -> Study:
    return study(EXAMPLES / f"{name}.toml", *overrides)


def test_there_are_examples() -> None:
    assert len(OWN) >= 8


@pytest.mark.slow
@pytest.mark.parametrize("path", [*OWN, BALL], ids=lambda path: path.stem)
def test_every_example_runs_and_its_laws_are_proven(path: Path) -> None:
    made = study(path, "run.samples=7")
    assert all(prove(made.system, law) for law in made.system.laws)
    assert made.system.title != "Untitled system"
    trajectory = made.trajectory()
    for law in trajectory.system.integrals:
        assert drift(trajectory.records[f"law_{law.name}"]) < 1e-11
    dataset = dataset_of(made, trajectory)
    assert all({"units", "long_name", "source"} <= set(v.attrs) for v in dataset.data_vars.values())
    again = Study.from_experiment(load_experiment(dataset.attrs["experiment"]))
    assert again.start == made.start


# --- what each of them shows -----------------------------------------------------------------


def test_the_sleigh_is_that_of_the_catalogue() -> None:
    made = named("sleigh", "run.until=5", "run.samples=11")
    sleigh = from_catalogue("chaplygin-sleigh-reduced")
    omega, spin = sp.Symbol("omega", real=True), sp.Symbol("Omega", real=True)
    table = dict(sleigh.scalar_definitions)
    expected = [rate.xreplace(table).xreplace({spin: omega}) for rate in sleigh.rates]
    given = [rate.xreplace(dict(made.system.scalar_definitions)) for rate in made.system.rates]
    assert all(sp.simplify(a - b) == 0 for a, b in zip(given, expected, strict=True))


def test_the_reaction_of_the_sleigh_is_recorded() -> None:
    dataset = dataset_of(made := named("sleigh", "run.samples=50"), made.trajectory())
    # what turns the velocity of the centre of mass sideways, m (u ω + a ω̇)
    m, a, inertia = 1.0, 0.3, 0.7
    u, omega = dataset["u"].values, dataset["omega"].values
    turning = -m * a * u * omega / (inertia + m * a**2)
    assert np.allclose(dataset["lambda_1"], m * (u * omega + a * turning), atol=1e-12)


def test_the_energy_of_the_turntable_is_seen_to_change() -> None:
    made = named("turntable", "run.samples=31")
    assert "energy" not in {law.name for law in made.system.laws}
    dataset = dataset_of(made, made.trajectory())
    around = np.stack([dataset["x"] - 0.3 + 1.05, dataset["y"] - 0.175])
    angle = np.unwrap(np.arctan2(around[1], around[0]))
    rate = 0.004 * 2.0 / (0.004 + 0.1**2)
    assert np.allclose(angle - angle[0], rate * dataset["time"], atol=1e-10)
    assert np.ptp(dataset["energy"].values) > 1.0
    assert "not conserved" in dataset["energy"].attrs["long_name"]
    slope = np.gradient(dataset["energy"].values, 0.5, edge_order=2)
    assert np.allclose(slope, dataset["power"], atol=0.05)


@pytest.mark.slow
def test_the_shaken_pendulum_stands_on_its_head() -> None:
    dataset = dataset_of(made := named("driven_pendulum", "run.samples=101"), made.trajectory())
    height = dataset["y"].values - 0.05 * np.sin(100.0 * dataset["time"].values)
    assert height.min() > 0.3

    def swinging(t: float, state: tuple[float, float]) -> tuple[float, float]:
        angle, rate = state
        return rate, (9.81 - 0.05 * 100.0**2 * np.sin(100.0 * t)) / 0.5 * np.sin(angle)

    times = dataset["time"].values
    options = {"t_eval": times, "rtol": 1e-11, "atol": 1e-12, "method": "DOP853"}
    start = (np.arctan2(0.14, 0.48), 0.0)
    alone = solve_ivp(swinging, (0.0, times[-1]), start, **options).y[0]
    assert np.allclose(dataset["x"], 0.5 * np.sin(alone), atol=1e-6)
    still = named("driven_pendulum", "parameters.A=0", "start.ydot=0", "run.samples=101")
    fallen = dataset_of(still, still.trajectory())["y"].values
    assert fallen.min() < -0.49


def test_the_falling_mass_keeps_its_ratio() -> None:
    dataset = dataset_of(made := named("appell_hamel", "run.samples=31"), made.trajectory())
    speed = np.hypot(dataset["xdot"], dataset["ydot"])
    assert np.allclose(dataset["zdot"], -0.7 * speed, atol=1e-9)
    # the weight M g k drives both masses along one path
    growth = 0.5 * 9.81 * 0.7 / (1.0 + 0.5 * 0.7**2)
    assert np.allclose(speed, 0.5 + growth * dataset["time"], atol=1e-9)
    assert "undecided: the constraint" in made.subject.derivation_notes[-1]


ROLLING = """\
[body]
mass = 1.0
inertia = [0.004, 0.005, 0.003]
[body.shape]
kind = "ball"
radius = 0.1
centre = [0.0, 0.0, 0.02]
[start]
gamma = [0.0, 0.6, 0.8]
omega = [1.0, 2.0, 20.0]
[run]
until = 1.0
samples = 11
"""


@pytest.mark.slow
def test_the_loaded_ball_moves_as_the_body_of_the_package() -> None:
    options = ("run.until=1", "run.samples=11", "parameters.I_2=0.005", "start.omega=[1, 2, 20]")
    mine, theirs = study(BALL, *options), Study.from_experiment(parse_experiment(ROLLING))
    one = dataset_of(mine, mine.trajectory())
    other = dataset_of(theirs, theirs.trajectory())
    assert "law_jellett" not in one
    for name in ("gamma", "omega"):
        assert np.allclose(one[name], other[name], rtol=0, atol=1e-11)


@pytest.mark.slow
def test_constraints_are_told_apart() -> None:
    assert "completely nonholonomic" in named("sleigh").subject.derivation_notes[-1]
    assert "completely nonholonomic" in named("trailer").subject.derivation_notes[-1]
    assert "span 2, 3, 4 dimensions" in named("trailer").subject.derivation_notes[-1]
    assert "1 of them is holonomic in effect" in study(BALL).subject.derivation_notes[-1]
    assert len(named("spherical_pendulum").subject.derivation_notes) == 1
    assert named("volterra").subject.derivation_notes == ()


# --- commands --------------------------------------------------------------------------------

Ask = Callable[..., tuple[int, str, str]]


@pytest.fixture
def ask(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> Ask:
    """Run a command in an empty folder; exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["chaplygin", *map(str, arguments)])
        with pytest.raises(SystemExit) as end:
            main()
        output = capsys.readouterr()
        return int(end.value.code or 0), output.out, output.err

    return run


@pytest.mark.slow
@pytest.mark.parametrize("path", spread([EXAMPLES / "sleigh.toml", BALL]), ids=["toml", "python"])
def test_every_command_takes_a_system_of_ones_own(ask: Ask, path: Path, tmp_path: Path) -> None:
    code, out, err = ask("show", path)
    assert (code, err) == (0, "")
    assert "Equations of motion" in out
    assert "Also recorded: λ₁ (multiplier of" in out
    assert "nonholonomic" in out
    assert max(map(len, out.splitlines())) <= 100
    assert "nonholonomic" in json.loads(ask("show", path, "--json")[1])["notes"][-1]
    for form, sign in (("latex", "aligned"), ("julia", "function"), ("c", "double")):
        assert sign in ask("show", path, "--as", form)[1]
    (tmp_path / "again.toml").write_text(ask("show", path, "--as", "toml")[1], encoding="utf-8")
    options = ("--set", "run.until=1", "--set", "run.samples=5")
    assert ask("run", path, "-o", "first.nc", *options)[0] == 0
    assert ask("run", "again.toml", "-o", "second.nc", *options)[0] == 0
    first, second = open_dataset("first.nc"), open_dataset("second.nc")
    assert list(first.data_vars) == list(second.data_vars)
    assert all(np.array_equal(first[name], second[name]) for name in first.data_vars)
    code, out, _ = ask("prove", path, "--json")
    assert code == 0
    assert {row["verdict"] for row in json.loads(out)} == {"proven"}
    code, out, _ = ask("find", "integrals", path, "--degree", "1", "--gamma-degree", "0")
    assert code in (0, 1)
    assert "First integrals of" in out
    assert ask("study", path, "-o", "whole", *options)[0] == 0
    page = (tmp_path / "whole" / "report.html").read_text(encoding="utf-8")
    assert page.count('<svg role="img"') == (8 if path.suffix == ".toml" else 6)
    assert "Other recorded quantities" in page
    assert "nonholonomic" in page


def test_mistakes_end_with_exit_code_two(ask: Ask) -> None:
    code, out, err = ask("run", EXAMPLES / "sleigh.toml", "-o", "x.nc", "--set", "start.v=1")
    assert (code, out) == (2, "")
    assert err == (
        "error: --set start.v: follows from the others and is 0, not 1; it may be left out\n"
    )
    code, _, err = ask("show", EXAMPLES / "none.py")
    assert code == 2
    assert "there is no such file" in err
