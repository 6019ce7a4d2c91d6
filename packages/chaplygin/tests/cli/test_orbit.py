"""``chaplygin orbit`` as a user meets it: the cycle of flowlanes/docs/orbits.md."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from asking import Ask, ask
from chaplygin.experiment.dataset import open_dataset

__all__ = ["ask"]

CYCLE = ("orbit", "unbalanced-rubber-ball-centred", "--on", "gamma_1", "--hold", "energy")


@pytest.mark.slow
def test_a_limit_cycle_and_its_branch(ask: Ask) -> None:
    found = ("--after", "60", "--follow", "quadratic=0.96", "--figure", "branch.png")
    code, out, err = ask(*CYCLE, *found, "-o", "cycle.nc")
    assert code == 0, err
    assert "a periodic orbit of 1 return, attracting (observed)" in out
    assert "continued through " in out
    assert "trivial multipliers (equal to 1): flow, energy, quadratic" in out
    data = open_dataset("cycle.nc")
    assert abs(data.gamma[0] - data.gamma[-1]).max() < 1e-10
    assert Path("branch.png").stat().st_size > 10_000


@pytest.mark.slow
def test_the_same_for_a_program_with_a_parameter(ask: Ask) -> None:
    more = ("--hold", "quadratic", "--after", "60", "--json", "--follow", "J_3=2.801")
    code, out, err = ask(*CYCLE, *more)
    assert code == 0, err
    facts = json.loads(out)
    assert facts["kind"] == "attracting"
    assert facts["values"]["quadratic"] == pytest.approx(0.95, abs=1e-9)
    assert facts["multipliers"][0]["real"] == pytest.approx(0.7444753, abs=1e-6)
    assert facts["branch"]["orbits"][-1]["values"]["J_3"] == pytest.approx(2.801, abs=1e-9)


@pytest.mark.parametrize(
    ("options", "sentence"),
    [
        (("--hold", "spin"), "--hold spin: it must be one of energy, quadratic"),
        (("--follow", "energy"), "--follow energy: it is written NAME=VALUE, such as energy=2"),
        (("--follow", "q=2"), "--follow q: it must be one of energy, quadratic, "),
        (("--period", "0"), "--period 0: it must be at least 1"),
        (("--direction", "up"), "--direction up: it must be one of rising, falling, both"),
        (("--figure", "a.gif"), "--figure a.gif: its name must end in .png, .svg, .pdf"),
        (("-o", "a.txt"), "a.txt: the name of a trajectory must end in .nc"),
    ],
)
def test_mistakes(options: tuple[str, ...], sentence: str, ask: Ask) -> None:
    code, out, err = ask(*CYCLE, *options)
    assert (code, out) == (2, "")
    assert err.startswith(f"error: {sentence}")


def test_a_section_that_is_never_met(ask: Ask) -> None:
    code, _, err = ask(*CYCLE, "--value", "2")
    assert code == 1
    assert "the motion does not return to gamma_1 = 2 often enough" in err
