"""Quadratic integrals of the Veselova top and of balls that roll in n dimensions.

The angular velocity ω is skew, γ is fixed in space, γ̇ = −ωγ, and the momentum is k = p ∧ γ: the
Veselova top and the rubber ball have it by their constraint, the marble ball on the invariant level
of zero SO(n−1)-momentum.  The inertia takes ω_ij to I_ij ω_ij.  For a symmetric array K the sum

    Σ K_ij ω_ij k_ij                                        (over i < j)

is a first integral of all three systems if the rows (1, 1, 1), (I_ij, I_jk, I_ki) and
(K_ij, K_jk, K_ki) are linearly dependent for every triple i, j, k.  K = 1 and K = I are such for
every inertia: twice the energy and, without mR², the square of p.  For a Manakov operator,
I_ij = (b_i − b_j)/(c_i − c_j), as of every rigid body (I_ij = J_i + J_j, c = J), there is for every
λ also K_ij = 1/((λ − c_i)(λ − c_j)), and n − 1 of the integrals are independent where the c_i are
distinct.  For a mass tensor J in any axes the integral with the number λ is

    F_λ = −½ tr(ω R k R),    R = (λ − J)⁻¹.

A potential ½ε(γ, Jγ) adds ε(γ, Rγ) to it for the Veselova top and the rubber ball.  The proof, for
every n, is in docs/quadratic-integrals.md.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import TypeAlias

import sympy as sp

from flowlanes.arguments import arguments_checked
from flowlanes.errors import InputError
from flowlanes.system.laws import Integral

Array: TypeAlias = sp.MatrixBase

_SOURCE = "docs/quadratic-integrals.md"
_SMALLEST = 3


def manakov_moments(b: Sequence[sp.Expr], c: Sequence[sp.Expr]) -> sp.ImmutableMatrix:
    """The moments I_ij = (b_i − b_j)/(c_i − c_j), 0 on the diagonal.

    Parameters
    ----------
    b, c : sequence of n sympy.Expr or numbers
        The c_i are distinct.

    Returns
    -------
    sympy matrix (n, n), symmetric

    Raises
    ------
    InputError
        If the lengths differ, are below 3, or two of the c_i are equal.

    Examples
    --------
    >>> manakov_moments([1, 4, 9], [1, 2, 3])
    Matrix([
    [0, 3, 4],
    [3, 0, 5],
    [4, 5, 0]])
    """
    heights, places = [sp.sympify(x) for x in b], [sp.sympify(x) for x in c]
    if len(heights) != len(places) or len(places) < _SMALLEST:
        raise InputError(
            f"b and c: two lists of the same length, at least {_SMALLEST}, are needed; they have "
            f"{len(heights)} and {len(places)} entries"
        )
    for i, j in combinations(range(len(places)), 2):
        if sp.simplify(places[i] - places[j]) == 0:
            raise InputError(f"c: entries {i + 1} and {j + 1} are equal; they must be distinct")
    return sp.ImmutableMatrix(
        len(places),
        len(places),
        lambda i, j: (
            sp.cancel((heights[i] - heights[j]) / (places[i] - places[j])) if i != j else 0
        ),
    )


def conserved_weights(moments: Array) -> tuple[sp.ImmutableMatrix, ...]:
    """A basis of the arrays K with an integral Σ K_ij ω_ij k_ij, from the moments I_ij.

    These are the K with det((1, 1, 1), (I_ij, I_jk, I_ki), (K_ij, K_jk, K_ki)) = 0 for all triples:
    linear equations, solved exactly.  There are n − 1 for generic c_i and two for generic I_ij,
    n ≥ 4: K = 1 and K = I are combinations of them.

    Parameters
    ----------
    moments : sympy matrix (n, n)
        I_ij, symmetric; the diagonal is not used.

    Returns
    -------
    tuple of sympy matrix (n, n)
        Symmetric, with zeros on the diagonal.

    Raises
    ------
    InputError
        If it is no symmetric matrix with at least three rows.

    Examples
    --------
    >>> len(conserved_weights(manakov_moments([1, 3, 2, 7], [1, 2, 4, 5])))
    3
    >>> generic = sp.Matrix([[0, 5, 11, 16], [5, 0, 23, 9], [11, 23, 0, 14], [16, 9, 14, 0]])
    >>> len(conserved_weights(generic))
    2
    """
    entries = _symmetric("moments", moments)
    n = entries.rows
    planes = tuple(combinations(range(n), 2))
    column = {plane: number for number, plane in enumerate(planes)}
    rows = []
    for i, j, k in combinations(range(n), 3):
        triple = ((i, j), (j, k), (i, k))
        row = [sp.S.Zero] * len(planes)
        for number, plane in enumerate(triple):
            following, last = triple[(number + 1) % 3], triple[(number + 2) % 3]
            row[column[plane]] = entries[following] - entries[last]
        rows.append(row)
    return tuple(
        sp.ImmutableMatrix(
            n, n, lambda i, j, v=vector: v[column[min(i, j), max(i, j)]] if i != j else 0
        )
        for vector in sp.Matrix(rows).nullspace()
    )


@arguments_checked
@dataclass(frozen=True)
class QuadraticPencil:
    """The integrals F_λ of a body with the mass tensor J, or with I_ij = (b_i − b_j)/(c_i − c_j).

    Parameters
    ----------
    omega, k : sympy matrix (n, n)
        Angular velocity and momentum in body axes, skew, by the symbols of a system.
    tensor : sympy matrix (n, n)
        J, symmetric; for other operators diag(c_1, …, c_n).
    gamma : sympy matrix (n, 1), optional
        Components of the unit vector γ; needed where there is a field.
    strength : sympy.Expr, optional
        ε of the potential ½ε(γ, Jγ); for bodies with ω = u ∧ γ alone.

    Raises
    ------
    InputError
        If the sizes differ, a matrix is not skew or not symmetric, or γ is missing.

    Examples
    --------
    >>> u, p, gamma = (sp.Matrix(sp.symbols(f"{s}_1:4", real=True)) for s in ("u", "p", "gamma"))
    >>> omega, k = u * gamma.T - gamma * u.T, p * gamma.T - gamma * p.T
    >>> pencil = QuadraticPencil(omega, k, sp.diag(1, 2, 4))
    >>> [law.name for law in pencil.integrals()]
    ['pencil_1', 'pencil_2']
    """

    omega: Array
    k: Array
    tensor: Array
    gamma: Array | None = None
    strength: sp.Expr = sp.S.Zero

    def __post_init__(self) -> None:
        n = _symmetric("tensor", self.tensor).rows
        for name in ("omega", "k"):
            matrix = getattr(self, name)
            if matrix.shape != (n, n):
                raise InputError(
                    f"{name}: a matrix of {n} × {n} is needed, as J is, not {matrix.shape}"
                )
            if not (matrix + matrix.T).expand().is_zero_matrix:
                raise InputError(f"{name}: the matrix must be skew")
            object.__setattr__(self, name, sp.ImmutableMatrix(matrix))
        object.__setattr__(self, "tensor", sp.ImmutableMatrix(self.tensor))
        object.__setattr__(self, "strength", sp.sympify(self.strength))
        if self.gamma is not None:
            if self.gamma.shape != (n, 1):
                raise InputError(f"gamma: a column of {n} is needed, not {self.gamma.shape}")
            object.__setattr__(self, "gamma", sp.ImmutableMatrix(self.gamma))
        elif self.strength != 0:
            raise InputError("gamma: its components are needed where strength is not 0")

    def member(self, number: sp.Expr | float) -> sp.Expr:
        """F_λ = −½ tr(ω R k R) + ε (γ, Rγ) with R = (λ − J)⁻¹.

        Parameters
        ----------
        number : sympy.Expr or number
            λ, no eigenvalue of J.
        """
        below = sp.sympify(number) * sp.eye(self.tensor.rows) - self.tensor
        if sp.simplify(below.det()) == 0:
            raise InputError(
                f"number: {number} is an eigenvalue of the tensor; F_λ has a pole there"
            )
        R = below.inv()
        return -(self.omega * R * self.k * R).trace() / 2 + self._field(R)

    def coefficient(self, order: int) -> sp.Expr:
        """The coefficient of λ^(−1−m) in F_λ: Σ (c_i^m − c_j^m)/(c_i − c_j) ω_ij k_ij.

        Parameters
        ----------
        order : int
            m ≥ 1.  Twice the energy for m = 1, and without field |p|² for m = 2 of a rigid body
            with ω = u ∧ γ and no mR².

        Returns
        -------
        sympy.Expr
            −½ Σ tr(ω J^a k J^(m−1−a)) over a = 0, …, m − 1, and ε (γ, J^m γ): a polynomial in J.
        """
        if order < 1:
            raise InputError(f"order: must be at least 1, not {order}")
        powers = [sp.eye(self.tensor.rows)]
        for _ in range(order):
            powers.append(powers[-1] * self.tensor)
        total = sp.Add(
            *(
                (self.omega * powers[a] * self.k * powers[order - 1 - a]).trace()
                for a in range(order)
            )
        )
        return -total / 2 + self._field(powers[order])

    @arguments_checked
    def integrals(self, on: tuple[sp.Expr, ...] = ()) -> tuple[Integral, ...]:
        """The first n − 1 coefficients of F_λ as laws, independent if the c_i are distinct.

        Parameters
        ----------
        on : tuple of sympy.Expr
            The level on which they hold: for the marble ball what vanishes where k = p ∧ γ.
        """
        return tuple(
            Integral(
                f"pencil_{order}",
                self.coefficient(order),
                f"member {order} of the pencil of quadratic integrals",
                level=on,
                source=_SOURCE,
            )
            for order in range(1, self.tensor.rows)
        )

    def _field(self, matrix: Array) -> sp.Expr:
        if self.gamma is None:
            return sp.S.Zero
        return self.strength * (self.gamma.T * matrix * self.gamma)[0]


def _symmetric(name: str, matrix: Array) -> Array:
    if matrix.rows != matrix.cols or matrix.rows < _SMALLEST:
        raise InputError(
            f"{name}: a symmetric matrix with at least {_SMALLEST} rows is needed, not one of "
            f"{matrix.rows} × {matrix.cols}"
        )
    if not (matrix - matrix.T).expand().is_zero_matrix:
        raise InputError(f"{name}: the matrix must be symmetric")
    return matrix
