"""A certificate in which any single datum is changed does not check, unless it still holds.

What still holds is listed for every example, as patterns of the datum and of its change.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from typing import Any

import pytest

from certificate_checker import BadInputError, CheckError, check
from checker import examples
from checker.corrupted import corrupted, meaning, put

#: Any number times nothing is nothing.
TIMES_NOTHING = r".*\.constant (one more|negated)"
#: Another point of the same level.
POINT = r"sample\..*"

#: Changes that leave a certificate valid: the claim stays true and its proof a proof of it.
VALID: dict[str, tuple[str, ...]] = {
    "oscillator": (r"claim\.law\.value one more", r".*ring.*", TIMES_NOTHING, POINT),
    "area": (r"claim\.law\.value one more", r".*ring\.[678] .*", r"sample\.(x|J_\d|m) .*"),
    "product_of_two": (r"claim.*state.* exchanged", r".*ring.*", r"sample\.y .*"),
    # the rate of x does not matter, since √(x² …)/x does not depend on it but for its sign; what
    # stands below a residual that vanishes identically does not either
    "root": (
        r"claim\.system\.rates\.0 .*",
        r"claim\.law\.value (one more|negated)",
        r".*\.signs\.0\.0\.0\.0 one more",
        r".*\.divisors\.0 removed",
        r".*\.divisors\.1\.factors\.0\.0\.0\.0 negated",
        r".*\.residuals\.0\.denominator.*",
        r"sample\.x negated",
        r"sample\.y one more",
    ),
    "squares": (
        r"claim.*state.* exchanged",
        r".*\.positive\.0\.poly\.0\.0 one more",
        r".*\.terms\.1\.2\.0\.0\.0 negated",
        r"sample\.a one more",
    ),
    "vanishing": (r".*\.tree\.zero\.polynomial\..*", r"sample\.a .*"),
    "empty": (r"claim.*state.* exchanged", r"sample\.y .*"),
    "somewhere": (r"claim.*state.* exchanged", r"sample\.y .*", r"conditions\.0 doubled"),
    "inertia": (
        r"claim\.system\.rates\.0 negated",
        r"claim\.law\.on.*(doubled|exchanged)",
        r"claim\.law\.value .*",
        r".*ring\.2 exchanged",
        r".*zeros\.0 doubled",
        r".*divisors.*(removed|list)",
        TIMES_NOTHING,
        POINT,
    ),
    "inverse": (
        r"claim\.system\.rates\.0 one more",
        r"claim\.system\.definitions\.\d+ exchanged",
        r".*ring.*",
        r".*exchanged\.\d exchanged",
        r".*inverted\.0 doubled",
        TIMES_NOTHING,
        POINT,
    ),
    # both auxiliary symbols share their angle, which may be any
    "circle": (
        r"claim\.law\.value\.. .*",
        r".*ring.*",
        r".*auxiliary\.\d\.1\.of\.numerator.*",
        r".*auxiliary\.0 exchanged",
        POINT,
    ),
    "potential": (
        r"claim\.law\.value\.0 negated",
        r".*ring.*",
        r".*auxiliary\.2\..*",
        r".*auxiliary\.[01] exchanged",
        r"sample\.p .*",
    ),
    # the power cancels, so that its symbol is not needed; 2 x > 0 says as much as x > 0, and that x
    # is no zero
    "power": (
        r".*divisors.*(removed|list)",
        r".*\.positive\.0\.poly\.0\.0 one more",
        r"claim\.system\.rates\.0 negated",
        r"claim\.law\.density\.0\.0 negated",
        r".*auxiliary.*",
        TIMES_NOTHING,
        POINT,
    ),
    "sphere": (r".*ring\.1 exchanged", r".*divisors.*(removed|list)", r"sample\.[yz] negated"),
    "bracket": (
        r".*hamiltonian one more",
        r".*casimirs\.0 one more",
        r".*rank replaced by none",
        r".*ring.*",
        TIMES_NOTHING,
        POINT,
    ),
    "carried": (
        r"claim\.system\.admissible.*",
        r"claim\.law\.map\.0 exchanged",
        r".*ring.*",
        TIMES_NOTHING,
        POINT,
    ),
    "reduced": (
        r".*quantities\.1\.1 one more",
        r".*equations\.\d exchanged",
        r".*divisors.*(removed|list|negated)",
        TIMES_NOTHING,
        POINT,
    ),
    "symmetry": (
        r"claim\.law\.field.* (exchanged|replaced by a list)",
        r".*ring.*",
        r"sample.* negated",
    ),
    "rational_witness": (r"claim\.system\.guards.*", r"claim\.law\.value one more"),
    # another motion and other roots, for which the residual is the same
    "algebraic_witness": (
        r"claim\.system\.rates\.1 .*",
        r"claim\.system\.relations\.0 exchanged",
        r"claim\.law\.value one more",
        r".*x\.root\.poly\.ring\.0 exchanged",
        r".*x\.root\.near negated",
    ),
}

FEW = 20


def survivors(certificate: Any, changes: Any) -> list[str]:
    """Changes after which a certificate of another meaning still checks."""
    whole = meaning(certificate)
    found = []
    for path, how, value in changes:
        changed = put(certificate, path, how, value)
        if meaning(changed) == whole:
            continue
        try:
            check(changed)
        except (CheckError, BadInputError) as error:
            assert str(error).strip() and "\n" not in str(error)
        else:
            found.append(f"{'.'.join(map(str, path))} {how}")
    return found


def unexpected(name: str, found: list[str]) -> list[str]:
    return [f for f in found if not any(re.fullmatch(p, f) for p in VALID[name])]


@pytest.mark.parametrize("example", examples.ALL, ids=lambda e: e.__name__)
def test_some_single_changes(example: Callable[[], Any]) -> None:
    certificate = example()
    changes = list(corrupted(certificate))
    chosen = random.Random(example.__name__).sample(changes, FEW)
    assert not unexpected(example.__name__, survivors(certificate, chosen))


@pytest.mark.slow
@pytest.mark.parametrize("example", examples.ALL, ids=lambda e: e.__name__)
def test_every_single_change(example: Callable[[], Any]) -> None:
    certificate = example()
    found = survivors(certificate, corrupted(certificate))
    assert not unexpected(example.__name__, found)
    # every pattern is met, so that the list says no more than it must
    for pattern in VALID[example.__name__]:
        assert any(re.fullmatch(pattern, f) for f in found), pattern
