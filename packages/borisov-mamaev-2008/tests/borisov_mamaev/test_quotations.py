"""Statements laid beside a text: what is left out, added and exchanged is found."""

from __future__ import annotations

from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import pytest

from borisov_mamaev_2008 import claims

PATH = Path(__file__).parents[4] / "scripts" / "quotations.py"


@pytest.fixture(scope="module")
def script():
    specification = spec_from_file_location("quotations", PATH)
    module = module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


TEXT = r"""
CONTENTS

1. FIRST THINGS

A ball rolls. If the plane is rough, the ball rolls forever, and its energy
$$H = \frac{1}{2}(\mathbf{M}, \boldsymbol{\omega}) - U(\gamma) \tag{1.1}$$
is an integral of Eqs. (1.2). Smith’s problem was solved only in the special case when the plane is
horizontal [7]. At last the ball sleeps.

2. LAST THINGS

Nothing rolls.

ACKNOWLEDGMENTS

A ball thanks.
"""


def found(script, statement, section=1):
    passage = script.sections(TEXT)[section]
    return [str(d) for d in script.differences(script.tokens(statement), passage)]


@pytest.mark.parametrize(
    ("statement", "expected"),
    [
        ("A ball rolls", []),
        # fonts, punctuation, apostrophes and ways to write a fraction are no words
        (
            r"its energy $H = \frac12(M, \omega) - U(\gamma)$ is an integral of Eqs. (1.2)",
            ["around: if"],
        ),
        ("Smith's problem was solved", ["around: only special when"]),
        ("Smith's problem was solved when the plane is horizontal", ["-only in the special case"]),
        ("the plane is smooth, the ball rolls", ["-rough +smooth", "around: if"]),
        ("If the plane is not rough, the ball rolls forever", ["+not"]),
        (r"$H = \frac{1}{2}(M, \omega) + U(\gamma)$ is an integral", ["-- ++", "around: if"]),
        ("the ball jumps", ["+jumps", "around: if"]),
    ],
)
def test_every_difference_is_found(script, statement, expected):
    assert found(script, statement) == expected


def test_sections_are_kept_apart(script):
    assert found(script, "Nothing rolls", 2) == []
    assert found(script, "Nothing rolls", 1) != []
    assert "thanks" not in script.sections(TEXT)[2]


def test_a_list_allows_what_it_was_written_from(script):
    one = script.differences(script.tokens("the ball jumps"), script.sections(TEXT)[1])
    two = script.differences(script.tokens("A ball rolls"), script.sections(TEXT)[1])
    listed = script.listed({(1, "(1.1)", 1): one, (1, "(1.1)", 2): one, (2, "end", 1): two})
    assert script.allowed(listed) == {
        (1, "(1.1)", 1): ("+jumps", "around: if"),
        (1, "(1.1)", 2): ("+jumps", "around: if"),
    }


def test_the_list_names_claims(script):
    """A claim that is renamed or dropped leaves no line behind."""
    names = {(section, claim.source) for section, claim in claims()}
    listed = script.allowed(script.ALLOWED.read_text(encoding="utf-8"))
    assert {key[:2] for key in listed} <= names
