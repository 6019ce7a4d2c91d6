"""Parameters that may lie in several ranges, and those that an isomorphism gives its target."""

from __future__ import annotations

import copy
from dataclasses import replace

import pytest
import sympy as sp

from certificate_checker import CheckError, check
from flowlanes.errors import InputError
from flowlanes.flow.integrator import integrate
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral
from flowlanes.system.system import Parameter, System
from lawproof.proof.certificates.certificate import prove_with_certificate
from lawproof.proof.level.alternatives import ranges_of_parameters
from lawproof.proof.prover import prove

x, v, a, b = sp.symbols("x v a b", real=True)
OUTSIDE = sp.Or(a > 1, a < -1)


def spring(*admissible, default=2.0):
    parameter = Parameter(a, "frequency", default, admissible=admissible)
    return System("spring", "Spring", {x: v, v: -(a**2) * x}, (parameter,))


ENERGY = Integral("energy", v**2 + a**2 * x**2)


@pytest.mark.parametrize(
    "condition", [OUTSIDE, sp.Xor(a > 1, a > 3), sp.Not(sp.And(a > -1, a < 1)), sp.Ne(a, 0)]
)
def test_conditions_of_every_form_are_understood(condition):
    system = spring(condition)
    assert prove(system, ENERGY).decision == "proven"
    assert prove(system, Integral("wrong", v**2 - a**2 * x**2)).decision == "refuted"


def test_each_range_counts():
    """Where (a + 2) x = 0 is x = 0 for a > 1 alone, whatever the default."""
    for default in (2.0, -3.0):
        still = replace(spring(OUTSIDE, default=default), field={x: 0 * x, v: 0 * x})
        verdict = prove(still, Identity("zero", x, level=((a + 2) * x,)))
        assert verdict.decision == "refuted"
        assert verdict.witness["point"]["a"] == "-2"
        assert prove(still, Identity("zero", x, level=(a * x,))).decision == "proven"


def test_a_certificate_for_each_range():
    verdict = prove_with_certificate(spring(OUTSIDE), ENERGY)
    assert verdict.decision == "proven"
    assert verdict.in_ranges
    assert len(verdict.identities) == 2
    for part in verdict.identities:
        check(part)


def test_defaults_lie_in_the_ranges():
    defaults = [each.parameters[0].default for each in ranges_of_parameters(spring(OUTSIDE))]
    assert sorted(default > 0 for default in defaults) == [False, True]
    assert all(abs(default) > 1 for default in defaults)


def test_ranges_that_contradict_each_other_are_left_out():
    further = Parameter(b, "", 2.0, admissible=(sp.Or(b > 0, a > 2),))
    system = spring(sp.And(OUTSIDE, a < 5))
    verdict = prove_with_certificate(
        replace(system, parameters=(*system.parameters, further)), ENERGY
    )
    assert verdict.decision == "proven"
    # a < −1 with b > 0, 1 < a < 5 with b > 0, and 2 < a < 5
    assert len(verdict.identities) == 3
    assert not verdict.no_certificate


@pytest.mark.parametrize(
    "condition", [sp.Contains(a, sp.S.Integers), a + 1, sp.Symbol("b") & OUTSIDE]
)
def test_what_is_no_condition_is_refused(condition):
    with pytest.raises(InputError, match="admissible must be a tuple of relations"):
        spring(condition)


@pytest.mark.parametrize("wide", [sp.Or(a >= 1, a <= -1), sp.Not(sp.And(a > -1, a < 1))])
def test_a_motion_has_parameters_of_a_range(wide):
    system = spring(wide)
    for value in (-1.0, 1.0, 3.0):
        assert integrate(system, [1.0, 0.0], [0.0, 0.1], parameters={"a": value}).states.shape
    with pytest.raises(InputError, match=r"a = 0.5 is not admissible; \(a >= 1\) or \(a <= -1\)"):
        integrate(system, [1.0, 0.0], [0.0, 0.1], parameters={"a": 0.5})


def test_a_condition_on_what_is_no_parameter():
    with pytest.raises(InputError, match="the condition a > b on a uses b, which is no parameter"):
        integrate(spring(a > b), [1.0, 0.0], [0.0, 0.1], parameters={"a": 3.0})


def onto(constant, *own):
    """x′ = v, v′ = −a x with a > 0 as the image of x′ = v, v′ = −c x."""
    target = System("target", "Target", {x: v, v: -a * x}, (Parameter(a, "", 1.0, "", (a > 0,)),))
    parameters = (Parameter(b, "", 2.0, "", own),)
    system = System("source", "Source", {x: v, v: -constant * x}, parameters)
    return system, Isomorphism("same", target, {x: x, v: v}, constants={a: constant})


def test_parameters_of_a_target_are_admissible():
    assert prove(*onto(b, b > 0)).decision == "proven"
    assert prove(*onto(1 + b**2)).decision == "proven"
    verdict = prove(*onto(b))
    assert (verdict.decision, verdict.conditions) == ("proven where", ("b > 0",))


def test_a_target_with_several_ranges():
    system, law = onto(b, OUTSIDE.xreplace({a: b}))
    ranged = replace(law.target.parameters[0], default=2.0, admissible=(OUTSIDE,))
    law = replace(law, target=replace(law.target, parameters=(ranged,)))
    verdict = prove_with_certificate(system, law)
    assert verdict.decision == "proven"
    assert len(verdict.identities) == 2
    for part in verdict.identities:
        check(part)
        changed = copy.deepcopy(part)
        changed["claim"]["law"]["target"]["admissible"] = ["(a > 1000) | (a < -1000)"]
        with pytest.raises(CheckError, match="parameters of the target are not admissible"):
            check(changed)
    free = replace(system, parameters=(replace(system.parameters[0], admissible=()),))
    assert prove(free, law).statement == "proven where b < −1 or b > 1"


def test_a_target_that_does_not_exist():
    with pytest.raises(InputError, match=r"nothing: the parameters that it gives its target"):
        prove(*onto(-1 - b**2))


def test_the_check_of_certificates_asks_the_same():
    certificate = prove_with_certificate(*onto(b, b > 0)).certificate
    check(certificate)
    changed = copy.deepcopy(certificate)
    changed["claim"]["law"]["target"]["admissible"] = ["a < 0"]
    with pytest.raises(CheckError, match="parameters of the target are not admissible"):
        check(changed)
