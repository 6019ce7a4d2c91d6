"""Limit cycles proven on tori where they are known."""

from __future__ import annotations

import pytest
import sympy as sp
from flint import arb

from flowlanes.errors import InputError
from flowlanes.orbits.limit_cycles import enclose_limit_cycle
from flowlanes.system.system import Parameter, System

alpha, beta, w, e = sp.symbols("alpha beta w e", real=True)


def torus(rate):
    """dα/dβ = rate."""
    parameters = (Parameter(w, "mean rate", 0.1), Parameter(e, "wave", 0.3))
    return System("torus", "Torus", {alpha: rate, beta: sp.S.One}, parameters)


#: α̇ = w − e sin α has the fixed angles sin α = w/e, with multipliers exp(∓2π√(e² − w²)).
SINES = torus(w - e * sp.sin(alpha))


@pytest.mark.parametrize(
    ("interval", "sign", "kind"),
    [(("0.2", "0.5"), -1, "attracting"), (("2.6", "3.0"), 1, "repelling")],
)
def test_cycles_of_sines(interval, sign, kind):
    found = enclose_limit_cycle(
        SINES, {"w": "0.1", "e": "0.3"}, interval, 0, steps=300, max_slope=1.0
    )
    wanted = (sign * 2 * arb.pi() * (arb("0.3") ** 2 - arb("0.1") ** 2).sqrt()).exp()
    assert found.kind == kind
    assert found.multiplier.contains(wanted)
    assert float(found.multiplier.rad()) < 0.6 * float(wanted)


def test_nothing_is_proven_without_a_cycle():
    found = enclose_limit_cycle(torus(w + e / 10 * sp.cos(alpha)), {}, ("0.2", "0.5"), 0, steps=100)
    assert found.kind == "undecided"


def test_a_rotation_is_undecided():
    assert (
        enclose_limit_cycle(torus(1 + 0 * w), {}, ("0.2", "0.5"), 1, steps=50).kind == "undecided"
    )


def test_mistakes_are_told():
    with pytest.raises(ArithmeticError, match="exceeds its assumed bound"):
        enclose_limit_cycle(SINES, {}, ("0.2", "0.5"), 0, steps=50, max_slope=0.01)
    with pytest.raises(InputError, match="no parameter q"):
        enclose_limit_cycle(SINES, {"q": "1"}, ("0.2", "0.5"), 0)
    with pytest.raises(InputError, match="its state must be"):
        enclose_limit_cycle(SINES, {}, ("0.2", "0.5"), 0, angle="phi")


def test_a_clock_that_runs_back_or_turns_is_refused():
    # α = π repels in time, but attracts while β decreases
    back = System("back", "Back", {alpha: -sp.sin(alpha), beta: -1})
    with pytest.raises(ArithmeticError, match="beta does not grow"):
        enclose_limit_cycle(back, {}, ("2.9", "3.4"), 0, steps=100)
    turning = System("turning", "Turning", {alpha: -sp.sin(alpha), beta: sp.cos(alpha)})
    with pytest.raises(ArithmeticError, match="beta does not grow"):
        enclose_limit_cycle(turning, {}, ("1.4", "1.7"), 0, steps=100)


def test_numbers_that_cannot_be_read_are_refused():
    with pytest.raises(InputError, match="interval = x: it must be a decimal number"):
        enclose_limit_cycle(SINES, {}, ("x", "0.5"), 0)
    with pytest.raises(InputError, match="w = abc: it must be a decimal number"):
        enclose_limit_cycle(SINES, {"w": "abc"}, ("0.2", "0.5"), 0)
