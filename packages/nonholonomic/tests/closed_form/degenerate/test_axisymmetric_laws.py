"""Constants and equations of bodies of revolution, proven; with another sign, refuted."""

from __future__ import annotations

from dataclasses import replace

import pytest

from closed_form.degenerate.axisymmetric_laws import chaplygin_laws, veselova_laws
from flowlanes.system.laws import Integral, Reduction
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue

LAWS = {
    f"{name}-{law.name}": (name, law)
    for name, laws in (("veselova", veselova_laws()), ("chaplygin-ball", chaplygin_laws()))
    for law in laws
}


@pytest.mark.parametrize("key", LAWS)
def test_proven(key: str) -> None:
    name, law = LAWS[key]
    assert prove(from_catalogue(name), law).decision == "proven"


@pytest.mark.parametrize("key", LAWS)
def test_not_for_any_moments(key: str) -> None:
    name, law = LAWS[key]
    assert prove(from_catalogue(name), replace(law, level=())).decision == "refuted"


@pytest.mark.parametrize("key", [key for key, (_, law) in LAWS.items() if key.endswith("nutation")])
def test_a_slip_is_refuted(key: str) -> None:
    name, law = LAWS[key]
    assert isinstance(law, Reduction)
    assert not isinstance(law, Integral)
    slip = replace(law, equations=(law.equations[0] + law.quantities[0][0], *law.equations[1:]))
    assert prove(from_catalogue(name), slip).decision == "refuted"
