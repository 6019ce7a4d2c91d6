"""Right laws of every kind are proven, wrong ones refuted, and what is out of reach is said."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import sympy as sp
from hypothesis import given, settings, strategies as st

from flowlanes.errors import InputError
from flowlanes.system.isomorphism import Isomorphism
from flowlanes.system.laws import (
    ConformallyHamiltonian,
    Identity,
    Integral,
    Measure,
    PoissonStructure,
    Rate,
    Reduction,
    Symmetry,
)
from flowlanes.system.system import Parameter, System
from flowlanes.system.vectors import (
    Diagonal,
    cross,
    dot,
    norm_squared,
    real_symbol,
    to_components,
    vectors,
)
from lawproof.proof.prover import prove
from nonholonomic.catalogue import from_catalogue
from nonholonomic.catalogue.e3 import lie_poisson

M, gamma, omega = vectors("M gamma omega")
A, J = Diagonal("A"), Diagonal("J")
u, q = real_symbol("u"), real_symbol("q")
half = sp.Rational(1, 2)
M_1, M_2, M_3 = M.symbols
ENERGY, AREA, SQUARE = half * dot(M, A * M), dot(M, gamma), norm_squared(M)


@pytest.fixture(autouse=True, scope="module")
def own_cache(tmp_path_factory):
    """Verdicts of these tests are kept for the tests of this module alone."""
    folder = tmp_path_factory.mktemp("cache")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("FLOWLANES_CACHE", str(folder))
        yield folder


def moments(tensor: Diagonal) -> tuple[Parameter, ...]:
    return tuple(
        Parameter(s, "", value) for s, value in zip(tensor.symbols, (1.0, 0.7, 0.4), strict=True)
    )


TOP = System(
    name="top",
    title="Free top",
    parameters=moments(A),
    field={M: cross(M, A * M), gamma: cross(gamma, A * M)},
    relations=(norm_squared(gamma) - 1,),
)
BY_VELOCITY = System(
    name="top-by-velocity",
    title="Free top by its angular velocity",
    parameters=moments(J),
    field={omega: J**-1 * cross(J * omega, omega), gamma: cross(gamma, omega)},
    relations=(norm_squared(gamma) - 1,),
)
#: A parameter by the name of something that moves in `TOP`.
OWN = Parameter(M_1, "", 1.0)
SMALL = replace(BY_VELOCITY, name="small", field=BY_VELOCITY.field[:1], relations=())
INVERSE = {j: 1 / a for j, a in zip(J.symbols, A.symbols, strict=True)}
BRACKET = PoissonStructure("bracket", lie_poisson(M, gamma), (norm_squared(gamma), AREA), rank=4)
SPIN = {M: cross(M, A * M), gamma: cross(gamma, A * M)}

RIGHT = {
    "energy": Integral("law", ENERGY),
    "integral with a root": Integral("law", sp.sqrt(1 + SQUARE) * ENERGY),
    "integral with a logarithm": Integral("law", sp.log(1 + SQUARE) + sp.exp(ENERGY)),
    "integral for equal moments": Integral("law", M_3, level=(A.symbols[0] - A.symbols[1],)),
    "integral on a level": Integral("law", ENERGY + AREA * M_1, level=(AREA,)),
    "volume": Measure("law", {sp.S.One: 1}),
    "density of integrals": Measure("law", {SQUARE: -half, ENERGY: A.symbols[0]}),
    "the field is its own symmetry": Symmetry("law", SPIN),
    "scaled by an integral": Symmetry(
        "law", {M: AREA * cross(M, A * M), gamma: AREA * SPIN[gamma]}
    ),
    "bracket": BRACKET,
    "hamiltonian": ConformallyHamiltonian("law", sp.S.One, BRACKET, ENERGY),
    "conformally hamiltonian": ConformallyHamiltonian("law", 1 / (2 * ENERGY), BRACKET, ENERGY**2),
    "isomorphism": Isomorphism("law", BY_VELOCITY, {omega: A * M, gamma: gamma}, constants=INVERSE),
    "isomorphism with another time": Isomorphism(
        "law", BY_VELOCITY, {omega: 2 * (A * M), gamma: gamma}, half, INVERSE
    ),
    "reduction": Reduction("law", {u: SQUARE * ENERGY}, (Rate(u),)),
    "reduction with constants": Reduction("law", {u: AREA, q: u**2}, (Rate(q), q - u**2)),
    "identity": Identity("law", (norm_squared(gamma) - 1, dot(gamma, cross(M, gamma)))),
    "identity with rates": Identity("law", Rate(M_1) - to_components(cross(M, A * M))[0]),
}
WRONG = {
    "no integral": Integral("law", norm_squared(A * M)),
    "integral with a wrong root": Integral("law", sp.sqrt(1 + M_1**2)),
    "integral on a level only": replace(RIGHT["integral on a level"], level=()),
    "equal moments only": replace(RIGHT["integral for equal moments"], level=()),
    "level that moves": Integral("law", ENERGY, level=(M_1,)),
    "no density": Measure("law", {SQUARE + M_1: half}),
    "no symmetry": Symmetry("law", {M: M + 0 * gamma}),
    "leaves the phase space": Symmetry("law", {gamma: gamma + 0 * M}),
    "no Jacobi identity": replace(BRACKET, matrix=M_1 * BRACKET.matrix),
    "not skew": replace(BRACKET, matrix=BRACKET.matrix + sp.eye(6)),
    "no Casimir function": replace(BRACKET, casimirs=(SQUARE,)),
    "rank too small": replace(BRACKET, rank=2),
    "rank too large": replace(BRACKET, casimirs=(), rank=6),
    "another multiplier": ConformallyHamiltonian("law", sp.Integer(2), BRACKET, ENERGY),
    "another hamiltonian": ConformallyHamiltonian("law", sp.S.One, BRACKET, ENERGY + M_1),
    "another time": replace(RIGHT["isomorphism"], time=sp.Integer(2)),
    "another map": replace(RIGHT["isomorphism"], map={omega: M, gamma: gamma}),
    "other constants": replace(
        RIGHT["isomorphism"], constants=dict(zip(INVERSE, A.symbols, strict=True))
    ),
    "constants that move": replace(RIGHT["isomorphism"], constants={**INVERSE, J.symbols[0]: M_1}),
    "map that loses dimensions": Isomorphism("law", SMALL, {omega: A * M}, constants=INVERSE),
    "no reduction": Reduction("law", {u: SQUARE}, (Rate(u) - u,)),
    "second equation wrong": Reduction("law", {u: SQUARE}, (Rate(u), u - 1)),
    "no constant": Reduction("law", {u: M_1}, (Rate(u),)),
    "no identity": Identity("law", norm_squared(gamma) - 2),
    "wrong rate": Identity("law", Rate(M_1) + to_components(cross(M, A * M))[0]),
}

FAR = {
    "a function that is not known": (Integral("law", sp.erf(M_1)), "erf"),
    "an exponent that moves": (Integral("law", (1 + M_1**2) ** M_2), "exponent"),
}

MISTAKES = {
    "unknown symbol": (Integral("law", M_1 * q), "'law' uses q, which is neither"),
    "unknown symbol in a level": (Integral("law", M_1, level=(q - 1,)), "uses q, which is neither"),
    "empty level": (Integral("law", M_1, level=(norm_squared(gamma) - 2,)), "is empty"),
    "level without real points": (Integral("law", ENERGY, level=(SQUARE + 1,)), "is empty"),
    "empty level of parameters": (
        Integral("law", M_1, level=(A.symbols[0] - 1, A.symbols[0] - 2)),
        "is empty",
    ),
    "denominator": (Integral("law", 1 / AREA, level=(AREA,)), "divides by zero"),
    "imaginary root": (Integral("law", sp.sqrt(-SQUARE)), "root of a negative quantity"),
    "state of the target": (
        replace(RIGHT["isomorphism"], map={omega: A * M}),
        "does not say what gamma_1, gamma_2, gamma_3 of top-by-velocity is",
    ),
    "parameter of the target": (
        replace(RIGHT["isomorphism"], constants=()),
        "does not say what the parameter J_1 of top-by-velocity is",
    ),
    "state of the source": (
        replace(RIGHT["isomorphism"], target=replace(BY_VELOCITY, parameters=(*moments(J), OWN))),
        "does not say what the parameter M_1 of top-by-velocity is, but top has a state variable",
    ),
    "size of the matrix": (
        PoissonStructure("law", sp.zeros(3, 3)),
        "its matrix is 3×3, but the state has 6 variables",
    ),
    "exponent of a density": (Measure("law", {SQUARE: M_1}), "must not depend on the state"),
}


@pytest.mark.parametrize("name", RIGHT)
def test_right_laws_are_proven(name):
    verdict = prove(TOP, RIGHT[name])
    assert verdict.decision == "proven", verdict
    assert verdict
    assert verdict.finding and verdict.terms >= 0 and verdict.witness is None


@pytest.mark.parametrize("name", WRONG)
def test_wrong_laws_are_refuted(name):
    verdict = prove(TOP, WRONG[name])
    assert verdict.decision == "refuted", verdict
    assert not verdict
    assert set(verdict.witness["point"]) == {
        *map(str, TOP.symbols),
        *(str(p.symbol) for p in TOP.parameters),
    }


@pytest.mark.parametrize("name", FAR)
def test_what_is_out_of_reach_is_undecided_with_the_reason(name):
    law, reason = FAR[name]
    verdict = prove(TOP, law)
    assert verdict.decision == "undecided"
    assert reason in verdict.reason
    assert not verdict and verdict.witness is None


def test_an_effort_that_is_too_small_leaves_a_law_undecided():
    law = Integral("law", ENERGY**2 + SQUARE)
    verdict = prove(TOP, law, effort=1000)
    assert verdict.decision == "undecided"
    assert verdict.reason == "not decided with an effort of 1,000 term operations"
    assert prove(TOP, law).decision == "proven"


@pytest.mark.slow
@pytest.mark.parametrize("name", MISTAKES)
def test_mistakes_are_told_in_one_sentence(name):
    law, message = MISTAKES[name]
    with pytest.raises(InputError) as caught:
        prove(TOP, law)
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


# --- random laws ---------------------------------------------------------------------------

MONOMIALS = st.tuples(*[st.integers(0, 2)] * 6).filter(any)
NUMBERS = st.fractions(-3, 3, max_denominator=5).filter(bool)


def combination(terms: list[tuple[sp.Rational, tuple[int, int, int]]]) -> sp.Expr:
    """A polynomial in the integrals of the top."""
    return sp.Add(*(sp.Rational(c) * ENERGY**i * AREA**j * SQUARE**k for c, (i, j, k) in terms))


COMBINATIONS = st.lists(
    st.tuples(NUMBERS, st.tuples(*[st.integers(0, 2)] * 3)), min_size=1, max_size=3
).map(combination)


@pytest.mark.slow
@settings(max_examples=25)
@given(COMBINATIONS)
def test_combinations_of_integrals_are_integrals(formula):
    assert prove(TOP, Integral("law", formula)).decision == "proven"


@pytest.mark.slow
@settings(max_examples=40)
@given(COMBINATIONS, MONOMIALS, NUMBERS)
def test_one_term_more_is_refuted(formula, powers, factor):
    """No product of powers of the variables is an integral of the top."""
    term = sp.Mul(*(s**n for s, n in zip(TOP.symbols, powers, strict=True)))
    wrong = formula + sp.Rational(factor) * term
    assert prove(TOP, Integral("law", wrong)).decision == "refuted"


@pytest.mark.slow
@settings(max_examples=25)
@given(COMBINATIONS, MONOMIALS)
def test_what_vanishes_with_a_level_holds_on_it_alone(formula, powers):
    term = sp.Mul(*(s**n for s, n in zip(TOP.symbols, powers, strict=True)))
    law = Integral("law", formula + AREA * term, level=(AREA,))
    assert prove(TOP, law).decision == "proven"
    assert prove(TOP, replace(law, level=())).decision == "refuted"


# --- witnesses -----------------------------------------------------------------------------


def written_out(system: System, formula: sp.Expr) -> sp.Expr:
    """A formula in state and parameters alone."""
    made = to_components(formula)
    for symbol, value in reversed(system.scalar_definitions):
        made = made.xreplace({symbol: value})
    return made


WITNESSES = {
    "top": (TOP, Integral("law", norm_squared(A * M) + M_1**3), ()),
    "chaplygin-ball": (
        from_catalogue("chaplygin-ball"),
        Integral("law", SQUARE + dot(omega, gamma)),
        (),
    ),
    "chaplygin-ball on a level": (
        from_catalogue("chaplygin-ball"),
        Integral("law", dot(omega, gamma), level=(AREA,)),
        (AREA,),
    ),
    "veselova": (from_catalogue("veselova"), Integral("law", dot(omega, omega)), ()),
}


@pytest.mark.parametrize("name", WITNESSES)
def test_a_witness_is_a_point_of_the_level_where_the_law_fails(name):
    """By SymPy's own differentiation and rational numbers."""
    system, law, level = WITNESSES[name]
    verdict = prove(system, law)
    assert verdict.decision == "refuted"
    point = {
        sp.Symbol(symbol, real=True): sp.Rational(value)
        for symbol, value in verdict.witness["point"].items()
    }
    assert set(point) == {*system.symbols, *system.defaults}
    for condition in (*system.relations, *level):
        assert written_out(system, condition).xreplace(point) == 0
    formula = written_out(system, law.value)
    rates = (written_out(system, rate).xreplace(point) for rate in system.rates)
    slope = sp.Add(
        *(
            sp.diff(formula, s).xreplace(point) * v
            for s, v in zip(system.symbols, rates, strict=True)
        )
    )
    assert verdict.witness["what"] == "v(F)"
    assert slope == sp.Rational(verdict.witness["residual"]) != 0


# --- verdicts that are kept ----------------------------------------------------------------


def kept(folder: Path) -> set[str]:
    return {path.name for path in folder.glob("*.json")}


def test_a_verdict_is_kept_and_read_again(own_cache):
    law = Integral("kept", SQUARE**3 + ENERGY)
    first = prove(TOP, law)
    names = kept(own_cache)
    assert prove(TOP, law) == first
    assert kept(own_cache) == names
    changed = prove(TOP, replace(law, value=SQUARE**3 - M_1))
    assert changed.decision == "refuted"
    assert len(kept(own_cache) - names) == 1


def test_another_system_has_a_verdict_of_its_own():
    law = Integral("other system", M_3)
    assert prove(TOP, law).decision == "refuted"
    still = replace(TOP, field={M: 0 * M, gamma: cross(gamma, A * M)})
    assert prove(still, law).decision == "proven"


def test_what_cannot_be_read_is_decided_again(own_cache):
    law = Integral("spoilt", SQUARE**2)
    names = kept(own_cache)
    prove(TOP, law)
    (own_cache / (kept(own_cache) - names).pop()).write_text("{")
    assert prove(TOP, law).decision == "proven"
