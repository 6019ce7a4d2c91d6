"""Levels with a part on which a root of the equations vanishes, or factors that hold functions."""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import Identity, Integral, Rate, Reduction, Symmetry
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove

x, y, z, w, k, u = (real_symbol(name) for name in ("x", "y", "z", "w", "k", "u"))
a, b = real_symbol("a"), real_symbol("b")
root = sp.sqrt(w)


def rooted() -> System:
    """√w is zero on one part of the phase space, where it has no derivative."""
    return System(
        name="rooted",
        title="Rooted",
        field={x: root * x, y: sp.S.One, w: root * x},
        relations=(root * x,),
    )


@pytest.mark.parametrize("law", [Reduction("law", {u: y * x}, (Rate(u),)), Identity("law", x)])
def test_a_part_on_which_a_root_vanishes_is_not_passed_over(law):
    verdict = prove(rooted(), law)
    assert verdict.decision == "proven where"
    assert verdict.formulas == ("w != 0",)


@pytest.mark.slow
def test_a_target_with_a_root_that_vanishes():
    free = System(name="free", title="Free", field={x: 0, w: 0, y: 1, z: 0})
    bound = System(
        name="bound", title="Bound", field={x: 0, w: 0, y: 1, z: 0}, relations=(root * x,)
    )
    law = Isomorphism("law", bound, {x: x, w: w, y: y, z: z + y * x}, level=(root * x,))
    verdict = prove(free, law)
    assert verdict.decision == "proven where"
    assert verdict.formulas == ("w != 0",)


def test_a_law_fails_where_the_root_of_its_level_vanishes():
    free = System(name="free", title="Free", field={x: 0, w: 0, y: 1})
    verdict = prove(free, Integral("law", y * x, level=(root * x,)))
    assert verdict.decision == "refuted"
    assert verdict.witness["point"]["w"] == "0"


@pytest.mark.parametrize("rate", [k * (sp.exp(sp.sin(y)) - 1), k * sp.sin(y) * sp.cos(y)])
def test_a_symmetry_field_with_the_angle_of_a_condition(rate):
    still = System(
        name="still", title="Still", field={y: 0, k: 1, x: 0}, relations=(sp.sin(y) * sp.cos(y),)
    )
    fails = bool(rate.has(sp.exp))
    assert prove(still, Symmetry("law", {x: rate})).decision == ("refuted" if fails else "proven")


def test_a_target_with_a_double_factor_beside_a_sine():
    """(a y − b x)² = 0 is as large as a y − b x = 0, though its differential vanishes."""
    system = System(
        name="double",
        title="Double",
        field={x: 0, y: 0, z: 0, k: 1},
        parameters=(Parameter(a, "", 1.9), Parameter(b, "", 0.7)),
        relations=((a * y - b * x) ** 2 * sp.sin(x),),
    )
    moved = z + k * (sp.exp((a * y - b * x) * sp.sin(x)) - 1)
    law = Isomorphism("law", system, {x: x, y: y, z: moved, k: k})
    verdict = prove(system, law)
    # on the other part the target is known by its sine alone
    assert (verdict.decision, verdict.formulas) == ("proven where", ("sin(x) != 0",))
    wrong = Isomorphism("law", system, {x: x, y: y, z: z + k * (a * y - b * x), k: k})
    assert prove(system, wrong).decision != "proven"
