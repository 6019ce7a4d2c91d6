"""Linear algebra of small matrices over the rationals or a field of rational functions."""

from __future__ import annotations

from collections.abc import Sequence

from .rational_functions import Value


def product(rows: Sequence[Sequence[Value]], column: Sequence[Value]) -> list[Value]:
    """The product of a matrix and a column."""
    return [sum((a * b for a, b in zip(row, column, strict=True)), 0 * column[0]) for row in rows]


def inverse(rows: Sequence[Sequence[Value]], like: Value) -> list[list[Value]]:
    """The inverse of a small matrix.

    Raises
    ------
    ZeroDivisionError
        If it is singular.
    """
    size = len(rows)
    wide = [[*row, *(like * int(i == j) for j in range(size))] for i, row in enumerate(rows)]
    left, pivots = reduced_echelon_form(wide)
    if pivots != list(range(size)):
        raise ZeroDivisionError
    return [row[size:] for row in left]


def reduced_echelon_form(rows: Sequence[Sequence[Value]]) -> tuple[list[list[Value]], list[int]]:
    """The reduced echelon form without zero rows, and the columns of its pivots."""
    left = [list(row) for row in rows]
    pivots: list[int] = []
    for k in range(len(left[0])):
        top = len(pivots)
        pivot = next((i for i in range(top, len(left)) if left[i][k] != 0), None)
        if pivot is None:
            continue
        left[top], left[pivot] = left[pivot], left[top]
        left[top] = [x / left[top][k] for x in left[top]]
        for i, row in enumerate(left):
            if i != top and row[k] != 0:
                factor = row[k]
                left[i] = [x - factor * y for x, y in zip(row, left[top], strict=True)]
        pivots.append(k)
    return left[: len(pivots)], pivots


def kernel(rows: Sequence[Sequence[Value]], like: Value) -> list[list[Value]]:
    """A basis of the solutions of a homogeneous system, one vector for each free unknown."""
    left, pivots = reduced_echelon_form(rows)
    size = len(rows[0])
    basis = []
    for free in (j for j in range(size) if j not in pivots):
        solution = [like * 0] * size
        solution[free] = like
        for row, pivot in zip(left, pivots, strict=True):
            solution[pivot] = -row[free]
        basis.append(solution)
    return basis
