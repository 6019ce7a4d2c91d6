"""Quadratic integrals Σ K_ij ω_ij k_ij of bodies with moments in the coordinate planes.

With k = p∧γ, the Veselova top, the rubber ball and, on its level k = p∧γ, the marble ball have such
an integral if for every triple of axes the rows (1, 1, 1), (I_ij, I_jk, I_ki), (K_ij, K_jk, K_ki)
are linearly dependent: Theorem 1 of docs/quadratic-integrals.md.  K = 1 and K = I are such always;
there are others for moments (b_i − b_j)/(c_i − c_j), as every rigid body has.  Whether moments are
of this kind is decided exactly, for the rational numbers that their decimals say.
"""

from __future__ import annotations

from itertools import combinations, permutations

import sympy as sp

from flowlanes.parsing.exact_decimals import exact_number
from flowlanes.system.laws import Identity, Integral
from flowlanes.system.matrices import Column, Skew
from flowlanes.system.system import System
from flowlanes.system.vectors import Components

from .inertia import Moments, pairs
from .quadratic_pencil import conserved_weights

SOURCE = "docs/quadratic-integrals.md"


def further_weights(inertia: Moments) -> tuple[sp.ImmutableMatrix, ...]:
    """Arrays K beyond combinations of 1 and I, at the present numbers of the moments.

    Returns
    -------
    tuple of sympy matrix (n, n)
        Of whole numbers, as many as are independent; none for moments in general position.
    """
    n = inertia.dimension
    places = pairs(n)
    own = [exact_number(inertia.numbers[inertia.moment(i, j).name]) for i, j in places]
    matrix = sp.zeros(n)
    for (i, j), value in zip(places, own, strict=True):
        matrix[i, j] = matrix[j, i] = value
    known = [[sp.S.One] * len(places), own]
    rows, pivots = sp.Matrix(known).rref()
    found = []
    for weights in conserved_weights(matrix):
        row = sp.Matrix([[weights[i, j] for i, j in places]])
        for number, pivot in enumerate(pivots):
            row -= row[pivot] * rows.row(number)
        found.append(row)
    reduced = sp.Matrix.vstack(*found).rref()[0]
    return tuple(
        _array(n, _whole(reduced.row(i)))
        for i in range(reduced.rows)
        if not reduced.row(i).is_zero_matrix
    )


def weighted_integrals(inertia: Moments, omega: Skew, k: sp.MatrixBase) -> tuple[Integral, ...]:
    """The laws Σ K_ij ω_ij k_ij, each with the linear equations for I_ij under which it holds.

    Parameters
    ----------
    inertia : Moments
    omega : Skew
        The angular velocity.
    k : sympy matrix (n, n)
        p∧γ.
    """
    n, spin = inertia.dimension, omega.entries
    return tuple(
        Integral(
            f"quadratic{number}",
            sp.Add(*(K[i, j] * spin[i, j] * k[i, j] for i, j in pairs(n))),
            f"quadratic integral {number} by weights of the planes",
            level=_conditions(inertia, K),
            source=SOURCE,
        )
        for number, K in enumerate(further_weights(inertia), 2)
    )


def _conditions(inertia: Moments, K: sp.MatrixBase) -> tuple[sp.Expr, ...]:
    """Independent linear equations for the moments: the determinants of all triples vanish."""
    n = inertia.dimension
    places = pairs(n)
    rows = []
    for i, j, k in combinations(range(n), 3):
        row = [sp.S.Zero] * len(places)
        row[places.index((i, j))] = K[j, k] - K[i, k]
        row[places.index((j, k))] = K[i, k] - K[i, j]
        row[places.index((i, k))] = K[i, j] - K[j, k]
        rows.append(row)
    reduced = sp.Matrix(rows).rref()[0]
    moments = [inertia.moment(i, j) for i, j in places]
    return tuple(
        sp.Add(*(c * s for c, s in zip(_whole(reduced.row(i)), moments, strict=True)))
        for i in range(reduced.rows)
        if not reduced.row(i).is_zero_matrix
    )


def _whole(row: sp.MatrixBase) -> list[sp.Integer]:
    """A multiple of a row by whole numbers without a common factor."""
    entries = list(row)
    scale = sp.ilcm(*(x.q for x in entries))
    whole = [x * scale for x in entries]
    return [x / sp.igcd(*whole) for x in whole]


def _array(n: int, entries: list[sp.Integer]) -> sp.ImmutableMatrix:
    matrix = sp.zeros(n)
    for (i, j), value in zip(pairs(n), entries, strict=True):
        matrix[i, j] = matrix[j, i] = value
    return sp.ImmutableMatrix(matrix)


def lemma() -> System:
    """The identities of the proof, in the numbers of one triple or pair of axes: for every n.

    With N_ijk = I_ij K_jk − K_ij I_jk the sum N_123 + N_231 + N_312 is the determinant of the three
    rows, so that N_ijk = d_k − d_i where it vanishes; then Σ N_ijk q_i (u∧γ)_ij (q∧γ)_jk γ_k is
    zero over the permutations of a triple.  Plücker's identity is that of four vectors in a plane.

    Examples
    --------
    >>> import lawproof
    >>> {verdict.decision for verdict in lawproof.prove_all(lemma())}
    {'proven'}
    """
    u, q, gamma, w, d = (Column(name, 3) for name in ("u", "q", "gamma", "w", "d"))
    I, K = Column("I", 3), Column("K", 3)

    def plane(a: Column, b: Column, i: int, j: int) -> sp.Expr:
        return a.symbols[i] * b.symbols[j] - a.symbols[j] * b.symbols[i]

    triple = sp.Add(
        *(
            (d.symbols[k] - d.symbols[i])
            * q.symbols[i]
            * plane(u, gamma, i, j)
            * plane(q, gamma, j, k)
            * gamma.symbols[k]
            for i, j, k in permutations(range(3))
        )
    )
    # I_12, I_23, I_31 and the same of K
    rows = sp.Matrix([[1, 1, 1], I.symbols, K.symbols])
    cycle = sp.Add(
        *(
            I.symbols[a] * K.symbols[(a + 1) % 3] - K.symbols[a] * I.symbols[(a + 1) % 3]
            for a in range(3)
        )
    )
    four = (
        plane(q, gamma, 0, 1) * plane(w, u, 0, 1)
        + plane(w, gamma, 0, 1) * plane(u, q, 0, 1)
        + plane(u, gamma, 0, 1) * plane(q, w, 0, 1)
    )
    return System(
        name="quadratic-integrals-by-weights",
        title="Quadratic integrals by weights of the planes, in every dimension",
        field={name: Components.zeros(3, 1) for name in (u, q, gamma, w, d, I, K)},
        laws=(
            Identity("triple", triple, "the sum over a triple of axes is zero", source=SOURCE),
            Identity("cycle", cycle - rows.det(), "the sum of N is a determinant", source=SOURCE),
            Identity("four", four, "Plücker's identity in a plane of axes", source=SOURCE),
        ),
    )
