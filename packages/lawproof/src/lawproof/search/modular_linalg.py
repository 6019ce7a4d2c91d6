"""Linear algebra modulo the prime with FLINT, and rational reconstruction."""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

import numpy as np
from flint import nmod_mat

from .modular_jets import Integers, prime

# Bits of margin: a random residue has a small fraction with a probability of about 2⁻¹².
_MARGIN = 12


def _matrix(values: Integers) -> nmod_mat:
    rows, columns = values.shape
    return nmod_mat(rows, columns, values.ravel().tolist(), prime())


def _pivots(reduced: nmod_mat, rank_: int) -> list[int]:
    pivots: list[int] = []
    column = 0
    for row in range(rank_):
        while int(reduced[row, column]) == 0:
            column += 1
        pivots.append(column)
        column += 1
    return pivots


def independent_columns(values: Integers) -> list[int]:
    """Indices of the columns that are linearly independent of those before them."""
    if 0 in values.shape:
        return []
    return _pivots(*_matrix(values).rref())


def rank(values: Integers) -> int:
    """Rank modulo the prime."""
    return 0 if 0 in values.shape else int(_matrix(values).rank())


def nullspace(values: Integers) -> Integers:
    """A basis of the null space in rows; each vector has an entry 1 where the others have 0.

    Parameters
    ----------
    values : array of int64, shape (rows, columns)

    Returns
    -------
    array of int64, shape (dimension, columns)
    """
    columns = values.shape[1]
    if values.shape[0] == 0:
        return np.eye(columns, dtype=np.int64)
    reduced, rank_ = _matrix(values).rref()
    pivots = _pivots(reduced, rank_)
    free = sorted(set(range(columns)) - set(pivots))
    # The free variables form the identity matrix, which makes the vectors sparse.
    basis = np.zeros((len(free), columns), dtype=np.int64)
    for index, column in enumerate(free):
        basis[index, column] = 1
        for row, pivot in enumerate(pivots):
            if pivot > column:
                break
            basis[index, pivot] = -int(reduced[row, column]) % prime()
    return basis


def product(left: Integers, right: Integers) -> Integers:
    """The matrix product modulo the prime."""
    total = np.zeros((left.shape[0], right.shape[1]), dtype=np.int64)
    for index in range(left.shape[1]):
        # The sum is reduced after every product, so that 64-bit integers do not overflow.
        total = (total + left[:, index, None] * right[index]) % prime()
    return total


def combination(columns: Integers, target: Integers) -> list[int] | None:
    """Coefficients with columns · c = target modulo the prime; None if there are none."""
    # The kernel vector with a non-zero last entry expresses the target by the columns.
    stacked = np.concatenate([columns, target[:, None]], axis=1)
    kernel = nullspace(stacked)
    hits = [vector for vector in kernel if vector[-1]]
    if not hits:
        return None
    scale = pow(-int(hits[-1][-1]), -1, prime())
    return [int(entry) * scale % prime() for entry in hits[-1][:-1]]


def rational(residue: int, modulus: int) -> Fraction | None:
    """The fraction with a given residue and small numerator and denominator, or None.

    Both are at most √(modulus/4096), so that a random residue rarely has one.
    """
    # Wang's algorithm: the extended Euclidean algorithm for (modulus, residue) keeps r = t ·
    # residue (mod modulus) and is stopped when r is small.
    bound = isqrt(modulus >> _MARGIN)
    r_0, r_1, t_0, t_1 = modulus, residue % modulus, 0, 1
    while r_1 > bound:
        quotient = r_0 // r_1
        r_0, r_1 = r_1, r_0 - quotient * r_1
        t_0, t_1 = t_1, t_0 - quotient * t_1
    if t_1 == 0 or abs(t_1) > bound:
        return None
    return Fraction(r_1, t_1)
