"""Certificates of the quadratic integrals in n dimensions.

The theorems and their proofs are in nonholonomic/docs/quadratic-integrals.md.

    python examples/quadratic_integrals.py [--long]

prints in a minute or two: the lemma as an identity of polynomials; the laws of rational bodies in
four and five dimensions, proven by the prover; how many integrals are independent; that a generic
operator of inertia has two; where Chaplygin's multiplier exists; that no further integrals of small
degree exist; and that the flow on an invariant torus is not conjugate to a linear one.  With
``--long`` the laws are also proven for all rigid bodies in four dimensions, with symbols for the
masses, and further integrals are sought up to higher degrees (some ten minutes).
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator, Sequence
from itertools import combinations, product
from math import comb

import numpy as np
import sympy as sp
from flint import Ordering, fmpz_mpoly, fmpz_mpoly_ctx, nmod_mat
from numpy.typing import NDArray
from quadratic_integrals_torus import MARBLE, TOP, nonlinear_torus

from chaplygin import Integral, Parameter, System, prove
from flowlanes.system import real_symbol
from nonholonomic.catalogue.so_n.quadratic_pencil import (
    QuadraticPencil,
    conserved_weights,
    manakov_moments,
)

PRIME = 2_147_483_647
GENERIC = ((0, 5, 11, 16), (5, 0, 23, 9), (11, 23, 0, 14), (16, 9, 14, 0))
BODY = (1, 4, 13, 30)
SPECIAL = (2, 3, 5, 7)
SEED = 20080830


# --- the lemma -----------------------------------------------------------------------------


def lemma_terms(n: int) -> Iterator[tuple[int, int]]:
    """Terms before they cancel, and terms that remain, for b and f running over unit vectors.

    The lemma says qᵀ(I(u∧γ) K(q∧γ) − K(u∧γ) I(q∧γ))γ = 0 for I_ij = (b_i − b_j)/(c_i − c_j) and
    K_ij = (f_i − f_j)/(c_i − c_j); it is bilinear in b and f.  Both operators are multiplied by
    their denominators.
    """
    names = [f"{letter}{i}" for letter in "cguq" for i in range(n)]
    context = fmpz_mpoly_ctx.get(names, Ordering.degrevlex)
    symbols = context.gens()
    c, gamma, u, q = (symbols[k * n : (k + 1) * n] for k in range(4))
    one = context.constant(1)

    def operator(unit: int, i: int, j: int) -> fmpz_mpoly:
        """I_ij for b = e_unit, times ∏ (c_unit − c_l)."""
        if unit not in (i, j):
            return 0 * one
        value = one
        for other in range(n):
            if other not in (i, j):
                value = value * (c[unit] - c[other])
        return value

    def turn(a: Sequence[fmpz_mpoly], i: int, j: int) -> fmpz_mpoly:
        return a[i] * gamma[j] - a[j] * gamma[i]

    for first, second in combinations(range(n), 2):
        total, count = 0 * one, 0
        for i, j, k in product(range(n), repeat=3):
            if i == j or j == k:
                continue
            weight = operator(first, i, j) * operator(second, j, k)
            weight -= operator(second, i, j) * operator(first, j, k)
            term = weight * turn(u, i, j) * turn(q, j, k) * q[i] * gamma[k]
            count += len(term)
            total += term
        yield count, len(total)


def check_lemma() -> None:
    """The lemma for n = 3, 4, 5."""
    for n in (3, 4, 5):
        pairs = list(lemma_terms(n))
        before = sum(count for count, _ in pairs)
        left = sum(rest for _, rest in pairs)
        print(f"  n = {n}: {before} terms in {len(pairs)} polynomials, {left} remain")


# --- the prover ----------------------------------------------------------------------------


def wedge(a: sp.MatrixBase, b: sp.MatrixBase) -> sp.MatrixBase:
    """a bᵀ − b aᵀ."""
    return a * b.T - b * a.T


def across(moments: sp.MatrixBase, gamma: sp.MatrixBase) -> sp.MatrixBase:
    """The matrix of u ↦ (I(u∧γ))γ, for moments I_ij."""
    n = len(gamma)
    matrix = sp.zeros(n)
    for i, j in combinations(range(n), 2):
        matrix[i, i] += moments[i, j] * gamma[j] ** 2
        matrix[j, j] += moments[i, j] * gamma[i] ** 2
        matrix[i, j] -= moments[i, j] * gamma[i] * gamma[j]
        matrix[j, i] = matrix[i, j]
    return matrix


def ball(
    kind: str, masses: Sequence[sp.Expr], parameters: tuple[Parameter, ...] = ()
) -> tuple[System, QuadraticPencil]:
    """A rigid body in p and γ, and its pencil; m R² = 1 of a ball, the marble on k = p ∧ γ."""
    n = len(masses)
    gamma, p, u = (
        sp.Matrix([real_symbol(f"{name}_{i + 1}") for i in range(n)])
        for name in ("gamma", "p", "u")
    )
    added = 1 if kind == "rubber" else 0
    moments = sp.Matrix(n, n, lambda i, j: masses[i] + masses[j] + added if i != j else 0)
    inverse = moments.applyfunc(lambda x: 1 / x if x != 0 else x)
    if kind == "marble":
        matrix = sp.eye(n) + across(inverse, gamma)
    else:
        matrix = gamma * gamma.T + across(moments, gamma)
    names = sp.Matrix(n, n, lambda i, j: real_symbol(f"B_{min(i, j) + 1}{max(i, j) + 1}"))
    Delta = real_symbol("Delta")
    definitions = {
        **{names[i, j]: matrix[i, j] for i in range(n) for j in range(i, n)},
        Delta: sp.expand(names.det(method="berkowitz")),
        **dict(zip(u, names.adjugate() * p / Delta, strict=True)),
    }
    # of the marble ball u is q of the note, ω = I⁻¹(q ∧ γ)
    omega = wedge(u, gamma)
    if kind == "marble":
        omega = omega.multiply_elementwise(inverse)
    field = {
        **dict(zip(p, -omega * p, strict=True)),
        **dict(zip(gamma, -omega * gamma, strict=True)),
    }
    system = System(
        name=kind,
        title=kind,
        field=field,
        parameters=parameters,
        definitions=definitions,
        relations=((gamma.T * gamma)[0] - 1, (p.T * gamma)[0]),
    )
    return system, QuadraticPencil(omega, wedge(p, gamma), sp.diag(*masses))


def check_laws(kind: str, masses: Sequence[int]) -> None:
    """Verdicts on the members of the pencil beyond energy and momentum."""
    system, pencil = ball(kind, [sp.Integer(x) for x in masses])
    for order in range(3, len(masses)):
        started = time.monotonic()
        decision = prove(system, Integral("member", pencil.coefficient(order))).decision
        seconds = time.monotonic() - started
        print(
            f"  {kind}, n = {len(masses)}, J = {tuple(masses)}: member {order} {decision}", end=""
        )
        print(f" ({seconds:.0f} s)")
    slipped = QuadraticPencil(pencil.omega, pencil.k, sp.diag(*masses[:-1], masses[-1] + 1))
    decision = prove(system, Integral("slip", slipped.coefficient(3))).decision
    print(f"  {kind}, n = {len(masses)}: the same with one J_i wrong, {decision}")


def check_all_bodies() -> None:
    """The members for n = 4 with symbols for the masses."""
    J = [real_symbol(f"J_{i + 1}") for i in range(4)]
    parameters = tuple(
        Parameter(s, f"mass in the direction {i + 1}", x, "kg m^2", (s > 0,))
        for i, (s, x) in enumerate(zip(J, (1.0, 2.0, 4.0, 7.0), strict=True))
    )
    system, pencil = ball("veselova", J, parameters)
    for order in (2, 3):
        started = time.monotonic()
        decision = prove(system, Integral("member", pencil.coefficient(order))).decision
        print(f"  member {order}: {decision} ({time.monotonic() - started:.0f} s)")


# --- how many ------------------------------------------------------------------------------


def check_numbers() -> None:
    """Dimensions of the spaces of integrals Σ K_ij ω_ij k_ij."""
    for n in (3, 4, 5, 6, 7):
        b, c = (
            [sp.Integer(i**3 + i) for i in range(1, n + 1)],
            [sp.Integer(i * i) for i in range(n)],
        )
        print(f"  n = {n}: {len(conserved_weights(manakov_moments(b, c)))}", end=";")
    print(f" generic moments, n = 4: {len(conserved_weights(sp.Matrix(GENERIC)))}")


# --- Chaplygin's multiplier ----------------------------------------------------------------


def multiplier_residuals() -> list[sp.Expr]:
    """What must vanish for a multiplier where γ lies in the plane of two body axes, n = 4.

    ½(v, ∇_X B v) = ⟨I(v∧γ), v∧X⟩ = −θ(X)(v, Bv) for v across γ and X with (Bv, X) = 0: with
    γ = (x, y, 0, 0), X = (−y, x, 0, 0) two choices of v, e_3 and e_4, give θ(X) twice.
    """
    x, y = sp.symbols("x y")
    I = sp.Matrix(4, 4, lambda i, j: sp.Symbol(f"I_{min(i, j) + 1}{max(i, j) + 1}"))
    residuals = []
    for order in ((0, 1, 2, 3), (0, 2, 1, 3), (0, 3, 1, 2)):
        axes = [sp.eye(4).col(i) for i in order]
        gamma, X = x * axes[0] + y * axes[1], x * axes[1] - y * axes[0]
        sides = []
        for v in axes[2:]:
            momentum = I.multiply_elementwise(wedge(v, gamma))
            along = (v.T * momentum * X)[0]
            square = (v.T * momentum * gamma)[0]
            sides.append((along, square))
        (first, below), (second, beneath) = sides
        residuals.append(sp.factor(first * beneath - second * below))
    return residuals


# --- no further integrals ------------------------------------------------------------------


def rates(moments: Sequence[Sequence[int]], points: int) -> tuple[NDArray[np.int64], ...]:
    """Points (u, γ) of the phase space modulo the prime, and the field there."""
    draw = np.random.default_rng(SEED)
    n = len(moments)
    states, fields = [], []
    while len(states) < points:
        t = [int(x) for x in draw.integers(1, PRIME, n - 1)]
        square = sum(x * x for x in t) % PRIME
        below = pow(square + 1, -1, PRIME)
        g = [*(2 * x * below % PRIME for x in t), (square - 1) * below % PRIME]
        u = [int(x) for x in draw.integers(1, PRIME, n)]
        along = sum(map(int.__mul__, u, g))
        u = [(x - along * y) % PRIME for x, y in zip(u, g, strict=True)]
        omega = [[u[i] * g[j] - g[i] * u[j] for j in range(n)] for i in range(n)]
        M = [[moments[i][j] * omega[i][j] % PRIME for j in range(n)] for i in range(n)]
        Mg = [sum(map(int.__mul__, row, g)) for row in M]
        speed = sum(x * x for x in u)
        # ((I u̇∧γ) − [M, ω])γ = 0 and (u̇, γ) = (u, u)
        right = [
            sum(map(int.__mul__, M[i], u)) - sum(map(int.__mul__, omega[i], Mg)) + speed * g[i]
            for i in range(n)
        ]
        left = [[g[i] * g[j] * (1 - moments[i][j]) for j in range(n)] for i in range(n)]
        for i in range(n):
            left[i][i] = g[i] * g[i] + sum(moments[i][j] * g[j] ** 2 for j in range(n) if j != i)
        change = nmod_mat(n, n, [x % PRIME for row in left for x in row], PRIME).solve(
            nmod_mat(n, 1, [x % PRIME for x in right], PRIME)
        )
        states.append([*u, *g])
        fields.append([*(int(change[i, 0]) for i in range(n)), *(-x % PRIME for x in u)])
    return np.array(states), np.array(fields)


def exponents(variables: int, degree: int) -> list[tuple[int, ...]]:
    """All monomials of one degree."""
    return [e for e in product(range(degree + 1), repeat=variables) if sum(e) == degree]


def dimension(moments: Sequence[Sequence[int]], in_u: int, in_gamma: int) -> tuple[int, int]:
    """Independent polynomials of these degrees on the phase space, and integrals among them.

    The rank modulo a prime is at most the rank over the rationals: there are no more integrals.
    """
    n = len(moments)
    monomials = [a + b for a in exponents(n, in_u) for b in exponents(n, in_gamma)]
    state, field = rates(moments, len(monomials) + 24)
    powers = [np.ones_like(state)]
    for _ in range(max(in_u, in_gamma)):
        powers.append(powers[-1] * state % PRIME)
    logarithmic = field * [[pow(int(x), -1, PRIME) for x in row] for row in state] % PRIME
    value = np.ones((len(state), len(monomials)), dtype=np.int64)
    slope = np.zeros_like(value)
    for column, powers_of in enumerate(monomials):
        for i, power in enumerate(powers_of):
            value[:, column] = value[:, column] * powers[power][:, i] % PRIME
            slope[:, column] = (slope[:, column] + power * logarithmic[:, i]) % PRIME
    ranks = [
        nmod_mat(*table.shape, table.ravel().tolist(), PRIME).rank()
        for table in (value, value * slope % PRIME)
    ]
    return ranks[0], ranks[0] - ranks[1]


def known(in_u: int, in_gamma: int, members: int) -> int:
    """How many of these are products of the members: of the energy (γ-degree 2) and others (4)."""
    if in_u % 2 or in_gamma % 2:
        return 0
    total = 0
    factors = in_u // 2
    for others in range(factors + 1):
        if 2 * factors + 2 * others <= in_gamma:
            total += comb(others + members - 2, others)
    return total


def check_search(degrees: Sequence[tuple[int, int]]) -> None:
    """Integrals polynomial in u and γ, for three operators."""
    product_moments = [
        [x * y if i != j else 0 for j, y in enumerate(SPECIAL)] for i, x in enumerate(SPECIAL)
    ]
    body = [[x + y if i != j else 0 for j, y in enumerate(BODY)] for i, x in enumerate(BODY)]
    for name, moments, members in (
        ("rigid body", body, 3),
        ("special", product_moments, 3),
        ("generic", GENERIC, 2),
    ):
        for in_u, in_gamma in degrees:
            size, found = dimension(moments, in_u, in_gamma)
            print(
                f"  {name}: degree {in_u} in u, {in_gamma} in γ: {found} of {size}, "
                f"products of those known: {known(in_u, in_gamma, members)}"
            )


def main() -> None:
    """Print all certificates."""
    started = time.monotonic()
    long = "--long" in sys.argv[1:]
    print("The lemma, polynomials in c, γ, u, q:")
    check_lemma()
    print("Laws of rational bodies:")
    for kind in ("veselova", "rubber", "marble"):
        check_laws(kind, BODY)
    check_laws("veselova", (1, 2, 4, 7, 9))
    if long:
        print("Laws of all rigid bodies, n = 4:")
        check_all_bodies()
    print("Integrals Σ K_ij ω_ij k_ij of Manakov operators:")
    check_numbers()
    print("Chaplygin's multiplier needs, n = 4, γ = (x, y, 0, 0) and two more:")
    for residual in multiplier_residuals():
        print(f"  {residual} = 0")
    print("Integrals polynomial in u and γ, n = 4 (ranks modulo 2³¹ − 1):")
    check_search([(1, 3), (2, 2), (2, 4), (3, 3), *([(2, 6), (4, 6), (4, 8)] if long else [])])
    print("Tori with the winding numbers 4 : 3 : 2, in balls:")
    for body in (TOP, MARBLE):
        for line in nonlinear_torus(body):
            print(f"  {line}")
    print(f"{time.monotonic() - started:.0f} s")


if __name__ == "__main__":
    main()
