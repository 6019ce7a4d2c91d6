"""The certificate of the theorem on energy: it checks, and none that says something else does."""

from __future__ import annotations

import json
import random
from collections.abc import Iterator
from copy import deepcopy
from functools import cache
from typing import Any

import pytest
import sympy as sp

import flowlanes
import lawproof
import nonholonomic
from certificate_checker import BadInputError, CheckError, check
from checker.corrupted import corrupted, put
from flowlanes.system import real_symbol

x, z, xdot, zdot, k = map(real_symbol, ["x", "z", "xdot", "zdot", "k"])


@cache
def _certificate() -> str:
    """A particle on a spring with a constraint that is solved for no velocity."""
    mechanism = nonholonomic.Mechanism(
        "particle",
        nonholonomic.coordinates(x, z),
        (xdot**2 + 2 * zdot**2 - k * x**2 - z**2) / 2,
        constraints=((1 + x**2) * zdot - x * xdot,),
        parameters=(flowlanes.Parameter(k, "stiffness", 2.0),),
    )
    system = nonholonomic.equations_of_motion(mechanism)
    verdict = lawproof.proof.prove_with_certificate(system, system.laws[0])
    assert verdict.certificate is not None and "rates" in verdict.certificate
    return json.dumps(verdict.certificate)


def certificate() -> dict[str, Any]:
    made: dict[str, Any] = json.loads(_certificate())
    return made


def test_it_checks() -> None:
    check(certificate())


def _refused(changed: Any) -> str:
    with pytest.raises((CheckError, BadInputError)) as refusal:
        check(changed)
    return str(refusal.value)


def test_another_law_or_equation_does_not_check() -> None:
    for part, key, added in (
        ("law", "value", " + 1/1000000*x"),
        ("law", "value", " + xdot**2/2"),
    ):
        made = certificate()
        made["claim"][part][key] += added
        assert "residual" in _refused(made)
    for rate in (2, 3):
        made = certificate()
        made["claim"]["system"]["rates"][rate] += " - zdot/1000000000"
        assert "residual" in _refused(made)


def test_every_relation_must_be_kept() -> None:
    made = certificate()
    made["claim"]["system"]["relations"].append("x - z")
    made["sample"]["z"] = made["sample"]["x"]
    _refused(made)
    made = certificate()
    made["rates"]["positions"] = [[0, None]]
    assert "residual" in _refused(made)
    made = certificate()
    made["rates"]["constraints"] = [3]
    assert "integer from 0 to 0" in _refused(made)


def test_a_level_or_another_kind_of_law_is_refused() -> None:
    made = certificate()
    made["claim"]["law"]["on"] = ["0*x"]
    assert "whole phase space" in _refused(made)
    made = certificate()
    made["claim"]["law"] = {
        "kind": "Identity", "name": "energy", "on": [], "quantities": [], "value": ["x"],
    }  # fmt: skip
    assert "prove integrals" in _refused(made)


def test_a_verdict_with_conditions_is_refused() -> None:
    made = certificate()
    made |= {"verdict": "proven where", "conditions": ["x > 0"]}
    _refused(made)


def test_a_divisor_of_its_own_is_refused() -> None:
    """λ may not be 1/0 where the equations are defined."""
    made = certificate()
    made["rates"]["multipliers"][0] += " + 1/(x - 17) - 1/(x - 17)"
    assert "not defined wherever the law is" in _refused(made)


def test_names_may_not_be_taken_twice() -> None:
    for key, names in (
        ("accelerations", ["x", "zdot_rate"]),
        ("velocities", ["xdot", "xdot"]),
        ("velocities", ["xdot", "k"]),
        ("definitions", [["x", "z"]]),
    ):
        made = certificate()
        made["rates"][key] = names
        _refused(made)


def _changes() -> Iterator[tuple[str, Any]]:
    whole = certificate()
    for path, how, value in corrupted(whole):
        if path[0] in ("claim", "rates"):
            yield f"{'.'.join(map(str, path))} {how}", put(deepcopy(whole), path, how, value)


#: What changes nothing: another name, a constant beside the energy, minus nothing, the definition
#: of a multiplier that no rate uses.
HARMLESS = (
    "name", "law.value one more", "parameters", "accelerations", "opaque", "admissible", "guards",
    "definitions.1", "mass.0.1 negated", "mass.1.0 negated", "constraints.0 negated",
)  # fmt: skip


def _survivors(changes: list[tuple[str, Any]]) -> list[str]:
    found = []
    for words, changed in changes:
        try:
            check(changed)
        except (CheckError, BadInputError) as error:
            assert str(error).strip() and "\n" not in str(error)
        else:
            found.append(words)
    return [words for words in found if not any(part in words for part in HARMLESS)]


def test_some_single_changes() -> None:
    assert _survivors(random.Random(19).sample(list(_changes()), 40)) == []


@pytest.mark.slow
def test_every_single_change() -> None:
    assert _survivors(list(_changes())) == []


def test_parts_of_another_certificate_do_not_serve() -> None:
    made = certificate()
    made["identities"]["power"], made["identities"]["solution"] = (
        made["identities"]["solution"],
        made["identities"]["power"],
    )
    _refused(made)
    made = certificate()
    del made["identities"]["solution"]
    assert "lacks the field 'solution'" in _refused(made)


def test_the_text_of_sympy_and_of_the_check_agree_on_cancelled_names() -> None:
    """A row that cancels names its variables nevertheless."""
    u, v = real_symbol("u"), real_symbol("v")
    flat = nonholonomic.Mechanism(
        "flat",
        nonholonomic.Frame({x: u * sp.cos(z), z: v}, (u, v)),
        (u**2 + v**2) / 2 - sp.cos(z),
    )
    system = nonholonomic.equations_of_motion(flat)
    verdict = lawproof.proof.prove_with_certificate(system, system.laws[0])
    assert verdict.certificate is not None
    check(verdict.certificate)
