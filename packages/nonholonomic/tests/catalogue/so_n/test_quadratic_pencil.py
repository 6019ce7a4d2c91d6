"""Quadratic integrals in n dimensions, exactly, against equations of motion with multipliers."""

from __future__ import annotations

import random
from dataclasses import dataclass
from itertools import combinations

import pytest
import sympy as sp
from flint import fmpq, fmpq_mat

from flowlanes.errors import InputError
from flowlanes.system.laws import Integral
from flowlanes.system.system import System
from flowlanes.system.vectors import real_symbol
from lawproof.proof.prover import prove
from nonholonomic.catalogue.so_n.quadratic_pencil import (
    QuadraticPencil,
    conserved_weights,
    manakov_moments,
)

Matrix = sp.MatrixBase
GENERIC = sp.Matrix([[0, 5, 11, 16], [5, 0, 23, 9], [11, 23, 0, 14], [16, 9, 14, 0]]) / 10
CONTACTS = ("veselova", "rubber", "marble")


def wedge(a: Matrix, b: Matrix) -> Matrix:
    return a * b.T - b * a.T


def solved(matrix: Matrix, right: Matrix) -> Matrix:
    """The exact solution of linear equations with rational coefficients."""
    rows = [[fmpq(int(x.p), int(x.q)) for x in matrix.row(i)] for i in range(matrix.rows)]
    column = [[fmpq(int(x.p), int(x.q))] for x in right]
    solution = fmpq_mat(rows).solve(fmpq_mat(column))
    return sp.Matrix([sp.Rational(int(x.p), int(x.q)) for x in solution.entries()])


@dataclass(frozen=True)
class Body:
    """An operator of inertia: I_ij by entries, or Jω + ωJ."""

    moments: Matrix | None = None
    tensor: Matrix | None = None

    @property
    def D(self) -> sp.Rational:
        """m R² of the ball."""
        return sp.Rational(4, 5)

    def of(self, omega: Matrix) -> Matrix:
        if self.tensor is not None:
            return self.tensor * omega + omega * self.tensor
        return self.moments.multiply_elementwise(omega)


@dataclass(frozen=True)
class Moment:
    """ω, k and γ at a moment, with their rates."""

    omega: Matrix
    k: Matrix
    omega_dot: Matrix
    k_dot: Matrix
    gamma: Matrix
    gamma_dot: Matrix

    def rate(self, tensor: Matrix, order: int) -> sp.Expr:
        """The rate of a member of the pencil, which is bilinear in ω and k."""
        pencil = QuadraticPencil(self.omega_dot, self.k, tensor)
        return pencil.coefficient(order) + QuadraticPencil(
            self.omega, self.k_dot, tensor
        ).coefficient(order)

    def weighted_rate(self, weights: Matrix) -> sp.Expr:
        """The rate of Σ K_ij ω_ij k_ij."""
        total = self.omega_dot.multiply_elementwise(self.k) + self.omega.multiply_elementwise(
            self.k_dot
        )
        return sum(weights.multiply_elementwise(total)) / 2


def vector(n: int, draw: random.Random) -> Matrix:
    return sp.Matrix([sp.Rational(draw.randint(-9, 9), draw.randint(1, 5)) for _ in range(n)])


def unit(n: int, draw: random.Random) -> Matrix:
    """A rational point of the sphere, by stereographic projection."""
    t = vector(n - 1, draw)
    square = (t.T * t)[0]
    return sp.Matrix([*(2 * t), square - 1]) / (square + 1)


def constrained(body: Body, contact: str, draw: random.Random, n: int) -> Moment:
    """A body that turns in planes through γ alone: (Iω)˙ = [Iω, ω] + Λ, Λ in no such plane."""
    gamma = unit(n, draw)
    heavier = body.D if contact == "rubber" else 0
    u = vector(n, draw)
    u = u - (u.T * gamma)[0] * gamma
    omega = wedge(u, gamma)
    momentum = body.of(omega) + heavier * omega
    columns = []
    for i in range(n):
        turn = wedge(sp.eye(n).col(i), gamma)
        columns.append((body.of(turn) + heavier * turn) * gamma + gamma[i] * gamma)
    change = solved(sp.Matrix.hstack(*columns), (momentum * omega - omega * momentum) * gamma)
    omega_dot = wedge(change, gamma)
    momentum_dot = body.of(omega_dot) + heavier * omega_dot
    p, gamma_dot = momentum * gamma, -omega * gamma
    p_dot = momentum_dot * gamma + momentum * gamma_dot
    k_dot = wedge(p_dot, gamma) + wedge(p, gamma_dot)
    return Moment(omega, wedge(p, gamma), omega_dot, k_dot, gamma, gamma_dot)


