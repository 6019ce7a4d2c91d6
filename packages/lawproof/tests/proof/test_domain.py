"""Where a proof holds: signs under roots, and points inside the domain of a system."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from flowlanes.system.laws import Identity, Integral
from flowlanes.system.system import Guard, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove

x, y = real_symbol("x"), real_symbol("y")
RESTING = System("resting", "resting", field={x: 0 * x, y: 0 * y})


def test_a_product_under_a_root_is_split_where_its_factors_are_positive():
    law = Identity("split", sp.sqrt((2 + x) * (2 + y)) - sp.sqrt(2 + x) * sp.sqrt(2 + y))
    assert prove(RESTING, law).decision == "proven"


def test_a_split_that_needs_a_sign_is_refuted_where_the_sign_is_another():
    """√((2 + x) y) √y = √(2 + x) y only where both factors are positive."""
    law = Identity("split", sp.sqrt((2 + x) * y) * sp.sqrt(y**3) - sp.sqrt(2 + x) * y**2)
    assert prove(RESTING, law).decision == "proven"
    first, second = 1 + y, 2 + y
    right = x * sp.sqrt(sp.expand(first * second))
    other = Identity("split", sp.sqrt(x * first) * sp.sqrt(x * second) - right)
    assert prove(RESTING, other).decision == "refuted"


def test_a_single_factor_needs_no_sign():
    law = Identity("square", sp.sqrt(2 + x) ** 2 - 2 - x)
    assert prove(RESTING, law).decision == "proven"
    assert prove(RESTING, Identity("root", 1 / sp.sqrt(2 + x) ** 2 - 1 / (2 + x)))


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
