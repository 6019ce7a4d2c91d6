"""Separations: the check sees by itself whether equations separate."""

from __future__ import annotations

import copy

import pytest
import sympy as sp

from certificate_checker import CheckError, check
from flowlanes.system.laws import Rate, Separation
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.certificates.certificate import prove_with_certificate

x, y, c, u, v = (real_symbol(name) for name in ("x", "y", "c", "u", "v"))


def oscillators() -> System:
    """ẋ = (x + y)(1 + x), ẏ = (x + y) y, and a constant."""
    return System(
        name="separated",
        title="Two equations with a factor in common",
        field={x: (x + y) * (1 + x), y: (x + y) * y, c: sp.S.Zero},
        guards=(),
    )


def separation() -> Separation:
    return Separation(
        "separation",
        (),
        (Rate(x) ** 2 - (x + y) ** 2 * (1 + x) ** 2, Rate(y) - (x + y) * y, Rate(c)),
    )


def certificate():
    verdict = prove_with_certificate(oscillators(), separation())
    assert verdict.decision == "proven"
    assert verdict.no_certificate == ""
    return verdict.certificate


def test_a_separation_has_a_certificate_that_checks():
    check(certificate())


def with_equations(certificate, *equations):
    changed = copy.deepcopy(certificate)
    changed["claim"]["law"]["equations"] = list(equations)
    return changed


@pytest.mark.parametrize(
    ("equations", "why"),
    [
        (
            ("Rate(x)**2 - (x + y)**2*(x*y + 1)**2", "Rate(y) - (x + y)*y", "Rate(c)"),
            "the rates of x and y do not separate",
        ),
        (
            ("Rate(x)**2 - (x + y)**2*(1 + x)**2", "Rate(y) - y", "Rate(c)"),
            "the rates of x and y do not separate",
        ),
        (
            ("Rate(x) - (x + y)*(1 + x)*c", "Rate(y) - (x + y)*y"),
            "the rates of x and y do not separate",
        ),
        (("Rate(x) - (x + y)*(1 + x)", "Rate(c)"), "a separation has two quantities or more"),
        (
            ("Rate(x) - Rate(y)", "Rate(y) - (x + y)*y", "Rate(c)"),
            "equation 1 of the separation does not contain exactly one rate",
        ),
        (
            ("Rate(x)**3 - (x + y)", "Rate(y) - (x + y)*y", "Rate(c)"),
            "the equation of x gives neither its rate nor the square of it",
        ),
        (
            ("Rate(x)*(x + y)", "Rate(y) - (x + y)*y", "Rate(c)"),
            "the equation of x says that it is constant",
        ),
        (
            ("Rate(x) - sin(x)", "Rate(y) - (x + y)*y", "Rate(c)"),
            "the equation of x is not rational",
        ),
        (
            ("Rate(x) - 1", "Rate(x) - (x + y)*y", "Rate(c)"),
            "x has two equations in the separation",
        ),
    ],
)
def test_what_does_not_separate_is_rejected(equations, why):
    with pytest.raises(CheckError, match=why):
        check(with_equations(certificate(), *equations))


def test_dependent_quantities_are_rejected():
    """u and v separate, but both are functions of x: the sample shows no independence."""
    law = Separation(
        "separation",
        {u: x, v: 2 * x},
        (Rate(u) - (x + y) * (1 + u), Rate(v) - (x + y) * (2 + v)),
    )
    verdict = prove_with_certificate(oscillators(), law)
    assert verdict.decision != "proven"
    changed = copy.deepcopy(certificate())
    changed["claim"]["law"]["quantities"] = [["u", "x"], ["v", "2*x"]]
    changed["claim"]["law"]["equations"] = [
        "Rate(u) - (x + y)*(1 + u)",
        "Rate(v) - (x + y)*(2 + v)",
    ]
    with pytest.raises(CheckError, match="at the sample the rank is not the stated one"):
        check(changed)
