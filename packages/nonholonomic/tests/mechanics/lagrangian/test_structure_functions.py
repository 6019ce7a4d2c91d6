"""Structure functions of frames (1.8)."""

from __future__ import annotations

import itertools

import pytest
import sympy as sp

from flowlanes import InputError
from flowlanes.system.vectors import Vector, cross, dot, norm_squared, real_symbol, to_components
from nonholonomic.mechanics.lagrangian.mechanism import Frame, coordinates, euclidean, rotations
from nonholonomic.mechanics.lagrangian.structure_functions import (
    check_structure,
    commutator,
    structure,
)

omega, v, alpha, beta, gamma, R = (Vector(n) for n in ("omega", "v", "alpha", "beta", "gamma", "R"))
x, y, u, w, theta, phi, psi = (real_symbol(n) for n in ("x", "y", "u", "w", "theta", "phi", "psi"))
ORTHONORMAL = (
    *(norm_squared(a) - 1 for a in (alpha, beta, gamma)),
    dot(alpha, beta),
    dot(beta, gamma),
    dot(gamma, alpha),
)
TURNING = {(0, 1, 2): 1, (0, 2, 1): -1, (1, 2, 0): 1}


def quaternion() -> Frame:
    q = Vector("q", 4)
    (a, b, c, d), (p, q_, r) = q.symbols, omega.symbols
    rates = {
        a: -(b * p + c * q_ + d * r) / 2,
        b: (a * p + c * r - d * q_) / 2,
        c: (a * q_ + d * p - b * r) / 2,
        d: (a * r + b * q_ - c * p) / 2,
    }
    return Frame(rates, (omega,), (a**2 + b**2 + c**2 + d**2 - 1,))


def euler() -> Frame:
    p, q, r = omega.symbols
    over = (p * sp.sin(phi) + q * sp.cos(phi)) / sp.sin(theta)
    return Frame(
        {theta: p * sp.cos(phi) - q * sp.sin(phi), psi: over, phi: r - over * sp.cos(theta)},
        (omega,),
    )


@pytest.mark.parametrize(
    "frame",
    [
        Frame({a: cross(a, omega) for a in (alpha, beta, gamma)}, (omega,), ORTHONORMAL),
        quaternion(),
        euler(),
        Frame({gamma: cross(gamma, omega)}, (omega,), structure=rotations(omega)),
    ],
    ids=["direction cosines", "quaternions", "Euler angles", "given"],
)
def test_rotations_in_every_description(frame: Frame) -> None:
    assert structure(frame) == TURNING


def test_motions_of_space() -> None:
    """(1.12), computed from (1.11) and as it is given by name."""
    turn = {a: cross(a, omega) for a in (alpha, beta, gamma)}
    shift = {s: dot(a, v) for s, a in zip(R.symbols, (alpha, beta, gamma), strict=True)}
    computed = structure(Frame({**turn, **shift}, (omega, v), ORTHONORMAL))
    assert computed == structure(Frame({}, (omega, v), structure=euclidean(omega, v)))
    assert len(computed) == 9


def test_coordinates_commute() -> None:
    assert structure(coordinates(x, y, theta)) == {}


def test_structure_functions_solve_their_equations() -> None:
    frame = Frame({x: u * (1 + y**2), y: w * sp.exp(x) + u}, (u, w))
    found = structure(frame)
    fields = [frame.field(i) for i in range(2)]
    for i, j in itertools.combinations(range(2), 2):
        bracket = commutator(fields[i], fields[j])
        for row, q in enumerate(frame.coordinates):
            span = sum(frame.matrix[row, k] * found.get((i, j, k), 0) for k in range(2))
            assert sp.simplify(bracket.get(q, 0) - span) == 0


def test_antisymmetry_of_what_is_given() -> None:
    swapped = {(u, w): {u: x}}
    frame = Frame({x: u, y: w}, (w, u), structure=swapped)
    assert structure(frame) == {(0, 1, 1): -x}


def test_mistakes() -> None:
    with pytest.raises(InputError, match="does not span: its fields are dependent"):
        structure(Frame({x: u + w, y: 2 * u + 2 * w}, (u, w)))
    with pytest.raises(InputError, match="2 velocities for a configuration space of dimension 3"):
        structure(Frame({x: u, y: w, theta: x * w}, (u, w)))
    with pytest.raises(InputError, match="names theta, which is no velocity"):
        structure(Frame({x: u}, (u,), structure={(u, theta): {u: sp.S.One}}))


def test_what_is_given_must_be_possible() -> None:
    p, q, r = omega.symbols
    check_structure(Frame({gamma: cross(gamma, omega)}, (omega,), structure=rotations(omega)))
    impossible = {(p, q): {r: sp.S.One}, (q, r): {q: sp.S.One}}
    with pytest.raises(InputError, match="identity of Jacobi"):
        check_structure(Frame({x: p}, (omega,), structure=impossible))
    with pytest.raises(InputError, match="they differ on the coordinate x"):
        check_structure(Frame({x: u}, (u, w), structure={(u, w): {u: sp.S.One}}))


def test_commutator_is_a_derivation() -> None:
    first, second = {x: y}, {y: x * y}
    assert to_components(sp.Matrix(list(commutator(first, second).values()))) == sp.ImmutableMatrix(
        [-x * y, y**2]
    )
