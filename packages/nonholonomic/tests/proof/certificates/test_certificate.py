"""What is proven or refuted has a certificate that checks, and one that was changed does not."""

from __future__ import annotations

import json
import random
import re
from typing import Any

import pytest
import sympy as sp

from certificate_checker import BadInputError, CheckError, check
from checker.corrupted import corrupted, put
from flowlanes.system.laws import Identity, Integral, Law, Measure, Rate, Separation
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.certificates.certificate import prove_with_certificate
from nonholonomic.catalogue import from_catalogue
from proof.test_prover import FAR, RIGHT, TOP, WRONG

Certificate = dict[str, Any]

x, y, z, a, k, w = map(real_symbol, ("x", "y", "z", "a", "k", "w"))
q = real_symbol("q")
POSITIVE = (Parameter(a, "", 2.0, admissible=(a > 0,)),)

#: Refuted by dimensions, which no single point shows.
BY_RANK = {"rank too large", "map that loses dimensions"}
#: Their kind is not decided.
OPEN = {"separation"}


@pytest.fixture(autouse=True, scope="module")
def own_cache(tmp_path_factory):
    """Verdicts of these tests are kept for the tests of this module alone."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FLOWLANES_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield


def certificate(system: System, law: Law) -> Certificate:
    """A certificate as another program reads it."""
    verdict = prove_with_certificate(system, law)
    assert verdict.certificate is not None, verdict.no_certificate
    made: Certificate = json.loads(json.dumps(verdict.certificate))
    assert made["verdict"] == verdict.decision
    return made


@pytest.mark.parametrize("name", sorted(set(RIGHT) - OPEN))
def test_right_laws_have_certificates(name):
    check(certificate(TOP, RIGHT[name]))


@pytest.mark.parametrize("name", sorted(set(WRONG) - BY_RANK - OPEN))
def test_wrong_laws_have_a_witness(name):
    made = certificate(TOP, WRONG[name])
    assert made["verdict"] == "refuted"
    assert set(made["witness"]["point"]) == {*map(str, TOP.symbols), *map(str, TOP.defaults)}
    check(made)


@pytest.mark.parametrize("name", sorted(BY_RANK))
def test_a_dimension_has_no_witness(name):
    verdict = prove_with_certificate(TOP, WRONG[name])
    assert verdict.decision == "refuted"
    assert verdict.certificate is None
    assert "a dimension on the whole level" in verdict.no_certificate


def test_a_separation_has_one():
    system = System("two", "Two", field={x: a * x, y: y}, parameters=POSITIVE)
    law = Separation("law", {}, (Rate(x) - a * x, Rate(y) - y))
    verdict = prove_with_certificate(system, law)
    assert verdict.decision == "proven", verdict
    assert verdict.no_certificate == ""
    check(verdict.certificate)


def test_what_is_undecided_has_no_certificate():
    verdict = prove_with_certificate(TOP, FAR["an exponent that moves"][0])
    assert verdict.decision == "undecided"
    assert verdict.certificate is None
    assert verdict.no_certificate == ""


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["chaplygin-sleigh", "rubber-ball-of-ratio", "veselova-spinning", "marble-ball-on-cone"]
)
def test_systems_of_the_catalogue(name):
    system = from_catalogue(name)
    for law in system.laws:
        verdict = prove_with_certificate(system, law)
        if verdict.decision == "proven":
            assert verdict.certificate is not None, verdict.no_certificate


@pytest.mark.slow
def test_a_law_by_a_theorem_has_the_certificates_of_its_identities():
    system = from_catalogue("veselova-nd", dimension=4)
    verdict = prove_with_certificate(system, next(x for x in system.laws if x.name == "measure"))
    assert verdict.certificate is None
    assert verdict.no_certificate
    (identity,) = verdict.identities
    check(identity)


# --- each means of a proof -----------------------------------------------------------------------


def still(*symbols: sp.Symbol, **more: Any) -> System:
    """A system in which the given variables do not move."""
    return System("still", "Still", field=dict.fromkeys(symbols, sp.S.Zero), **more)


MEANS = {
    "a level of two components": (still(x, y, relations=(x * y,)), Identity("law", x**2 * y)),
    "a power of a factor": (still(x, y, relations=(x**2 * y**3,)), Identity("law", x * y)),
    "squares": (
        still(x, y, parameters=POSITIVE, relations=(a * x**2 + 2 * y**2,)),
        Identity("law", x + y),
    ),
    "an initial that may vanish": (
        still(x, y, z, relations=(x * z - y, y * z - x)),
        Identity("law", (x - y) * (x + y)),
    ),
    "a divisor that vanishes on a part": (
        still(x, y, relations=(x * y,)),
        Identity("law", x / y + x / (1 + x**2)),
    ),
    "a function in a condition": (
        System(
            "wave", "Wave", field={x: y, y: sp.S.Zero, z: y * sp.cos(x)}, relations=(z - sp.sin(x),)
        ),
        Identity("law", z**2 + sp.cos(x) ** 2 - 1),
    ),
    "a product with a function": (
        still(x, y, relations=(y * sp.sin(x),)),
        Identity("law", y * sp.sin(2 * x)),
    ),
    "a root without a sign": (
        System("grown", "Grown", field={x: x, y: sp.S.Zero}, definitions={q: x**2 * (1 + y**2)}),
        Integral("law", sp.sqrt(q) / x),
    ),
    "a power of what is 1": (
        still(x, y, parameters=(Parameter(k, "", 0.5),), relations=(x**2 + y**2 - 1,)),
        Identity("law", (x**2 + y**2) ** k - 1),
    ),
    "one function at two places": (
        still(x, y, relations=(x - y,)),
        Identity("law", sp.Function("f")(x) - sp.Function("f")(y)),
    ),
    "what is positive as a sum": (
        System("sum", "Sum", field={x: y, y: -x}, parameters=POSITIVE),
        Measure("law", {a * (x**2 + y**2) + 1: sp.Rational(1, 2)}),
    ),
    "a level of two relations": (
        System(
            "turn", "Turn", field={x: -y, y: x, z: sp.S.Zero}, relations=(x**2 + y**2 + z**2 - 1, z)
        ),
        Measure("law", {sp.S.One: 1}),
    ),
}


@pytest.mark.parametrize("name", MEANS)
def test_means_of_a_proof(name):
    system, law = MEANS[name]
    made = certificate(system, law)
    assert made["verdict"] == "proven"
    check(made)


def test_proven_where_a_sign_is_as_asked():
    system = System(
        "side",
        "Side",
        field={x: x, y: sp.S.Zero},
        definitions={q: x**2 * (1 + y**2)},
        parameters=(Parameter(a, "", 1.0),),
        guards=(),
    )
    made = prove_with_certificate(system, Identity("law", sp.sqrt(q) - x * sp.sqrt(1 + y**2)))
    assert made.decision == "refuted"
    assert made.certificate is not None
    check(made.certificate)


# --- changes -------------------------------------------------------------------------------------

#: Coefficients of which each matters.
COEFFICIENT = re.compile(
    r"proofs\.\d+\.(residuals\.\d+\.numerator|equations\.\d+\.poly)\.\d+\.0"
    r"|proofs\.\d+\.tree\..*quotients\.\d+\.\d+\.0"
)


def spoilt(made: Certificate, count: int) -> list[Certificate]:
    """Certificates with one wrong coefficient each."""
    found = []
    for path, how, value in corrupted(made):
        if how in ("one more", "negated") and COEFFICIENT.fullmatch(".".join(map(str, path))):
            found.append((path, how, value))
    random.Random(7).shuffle(found)
    return [put(made, *change) for change in found[:count]]


def rejected(made: Certificate) -> bool:
    try:
        check(made)
    except (BadInputError, CheckError):
        return True
    return False


@pytest.mark.parametrize("name", ["a level of two components", "a function in a condition"])
def test_a_wrong_coefficient_is_noticed(name):
    made = certificate(*MEANS[name])
    changed = spoilt(made, 20)
    assert len(changed) >= 4
    assert all(map(rejected, changed))


@pytest.mark.slow
def test_every_wrong_coefficient_is_noticed():
    count = 0
    for name in ("veselova", "veselova-bruns", "rubber-ball-of-ratio", "disk-on-ice"):
        system = from_catalogue(name)
        for law in system.integrals:
            for changed in spoilt(certificate(system, law), 300):
                count += 1
                assert rejected(changed), law.name
    assert count >= 1000


def rejected_after(made: Certificate, change: Any) -> bool:
    """Whether a certificate does not check after its first proof was changed."""
    spoilt_one = json.loads(json.dumps(made))
    change(spoilt_one["proofs"][0])
    return rejected(spoilt_one)


def of_kind(proof: Certificate, kind: str) -> Any:
    return next(meaning for _, meaning in proof["auxiliary"] if meaning["kind"] == kind)


def test_a_formal_root_needs_its_radicand() -> None:
    made = certificate(*MEANS["a root without a sign"])
    assert of_kind(made["proofs"][0], "formal root")["whole"]
    assert rejected_after(made, lambda p: of_kind(p, "formal root").update(degree=3))
    assert rejected_after(made, lambda p: of_kind(p, "formal root").update(kind="root"))
    assert rejected_after(made, lambda p: p.update(divisors=[]))


def test_equal_values_need_equal_arguments() -> None:
    made = certificate(*MEANS["one function at two places"])
    number = next(
        i for i, e in enumerate(made["proofs"][0]["equations"]) if e["from"].startswith("same")
    )
    assert rejected_after(made, lambda p: p["equations"][number].update(quotients=[[[]]]))
    assert rejected_after(made, lambda p: p["equations"][number].pop("quotients"))


def test_a_sum_needs_positive_terms() -> None:
    made = certificate(*MEANS["what is positive as a sum"])
    sums = [p for p in made["proofs"][0]["positive"] if p["from"] == "sum"]
    assert sums
    assert rejected_after(
        made,
        lambda p: next(s for s in p["positive"] if s["from"] == "sum")["terms"][0].__setitem__(
            1, "-1"
        ),
    )
    assert rejected_after(
        made, lambda p: p.update(positive=[s for s in p["positive"] if s["from"] != "a > 0"])
    )


def test_a_witness_elsewhere_is_noticed():
    made = certificate(TOP, WRONG["no integral"])
    for name in made["witness"]["point"]:
        changed = put(made, ("witness", "point", name), "replaced", "1/7")
        assert rejected(changed)
