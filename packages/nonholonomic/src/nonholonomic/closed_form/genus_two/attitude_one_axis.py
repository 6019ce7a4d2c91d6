"""Attitude if a single direction fixed in space is known: the rotation about it.

Let κ be the unit vector fixed in space and e another vector, not parallel to it, both in body axes.
In space e has the velocity w = ė + ω×e (in body components), and its component orthogonal to κ
turns about κ at the rate

    ψ̇ = (κ, e×w)/(e² − (e, κ)²),

which is a function of the state.  ψ follows by one quadrature, and the attitude from κ, e and ψ.

A vector is a sequence of three numbers, a triad a sequence of three vectors.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import sympy as sp
from flint import arb

from flowlanes.system import tuple_vectors
from flowlanes.system.arrays import FloatArray
from flowlanes.system.laws import Identity, Rate
from flowlanes.system.named_formulas import scalars
from flowlanes.system.vector_operators import unit_vector
from flowlanes.system.vectors import constant, cross, dot, norm_squared, vectors

from .separation import SeparatedSystem, nu, nuprime

omega, kappa, level, a = vectors("omega spin_kappa spin_level spin_a")


def rate(
    fixed: Sequence[sp.Expr], reference: Sequence[sp.Expr], velocity: Sequence[sp.Expr]
) -> sp.Expr:
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
    along = tuple_vectors.dot(reference, fixed)
    across = tuple_vectors.dot(reference, reference) - along * along
    product = tuple_vectors.cross(reference, velocity)
    return tuple_vectors.dot(fixed, product) / across


def rotated_triad(
    axes: Sequence[Sequence[arb]], cosine: arb, sine: arb
) -> tuple[Sequence[arb], Sequence[arb], Sequence[arb]]:
    """A triad in space after a rotation about its first vector by an angle ψ.

    Parameters
    ----------
    axes : triad
        Three vectors in space axes, at ψ = 0.
    cosine, sine : arb
        cos ψ and sin ψ.

    Returns
    -------
    triad
        The triad of (κ, e) in space axes, at the angle ψ.
    """
    one, two, three = axes
    return (
        one,
        tuple(cosine * x + sine * y for x, y in zip(two, three, strict=True)),
        tuple(cosine * y - sine * x for x, y in zip(two, three, strict=True)),
    )


def farthest_from_axis(fixed: FloatArray, candidates: Sequence[FloatArray]) -> int:
    """The candidate whose direction stays farthest from ±κ.

    Parameters
    ----------
    fixed : array (3, n)
        κ at points all over the torus, of any length.
    candidates : sequence of arrays (3, n)

    Returns
    -------
    int
        The number of the candidate with the greatest minimum of sin² of its angle to κ.
    """
    margins = []
    for e in candidates:
        cosine = np.sum(fixed * e, axis=0)
        square = np.sum(fixed * fixed, axis=0) * np.sum(e * e, axis=0)
        margins.append(float(np.min(1 - cosine * cosine / square)))
    return int(np.argmax(margins))


@dataclass(frozen=True)
class Reference:
    """A vector that measures the rotation about κ, in ν, ν′ and the state.

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
    """Candidates for the reference vector: ν and the body axes.

    Parameters
    ----------
    of : SeparatedSystem
        Its system must have ω in its state or definitions.
    """
    moving = Reference(nu, nuprime / of.time_rescaling + cross(omega, nu))
    axes = tuple(Reference(unit_vector(i), cross(omega, unit_vector(i))) for i in (1, 2, 3))
    return (moving, *axes)


def spin_rate(of: SeparatedSystem, reference: Reference) -> sp.Expr:
    """ψ̇ about the first fixed vector of `of`, in ν, ν′ and the system's symbols."""
    fixed = of.fixed[0]
    (length,) = scalars(sp.sqrt(norm_squared(fixed)))
    return rate(
        [component / length for component in scalars(fixed)],
        scalars(reference.vector),
        scalars(reference.velocity),
    )


def spin_identity(of: SeparatedSystem, reference: Reference) -> Identity:
    """The law that the angle about the fixed vector grows at the rate `spin_rate`.

    With κ and a the first two vectors of the triad the rate is (ȧ + ω×a, κ×a), and κ is fixed.
    """
    fixed = of.fixed[0]
    across = reference.vector - dot(reference.vector, kappa) * kappa
    velocity = constant([Rate(s) for s in a.symbols]) + cross(omega, a)
    still = constant([Rate(s) for s in kappa.symbols]) + cross(omega, kappa)
    return Identity(
        "spin",
        (
            still,
            dot(velocity, cross(kappa, a)) - spin_rate(of, reference),
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
        level=of.level,
        source=of.source,
    )
