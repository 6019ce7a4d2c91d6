"""``chaplygin sweep`` as a user meets it."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from asking import Ask, ask
from chaplygin.cli.sweep import values_of
from flowlanes.errors import InputError
from flowlanes.flow.ensembles.zarr_store import read_store
from flowlanes.flow.integrator import integrate
from nonholonomic.catalogue import from_catalogue
from nonholonomic.starts import initial_state

__all__ = ["ask"]

SWEEP = ("sweep", "chaplygin-ball", "-o", "s.zarr", "--set", "run.until=5")


@pytest.mark.slow
def test_a_list_of_values(ask: Ask) -> None:
    options = ("--over", "I_1=1,1.2,1.45", "--record", "omega", "--draw", "omega_3")
    code, out, err = ask(*SWEEP, *options)
    assert code == 0, err
    assert "Chaplygin ball: 3 motions, 3 of I_1" in out
    assert Path("s.png").stat().st_size > 10_000
    data = read_store("s.zarr")
    assert data.I_1.values.tolist() == [1.0, 1.2, 1.45]
    ball = from_catalogue("chaplygin-ball", I_1=1.2)
    start = initial_state(ball, (0.7, 0.4, 1.1), (0.2, -0.3, 0.93))
    alone = integrate(ball, start, [0.0, 5.0])
    assert np.abs(data.M.values[1, -1] - alone["M"][-1]).max() < 1e-10
    # the same command finds everything done, another one is another experiment
    assert ask(*SWEEP, *options)[0] == 0
    code, _, err = ask(*SWEEP, "--over", "I_1=1,1.2")
    assert code == 2
    assert "holds another experiment" in err


@pytest.mark.slow
def test_every_combination_for_a_program(ask: Ask) -> None:
    code, out, _ = ask(*SWEEP, "--over", "I_1=1:1.4:5", "--over", "m=1,2", "--json")
    assert code == 0
    facts = json.loads(out)
    assert facts["motions"] == 10
    assert facts["parameters"]["m"] == [1.0, 2.0]
    assert facts["outcomes"] == {"the last time was reached": 10}


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--over", "I_1"), "--over I_1: it is written NAME=VALUE,VALUE,"),
        (("--over", "I_1=a,b"), "--over I_1=a,b: it is written NAME=VALUE,VALUE,"),
        (
            ("--over", "q=1,2"),
            "--over q: no parameter of chaplygin-ball; allowed: m, I_1, I_2, I_3, R",
        ),
        (("--over", "m=1,2", "--draw", "x"), "--draw x: it must be one of M_1, M_2, M_3, gamma_1"),
        (("--over", "m=1,2", "--figure", "a.gif"), "--figure a.gif: its name must end in .png"),
    ],
)
def test_mistakes(options: tuple[str, ...], sentence: str, ask: Ask) -> None:
    code, out, err = ask(*SWEEP, *options)
    assert (code, out) == (2, "")
    assert err.startswith(f"error: {sentence}")
    assert not list(Path().iterdir())


def test_values() -> None:
    assert values_of("m = 1, 2.5") == ("m", [1.0, 2.5])
    assert values_of("m=1:2:3") == ("m", [1.0, 1.5, 2.0])
    with pytest.raises(InputError):
        values_of("2m=1,2")
