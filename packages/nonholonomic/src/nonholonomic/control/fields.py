"""The control fields of a balanced ball with rotors, as polynomials in the vertical.

A field on R² × SO(3) has the components (a, v): angular velocity and velocity of the contact, in
body axes.  Those of the rotors depend only on γ, and so do all commutators,

    [(a, v), (b, w)] = (a×b + ∂_a b − ∂_b a, a×w − b×v + ∂_a w − ∂_b v),   ∂_a γ = γ×a.

Each field is multiplied by a positive function of γ, which makes it polynomial and does not change
the span of fields and commutators: by 1 − D(γ, J⁻¹γ) for the marble contact, J = I + D, D = mR²,
and by (γ, J⁻¹γ) for the rubber contact.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from typing import TypeAlias

from flint import Ordering, fmpq, fmpq_mat, fmpq_mpoly, fmpq_mpoly_ctx

from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.tuple_vectors import cross, dot

from .robot import SphericalRobot

RING = fmpq_mpoly_ctx.get(("gamma_1", "gamma_2", "gamma_3"), Ordering.degrevlex)
GAMMA: tuple[fmpq_mpoly, ...] = tuple(RING.gens())
ZERO, ONE = RING.constant(0), RING.constant(1)
SQUARE = sum((x**2 for x in GAMMA), ZERO)

#: Components a_1, a_2, a_3, v_1, v_2, v_3 in body axes.
Field: TypeAlias = tuple[fmpq_mpoly, ...]


@dataclass(frozen=True)
class ControlFields:
    """Control fields with their commutators.

    Attributes
    ----------
    levels : tuple of tuple of (str, Field)
        The fields ``g1``, …; the commutators of two of them; those with one more; and so on.
    scale : polynomial
        The factor of the fields, positive on the sphere.
    """

    levels: tuple[tuple[tuple[str, Field], ...], ...]
    scale: fmpq_mpoly

    def with_next_commutators(self) -> ControlFields:
        """The fields with one more level of commutators."""
        first, last = self.levels[0], self.levels[-1]
        words = []
        for i, (name, field) in enumerate(first):
            for j, (word, other) in enumerate(last):
                if len(self.levels) > 1 or j > i:
                    words.append((f"[{name}, {word}]", commutator(field, other)))
        return ControlFields((*self.levels, tuple(words)), self.scale)

    @property
    def forms(self) -> list[Field]:
        """The fields of the last level, with homogeneous components.

        Off the unit sphere rows and columns are multiplied by powers of |γ|, so that independence
        is the same along each line through the origin.
        """
        degree = 2 * len(self.levels)
        return [
            tuple(homogeneous(x, degree + (i > 2)) for i, x in enumerate(field))
            for _, field in self.levels[-1]
        ]


def control_fields(robot: SphericalRobot) -> ControlFields:
    """The fields of the rotors of a balanced robot that starts from rest."""
    tensor = [[_rational(entry) for entry in row] for row in robot.tensor.tolist()]
    D = _rational(robot.mass) * _rational(robot.radius) ** 2
    inverse = fmpq_mat([[x + D * (i == j) for j, x in enumerate(r)] for i, r in enumerate(tensor)])
    inverse = inverse.inv()
    up = _times(inverse, GAMMA)
    form = dot(GAMMA, up)
    rubber = robot.contact == "rubber"
    fields = []
    for number, rotor in enumerate(robot.rotors, 1):
        axis = [_rational(x) * ONE for x in rotor.axis]
        turn = _times(inverse, axis)
        share = dot(GAMMA, turn)
        if rubber:
            a = [share * u - form * t for u, t in zip(up, turn, strict=True)]
        else:
            a = [(ONE - D * form) * t + D * share * u for u, t in zip(up, turn, strict=True)]
        velocity = [_rational(robot.radius) * x for x in cross(a, GAMMA)]
        fields.append((f"g{number}", tuple(map(on_sphere, (*a, *velocity)))))
    scale = form if rubber else SQUARE - D * form
    return ControlFields((tuple(fields),), scale)


def commutator(left: Field, right: Field) -> Field:
    """The commutator [X, Y] of two fields."""
    a, v, b, w = left[:3], left[3:], right[:3], right[3:]
    mixed = [p + q for p, q in zip(cross(a, w), cross(v, b), strict=True)]
    parts = (*cross(a, b), *mixed)
    return tuple(
        on_sphere(part + _along(a, new) - _along(b, old))
        for part, new, old in zip(parts, right, left, strict=True)
    )


def _along(turn: Sequence[fmpq_mpoly], value: fmpq_mpoly) -> fmpq_mpoly:
    """The derivative ∂_a of a function of γ, for the angular velocity a."""
    rate = cross(GAMMA, turn)
    return sum((value.derivative(i) * rate[i] for i in range(3)), ZERO)


def minor(fields: Sequence[Field]) -> fmpq_mpoly:
    """The determinant of five fields together with the missing direction (0, γ).

    On the unit sphere it vanishes exactly if the five are dependent.
    """
    # all fields have (v, γ) = 0, so that (0, γ) completes five independent ones to a basis
    rows = [*fields, (ZERO, ZERO, ZERO, *GAMMA)]

    @cache
    def below(row: int, columns: tuple[int, ...]) -> fmpq_mpoly:
        if row == len(rows):
            return ONE
        total = ZERO
        for k, column in enumerate(columns):
            entry = rows[row][column]
            if not entry.is_zero():
                rest = below(row + 1, columns[:k] + columns[k + 1 :])
                total += (-1) ** k * entry * rest
        return on_sphere(total)

    return below(0, tuple(range(6)))


def values_at(fields: Sequence[Field], point: Sequence[fmpq]) -> fmpq_mat:
    """The components of fields at a point, one row per field."""
    return fmpq_mat([[entry(*point) for entry in field] for field in fields])


def on_sphere(value: fmpq_mpoly) -> fmpq_mpoly:
    """The remainder of a polynomial modulo γ² − 1, which agrees on the unit sphere."""
    return divmod(value, SQUARE - 1)[1]


def homogeneous(value: fmpq_mpoly, degree: int) -> fmpq_mpoly:
    """The form of given degree that agrees on |γ| = 1, for a polynomial of the same parity."""
    total = ZERO
    for powers, number in value.to_dict().items():
        missing = degree - sum(powers)
        term = RING.from_dict({powers: number})
        total += term * SQUARE ** (missing // 2)
    return total


def _times(matrix: fmpq_mat, vector: Sequence[fmpq_mpoly]) -> list[fmpq_mpoly]:
    return [sum((matrix[i, j] * vector[j] for j in range(3)), ZERO) for i in range(3)]


def _rational(number: float) -> fmpq:
    value = exact_number(number)
    return fmpq(int(value.p), int(value.q))
