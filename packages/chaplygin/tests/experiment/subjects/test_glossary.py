"""The letters of equations in words."""

from __future__ import annotations

from pathlib import Path

import pytest

from catalogue import built
from chaplygin.experiment.models.experiment import load_experiment
from chaplygin.experiment.study import Study
from studies import catalogue_study

EXAMPLES = Path(__file__).parents[5] / "examples"


def test_a_body_about_a_fixed_point_touches_nothing() -> None:
    words = catalogue_study("veselova").subject.legend
    assert "γ unit vector fixed in space" in words
    assert "contact" not in words
    assert "surface" not in words
    assert "λ₀ torque about the vertical" in words
    assert "A inverse of I" in words


def test_a_ball_under_a_constraint_of_its_own() -> None:
    words = catalogue_study("chaplygin-suslov-ball").subject.legend
    for part in ("p angular acceleration by a unit torque about e", "q the same by one about γ"):
        assert part in words
    assert "γ outward normal of the plane at the contact" in words


def test_a_rolling_body() -> None:
    words = catalogue_study("rubber-body").subject.legend
    for part in (
        "J inertia tensor about the contact point, plus m r ⊗ r",
        "X torque other than that of the constraints",
        "λ₀ torque about the normal",
        "r from the centre of mass to the contact point",
    ):
        assert part in words


@pytest.mark.slow
@pytest.mark.parametrize("name", [*built.ROLLING, "suslov", "veselova-spinning"])
def test_every_letter_of_the_equations_has_words(name: str) -> None:
    """But for parameters, which have a table of their own, and rates with a dot."""
    system = built.system(name)
    words = catalogue_study(name).subject.legend
    sentence = {part.split()[0] for part in words.removeprefix("In body axes: ").split("; ")}
    for letter in ("ω", "γ", "J", "A", "X", "p", "q", "λ₀"):
        shown = str(system).partition("Parameters")[0]
        if f"    {letter} = " in shown:
            assert letter in sentence, (name, letter)


def test_letters_of_a_body_with_friction() -> None:
    words = Study.from_experiment(load_experiment(EXAMPLES / "tippe_top.toml")).subject.legend
    for part in (
        "v velocity of the centre of mass",
        "slip: velocity of the body's point in contact over the support",
        "Fᵤ friction over μN by a unit slip",
        "Y inverse of I",
        "W contensou: work lost to this law",
    ):
        assert part in words
    assert "u length of the slip" not in words, "its equations have no u"
