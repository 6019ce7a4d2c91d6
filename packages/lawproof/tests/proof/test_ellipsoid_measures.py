"""The polynomial identities behind the theorems on ellipsoids, for m = 1.

The theorems are in nonholonomic/docs/measures.md.
B_i are the squared semi-axes; γ = (x, y, 1) near a vertex, since all formulas are homogeneous.
"""

from __future__ import annotations

import pytest
import sympy as sp

from flowlanes.system.vector_operators import hat

I = sp.symbols("I1:4")
B = sp.symbols("B1:4")
x, y, Y = sp.symbols("x y Y")


def connection(gamma):
    """q = Ĩ⁻¹γ/(γ, Ĩ⁻¹γ) by its factors of γ_i, for a rubber ellipsoid; γ by its squares."""
    s = sum(b * g for b, g in zip(B, gamma, strict=True))
    square = sum(b**2 * g for b, g in zip(B, gamma, strict=True))
    n = [i * s + square for i in I]
    plain = sum(g / k for g, k in zip(gamma, n, strict=True))
    mixed = sum(b * g / k for b, g, k in zip(B, gamma, n, strict=True))
    double = sum(b**2 * g / k for b, g, k in zip(B, gamma, n, strict=True))
    below = plain * (1 - double) + mixed**2
    return [(1 - double + mixed * b) / k / below for b, k in zip(B, n, strict=True)]


def test_the_connection_is_that_of_the_inertia_about_the_contact():
    numbers = dict(zip((*I, *B), map(sp.Integer, (3, 4, 5, 2, 3, 7)), strict=True))
    gamma = sp.Matrix([2, -1, 3])
    semi = sp.diag(*B).subs(numbers)
    r = -semi * gamma / sp.sqrt(gamma.dot(semi * gamma))
    about = sp.diag(*I).subs(numbers) + r.dot(r) * sp.eye(3) - r * r.T
    direction = about.inv() * gamma
    q = direction / gamma.dot(direction)
    factors = [f.subs(numbers) for f in connection([g**2 for g in gamma])]
    assert sp.simplify(q - sp.Matrix([f * g for f, g in zip(factors, gamma, strict=True)])) == (
        sp.zeros(3, 1)
    )


def test_rubber_ellipsoid_at_a_vertex():
    """The curl of q is 2(β − α)γ₁γ₂ to lowest order, α and β being those of q₁ and q₂."""
    alpha = sp.diff(connection([0, Y, 1])[0], Y).subs(Y, 0)
    beta = sp.diff(connection([Y, 0, 1])[1], Y).subs(Y, 0)
    found = sp.factor(sp.together(beta - alpha))
    pairs = ((0, 1), (1, 2), (2, 0))
    line = sum(I[i] * I[j] * (B[i] - B[j]) - B[i] * B[j] * (I[i] - I[j]) for i, j in pairs)
    positive = I[0] * B[0] + I[1] * B[1] + (B[0] + B[1]) * B[2]
    rest = sp.factor(sp.cancel(found / (line * positive)))
    assert rest.free_symbols
    above, below = sp.fraction(rest)
    signs = {sp.sign(c) for part in (above, below) for c in sp.Poly(part, *I, *B).coeffs()}
    assert len(signs - {1}) <= 1
    points = sp.Matrix([[1, i * b, i - b] for i, b in zip(I, B, strict=True)]).det()
    assert sp.expand(points - line) == 0


def test_rubber_ellipsoid_on_a_line():
    """Ĩ(βB + δE)γ is along γ."""
    alpha, beta, delta = sp.symbols("alpha beta delta")
    gamma = sp.symbols("g1:4")
    line = [(delta * b - alpha) / (beta * b + delta) for b in B]
    s = sum(b * g**2 for b, g in zip(B, gamma, strict=True))
    square = sum(b**2 * g**2 for b, g in zip(B, gamma, strict=True))
    L = [(beta * b + delta) * g for b, g in zip(B, gamma, strict=True)]
    product = sum(b * g * k for b, g, k in zip(B, gamma, L, strict=True))
    image = [
        (i * s + square) * k - b * g * product for i, b, g, k in zip(line, B, gamma, L, strict=True)
    ]
    factor = delta * square - alpha * s
    assert all(sp.cancel(v - factor * g) == 0 for v, g in zip(image, gamma, strict=True))


def spin():
    """The spin condition of a marble ellipsoid near γ = e₃, up to powers of (γ, Bγ) and det Ĩ."""
    gamma = sp.Matrix([x, y, 1])
    semi = sp.diag(*B)
    lever = semi * gamma
    s = gamma.dot(lever)
    inverse = (s * sp.diag(*I) + lever.dot(lever) * sp.eye(3) - lever * lever.T).adjugate()
    spread = s * semi - lever * lever.T
    turn = sp.Matrix(hat(sp.ImmutableDenseMatrix(gamma)))
    twist = (inverse * spread * turn).trace()
    return (turn * spread * lever).dot(inverse * gamma) + s * twist