def marble(body: Body, draw: random.Random, n: int, zero_momentum: bool = True) -> Moment:
    """A ball that rolls without slipping: k = Iω + D(ωΓ + Γω) is constant in space."""
    gamma = unit(n, draw)
    outer = gamma * gamma.T
    planes = list(combinations(range(n), 2))

    def skew(entries: Matrix) -> Matrix:
        matrix = sp.zeros(n)
        for value, (i, j) in zip(entries, planes, strict=True):
            matrix[i, j], matrix[j, i] = value, -value
        return matrix

    def above(matrix: Matrix) -> Matrix:
        return sp.Matrix([matrix[i, j] for i, j in planes])

    def of(omega: Matrix) -> Matrix:
        return body.of(omega) + body.D * (omega * outer + outer * omega)

    basis = [skew(sp.eye(len(planes)).col(i)) for i in range(len(planes))]
    operator = sp.Matrix.hstack(*(above(of(turn)) for turn in basis))
    p = vector(n, draw)
    k = wedge(p - (p.T * gamma)[0] * gamma, gamma)
    if not zero_momentum:
        k = skew(vector(len(planes), draw))
    omega = skew(solved(operator, above(k)))
    gamma_dot = -omega * gamma
    outer_dot = gamma_dot * gamma.T + gamma * gamma_dot.T
    k_dot = k * omega - omega * k
    rest = k_dot - body.D * (omega * outer_dot + outer_dot * omega)
    omega_dot = skew(solved(operator, above(rest)))
    return Moment(omega, k, omega_dot, k_dot, gamma, gamma_dot)


def at(body: Body, contact: str, draw: random.Random, n: int) -> Moment:
    return marble(body, draw, n) if contact == "marble" else constrained(body, contact, draw, n)


def distinct(n: int, draw: random.Random) -> list[sp.Rational]:
    return sorted(sp.Rational(x, 7) for x in draw.sample(range(1, 60), n))


def rotation(n: int, draw: random.Random) -> Matrix:
    """A rational rotation (Cayley)."""
    half = sp.zeros(n)
    for i, j in combinations(range(n), 2):
        half[i, j] = sp.Rational(draw.randint(-2, 2), 3)
        half[j, i] = -half[i, j]
    return (sp.eye(n) - half) * (sp.eye(n) + half).inv()


# --- conservation ----------------------------------------------------------------------------


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("n", [3, 4, 5])
def test_every_manakov_operator_has_the_pencil(n: int, contact: str) -> None:
    draw = random.Random(f"{n} {contact}")
    c, b = distinct(n, draw), distinct(n, draw)
    moment = at(Body(manakov_moments(b, c)), contact, draw, n)
    assert [moment.rate(sp.diag(*c), order) for order in range(1, n)] == [0] * (n - 1)


@pytest.mark.parametrize("contact", CONTACTS)
@pytest.mark.parametrize("n", [3, 4])
def test_every_rigid_body_has_it_in_any_axes(n: int, contact: str) -> None:
    draw = random.Random(f"body {n} {contact}")
    turn = rotation(n, draw)
    tensor = turn * sp.diag(*distinct(n, draw)) * turn.T
    assert not tensor.is_diagonal()
    moment = at(Body(tensor=tensor), contact, draw, n)
    assert [moment.rate(tensor, order) for order in range(1, n)] == [0] * (n - 1)


@pytest.mark.parametrize("contact", CONTACTS)
def test_equal_entries_of_the_mass_tensor_are_allowed(contact: str) -> None:
    draw = random.Random(contact)
    tensor = sp.diag(1, 1, 3, 5)
    moment = at(Body(tensor=tensor), contact, draw, 4)
    assert [moment.rate(tensor, order) for order in (1, 2, 3)] == [0] * 3


@pytest.mark.parametrize("contact", CONTACTS)
def test_a_generic_operator_has_only_energy_and_momentum(contact: str) -> None:
    draw = random.Random(f"generic {contact}")
    ones = sp.ones(4) - sp.eye(4)
    moment = at(Body(GENERIC), contact, draw, 4)
    assert moment.weighted_rate(ones) == moment.weighted_rate(GENERIC) == 0
    planes = list(combinations(range(4), 2))
    rates = []
    for _ in range(6):
        moment = at(Body(GENERIC), contact, draw, 4)
        row = []
        for plane in planes:
            single = sp.zeros(4)
            single[plane] = single[plane[::-1]] = 1
            row.append(moment.weighted_rate(single))
        rates.append(row)
    assert sp.Matrix(rates).rank() == 4


@pytest.mark.parametrize("contact", CONTACTS)
def test_wrong_weights_are_not_conserved(contact: str) -> None:
    draw = random.Random(f"planted {contact}")
    c, b = distinct(4, draw), distinct(4, draw)
    moment = at(Body(manakov_moments(b, c)), contact, draw, 4)
    slipped = [c[0] + 1, *c[1:]]
    assert moment.rate(sp.diag(*slipped), 3) != 0
    # the b_i serve the inverse operator, not this one
    assert moment.rate(sp.diag(*b), 3) != 0


