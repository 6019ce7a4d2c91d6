"""The rattleback of Kane and Levinson turns back when their own equations say so."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

EXAMPLES = Path(__file__).parents[2] / "examples"
sys.path.insert(0, str(EXAMPLES))
import rattleback_kane_levinson as example  # noqa: E402

# 34 digits at tolerance 1e-30, rounded to double
REVERSALS = [
    2.6846470448173907,
    2.6849588156246496,
    2.7611091538006316,
    2.7802787168881364,
    2.8073124074434563,
    2.852753727995094,
    2.8554800327128245,
    17.32942312300551,
    17.366685194135002,
    17.397134375164413,
]
OMEGA3_ZEROS = [
    2.352730996524552,
    2.3567369846539994,
    2.404393228010354,
    2.4076549195387837,
    2.6174991994700365,
    2.6466899854715003,
    2.672354649244515,
    2.7019261224752906,
    2.866318123542174,
    3.0721285943423293,
    3.0856883710286573,
    3.130150950406761,
    3.133756881294396,
    17.331426695224295,
    17.366688263802743,
    17.39499710153622,
]
DAMPED_REVERSALS = [2.5124324894615704, 2.5474661522852116, 2.5562970167139807]
DAMPED_ZEROS = [
    2.3899350858784456,
    2.4137608316027395,
    2.4447640755656814,
    2.4616166559894515,
    2.5670861443899584,
    2.7496914038263687,
    2.756529297806716,
]


def cross(a: Any, b: Any) -> Any:
    """The vector product of three numbers each: that of NumPy takes ten times as long for them."""
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


def their_equations(time: float, state: Any, sigma: float) -> Any:
    """Euler's equations about the contact with angles α, β and axis 3 down, by hand."""
    (alpha, beta), u = state[:2], state[2:]
    axes, inertia = np.array([0.2, 0.03, 0.02]) ** 2, np.diag([2e-4, 16e-4, 17e-4])
    inertia[0, 1] = inertia[1, 0] = -2e-5
    mass, gravity, height = 1.0, 9.81, 0.01
    down = np.array([-np.cos(alpha) * np.sin(beta), np.sin(alpha), np.cos(alpha) * np.cos(beta)])
    size = np.sqrt(axes @ down**2)
    contact = axes * down / size - [0, 0, height]
    turning = cross(down, u)
    growth = axes @ (down * turning) / size
    sliding = axes * (turning / size - down * growth / size**2)
    acceleration = cross(u, cross(contact, u) - sliding)
    couple = (
        mass * gravity * cross(down, contact)
        - sigma * u
        + cross(inertia @ u, u)
        + mass * cross(contact, acceleration)
    )
    about = inertia + mass * (contact @ contact * np.eye(3) - np.outer(contact, contact))
    heading = (u[2] * np.cos(beta) - u[0] * np.sin(beta)) / np.cos(alpha)
    rates = [u[2] * np.sin(beta) + u[0] * np.cos(beta), u[1] - heading * np.sin(alpha)]
    return np.concatenate([rates, np.linalg.solve(about, couple)])


def their_vertical(time: float, state: Any, sigma: float) -> float:
    """The component of the angular velocity along the vertical."""
    (alpha, beta), u = state[:2], state[2:]
    down = [-np.cos(alpha) * np.sin(beta), np.sin(alpha), np.cos(alpha) * np.cos(beta)]
    return float(np.dot(down, u))


def their_third(time: float, state: Any, sigma: float) -> float:
    """The component along axis 3."""
    return float(state[4])


@pytest.mark.slow
def test_json(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "argv", ["rattleback_kane_levinson.py", "--json"])
    example.main()
    sentence = json.loads(capsys.readouterr().out)
    # rounded to eleven digits behind the point, where two times on both sides of a half may part
    np.testing.assert_allclose(sentence["reversals"], REVERSALS, rtol=0, atol=6e-12)
    np.testing.assert_allclose(sentence["omega3_zeros"], OMEGA3_ZEROS, rtol=0, atol=6e-12)
    assert sentence["damped"]["sigma"] == 1e-4
    damped = sentence["damped"]
    np.testing.assert_allclose(damped["reversals"], DAMPED_REVERSALS, rtol=0, atol=6e-12)
    np.testing.assert_allclose(damped["omega3_zeros"], DAMPED_ZEROS, rtol=0, atol=6e-12)


@pytest.mark.slow
def test_both_derivations_agree_without_dissipation() -> None:
    made = example.run(example.damped_stone(0.0), 20.0, "double")
    np.testing.assert_allclose(made.reversals, REVERSALS, rtol=0, atol=2e-13)
    np.testing.assert_allclose(made.omega3_zeros, OMEGA3_ZEROS, rtol=0, atol=2e-13)


@pytest.mark.parametrize(
    ("sigma", "until", "vertical", "third"),
    [
        (1e-4, 2.58, DAMPED_REVERSALS, DAMPED_ZEROS[:5]),
        pytest.param(1e-4, 3.5, DAMPED_REVERSALS, DAMPED_ZEROS, marks=pytest.mark.slow),
        pytest.param(0.0, 3.5, REVERSALS[:7], OMEGA3_ZEROS[:13], marks=pytest.mark.slow),
    ],
)
def test_the_equations_of_the_paper(
    sigma: float, until: float, vertical: list[float], third: list[float]
) -> None:
    tilt = np.radians(0.5)
    made = solve_ivp(
        their_equations,
        (0.0, until),
        [tilt, tilt, 0.0, 0.0, -5.0],
        method="DOP853",
        rtol=1e-12,
        atol=1e-13,
        args=(sigma,),
        events=[their_vertical, their_third],
    )
    np.testing.assert_allclose(made.t_events[0], vertical, rtol=0, atol=2e-9)
    np.testing.assert_allclose(made.t_events[1], third, rtol=0, atol=2e-9)


@pytest.mark.slow
def test_34_digits() -> None:
    made = example.run(example.damped_stone(example.SIGMA), 2.8, "quad")
    np.testing.assert_allclose(made.reversals, DAMPED_REVERSALS, rtol=0, atol=4e-15)


@pytest.mark.slow
def test_the_couple_takes_energy() -> None:
    system = example.damped_stone(example.SIGMA)
    assert system.integrals == ()
    made = example.run(system, 20.0, "double")
    free = example.run(example.rolling_stone(), 20.0, "double")
    assert made.tilt[2000:].max() < free.tilt[2000:].max() / 5
    assert not [t for t in made.reversals if t > 3]


def test_zeros_side_by_side_are_found() -> None:
    knots = np.linspace(0.0, 2.0, 6)
    found = example.sign_changes(lambda t: (np.atleast_1d(t) - 1.03) ** 2 - 1e-10, knots)
    np.testing.assert_allclose(found, [1.03 - 1e-5, 1.03 + 1e-5], rtol=0, atol=1e-12)
    assert example.sign_changes(lambda t: (np.atleast_1d(t) - 1.03) ** 2 + 1e-9, knots) == []


@pytest.mark.slow
def test_table_and_figure(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    picture = tmp_path / "spin.png"
    options = ["x", "--until", "3", "--figure", str(picture)]
    monkeypatch.setattr(sys, "argv", options)
    example.main()
    assert picture.stat().st_size > 10_000
    assert "2.68464704482" in capsys.readouterr().out