@pytest.mark.slow
def test_marble_ellipsoid_at_the_vertices():
    value = sp.diff(spin(), x, y).subs({x: 0, y: 0})
    third = sp.factor(value)
    u, v, w = sp.symbols("u v w")
    named = {I[0]: B[0] + w + u, I[1]: B[1] + w + v, I[2]: B[2] + w}
    U, V = (B[1] - B[2]) * u, (B[0] - B[2]) * v
    T = (B[0] - B[1]) * u * v - (B[1] - B[2]) * u * w + (B[0] - B[2]) * v * w
    stated = [
        (B[0] + B[1], B[0] * B[2] + B[1] ** 2 + B[1] * B[2], B[0] ** 2 + B[0] * B[2] + B[1] * B[2]),
        (B[0] + B[2], B[0] * B[1] + B[1] * B[2] + B[2] ** 2, B[0] ** 2 + B[0] * B[2] + B[2] ** 2),
        (B[1] + B[2], B[1] ** 2 + B[1] * B[2] + B[2] ** 2, B[0] * B[1] + B[0] * B[2] + B[2] ** 2),
    ]
    vertices = ((0, 1, 2), (2, 0, 1), (1, 2, 0))
    for vertex, (a, b, c) in zip(vertices, stated, strict=True):
        cyclic = {I[i]: I[j] for i, j in enumerate(vertex)} | {
            B[i]: B[j] for i, j in enumerate(vertex)
        }
        found = third.subs(cyclic, simultaneous=True).subs(named, simultaneous=True)
        ratio = sp.cancel(found / (a * T - b * U + c * V))
        # a power of one B_i is left
        assert len(sp.Poly(ratio, *B).terms()) == 1
        assert ratio.free_symbols <= set(B)
    minor = stated[2 - 1][1] * stated[0][0] - stated[0][1] * stated[1][0]
    assert sp.expand(minor - B[0] ** 2 * (B[1] - B[2])) == 0
    # with U = V = s the equations leave T = (B₂ − B₁)s
    assert all(sp.expand((b - c) - (B[1] - B[0]) * a) == 0 for a, b, c in stated)


# --- off the centre ------------------------------------------------------------------------

a, k, ell, e = sp.symbols("a k l e")
c = sp.symbols("c1:4")


def curl(gamma, r, spread):
    """dθ of a rubber body on a plane by r and W = spread alone, times a positive factor."""
    about = sp.diag(*I) + r.dot(r) * sp.eye(3) - r * r.T
    whole = about.adjugate()
    direction = whole * gamma
    length = gamma.dot(direction)
    across = whole * length - direction * direction.T

    def twist(u, v):
        return gamma.dot(u.cross(v))

    units = [sp.Matrix([int(i == j) for j in range(3)]) for i in range(3)]
    total = 2 * twist(across * direction, spread * r) - twist(across * r, spread * direction)
    total -= r.dot(direction) * sum(twist(across * n, spread * n) for n in units)
    return sp.expand(total)


def test_the_local_curl_is_that_of_the_vertex():
    """A centred ellipsoid: the curl by r and W agrees in sign and zeros with the expansion."""
    r = sp.Matrix([-a, -k * e, 0])
    spread = sp.Matrix([[0, -k * e, 0], [-k * e, k, 0], [0, 0, ell]])
    assert sp.diff(curl(sp.Matrix([1, e, 0]), r, spread), e).subs(e, 0) == 0


@pytest.mark.slow
def test_rubber_ellipsoid_off_its_centre_at_a_vertex():
    """The curl at γ = e₁ is c₂c₃(I₂ − I₃)(a − c₁) times a positive factor and det Ĩ."""
    r = sp.Matrix([c[0] - a, c[1], c[2]])
    found = sp.factor(curl(sp.Matrix([1, 0, 0]), r, sp.diag(0, k, ell)))
    distance = (a - c[0]) ** 2
    positive = k * (distance + c[2] ** 2 + I[1]) + ell * (distance + c[1] ** 2 + I[2])
    about = sp.diag(*I) + r.dot(r) * sp.eye(3) - r * r.T
    stated = c[1] * c[2] * (I[1] - I[2]) * (a - c[0]) * positive
    ratio = sp.cancel(found / stated)
    rest = sp.cancel(ratio / about.det())
    assert rest.is_number
    assert rest != 0


@pytest.mark.slow
def test_rubber_ellipsoid_with_its_centre_on_an_axis():
    """The slope of the curl at γ = e₁ for c along e₃."""
    r = sp.Matrix([-a, -k * e, c[2]])
    spread = sp.Matrix([[0, -k * e, 0], [-k * e, k, 0], [0, 0, ell]])
    slope = sp.diff(curl(sp.Matrix([1, e, 0]), r, spread), e).subs(e, 0)
    i, j, n = I
    square = c[2] ** 2
    P = (
        a**4 * (k + 2 * ell)
        + a**2 * (k * square + k * (j + n) + 4 * n * ell)
        + n * (k * square + j * k + 2 * n * ell)
    )
    M = a**2 * (k + ell) + k * square + k * j + n * ell
    stated = c[2] * ((i - j) * P + 2 * a * (a - k) * M * (j - n))
    about = (sp.diag(*I) + r.dot(r) * sp.eye(3) - r * r.T).subs(e, 0)
    rest = sp.cancel(slope / stated / about.det())
    assert rest.is_number
    assert rest != 0
