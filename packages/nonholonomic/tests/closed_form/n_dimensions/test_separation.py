"""The reduction to the curve, exactly at random rational points.

With G(z) = ∏ (z − z_k) the equations of the separated variables say that (dG/dτ)² and Y F², F the
factor of the speeds, are the same polynomial modulo G.  Both sides are rational in p and γ.
"""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import combinations

import pytest
from flint import fmpq, fmpq_poly

from flowlanes.formulas.jets import Evaluator, Jet
from flowlanes.formulas.number_fields import Rationals
from flowlanes.system.vectors import to_components
from nonholonomic.catalogue import from_catalogue

X = fmpq_poly([0, 1])


def product(factors):
    result = fmpq_poly([1])
    for factor in factors:
        result *= factor
    return result


def random_state(n, generator):
    """Distinct a_i > 0, a rational unit vector γ and p across it."""
    a = [fmpq(x, 7) for x in generator.sample(range(2, 60), n)]
    t = [fmpq(generator.randint(-9, 9), generator.randint(1, 9)) for _ in range(n - 1)]
    square = sum((x * x for x in t), fmpq(0))
    gamma = [*(2 * x / (1 + square) for x in t), (1 - square) / (1 + square)]
    p = [fmpq(generator.randint(-20, 20), generator.randint(1, 9)) for _ in range(n)]
    along = sum((x * y for x, y in zip(p, gamma, strict=True)), fmpq(0))
    return a, [x - along * y for x, y in zip(p, gamma, strict=True)], gamma


def dot(*vectors):
    total = fmpq(0)
    for entries in zip(*vectors, strict=True):
        term = fmpq(1)
        for x in entries:
            term *= x
        total += term
    return total


def coordinates(poles, vector, rate):
    """G and dG/dt."""
    squares = [y * y for y in vector]
    changes = [2 * y * r for y, r in zip(vector, rate, strict=True)]
    return weighted(poles, squares), weighted(poles, changes)


def wedge(x, y):
    return {(i, j): x[i] * y[j] - x[j] * y[i] for i, j in combinations(range(len(x)), 2)}


def pencil(poles, planes):
    """Σ x_ij ∏ (z − c_l) over l ≠ i, j."""
    return sum(
        (
            x * product([X - c for m, c in enumerate(poles) if m not in pair])
            for pair, x in planes.items()
        ),
        fmpq_poly([0]),
    )


def weighted(poles, weights):
    """Σ weights_i ∏ (z − c_j) over j ≠ i."""
    others = [product([X - c for j, c in enumerate(poles) if j != i]) for i in range(len(poles))]
    return sum((w * q for w, q in zip(weights, others, strict=True)), fmpq_poly([0]))


def velocity(a, p, gamma):
    """W and u of the Veselova system."""
    W = dot(a, gamma, gamma)
    along = sum((x * y / z for x, y, z in zip(p, gamma, a, strict=True)), fmpq(0))
    return W, [(x / z - along * y) / W for x, y, z in zip(p, gamma, a, strict=True)]


def integral_of_veselova(a, p, gamma):
    _, u = velocity(a, p, gamma)
    spin, k = wedge(u, gamma), wedge(p, gamma)
    return pencil([1 / x for x in a], {pair: spin[pair] * k[pair] for pair in k})


def integral_of_ball(a, p, gamma):
    W = sum((y * y / x for x, y in zip(a, gamma, strict=True)), fmpq(0))
    k = wedge(p, gamma)
    G = weighted(a, [y * y for y in gamma])
    return (X * pencil(a, {pair: x * x for pair, x in k.items()}) - dot(p, p) * G) / W


def integral_of_surrounding(a, p, gamma, slip=0):
    W, u = velocity(a, p, gamma)
    turns = wedge(gamma, u)
    K = pencil([1 / x for x in a], {(i, j): a[i] * a[j] * x * x / W for (i, j), x in turns.items()})
    squares = [x * y * y / W for x, y in zip(a, gamma, strict=True)]
    return (1 + slip) * K - dot(p, u) * weighted([1 / x for x in a], squares)


def veselova(a, p, gamma, slip=0):
    W, u = velocity(a, p, gamma)
    c = [1 / x for x in a]
    G, change = coordinates(c, gamma, [-x for x in u])
    Y = (-4 + slip) * X * integral_of_veselova(a, p, gamma) * product([X - x for x in c])
    return W * change * change - Y, G


