"""Attitude where one direction alone is known to stay in space: the turn about it.

Let κ be the unit vector that is fixed in space and e another vector, not parallel to it, both in
body axes.  Seen from the body, e has in space the velocity w = ė + ω×e, and the part of e that is
orthogonal to κ turns about κ at the rate

    ψ̇ = (κ, e×w)/(e² − (e, κ)²),

a function of the state.  ψ follows by one quadrature, and the attitude from κ, e and ψ.

Numbers are taken as they come: arrays, balls (flint.arb) or formulas; a vector is a sequence of
three.  A triad is a sequence of three vectors.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import numpy as np
import sympy as sp

from ...core.laws import Identity, Rate
from ...core.vectors import constant, cross, dot, norm_squared, to_components, unit_vector, vectors
from ...formulas.balls import number
from .separation import SeparatedSystem, nu, nuprime

__all__ = [
    "Reference",
    "along",
    "farthest",
    "quaternion",
    "rate",
    "references",
    "spinning",
    "stated",
    "triad",
    "turned",
]

Triple: TypeAlias = Sequence[Any]

omega, kappa, level, a = vectors("omega spin_kappa spin_level spin_a")


# --- numbers -------------------------------------------------------------------------------


def _dot(u: Triple, v: Triple) -> Any:
    return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]


def _cross(u: Triple, v: Triple) -> tuple[Any, Any, Any]:
    return (
        u[1] * v[2] - u[2] * v[1],
        u[2] * v[0] - u[0] * v[2],
        u[0] * v[1] - u[1] * v[0],
    )


def rate(fixed: Triple, reference: Triple, velocity: Triple) -> Any:
    """ψ̇ = (κ, e×w)/(e² − (e, κ)²).

    Parameters
    ----------
    fixed : vector
        κ, of unit length, body axes.
    reference : vector
        e, body axes.
    velocity : vector
        w = ė + ω×e, body axes.
    """
    across = _dot(reference, reference) - _dot(reference, fixed) * _dot(reference, fixed)
    return _dot(fixed, _cross(reference, velocity)) / across


def triad(fixed: Triple, reference: Triple) -> tuple[Triple, Triple, Triple]:
    """κ, the direction of the part of e orthogonal to it, and their vector product.

    Parameters
    ----------
    fixed, reference : vector
        κ and e of any length, body axes; not parallel.
    """
    one = along(fixed)
    share = _dot(reference, one)
    two = along([e - share * k for e, k in zip(reference, one, strict=True)])
    return one, two, _cross(one, two)


def along(vector: Triple) -> tuple[Any, Any, Any]:
    """The unit vector of a vector."""
    length = _dot(vector, vector) ** 0.5
    return vector[0] / length, vector[1] / length, vector[2] / length


def turned(axes: Sequence[Triple], cosine: Any, sine: Any) -> tuple[Triple, Triple, Triple]:
    """A triad in space, turned about its first vector by an angle ψ.

    Parameters
    ----------
    axes : triad
        In space axes, at ψ = 0.
    cosine, sine : number
        Of ψ.

    Returns
    -------
    triad
        Where the triad (κ, e) of the body stands in space when the angle is ψ.
    """
    one, two, three = axes
    return (
        one,
        tuple(cosine * x + sine * y for x, y in zip(two, three, strict=True)),
        tuple(cosine * y - sine * x for x, y in zip(two, three, strict=True)),
    )


def quaternion(space: Sequence[Triple], body: Sequence[Triple]) -> tuple[Any, Any, Any, Any]:
    """The attitude (w, x, y, z) that carries a triad in body axes to one in space axes.

    Parameters
    ----------
    space, body : triad
        Single numbers: floats or balls.

    Returns
    -------
    4 numbers
        The component of greatest modulus is positive.
    """
    Q = [[_dot([s[i] for s in space], [b[j] for b in body]) for j in range(3)] for i in range(3)]
    diagonal = [
        1 + sum((sign * Q[i][i] for i, sign in enumerate(signs)), 0 * Q[0][0])
        for signs in ((1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1))
    ]
    # the matrix 4 q⊗q, w first
    sums = {(i, j): Q[i][j] + Q[j][i] for i, j in ((0, 1), (0, 2), (1, 2))}
    x, y, z = Q[2][1] - Q[1][2], Q[0][2] - Q[2][0], Q[1][0] - Q[0][1]
    dyad = (
        (diagonal[0], x, y, z),
        (x, diagonal[1], sums[0, 1], sums[0, 2]),
        (y, sums[0, 1], diagonal[2], sums[1, 2]),
        (z, sums[0, 2], sums[1, 2], diagonal[3]),
    )
    largest = max(range(4), key=lambda i: number(diagonal[i]))
    scale = 2 * diagonal[largest] ** 0.5
    w, x, y, z = (entry / scale for entry in dyad[largest])
    return w, x, y, z


def farthest(fixed: Triple, candidates: Sequence[Triple]) -> int:
    """The candidate whose direction stays farthest from ±κ.

    Parameters
    ----------
    fixed : array (3, n)
        κ at places all over the torus, of any length.
    candidates : sequence of arrays (3, n)

    Returns
    -------
    int
        The number of the candidate with the greatest minimum of sin² of its angle to κ.
    """
    margins = []
    for e in candidates:
        cosine = _dot(fixed, e)
        square = _dot(fixed, fixed) * _dot(e, e)
        margins.append(float(np.min(1 - cosine * cosine / square)))
    return int(np.argmax(margins))


# --- formulas ------------------------------------------------------------------------------


@dataclass(frozen=True)
class Reference:
    """A vector by which the turn about κ is measured, formulas in ν, ν′ and the state's symbols.

    Attributes
    ----------
    vector : vector
        e, body axes.
    velocity : vector
        w = ė + ω×e, body axes.
    """

    vector: sp.MatrixExpr
    velocity: sp.MatrixExpr


def references(of: SeparatedSystem) -> tuple[Reference, ...]:
    """ν and the body axes, to choose from.

    Parameters
    ----------
    of : Separable
        Of a system whose state or definitions name ω.
    """
    moving = Reference(nu, nuprime / of.clock + cross(omega, nu))
    axes = tuple(Reference(unit_vector(i), cross(omega, unit_vector(i))) for i in (1, 2, 3))
    return (moving, *axes)


def spinning(of: SeparatedSystem, reference: Reference) -> sp.Expr:
    """ψ̇ about the first vector that `of` says is fixed, in ν, ν′ and the system's symbols."""
    fixed = to_components(of.fixed[0])
    length = sp.sqrt(to_components(norm_squared(of.fixed[0])))
    return rate(
        [component / length for component in fixed],
        to_components(reference.vector),
        to_components(reference.velocity),
    )


def stated(of: SeparatedSystem, reference: Reference) -> Identity:
    """That the angle about the fixed vector grows at the rate of :func:`spinning`.

    With κ and a the first two vectors of the triad the rate is (ȧ + ω×a, κ×a), and κ is fixed.
    """
    fixed = of.fixed[0]
    across = reference.vector - dot(reference.vector, kappa) * kappa
    velocity = constant([Rate(s) for s in a.symbols]) + cross(omega, a)
    still = constant([Rate(s) for s in kappa.symbols]) + cross(omega, kappa)
    return Identity(
        "spin",
        (
            *to_components(still),
            to_components(dot(velocity, cross(kappa, a))) - spinning(of, reference),
        ),
        "the rate of turning about a direction that stays in space",
        {
            **dict(of.constants),
            nu: of.direction,
            nuprime: of.turning,
            kappa: fixed / sp.sqrt(norm_squared(fixed)),
            level: across,
            a: level / sp.sqrt(norm_squared(level)),
        },
        on=of.level,
        source=of.source,
    )
