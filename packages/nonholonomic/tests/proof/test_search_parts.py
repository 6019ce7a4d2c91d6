"""The parts of the search: arithmetic modulo a prime, weights, points, formulas as typed."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from hypothesis import given, strategies as st

from flowlanes.errors import InputError
from flowlanes.system.vectors import Diagonal, dot, norm_squared, real_symbol, vectors
from lawproof.search.ansatz import Ansatz, table
from lawproof.search.input_formulas import code_spelling, condition, formula, quantities
from lawproof.search.modular_jets import PRIMES, Evaluator, Jet, inverse, square_root
from lawproof.search.modular_linalg import combination, independent_columns, nullspace, rational
from lawproof.search.phase_space import restricted_system
from lawproof.search.scaling import weights
from nonholonomic.catalogue import from_catalogue

M, omega, gamma = vectors("M omega gamma")
A, J = Diagonal("A"), Diagonal("J")
x, y = real_symbol("x"), real_symbol("y")

PRIME = PRIMES[0]


def residue(number: sp.Rational) -> int:
    return int(number.p) * pow(int(number.q), -1, PRIME) % PRIME


@pytest.mark.parametrize(
    "expression",
    [
        x**3 * y - 7,
        (x + y) ** 2 / (x - 3 * y),
        x ** sp.Integer(-2) + sp.Rational(3, 5) * y,
        sp.Float("0.25") * x * y + 1 / (1 + y**2),
    ],
)
def test_a_jet_holds_value_and_gradient(expression: sp.Expr) -> None:
    at = {x: sp.Integer(11), y: sp.Integer(-5)}
    known = {
        s: Jet(np.array([int(v) % PRIME]), np.array([[int(s == x)], [int(s == y)]]))
        for s, v in at.items()
    }
    jet = Evaluator(known, 1, 2, {})(expression)
    exact = sp.nsimplify(expression)
    assert jet.value[0] == residue(exact.xreplace(at))
    for row, symbol in zip(jet.slope, (x, y), strict=True):
        assert row[0] == residue(sp.diff(exact, symbol).xreplace(at))


def test_roots_sines_and_symbolic_powers_obey_their_rules() -> None:
    count = 200
    rng = np.random.default_rng(3)
    flat = [np.ones((1, count), dtype=np.int64), np.zeros((1, count), dtype=np.int64)]
    known = {
        x: Jet(rng.integers(1, PRIME, count), flat[0]),
        y: Jet(rng.integers(1, PRIME, count), flat[1]),
    }
    evaluate = Evaluator(known, count, 1, {})
    root = evaluate(sp.sqrt(x))
    good = evaluate.good
    assert 60 < good.sum() < 140
    assert np.array_equal((root * root).value[good], known[x].value[good])
    assert np.array_equal((root * root).slope[0, good], known[x].slope[0, good])
    sine, cosine = evaluate(sp.sin(x)), evaluate(sp.cos(x))
    one = sine * sine + cosine * cosine
    assert (one.value == 1).all()
    assert not one.slope.any()
    assert np.array_equal(evaluate(sp.sin(2 * x)).value, 2 * (sine * cosine).value % PRIME)
    assert np.array_equal(sine.slope[0], cosine.value)
    raised = evaluate(x ** (2 - 1 / y))
    split = evaluate(x**2) * evaluate(x ** (-1 / y))
    assert np.array_equal(raised.value, split.value)
    expected = evaluate((2 - 1 / y) / x) * raised
    assert np.array_equal(raised.slope[0], expected.value)


@given(st.integers(-700, 700), st.integers(1, 700))
def test_fractions_come_back(top: int, bottom: int) -> None:
    exact = sp.Rational(top, bottom)
    found = rational(residue(exact), PRIME)
    assert found is not None
    assert (found.numerator, found.denominator) == (exact.p, exact.q)


def test_a_residue_taken_at_random_is_no_fraction() -> None:
    rng = np.random.default_rng(8)
    found = [rational(int(r), PRIME) for r in rng.integers(0, PRIME, 1000)]
    assert sum(fraction is not None for fraction in found) < 5


@given(st.lists(st.lists(st.integers(-3, 3), min_size=4, max_size=4), min_size=1, max_size=5))
def test_null_space_and_independent_columns(rows: list[list[int]]) -> None:
    matrix = np.array(rows, dtype=np.int64) % PRIME
    exact = sp.Matrix(rows)
    basis = nullspace(matrix)
    assert len(basis) == 4 - exact.rank()
    for vector in basis:
        assert not ((matrix * vector % PRIME).sum(axis=1) % PRIME).any()
    assert independent_columns(matrix) == list(exact.rref()[1])


def test_combination_and_its_absence() -> None:
    columns = np.array([[1, 0], [1, 1], [0, 2]], dtype=np.int64)
    assert combination(columns, np.array([3, 5, 4])) == [3, 2]
    assert combination(columns, np.array([3, 5, 5])) is None


@given(st.integers(1, PRIME - 1))
def test_square_roots_and_reciprocals(number: int) -> None:
    value = np.array([number])
    root, exists = square_root(value * value % PRIME)
    assert exists[0]
    assert root[0] in (number, PRIME - number)
    assert inverse(value)[0] * number % PRIME == 1


def test_weights_are_mass_length_and_time() -> None:
    known = weights(restricted_system(from_catalogue("chaplygin-ball")))
    m, R, I_1 = (known[real_symbol(n)] for n in ("m", "R", "I_1"))
    moment = known[M.symbols[0]]
    turn = known[omega.symbols[2]]
    assert sp.Matrix([m, R, turn]).rank() == len(m) == 3
    assert tuple(a + 2 * b for a, b in zip(m, R, strict=True)) == I_1
    assert tuple(a + b for a, b in zip(I_1, turn, strict=True)) == moment
    assert not any(known[gamma.symbols[1]])


def test_entries_that_are_zero_tie_no_weights() -> None:
    """The tensor of a rattleback's shape has zeros; its semi-axes are lengths all the same."""
    known = weights(restricted_system(from_catalogue("rattleback")))
    length, square = known[real_symbol("b_3")], known[real_symbol("B_33")]
    assert any(length)
    assert square == tuple(2 * w for w in length)


