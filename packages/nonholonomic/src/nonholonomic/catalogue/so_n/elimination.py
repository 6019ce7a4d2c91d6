"""Symmetric linear equations B u = f: small ones by minors, others by steps B = L D Lᵀ.

Minors make formulas of which laws are proven fastest, where there are few of them; every step of an
elimination has a name, so that nothing is expanded in any dimension.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from flowlanes.system.named_formulas import Pairs
from flowlanes.system.vectors import real_symbol

#: Rows up to which the solution is written by minors.
FEW = 5


def solution(
    matrix: sp.MatrixBase,
    right: Sequence[sp.Expr],
    unknown: Sequence[sp.Symbol],
    determinant: sp.Symbol,
) -> Pairs:
    """The steps that solve symmetric positive equations, with the determinant among them.

    Parameters
    ----------
    matrix : sympy.Matrix (N, N)
        B, symmetric, of symbols.
    right : sequence of N sympy.Expr
        f.
    unknown : sequence of N Symbol
        The names of u.
    determinant : Symbol
        The name of the determinant.
    """
    if matrix.shape[0] > FEW:
        steps, product = elimination(matrix, right, unknown)
        return (*steps, (determinant, product))
    named = [real_symbol(f"f_{i + 1}") for i in range(len(right))]
    minors = matrix.adjugate() * sp.Matrix(named) / determinant
    return (
        (determinant, sp.expand(matrix.det(method="berkowitz"))),
        *zip(named, right, strict=True),
        *zip(unknown, minors, strict=True),
    )


def elimination(
    matrix: sp.MatrixBase, right: Sequence[sp.Expr], unknown: Sequence[sp.Symbol]
) -> tuple[Pairs, sp.Expr]:
    """The steps that solve symmetric positive equations, and the determinant.

    No pivots are sought: a positive definite matrix needs none, and every pivot is positive.

    Parameters
    ----------
    matrix : sympy.Matrix (N, N)
        B, symmetric.
    right : sequence of N sympy.Expr
        f.
    unknown : sequence of N Symbol
        The names of u.

    Returns
    -------
    steps : pairs of Symbol and Expr
        Pivots ``d_1``, …, factors ``L_2_1``, …, ``y_1``, … and the unknowns, each in terms of
        those before it.
    determinant : sympy.Expr
        The product of the pivots.

    Examples
    --------
    >>> a, b, u, v = sp.symbols("a b u v", real=True)
    >>> steps, determinant = elimination(sp.Matrix([[a, 1], [1, b]]), [1, 0], [u, v])
    >>> [str(name) for name, _ in steps], determinant
    (['d_1', 'L_2_1', 'd_2', 'y_1', 'y_2', 'v', 'u'], d_1*d_2)
    """
    size = matrix.shape[0]
    d = [real_symbol(f"d_{i + 1}") for i in range(size)]
    y = [real_symbol(f"y_{i + 1}") for i in range(size)]
    lower: dict[tuple[int, int], sp.Expr] = {}
    steps: list[tuple[sp.Symbol, sp.Expr]] = []
    for j in range(size):
        steps.append((d[j], matrix[j, j] - sp.Add(*(lower[j, k] ** 2 * d[k] for k in range(j)))))
        for i in range(j + 1, size):
            entry = matrix[i, j] - sp.Add(*(lower[i, k] * lower[j, k] * d[k] for k in range(j)))
            lower[i, j] = sp.S.Zero
            if entry != 0:
                lower[i, j] = real_symbol(f"L_{i + 1}_{j + 1}")
                steps.append((lower[i, j], entry / d[j]))
    for i in range(size):
        steps.append((y[i], right[i] - sp.Add(*(lower[i, k] * y[k] for k in range(i)))))
    for i in reversed(range(size)):
        above = sp.Add(*(lower[k, i] * unknown[k] for k in range(i + 1, size)))
        steps.append((unknown[i], y[i] / d[i] - above))
    return tuple(steps), sp.Mul(*d)
