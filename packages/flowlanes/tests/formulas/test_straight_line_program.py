"""Straight-line programs, run with several kinds of numbers."""

from __future__ import annotations

import pytest
import sympy as sp
from flint import acb, arb, ctx, fmpq

from flowlanes.errors import InputError
from flowlanes.formulas.balls import ball_function
from flowlanes.formulas.straight_line_program import ANALYTIC, ENTIRE, REAL, StraightLineProgram
from flowlanes.system.named_formulas import needed_steps

x, y, z = sp.symbols("x y z", real=True)


def ball(formula: sp.Expr, **values: arb) -> arb:
    names = tuple(map(sp.Symbol, values))
    real = {sp.Symbol(str(name), real=True): name for name in names}
    (value,) = ball_function(names, (formula.xreplace(real),))(*values.values())
    return value


@pytest.mark.parametrize(
    "formula",
    [
        sp.pi * x,
        sp.E + x,
        sp.sin(x) / sp.tanh(x),
        sp.log(x) * sp.atan2(x, -2),
        sp.Float(0.1) * x,
        x ** sp.Rational(1, 3),
        2**x + sp.Abs(x - 3),
        sp.asin(x / 7) + sp.acos(x / 7) + sp.atan(x),
        sp.cosh(x) ** 2 - sp.sinh(x) ** 2 + sp.exp(x) * sp.tan(x) * sp.cos(x),
    ],
    ids=str,
)
def test_balls_enclose_values_to_the_working_precision(formula: sp.Expr) -> None:
    with ctx.workprec(200):
        value = ball(formula, x=arb("1.7"))
        exact = sp.N(sp.nsimplify(formula, rational=True).subs(x, sp.Rational(17, 10)), 80)
        with ctx.workprec(260):
            assert value.contains(arb(str(exact)))
        assert value.rad() < arb("1e-55")


def test_constants_have_the_precision_of_the_run() -> None:
    function = ball_function((x,), (x / 3,))
    for bits in (60, 400):
        with ctx.workprec(bits):
            assert function(arb(1))[0].rad() < arb(2) ** (5 - bits)


@pytest.mark.parametrize("formula", [1 / x, x ** sp.Rational(-3, 2), sp.sqrt(x - 2), sp.log(x)])
def test_a_pole_or_the_root_of_a_negative_number_is_not_finite(formula: sp.Expr) -> None:
    assert not ball(formula, x=arb(0, 1)).is_finite()


def test_analytic_roots_have_no_value_across_their_cut() -> None:
    program = StraightLineProgram((x,), [sp.sqrt(x)])
    across = acb(arb(-1), arb(0, 0.5))
    assert program.run([across])[0].is_finite()
    assert not program.run([across], ANALYTIC)[0].is_finite()
    assert program.run([acb(arb(2), arb(0, 0.5))], ANALYTIC)[0].is_finite()


def test_what_is_not_allowed_is_refused() -> None:
    with pytest.raises(InputError, match=r"closed forms are computed of .* cos and exp alone"):
        StraightLineProgram((x,), [sp.log(x)], functions=ENTIRE)
    with pytest.raises(InputError, match="neither a sum, a product nor a root"):
        StraightLineProgram((x,), [x ** sp.Rational(1, 3)])
    with pytest.raises(InputError, match=r"y: .* without a value"):
        StraightLineProgram((x,), [x + y], functions=REAL)
    with pytest.raises(InputError, match="sums, products"):
        StraightLineProgram((x,), [sp.gamma(x)], functions=REAL)


def test_steps_are_computed_once_and_only_if_needed() -> None:
    steps = ((y, x**2), (z, y + 1), (sp.Symbol("unused"), sp.gamma(x)))
    assert needed_steps(steps, [z]) == steps[:2]
    program = StraightLineProgram((x,), [z * y, z], steps)
    assert program.run([fmpq(3)]) == [90, 10]
    kinds = [operation.kind for operation in program.operations]
    assert kinds.count("sum") == 1


def test_a_long_chain_of_steps_is_followed() -> None:
    names = sp.symbols("s:3000")
    steps = tuple((name, last + 1) for last, name in zip((x, *names[:-1]), names, strict=True))
    assert StraightLineProgram((x,), [names[-1]], steps).run([arb(0)])[0] == 3000
