"""``chaplygin bifurcation`` as a user meets it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from asking import Ask, ask

__all__ = ["ask"]


@pytest.mark.slow
def test_a_system_with_its_motion(ask: Ask) -> None:
    code, out, err = ask("bifurcation", "veselova", "-o", "diagram.png")
    assert code == 0, err
    assert "region 1: 2 tori — this motion" in out
    assert "permanent rotation about axis 2: 2 circles, unstable; 3 h − F = 0" in out
    assert "this motion: h = 0.724706035, F = 1.84439617" in out
    assert Path("diagram.png").stat().st_size > 10_000
    code, _, err = ask("bifurcation", "veselova", "-o", "diagram.png")
    assert code == 2
    assert "exists already" in err


def test_a_plane_alone_for_a_program(ask: Ask) -> None:
    code, out, _ = ask("bifurcation", "chaplygin-ball-area", "--set", "I_2=1.7", "--json")
    assert code == 0
    facts = json.loads(out)
    assert [axis["symbol"] for axis in facts["axes"]] == ["h", "g"]
    assert {region["tori"] for region in facts["regions"]} == {2}
    assert [b["motions"] for b in facts["boundaries"] if not b["stable"]] == [
        "permanent rotation about axis 2"
    ]


def test_a_rubber_body_of_revolution(ask: Ask) -> None:
    code, out, err = ask("bifurcation", "rubber-disk", "-o", "disk.png")
    assert code == 0, err
    assert "K  integral (5.1), linear in the angular velocity (kg^0.5 m/s)" in out
    assert "    unstable: cos θ = 0.218882, h = 10.5204752" in out
    assert out.endswith(
        "this motion: h = 8.980045, K = -0.994029786; 2 motions with these values\n"
    )
    assert max(map(len, out.splitlines())) <= 80
    assert Path("disk.png").stat().st_size > 10_000
    level = ["--set", "start.omega=[0.3, 0, 0]", "--set", "start.gamma=[0, 0.8, 0.6]"]
    code, out, _ = ask("bifurcation", "rubber-disk", *level, "--json")
    facts = json.loads(out)
    assert (code, facts["motion"][1], facts["motions"], facts["rotations"]) == (0, 0.0, None, [])
    assert {family["stable"] for family in facts["families"]} == {True, False}


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (("rattleback",), "no bifurcation diagram of Rattleback is known at this start"),
        (("veselova", "--set", "I_1=1.5"), "veselova: the moments 3/2, 3/2, 21/10 must be three"),
        (("veselova", "-o", "a.gif"), "--output a.gif: its name must end in .png, .svg, .pdf"),
        (("chaplygin-ball-area", "--set", "I_2=x"), "--set I_2=x: of a plane a parameter is set"),
    ],
)
def test_refusals(arguments: tuple[str, ...], sentence: str, ask: Ask) -> None:
    code, out, err = ask("bifurcation", *arguments)
    assert (code, out) == (2, "")
    assert err.startswith(f"error: {sentence}")
