"""Claims that differ from true ones by very little have no certificate."""

from __future__ import annotations

import datetime
import random
import re
from collections.abc import Callable
from copy import deepcopy
from typing import Any

import pytest

from certificate_checker import BadInputError, CheckError, check
from checker import examples
from checker.corrupted import meaning
from checker.false_claims import SMALL, TAKEN, forgeries
from checker.made import divisor, equation, identity, poly, powers, proof, residual, zero

Certificate = dict[str, Any]

#: Forgeries that are true, or that say less than the genuine certificate: for each example the
#: places, and why.
TRUE: dict[str, tuple[str, ...]] = {
    # a coordinate that no condition binds may be another one
    "oscillator": (r"point .*", r"formula claim\.law\.value"),
    "area": (r"point sample\.(x|J_\d|m)", r"formula claim\.law\.value"),
    "product_of_two": (r"point sample\.y",),
    # x does not matter for √(x² …)/x, and a factor 1 + ε not for a sign; y stays constant
    "root": (
        r"point sample\.[xy]",
        r"formula claim\.(system\.rates\.0|law\.value)",
        r"coefficient proofs\.\d\.(signs|residuals\.0\.denominator).*",
        r"loss proofs\.\d\.divisors\.0",
    ),
    # a > 0 and (1 + ε) a > 0 say the same
    "squares": (r"point sample\.a", r"coefficient proofs\.0\.positive\.0\.poly.*"),
    "vanishing": (r"point sample\.a", r"coefficient proofs\.0\.tree\.zero\.polynomial.*"),
    "empty": (r"point sample\.y",),
    "somewhere": (r"point sample\.y",),
    # w stays constant where k = −1 and U(r) = 0, so that parameters and w may be added
    "inertia": (
        r"point sample\.[wImr]",
        r"formula claim\.law\.value",
        r"loss proofs\.0\.divisors\.0",
    ),
    "inverse": (r"point sample\..*", r"formula claim\.system\.rates\.0"),
    # the angle of a circle does not matter
    "circle": (r"point sample\.[qp]", r"coefficient proofs\.0\.auxiliary\.\d\.1\.of.*"),
    "potential": (r"point sample\.p", r"coefficient proofs\.0\.auxiliary\.2\.1\.of.*"),
    # the density times a constant; (1 + ε) x > 0 says as much as x > 0, and that x is no zero
    "power": (
        r"loss proofs\.0\.divisors\.0",
        r"coefficient proofs\.0\.positive\.0\.poly.*",
        r"point sample\.[xn]",
        r"formula claim\.law\.density\.0\.0",
        r"coefficient proofs\.0\.auxiliary.*",
    ),
    "sphere": (r"loss proofs\.0\.divisors\.\d",),
    # functions of parameters may be added
    "bracket": (r"point sample\..*", r"formula claim\.law\.(hamiltonian|structure\.casimirs\.0)"),
    # that a frequency is positive is not needed
    "carried": (r"point sample\.[xvw]", r"sign claim\.system\.admissible\.0"),
    "reduced": (
        r"point sample\.[xc]",
        r"formula claim\.law\.quantities\.1\.1",
        r"loss proofs\.0\.divisors\.0",
    ),
    "symmetry": (),
    # another motion or law that fails at the same point, by its stated value to the bits of a ball
    "rational_witness": (
        r"point witness\.point\.[xya]",
        r"formula claim\.(law\.value|system\.(guards|rates)\.\d)",
        r"sign claim\.system\.guards\.0",
        r"power of .*",
    ),
    "algebraic_witness": (
        r"formula claim\.(law\.value|system\.rates\.\d)",
        r"power of .* in claim\.(law\.value|system\..*)",
    ),
}

#: 0 = 0 may be multiplied by any number.
TIMES_NOTHING = r"coefficient .*identities\.\d+\.constant"


def _accepted(example: Callable[[], Certificate], seed: str, count: int) -> list[str]:
    """What is accepted of so many forgeries though it is not known to be true."""
    genuine = example()
    whole, found = meaning(genuine), []
    made = forgeries(genuine, random.Random(f"{example.__name__} {seed}"))
    for _ in range(count):
        label, forged = next(made)
        if meaning(forged) == whole:
            continue
        try:
            check(forged)
        except (CheckError, BadInputError) as error:
            assert str(error).strip() and "\n" not in str(error)
        else:
            patterns = (TIMES_NOTHING, *TRUE[example.__name__])
            if not any(re.fullmatch(pattern, label) for pattern in patterns):
                found.append(label)
    return found


