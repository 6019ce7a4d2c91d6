"""Where a proof holds: signs under roots, and points inside the domain of a system."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from chaplygin.laws.prove import prove
from chaplygin.statements import Identity, Integral
from chaplygin.system import Guard, System
from chaplygin.vectors import scalar

x, y = scalar("x"), scalar("y")
RESTING = System("resting", "resting", field={x: 0 * x, y: 0 * y})


def test_a_product_under_a_root_is_split_where_its_factors_are_positive():
    law = Identity("split", sp.sqrt((2 + x) * (2 + y)) - sp.sqrt(2 + x) * sp.sqrt(2 + y))
    verdict = prove(RESTING, law)
    assert verdict.decision == "proven"
    assert "x + 2 > 0" in verdict.shown
    assert "y + 2 > 0" in verdict.shown


def test_a_single_factor_needs_no_sign():
    law = Identity("square", sp.sqrt(2 + x) ** 2 - 2 - x)
    assert prove(RESTING, law).decision == "proven"
    assert (
        "> 0" not in prove(RESTING, Identity("root", 1 / sp.sqrt(2 + x) ** 2 - 1 / (2 + x))).shown
    )


@pytest.mark.parametrize("side", [1, -1])
def test_points_lie_where_the_guards_are_positive(side):
    """|x| = ±x on either side, each told by a guard."""
    system = System(
        "half",
        "half line",
        field={x: 0 * x, y: 0 * y},
        guards=(Guard("side", side * x - 1, "the side is left"),),
    )
    # the square under the root is hidden from SymPy, which would write an absolute value
    root = sp.sqrt((x + y) ** 2 - 2 * x * y - y**2)
    right = Identity("right", root - side * x)
    wrong = Identity("wrong", root + side * x)
    assert prove(system, right).decision == "proven"
    assert prove(system, wrong).decision == "refuted"
    moved = System("moved", "moved", field={x: 1 + 0 * x}, guards=system.guards)
    witness = prove(moved, Integral("place", x)).witness
    assert witness is not None
    assert side * Fraction(witness["point"]["x"]) > 1