def test_off_the_level_the_marble_ball_loses_it() -> None:
    draw = random.Random(7)
    tensor = sp.diag(1, 2, 4, 7)
    moment = marble(Body(tensor=tensor), draw, 4, zero_momentum=False)
    assert moment.rate(tensor, 1) == 0
    assert moment.rate(tensor, 3) != 0


@pytest.mark.parametrize("contact", ["veselova", "rubber"])
def test_a_quadratic_potential_keeps_it(contact: str) -> None:
    # the torque γ ∧ ∂U changes ω̇ by u̇ with B u̇ = ∂U across γ, and k by ∂U ∧ γ
    draw = random.Random(f"field {contact}")
    n, strength = 4, sp.Rational(3, 2)
    tensor = sp.diag(*distinct(n, draw))
    body = Body(tensor=tensor)
    free = constrained(body, contact, draw, n)
    heavier = body.D if contact == "rubber" else 0
    columns = []
    for i in range(n):
        turn = wedge(sp.eye(n).col(i), free.gamma)
        columns.append((body.of(turn) + heavier * turn) * free.gamma + free.gamma[i] * free.gamma)
    force = strength * tensor * free.gamma
    across = force - (force.T * free.gamma)[0] * free.gamma
    change = solved(sp.Matrix.hstack(*columns), across)
    moment = Moment(
        free.omega,
        free.k,
        free.omega_dot + wedge(change, free.gamma),
        free.k_dot + wedge(across, free.gamma),
        free.gamma,
        free.gamma_dot,
    )

    def rate(order: int, sign: int) -> sp.Expr:
        # ε (γ, J^m γ) is quadratic: its rate by polarisation
        zero = sp.zeros(n)

        def field(gamma: Matrix) -> sp.Expr:
            return QuadraticPencil(zero, zero, tensor, gamma, strength).coefficient(order)

        forward, backward = free.gamma + free.gamma_dot, free.gamma - free.gamma_dot
        return moment.rate(tensor, order) + sign * (field(forward) - field(backward)) / 2

    assert [rate(order, 1) for order in (1, 2, 3)] == [0] * 3
    assert all(rate(order, -1) != 0 for order in (1, 2, 3))


# --- proofs of a System ----------------------------------------------------------------------


def veselova(tensor: Matrix) -> tuple[System, QuadraticPencil]:
    """The Veselova top with rational numbers, in p and γ, and its pencil."""
    n = tensor.rows
    gamma, p, u = (
        sp.Matrix([real_symbol(f"{name}_{i + 1}") for i in range(n)])
        for name in ("gamma", "p", "u")
    )
    matrix = gamma * gamma.T
    for i, j in combinations(range(n), 2):
        moment = tensor[i, i] + tensor[j, j]
        matrix[i, i] += moment * gamma[j] ** 2
        matrix[j, j] += moment * gamma[i] ** 2
        matrix[i, j] -= moment * gamma[i] * gamma[j]
        matrix[j, i] = matrix[i, j]
    Delta = real_symbol("Delta")
    names = sp.Matrix(n, n, lambda i, j: real_symbol(f"B_{min(i, j) + 1}{max(i, j) + 1}"))
    system = System(
        name="veselova",
        title="Veselova top",
        field={
            **dict(zip(p, (u.T * p)[0] * gamma, strict=True)),
            **dict(zip(gamma, -u, strict=True)),
        },
        definitions={
            **{names[i, j]: matrix[i, j] for i in range(n) for j in range(i, n)},
            Delta: sp.expand(names.det(method="berkowitz")),
            **dict(zip(u, names.adjugate() * p / Delta, strict=True)),
        },
        relations=((gamma.T * gamma)[0] - 1, (p.T * gamma)[0]),
    )
    return system, QuadraticPencil(wedge(u, gamma), wedge(p, gamma), tensor)


@pytest.mark.slow
def test_the_prover_proves_the_laws_in_three_dimensions() -> None:
    system, pencil = veselova(sp.diag(1, 2, 4))
    assert [prove(system, law).decision for law in pencil.integrals()] == ["proven"] * 2


@pytest.mark.slow
def test_the_prover_proves_the_laws_in_four_dimensions() -> None:
    system, pencil = veselova(sp.diag(1, 2, 4, 7))
    assert [prove(system, law).decision for law in pencil.integrals()] == ["proven"] * 3
    slipped = QuadraticPencil(pencil.omega, pencil.k, sp.diag(1, 2, 4, 8))
    assert prove(system, slipped.integrals()[2]).decision == "refuted"


