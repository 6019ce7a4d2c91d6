"""Linear algebra for many small vectors and matrices, bit for bit independent of their number.

Sums are evaluated in a fixed order, which is not guaranteed by the reductions of NumPy.
"""

from __future__ import annotations

import numpy as np

from ..system.arrays import FloatArray


def norm_squared_columns(columns: FloatArray) -> FloatArray:
    """(v, v) for vectors in columns, array (n, k)."""
    total = columns[0] * columns[0]
    for row in columns[1:]:
        total = total + row * row
    result: FloatArray = total
    return result


def row_dots(left: FloatArray, right: FloatArray) -> FloatArray:
    """(u, v) for vectors in rows, arrays (k, n)."""
    total = np.zeros(left.shape[0])
    for i in range(left.shape[1]):
        total = total + left[:, i] * right[:, i]
    return total


def batched_matvec(matrices: FloatArray, vectors: FloatArray) -> FloatArray:
    """A v for matrices (k, m, n) and vectors (k, n): array (k, m)."""
    products = np.zeros(matrices.shape[:2])
    for i in range(matrices.shape[1]):
        products[:, i] = row_dots(matrices[:, i], vectors)
    return products


def batched_solve(matrices: FloatArray, right: FloatArray) -> FloatArray:
    """A⁻¹ v for matrices (k, n, n) and vectors (k, n): array (k, n)."""
    if right.shape[1] == 0:
        return right
    if right.shape[1] == 1:
        return right / matrices[:, 0]
    solution = np.linalg.solve(matrices, right[:, :, None])
    return np.asarray(solution[:, :, 0], dtype=np.float64)