@pytest.mark.parametrize("example", examples.ALL, ids=lambda e: e.__name__)
def test_some_forgeries(example: Callable[[], Certificate]) -> None:
    """Other ones every day; the date is in the message."""
    day = datetime.date.today().isoformat()
    assert not _accepted(example, day, 3), day


@pytest.mark.slow
@pytest.mark.parametrize("example", examples.ALL, ids=lambda e: e.__name__)
def test_two_thousand_forgeries(example: Callable[[], Certificate]) -> None:
    assert not _accepted(example, "all", 2000 // len(examples.ALL) + 1)


@pytest.mark.parametrize("power", SMALL)
def test_a_small_term_in_a_rate(power: int) -> None:
    certificate = examples.oscillator()
    certificate["claim"]["system"]["rates"][1] = f"-k*x + x*v/10**{power}"
    with pytest.raises(CheckError, match="residual 0 is not that of the law"):
        check(certificate)


def test_a_small_term_that_is_proved_is_accepted() -> None:
    certificate = examples.oscillator()
    certificate["claim"]["law"]["value"] = "(v**2/2 + k*x**2/2)/10**400"
    check(certificate)


@pytest.mark.parametrize("word", TAKEN)
def test_names_of_numbers_and_functions_are_taken(word: str) -> None:
    certificate = examples.oscillator()
    certificate["claim"]["system"]["definitions"] = [[word, "3"]]
    with pytest.raises(CheckError, match="means something else in formulas"):
        check(certificate)


def test_pi_is_no_other_number() -> None:
    for value in ("pi - 3", "pi - 355/113", "E - 2", "exp(1) - E + pi/10**400"):
        certificate = examples.empty()
        certificate["claim"]["law"]["value"] = [f"x + 1/y - 1/y + ({value})"]
        with pytest.raises(CheckError):
            check(certificate)


def test_a_power_of_a_square_needs_a_sign() -> None:
    """(x²)^(n/2) is |x|^n, and not x^n."""
    certificate = examples.power()
    certificate["claim"]["system"]["rates"] = ["x*(x**2)**(n/2)"]
    with pytest.raises(CheckError):
        check(certificate)


def test_what_a_proof_assumes_makes_nothing_certain() -> None:
    """√−x is real where x < 0 is assumed; that does not exclude x > 0."""
    certificate = examples.root()
    ring = ["aux1", "aux0", "x", "y"]
    root = {"kind": "root", "degree": 2}
    sum_of_one = {
        "poly": poly("-x", ring),
        "strict": True,
        "from": "sum",
        "terms": [[powers([("aux1", 2)], ring), "1", [poly("1", ring)]]],
        "quotients": [[], poly("-1", ring)],
    }
    certificate["proofs"] = [
        proof(
            ring,
            signs=[[poly("x", ring), -1]],
            auxiliary=[
                ["aux0", {**root, "of": poly("y**2 + 1", ring)}],
                ["aux1", {**root, "of": poly("-x", ring)}],
            ],
            equations=[
                equation("aux0**2 - y**2 - 1", ring, "root aux0"),
                equation("aux1**2 + x", ring, "root aux1"),
            ],
            positive=[sum_of_one],
            divisors=[
                divisor("x", [("x", 1)], ring),
                divisor("x**2*(y**2 + 1)", [("x", 2), ("y**2 + 1", 1)], ring),
            ],
            residuals=[residual("-(aux0**2 - y**2 - 1)", [("aux0", 1)], ring)],
            tree=zero(identity(0, ["-1", "0"], ring)),
        )
    ]
    with pytest.raises(CheckError, match="do not cover all signs"):
        check(certificate)


@pytest.mark.parametrize("relation", ["z - sin(x) + y/10**400", "z - sin(x + 1/10**400)"])
def test_a_witness_lies_on_the_level(relation: str) -> None:
    certificate = examples.algebraic_witness()
    certificate["claim"]["system"]["relations"][1] = relation
    with pytest.raises(CheckError, match="does not satisfy a condition"):
        check(certificate)


def test_a_witness_may_have_angles() -> None:
    """sin 2q at q = atan2(3/5, 4/5)/2 is 3/5."""
    from checker.made import law, refuted, system

    claim = {
        "system": system({"q": "0", "x": "1"}, relations=["sin(2*q) - 3/5"]),
        "law": law("Integral", value="x"),
    }
    point = {"q": {"formula": "atan2(3/5, 4/5)/2"}, "x": "0"}
    made = refuted(claim, point=point, what="v(F)", index=1, residual="1")
    check(made)
    wrong = deepcopy(made)
    wrong["claim"]["system"]["relations"] = ["sin(2*q) - 3/5 + 1/10**400"]
    with pytest.raises(CheckError, match="does not satisfy a condition"):
        check(wrong)
