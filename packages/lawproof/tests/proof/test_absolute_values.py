"""Absolute values and signs: |u| is the positive root of u², its derivative is sign u."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes import Identity, Integral, System
from flowlanes.system import real_symbol
from flowlanes.system.laws import Law
from flowlanes.system.system import Guard
from lawproof.proof import prove_with_certificate

x, y = real_symbol("x"), real_symbol("y")
TURNING = {x: y, y: -x}
FALLING = {x: y, y: -sp.sign(x)}
STILL = {x: sp.S.One, y: sp.S.One}

TRUE = {
    "a sign": (STILL, Identity("law", sp.Abs(x) * sp.sign(x) - x)),
    "a square": (STILL, Identity("law", sp.Abs(x - y) ** 2 - sp.expand((x - y) ** 2))),
    "a product": (STILL, Identity("law", sp.Abs(x * y + x) - sp.Abs(x) * sp.Abs(y + 1))),
    "a product of signs": (
        STILL,
        Identity("law", sp.sign(x * y + x) - sp.sign(x) * sp.sign(y + 1)),
    ),
    "one in another": (
        STILL,
        Identity("law", sp.Abs(sp.Abs(x) - 1) ** 2 - x**2 + 2 * sp.Abs(x) - 1),
    ),
    "one that needs no sign": (STILL, Identity("law", sp.Abs(sp.Abs(x) + 1) - sp.Abs(x) - 1)),
    "a root": (STILL, Identity("law", sp.sqrt(sp.expand((x - y) ** 2)) - sp.Abs(x - y))),
    "a maximum": (STILL, Identity("law", sp.Max(x, y) + sp.Min(x, y) - x - y)),
    "three": (STILL, Identity("law", sp.Max(x, y, 1 - x) + sp.Min(-x, -y, x - 1))),
    "a constant force": (FALLING, Integral("law", y**2 / 2 + sp.Abs(x))),
    "a product that stays": ({x: x, y: -y}, Integral("law", sp.Abs(x) * y)),
    "a force |x| x": ({x: y, y: -x * sp.Abs(x)}, Integral("law", y**2 / 2 + sp.Abs(x) ** 3 / 3)),
    "a power of a radius": (
        TURNING,
        Integral("law", sp.Abs(x**2 + y**2 - 1) ** sp.Rational(1, 3)),
    ),
}

FALSE = {
    "the variable itself": (STILL, Identity("law", sp.Abs(x) - x)),
    "the root of a square": (
        STILL,
        Identity("law", sp.sqrt(sp.expand((x + y - 3) ** 2)) - x - y + 3),
    ),
    "a sum": (STILL, Identity("law", sp.Abs(x + y) - sp.Abs(x) - sp.Abs(y))),
    "one in another": (STILL, Identity("law", sp.Abs(sp.Abs(x) - 1) - sp.Abs(x) + 1)),
    "a sign": (STILL, Identity("law", sp.sign(x) - 1)),
    "a maximum": (STILL, Identity("law", sp.Max(x, y) - x)),
    "a force of the wrong sign": (FALLING, Integral("law", y**2 / 2 - sp.Abs(x))),
}


def system(rates: dict[sp.Symbol, sp.Expr], *guards: sp.Expr) -> System:
    named = tuple(Guard(f"guard{i}", g, "outside") for i, g in enumerate(guards))
    return System("s", "S", rates, guards=named)


@pytest.mark.parametrize("name", TRUE)
def test_true_ones_are_proven(name: str) -> None:
    rates, law = TRUE[name]
    verdict = prove_with_certificate(system(rates), law)
    assert verdict.decision == "proven", verdict.reason
    assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.parametrize("name", FALSE)
def test_false_ones_are_refuted(name: str) -> None:
    rates, law = FALSE[name]
    verdict = prove_with_certificate(system(rates), law)
    assert verdict.decision == "refuted"
    assert verdict.certificate is not None


@pytest.mark.parametrize(
    ("formula", "guard"),
    [
        (sp.sqrt((x - 1) ** 2) - x + 1, x - 1),
        (sp.sqrt((x - 1) ** 2) + x - 1, 1 - x),
        (sp.Abs(x) - x, x - 1),
        (sp.Max(x, y) - x, x - y),
    ],
    ids=str,
)
def test_a_guard_says_the_sign(formula: sp.Expr, guard: sp.Expr) -> None:
    verdict = prove_with_certificate(system(STILL, guard), Identity("law", formula))
    assert verdict.decision == "proven"
    assert verdict.certificate is not None, verdict.no_certificate


def test_zeros_of_an_absolute_value_are_left_aside() -> None:
    """On x y = 0 the law holds where x = 0, but has no derivative there."""
    law: Law = Identity("law", y * (sp.Abs(x) + 1), level=(x * y,))
    verdict = prove_with_certificate(system({x: 0 * x, y: 0 * y}), law)
    assert verdict.decision not in ("proven", "refuted")
