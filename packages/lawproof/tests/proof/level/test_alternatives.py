"""Measures on levels whose conditions are products with functions."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.system.laws import Identity, Measure
from flowlanes.system.system import System
from lawproof.proof.prover import prove

X, Y, Z = sp.symbols("x y z", real=True)
FIRST, SECOND = Y - sp.exp(X), Z - 2


def on_the_level() -> System:
    """The field w × ∇f with curl w = 0, which keeps f = 0 and the volume that f cuts out."""
    level = FIRST * SECOND
    slopes = [sp.diff(level, s) for s in (X, Y, Z)]
    w = (X, Y**2, sp.sin(Z))
    rates = [w[i - 2] * slopes[i - 1] - w[i - 1] * slopes[i - 2] for i in range(3)]
    return System("two", "Two sheets", dict(zip((X, Y, Z), rates, strict=True)), relations=(level,))


@pytest.mark.parametrize(
    ("density", "decision"),
    [
        ((sp.exp(X * FIRST * SECOND), 1), "proven"),
        # each would be right for the volume that one factor alone cuts out
        ((FIRST, 1), "refuted"),
        ((SECOND, 1), "refuted"),
        ((X**2 + 1, 1), "refuted"),
    ],
)
def test_the_volume_is_that_of_the_whole_condition(
    density: tuple[sp.Expr, int], decision: str
) -> None:
    assert prove(on_the_level(), Measure("density", (density,))).decision == decision


def test_a_name_hides_no_factor() -> None:
    product, again = sp.symbols("product again", real=True)
    system = System(
        "still",
        "Still",
        {X: sp.S.Zero, Y: sp.S.Zero},
        definitions={product: Y * sp.sin(X), again: 2 * product},
    )
    for condition in (Y * sp.sin(X), product, again):
        assert prove(system, Identity("y", Y, level=(condition,))).decision == "refuted"
        both = Identity("both", Y * sp.sin(X) ** 2, level=(condition,))
        assert prove(system, both).decision == "proven"
