"""The volume on a phase space is that of its relations as they are written."""

from __future__ import annotations

import pytest
import sympy as sp

from certificate_checker import CheckError
from flowlanes.errors import InputError
from flowlanes.system.laws import Identity, Measure, PoissonStructure, Symmetry
from flowlanes.system.system import Guard, Parameter, System
from lawproof.proof import decision
from lawproof.proof.certificates.certificate import prove_with_certificate
from lawproof.proof.prover import prove, prove_all
from lawproof.search import measures, search_space

x, y, z, w, a = sp.symbols("x y z w a", real=True)
SPHERE = x**2 + y**2 + z**2 - 1
#: It keeps the sphere and the volume dⁿx/dF of it.
FIELD = {x: y * z, y: -2 * x * z, z: x * y}
RIGHT = Guard("right", x + 2, "the motion ends")
POSITIVE = Parameter(a, "", 1.3, admissible=(a > 0,))


def measure(density, on=()):
    return Measure("volume", density, level=on)


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


def test_an_exponential_belongs_to_the_density():
    system = System("exponential", "Exponential", FIELD, relations=(sp.exp(x) * SPHERE,))
    assert prove(system, measure({1: 1})).decision == "refuted"
    assert prove(system, measure({sp.exp(x): 1})).decision == "proven"


def test_a_square_cuts_out_no_volume_where_no_point_can_be_computed():
    """The points have irrational coordinates of the third degree over √2: none is tried."""
    still = {x: sp.S.Zero, y: sp.S.Zero, z: sp.S.Zero}
    curve = y**3 - x * y - 1
    system = System("curve", "Curve", still, relations=(x**2 - 2, curve))
    assert prove(system, measure({1: 1})).decision == "proven"
    squared = System("curve", "Curve", still, relations=(x**2 - 2, curve**2))
    with pytest.raises(InputError, match="cut out no volume"):
        prove(squared, measure({1: 1}))


@pytest.mark.parametrize(
    ("relation", "where"),
    [(SPHERE**2 * (SPHERE - 3), f"{sp.expand(SPHERE)} != 0"), ((a - 1) * SPHERE, "a - 1 != 0")],
)
def test_a_volume_on_a_part_alone(relation, where):
    """Nothing is said of the sphere that is double, nor of all of space for a = 1."""
    system = System("part", "Part", FIELD, relations=(relation,), parameters=(POSITIVE,))
    verdict = prove(system, measure({1: 1}))
    assert verdict.decision == "proven where"
    assert verdict.formulas == (where,)


@pytest.mark.parametrize("is_level", [False, True])
def test_the_search_finds_the_density_by_the_relation(is_level):
    relation = sp.expand((1 + x**2) * SPHERE)
    system = System("searched", "Searched", FIELD, relations=() if is_level else (relation,))
    found = list(measures(search_space(system, level=(str(relation),) if is_level else ())))
    assert [f.law.density for f in found] == [((1 + x**2, 1),)]
    assert found[0].verdict.decision == "proven"


# --- other laws of conditions ---------------------------------------------------------------

LIFT = sp.ImmutableDenseMatrix([[0, 0, 1], [0, 0, 0], [-1, 0, 0]])
PLANE = sp.ImmutableDenseMatrix([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])
TURN = {x: -y, y: x, z: sp.S.Zero}


@pytest.mark.parametrize("factor", [1, 1 + x**2, z])
def test_brackets_and_symmetries_keep_the_zeros_of_a_condition(factor):
    """By z² = 0, too, the phase space is the plane: a bracket of z would lead out of it."""
    system = System("plane", "Plane", TURN, relations=(z * factor,))
    assert prove(system, PoissonStructure("bracket", PLANE)).decision == "proven"
    assert prove(system, PoissonStructure("bracket", LIFT)).decision == "refuted"
    assert prove(system, Symmetry("turn", {x: -y, y: x})).decision == "proven"
    assert prove(system, Symmetry("lift", {z: sp.S.One})).decision == "refuted"


def test_a_point_in_dispute_stands_against_a_proof(monkeypatch):
    """Where check and trial disagree nothing is proven, and the reason is the check's."""
    system = System("line", "Line", {x: sp.S.Zero, y: sp.S.One}, relations=(x * (x - 1),))
    law = Identity("at zero", x * (x - 1) + x)
    assert prove(system, law).decision == "refuted"

    def disagreeing(*_):
        raise CheckError("every residual may be zero at the point")

    monkeypatch.setattr(decision, "witness", disagreeing)
    verdict = prove(system, Identity("at zero again", x * (x - 1) + x))
    assert verdict.decision == "undecided"
    assert "does not confirm it: every residual may be zero at the point" in verdict.reason


def test_laws_that_state_nothing_are_refused_one_by_one():
    oscillator = System("oscillator", "Oscillator", {x: y, y: -x})
    laws = (
        measure({1: 1}),
        Measure("imaginary", {-1 - x**2: sp.Rational(1, 2)}),
        Measure("wrong", {1 + x**2: 1}),
    )
    verdicts = prove_all(oscillator.with_laws(*laws))
    assert [v.decision for v in verdicts] == ["proven", "refused", "refuted"]
    assert "root of a negative quantity" in verdicts[1].reason
    with pytest.raises(InputError, match="root of a negative quantity"):
        prove(oscillator, laws[1])
