"""Symbolic solution of linear equations by A = L D Lᵀ, with named intermediate results."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.formulas.tape import Tape


def product(left: Sequence[sp.Expr], right: Sequence[sp.Expr]) -> sp.Expr:
    """Σ u_i v_i."""
    return sp.Add(*(u * v for u, v in zip(left, right, strict=True)))


class Factorisation:
    """The factorisation L D Lᵀ of a symmetric matrix, rows with few entries first.

    There is no pivoting: a positive definite matrix does not need it, and has positive pivots.

    Parameters
    ----------
    tape : Tape
        The tape that names intermediate results.
    matrix : sequence of rows

    Raises
    ------
    ZeroDivisionError
        If a pivot is zero.
    """

    def __init__(self, tape: Tape, matrix: Sequence[Sequence[sp.Expr]]) -> None:
        size = len(matrix)
        self._tape = tape
        self._order = _sparse_first(matrix)
        remainder = [[matrix[i][j] for j in self._order] for i in self._order]
        self.pivots: list[sp.Expr] = []
        self._lower = [[sp.S.Zero] * size for _ in range(size)]
        # outer-product form: after step k the remainder is the Schur complement of the leading
        # block
        for k in range(size):
            pivot = tape.name(tape.short(remainder[k][k]))
            if pivot == 0:
                raise ZeroDivisionError
            self.pivots.append(pivot)
            for i in range(k + 1, size):
                if remainder[i][k] != 0:
                    self._lower[i][k] = tape.name(tape.short(remainder[i][k] / pivot))
            for i in range(k + 1, size):
                for j in range(k + 1, i + 1):
                    if self._lower[i][k] != 0 and remainder[j][k] != 0:
                        change = self._lower[i][k] * remainder[j][k]
                        remainder[i][j] = remainder[j][i] = tape.name(
                            tape.short(remainder[i][j] - change)
                        )

    def solve(self, right: Sequence[sp.Expr]) -> list[sp.Expr]:
        """The solution x of A x = b."""
        size = len(right)
        lower, tape = self._lower, self._tape
        solution = [right[i] for i in self._order]
        for i in range(size):
            solution[i] = tape.name(tape.short(solution[i] - product(lower[i][:i], solution[:i])))
        solution = [
            tape.name(tape.short(x / d)) for x, d in zip(solution, self.pivots, strict=True)
        ]
        for i in reversed(range(size)):
            above = [lower[k][i] for k in range(i + 1, size)]
            solution[i] = tape.name(tape.short(solution[i] - product(above, solution[i + 1 :])))
        back = dict(zip(self._order, solution, strict=True))
        return [back[i] for i in range(size)]


def _sparse_first(matrix: Sequence[Sequence[sp.Expr]]) -> list[int]:
    """An order of elimination with little fill-in: the sparsest row comes next."""
    left = set(range(len(matrix)))
    # Minimum degree ordering (A. George, J. W. H. Liu, SIAM Review 31 (1989) 1): elimination of a
    # row links all its neighbours, and each new link is a new nonzero entry.
    links = {i: {j for j in left if j != i and matrix[i][j] != 0} for i in left}
    order = []
    while left:
        best = min(left, key=lambda i: (len(links[i] & left), i))
        order.append(best)
        left.remove(best)
        neighbours = links[best] & left
        for i in neighbours:
            links[i] |= neighbours - {i}
    return order