def test_points_lie_on_level_and_phase_space() -> None:
    system = from_catalogue("ball-around-sphere")
    made = restricted_system(system, [real_symbol("k") + 1], [])
    sample = made.sample(50, 5, common=False)
    assert not sample(norm_squared(gamma) - 1).value.any()
    assert (sample(real_symbol("k")).value == PRIME - 1).all()
    assert len(set(sample(real_symbol("m")).value.tolist())) > 40
    together = made.sample(50, 5, common=True)
    assert len(set(together(real_symbol("m")).value.tolist())) == 1
    level = restricted_system(from_catalogue("chaplygin-ball"), (), [dot(M, gamma)])
    on_level = level.sample(50, 5, common=True)
    assert not on_level(dot(M, gamma)).value.any()
    assert on_level.along(on_level(M.symbols[0])).any()
    assert not on_level.along(on_level(dot(M, omega))).any()


def test_a_level_that_cannot_be_solved_is_refused() -> None:
    with pytest.raises(InputError, match="degree one or two"):
        restricted_system(from_catalogue("chaplygin-ball"), (), [norm_squared(M) ** 2 - 1]).sample(
            5, 1, common=True
        )


def test_monomials_and_their_rates() -> None:
    system = from_catalogue("chaplygin-ball")
    ansatz = Ansatz(M.symbols, gamma.symbols, 2, 1)
    sample = restricted_system(system).sample(10, 2, common=True)
    made = table(ansatz, sample)
    assert len(made.exponents) == ansatz.size == 40
    for index in (0, 7, 23, 39):
        powers = made.exponents[index]
        monomial = sp.Mul(*(s**e for s, e in zip(system.symbols, powers, strict=True)))
        jet = sample(monomial)
        assert np.array_equal(made.value[index], jet.value)
        assert np.array_equal(made.rate[index], sample.along(jet))


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("M·γ", dot(M, gamma)),
        ("(M, γ) = 1/2", dot(M, gamma) - sp.Rational(1, 2)),
        ("(γ, A γ)", dot(gamma, A * gamma)),
        ("dot(J*gamma, gamma)", dot(J * gamma, gamma)),
        ("M² − 2", norm_squared(M) - 2),
        ("γ₃**2 + m", gamma.symbols[2] ** 2 + real_symbol("m")),
        (
            "1 - m*R**2*(γ, A γ)",
            1 - real_symbol("m") * real_symbol("R") ** 2 * dot(gamma, A * gamma),
        ),
    ],
)
def test_formulas_as_typed(typed: str, meant: sp.Expr) -> None:
    assert formula(typed, from_catalogue("chaplygin-ball")) == meant


def test_conditions_and_names_as_typed() -> None:
    system = from_catalogue("ball-on-sphere")
    assert condition("k = -1", system) == real_symbol("k") + 1
    assert condition("I_1 = I_2", system) == real_symbol("I_1") - real_symbol("I_2")
    assert quantities("ω, γ_3", system) == (*omega.symbols, gamma.symbols[2])
    assert code_spelling("Γ₁² λ") == "Gamma_1**2 lambda"
    with pytest.raises(InputError, match="unknown name 'omega_1'"):
        condition("omega_1 = 1", system)
