"""The volume on a phase space is that of its relations as they are written."""

from __future__ import annotations

import pytest
import sympy as sp

from chaplygin.core.laws import Measure
from chaplygin.core.system import Guard, Parameter, System
from chaplygin.errors import InputError
from chaplygin.proof.certificates.certificate import prove_with_certificate
from chaplygin.proof.prover import prove

x, y, z, w, a = sp.symbols("x y z w a", real=True)
SPHERE = x**2 + y**2 + z**2 - 1
#: It keeps the sphere and the volume dⁿx/dF of it.
FIELD = {x: y * z, y: -2 * x * z, z: x * y}
RIGHT = Guard("right", x + 2, "the motion ends")
POSITIVE = Parameter(a, "", 1.3, admissible=(a > 0,))


def measure(density, on=()):
    return Measure("volume", density, on=on)


FACTORS = [
    (1 + x**2, {}),
    (3 + x, {"guards": (RIGHT,)}),
    (a + x**2, {"parameters": (POSITIVE,)}),
]


@pytest.mark.parametrize(("factor", "more"), FACTORS)
@pytest.mark.parametrize("write", [sp.expand, lambda f: f])
def test_a_factor_without_zeros_belongs_to_the_density(factor, more, write):
    """dⁿx/d(g F) = dⁿx/(g dF), and g moves."""
    system = System("factor", "Factor", FIELD, relations=(write(factor * SPHERE),), **more)
    assert prove(system, measure({1: 1})).decision == "refuted"
    verdict = prove_with_certificate(system, measure({factor: 1}))
    assert verdict.decision == "proven"
    assert verdict.certificate is not None


def test_the_same_of_a_level():
    system = System("level", "Level", FIELD)
    on = ((1 + x**2) * SPHERE,)
    assert prove(system, measure({1: 1}, on)).decision == "refuted"
    assert prove(system, measure({1 + x**2: 1}, on)).decision == "proven"


def test_a_factor_in_two_relations_counts_twice():
    relations = ((1 + x**2) * SPHERE, (1 + x**2) * w)
    system = System("twice", "Twice", {**FIELD, w: sp.S.Zero}, relations=relations)
    assert prove(system, measure({1 + x**2: 1})).decision == "refuted"
    assert prove(system, measure({1 + x**2: 2})).decision == "proven"


def test_two_spheres_have_each_its_volume():
    relation = SPHERE * (SPHERE - 3) * (1 + x**2)
    system = System("spheres", "Spheres", FIELD, relations=(relation,))
    assert prove(system, measure({1: 1})).decision == "refuted"
    assert prove(system, measure({1 + x**2: 1})).decision == "proven"


@pytest.mark.parametrize("relation", [SPHERE**2, sp.expand(SPHERE**2)])
def test_a_square_cuts_out_no_volume(relation):
    system = System("square", "Square", FIELD, relations=(relation,))
    with pytest.raises(InputError, match="cut out no volume: their gradients depend"):
        prove(system, measure({1: 1}))


def test_a_factor_that_moves():
    """ẇ = x w: the divergence is x, and so is the rate of w F by itself, on both components."""
    system = System("moves", "Moves", {**FIELD, w: x * w}, relations=(w * SPHERE,))
    assert prove(system, measure({1: 1})).decision == "proven"
    assert prove(system, measure({w: 1})).decision == "refuted"


def test_laws_that_state_nothing_are_refused_one_by_one():
    oscillator = System("oscillator", "Oscillator", {x: y, y: -x})
    laws = (
        measure({1: 1}),
        Measure("imaginary", {-1 - x**2: sp.Rational(1, 2)}),
        Measure("wrong", {1 + x**2: 1}),
    )
    verdicts = prove(oscillator.with_laws(*laws))
    assert [v.decision for v in verdicts] == ["proven", "refused", "refuted"]
    assert "root of a negative quantity" in verdicts[1].reason
    with pytest.raises(InputError, match="root of a negative quantity"):
        prove(oscillator, laws[1])
