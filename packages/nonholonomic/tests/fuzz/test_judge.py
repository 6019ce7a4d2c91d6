"""The judge: outcomes, conditions, witnesses."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.laws import Identity
from fuzz.case import Case, guards, parameter, real, system
from fuzz.judge import admits, judged
from lawproof.proof.verdict import Verdict

x, y, a = real("x y a")
MADE = (
    system(
        {x: sp.S.Zero, y: sp.S.Zero},
        parameters=(parameter(a, 1.0, a > 0),),
        relations=(x * y,),
        guards=guards((2 - x,)),
    ),
    Identity("law", y),
)
FALSE = Case("hand-made", lambda: MADE, "false", "", {x: sp.S.Zero, y: sp.S.One, a: sp.S.One})
TRUE = replace(FALSE, truth="true", fails_at=None)
MALFORMED = replace(TRUE, truth="malformed")


def told(decision, *conditions, **point):
    witness = {"point": point} if point else None
    return Verdict("law", decision, conditions=conditions, witness=witness)


@pytest.mark.parametrize(
    ("case", "verdict", "outcome"),
    [
        (TRUE, told("proven"), "right"),
        (TRUE, told("refuted"), "false refutation"),
        (TRUE, told("undecided"), "undecided, true"),
        (TRUE, told("proven where", "x > 0"), "proven where, true"),
        (TRUE, InputError("no"), "refused"),
        (replace(TRUE, refusable=True), InputError("no"), "right"),
        (TRUE, ValueError("no"), "crash"),
        (FALSE, told("proven"), "false proof"),
        (FALSE, told("proven where", "not y = 0"), "false proof where"),
        (FALSE, told("proven where", "not y = 0", "x > 0"), "proven where, false"),
        (FALSE, told("proven where", "who knows"), "proven where, false"),
        (FALSE, told("undecided"), "undecided, false"),
        (FALSE, told("refuted", x="0", y="3/2", a="1"), "right"),
        (FALSE, told("refuted", x="0", y="[1.5 +/- 1e-9]", a="1"), "right"),
        (FALSE, told("refuted", x="1", y="3/2", a="1"), "bad witness"),
        (FALSE, told("refuted", x="0", y="3/2", a="-1"), "bad witness"),
        (FALSE, told("refuted", x="3", y="0", a="1"), "bad witness"),
        (FALSE, told("refuted", x="[3.0 +/- 1e-9]", y="0", a="1"), "bad witness"),
        (MALFORMED, InputError("no"), "right"),
        (MALFORMED, told("undecided"), "not refused"),
        (MALFORMED, told("proven"), "proven, malformed"),
    ],
)
def test_outcomes(case, verdict, outcome):
    assert judged(case, verdict, MADE) == outcome


@pytest.mark.parametrize(
    ("text", "met"),
    [
        ("x > 0", True),
        ("x < 0", False),
        ("x^2 - 1 = 3", True),
        ("not x - 2 = 0", False),
        ("not y = 0", False),
        ("y ≠ 0", False),
        ("x + y >= 2", True),
        ("not x = 0 or not y = 0", True),
        ("x > 0 and y > 0", False),
        ("sin(y) = 0", True),
        ("z > 0", None),
        ("the two are apart", None),
        ("x >", None),
    ],
)
def test_conditions_are_read(text, met):
    assert admits((text,), {x: sp.S(2), y: sp.S.Zero}) is met


def test_names_of_variables_may_be_words_of_python():
    point = {sp.Symbol("lambda", real=True): sp.S(2), sp.Symbol("E", real=True): sp.S(3)}
    assert admits(("lambda - E + 1 = 0",), point) is True
    assert admits(("not E - 3 = 0",), point) is False


def test_one_condition_that_is_not_met_is_enough():
    point = {x: sp.S(2)}
    assert admits(("unreadable", "x < 0"), point) is False
    assert admits(("unreadable", "x > 0"), point) is None
    assert admits((), point) is True
