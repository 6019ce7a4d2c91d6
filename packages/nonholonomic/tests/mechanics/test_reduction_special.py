"""Reductions at exceptional values of parameters, which must not contradict the general ones."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove
from mechanics.reducible import I, a, ball, on_sphere, ratio, sleigh, veselova
from nonholonomic.mechanics.lagrangian.substituted_parameters import with_parameters
from nonholonomic.mechanics.reduction.chaplygin import chaplygin_form
from nonholonomic.mechanics.reduction.multiplier import poles


def with_default(mechanism, symbol, value):
    parameters = tuple(
        replace(p, default=value) if p.symbol == symbol else p for p in mechanism.parameters
    )
    return replace(mechanism, parameters=parameters)


@pytest.mark.slow
def test_a_parameter_whose_number_is_exceptional():
    """The sleigh has a multiplier where a = 0, whether that is put in or its default."""
    found = chaplygin_form(with_default(sleigh(), a, 0.0))
    put_in = chaplygin_form(sleigh(sp.S.Zero))
    assert found.level == (a,)
    assert found.obstruction is None
    assert found.multiplier.value == put_in.multiplier.value
    assert "where         a = 0, a case of its own" in str(found)
    for system, law in found.claims():
        # N = cos φ
        where = ("dτ/dt > 0",) if law.name == "canonical" else ()
        assert prove(system, law).conditions == where


@pytest.mark.slow
def test_a_general_parameter_has_an_obstruction_and_says_where_not():
    found = chaplygin_form(sleigh())
    assert found.level == ()
    assert found.multiplier is None
    assert found.obstruction.vanishing == (a,)


def test_settled_is_what_was_built_with_the_number():
    one, other = with_parameters(sleigh(), {a: sp.S.Zero}), sleigh(sp.S.Zero)
    assert one.parameters == other.parameters
    assert sp.expand(one.L - other.L) == 0
    assert one.f == other.f


@pytest.mark.slow
def test_poles_of_exponents_are_told():
    found = chaplygin_form(on_sphere(ratio, rubber=True))
    assert poles(found.multiplier) == (ratio,)
    assert "not where κ = 0, which is a case of its own" in str(found)


@pytest.mark.parametrize("rubber", [True, False])
def test_a_normal_that_does_not_move_is_refused(rubber):
    with pytest.raises(InputError, match="gamma does not move freely under the constraints"):
        chaplygin_form(on_sphere(sp.S.Zero, rubber))


@pytest.mark.slow
def test_the_normal_does_not_move_for_the_number_of_a_parameter():
    with pytest.raises(InputError, match="gamma does not move freely under the constraints"):
        chaplygin_form(with_default(on_sphere(ratio, rubber=True), ratio, 0.0))


@pytest.mark.slow
def test_special_values_are_to_be_put_in():
    with pytest.raises(InputError, match="general values of its parameters"):
        chaplygin_form(on_sphere(ratio, rubber=False))


@pytest.mark.slow
def test_the_integral_for_equal_moments_is_that_of_the_general_ball():
    first, second, third = I.symbols
    equal = with_parameters(ball(), {second: first, third: first})
    special, general = chaplygin_form(equal), chaplygin_form(ball())
    # N is known up to a constant factor, and with it S̄ and its integral
    m, R, gamma = real_symbol("m"), real_symbol("R"), general.base.normal
    same = {second: first, third: first}
    pole = dict(zip(gamma.symbols, (0, 0, 1), strict=True))
    factor = general.multiplier.value.xreplace(same).subs(pole) / special.multiplier.value
    assert special.flux.value is not None
    ratio_ = sp.simplify(general.flux.value.xreplace(same) / special.flux.value / factor)
    numbers = {first: 2, m: 3, R: 5}
    assert abs(sp.N(ratio_.subs(numbers))) == pytest.approx(1)
    assert ratio_.subs(numbers) > 0


def test_equal_moments_of_veselova():
    first, second, third = I.symbols
    form = chaplygin_form(with_parameters(veselova(), {second: first, third: first}))
    assert form.multiplier.value == 1