def ball(a, p, gamma, slip=0):
    D = a[0] * a[0] + 3
    W = sum((y * y / x for x, y in zip(a, gamma, strict=True)), fmpq(0))
    along = dot(a, p, gamma)
    rate = [
        (-W * x + (s * x - along * y) / D) / (D * W) for s, x, y in zip(a, p, gamma, strict=True)
    ]
    G, change = coordinates(a, gamma, rate)
    T = integral_of_ball(a, p, gamma)
    assert T.degree() <= len(a) - 2
    whole = fmpq(1)
    for x in a:
        whole *= x
    volume = (-1) ** (len(a) - 1) * G(fmpq(0))
    # ∏ z_l over l ≠ k is ∏z/z_k
    factor = volume - (1 + slip) * whole / D * X
    Y = -4 * X * T * product([X - x for x in a])
    return D * D * whole * volume * change * change * X * X - Y * factor * factor, G


def surrounding(a, p, gamma, slip=0):
    """y = A^(1/2)γ/W^(1/2), all of it rational in squares and y_i y_i′."""
    W, u = velocity(a, p, gamma)
    c = [1 / x for x in a]
    pull = dot(a, gamma, u) / W
    G = weighted(c, [s * y * y / W for s, y in zip(a, gamma, strict=True)])
    # y_i y_i′ = a_i γ_i (u_i − pull γ_i)/√W
    half = weighted(c, [2 * s * y * (v - pull * y) for s, y, v in zip(a, gamma, u, strict=True)])
    Q = integral_of_surrounding(a, p, gamma, slip)
    return half * half / W + 4 * Q * product([X - x for x in c]), G


@pytest.mark.parametrize("equations", [veselova, ball])
@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_the_separated_variables_obey_their_equations(equations, n):
    generator = random.Random(n)
    planted = []
    for _ in range(6):
        state = random_state(n, generator)
        difference, G = equations(*state)
        assert difference % G == 0
        difference, G = equations(*state, slip=fmpq(1, 1000))
        planted.append(difference % G)
    assert any(x != 0 for x in planted)


@pytest.mark.parametrize("n", [3, 4, 5, 6])
def test_around_a_sphere_the_point_is_that_of_neumann(n):
    generator = random.Random(n)
    planted = []
    for _ in range(6):
        state = random_state(n, generator)
        difference, G = surrounding(*state)
        assert difference % G == 0
        difference, G = surrounding(*state, slip=fmpq(1, 1000))
        planted.append(difference % G)
    assert any(x != 0 for x in planted)


def residues(poles, polynomial):
    """Those of polynomial/∏ (z − c_i)."""
    return [
        polynomial(c) / product([c - x for j, x in enumerate(poles) if j != i])(fmpq(0))
        for i, c in enumerate(poles)
    ]


@pytest.mark.parametrize("n", [3, 4, 5])
@pytest.mark.parametrize(
    ("name", "integral"),
    [
        ("special-veselova-nd", integral_of_veselova),
        ("special-chaplygin-ball-nd", integral_of_ball),
        ("special-rubber-ball-on-sphere-nd", integral_of_surrounding),
    ],
)
def test_the_polynomials_are_the_integrals_that_the_catalogue_proves(name, integral, n):
    """P, T and Q have the residues −2E a_i F_i, a_i F_i and −F_i at the c_i."""
    a, p, gamma = random_state(n, random.Random(n))
    system = replace(from_catalogue(name, dimension=n), reconstruction=None)
    numbers = {f"a_{i}": x for i, x in enumerate(a, 1)}
    numbers |= {"m": a[0] * a[0] + 3, "R": fmpq(1), "a": fmpq(-1, 2)}
    laws = {law.name: law.value for law in system.integrals}
    wanted = [laws["energy"], *(laws[f"quadratic{i}"] for i in range(1, n + 1))]
    energy, *F = values(system, wanted, [*p, *gamma], numbers)
    if name == "special-veselova-nd":
        expected = [-2 * energy * x * y for x, y in zip(a, F, strict=True)]
    elif name == "special-chaplygin-ball-nd":
        expected = [x * y for x, y in zip(a, F, strict=True)]
    else:
        expected = [-y for y in F]
    poles = a if name == "special-chaplygin-ball-nd" else [1 / x for x in a]
    found = integral(a, p, gamma)
    assert residues(poles, found) == expected
    assert residues(poles, found + fmpq(1, 1000)) != expected


def values(system, formulas, point, numbers):
    """Formulas of a system at a rational state."""
    known = dict(zip(system.symbols, point, strict=True))
    known |= {q.symbol: numbers[str(q.symbol)] for q in system.parameters}
    evaluate = Evaluator(
        Rationals({}),
        {s: Jet(x, {}) for s, x in known.items()}.get,
        dict(system.scalar_definitions),
    )
    return [evaluate.value(to_components(formula)) for formula in formulas]