# --- the family ------------------------------------------------------------------------------


@pytest.mark.parametrize("n", [3, 4, 5, pytest.param(6, marks=pytest.mark.slow)])
def test_they_are_independent(n: int) -> None:
    # at one γ the rank in p alone is n − 1
    draw = random.Random(n)
    tensor = sp.diag(*distinct(n, draw))
    gamma = unit(n, draw)
    columns = [
        (Body(tensor=tensor).of(wedge(sp.eye(n).col(i), gamma))) * gamma + gamma[i] * gamma
        for i in range(n)
    ]
    operator = sp.Matrix.hstack(*columns)
    p = vector(n, draw)
    p = p - (p.T * gamma)[0] * gamma
    # F is a quadratic form of p: half its gradient along e is F(p, e)
    slopes = []
    for axis in range(n):
        across = sp.eye(n).col(axis) - gamma[axis] * gamma
        omega = wedge(solved(operator, across), gamma)
        pencil = QuadraticPencil(omega, wedge(p, gamma), tensor)
        slopes.append([pencil.coefficient(order) for order in range(1, n)])
    assert sp.Matrix(slopes).rank() == n - 1


def test_the_members_are_combinations_of_the_coefficients() -> None:
    draw = random.Random(3)
    c = distinct(4, draw)
    moment = constrained(Body(tensor=sp.diag(*c)), "veselova", draw, 4)
    pencil = QuadraticPencil(moment.omega, moment.k, sp.diag(*c))
    number = sp.Rational(11, 3)
    by_hand = sum(
        moment.omega[i, j] * moment.k[i, j] / ((number - c[i]) * (number - c[j]))
        for i, j in combinations(range(4), 2)
    )
    assert pencil.member(number) == by_hand
    # ∏(λ − c_i) F_λ has degree n − 2 and the coefficients follow from three of them
    s = sum(c)
    t = sum(x * y for x, y in combinations(c, 2))
    G = [pencil.coefficient(order) for order in (1, 2, 3)]
    polynomial = G[0] * number**2 + (G[1] - s * G[0]) * number + (G[2] - s * G[1] + t * G[0])
    assert polynomial == by_hand * sp.prod(number - x for x in c)


@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_weights_form_a_space_of_the_right_dimension(n: int) -> None:
    draw = random.Random(n)
    c, b = distinct(n, draw), distinct(n, draw)
    space = [list(w) for w in conserved_weights(manakov_moments(b, c))]
    assert len(space) == n - 1
    number = sp.Rational(1, 2)
    member = sp.Matrix(n, n, lambda i, j: 1 / ((number - c[i]) * (number - c[j])) if i != j else 0)
    assert sp.Matrix([*space, list(member)]).rank() == n - 1
    generic = sp.zeros(n)
    for i, j in combinations(range(n), 2):
        generic[i, j] = generic[j, i] = draw.randint(1, 10**6)
    assert len(conserved_weights(generic)) == 2


def test_laws_carry_their_level() -> None:
    x = real_symbol("x")
    zero = sp.zeros(3)
    laws = QuadraticPencil(zero, zero, sp.diag(1, 2, 3)).integrals(on=(x,))
    assert all(isinstance(law, Integral) and law.level == (x,) for law in laws)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: manakov_moments([1, 2], [1, 2]), "at least 3"),
        (lambda: manakov_moments([1, 2, 3], [1, 2, 2]), "entries 2 and 3 are equal"),
        (lambda: conserved_weights(sp.ones(3, 4)), "3 × 4"),
        (lambda: QuadraticPencil(sp.zeros(3), sp.zeros(4), sp.eye(3)), "k: a matrix of 3 × 3"),
        (lambda: QuadraticPencil(sp.eye(3), sp.zeros(3), sp.eye(3)), "omega: the matrix must be"),
        (
            lambda: QuadraticPencil(
                sp.zeros(3), sp.zeros(3), sp.Matrix([[1, 1, 0], [0, 1, 0], [0, 0, 1]])
            ),
            "tensor: the matrix must be symmetric",
        ),
        (
            lambda: QuadraticPencil(sp.zeros(3), sp.zeros(3), sp.eye(3), strength=sp.S.One),
            "gamma: its components are needed",
        ),
        (
            lambda: QuadraticPencil(sp.zeros(3), sp.zeros(3), sp.diag(1, 2, 3)).member(2),
            "2 is an eigenvalue",
        ),
        (
            lambda: QuadraticPencil(sp.zeros(3), sp.zeros(3), sp.eye(3)).coefficient(0),
            "order: must be at least 1",
        ),
    ],
)
def test_mistakes_are_one_sentence(call: object, words: str) -> None:
    with pytest.raises(InputError, match=words):
        call()  # type: ignore[operator]
