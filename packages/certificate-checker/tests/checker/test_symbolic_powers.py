"""Certificates of laws with symbolic powers and absolute values: none leaves a sign open."""

from __future__ import annotations

from typing import Any

import pytest

from certificate_checker import CheckError, check
from checker.made import (
    divisor,
    identity,
    law,
    poly,
    proof,
    proven,
    refuted,
    residual,
    system,
    zero,
)

Certificate = dict[str, Any]
GUARDED = {"guards": ["x"]}
POSITIVE = {"strict": True, "from": "x"}


def square_of_a_power(value: str, above: str, divisors: list[Any], **more: Any) -> Certificate:
    """A law of x^a and its square, as if x were positive; `more` is said of the system."""
    ring = ["aux0", "x", "a"]
    power = {"kind": "power", "of": poly("x", ring), "exponent": "a", "fineness": 1}
    claim = {
        "system": system({"x": "1"}, parameters=["a"], admissible=["a > 0"], **more),
        "law": law("Identity", value=[value]),
    }
    made = proof(
        ring,
        auxiliary=[["aux0", power]],
        divisors=[divisor(formula, factors, ring) for formula, factors in divisors],
        positive=[{"poly": poly("x", ring), **POSITIVE}] if more else [],
        residuals=[residual(above, [], ring)],
        tree=zero(identity(0, [], ring)),
    )
    return proven(claim, made, sample={"x": "2", "a": "1/3"})


FALSE = {
    "a square": ("(x**2)**a - x**(2*a)", "0", [("x**2", [("x", 2)]), ("x", [("x", 1)])]),
    "half the exponent": ("(x**2)**(a/2) - x**a", "0", [("x**2", [("x", 2)]), ("x", [("x", 1)])]),
    "half more": (
        "(x**2)**(a + 1/2) - x*(x**2)**a",
        "aux0**2*x - x*aux0**2",
        [("x**2", [("x", 2)])],
    ),
}


@pytest.mark.parametrize("name", FALSE)
def test_a_base_must_be_positive(name: str) -> None:
    value, above, divisors = FALSE[name]
    check(square_of_a_power(value, above, divisors, **GUARDED))
    with pytest.raises(CheckError, match=r"may be negative|leaves open|may vanish"):
        check(square_of_a_power(value, above, divisors))


@pytest.mark.parametrize("name", FALSE)
def test_a_sign_that_is_assumed_must_be_a_condition(name: str) -> None:
    certificate = square_of_a_power(*FALSE[name])
    (made,) = certificate["proofs"]
    ring = made["ring"]
    made["signs"] = [[poly("x", ring), 1]]
    with pytest.raises(CheckError, match="do not cover all signs"):
        check(certificate)
    check({**certificate, "verdict": "proven where", "conditions": ["x > 0"]})
    with pytest.raises(CheckError, match="do not cover all signs"):
        check({**certificate, "verdict": "proven where", "conditions": ["x + 1 > 0"]})


def test_a_negative_base_has_no_proof() -> None:
    certificate = square_of_a_power(*FALSE["a square"])
    (made,) = certificate["proofs"]
    ring = made["ring"]
    mirrored = {"kind": "power", "of": poly("-x", ring), "exponent": "a", "fineness": 1}
    certificate["proofs"] = [
        {**made, "signs": [[poly("x", ring), 1]]},
        {**made, "signs": [[poly("x", ring), -1]], "auxiliary": [["aux0", mirrored]]},
    ]
    with pytest.raises(CheckError, match="a power of the law is none of factors with known signs"):
        check(certificate)


def test_whole_exponents_allow_negative_bases_but_not_zero() -> None:
    claim = square_of_a_power(*FALSE["a square"])["claim"]
    check(refuted(claim, point={"x": "-1", "a": "1/2"}, what="", index=0, residual="2"))
    claim["law"]["value"] = ["x**a - 1"]
    check(refuted(claim, point={"x": "-3", "a": "2"}, what="", index=0, residual="8"))
    with pytest.raises(CheckError, match="not certainly defined"):
        check(refuted(claim, point={"x": "0", "a": "2"}, what="", index=0, residual="-1"))


def absolute_value() -> Certificate:
    """|x| sign x = x, for both signs of x."""
    ring = ["x"]
    claim = {"system": system({"x": "1"}), "law": law("Identity", value=["Abs(x)*sign(x) - x"])}
    proofs = [
        proof(
            ring,
            signs=[[poly("x", ring), sign]],
            divisors=[divisor("x**2", [("x", 2)], ring)],
            residuals=[residual("0", [], ring)],
            tree=zero(identity(0, [], ring)),
        )
        for sign in (1, -1)
    ]
    return proven(claim, *proofs, sample={"x": "-1"})


def test_an_absolute_value_has_a_proof_for_each_sign() -> None:
    check(absolute_value())
    certificate = absolute_value()
    del certificate["proofs"][1]
    with pytest.raises(CheckError, match="do not cover all signs"):
        check(certificate)


def test_an_absolute_value_is_not_its_argument() -> None:
    certificate = absolute_value()
    certificate["claim"]["law"]["value"] = ["Abs(x) - x"]
    with pytest.raises(CheckError, match="residual 0 is not that of the law"):
        check(certificate)
    del certificate["proofs"][1]
    with pytest.raises(CheckError, match="do not cover all signs"):
        check(certificate)


def test_maxima_are_read_as_absolute_values() -> None:
    claim = {
        "system": system({"x": "1"}),
        "law": law("Identity", value=["Max(x, -x, 3) + Min(x, -x, -3)"]),
    }
    with pytest.raises(CheckError, match="not certainly different"):
        check(refuted(claim, point={"x": "1"}, what="", index=0, residual="0"))
    claim["law"]["value"] = ["Max(x, -x, 3) - 4"]
    check(refuted(claim, point={"x": "-5"}, what="", index=0, residual="1"))
