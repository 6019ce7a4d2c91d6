"""Subspaces in multi-precision arithmetic: null spaces, bases, minimum-norm solutions."""

from __future__ import annotations

from collections.abc import Sequence

import mpmath


def minimum_norm_solution(matrix: mpmath.matrix, right: mpmath.matrix) -> mpmath.matrix:
    """Least-squares solution of a x = b of minimal norm, for any rank."""
    left, sizes, other = mpmath.svd_r(matrix)
    floor = sizes[0] * mpmath.mpf(10) ** (-mpmath.mp.dps // 4)
    share = left.T * right
    for i, size in enumerate(sizes):
        share[i] = share[i] / size if size > floor else mpmath.mpf(0)
    return other.T * share


def null_space_basis(rows: mpmath.matrix, size: int) -> mpmath.matrix:
    """Orthonormal basis, in columns, of the null space of the rows."""
    span = _orthonormal([rows[i, :].T for i in range(rows.rows)])
    units = [mpmath.matrix([int(i == j) for j in range(size)]) for i in range(size)]
    return _columns(_orthonormal(units, span), size)


def orthogonal_part(basis: mpmath.matrix, family: Sequence[mpmath.matrix]) -> mpmath.matrix:
    """Orthonormal basis of the part of a span that is orthogonal to given vectors."""
    span = _orthonormal(family)
    columns = [basis[:, j] for j in range(basis.cols)]
    return _columns(_orthonormal(columns, span), basis.rows) if span else basis


def _columns(vectors: Sequence[mpmath.matrix], size: int) -> mpmath.matrix:
    matrix = mpmath.matrix(size, len(vectors))
    for j, v in enumerate(vectors):
        for i in range(size):
            matrix[i, j] = v[i]
    return matrix


def _orthonormal(
    vectors: Sequence[mpmath.matrix], beside: Sequence[mpmath.matrix] = ()
) -> list[mpmath.matrix]:
    """Orthonormal basis by the Gram–Schmidt process done twice, largest remainder first."""
    basis: list[mpmath.matrix] = []
    remainders = [+v for v in vectors]
    scale = max((mpmath.norm(v) for v in remainders), default=mpmath.mpf(1))
    floor = scale * mpmath.mpf(10) ** (-mpmath.mp.dps // 4)
    while remainders:
        remainders = [_remainder(v, (*beside, *basis)) for v in remainders]
        longest = max(range(len(remainders)), key=lambda i: mpmath.norm(remainders[i]))
        best = remainders.pop(longest)
        if mpmath.norm(best) <= floor:
            break
        basis.append(best / mpmath.norm(best))
    return basis


def _remainder(vector: mpmath.matrix, span: Sequence[mpmath.matrix]) -> mpmath.matrix:
    """Vector minus its projection onto an orthonormal span."""
    for _ in range(2):
        for e in span:
            vector = vector - (e.T * vector)[0] * e
    return vector
