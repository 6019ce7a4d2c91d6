"""Every kind of law by its whole definition: what falls short of it is not proven."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
import sympy as sp

from flowlanes.errors import InputError
from flowlanes.formulas.number_fields import ball_precision
from flowlanes.system.isomorphism import Isomorphism, with_any_parameters
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Law,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Separation,
    Symmetry,
)
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.fields.budget import Budget
from lawproof.proof.fields.function_field import FunctionField
from lawproof.proof.level.level_set import LevelSet
from lawproof.proof.level.positivity_conditions import (
    positive_formulas,
    sign_determining_bases,
    unmet_conditions,
)
from lawproof.proof.prover import prove
from lawproof.proof.rank import rank_defect
from lawproof.proof.remarks import remark
from nonholonomic.catalogue import from_catalogue

x, y, z, w = map(real_symbol, "xyzw")
X, Y, Z = map(real_symbol, "XYZ")
u, v, q, h, f, a, b = map(real_symbol, "uvqhfab")
half = sp.Rational(1, 2)

A = Parameter(a, "", 1.3, "", (a > 0,))
#: A rotation of the plane, and a third coordinate at rest.
TURN = System("turn", "Turn", {x: -y, y: x, z: sp.S.Zero})
#: The same with only the plane, and with a further motion.
PLANE = System("plane", "Plane", {X: -Y, Y: X})
SPACE = System("space", "Space", {X: -Y, Y: X, Z: sp.S.Zero})
LINE = System("line", "Line", {X: sp.S.Zero})
#: Two oscillators.
PAIR = System("pair", "Pair", {x: z, y: w, z: -x, w: -4 * y})
SQUARE = x**2 + y**2


@pytest.fixture(autouse=True, scope="module")
def own_cache(tmp_path_factory):
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FLOWLANES_CACHE", str(tmp_path_factory.mktemp("cache")))
        yield


def fractions(law: Law, system: System) -> tuple[LevelSet, FunctionField]:
    """The ground of a law with its field of fractions, at a sample point."""
    ground = LevelSet(system, law.level)
    with ball_precision():
        values, _ = ground.point(random.Random(3))
    sample = {name: float(value) for name, value in values.items()}
    return ground, ground.fractions(FunctionField, 8, sample, Budget())


def numbers(ground: LevelSet, seed: int = 5):
    values, exact = ground.point(random.Random(seed))
    return ground.numbers(values, exact)


# --- brackets ------------------------------------------------------------------------------

SKEW = sp.Matrix([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])


@pytest.mark.parametrize("rank", [1, 3, -2, 4])
def test_no_skew_matrix_has_such_a_rank(rank):
    with pytest.raises(InputError, match="even rank from 0 to 2"):
        PoissonStructure("law", SKEW, rank=rank)


@pytest.mark.parametrize("rank", [True, 2.0])
def test_a_rank_is_a_whole_number(rank):
    with pytest.raises(InputError, match="rank must be a whole number or None"):
        PoissonStructure("law", SKEW, rank=rank)


def test_a_bracket_has_a_square_matrix():
    with pytest.raises(InputError, match="is 2×3"):
        PoissonStructure("law", SKEW[:2, :])


def test_a_rank_is_proven_if_it_is_that_of_a_generic_point():
    structure = PoissonStructure("law", z * SKEW, rank=2)
    assert prove(TURN, structure)
    assert not prove(TURN, replace(structure, rank=0))
    assert not prove(TURN, PoissonStructure("law", sp.zeros(3), rank=2))


def test_a_special_point_is_told_from_a_rank_that_is_too_large():
    rightly = PoissonStructure("law", z * SKEW, rank=2)
    ground, field = fractions(rightly, TURN)
    at_rest = ground.numbers({"x": 1, "y": 2, "z": 0}, exact=True)
    assert rank_defect(rightly, ground, at_rest) == ("the rank of the bracket", "0 instead of 2")
    assert rank_defect(rightly, ground, field) is None
    wrongly = replace(rightly, matrix=sp.zeros(3))
    assert rank_defect(wrongly, ground, field) is not None


def test_a_multiplier_does_not_vanish_identically():
    still = System("still", "Still", {x: sp.S.Zero, y: sp.S.Zero, z: sp.S.Zero})
    structure = PoissonStructure("law", SKEW, rank=2)
    form = ConformallyHamiltonian("law", sp.S.Zero, structure, SQUARE / 2)
    assert prove(still, form).decision == "refuted"
    assert prove(still, replace(form, multiplier=x - x * (1 + 0 * y))).decision == "refuted"
    assert prove(still, replace(form, multiplier=sp.S.One, hamiltonian=z))


# --- isomorphisms --------------------------------------------------------------------------

ONTO_PLANE = Isomorphism("law", PLANE, {X: x, Y: y}, constants={}, level=(z - 1,))


def test_a_level_and_a_target_of_one_dimension():
    assert prove(TURN, ONTO_PLANE)
    assert prove(TURN, Isomorphism("law", SPACE, {X: x, Y: y, Z: z**3 + z}))


@pytest.mark.parametrize(
    ("law", "lacking"),
    [
        (replace(ONTO_PLANE, level=()), "the rank of the map"),
        (Isomorphism("law", SPACE, {X: x, Y: y, Z: sp.S.One}), "the rank of the map"),
        (
            Isomorphism("law", SPACE, {X: x, Y: y, Z: sp.S.One}, level=(z - 1,)),
            "the dimension of the level",
        ),
        (
            Isomorphism("law", SPACE, {X: x, Y: y, Z: SQUARE}, level=(z,)),
            "the dimension of the level",
        ),
    ],
)
def test_a_map_that_is_not_onto_or_not_injective_is_refuted(law, lacking):
    verdict = prove(TURN, law)
    assert verdict.decision == "refuted"
    assert lacking in verdict.witness["what"]


def test_a_map_onto_a_level_of_the_target_says_which():
    into = Isomorphism("law", SPACE, {X: x, Y: y, Z: SQUARE}, level=(z,))
    assert prove(TURN, replace(into, onto=(X**2 + Y**2 - Z,)))
    assert prove(TURN, replace(into, onto=(X**2 + Y**2 - 2 * Z,))).decision == "refuted"
    assert prove(TURN, replace(into, onto=(Z - Z,))).decision == "refuted"


def test_a_level_of_the_target_is_one_for_all_states():
    law = Isomorphism("law", SPACE, {X: x, Y: y, Z: SQUARE}, level=(z,), onto=(Z - x**2 - y**2,))
    with pytest.raises(InputError, match="uses x, y, which depends on the state of turn"):
        prove(TURN, law)


def test_constants_that_depend_on_the_state_cut_the_level_out():
    turning = replace(PLANE, name="turning", field={X: -a * Y, Y: a * X}, parameters=(A,))
    fast = replace(TURN, field={x: -z * y, y: z * x, z: sp.S.Zero})
    law = Isomorphism("law", turning, {X: x, Y: y}, constants={a: z})
    assert prove(fast, law).conditions == ("z > 0",)
    assert prove(fast, replace(law, target=with_any_parameters(turning)))
    still = replace(law, constants={a: sp.S.One})
    assert not prove(fast, still)


def test_what_the_target_does_not_have_is_refused():
    with pytest.raises(InputError, match="map names w, which is no state variable of plane"):
        replace(ONTO_PLANE, map={X: x, Y: y, w: x})
    with pytest.raises(InputError, match="constants names a, which is no parameter of plane"):
        replace(ONTO_PLANE, constants={a: sp.S.One})
    with pytest.raises(InputError, match="names X twice"):
        replace(ONTO_PLANE, map=((X, x), (X, x), (Y, y)))


def test_a_parameter_is_not_read_as_a_state_variable_of_the_same_name():
    turning = System("turning", "", {X: -z * Y, Y: z * X}, (Parameter(z, "", 1.0),))
    fast = replace(TURN, field={x: -z * y, y: z * x, z: sp.S.Zero})
    with pytest.raises(InputError, match="turn has a state variable of this name"):
        prove(fast, Isomorphism("law", turning, {X: x, Y: y}))


@pytest.mark.parametrize("time", [sp.S.Zero, sp.S.NegativeOne, -sp.sqrt(2)])
def test_a_time_that_stands_still_or_runs_backwards_is_refuted(time):
    still = System("still", "", {x: sp.S.Zero, y: sp.S.Zero})
    rest = System("rest", "", {X: sp.S.Zero, Y: sp.S.Zero})
    verdict = prove(still, Isomorphism("law", rest, {X: x, Y: y}, time=time))
    assert verdict.decision == "refuted"
    assert verdict.witness["what"] == "dτ/dt"


def test_a_time_whose_sign_is_not_settled_is_named():
    ground = LevelSet(TURN)

    def needed(time: sp.Expr) -> list[sp.Expr]:
        law = replace(ONTO_PLANE, time=time)
        return [formula for _, formula in positive_formulas(law, ground)]

    assert needed(sp.S.One) == needed(1 + SQUARE) == needed(sp.exp(x) / sp.sqrt(x)) == []
    assert needed(x) == [x]
    assert needed(x / (y * z**2)) == [x * y]
    assert needed(x**2) == [x**2]
    # a power with a symbol as exponent is real where its base is positive
    assert needed(x**a) == []
    assert needed(sp.S.NegativeOne) == [-1]
    assert needed(x ** sp.Rational(1, 3)) == [x ** sp.Rational(1, 3)]


def test_a_time_that_is_never_positive_is_not_proven():
    law = replace(ONTO_PLANE, time=-1 - SQUARE)
    slow = replace(TURN, field={x: y * (1 + SQUARE), y: -x * (1 + SQUARE), z: sp.S.Zero})
    ground = LevelSet(slow, law.level)
    with ball_precision():
        for seed in range(8):
            ((what, value),) = unmet_conditions(law, ground, numbers(ground, seed))
            assert what == "dτ/dt"
            assert value < 0
    try:
        assert not prove(slow, law)
    except InputError as refusal:
        assert "at every point tried" in str(refusal)


def test_definitions_that_are_roots_need_no_sign():
    rooted = replace(TURN, definitions={q: sp.sqrt(1 + x), w: x - 1})
    ground = LevelSet(rooted)
    assert positive_formulas(replace(ONTO_PLANE, time=1 / q), ground) == ()
    assert positive_formulas(replace(ONTO_PLANE, time=q * w), ground) == (("dτ/dt", w),)


# --- measures ------------------------------------------------------------------------------


def test_a_density_that_is_nowhere_real_is_not_proven():
    law = Measure("law", {-1 - SQUARE: half})
    ground = LevelSet(TURN)
    assert [formula for _, formula in positive_formulas(law, ground)] == [-1 - SQUARE]
    with ball_precision():
        assert all(unmet_conditions(law, ground, numbers(ground, seed)) for seed in range(8))
    try:
        assert not prove(TURN, law)
    except InputError as refusal:
        assert "at every point tried" in str(refusal)


def test_bases_under_roots_must_be_positive_and_odd_ones_give_the_sign():
    ground = LevelSet(replace(TURN, parameters=(A,)))
    law = Measure("law", {z: half, SQUARE: 3, z - 1: -2, z + 1: a, z + 2: -1, z + 3: 0, z + 4: 1})
    assert [formula for _, formula in positive_formulas(law, ground)] == [z, z + 1]
    assert [formula for _, formula in sign_determining_bases(law, ground)] == [SQUARE, z + 2, z + 4]
    on_level = Measure("law", {z + 1: a}, level=(a - 3,))
    ground = LevelSet(ground.system, on_level.level)
    assert positive_formulas(on_level, ground) == ()
    assert [formula for _, formula in sign_determining_bases(on_level, ground)] == [z + 1]
    assert prove(TURN, Measure("law", {z**2 + 1: half}))
    assert sign_determining_bases(ONTO_PLANE, LevelSet(TURN)) == ()


def test_a_condition_that_follows_from_others_leaves_no_volume():
    """By z = 0 and by z (1 + x) = 0 the volumes differ: which of them is meant is not said."""
    twice = replace(TURN, field={x: -y, y: x, z: -z}, relations=(z, z * (1 + x)))
    with pytest.raises(InputError, match="gradients depend on each other"):
        prove(twice, Measure("law", {sp.Integer(1): 1}))


# --- reductions ----------------------------------------------------------------------------

ENERGY = (z**2 + x**2) / 2


@pytest.mark.parametrize(
    "law",
    [
        Reduction("law", {u: x * z}, (Rate(Rate(u)) + 4 * u,)),
        Reduction("law", {u: x**2, h: ENERGY}, (Rate(u) ** 2 - 4 * u * (2 * h - u), Rate(h))),
        Reduction("law", {}, (Rate(x) - z, Rate(z) + x)),
        Reduction("law", {h: ENERGY}, (Rate(x) - z, z**2 + x**2 - 2 * h, Rate(h))),
        Reduction("law", {u: x, v: z}, (u * Rate(u) + v * Rate(v),)),
    ],
    ids=["second order", "with a constant", "in the state", "algebraic", "paths"],
)
def test_closed_equations_are_proven(law):
    assert prove(PAIR, law)


@pytest.mark.parametrize(
    "law",
    [
        Reduction("law", {u: x**2}, (Rate(u) - 2 * x * z,)),
        Reduction("law", {u: x, v: y}, (Rate(Rate(u)) + u + v - y,)),
        Reduction("law", {u: x**2, h: ENERGY}, (Rate(u) ** 2 - 4 * u * (2 * h - u),)),
        Reduction("law", {u: x}, (u - x,)),
        Reduction("law", {u: x}, (Rate(u) - Rate(x),)),
        Reduction("law", {}, (Rate(x) - z,)),
    ],
    ids=["the state", "another quantity", "a constant unsaid", "no rate", "nothing", "half of it"],
)
def test_equations_that_leave_rates_open_are_not_closed(law):
    verdict = prove(PAIR, law)
    assert not verdict
    assert verdict.decision == "refuted"
    assert verdict.witness["what"] == "the rank of the equations in the rates"
    assert prove(PAIR, Identity("law", law.equations, quantities=law.quantities))


@pytest.mark.parametrize("taken", ["x", "q", "a"])
def test_a_quantity_needs_a_name_of_its_own(taken):
    system = replace(PAIR, definitions={q: x + y}, parameters=(A,))
    name = real_symbol(taken)
    for law in (
        Reduction("law", {name: z**2}, (Rate(name),)),
        Identity("law", name - z**2, quantities={name: z**2}),
    ):
        with pytest.raises(InputError, match=f"quantity {taken}, which is a"):
            prove(system, law)


def test_quantities_stand_in_an_order():
    with pytest.raises(InputError, match="the formula of u uses v"):
        prove(PAIR, Identity("law", u - v, quantities={u: v, v: u}))
    with pytest.raises(InputError, match="names two quantities u"):
        Reduction("law", ((u, x), (u, z)), (Rate(u) - z,))
    with pytest.raises(InputError, match="has no equation"):
        Reduction("law", {u: x}, ())
    with pytest.raises(InputError, match="hold nothing that moves"):
        prove(replace(PAIR, parameters=(A,)), Reduction("law", {}, (a - a * 1 + 0 * a,)))


def test_an_identity_has_a_formula():
    with pytest.raises(InputError, match="states nothing"):
        prove(PAIR, Identity("law", ()))


# --- separations ---------------------------------------------------------------------------

#: A point in the plane, in parabolic coordinates: r ± x, with the force of a centre at distance r.
R = sp.sqrt(x**2 + y**2)
KEPLER = System("kepler", "Kepler", {x: z, y: w, z: -x / R**3, w: -y / R**3})
TOTAL = (z**2 + w**2) / 2 - 1 / R
#: The constant of the separation.
LENZ = w * (x * w - y * z) - x / R
PARABOLIC = {u: R + x, v: R - x, h: TOTAL, f: LENZ}
OWN = (
    (u + v) ** 2 * Rate(u) ** 2 - 4 * u * (2 * h * u + 2 - 2 * f),
    (u + v) ** 2 * Rate(v) ** 2 - 4 * v * (2 * h * v + 2 + 2 * f),
)
KEPT = (Rate(h), Rate(f))


def test_parabolic_coordinates_separate():
    assert prove(KEPLER, Separation("law", PARABOLIC, (*OWN, *KEPT)))


def test_oscillators_separate_in_their_own_time():
    law = Separation(
        "law",
        {h: ENERGY, f: (w**2 + 4 * y**2) / 2},
        (
            Rate(x) ** 2 - 2 * h + x**2,
            Rate(y) ** 2 - 2 * f + 4 * y**2,
            *KEPT,
        ),
    )
    assert prove(PAIR, law)


MIXED = System("mixed", "", {x: x + y, y: y - x, z: sp.S.Zero})


@pytest.mark.parametrize(
    ("system", "law"),
    [
        (MIXED, Separation("law", {}, (Rate(x) - x - y, Rate(y) - y + x))),
        (PAIR, Separation("law", {}, (Rate(x) - z, Rate(y) - w))),
        (KEPLER, Separation("law", PARABOLIC, OWN)),
        (
            KEPLER,
            Separation("law", PARABOLIC, (*OWN, *KEPT[:1])),
        ),
        (
            TURN,
            Separation(
                "law",
                {u: x / y, v: x / y + 1},
                (
                    Rate(u) + u**2 + 1,
                    Rate(v) + (v - 1) ** 2 + 1,
                ),
            ),
        ),
        (
            replace(TURN, field={x: x * y * z, y: x * y + z * y, z: z * (x + y)}),
            Separation(
                "law",
                {},
                (Rate(x) - x * y * z, Rate(y) - y * (x + z), Rate(z) - z * (x + y)),
            ),
        ),
    ],
    ids=["coupled", "other state", "values unsaid", "one value unsaid", "one quantity", "three"],
)
def test_what_does_not_separate_is_refuted(system, law):
    assert prove(system, law).decision == "refuted"
    assert all(
        prove(system, Identity("law", equation, quantities=law.quantities))
        for equation in law.equations
    )


def test_three_that_separate_with_a_factor_of_everything():
    common = x + y * z + w
    system = System("three", "", {x: common * x, y: common * (1 + y), z: common * z**2, w: x * y})
    law = Separation(
        "law", {}, tuple(Rate(s) - common * rate for s, rate in ((x, x), (y, 1 + y), (z, z**2)))
    )
    assert prove(system, law)
    assert not prove(
        replace(system, field={**dict(system.field), z: common * z * w}),
        replace(law, equations=(*law.equations[:2], Rate(z) - common * z * w)),
    )


@pytest.mark.parametrize(
    ("equations", "words"),
    [
        ((Rate(x) - z, y - y * 1 + x - x), "equation 2"),
        ((Rate(x) * Rate(y) - z * w,), "equation 1"),
        ((Rate(x) - z, 2 * Rate(x) - 2 * z), "the only one of x"),
        ((Rate(x) ** 3 - z**3, Rate(y) - w), "its rate or the square"),
        ((Rate(x) - z,), "two or more"),
    ],
)
def test_equations_of_another_form_are_refused(equations, words):
    with pytest.raises(InputError, match=words):
        prove(PAIR, Separation("law", {}, equations))


# --- words ---------------------------------------------------------------------------------


def test_trivial_laws_are_told():
    cases = {
        Integral("law", sp.Integer(3)): "a constant on the whole level",
        Integral(
            "law", SQUARE * (1 + z), level=(SQUARE - 1, z - 2)
        ): "a constant on the whole level",
        Integral("law", SQUARE): "",
        Symmetry("law", {x: sp.S.Zero}): "the zero field",
        Symmetry("law", {x: -y, y: x}): "",
        Reduction("law", {u: x, v: y}, (u * Rate(u) + v * Rate(v),)): "up to the time",
        Reduction("law", {u: x, v: y}, (Rate(u) + v, Rate(v) - u)): "",
        ONTO_PLANE: "",
    }
    for law, words in cases.items():
        assert prove(TURN, law)
        ground, field = fractions(law, TURN)
        assert remark(law, ground, field) == words


# --- the catalogue -------------------------------------------------------------------------


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "law"),
    [
        ("veselova", "neumann"),
        ("chaplygin-ball", "clebsch_case"),
        ("chaplygin-ball", "fedorov"),
        ("rubber-ball-of-ratio", "sphere"),
        ("veselova-geodesic-flow", "clebsch"),
        ("suslov-quadratic", "bracket"),
        ("ball-bearing", "chaplygin_ball"),
    ],
)
def test_levels_onto_which_the_catalogue_leads_are_needed(name, law):
    system = from_catalogue(name)
    (claim,) = (each for each in system.laws if each.name == law)
    assert prove(system, claim)
    assert prove(system, replace(claim, onto=())).decision == "refuted"
